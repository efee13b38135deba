#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <new>

#include "commands.h"
#include "diff_report.h"
#include "difference_picture.h"
#include "error.h"
#include "image_read.h"
#include "json_parse.h"
#include "temporary_file.h"

namespace gnomon {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_tolerance(const std::string& text) {
    throw Error(
        Blame::input,
        "found " + quote(text) + ", expected a number >= 0, or radiance=, distance= or normal=" + " and such a number",
        "--tolerance");
}

double parse_tolerance(const std::string& number, const std::string& text) {
    double value = 0;
    const char* const end = number.data() + number.size();
    const auto [rest, error] = std::from_chars(number.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value) || value < 0) refuse_tolerance(text);
    return value;
}

/// "X" is for all results, "NAME=X" for one, wherever it stands.
Tolerances parse_tolerances(const std::vector<std::string>& texts) {
    Tolerances result;
    for (const std::string& text : texts)
        if (text.find('=') == std::string::npos)
            result.radiance = result.distance = result.normal = parse_tolerance(text, text);
    for (const std::string& text : texts) {
        const size_t sign = text.find('=');
        if (sign == std::string::npos) continue;
        const std::string name = text.substr(0, sign);
        const double value = parse_tolerance(text.substr(sign + 1), text);
        if (name != "radiance" && name != "distance" && name != "normal") refuse_tolerance(text);
        (name == "radiance" ? result.radiance : name == "distance" ? result.distance : result.normal) = value;
    }
    return result;
}

void expect_same_corner(const PictureFile& a, const PictureFile& b) {
    if (a.left == b.left && a.top == b.top) return;
    throw Error(Blame::input, fmt::format("the pictures start at different pixels, ({}, {}) and ({}, {})", a.left,
                                          a.top, b.left, b.top));
}

void warn_of_missing(const std::vector<std::string>& names, const std::string& path, const std::string& why) {
    for (const std::string& name : names)
        fmt::print(stderr, "gnomon: warning: channel {} of {} is not compared: {}\n", quote(name), path, why);
}

/// EXR: the differences as numbers. Anything else: the map.
void write_difference(const std::string& path, const Film& a, const Film& b, const PictureDiff& diff) {
    const Metadata metadata{{"Software", "gnomon " GNOMON_VERSION}};
    write_image(is_exr(path) ? difference_film(a, b) : difference_map(diff), path, {}, metadata);
}

}  // namespace

DiffCommand::DiffCommand(CLI::App& app) {
    command_ = app.add_subcommand("diff", "Compare two EXR pictures. Exit code 0: same, 1: different, 2: trouble.");
    command_->add_option("A", path_a_, "the picture to be compared with, EXR")->required();
    command_->add_option("B", path_b_, "another, with any of the channels that render writes")->required();
    command_
        ->add_option("--tolerance", tolerances_,
                     "difference to accept, relative to the largest finite magnitude in A of radiance, distance or "
                     "normal; one number for all of them, or one each (default 0: equal values)")
        ->type_name("[NAME=]X")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command_->add_option("--allow", allowed_, "how many pixels may differ by more (default 0)")
        ->check(CLI::NonNegativeNumber)
        ->type_name("PIXELS");
    command_->add_option("-o,--output", output_, "write the differences (.exr: as numbers; .png and others: where)")
        ->type_name("FILE");
    command_->add_option("--json", json_path_, "write all figures, as JSON")->type_name("FILE");
    command_->add_flag("--quiet", quiet_, "print nothing but warnings and errors");
}

/// So that a typing mistake does not cost a picture.
void DiffCommand::check_outputs() const {
    for (const std::string& output : {output_, json_path_})
        for (const std::string& input : {path_a_, path_b_}) {
            std::error_code ignored;  // what is not there yet is no input
            if (fs::equivalent(output, input, ignored))
                throw Error(Blame::input, "this is one of the pictures to compare", output, "choose another name");
        }
    if (!output_.empty()) check_writable(output_, {});
    if (!json_path_.empty()) check_folder(json_path_);
}

int DiffCommand::compare() const {
    DiffRun run{path_a_, path_b_, parse_tolerances(tolerances_), allowed_, {}};
    check_outputs();
    const PictureFile a = read_exr(path_a_), b = read_exr(path_b_);
    run.diff = diff_pictures(a.film, b.film, run.tolerances);
    expect_same_corner(a, b);
    warn_of_missing(run.diff.only_in_a, path_a_, "the other picture has none");
    warn_of_missing(run.diff.only_in_b, path_b_, "the other picture has none");
    warn_of_missing(a.others, path_a_, "unknown name");
    warn_of_missing(b.others, path_b_, "unknown name");
    if (!output_.empty()) write_difference(output_, a.film, b.film, run.diff);
    if (!json_path_.empty()) write_text(json_path_, to_json(run).dump(2) + "\n");
    if (!quiet_) fmt::print("{}", describe_diff(run));
    return run.same() ? 0 : 1;
}

/// Whatever went wrong is 2 here, since 1 says that the pictures differ.
int DiffCommand::run() const try { return compare(); } catch (const std::bad_alloc&) {
    throw Error(Blame::input, "not enough memory to hold both pictures");
} catch (const std::exception& error) {
    throw Error(Blame::input, error.what());
}

}  // namespace gnomon
