// The hierarchy: that walking it changes no bit against brute force.
#include "crowds.h"
#include "hierarchy.h"
#include "intersect_harness.h"
#include "shadow_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// The last two are among the spheres: they keep bounds for six faces.
const Light suns_and_lamps[] = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, PointLight{{10, 80, -400}, {1, 1, 1}},
                                PointLight{{10, 80, 40}, {1, 1, 1}}, PointLight{{0, 0, 100}, {1, 1, 1}}};

}  // namespace

TEST_CASE("hierarchy: few spheres have no levels but balls, more have as many as they need", "[hierarchy]") {
    for (const auto& [spheres, levels] : {std::pair{int64_t{1}, 0},
                                          {64, 0},
                                          {65, 1},
                                          {256, 1},
                                          {257, 2},
                                          {4096, 2},
                                          {4097, 3},
                                          {int64_t{1} << 31, 7}}) {
        INFO(spheres);
        const HierarchyShape shape = hierarchy_over(spheres);
        CHECK(shape.levels() == levels);
        CHECK(shape.levels() <= MAX_LEVELS);
        CHECK(shape.is_flat() == (spheres <= 256));
        CHECK(shape.has_balls() == (levels == 1));
        CHECK(int64_t{shape.clusters} * CLUSTER >= spheres);
        int below = shape.clusters;
        for (const int nodes : shape.nodes) {
            CHECK(nodes == (below + CLUSTER - 1) / CLUSTER);
            below = nodes;
        }
        CHECK((shape.is_flat() || below == 1));
    }
}

TEST_CASE("hierarchy: closest hits are those of brute force", "[hierarchy]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds) {
            INFO(to_string(crowd));
            std::ptrdiff_t met = 0;
            for (const int n : {200, 5000}) {
                const Hits hits = closest(bench, scene_of(crowd, n), looking_in(24));
                met += std::count_if(hits.ids.begin(), hits.ids.end(), [](int id) { return id >= 0; });
            }
            CHECK(met > 0);
        }
    });
}

TEST_CASE("hierarchy: shadows are those of brute force", "[hierarchy]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds) {
            for (const int n : {200, 3000}) {
                INFO(n << " " << to_string(crowd));
                const Scene scene = scene_of(crowd, n);
                Receivers receivers;
                for (const Float3& dir : looking_in(8)) receivers.see(scene, dir);
                for (const Light& light : suns_and_lamps) arrival(bench, scene, receivers, light);
            }
        }
    });
}
