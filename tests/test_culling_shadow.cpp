// Fat rays and the hierarchy change no bit: intersect_shadow finds what brute force finds. arrival() compares them.
#include "bundles.h"
#include "shadow_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Hits in bundles about a point, whose shadow rays meet a light: with the light at the origin and t = 1, dir is a
/// position. Each has a sphere that only its outermost way touches: from the side or, with `end`, at the receiver.
struct Grazed {
    Scene scene;
    Receivers hits;
};

Grazed graze_lamp(Random& random, size_t group, bool end) {
    Grazed g;
    for (size_t i = 0; i < 20 * BLOCK_RAYS / group; ++i) {
        const std::vector<Float3> rays = bundle(random, group, random.scale(1e-5, 2e-3));
        const double far = random.scale(1, 1e4), ratio = random.scale(1e-6, 2e-3),
                     distance = far * random.uniform(0.1, 0.9);
        for (size_t k = 0; k < group; ++k) {
            const Vec3 d = to_double(rays[k]);
            g.hits.add(to_float(d * (k == 0 ? far : far * random.uniform(0.5, 0.99))), 1, to_float(d * -1), 1 << 30);
        }
        const double gap = random.uniform(-2, 2) * u, r = distance * ratio;
        if (end)  // straight ahead
            g.scene.spheres.push_back({to_double(rays[0]) * (far * (1 + gap) + r), r});
        else
            g.scene.spheres.push_back(touching(rays, distance, r, random.uniform(-3, 3)));
    }
    return g;
}

Grazed graze_sun(Random& random, size_t group, bool end, const DirectionalLight& sun) {
    const ParallelPencil pencil = parallel_pencil(sun);
    const Vec3 sides[] = {to_double(pencil.u), to_double(pencil.v)}, l = to_double(pencil.axis);
    Grazed g;
    for (size_t i = 0; i < 20 * BLOCK_RAYS / group; ++i) {
        const Vec3 middle = random.direction() * random.scale(1, 1e3);
        const double size = random.scale(1e-3, 1e-1), r = random.scale(1e-3, 1e-1), sign = random.word() & 1 ? 1 : -1;
        const Vec3 out = end ? l * -1 : sides[random.word() & 1] * sign;
        for (size_t k = 0; k < group; ++k) {
            const Vec3 d = random.direction() * size, inward = d - out * (std::max(0.0, dot(d, out)) * 2);
            g.hits.add(to_float(middle + (k == 0 ? out * size * 1.5 : inward)), 1, to_float(l), 1 << 30);
        }
        const Vec3 first = g.hits.hit(i * group).position;
        const double gap = random.uniform(-2, 2) * u * length(first);
        g.scene.spheres.push_back({first + out * (r + gap) + (end ? Vec3{} : l * random.uniform(0.1, 10)), r});
    }
    return g;
}

/// One bundle and one sphere, larger than either is far from the eye: the receiver's power decides.
Grazed graze_large(Random& random, const DirectionalLight& sun) {
    const ParallelPencil pencil = parallel_pencil(sun);
    const Vec3 sides[] = {to_double(pencil.u), to_double(pencil.v)}, l = to_double(pencil.axis);
    const double away = random.scale(1, 1e3), r = away * random.uniform(1.1, 3);
    const Vec3 out = sides[random.word() & 1] * (random.word() & 1 ? 1 : -1), middle = random.direction() * away;
    Grazed g;
    for (int k = 0; k < BLOCK_RAYS; ++k) {
        const Vec3 d = random.direction() * (away * 1e-3);
        g.hits.add(to_float(middle + d - out * (k == 0 ? 0 : dot(d, out) + away * 2e-3)), 1, to_float(l), 1 << 30);
    }
    const double gap = random.uniform(-3, 3) * u * r;
    g.scene.spheres = {{g.hits.hit(0).position + out * (r + gap) + l * (r * random.uniform(0.01, 0.2)), r}};
    return g;
}

void check_grazed(Bench& bench, const Grazed& g, size_t group, const Light& light) {
    const std::vector<float> arrived = arrival(bench, g.scene, g.hits, light);
    const size_t groups = g.hits.size() / group;
    size_t dark = 0, others = 0;
    for (size_t i = 0; i < groups; ++i) dark += arrived[i * group] == 0;
    for (const float a : arrived) others += a == 0;
    INFO(dark << " of " << groups << " in shadow");
    CHECK(dark > groups / 10);  // else the spheres are not where they should be
    CHECK(dark < groups * 9 / 10);
    CHECK(others - dark < arrived.size() / 10);
}

}  // namespace

TEST_CASE("culling: shadow rays that barely touch spheres", "[culling]") {
    on_every_bench([](Bench& bench) {
        Random random(52);
        for (const size_t group : bundle_sizes)
            for (const bool end : {false, true})
                for (int i = 0; i < 4; ++i) {
                    INFO(group << " rays" << (end ? ", at the receiver" : ""));
                    check_grazed(bench, graze_lamp(random, group, end), group, PointLight{{0, 0, 0}, {1, 1, 1}});
                    const DirectionalLight sun{random.direction(), {1, 1, 1}};
                    check_grazed(bench, graze_sun(random, group, end, sun), group, sun);
                }
    });
}

TEST_CASE("culling: shadow rays that barely touch large spheres", "[culling]") {
    on_every_bench([](Bench& bench) {
        Random random(53);
        int dark = 0;
        for (int i = 0; i < 200; ++i) {
            const DirectionalLight sun{random.direction(), {1, 1, 1}};
            const Grazed g = graze_large(random, sun);
            dark += arrival(bench, g.scene, g.hits, sun)[0] == 0;
        }
        CHECK(dark > 20);
        CHECK(dark < 180);
    });
}
