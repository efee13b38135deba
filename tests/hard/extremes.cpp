// Radii of very different sizes, and scenes whose numbers float hardly holds.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// Radii over twelve orders of magnitude, 1e-6 to 1e6, that look alike: each at ten times its radius.
Scene alike() {
    Scene scene = small_picture({}, two_suns(), 60);
    scene.image = {52, 16};
    for (int k = -6; k <= 6; ++k)
        scene.spheres.push_back({Vec3{0.25 * k, 0.05 * (k % 3), 1} * std::pow(10.0, k + 1), std::pow(10.0, k)});
    return scene;
}

/// Spheres of all these radii in one place: each rests on the one that is ten times as large.
Scene stacked() {
    Scene scene = small_picture({}, two_suns(), 60);
    double top = -3;
    for (int k = 6; k >= -6; --k) {
        const double radius = std::pow(10.0, k);
        scene.spheres.push_back({{0.1, top + (k == 6 ? -radius : radius), 10}, radius});
        if (k != 6) top += 2 * radius;
        if (k > 0) top = -3;  // larger ones are in the ground, in each other
    }
    return scene;
}

}  // namespace

std::vector<HardCase> extremes() {
    const std::string scale = "the same still life: only the exponents change";
    return {
        {"radii 1e-6 to 1e6, alike",
         "one unit serves all",
         {alike()},
         {{0, 0, 0, 1.35e+03, 0.00103}, {0, 0, 0, 6.68e+03, 0.0104}}},
        {"radii 1e-6 to 1e6, stacked",
         "what is small is near what is large",
         {stacked()},
         {{0, 0, 0, 14.7, 7e-07}, {0, 0, 0, 45.4, 2.14e-06}}},
        {"scaled by 2^20",
         scale,
         {scaled(still_life(), 0x1p20)},
         {{0, 0, 0, 3.09, 3.67e-06}, {0, 0, 0, 14.8, 3.68e-06}}},
        {"scaled by 1e30",
         scale + "; squares overflow",
         {scaled(still_life(), 1e30)},
         {{0, 0, 0, 5.03, 9.6e-07}, {0, 0, 0, 29.2, 1.24e-05}}},
        {"scaled by 1e36",
         scale + "; distances are near the largest float",
         {scaled(still_life(), 1e36)},
         {{0, 0, 0, 3.94, 3.32e-06}, {0, 0, 0, 25.6, 4.64e-06}}},
        {"scaled by 1e-30",
         scale + "; squares underflow",
         {scaled(still_life(), 1e-30)},
         {{0, 0, 0, 5.33, 2.1e-06}, {0, 0, 0, 21.3, 9.76e-06}}},
        {"scaled by 1e-38",
         scale + "; radii and some coordinates are denormal",
         {scaled(still_life(), 1e-38)},
         {{0, 0, 0, 6.13, 2.06e-06}, {0, 0, 0, 15.9, 5.24e-06}}},
        {"scaled by 1e-43",
         scale + "; all numbers are denormal",
         {scaled(still_life(), 1e-43)},
         {{0, 0, 0, 0.5, 3.03e-06}, {0, 0, 0, 0.5, 4.28e-06}}},
    };
}

}  // namespace gnomon::test
