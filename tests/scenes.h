// What the tests of pictures share: every device, small scenes, and planes compared bit by bit.
#pragma once

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "catch.h"
#include "device.h"
#include "error.h"
#include "render.h"
#include "scene_io.h"

namespace gnomon::test {

/// Half an ulp of 1: what one rounding to float changes a value by, relative to it, at most.
constexpr double u = 1.0 / (1 << 24);

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline void check_vec(Vec3 found, Vec3 expected) {
    CHECK(found.x == expected.x);
    CHECK(found.y == expected.y);
    CHECK(found.z == expected.z);
}

/// The message of the Error with this exit code that the action must end in.
template <class Action>
std::string refusal(int exit_code, Action action) {
    try {
        action();
    } catch (const Error& error) {
        CHECK(error.exit_code() == exit_code);
        return error.what();
    }
    FAIL("accepted what is wrong");
    return "";
}

/// Runs `test` with a renderer on each OpenCL device.
template <class Test>
void on_every_device(Test test) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            Renderer renderer(device);
            test(renderer);
        }
}

inline RenderOptions all_outputs() {
    RenderOptions options;
    options.outputs = {true, true, true, true};
    return options;
}

inline Film render(Renderer& renderer, const Scene& scene, const RenderOptions& options = all_outputs()) {
    Film film;
    renderer.render(scene, options, film);
    return film;
}

inline size_t pixel(const Film& film, int i, int j) {
    return static_cast<size_t>(j) * static_cast<size_t>(film.width) + static_cast<size_t>(i);
}

/// Of an image with odd sides.
inline size_t centre(const Film& film) { return film.pixels() / 2; }

template <class T>
bool same_bits(const Plane<T>& a, const Plane<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool same_bits(const Film& a, const Film& b) {
    bool same =
        a.width == b.width && a.height == b.height && same_bits(a.distance, b.distance) && same_bits(a.id, b.id);
    for (int c = 0; c < 3; ++c) same = same && same_bits(a.radiance[c], b.radiance[c]);
    for (int c = 0; c < 3; ++c) same = same && same_bits(a.normal[c], b.normal[c]);
    return same;
}

/// Every radiance is exactly 0; a NaN is not.
inline bool black(const Film& film) {
    return std::all_of(std::begin(film.radiance), std::end(film.radiance), [](const Plane<float>& plane) {
        return std::all_of(plane.begin(), plane.end(), [](float v) { return v == 0; });
    });
}

/// The eye in the origin looks along z, y is up, and the image plane at distance 1 is 2 high.
inline Scene looking_ahead(int width, int height) {
    Scene scene;
    scene.image = {width, height};
    scene.camera.fov = 90;
    return scene;
}

inline Scene example(const std::string& name) {
    return load_scene(std::string(GNOMON_SOURCE_DIR) + "/examples/" + name).scene;
}

/// Spheres and lights of each kind, shadows of each kind, spheres that overlap and that coincide, all placed on halves.
inline Scene mixed(int width, int height) {
    Scene scene = example("directional.json");
    scene.image = {width, height};
    scene.spheres.push_back({{-18, -24, 138}, 8, {0.9, 0.8, 0.1}});
    scene.spheres.push_back({{-30, -22.5, 140}, 16.5, {0, 0, 1}});
    scene.spheres.push_back({{5, 20, 60}, 2.5, {0.3, 0.3, 1}});
    const Scene lamps = example("point.json");
    scene.lights.insert(scene.lights.begin() + 1, lamps.lights.begin(), lamps.lights.begin() + 2);
    return scene;
}

/// Spheres strewn before the eye, in sizes from a pixel to a fifth of the image; the first `count` of one sequence, so
/// that what fits 16 spheres is also tried with 15 and 17. No ray of theirs comes so close to a limb that float and
/// double might disagree about it; a sequence has about an even chance of that.
inline Scene scattered(int count, int width, int height) {
    Scene scene = looking_ahead(width, height);
    std::mt19937 random(7);  // gives the same numbers everywhere, which the library's distributions do not
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random()) / 4294967296.0);
    };
    for (int id = 0; id < count; ++id) {
        const double z = between(10, 60), x = z * between(-1.3, 1.3), y = z * between(-1, 1), size = between(0.1, 1);
        scene.spheres.push_back({{x, y, z}, 0.2 * z * size * size * size + 0.02 * z, {0.5, 0.7, between(0, 1)}});
    }
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 2, 3}}, PointLight{{-20, 20, 10}, {9e3, 9e3, 9e3}},
                    PointLight{{5, 0, 30}, {2e3, 4e3, 8e3}}, DirectionalLight{{-3, 1, -2}, {3, 2, 1}}};
    return scene;
}

inline bool ran(const RenderStats& stats, const std::string& kernel) {
    return std::any_of(stats.kernels.begin(), stats.kernels.end(),
                       [&](const KernelStats& k) { return k.kernel == kernel; });
}

inline bool built_with(const RenderStats& stats, const std::string& option) {
    return std::any_of(stats.kernels.begin(), stats.kernels.end(),
                       [&](const KernelStats& k) { return contains(k.options, option); });
}

}  // namespace gnomon::test
