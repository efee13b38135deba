// intersect_closest alone, on numbers that are exact in float: what the answer is to the bit.
#include "intersect_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene scene_of(std::vector<Sphere> spheres, const Vec3& eye = {}) {
    Scene scene;
    scene.camera.eye = eye;
    scene.spheres = std::move(spheres);
    return scene;
}

struct Expected {
    float t;
    Float3 normal;
    int id;
};
const Expected miss{INFINITY, {INFINITY, INFINITY, INFINITY}, -1};

/// The same ray in each place of a block but one, with NaN there: 0, the last and some between.
void check_exactly(Bench& bench, const Scene& scene, Float3 dir, const Expected& expected) {
    INFO("dir " << dir.x << ' ' << dir.y << ' ' << dir.z << ", eye " << scene.camera.eye.x << ' ' << scene.camera.eye.y
                << ' ' << scene.camera.eye.z);
    for (const size_t nan : {0, 17, 63}) {
        std::vector<Float3> dirs(BLOCK_RAYS, dir);
        dirs[nan] = {NAN, NAN, NAN};
        const Hits hits = closest(bench, scene, dirs);
        int wrong = 0;
        for (size_t ray = 0; ray < dirs.size(); ++ray) {
            const Expected& e = ray == nan ? miss : expected;
            const Float3 n = unpacked(hits.normals, ray);
            wrong += !(hits.ts[ray] == e.t && hits.ids[ray] == e.id && n.x == e.normal.x && n.y == e.normal.y &&
                       n.z == e.normal.z);
        }
        CHECK(wrong == 0);
    }
}

}  // namespace

TEST_CASE("intersect_closest: rays past, along and through the unit sphere", "[intersect_closest]") {
    on_every_bench([](Bench& bench) {
        const struct {
            Vec3 eye;
            Expected expected;
        } rays[] = {{{0, 2, -2}, miss},
                    {{0, 1, -2}, {2, {0, 1, 0}, 0}},
                    {{0, 0, -2}, {1, {0, 0, -1}, 0}},
                    {{0, -1, -2}, {2, {0, -1, 0}, 0}},
                    {{0, -2, -2}, miss},
                    {{0, 0, -4}, {3, {0, 0, -1}, 0}},
                    {{0, 0, 0}, {1, {0, 0, 1}, 0}},       // from the centre
                    {{0, 0, 0.5}, {0.5, {0, 0, 1}, 0}},   // from inside, looking outward
                    {{0, 0, -0.5}, {1.5, {0, 0, 1}, 0}},  // from inside, through the centre
                    {{0, 0, 2}, miss},                    // behind, looks small
                    {{0, 0, 1.125}, miss},                // behind, looks large
                    {{0, 0, -1.25}, {0.25, {0, 0, -1}, 0}}};
        for (const auto& ray : rays) check_exactly(bench, scene_of({{{0, 0, 0}, 1}}, ray.eye), {0, 0, 1}, ray.expected);
    });
}

TEST_CASE("intersect_closest: an eye on the surface sees the far side, or past the sphere", "[intersect_closest]") {
    on_every_bench([](Bench& bench) {
        // On a sphere of radius 5, its centre 5 away along (0, 0.6, 0.8): b is 4 along z and 3 along y, and t is 2 b.
        // With r = 5, centre (0, 3, 4): |f|^2 = 25 exactly.
        const Scene scene = scene_of({{{0, 3, 4}, 5}});
        check_exactly(bench, scene, {0, 0, 1}, {8, {0, -0.6f, 0.8f}, 0});
        check_exactly(bench, scene, {0, 1, 0}, {6, {0, 0.6f, -0.8f}, 0});
        check_exactly(bench, scene, {0, 0, -1}, miss);
        check_exactly(bench, scene, {0, -1, 0}, miss);
        check_exactly(bench, scene, {1, 0, 0}, miss);  // along the surface: t = 0 is not > 0
    });
}

