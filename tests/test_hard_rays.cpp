// intersect_closest's roots and decisions against the oracle, on the floats that the kernel is given: the eye is the
// origin, centres, radii and directions are floats.
#include <fmt/format.h>

#include <algorithm>

#include "intersect_harness.h"
#include "oracle.h"
#include "rounding.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

// Rays a sphere.
constexpr int bundle = 8 * BLOCK_RAYS;

Sphere of_floats(const Vec3& center, double radius) {
    return {{round_to_float(center.x), round_to_float(center.y), round_to_float(center.z)}, round_to_float(radius)};
}

/// Toward points of a disc around the sphere's centre that faces the eye, `size` times as large as the sphere.
std::vector<Float3> toward(Random& random, const Sphere& sphere, double size, int rays) {
    std::vector<Float3> dirs;
    for (int i = 0; i < rays; ++i) {
        const Vec3 across = normalize(cross(sphere.center, random.direction()));
        const Vec3 point = sphere.center + across * (sphere.radius * size * std::sqrt(random.uniform(0, 1)));
        dirs.push_back(to_float(normalize(point)));
    }
    return dirs;
}

Hits trace(Bench& bench, const Sphere& sphere, const std::vector<Float3>& dirs) {
    Scene scene;
    scene.spheres = {sphere};
    return closest(bench, widths[0], scene.camera, brute(seen_from_eye(bench, scene)), packed(dirs));
}

/// Whether the line meets the sphere ahead. In double unless the centre's distance from the line, of which the cross
/// product's roundings change no more than 8 2^-53 |f|, is so near to the radius that this may decide.
bool meets(const Sphere& sphere, const Vec3& dir) {
    const double across = length(cross(sphere.center, dir)) / length(dir);
    if (std::fabs(across - sphere.radius) > 0x1p-48 * length(sphere.center)) return across < sphere.radius;
    return oracle::position({{}, dir}, sphere).discriminant >= 0;
}

/// Errors of t in ulp: what they are at worst, and of which ray.
struct Worst {
    double ulps = 0;
    int rays = 0;
    std::string ray;

    void add(double t, const oracle::Hit& hit, const Sphere& s, const Vec3& dir) {
        ++rays;
        const double off = std::fabs(t - hit.t) / std::ldexp(1.0, std::ilogb(hit.t) - 23);
        if (off <= ulps) return;
        ulps = off;
        ray = fmt::format(
            "centre ({:a}, {:a}, {:a}), radius {:a}, dir ({:a}, {:a}, {:a}): {:.9g} for {:.17g}, condition {:.3g}",
            s.center.x, s.center.y, s.center.z, s.radius, dir.x, dir.y, dir.z, t, hit.t, hit.condition);
    }
};

/// Of the rays for which `counts`.
template <class Counts>
void measure(Bench& bench, const Sphere& sphere, const std::vector<Float3>& dirs, Worst& worst, Counts counts) {
    const Hits hits = trace(bench, sphere, dirs);
    for (size_t i = 0; i < dirs.size(); ++i) {
        const Vec3 dir = to_double(dirs[i]);
        const oracle::Hit hit = oracle::meet({{}, dir}, sphere);
        if (hit && hits.ids[i] == 0 && counts(hit)) worst.add(static_cast<double>(hits.ts[i]), hit, sphere, dir);
    }
}

/// Records of worst errors have three digits.
void hold(const char* what, const Worst& worst, double recorded) {
    INFO(what << worst.ulps << " ulp, recorded " << recorded << ", of " << worst.rays << " rays: " << worst.ray);
    CHECK(worst.ulps <= recorded * 1.005);
    if (worst.ulps < recorded * 0.995) WARN(what << "better than recorded, lower the record to " << worst.ulps);
}

struct Sides {
    double outside, inside;
};

