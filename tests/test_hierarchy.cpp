// The hierarchy: that it holds what it should, and that walking it changes no bit against brute force.
#include <set>

#include "crowds.h"
#include "intersect_harness.h"
#include "shadow_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// How far a ball's content sticks out of it, relative to its radius. Centre and radius are a few roundings of doubles.
double sticks_out(const Ball& outer, const Ball& inner) {
    return (length(inner.center - outer.center) + inner.radius) / outer.radius - 1;
}

const Light suns_and_lamps[] = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, PointLight{{10, 80, 40}, {1, 1, 1}},
                                PointLight{{0, 0, 100}, {1, 1, 1}}};

}  // namespace

TEST_CASE("hierarchy: every distinct sphere is there once, in balls that hold it", "[hierarchy]") {
    for (const Crowd crowd : crowds) {
        INFO(to_string(crowd));
        const Scene scene = scene_of(crowd, 5000);
        const Hierarchy h = build_hierarchy(scene.spheres);
        const std::set<int> ids(h.order.begin(), h.order.end());
        CHECK(ids.size() == h.order.size());
        CHECK(h.order.size() == (crowd == Crowd::coincident ? 3 : 5000));
        if (crowd == Crowd::coincident) CHECK(ids == std::set<int>{0, 1, 2});
        const std::vector<Ball>* below = &h.spheres;
        for (const std::vector<Ball>& level : h.levels) {
            REQUIRE(level.size() == (below->size() + CLUSTER - 1) / CLUSTER);
            for (size_t i = 0; i < below->size(); ++i) CHECK(sticks_out(level[i / CLUSTER], (*below)[i]) < 0x1p-48);
            below = &level;
        }
        CHECK((h.levels.empty() || h.levels.back().size() <= CLUSTER));
    }
}

TEST_CASE("hierarchy: few spheres have no levels, more have as many as they need", "[hierarchy]") {
    for (const auto& [spheres, levels] : {std::pair{1, 0}, {16, 0}, {256, 0}, {257, 2}, {4096, 2}, {4097, 3}}) {
        INFO(spheres);
        CHECK(build_hierarchy(scene_of(Crowd::strewn, spheres).spheres).levels.size() == static_cast<size_t>(levels));
    }
}

TEST_CASE("hierarchy: seen from an apex, children come front to back", "[hierarchy]") {
    const Scene scene = scene_of(Crowd::sizes, 5000);
    const PencilSpheres seen = seen_from_eye(scene.camera, build_hierarchy(scene.spheres));
    REQUIRE(seen.levels == 3);
    for (const Bounds& b : seen.nodes)
        for (int i = 1; i < CLUSTER && b.id[i] >= 0; ++i)
            CHECK(b.distance[i - 1] - b.reach[i - 1] <= b.distance[i] - b.reach[i]);
}

TEST_CASE("hierarchy: closest hits are those of brute force", "[hierarchy]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds) {
            INFO(to_string(crowd));
            const Hits hits = closest(bench, scene_of(crowd, 5000), looking_in(24));
            CHECK(std::count_if(hits.ids.begin(), hits.ids.end(), [](int id) { return id >= 0; }) > 0);
        }
    });
}

TEST_CASE("hierarchy: shadows are those of brute force", "[hierarchy]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds) {
            INFO(to_string(crowd));
            const Scene scene = scene_of(crowd, 3000);
            Receivers receivers;
            for (const Float3& dir : looking_in(8)) receivers.see(scene, dir);
            for (const Light& light : suns_and_lamps) arrival(bench, scene, receivers, light);
        }
    });
}
