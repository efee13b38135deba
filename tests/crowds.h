// Thousands of spheres in arrangements that are hard on a hierarchy, around an eye in the origin that looks along z.
#pragma once

#include "kernel_harness.h"
#include "scene.h"

namespace gnomon::test {

enum class Crowd { strewn, teapot_in_a_stadium, shells, coincident, diagonal, sizes, ground };
constexpr Crowd crowds[] = {
    Crowd::strewn, Crowd::teapot_in_a_stadium, Crowd::shells, Crowd::coincident, Crowd::diagonal, Crowd::sizes,
    Crowd::ground};

inline const char* to_string(Crowd crowd) {
    const char* const names[] = {"strewn", "a teapot in a stadium", "shells", "coincident", "diagonal", "sizes",
                                 "ground"};
    return names[static_cast<int>(crowd)];
}

/// Sphere i of n.
inline Sphere member(Crowd crowd, int i, int n, Random& random) {
    const auto strewn = [&](const Vec3& center, double size, double radius) {
        const auto off = [&] { return random.uniform(-size, size); };
        return Sphere{center + Vec3{off(), off(), off()}, radius};
    };
    switch (crowd) {
        case Crowd::strewn:
            break;
        case Crowd::teapot_in_a_stadium:  // and a spout on the teapot
            if (i % 10 == 0) return strewn({0, 0, 2000}, 1000, random.uniform(1, 5));
            return i % 2 == 0 ? strewn({1, 0, 30}, 1, 0.05) : strewn({2, 0, 30}, 1e-3, 5e-5);
        case Crowd::shells:  // nested, each seen through nothing but its own surface, and some around the eye
            return {{0, 0, 50}, 60.0 * (i + 1) / n};
        case Crowd::coincident:
            return {{i % 3 * 1.0, 0, 20}, 8};
        case Crowd::diagonal:
            return {{-50 + 100.0 * i / n, -40 + 80.0 * i / n, 60 + 100.0 * i / n}, 15};
        case Crowd::sizes:  // over nine orders of magnitude
            return strewn({0, 0, 100}, 50, random.scale(1e-8, 10));
        case Crowd::ground:
            if (i == n / 2) return {{0, -1e4, 100}, 1e4 - 40};
            return strewn({0, -35, 100}, 30, 0.4);
    }
    return strewn({0, 0, 100}, 50, random.uniform(0.3, 1));
}

inline Scene scene_of(Crowd crowd, int n) {
    Random random(static_cast<uint64_t>(n));
    Scene scene;
    for (int i = 0; i < n; ++i) scene.spheres.push_back(member(crowd, i, n, random));
    return scene;
}

/// Blocks of neighbouring rays into the picture, and one of rays all around.
inline std::vector<Float3> looking_in(int blocks) {
    std::vector<Float3> dirs;
    Random random(7);
    for (int block = 0; block < blocks; ++block) {
        const Vec3 middle{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1};
        for (int i = 0; i < BLOCK_RAYS; ++i)
            dirs.push_back(
                to_float(block == 0 ? random.direction() : normalize(middle + Vec3{i % 8 * 2e-3, i / 8 * 2e-3, 0})));
    }
    return dirs;
}

}  // namespace gnomon::test
