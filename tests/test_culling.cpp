// Fat rays and the hierarchy change no bit: intersect_closest finds what brute force finds. closest() compares them.
#include "bundles.h"
#include "intersect_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Ranges, of uniform logarithm: of a bundle's half angle, and of radius over distance.
struct Angles {
    double spread[2], ratio[2];
};
// Between narrow bundles and small spheres, |f x a| <= r + |f| h is an equation but for angles cubed: below 2^-24 up to
// some 1e-3. The wide ones are for axes that nearly vanish and spheres around the apex.
const Angles narrow{{1e-5, 2e-3}, {1e-6, 2e-3}}, wide{{1e-2, 10}, {1e-2, 2}};

/// How many of the spheres were hit by the ray that touches them.
struct Touched {
    int64_t spheres = 0, hit = 0;
};

void touch(Bench& bench, size_t group, const Angles& angles, uint64_t seed, Touched& touched) {
    Random random(seed);
    Scene scene;
    std::vector<Float3> dirs;
    for (size_t i = 0; i < 40 * BLOCK_RAYS / group; ++i) {
        const std::vector<Float3> rays = bundle(random, group, random.scale(angles.spread[0], angles.spread[1]));
        const double distance = random.scale(1e-2, 1e6), ratio = random.scale(angles.ratio[0], angles.ratio[1]);
        scene.spheres.push_back(touching(rays, distance, distance * ratio, random.uniform(-3, 3)));
        dirs.insert(dirs.end(), rays.begin(), rays.end());
    }
    const Hits hits = closest(bench, scene, dirs);
    for (size_t i = 0; i < scene.spheres.size(); ++i) touched.hit += hits.ids[i * group] == static_cast<int>(i);
    touched.spheres += static_cast<int64_t>(scene.spheres.size());
}

}  // namespace

TEST_CASE("culling: eye rays that barely touch spheres", "[culling]") {
    on_every_bench([](Bench& bench) {
        Touched touched;
        for (const size_t group : bundle_sizes)
            for (uint64_t seed = 0; seed < 8; ++seed) {
                INFO(group << " rays, seed " << seed);
                touch(bench, group, narrow, seed, touched);
            }
        CHECK(touched.hit > touched.spheres / 5);
        CHECK(touched.hit < touched.spheres * 4 / 5);
        for (const size_t group : bundle_sizes)
            for (uint64_t seed = 0; seed < 8; ++seed) {
                INFO(group << " rays, seed " << seed << ", wide");
                touch(bench, group, wide, seed, touched);
            }
    });
}

TEST_CASE("culling: rays all around lose no hit", "[culling]") {
    on_every_bench([](Bench& bench) {
        Random random(51);
        for (const double rest : {0.0, 3e-23, 1e-19, 1e-9}) {
            Scene scene;
            std::vector<Float3> dirs;
            for (int i = 0; i < 4 * BLOCK_RAYS; i += 2) {
                const Float3 d = i % 8 ? to_float(random.direction()) : Float3{0, 1, static_cast<float>(rest)};
                dirs.push_back(d);
                dirs.push_back(i % 8 ? Float3{-d.x, -d.y, -d.z} : Float3{0, -1, 0});
                for (const int sign : {-1, 1})
                    scene.spheres.push_back({to_double(d) * (sign * random.scale(1, 1e3)), 0.5});
            }
            const Hits hits = closest(bench, scene, dirs);
            CHECK(std::count(hits.ids.begin(), hits.ids.end(), -1) == 0);
        }
    });
}
