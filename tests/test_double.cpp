// --accuracy double: kernels against arithmetic of 100 digits, pictures against the reference.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "intersect_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

using Real = boost::multiprecision::cpp_bin_float_100;

/// Half an ulp of 1 in double.
constexpr double u64 = 0x1p-53;

/// Runs `test` on each device that has double.
template <class Test>
void on_every_double_bench(Test test) {
    on_every_bench([&](Bench& bench) {
        if (bench.info.fp64) test(bench);
    });
}

struct Exact {
    Real t = 0;
    int id = -1;
    bool clear = true;  ///< nothing that could be first is grazed or as near, to double's rounding
};

/// The first hit of a ray from the origin. The line's parameter is that of the unit vector which d nearly is.
Exact exact_hit(const Scene& scene, const Real3Of<double>& d) {
    Exact hit;
    const Real dx = d.x, dy = d.y, dz = d.z, inverse = 1 / sqrt(dx * dx + dy * dy + dz * dz);
    for (size_t id = 0; id < scene.spheres.size(); ++id) {
        const Sphere& s = scene.spheres[id];
        const Real x = s.center.x, y = s.center.y, z = s.center.z, r = s.radius;
        const Real b = (x * dx + y * dy + z * dz) * inverse, C = x * x + y * y + z * z - r * r, D = b * b - C;
        const double e = doubt(s.center, s.radius, normalize({d.x, d.y, d.z}), u64).d_error;
        if (abs(D) <= 1e6 * e) hit.clear = false;  // how far t may then be off is another question
        if (D < 0) continue;
        const Real t = C > 0 ? b - sqrt(D) : b + sqrt(D);
        if (!(t > 0)) continue;
        if (hit.id >= 0 && abs(t - hit.t) <= 1e-9 * t) hit.clear = false;
        if (hit.id >= 0 && t >= hit.t) continue;
        hit.t = t;
        hit.id = static_cast<int>(id);
    }
    return hit;
}

/// A number that two floats hold, as kernels are given it: a multiple of 2^-30, below 2^12.
double held(double v) { return std::round(v * 0x1p30) * 0x1p-30; }
Sphere placed(const Vec3& center, double radius) {
    return {{held(center.x), held(center.y), held(center.z)}, held(radius)};
}

Scene random_scene(Random& random, int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const double r = random.scale(1e-3, 3);
        const bool is_around = i % 4 == 3;  // large, its surface near the eye
        scene.spheres.push_back(is_around ? placed(random.direction() * (300 * r + random.uniform(-2, 5)), 300 * r)
                                          : placed(random.direction() * random.scale(1, 1e3), r));
    }
    return scene;
}

/// A unit vector, rounded once.
Real3Of<double> unit(const Vec3& v) {
    const long double x = v.x, y = v.y, z = v.z, l = std::sqrt(x * x + y * y + z * z);
    return {static_cast<double>(x / l), static_cast<double>(y / l), static_cast<double>(z / l)};
}

std::vector<Real3Of<double>> random_rays(Random& random, const Scene& scene, int blocks) {
    std::vector<Real3Of<double>> dirs;
    for (int block = 0; block < blocks; ++block) {
        const Sphere& aim = scene.spheres[random.word() % scene.spheres.size()];
        const Vec3 axis = normalize(aim.center + random.direction() * aim.radius);
        const double spread = random.scale(1e-4, 10);
        for (int i = 0; i < BLOCK_RAYS; ++i) dirs.push_back(unit(axis + random.direction() * spread));
    }
    return dirs;
}

/// What is off, of `rays` that are clear.
struct Wrong {
    int64_t rays = 0, hits = 0, ids = 0, distances = 0, misses = 0;
    double worst = 0;  ///< relative error of t, in u
};

void compare(const HitsOf<double>& hits, const Scene& scene, const std::vector<Real3Of<double>>& dirs, Wrong& wrong) {
    for (size_t ray = 0; ray < dirs.size(); ++ray) {
        const Exact exact = exact_hit(scene, dirs[ray]);
        if (!exact.clear) continue;
        ++wrong.rays;
        wrong.ids += hits.ids[ray] != exact.id;
        if (exact.id < 0) wrong.misses += !is_miss(hits, ray);
        if (exact.id < 0 || hits.ids[ray] != exact.id) continue;
        ++wrong.hits;
        const Sphere& s = scene.spheres[static_cast<size_t>(exact.id)];
        const Vec3 d = normalize({dirs[ray].x, dirs[ray].y, dirs[ray].z});
        const auto off = static_cast<double>(abs(hits.ts[ray] - exact.t));
        wrong.distances += !(off <= doubt(s.center, s.radius, d, u64).t_error);
        // Looked at straight on, from well outside: see the test.
        if (dot(s.center, s.center) > 16 * s.radius * s.radius && length(cross(s.center, d)) < 0.5 * s.radius)
            wrong.worst = std::max(wrong.worst, off / static_cast<double>(exact.t) / u64);
    }
}