TEST_CASE("intersect_closest: tangents hit once, the nearest wins, of equals the lowest id", "[intersect_closest]") {
    on_every_bench([](Bench& bench) {
        // Tangents: small (radius 3 at distance 5) and large (radius 4 at distance 5, along a line 4 away).
        check_exactly(bench, scene_of({{{3, 0, 4}, 3}}), {0, 0, 1}, {4, {-1, 0, 0}, 0});
        check_exactly(bench, scene_of({{{4, 0, 3}, 4}}), {0, 0, 1}, {3, {-1, 0, 0}, 0});
        check_exactly(bench, scene_of({{{3, 0, 4}, 2.9375}}), {0, 0, 1}, miss);
        check_exactly(bench, scene_of({{{4, 0, 3}, 3.9375}}), {0, 0, 1}, miss);
        // Order in the list does not matter but where distances are the same.
        const Sphere near{{0, 0, 6}, 1}, far{{0, 0, 12}, 2}, other{{0, 0, 8}, 3};
        check_exactly(bench, scene_of({near, far}), {0, 0, 1}, {5, {0, 0, -1}, 0});
        check_exactly(bench, scene_of({far, near}), {0, 0, 1}, {5, {0, 0, -1}, 1});
        check_exactly(bench, scene_of({far, near, other}), {0, 0, 1}, {5, {0, 0, -1}, 1});
        check_exactly(bench, scene_of({far, other, near}), {0, 0, 1}, {5, {0, 0, -1}, 1});
        check_exactly(bench, scene_of({other, far, near, near}), {0, 0, 1}, {5, {0, 0, -1}, 0});
        // Inside one sphere, before another.
        check_exactly(bench, scene_of({{{0, 0, 0}, 32}, near}), {0, 0, 1}, {5, {0, 0, -1}, 1});
        check_exactly(bench, scene_of({{{0, 0, 0}, 4}, near}), {0, 0, 1}, {4, {0, 0, 1}, 0});
    });
}

TEST_CASE("intersect_closest: ties between clusters, and ids that are not places", "[intersect_closest]") {
    on_every_bench([](Bench& bench) {
        Scene scene;
        for (int i = 0; i < 40; ++i) scene.spheres.push_back({{0, i == 20 || i == 35 ? 0.0 : 100.0, 6}, 1});
        check_exactly(bench, scene, {0, 0, 1}, {5, {0, 0, -1}, 20});
        check_exactly(bench, scene, {0, 0, -1}, miss);
        // Ids are not places, and the rest of the cluster is empty.
        const Sphere near{{0, 0, 6}, 1}, far{{0, 100, 6}, 1};
        const auto with_ids = [&](const std::vector<Sphere>& few, const std::vector<int>& ids) {
            PencilSpheres seen = seen_from_eye(bench, scene_of(few));
            std::copy(ids.begin(), ids.end(), seen.clusters[0].id);
            return seen;
        };
        const PencilSpheres three = with_ids({far, near, {{0, 0, 6.5}, 1.5}}, {3, 35, 20}), one = with_ids({far}, {3});
        const std::vector<float> dirs = packed(std::vector<Float3>(BLOCK_RAYS, {0, 0, 1}));
        for (const Width& w : widths) {
            CHECK(closest(bench, w, scene.camera, three, dirs).ids == std::vector<int>(BLOCK_RAYS, 20));
            CHECK(closest(bench, w, scene.camera, one, dirs).ids == std::vector<int>(BLOCK_RAYS, -1));
        }
    });
}

TEST_CASE("intersect_closest: what lights need of the hits is what all would have", "[intersect_closest]") {
    on_every_bench([](Bench& bench) {
        Scene scene = scene_of({{{0, 0, -20}, 1, {}}, {{3, 1, -30}, 2, {}}});
        scene.camera.at = {0, 0, -1};
        scene.image = {64, 48};
        const Tile tile{0, 0, 8, 48};
        const PencilSpheres spheres = seen_from_eye(bench, scene);
        const Hits all = closest_of_pixels(bench, widths[0], scene, tile, spheres);
        for (const Width& w : widths) {
            const Hits some = closest_of_pixels(bench, w, scene, tile, spheres, true);
            CHECK(some.ids == all.ids);
            CHECK(some.counts == all.counts);
            CHECK(same_bits(some.ts, sentinels<float>(some.ts.size())));
            int wrong = 0, hits = 0;
            for (size_t ray = 0; ray < all.ids.size(); ++ray) {
                if (all.ids[ray] < 0) continue;
                const Float3 p = unpacked(all.positions, ray), q = unpacked(some.positions, ray),
                             n = unpacked(all.normals, ray), m = unpacked(some.normals, ray);
                wrong += !(p.x == q.x && p.y == q.y && p.z == q.z && n.x == m.x && n.y == m.y && n.z == m.z);
                ++hits;
            }
            CHECK(wrong == 0);
            CHECK(hits > 10);
            CHECK(hits < 1000);
        }
    });
}