void check_well_conditioned(Bench& bench, int spheres, const Sides& recorded) {
    Random random(41);
    Worst outside, inside;
    for (int i = 0; i < spheres; ++i) {
        const bool around = i % 2 != 0;
        const Vec3 center = random.direction() * random.scale(1e-3, 1e4);
        const double share = around ? random.scale(1.01, 1e3) : random.scale(1e-4, 0.99);
        const Sphere sphere = of_floats(center, length(center) * share);
        std::vector<Float3> dirs = toward(random, sphere, 1, bundle);
        if (around) std::generate(dirs.begin(), dirs.end(), [&] { return to_float(random.direction()); });
        measure(bench, sphere, dirs, around ? inside : outside,
                [](const oracle::Hit& hit) { return hit.condition < 10; });
    }
    CHECK(std::min(outside.rays, inside.rays) > spheres * bundle / 4);  // else the test says little
    hold("from outside: ", outside, recorded.outside);
    hold("from inside: ", inside, recorded.inside);
}

void check_far_sphere(Bench& bench, int spheres, int rays, int recorded) {
    Random random(42);
    int wrong = 0;
    for (int i = 0; i < spheres; ++i) {
        const Sphere sphere = of_floats(random.direction() * 1e4, 1);
        const std::vector<Float3> dirs = toward(random, sphere, 1.5, rays);
        const Hits hits = trace(bench, sphere, dirs);
        for (size_t ray = 0; ray < dirs.size(); ++ray)
            wrong += (hits.ids[ray] == 0) != meets(sphere, to_double(dirs[ray]));
    }
    INFO("of " << spheres * rays << " rays");
    CHECK(wrong <= recorded);
    if (wrong < recorded) WARN("better than recorded, lower the record to " << wrong);
}

/// Rays anywhere below the horizon, evenly in the logarithm of the angle from it.
void check_ground(Bench& bench, int rays, double recorded_near, double recorded_far) {
    Random random(43);
    const Sphere ground = of_floats({0, -1001.7, 0}, 1000);
    const double dip = std::acos(1000 / -ground.center.y), far = 50;
    std::vector<Float3> dirs;
    for (int i = 0; i < rays; ++i) {
        const double below = dip + random.scale(1e-4, 1.57 - dip), azimuth = random.uniform(-3.14, 3.14);
        const Vec3 ahead{std::cos(azimuth), 0, std::sin(azimuth)};
        dirs.push_back(to_float(ahead * std::cos(below) + Vec3{0, -std::sin(below), 0}));
    }
    Worst nearer, farther;
    measure(bench, ground, dirs, nearer, [far](const oracle::Hit& hit) { return hit.t < far; });
    measure(bench, ground, dirs, farther, [far](const oracle::Hit& hit) { return hit.t >= far; });
    CHECK(nearer.rays > rays / 2);
    hold("nearer than 50: ", nearer, recorded_near);
    hold("near the horizon: ", farther, recorded_far);
}

}  // namespace

// Wanted: 4 ulp. So it is, of two million rays; docs/accuracy.md says what a search for the worst comes to.
TEST_CASE("intersect_closest: t is within 4 ulp where it is well conditioned", "[hard]") {
    on_every_bench([](Bench& bench) { check_well_conditioned(bench, 64, {2.78, 2.35}); });
}
TEST_CASE("intersect_closest: t where it is well conditioned, many spheres", "[.long]") {
    on_every_bench([](Bench& bench) { check_well_conditioned(bench, 4096, {3.82, 3.07}); });
}

// Wanted: none wrong in a million, toward a disc of 1.5 radii. Of a hundred million none is.
TEST_CASE("intersect_closest: the unit sphere from ten thousand radii", "[hard]") {
    on_every_bench([](Bench& bench) { check_far_sphere(bench, 100, 10240, 0); });
}
TEST_CASE("intersect_closest: the unit sphere from ten thousand radii, a hundred million rays", "[.long]") {
    on_every_bench([](Bench& bench) { check_far_sphere(bench, 1000, 102400, 0); });
}

// Wanted: 8 ulp, to the horizon at 58.
TEST_CASE("intersect_closest: ground of radius 1000 from 1.7 above", "[hard]") {
    on_every_bench([](Bench& bench) { check_ground(bench, 4096, 3.77, 0.499); });
}
TEST_CASE("intersect_closest: ground of radius 1000 from 1.7 above, many rays", "[.long]") {
    on_every_bench([](Bench& bench) { check_ground(bench, 1 << 18, 4.54, 0.5); });
}
