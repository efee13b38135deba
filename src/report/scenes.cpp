#include "scenes.h"

#include "draws.h"
#include "embedded_scenes.h"
#include "scene_io.h"

namespace gnomon::report {

namespace {

Rgb grey(double value) { return {value, value, value}; }

Sphere small_sphere(Draws& draws) {
    Sphere s;
    s.center.x = draws.uniform(-8, 8);
    s.center.y = draws.uniform(0.3, 5);
    s.center.z = draws.uniform(-8, 8);
    s.radius = draws.uniform(0.2, 0.7);
    s.albedo.r = draws.uniform(0.2, 0.9);
    s.albedo.g = draws.uniform(0.2, 0.9);
    s.albedo.b = draws.uniform(0.2, 0.9);
    return s;
}

Scene ground_and_99() {
    Scene scene;
    scene.camera = {{0, 4, -20}, {0, 2, 0}, {0, 1, 0}, 40};
    scene.spheres = {{{0, -1000, 0}, 1000, grey(0.5)}};
    Draws draws(100);
    for (int i = 0; i < 99; ++i) scene.spheres.push_back(small_sphere(draws));
    scene.lights = {DirectionalLight{{1, 2, -1.5}, grey(1)}, DirectionalLight{{-2, 1.5, 0.5}, grey(0.6)},
                    PointLight{{0, 9, -6}, grey(1200)}};
    return scene;
}

}  // namespace

std::vector<NamedScene> default_scenes() {
    std::vector<NamedScene> scenes;
    for (const auto& [file, text] : embedded_scenes()) scenes.push_back({file, parse_scene(text, file).scene});
    scenes.push_back({"ground and 99 spheres", ground_and_99()});
    return scenes;
}

}  // namespace gnomon::report
