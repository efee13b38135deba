// Eyes on, just inside and just outside a surface.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// The eye on a sphere whose centre is 3 : 4 up and ahead, or off its surface by a share of the radius (inward < 0).
Scene on_sphere(double radius, double off) {
    const double fifth = radius / 5;  // whole
    Scene scene = small_picture({{{0, 3 * fifth, 4 * fifth}, radius}}, two_suns(), 120);
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
        {"eye on a surface", "t = 0 is no hit, and |eye - centre|^2 - r^2 is exactly 0", on_all(0), {}},
        {"eye 1e-15 r outside a surface", inside, on_all(1e-15), {}},
        {"eye 1e-15 r inside a surface", inside, on_all(-1e-15), {}},
        {"eye 1e-9 r outside a surface", inside, on_all(1e-9), {}},
        {"eye 1e-9 r inside a surface", inside, on_all(-1e-9), {}},
        {"eye 1e-6 r outside a surface", inside, on_all(1e-6), {}},
        {"eye 1e-6 r inside a surface", inside, on_all(-1e-6), {}},
    };
}

}  // namespace gnomon::test
