// A scene far from the origin: all coordinates share their leading digits.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

std::vector<Scene> both_ways(double by) {
    return {moved(still_life(), {by, by, by}), moved(still_life(), {-by / 3, by / 7, by})};
}

}  // namespace

std::vector<HardCase> offsets() {
    const std::string why =
        "as floats, coordinates would be off by that times 6e-8, and centres by as much from each other";
    return {
        {"at the origin",
         "the same scene, to compare",
         {still_life()},
         {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"1e5 from the origin", why, both_ways(1e5), {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"1e6 from the origin", why, both_ways(1e6), {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"1e7 from the origin", why, both_ways(1e7), {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"1e8 from the origin", why, both_ways(1e8), {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"1e9 from the origin", why, both_ways(1e9), {{0, 0, 0, 3.41, 3.79e-06}, {0, 0, 0, 16.6, 4.75e-06}}},
    };
}

}  // namespace gnomon::test
