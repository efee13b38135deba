// Spheres so large that one stands on them.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// From 1.7 above ground of this radius, with balls that rest on it, to the horizon, which is at a third of the height.
Scene standing(double radius) {
    Scene scene = small_picture({{{0, -1.7 - radius, 0}, radius}}, two_suns(), 50);
    scene.image = {36, 24};
    scene.camera.at = {0, -0.15, 1};
    for (int i = 0; i < 4; ++i) {
        const double x = 1.3 * i - 2, z = 4 + 3.1 * i, size = 0.5 + 0.1 * i;
        const double y = std::sqrt((radius + size) * (radius + size) - x * x - z * z) - 1.7 - radius;
        scene.spheres.push_back({{x, y, z}, size});
    }
    scene.lights.push_back(PointLight{{0.9, 2.3, 6.1}, {100, 100, 100}});
    return scene;
}

/// Through a telescope at the horizon, which dips sqrt(2 h / r) below the horizontal.
Scene horizon(double radius) {
    const double dip = std::acos(radius / (radius + 1.7));
    Scene scene = small_picture({{{0, -1.7 - radius, 0}, radius}}, two_suns(), 0.02 * dip * degrees_per_radian);
    scene.camera.at = {0, -std::tan(dip), 1};
    return scene;
}

}  // namespace

std::vector<HardCase> grounds() {
    const std::string why = "1.7 is a rounding beside the radius, and light grazes the ground that balls stand on";
    const std::string far = "the roots are nearly equal for all that is near the horizon";
    return {
        {"ground of radius 1e3", why, {standing(1e3)}, {{0, 0, 0, 2.64, 1.09e-06}, {0, 0, 0, 18.1, 1.39e-05}}},
        {"ground of radius 1e4", why, {standing(1e4)}, {{0, 0, 0, 3.2, 1.72e-06}, {0, 0, 0, 7.22, 3.8e-06}}},
        {"ground of radius 1e5", why, {standing(1e5)}, {{0, 0, 0, 2.61, 1.21e-06}, {0, 0, 0, 6.76, 3.66e-06}}},
        {"ground of radius 1e6", why, {standing(1e6)}, {{0, 0, 0, 3.57, 1.6e-06}, {0, 0, 0, 11.2, 3.08e-06}}},
        {"ground of radius 1e7", why, {standing(1e7)}, {{0, 0, 0, 3.6, 1.5e-06}, {0, 0, 0, 178, 3.69e-06}}},
        {"horizon of radius 1e3", far, {horizon(1e3)}, {{0, 0, 0, 23.4, 8.06e-08}, {0, 0, 0, 35, 1.25e-07}}},
        {"horizon of radius 1e5", far, {horizon(1e5)}, {{0, 0, 0, 5.73, 4.09e-09}, {0, 0, 0, 21.4, 1.32e-08}}},
        {"horizon of radius 1e7", far, {horizon(1e7)}, {{0, 0, 0, 15.7, 8.37e-10}, {0, 0, 0, 25.5, 1.28e-09}}},
    };
}

}  // namespace gnomon::test
