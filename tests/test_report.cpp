// What the report is made of, without a device: statistics and the Pareto front against brute force, the exact
// reference against cases worked out by hand, and the drawings' way into the page.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "catch.h"
#include "kernel_harness.h"
#include "reference.h"
#include "report/exact.h"
#include "report/gnuplot.h"
#include "report/label_places.h"
#include "report/pareto.h"
#include "report/plots.h"
#include "report/report_html.h"
#include "report/statistics.h"

using namespace gnomon;
using namespace gnomon::test;
using namespace gnomon::report;

namespace {

/// By the definition: nobody is at most as slow and at most as wrong, and better in one of the two.
std::vector<bool> front_by_definition(const std::vector<Cost>& costs) {
    std::vector<bool> front;
    for (const Cost& a : costs)
        front.push_back(std::none_of(costs.begin(), costs.end(), [&](const Cost& b) {
            return b.time <= a.time && b.error <= a.error && (b.time < a.time || b.error < a.error);
        }));
    return front;
}

void check_hit(const RootSphere& sphere, const Float3& dir, double t, const Vec3& normal) {
    const ExactHit hit = exact_hit(sphere, dir);
    CHECK(hit.hits);
    CHECK(hit.t == t);
    CHECK(hit.normal.x == normal.x);
    CHECK(hit.normal.y == normal.y);
    CHECK(hit.normal.z == normal.z);
}

}  // namespace

TEST_CASE("a summary is what sorting says", "[report]") {
    Random random(1);
    for (const int count : {1, 2, 99, 100, 101, 200, 1000}) {
        std::vector<double> errors;
        for (int i = 0; i < count; ++i) errors.push_back(random.uniform(0, 1));
        const Summary s = summarize(errors);
        CHECK(s.count == count);
        CHECK(errors[s.worst] == s.max);
        std::vector<double> sorted = errors;
        std::sort(sorted.begin(), sorted.end());
        CHECK(s.max == sorted.back());
        // The least value of which 99 % or more are not above it.
        const auto p99 = std::find_if(sorted.begin(), sorted.end(), [&](double value) {
            return 100 * std::count_if(errors.begin(), errors.end(), [&](double e) { return e <= value; }) >=
                   99 * count;
        });
        CHECK(s.p99 == *p99);
    }
    CHECK(summarize({3, 4}).rms == std::sqrt(12.5));
    CHECK(summarize({5, 1, 5}).worst == 0);
    CHECK(summarize({}).count == 0);
}

TEST_CASE("a series has its middle and its least", "[report]") {
    CHECK(series({3, 1, 2}).median == 2);
    CHECK(series({4, 1, 3, 2}).median == 3);
    CHECK(series({4, 1, 3, 2}).least == 1);
}

TEST_CASE("errors fall into bins of powers of two, edges into the lower", "[report]") {
    Histogram histogram;
    for (const double error : {0.0, 0.5, 0.51, 1.0, 1.5, 1e300}) histogram.add(error);
    CHECK(histogram.counts[0] == 2);
    CHECK(histogram.counts[1] == 2);
    CHECK(histogram.counts[2] == 1);
    CHECK(histogram.counts[Histogram::bins - 1] == 1);
}

TEST_CASE("an ulp is the distance of neighbouring floats", "[report]") {
    for (const float value : {1.0f, 1.5f, 3e-5f, 12345.678f, 1e-44f}) {
        CHECK(ulps(std::nextafter(value, 1e30f), static_cast<double>(value)) == 1);
        CHECK(ulps(value, static_cast<double>(value)) == 0);
    }
    CHECK(ulps(2, 1.0 + 0x1p-24) == 0x1p23 - 0.5);
}

TEST_CASE("the Pareto front is what its definition says", "[report]") {
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        std::vector<Cost> costs(static_cast<size_t>(random.uniform(0, 9)));
        // Few values, so that there are many ties.
        for (Cost& cost : costs) cost = {std::floor(random.uniform(1, 5)), std::floor(random.uniform(1, 5))};
        CHECK(pareto_front(costs) == front_by_definition(costs));
    }
    CHECK(pareto_front({{1, INFINITY}, {2, 3}}) == std::vector<bool>{false, true});
}

