// `gnomon report` as a user runs it.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "report/gnuplot.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
using nlohmann::json;

namespace {

bool is_time(const std::string& key) {
    return contains(key, "ns_per") || contains(key, "seconds") || contains(key, "mrays");
}

/// How many objects have a time; each must have an error beside it.
int check_times(const json& value) {
    int times = 0;
    if (value.is_object()) {
        bool has_time = false;
        for (const auto& [key, inner] : value.items()) has_time = has_time || is_time(key);
        times += has_time;
        if (has_time) CHECK(value.at("error").is_object());
    }
    for (const json& inner : value)
        if (inner.is_structured()) times += check_times(inner);
    return times;
}

void check_formula(const json& row) {
    CHECK(row.at("ns_per_ray").at("median").get<double>() >= row.at("ns_per_ray").at("least").get<double>());
    CHECK(row.at("ns_per_ray").at("least").get<double>() > 0);
    CHECK(row.at("mrays_per_second").get<double>() > 0);
    CHECK(row.at("on_pareto_front").is_boolean());
    const json& error = row.at("error");
    for (const char* what : {"t_ulp", "normal_radians"})
        for (const char* key : {"max_lower_bound", "p99", "rms", "rays"}) CHECK(error.at(what).at(key) >= 0);
    for (const char* what : {"missed", "false_hits"}) CHECK(error.at(what).at("of") > 0);
    CHECK(error.at("worst").at("dir").size() == 3);
    int64_t counted = 0;
    for (const json& count : error.at("ulp_histogram").at("counts")) counted += count.get<int64_t>();
    CHECK(counted == error.at("t_ulp").at("rays"));
}

/// That the formulas are what they are called. Rounded from double, t is half an ulp off and what double leaves: in the
/// worst case, a grazing ray from 1000 radii away, the discriminant is 2^-53 (d / r) over sqrt(10^-7) wrong, less than
/// 0.01 ulp of a float. Textbooks' formula is worst by far where the sphere is far away. What is certified is never
/// wrong.
void check_formulas(const json& table) {
    std::map<std::string, double> worst;
    for (const json& row : table.at("formulas")) {
        check_formula(row);
        worst[row.at("formula")] = row.at("error").at("t_ulp").at("max_lower_bound");
        if (row.at("formula") != "certified") continue;
        for (const char* decision : {"missed", "false_hits"}) CHECK(row.at("error").at(decision).at("wrong") == 0);
    }
    if (worst.count("double")) CHECK(worst.at("double") <= 0.51);
    CHECK(worst.at("compensated") < worst.at("pencil"));
    CHECK(worst.at("pencil") < worst.at("textbook"));
}

void check_pictures(const json& pictures) {
    CHECK(pictures.size() == 3);
    for (const json& table : pictures)
        for (const json& row : table.at("accuracies")) {
            CHECK(row.at("seconds").at("least") > 0);
            CHECK(row.at("kernels").size() >= 2);
            const json& error = row.at("error");
            for (const char* key : {"pixels", "max_radiance_lower_bound", "rms_radiance", "wrong_ids", "wrong_pixels"})
                CHECK(error.at(key) >= 0);
            CHECK(error.at("wrong_shadow_bits").at("of") > 0);
        }
}

}  // namespace

TEST_CASE("a quick report has all that it promises", "[report]") {
    const TempFolder folder;
    const Ran ran = run_program("report --quick -o " + quoted(folder.path()));
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    CHECK(folder.count() == 2);
    const json report = json::parse(read_file(folder / "report.json"));
    for (const char* key : {"program", "date", "quick", "reference", "plots"}) CHECK(report.contains(key));
    REQUIRE(report.at("devices").size() == 1);
    const json& device = report.at("devices").at(0);
    CHECK(device.at("device").at("driver").is_string());
    CHECK(device.at("cases").size() == 9);
    for (const json& table : device.at("cases")) {
        check_formulas(table);
        CHECK(table.at("default_on_pareto_front").is_boolean());
    }
    check_pictures(device.at("pictures"));
    const json& grid = device.at("grid");
    for (const json& map : grid.at("formulas"))
        CHECK(map.at("wrong_decisions").size() == grid.at("columns").get<size_t>() * grid.at("rows").get<size_t>());
    CHECK(check_times(report) > 9 * 4);
    CHECK(contains(ran.out, "Pareto front: "));
    CHECK(contains(ran.out, "the default, pencil, is"));

    const std::string html = read_file(folder / "report.html");
    for (const char* link : {"src=", "href=\"http", "href='http", "@import", "url(http", "<script", "<link"})
        CHECK_FALSE(contains(html, link));
    CHECK(contains(html, "the default, pencil, is"));
    CHECK(contains(html, "<svg") == report::has_gnuplot());
    CHECK(contains(html, "gnuplot-nox") == !report::has_gnuplot());
}

TEST_CASE("a report refuses what is wrong before it measures", "[report]") {
    const TempFolder folder;
    const std::string missing = folder / "missing";
    for (const std::string& arguments :
         {"-o " + quoted(missing), quoted(missing + ".json"), std::string("--device no_such_thing"),
          std::string("--all-devices --device cpu"), std::string("--slow")}) {
        const Ran ran = run_program("report --quick " + arguments);
        INFO(arguments);
        CHECK(ran.code == 2);
        CHECK_FALSE(ran.err.empty());
        CHECK(ran.out.empty());
    }
    const Ran preset = run_program("report --quick", "GNOMON_DEVICE=no_such_thing");
    CHECK(preset.code == 2);
    CHECK(contains(preset.err, "no_such_thing"));
    CHECK(folder.count() == 0);
}
