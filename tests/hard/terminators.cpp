// Where light begins to arrive: n . l near 0.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// A sphere lit from the side, looked at where day and night meet: the middle column, of which the light is exactly
/// across.
Scene lit_across(double radius, double fov, const Light& light) {
    Scene scene = small_picture({{{0, 0, 2 * radius}, radius}}, {light}, fov);
    scene.image = {25, 17};
    return scene;
}

/// A sphere looked at where an aslant sun is nearly across.
Scene slanted(double fov) {
    const Vec3 center{0.1, 0.2, 10.3}, place{0.1, 0.7, 7.1};
    Scene scene = small_picture({{center, length(place - center)}}, {}, fov);
    scene.camera.at = place;
    scene.lights = {DirectionalLight{cross(place - center, {1, 0.3, 0.2}), {1, 1, 1}}};
    return scene;
}

}  // namespace

std::vector<HardCase> terminators() {
    const Light sun = DirectionalLight{{1, 0, 0}, {1, 1, 1}};
    const std::string why = "whether n . l > 0 hangs on the last bits of the normal",
                      exactly = "; in the middle it is 0: night";
    return {
        {"sun exactly across",
         why + exactly,
         {lit_across(1, 60, sun), lit_across(1e6, 60, sun)},
         {{0, 0, 0, 1.62, 1.81e-07}, {0, 0, 0, 30.2, 3.68e-06}}},
        {"sun exactly across, telescope",
         why + exactly,
         {lit_across(1, 1e-4, sun), lit_across(1e6, 1e-6, sun)},
         {{0, 0, 0, 1.84e-05, 4.9e-14}, {0, 0, 0, 1.96e-05, 1.03e-13}}},
        {"lamp in the tangent plane",
         why + exactly,
         {lit_across(4, 60, PointLight{{4, 0, 4}, {1, 1, 1}}),
          lit_across(4, 1e-4, PointLight{{0, 1024, 4}, {1, 1, 1}})},
         {{0, 0, 0, 1.24, 1.81e-07}, {0, 0, 0, 21.3, 2.51e-06}}},
        {"sun aslant",
         why,
         {slanted(60), slanted(1), slanted(1e-2)},
         {{0, 0, 0, 3.13, 5.16e-07}, {0, 0, 0, 15.4, 4.12e-06}}},
        {"sun aslant, telescope",
         why,
         {slanted(1e-4), slanted(1e-6)},
         {{0, 0, 194, 2.22, 9.71e-08}, {0, 0, 1750, 2.48, 9.8e-08}}},
    };
}

}  // namespace gnomon::test
