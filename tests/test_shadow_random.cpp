// intersect_shadow alone, against the reference in double: random scenes, and those where float finds it hard.
#include "shadow_bounds.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Vec3 as_float(const Vec3& v) { return to_double(to_float(v)); }

/// Blocks of neighbouring receivers, and some of receivers anywhere.
Receivers look_around(Random& random, const Scene& scene, int blocks) {
    Receivers hits;
    for (int block = 0; block < blocks; ++block) {
        const Vec3 axis = normalize(scene.spheres[random.word() % scene.spheres.size()].center);
        const double spread = block % 4 ? random.scale(1e-3, 0.3) : 10;
        for (int i = 0; i < BLOCK_RAYS; ++i) hits.see(scene, to_float(normalize(axis + random.direction() * spread)));
    }
    return hits;
}

/// Spheres all around the eye, from a thousandth to a third of their distance large, and three large ones whose surface
/// is near the eye, `around` it or beside.
Scene random_scene(Random& random, int count, bool large, bool around) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const Vec3 center = as_float(random.direction() * random.scale(1, 100));
        scene.spheres.push_back({center, length(center) * random.scale(1e-3, 0.3)});
    }
    for (int i = 0; large && i < 3; ++i) {
        const Vec3 center = as_float(random.direction() * random.scale(10, 1000));
        scene.spheres.push_back(
            {center, length(center) * (around ? random.uniform(1.1, 2) : random.uniform(0.75, 0.999))});
    }
    return scene;
}

Light random_light(Random& random, bool point) {
    if (!point) return DirectionalLight{random.direction(), {1, 1, 1}};
    return PointLight{as_float(random.direction() * random.scale(1, 200)), {1, 1, 1}};
}

void check_random(Bench& bench, bool point, bool large, uint64_t seed) {
    Random random(seed);
    ShadowCount count;
    for (const int spheres : {1, 5, 13, 16, 17, 100, 400})
        for (int light_number = 0; light_number < 3; ++light_number) {
            const Scene scene = random_scene(random, spheres, large, point);
            const Receivers hits = look_around(random, scene, 24).padded();
            const Light light = random_light(random, point);
            compare(scene, hits, arrival(bench, scene, hits, light), light, count);
        }
    CHECK(count.wrong == 0);
    CHECK(count.lit > 500);  // else the test says little
    CHECK(count.shadowed > 500);
    CHECK(count.away > 500);
    CHECK(count.flips * 1000 < count.lit + count.shadowed);
}

}  // namespace

TEST_CASE("intersect_shadow: random scenes in the sun", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) { check_random(bench, false, false, 21); });
}
TEST_CASE("intersect_shadow: random scenes in the sun, and large spheres beside the eye", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) { check_random(bench, false, true, 22); });
}
TEST_CASE("intersect_shadow: random scenes by lamplight", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) { check_random(bench, true, false, 23); });
}
TEST_CASE("intersect_shadow: random scenes by lamplight, and large spheres around all", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) { check_random(bench, true, true, 24); });
}

TEST_CASE("intersect_shadow: the ground casts no shadow on what lies on it", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        Random random(25);
        for (const double radius : {1e3, 1e4, 1e5, 1e6}) {
            INFO("ground of radius " << radius);
            // The eye 5 above the ground; balls of radius 1 that rest on it, apart from each other.
            Scene scene;
            scene.spheres = {{{0, -5 - radius, 0}, radius}};
            for (int i = 0; i < 9; ++i) {
                const double x = 4.0 * (i % 3 - 1), z = 10 + 4.0 * (i / 3);
                const double y = std::sqrt((radius + 1) * (radius + 1) - x * x - z * z) - 5 - radius;
                scene.spheres.push_back({as_float({x, y, z}), 1});
            }
            Receivers hits;
            for (int i = 0; i < 4096; ++i)
                hits.see(scene, to_float(normalize({random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.1), 1})));
            const Light lights[] = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, DirectionalLight{{-3, 1, -2}, {1, 1, 1}},
                                    PointLight{{-5, 8, 3}, {1, 1, 1}}};
            for (const Light& light : lights) {
                ShadowCount count;
                compare(scene, hits, arrival(bench, scene, hits, light), light, count);
                CHECK(count.wrong == 0);
                CHECK(count.lit > 1000);
                CHECK(count.shadowed > 100);
                CHECK(count.away > 50);
                CHECK(count.flips <= 1);
            }
        }
    });
}