TEST_CASE("the exact reference has the hits that can be worked out by hand", "[report]") {
    check_hit({{0, 0, 5}, 1, 0}, {0, 0, 1}, 4, {0, 0, -1});
    check_hit({{0, 0, 5}, 1, 0}, {0, 0, 0.5f}, 8, {0, 0, -1});  // dir as it is, not brought to length 1
    check_hit({{0, 0, 1}, 2, 0}, {0, 0, 1}, 3, {0, 0, 1});      // from inside
    check_hit({{0, 0, 2}, 2, 0}, {0, 0, 1}, 4, {0, 0, 1});      // from the surface: t = 0 is no hit
    check_hit({{3, 0, 4}, 3, 0}, {0, 0, 1}, 4, {-1, 0, 0});     // touches
    check_hit({{0, 0, 1e7f}, 1, 0}, {0, 0, 1}, 9999999, {0, 0, -1});
    check_hit({{0, 3, 9}, 5, 0}, {0, 0, 1}, 5, {0, -0.6, -0.8});  // 3, 4, 5
    CHECK_FALSE(exact_hit({{3, 0, 4}, 3 - 0x1p-22f, 0}, {0, 0, 1}).hits);
    CHECK_FALSE(exact_hit({{0, 0, -5}, 1, 0}, {0, 0, 1}).hits);
    CHECK_FALSE(exact_hit({{0, 0, -2}, 2, 0}, {0, 0, 1}).hits);
}

TEST_CASE("the exact power is rounded once", "[report]") {
    CHECK(exact_power({3, 0, 4}, 5) == 0);
    // (2^12 + 2^-11)^2 - 2^24 = 4 + 2^-22, and 2^-22 once more: in float nothing but the 4 would be left.
    CHECK(exact_power({4096 + 0x1p-11f, 0, 0x1p-11f}, 4096) == 4 + 0x1p-21f);
}

TEST_CASE("the exact reference agrees with double where that is easy", "[report]") {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const RootSphere sphere{to_float(random.direction() * random.uniform(2, 5)), 1, 0};
        const Float3 dir = to_float(normalize(to_double(sphere.center) + random.direction() * 0.5));
        const ExactHit hit = exact_hit(sphere, dir);
        const auto roots = reference::intersect({{}, to_double(dir)}, {to_double(sphere.center), 1, {}});
        REQUIRE(hit.hits);
        // b^2 - 4 a c is of the size of b^2 <= 100 and at least 4 (1 - 0.5^2): 100 / 3 roundings of 2^-53, and a few.
        CHECK(std::fabs(hit.t - roots.near) <= 1e-13 * hit.t * 5);
    }
}

TEST_CASE("names of points lie beside one another", "[report]") {
    const std::vector<Point> points = {{100, 50, "textbook"}, {101, 50, "perpendicular"}, {103, 52, "pencil"}};
    const Panel panel{260, 190};
    const std::vector<LabelPlace> places = label_places(panel, points);
    for (size_t i = 0; i < places.size(); ++i) {
        const double width = panel.letter_width * static_cast<double>(points[i].name.size());
        CHECK(places[i].x >= 0);
        CHECK(places[i].x + width <= panel.width);
        for (size_t j = 0; j < i; ++j) {
            const double other = panel.letter_width * static_cast<double>(points[j].name.size());
            const bool apart = places[i].x + width <= places[j].x || places[j].x + other <= places[i].x ||
                               std::fabs(places[i].y - places[j].y) >= panel.letter_height;
            CHECK(apart);
        }
    }
}

TEST_CASE("a drawing inside a page has ids of its own", "[report]") {
    const std::string svg =
        "<?xml version='1.0'?><svg><g fill='none'>\n</g><g id=\"a\"><b/></g><path id='b'/><use xlink:href='#b'/></svg>";
    CHECK(inlined(svg, "x-") == "<svg><g id=\"x-a\"><b/></g><path id='x-b'/><use xlink:href='#x-b'/></svg>");
}

TEST_CASE("without gnuplot the page says what to install", "[report]") {
    const char* path = std::getenv("PATH");
    const std::string before = path ? path : "";
    setenv("PATH", "/nowhere", 1);
    const bool found = has_gnuplot();
    setenv("PATH", before.c_str(), 1);
    CHECK_FALSE(found);
    const std::string html = to_html(Report{"today", true, {}, "install gnuplot-nox & more"});
    CHECK(contains(html, "install gnuplot-nox &amp; more"));
    CHECK_FALSE(contains(html, "<svg"));
}
