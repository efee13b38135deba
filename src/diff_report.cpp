#include "diff_report.h"

#include <fmt/core.h>

#include <cmath>

namespace gnomon {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Result result) {
    if (result == Result::radiance) return "radiance";
    return result == Result::distance ? "distance" : "normal";
}

/// "p50", "p99.9".
std::string percentile_name(int64_t permille) { return fmt::format("p{}", static_cast<double>(permille) / 10); }

Json value(uint32_t id) { return id; }
Json value(float number) { return std::isfinite(number) ? Json(number) : Json(fmt::format("{}", number)); }

template <class Value>
Json to_json(const std::optional<Sample<Value>>& sample, size_t width) {
    if (!sample) return nullptr;
    return {
        {"x", sample->pixel % width}, {"y", sample->pixel / width}, {"a", value(sample->a)}, {"b", value(sample->b)}};
}

Json to_json(const PixelCount& count) {
    return {{"all", count.all()}, {"inside", count.inside}, {"silhouette", count.silhouette}};
}

Json to_json(const Differences& d, size_t width) {
    Json json{
        {"finite", d.finite}, {"over_tolerance", d.over}, {"nonfinite", d.nonfinite}, {"max", d.max}, {"rms", d.rms()}};
    for (size_t i = 0; i < permilles.size(); ++i) json[percentile_name(permilles[i])] = d.percentiles[i];
    json["worst"] = to_json(d.worst, width);
    json["first_nonfinite"] = to_json(d.first_nonfinite, width);
    return json;
}

Json to_json(const ComparedChannel& compared, size_t width) {
    return {{"channel", compared.channel.name},
            {"scale", compared.scale},
            {"tolerance", compared.tolerance},
            {"all", to_json(compared.diff.all, width)},
            {"inside", to_json(compared.diff.inside, width)},
            {"silhouette", to_json(compared.diff.silhouette, width)}};
}

/// Whose ids tell the silhouettes: "A and B", "A", "B", or "" for none.
std::string silhouettes_by(const PictureDiff& diff) {
    if (diff.ids_in_a && diff.ids_in_b) return "A and B";
    return diff.ids_in_a ? "A" : diff.ids_in_b ? "B" : "";
}

template <class Value>
std::string text(const std::optional<Sample<Value>>& sample, size_t width) {
    if (!sample) return "";
    return fmt::format("({}, {}): {}, {}", sample->pixel % width, sample->pixel / width, sample->a, sample->b);
}

/// Heads and rows of the table, with the same columns.
constexpr const char* row = "{:<11}{:<11}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{}\n";

std::string number(double value) { return value == 0 ? "0" : fmt::format("{:.1e}", value); }

std::string table_row(const char* channel, const char* where, const Differences& d, size_t width) {
    const std::optional<Sample<float>>& sample = d.worst ? d.worst : d.first_nonfinite;
    return fmt::format(row, channel, where, d.finite, d.over, d.nonfinite, number(d.percentiles[0]),
                       number(d.percentiles[2]), number(d.rms()), number(d.max),
                       sample ? "  " + text(sample, width) : "");
}

std::string table_rows(const ComparedChannel& compared, bool apart, size_t width) {
    const auto& [channel, scale, tolerance, diff] = compared;
    if (!apart) return table_row(channel.name, "all", diff.all, width);
    return table_row(channel.name, "inside", diff.inside, width) + table_row("", "silhouette", diff.silhouette, width);
}

std::string head(const DiffRun& run) {
    const std::string by = silhouettes_by(run.diff);
    return fmt::format("A {}, B {}: {}x{}; ", run.path_a, run.path_b, run.diff.width, run.diff.height) +
           (by.empty() ? "no ids, so that silhouettes are not told apart\n"
                       : fmt::format("{} of {} pixels at silhouettes, by the ids of {}\n", run.diff.pixels.silhouette,
                                     run.diff.pixels.all(), by)) +
           fmt::format(row, "channel", "where", "finite", "over", "nan|inf", "p50", "p99", "RMS", "max",
                       "  worst (x, y): A, B");
}

std::string id_line(const ComparedIds& ids, size_t width) {
    return fmt::format("ids differ in {} pixels inside and {} at silhouettes{}\n", ids.different.inside,
                       ids.different.silhouette, ids.first ? ", first " + text(ids.first, width) : "");
}

/// Of channels where NaN or an infinity stands against something else, which the table's last column need not show.
std::string nonfinite_line(const ComparedChannel& compared, size_t width) {
    const Differences& all = compared.diff.all;
    if (all.nonfinite == 0) return "";
    return fmt::format("{}: NaN or infinity against another value in {} pixels, first {}\n", compared.channel.name,
                       all.nonfinite, text(all.first_nonfinite, width));
}

std::string verdict(const DiffRun& run) {
    const PixelCount& different = run.diff.different;
    const std::string allowed = run.allowed > 0 ? fmt::format(" ({} allowed)", run.allowed) : "";
    const std::string where = silhouettes_by(run.diff).empty() ? ""
                                                               : fmt::format(", {} inside and {} at silhouettes",
                                                                             different.inside, different.silhouette);
    return fmt::format("{}: {} of {} pixels differ{}{}\n", run.same() ? "same" : "different", different.all(),
                       run.diff.pixels.all(), where, allowed);
}

}  // namespace

Json to_json(const DiffRun& run) {
    const PictureDiff& diff = run.diff;
    const auto width = static_cast<size_t>(diff.width);
    Json json;
    json["program"] = "gnomon " GNOMON_VERSION;
    json["a"] = {{"file", run.path_a}, {"only_here", diff.only_in_a}};
    json["b"] = {{"file", run.path_b}, {"only_here", diff.only_in_b}};
    json["image"] = {{"width", diff.width}, {"height", diff.height}};
    for (const Result result : {Result::radiance, Result::distance, Result::normal})
        json["tolerance"][name_of(result)] = run.tolerances.of(result);
    json["allowed"] = run.allowed;
    json["same"] = run.same();
    json["silhouettes_by"] = silhouettes_by(diff);
    json["pixels"] = to_json(diff.pixels);
    json["different"] = to_json(diff.different);
    json["channels"] = Json::array();
    for (const ComparedChannel& compared : diff.channels) json["channels"].push_back(to_json(compared, width));
    if (diff.id) json["id"] = {{"different", to_json(diff.id->different)}, {"first", to_json(diff.id->first, width)}};
    return json;
}

std::string describe_diff(const DiffRun& run) {
    const auto width = static_cast<size_t>(run.diff.width);
    std::string text = head(run);
    for (const ComparedChannel& compared : run.diff.channels)
        text += table_rows(compared, !silhouettes_by(run.diff).empty(), width);
    for (const ComparedChannel& compared : run.diff.channels) text += nonfinite_line(compared, width);
    if (run.diff.id) text += id_line(*run.diff.id, width);
    return text + verdict(run);
}

}  // namespace gnomon
