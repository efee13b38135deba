// How long launches may be: the pace of a kernel, learned from launches that a model of a device answers.
#include "pace.h"

#include <algorithm>
#include <vector>

#include "catch.h"
#include "render.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

constexpr double bound = 0.1;
constexpr int64_t least = 32;

/// A device of which each launch takes a moment, and each work-item the seconds that `cost` says.
template <class Cost>
std::vector<double> launch_all(KernelPace& pace, int64_t items, Cost cost) {
    constexpr double moment = 1e-5;
    std::vector<double> launches;
    for (int64_t first = 0; first < items;) {
        const int64_t part = pace.part(items - first, least, bound);
        REQUIRE(part > 0);
        CHECK((part % least == 0 || first + part == items));
        double seconds = moment;
        for (int64_t i = first; i < first + part; ++i) seconds += cost(i);
        pace.measured(part, seconds);
        launches.push_back(seconds);
        first += part;
    }
    return launches;
}

double longest(const std::vector<double>& launches) { return *std::max_element(launches.begin(), launches.end()); }

}  // namespace

TEST_CASE("pace: short launches are not cut once they are known", "[pace]") {
    KernelPace pace;
    const auto quick = [](int64_t) { return 5e-8; };
    launch_all(pace, 100'000, quick);
    for (const int64_t items : {1, 31, 32, 33, 100'000}) CHECK(launch_all(pace, items, quick).size() == 1);
    CHECK(launch_all(pace, 1'000'000, quick).size() <= 6);  // 50 ms of work: parts of a tenth of the bound
}

TEST_CASE("pace: whatever a work-item takes, no launch is longer than the bound", "[pace]") {
    for (double seconds = 1e-9; seconds < bound / least; seconds *= 7) {
        INFO(seconds << " s a work-item");
        KernelPace pace;
        CHECK(longest(launch_all(pace, 200'000, [=](int64_t) { return seconds; })) < bound);
    }
}

TEST_CASE("pace: from tile to tile work-items may become eight times as slow", "[pace]") {
    KernelPace pace;
    constexpr int64_t tile = 2048;
    // From 20 ns to 0.7 ms, as in a picture that leads from the sky into a crowd.
    double slowest = 0;
    for (int i = 0; i < 5; ++i) {
        const auto cost = [&](int64_t item) {
            return slowest = 2e-8 * std::pow(8, i + static_cast<double>(item) / static_cast<double>(tile));
        };
        CHECK(longest(launch_all(pace, tile, cost)) < bound);
    }
    CHECK(slowest * static_cast<double>(least) < bound);
    CHECK(slowest * static_cast<double>(tile) > 10 * bound);
}

TEST_CASE("pace: the slowest of late counts, and is forgotten", "[pace]") {
    KernelPace pace;
    pace.measured(1'000'000, 1e-2);
    CHECK(pace.part(1'000'000, least, bound) == 1'000'000);
    pace.measured(100'000, 1.0);
    const int64_t after = pace.part(1'000'000, least, bound);
    CHECK(static_cast<double>(after) * 1e-5 < bound);
    pace.measured(after, 1e-8 * static_cast<double>(after));
    CHECK(pace.part(1'000'000, least, bound) < 1'000'000);
    for (int i = 0; i < 20; ++i) pace.measured(100'000, 1e-3);
    CHECK(pace.part(1'000'000, least, bound) == 1'000'000);
}

TEST_CASE("pace: few quick work-items tell nothing about many", "[pace]") {
    KernelPace pace;
    pace.measured(1'000'000, 1e-2);
    pace.measured(1, 1e-4);  // what a launch costs
    CHECK(pace.part(1'000'000, least, bound) == 1'000'000);
}

TEST_CASE("pace: a picture of more spheres begins anew", "[pace]") {
    Pace paces;
    KernelPace& kernel = paces.of("kernel -D LANES=16");
    paces.expect(bound, 10);
    CHECK_FALSE(kernel.is_loaded());
    kernel.set_loaded();
    kernel.measured(1'000'000, 1e-3);
    paces.expect(bound, 10);
    CHECK(kernel.part(1'000'000, least, bound) == 1'000'000);
    paces.expect(bound, 11);
    CHECK(kernel.part(1'000'000, least, bound) == least);
    CHECK(kernel.is_loaded());
    CHECK(&paces.of("kernel -D LANES=16") == &kernel);
}
