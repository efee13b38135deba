#include "scenes.h"

#include "crowd.h"

namespace bench {

using namespace gnomon;

Light directional(Vec3 direction, double irradiance) {
    return DirectionalLight{direction, {irradiance, irradiance, irradiance}};
}
Light point(Vec3 position, double power) { return PointLight{position, {power, power, power}}; }

Scene empty_cube() {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{50, 45, -115}, {0, 0, 0}, {0, 1, 0}, 40};
    scene.lights = {directional({1, 2, -1.5}, 1.5), point({0, 100, -120}, 400000)};
    return scene;
}

Scene cube(int64_t count, int columns) {
    Scene scene = empty_cube();
    Crowd crowd(count, columns);
    Random random(static_cast<uint64_t>(count));
    add_cloud(crowd, {}, count, random);
    crowd.move_to(scene);
    return scene;
}

namespace {

const Sphere ground{{0, -1000, 0}, 1000, {0.5, 0.5, 0.5}};

Scene four() {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{0, 2.5, -9}, {0, 1, 0}, {0, 1, 0}, 40};
    scene.spheres = {ground,
                     {{-2.2, 1, 0.5}, 1, {0.9, 0.2, 0.2}},
                     {{0, 1.2, 0}, 1.2, {0.2, 0.9, 0.2}},
                     {{2, 0.8, -1}, 0.8, {0.2, 0.3, 0.9}}};
    scene.lights = {directional({1, 2, -1.5}, 1.5), point({-4, 5, -4}, 500)};
    return scene;
}

Scene hundred() {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{0, 4, -20}, {0, 2, 0}, {0, 1, 0}, 40};
    Crowd crowd(100);
    crowd.add(ground);
    Random random(100);
    while (crowd.count() < 100) crowd.add(random.sphere({-8, 0.3, -8}, {8, 5, 8}, 0.2, 0.7));
    crowd.move_to(scene);
    scene.lights = {directional({1, 2, -1.5}, 1), directional({-2, 1.5, 0.5}, 0.6), point({0, 9, -6}, 1200)};
    return scene;
}

}  // namespace

std::vector<NamedScene> scenes() {
    return {{"S4", "a ground and three spheres", four, true},
            {"S100", "a ground and 99 small spheres", hundred, true},
            {"S1e4", "a cube of 10^4 small spheres", [] { return cube(10'000); }, true},
            {"S1e6", "a cube of 10^6 small spheres", [] { return cube(1'000'000); }, true},
            {"S1e7", "a cube of 10^7 small spheres", [] { return cube(10'000'000); }},
            // Rows of 4 numbers, since memory is scarce.
            {"S1e8", "a cube of 10^8 small spheres, all grey", [] { return cube(100'000'000, 4); }}};
}

}  // namespace bench
