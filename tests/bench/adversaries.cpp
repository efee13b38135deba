// Scenes that hierarchies, floats and tiles do not like.
#include <cmath>

#include "crowd.h"
#include "scenes.h"

namespace bench {

using namespace gnomon;

namespace {

/// The cube's camera and lights, for spheres that `fill` adds.
template <class Fill>
Scene crowded(int64_t count, Fill fill, Scene scene = empty_cube()) {
    Crowd crowd(count);
    Random random(static_cast<uint64_t>(count));
    fill(crowd, random);
    crowd.move_to(scene);
    return scene;
}

Scene in_one_pixel(int64_t count) {
    Scene scene = empty_cube();
    scene.camera = {{0, 0, -1000}, {0, 0, 0}, {0, 1, 0}, 40};
    // At this distance a pixel is 2 * 1000 * tan(20 deg) / 1080 = 0.674 wide; the one right of and below the middle:
    const Cloud cloud{{0.337, -0.337, 0}, 0.4};
    return crowded(
        count, [&](Crowd& crowd, Random& random) { add_cloud(crowd, cloud, count, random); }, scene);
}

/// A teapot in a stadium in a desert: each cloud a hundredth as wide as the one around it, and ten times as populous.
Scene stadium(int64_t count) {
    const int64_t outer = count / 100, middle = count / 10;
    return crowded(count, [&](Crowd& crowd, Random& random) {
        add_cloud(crowd, {{}, 1e4, 0.001}, outer, random);
        add_cloud(crowd, {{}, 100, 0.001}, middle, random);
        add_cloud(crowd, {{}, 1}, count - outer - middle, random);
    });
}

Scene inside_one(int64_t count) {
    Scene scene = cube(count);
    scene.spheres.insert(scene.spheres.begin(), Sphere{{0, 0, 0}, 500, {0.8, 0.8, 0.8}});
    scene.lights = {point({0, 100, -120}, 400000), point({150, 80, -40}, 200000)};
    return scene;
}

Scene on_ground(int64_t count) {
    Scene scene = cube(count);
    scene.spheres.insert(scene.spheres.begin(), Sphere{{0, -1050, 0}, 1000, {0.5, 0.5, 0.5}});
    return scene;
}

/// Radii are the largest times 10^-9 to 10^0, evenly; of these powers' cubes the mean is 1 / (27 ln 10).
Scene many_radii(int64_t count) {
    const double volume = 0.05 * 1e6, pi = std::acos(-1.0);
    const double most = std::cbrt(volume * 27 * std::log(10.0) / (static_cast<double>(count) * 4 / 3 * pi));
    return crowded(count, [&](Crowd& crowd, Random& random) {
        while (crowd.count() < count) {
            Sphere sphere = random.sphere({-50, -50, -50}, {50, 50, 50}, -9, 0);
            sphere.radius = most * std::pow(10.0, sphere.radius);
            crowd.add(sphere);
        }
    });
}

Scene coincident(int64_t count) {
    return crowded(count, [&](Crowd& crowd, Random&) {
        while (crowd.count() < count) crowd.add({{0, 0, 0}, 30, {0.5, 0.6, 0.7}});
    });
}

Scene diagonal(int64_t count) {
    return crowded(count, [&](Crowd& crowd, Random& random) {
        while (crowd.count() < count) {
            const double x = -50 + 100 * static_cast<double>(crowd.count()) / static_cast<double>(count);
            crowd.add(random.sphere({x, x, x}, {x, x, x}, 0.5, 0.5));
        }
    });
}

/// A cloud with room for what is at `position`.
Scene around(const Vec3& position, int64_t count, const Scene& scene) {
    Cloud cloud;
    cloud.hole = position;
    return crowded(
        count, [&](Crowd& crowd, Random& random) { add_cloud(crowd, cloud, count, random); }, scene);
}

Scene light_inside(int64_t count) {
    const Vec3 position{25, 25, -40};  // where some of its light finds the way to the side that the camera sees
    Scene scene = empty_cube();
    scene.lights.back() = point(position, 20000);
    return around(position, count, scene);
}

/// With a headlamp, since little light comes in from outside.
Scene camera_inside(int64_t count) {
    Scene scene = empty_cube();
    scene.camera.eye = {0, 0, 0};
    scene.camera.at = {1, 1, 2};
    scene.lights.back() = point({0, mean_radius({}, count) / 2, 0}, 2000);
    return around(scene.camera.eye, count, scene);
}

/// Directions spread evenly over the sphere: heights evenly, turned by the golden angle each.
Vec3 spread(int i, int n) {
    const double y = 1 - (2.0 * i + 1) / n, r = std::sqrt(1 - y * y), turn = 2.399963229728653 * i;
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

Scene many_lights(int64_t count) {
    Scene scene = cube(count);
    scene.lights.clear();
    for (int i = 0; i < 32; ++i) scene.lights.push_back(directional(spread(i, 32), 0.1));
    for (int i = 0; i < 32; ++i) scene.lights.push_back(point(spread(i, 32) * 150, 20000));
    return scene;
}

}  // namespace

std::vector<NamedScene> adversaries(int64_t count) {
    const auto of = [count](Scene (*make)(int64_t)) { return [make, count] { return make(count); }; };
    return {{"benign", "a cube of small spheres", [count] { return cube(count); }},
            {"pixel", "all spheres in one pixel", of(in_one_pixel)},
            {"stadium", "a dense cluster in a sparse one in a sparser one", of(stadium)},
            {"inside", "camera, lights and all spheres inside one sphere", of(inside_one)},
            {"ground", "a ground under all others", of(on_ground)},
            {"radii", "radii over nine orders of magnitude", of(many_radii)},
            {"coincident", "one sphere, many times", of(coincident)},
            {"diagonal", "a diagonal line of overlapping spheres", of(diagonal)},
            {"light-inside", "a point light inside the cloud", of(light_inside)},
            {"camera-inside", "the camera inside the cloud", of(camera_inside)},
            {"64-lights", "32 directional and 32 point lights", of(many_lights)}};
}

}  // namespace bench