/// The condition number of t (tests/oracle.cpp): how many times its relative error may be that of the ray and sphere.
double condition(const Sphere& s, const Vec3& d, double t) {
    const Vec3 normal = (d * t - s.center) * (1 / s.radius);
    return (s.radius + length(s.center) + t * length(cross(normal, d))) / (t * std::fabs(dot(normal, d)));
}

/// Errors of t in ulp where it is well conditioned.
struct Worst {
    double ulps = 0;
    int64_t rays = 0;

    void add(double t, const Exact& exact) {
        ++rays;
        ulps = std::max(ulps, static_cast<double>(abs(t - exact.t)) / std::ldexp(1.0, std::ilogb(t) - 52));
    }
};

/// A sphere around the eye, or apart from it, and rays that meet it.
void add_well_conditioned(Bench& bench, Random& random, bool is_around, Worst& worst) {
    Scene scene;
    const double distance = random.scale(1, 1e3), share = is_around ? random.scale(1.01, 4) : random.scale(1e-3, 0.99);
    scene.spheres = {placed(random.direction() * distance, distance * share)};
    const Sphere& s = scene.spheres[0];
    std::vector<Real3Of<double>> dirs;
    for (int i = 0; i < 8 * BLOCK_RAYS; ++i) {
        const Vec3 aim = s.center + cross(random.direction(), normalize(s.center)) * s.radius;
        dirs.push_back(unit(is_around ? random.direction() : aim));
    }
    const HitsOf<double> hits =
        closest(bench, widths[0], scene.camera, brute(seen_from_eye<double>(bench, scene)), packed(dirs));
    for (size_t ray = 0; ray < dirs.size(); ++ray) {
        const Exact exact = exact_hit(scene, dirs[ray]);
        const Vec3 d{dirs[ray].x, dirs[ray].y, dirs[ray].z};
        if (exact.id == 0 && hits.ids[ray] == 0 && condition(s, d, static_cast<double>(exact.t)) < 10)
            worst.add(hits.ts[ray], exact);
    }
}

}  // namespace

TEST_CASE("double: intersect_closest against 100 digits", "[double][intersect_closest]") {
    on_every_double_bench([](Bench& bench) {
        Random random(21);
        Wrong wrong;
        int64_t rays = 0;
        for (const int count : {1, 17, 300}) {
            const Scene scene = random_scene(random, count);
            const std::vector<Real3Of<double>> dirs = random_rays(random, scene, 12);
            compare(closest(bench, scene, dirs), scene, dirs, wrong);
            rays += static_cast<int64_t>(dirs.size());
        }
        CHECK(wrong.rays > rays * 9 / 10);
        CHECK(wrong.hits > rays / 10);
        CHECK(wrong.ids == 0);
        CHECK(wrong.misses == 0);
        CHECK(wrong.distances == 0);
        // Half an ulp, which is u at most, and what is of the order of u^2.
        CHECK(wrong.worst > 0);
        CHECK(wrong.worst <= 1.02);
    });
}

TEST_CASE("double: t is within 1 ulp where it is well conditioned", "[double][intersect_closest]") {
    on_every_double_bench([](Bench& bench) {
        Random random(22);
        Worst outside, inside;
        for (int i = 0; i < 64; ++i) add_well_conditioned(bench, random, i % 2 != 0, i % 2 != 0 ? inside : outside);
        CHECK(std::min(outside.rays, inside.rays) > 32 * 8 * BLOCK_RAYS / 4);
        INFO("from outside " << outside.ulps << " ulp, from inside " << inside.ulps);
        CHECK(std::max(outside.ulps, inside.ulps) > 0);
        CHECK(std::max(outside.ulps, inside.ulps) <= 0.51);
    });
}

TEST_CASE("double: an eye next to a surface sees how near it is", "[double][intersect_closest]") {
    on_every_double_bench([](Bench& bench) {
        // What |f|^2 - r^2 in double would lose: it is 2^-19 beside 2^20, and t is 2^-30. A height is a float's rest.
        for (const double height : {0x1p-10, 0x1p-30})
            for (const double side : {1.0, -1.0}) {  // outside; inside, from where t is that to the far side
                Scene scene;
                scene.spheres = {{{0, 0, 1024 + side * height}, 1024}};
                const auto hits = closest(bench, scene, std::vector<Real3Of<double>>(BLOCK_RAYS, {0, 0, 1}));
                const double t = side > 0 ? height : 2048 - height;
                CHECK(std::fabs(hits.ts[0] - t) <= 4 * u64 * t);  // q exact: C, quotient, and b + root
            }
    });
}
