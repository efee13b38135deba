// Eyes on, just inside and just outside a surface.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

// It shines on what is below and before the spheres' centres, where the eye is.
const Light from_below = DirectionalLight{{1, -2, -1.5}, {2, 3, 4}};

/// The eye on a sphere whose centre is 3 : 4 up and ahead, or off its surface by a share of the radius (inward < 0).
Scene on_sphere(double radius, double off) {
    const double fifth = radius / 5;  // whole
    Scene scene = small_picture({{{0, 3 * fifth, 4 * fifth}, radius}}, {from_below, two_suns()[1]}, 120);
    scene.camera.eye = Vec3{0, -0.6, -0.8} * (off * radius);
    scene.camera.at = scene.camera.eye + Vec3{0, 0, 1};
    scene.spheres.push_back({{radius, radius, 3 * radius}, radius / 2});
    return scene;
}

std::vector<Scene> on_all(double off) { return {on_sphere(5, off), on_sphere(5e3, off), on_sphere(5e6, off)}; }

}  // namespace

std::vector<HardCase> surfaces() {
    const std::string inside = "from inside, the far side is seen, from outside the near one or nothing";
    return {
        {"eye on a surface",
         "t = 0 is no hit, and |eye - centre|^2 - r^2 is exactly 0",
         on_all(0),
         {{0, 0, 0, 11.1, 2.17e-07}, {0, 0, 0, 34.8, 2.47e-07}}},
        {"eye 1e-15 r outside a surface",
         inside,
         on_all(1e-15),
         {{0, 0, 0, 10.2, 1.19e-08}, {0, 0, 0, 34.4, 1.19e-08}}},
        {"eye 1e-15 r inside a surface", inside, on_all(-1e-15), {{0, 0, 0, 21.6, 2.17e-07}, {0, 0, 0, 702, 2.47e-07}}},
        {"eye 1e-9 r outside a surface", inside, on_all(1e-9), {{0, 0, 0, 10.5, 1.82e-08}, {0, 0, 0, 30.9, 2.15e-08}}},
        {"eye 1e-9 r inside a surface", inside, on_all(-1e-9), {{0, 0, 0, 21.1, 2.16e-07}, {0, 0, 0, 662, 2.48e-07}}},
        {"eye 1e-6 r outside a surface", inside, on_all(1e-6), {{0, 0, 0, 15.7, 6.17e-08}, {0, 0, 0, 34.4, 9.04e-08}}},
        {"eye 1e-6 r inside a surface", inside, on_all(-1e-6), {{0, 0, 0, 21.5, 2.63e-07}, {0, 0, 0, 239, 2.63e-07}}},
    };
}

}  // namespace gnomon::test
