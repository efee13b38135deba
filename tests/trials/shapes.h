// What scenes of trials are made of.
#pragma once

#include <cmath>

#include "../hard/scene_parts.h"
#include "kernel_harness.h"

namespace gnomon::test {

inline int whole(Random& random, int low, int high) {
    return low + static_cast<int>(random.word() % static_cast<uint64_t>(high - low + 1));
}
inline bool chance(Random& random, double share) { return random.uniform(0, 1) < share; }
inline Vec3 in_cube(Random& random, double half) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    return {x, y, random.uniform(-half, half)};
}
/// 10^-low to 10^-high; now and then 0.
inline double little(Random& random, double low, double high) {
    return chance(random, 0.04) ? 0 : std::pow(10, -random.uniform(low, high));
}
inline double sign(Random& random) { return chance(random, 0.5) ? 1 : -1; }

/// A unit vector across another.
inline Vec3 across(Random& random, const Vec3& v) {
    Vec3 other = cross(random.direction(), v);
    while (length(other) < 0.1 * length(v)) other = cross(random.direction(), v);
    return normalize(other);
}
/// A unit vector less than 90 degrees from n.
inline Vec3 facing(Random& random, const Vec3& n) {
    const Vec3 v = random.direction();
    return dot(v, n) < 0 ? v * -1 : v;
}

/// Light k in channel k alone. What a lamp sends is enough for scenes of `size` around it.
inline Rgb channel(size_t k, double value) { return {k == 0 ? value : 0, k == 1 ? value : 0, k == 2 ? value : 0}; }
inline void add_sun(Scene& scene, const Vec3& to_light) {
    scene.lights.push_back(DirectionalLight{to_light, channel(scene.lights.size(), 1)});
}
inline void add_lamp(Scene& scene, const Vec3& position, double size) {
    scene.lights.push_back(PointLight{position, channel(scene.lights.size(), 1e3 * size * size)});
}

/// An empty scene. Many small pictures are harder than a few large ones: what rounds once a scene rounds in other ways.
inline Scene picture(Random& random) {
    Scene scene;
    const auto side = [&] { return static_cast<int>(random.scale(12, 96)); };
    scene.image.width = side();
    scene.image.height = side();
    return scene;
}
/// How much of a radius a picture shows: down to where float, and then double, cannot tell any more.
inline double zoom(Random& random) { return std::pow(10, -random.uniform(0.5, chance(random, 0.15) ? 15 : 9)); }
/// From an eye to a target of which the picture shows so much to either side.
inline void aim(Scene& scene, Random& random, const Vec3& eye, const Vec3& target, double half_height) {
    scene.camera = look_at(eye, target, 2 * degrees_per_radian * std::atan(half_height / length(target - eye)));
    scene.camera.up = across(random, target - eye);
}

}  // namespace gnomon::test
