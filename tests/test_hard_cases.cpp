// Hard scenes (tests/hard) against the oracle: the default accuracy may be wrong about them, but not more than it was.
#include <fmt/format.h>

#include <cstdio>

#include "catch.h"
#include "measure_hard.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

using Subject = std::vector<HardCase> (*)();
constexpr Subject subjects[] = {distances,   grounds,      tangents, surfaces, nests,
                                terminators, point_lights, offsets,  extremes, cameras};

constexpr int at_length = 3;  // times as wide and high; odd, so that pixels have their centres where they had them

/// As a Record has them.
std::string row(const Figures& f) {
    return fmt::format("{{{}, {}, {}, {:.3g}, {:.3g}}}", f.hits, f.ids, f.shadows, f.t, f.normal);
}

/// Recorded values have three digits.
bool within(double value, double recorded) { return value <= recorded * 1.005; }

bool within(const Figures& now, const Figures& recorded) {
    return now.hits <= recorded.hits && now.ids <= recorded.ids && now.shadows <= recorded.shadows &&
           within(now.t, recorded.t) && within(now.normal, recorded.normal);
}

void hold(const std::string& name, const Measured& measured, const Figures& recorded) {
    INFO(name << ": " << row(measured.figures) << ", recorded " << row(recorded)
              << "; first wrong: " << measured.first_wrong << "; worst t: " << measured.worst_t
              << "; worst normal: " << measured.worst_normal);
    CHECK(within(measured.figures, recorded));
    if (within(measured.figures, recorded) && !within(recorded, measured.figures))
        WARN(name << ": better than recorded, lower the record to " << row(measured.figures));
}

void hold_strict(Subject subject) {
    on_every_device([&](Renderer& renderer) {
        for (const HardCase& hard : subject()) hold(hard.name, measure(renderer, hard, {}), hard.record.figures);
    });
}

}  // namespace

TEST_CASE("hard cases: small spheres far away", "[hard]") { hold_strict(distances); }
TEST_CASE("hard cases: grounds", "[hard]") { hold_strict(grounds); }
TEST_CASE("hard cases: tangents", "[hard]") { hold_strict(tangents); }
TEST_CASE("hard cases: eyes at surfaces", "[hard]") { hold_strict(surfaces); }
TEST_CASE("hard cases: nested, touching and coincident spheres", "[hard]") { hold_strict(nests); }
TEST_CASE("hard cases: terminators", "[hard]") { hold_strict(terminators); }
TEST_CASE("hard cases: point lights", "[hard]") { hold_strict(point_lights); }
TEST_CASE("hard cases: far from the origin", "[hard]") { hold_strict(offsets); }
TEST_CASE("hard cases: very large and very small numbers", "[hard]") { hold_strict(extremes); }
TEST_CASE("hard cases: cameras", "[hard]") { hold_strict(cameras); }

TEST_CASE("hard cases: certified pictures have no wrong decision", "[hard][certified]") {
    RenderOptions options;
    options.accuracy = Accuracy::certified;
    on_every_device([&](Renderer& renderer) {
        for (const Subject subject : subjects)
            for (const HardCase& hard : subject()) {
                const Measured measured = measure(renderer, hard, options);
                INFO(hard.name << ": " << row(measured.figures) << "; first wrong: " << measured.first_wrong);
                CHECK(measured.figures.hits == 0);
                CHECK(measured.figures.ids == 0);
                CHECK(measured.figures.shadows == 0);
            }
    });
}

TEST_CASE("hard cases, larger pictures", "[.long]") {
    on_every_device([](Renderer& renderer) {
        for (const Subject subject : subjects)
            for (const HardCase& hard : subject())
                hold(hard.name, measure(renderer, hard, {}, at_length), hard.record.at_length);
    });
}

/// What the records are taken from: name, pixels, figures; pixels and figures at length.
TEST_CASE("hard cases: print the figures", "[.figures]") {
    on_every_device([](Renderer& renderer) {
        for (const Subject subject : subjects)
            for (const HardCase& hard : subject()) {
                const Measured normal = measure(renderer, hard, {}), large = measure(renderer, hard, {}, at_length);
                fmt::print("{} | {} | {} | {} | {}\n", hard.name, normal.pixels, row(normal.figures), large.pixels,
                           row(large.figures));
                std::fflush(stdout);
            }
    });
}
