// Lines that touch spheres exactly, and lines that nearly do.
//
// The eye looks along z with a field of view of 90 degrees at 8 x 8 pixels, so that rays go through the whole numbers
// (odd, odd, 8). For a whole vector p across such a ray whose length is whole, the sphere of radius |p| around any
// point of the ray, moved by p, is touched.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// A ray and a vector across it, whole numbers all.
struct Touch {
    Vec3 ray, across;
    int length;  // of `across`
};

/// The n-th shortest vector across (a, b, 8), none where there is no such vector: a^2 + b^2 + 64 must be the sum of two
/// squares (Witt's theorem), and is for half the rays.
std::optional<Touch> touch(int a, int b, int n) {
    for (int most = 1; most <= 64; ++most)
        for (int x = -most; x <= most; ++x)
            for (int y = -most; y <= most; ++y) {
                if (std::max(std::abs(x), std::abs(y)) != most || (a * x + b * y) % 8 != 0) continue;
                const int z = -(a * x + b * y) / 8, squared = x * x + y * y + z * z;
                const int length = static_cast<int>(std::lround(std::sqrt(squared)));
                if (length * length != squared || std::gcd(std::gcd(x, y), z) != 1 || n-- > 0) continue;
                return Touch{{1. * a, 1. * b, 8}, {1. * x, 1. * y, 1. * z}, length};
            }
    return {};
}

std::vector<Touch> touches(int n) {
    std::vector<Touch> all;
    for (int b = 7; b >= -7; b -= 2)
        for (int a = -7; a <= 7; a += 2)
            if (const auto one = touch(a, b, n)) all.push_back(*one);
    return all;
}

Scene eight_by_eight(std::vector<Sphere> spheres) {
    Scene scene = small_picture(std::move(spheres), two_suns(), 90);
    scene.image = {8, 8};
    return scene;
}

/// Beside the ray at `steps` times its vector; every other sphere is smaller, the rest larger by so much that the
/// discriminant is -+ change r^2.
Sphere beside(const Touch& touch, size_t i, double steps, double times, double change) {
    const double sign = i % 2 ? 1 : -1;
    return {touch.ray * steps + touch.across * times, touch.length * times * (1 + sign * change / 2)};
}

/// All in one scene, far enough not to hide each other.
Scene small_ones(int n, double steps, double change) {
    std::vector<Sphere> spheres;
    for (const Touch& touch : touches(n)) spheres.push_back(beside(touch, spheres.size(), steps, 1, change));
    return eight_by_eight(spheres);
}
std::vector<Scene> small_ones(double change) { return {small_ones(0, 1000, change), small_ones(1, 50000, change)}; }

/// Each in a scene of its own, for they would hide each other; some of them.
std::vector<Scene> large_ones(double change) {
    std::vector<Scene> scenes;
    const std::vector<Touch> all = touches(0);
    for (size_t i = 0; i < all.size(); i += 3) scenes.push_back(eight_by_eight({beside(all[i], i, 0.75, 16, change)}));
    return scenes;
}

}  // namespace

std::vector<HardCase> tangents() {
    const std::string exact = "the discriminant is exactly 0: a hit; the image is on a grid of whole numbers",
                      why = "the discriminant's sign hangs on a part of it so small";
    return {
        {"touched exactly, small spheres", exact, small_ones(0), {{46, 0, 0, 80.2, 0.0802}, {46, 0, 0, 80.2, 0.0802}}},
        {"touched exactly, large spheres",
         exact,
         large_ones(0),
         {{6, 0, 0, 1.12e+04, 6.64e-05}, {6, 0, 0, 1.12e+04, 6.64e-05}}},
        {"discriminant +-1e-5 r^2, small spheres",
         why,
         small_ones(1e-5),
         {{28, 0, 0, 32.1, 0.0657}, {28, 0, 0, 32.1, 0.0657}}},
        {"discriminant +-1e-7 r^2, small spheres",
         why,
         small_ones(1e-7),
         {{32, 0, 0, 47.5, 0.0686}, {32, 0, 0, 47.5, 0.0686}}},
        {"discriminant +-1e-9 r^2, small spheres",
         why,
         small_ones(1e-9),
         {{38, 0, 0, 49.6, 0.0689}, {42, 0, 0, 49.6, 0.0689}}},
        {"discriminant +-1e-12 r^2, small spheres",
         why,
         small_ones(1e-12),
         {{38, 0, 0, 49.8, 0.0689}, {42, 0, 0, 49.8, 0.0689}}},
        {"discriminant +-1e-15 r^2, small spheres",
         why,
         small_ones(1e-15),
         {{38, 0, 0, 49.8, 0.0689}, {42, 0, 0, 49.8, 0.0689}}},
        {"discriminant +-1e-5 r^2, large spheres",
         why,
         large_ones(1e-5),
         {{0, 0, 0, 81.3, 7.25e-07}, {0, 0, 0, 81.3, 7.25e-07}}},
        {"discriminant +-1e-9 r^2, large spheres",
         why,
         large_ones(1e-9),
         {{9, 0, 0, 5.79e+03, 4.63e-05}, {9, 0, 0, 5.79e+03, 4.63e-05}}},
        {"discriminant +-1e-15 r^2, large spheres",
         why,
         large_ones(1e-15),
         {{9, 0, 0, 1.11e+04, 6.64e-05}, {9, 0, 0, 1.11e+04, 6.64e-05}}},
    };
}

}  // namespace gnomon::test
