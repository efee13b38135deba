// The quick oracle against the exact one: intervals between doubles hold the truth, and what they decide is so.
#include "catch.h"
#include "hard/hard_case.h"
#include "kernel_harness.h"
#include "quick_oracle.h"

using namespace gnomon;
using namespace gnomon::test;
using oracle::Interval;
using oracle::QuickInterval;

namespace {

/// Of either sign and any size, subnormal ones among them; what 12 bits of significand hold, now and then.
double any_double(Random& random, int least, int most) {
    const double significand = random.word() % 4 == 0 ? std::floor(random.uniform(1, 4096)) : random.uniform(1, 2);
    const double size =
        std::ldexp(significand, least + static_cast<int>(random.word() % static_cast<uint64_t>(most - least)));
    return random.word() % 2 == 0 ? size : -size;
}

/// The exact result lies between the ends, and these are no farther from it than a few doubles.
void check_encloses(const QuickInterval& quick, const Interval& exact) {
    REQUIRE(Interval(quick.lower()) <= exact);
    REQUIRE(Interval(quick.upper()) >= exact);
    REQUIRE(quick.upper() - quick.lower() <= 0x1p-51 * std::fabs(quick.lower()) + 0x1p-1072);
}

}  // namespace

TEST_CASE("quick oracle: rounded operations enclose the exact result", "[oracle]") {
    const oracle::Digits digits(1280);  // sums and products of doubles are exact
    Random random(1);
    for (int k = 0; k < 20000; ++k) {
        const double x = any_double(random, -540, 400), y = any_double(random, -540, 400);
        const QuickInterval a(x), b(y);
        check_encloses(a + b, Interval(x) + y);
        check_encloses(a - b, Interval(x) - y);
        check_encloses(a * b, Interval(x) * y);
        check_encloses(a / b, Interval(x) / y);
        check_encloses(oracle::root(QuickInterval(std::fabs(x))), sqrt(Interval(std::fabs(x))));
    }
}

TEST_CASE("quick oracle: decides hard cases as the exact one", "[oracle]") {
    using Subject = std::vector<HardCase> (*)();
    const Subject subjects[] = {distances,   grounds,      tangents, surfaces, nests,
                                terminators, point_lights, offsets,  extremes, cameras};
    int64_t quickly = 0, pixels = 0;
    for (const Subject subject : subjects)
        for (const HardCase& hard : subject())
            for (const Scene& scene : hard.scenes) {
                INFO(hard.name);
                const oracle::QuickOracle quick(scene);
                for (int p = 0; p < scene.image.width * scene.image.height; p += 11, ++pixels) {
                    const int i = p % scene.image.width, j = p / scene.image.width;
                    const auto answer = quick.decide(i, j);
                    if (answer.exactly) continue;
                    ++quickly;
                    REQUIRE(answer.decisions == quick.exact().decide(i, j));
                }
            }
    CHECK(quickly > pixels / 2);
}

TEST_CASE("quick oracle: of distances that doubles do not tell apart it does not take the first", "[oracle]") {
    Scene scene;
    scene.image = {1, 1};
    scene.spheres = {{{0, 0x1p-60, 10}, 3}, {{0, -0x1p-60, 10}, 3}, {{0, 0, 10 - 0x1p-49}, 3}, {{0, 0, 10}, 3}};
    CHECK(oracle::QuickOracle(scene).decide(0, 0).decisions.id == 2);
    scene.spheres.erase(scene.spheres.begin() + 2);
    CHECK(oracle::QuickOracle(scene).decide(0, 0).decisions.id == 2);
}