TEST_CASE("intersect_shadow: on large ground light goes as far as the horizon", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        // The eye 5 above ground of radius 1e6; receivers face the light. The sun dips below the horizon of height 5,
        // so that it lights what is higher than that; a lamp 1 above the ground has its horizon 1414 away and, 3000
        // away, lights what is higher than (3000 - 1414)^2 / 2e6 = 1.26.
        Random random(26);
        Scene scene;
        scene.spheres = {{{0, -1000005, 0}, 1e6}};
        const Light lights[] = {DirectionalLight{{1, -std::sqrt(1e-5), 0}, {1, 1, 1}},
                                PointLight{{3000, -4 - 4.5, 0}, {1, 1, 1}}};
        for (const Light& light : lights) {
            const bool sun = std::holds_alternative<DirectionalLight>(light);
            Receivers hits;
            for (int i = 0; i < 4096; ++i) {
                const double height = random.uniform(0, sun ? 10 : 2.5);
                hits.add(to_float({random.uniform(-0.1, 0.1), height - 5, random.uniform(-0.1, 0.1)}), 1, {1, 0, 0}, 1);
            }
            scene.spheres.resize(1);
            scene.spheres.push_back({{-2, 0, 0}, 1});  // whose hits they are
            ShadowCount count;
            compare(scene, hits, arrival(bench, scene, hits, light), light, count);
            CHECK(count.wrong == 0);
            CHECK(count.lit > 1500);
            CHECK(count.shadowed > 1500);
            CHECK(count.flips <= 8);
        }
    });
}

TEST_CASE("intersect_shadow: a far sphere shadows receivers around the eye", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        Random random(27);
        for (const double distance : {1e2, 1e3, 1e4}) {
            INFO("distance " << distance);
            const DirectionalLight sun{random.direction(), {1, 1, 1}};
            const Vec3 l = normalize(sun.direction_to_light), side = normalize(cross(l, {0, 0, 1}));
            Scene scene;
            scene.spheres = {{as_float(l * distance + side), 1}, {as_float(l * -9), 1}};  // its edge through the eye
            Receivers hits;
            for (int i = 0; i < 4096; ++i)
                hits.add(to_float(random.direction() * random.uniform(0, 0.7)), 1, to_float(l), 1);
            ShadowCount count;
            compare(scene, hits, arrival(bench, scene, hits, sun), sun, count);
            CHECK(count.wrong == 0);
            CHECK(count.lit > 1000);
            CHECK(count.shadowed > 1000);
            // The edge is in doubt by 5 u times the distance at most, of receivers 1.4 wide.
            CHECK(static_cast<double>(count.flips) <= 2 + 4096 * 2 * 5 * u * distance);
        }
    });
}

TEST_CASE("intersect_shadow: far receivers of a sphere beside the eye", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        const Light sun = DirectionalLight{{0, 0, -1}, {1, 1, 1}};
        int64_t flips = 0, shadowed = 0;
        for (const double radius : {1e2, 1e3, 1e4, 1e5}) {
            INFO("receiver of radius " << radius);
            Scene scene;
            scene.spheres = {{as_float({-1.2, 0, -0.01}), 1}, {{0, 0, 2 * radius}, radius}};
            Receivers hits;
            for (int i = 0; i < 64; ++i)
                for (int k = 0; k < 64; ++k) {
                    const Vec3 at{-1.2 + (i - 31.5) / 24, (k - 31.5) / 24, radius};
                    hits.see(scene, to_float(normalize(at)));
                }
            ShadowCount count;
            compare(scene, hits, arrival(bench, scene, hits, sun), sun, count);
            CHECK(count.wrong == 0);
            flips += count.flips;
            shadowed += count.shadowed;
            // pi 24^2 = 1810 pixels are in the disc, but for those on its edge of length 2 pi 24.
            CHECK(std::fabs(static_cast<double>(count.shadowed) - 1810) < 151);
        }
        // At 1e5 away u |p| is 1/4 of a pixel's 1/24: of 151 pixels on the edge up to about half.
        CHECK(flips < 80);
        CHECK(shadowed > 6000);
    });
}
