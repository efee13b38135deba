// intersect_shadow alone, on numbers that are exact in float, where there is one right answer.
#include "shadow_bounds.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const DirectionalLight sun{{0, 0, -1}, {1, 1, 1}};  // n . l = 1 at the receiver
const PointLight lamp{{0, 0, 4}, {1, 1, 1}};        // 4 before the receiver: 1 / 16

/// One hit in each place of a block but one, which is a miss.
Receivers one_of(Float3 normal = {0, 0, -1}, int id = 0) {
    Receivers hits;
    for (int i = 0; i < BLOCK_RAYS; ++i) i == 21 ? hits.add_miss() : hits.add({0, 0, 1}, 8, normal, id);
    return hits;
}

/// The receiver (0, 0, 8) belongs to sphere 0; the others are in the way, or not.
void check_arrival(Bench& bench, const std::vector<Sphere>& others, const Light& light, float expected,
                   const Receivers& hits = one_of()) {
    Scene scene;
    scene.spheres = {{{0, 0, 10}, 2}};
    scene.spheres.insert(scene.spheres.end(), others.begin(), others.end());
    const std::vector<float> arrived = arrival(bench, scene, hits, light);
    int wrong = 0;
    for (size_t i = 0; i < hits.size(); ++i) wrong += arrived[i] != (hits.ids[i] < 0 ? 0.0f : expected);
    CHECK(wrong == 0);
    for (size_t i = 0; i < hits.size(); ++i)  // and the reference thinks so too
        wrong += hits.ids[i] >= 0 && share(hits.hit(i), light) > 0 &&
                 reference::in_between(scene, hits.hit(i), light) != (expected == 0);
    CHECK(wrong == 0);
}

/// A sphere beside the receiver, and whether it is in the way of the sun and of the lamp.
struct Occluder {
    const char* what;
    Sphere sphere;
    bool sun, lamp;
};
const Occluder occluders[] = {
    {"between receiver and lamp", {{0, 0, 6}, 1}, true, true},
    {"between, small", {{0, 0, 7}, 0.0625}, true, true},
    {"beyond the lamp", {{0, 0, 2}, 1}, true, false},
    {"beyond the lamp, large", {{0, 0, -1000}, 1001}, true, false},
    {"beyond the lamp, touching it", {{0, 0, 3}, 1}, true, false},
    {"touching the lamp on this side", {{0, 0, 5}, 1}, true, true},
    {"around the lamp", {{0, 0, 4}, 1}, true, true},
    {"around the lamp, not about it", {{0, 2, 4}, 3}, true, true},
    {"around both", {{0, 0, 6}, 3}, true, false},
    {"around the receiver", {{0, 0, 9}, 2}, true, true},
    {"around the receiver, small", {{0, 0, 8}, 0.125}, true, true},
    {"around the receiver, large", {{0, 0, 100}, 93}, true, true},
    {"around the receiver, touching the lamp", {{0, 0, 7}, 3}, true, false},
    {"touching the receiver, before it", {{0, 0, 7}, 1}, true, true},
    {"touching the receiver, behind it", {{0, 0, 9}, 1}, false, false},
    {"touching the receiver from the side", {{1, 0, 8}, 1}, false, false},
    {"behind", {{0, 0, 11}, 1}, false, false},
    {"behind, large", {{0, 0, 1008}, 999}, false, false},
    {"tangent to the way", {{1, 0, 6}, 1}, true, true},
    {"beside the way", {{1.0625, 0, 6}, 1}, false, false},
    {"tangent beyond the lamp", {{0, 1, 2}, 1}, true, false},
    {"tangent to the way, large", {{16, 0, 6}, 16}, true, true},
    {"tangent at the lamp, large", {{16, 0, 4}, 16}, true, false},
    {"tangent at the receiver, large", {{16, 0, 8}, 16}, false, false},
    {"beside the way, large", {{16.0625, 0, 6}, 16}, false, false},
    {"touching the receiver, behind it, large", {{0, 0, 40}, 32}, false, false},
    {"around the lamp, touching the receiver", {{0, 0, -24}, 32}, true, false},
    {"around the lamp, which is beyond its centre", {{0, 0, 3}, 2}, true, true},
    {"its foot beyond the lamp, the ball before it", {{0, 1, 3}, 2}, true, true},
};

}  // namespace

TEST_CASE("intersect_shadow: what stands between receiver and light", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        check_arrival(bench, {}, sun, 1);
        check_arrival(bench, {}, lamp, 0.0625f);
        for (const Occluder& o : occluders) {
            INFO(o.what);
            check_arrival(bench, {o.sphere}, sun, o.sun ? 0.0f : 1.0f);
            check_arrival(bench, {o.sphere}, lamp, o.lamp ? 0.0f : 0.0625f);
        }
    });
}

TEST_CASE("intersect_shadow: any one of many spheres is enough", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        for (const size_t count : {1, 2, 15, 16, 17, 31, 33}) {
            std::vector<Sphere> spheres(count, {{50, 0, 6}, 1});
            check_arrival(bench, spheres, sun, 1);
            check_arrival(bench, spheres, lamp, 0.0625f);
            spheres.back() = {{0, 0, 6}, 1};
            check_arrival(bench, spheres, sun, 0);
            check_arrival(bench, spheres, lamp, 0);
        }
    });
}

TEST_CASE("intersect_shadow: its own sphere casts no shadow on a hit, every other does", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        const std::vector<Sphere> others = {{{0, 0, 6}, 1}};
        check_arrival(bench, others, sun, 1, one_of({0, 0, -1}, 1));
        check_arrival(bench, others, lamp, 0.0625f, one_of({0, 0, -1}, 1));
        check_arrival(bench, others, sun, 0, one_of({0, 0, -1}, 0));
        check_arrival(bench, others, lamp, 0, one_of({0, 0, -1}, 0));
    });
}

TEST_CASE("intersect_shadow: a surface that does not face the light gets nothing", "[intersect_shadow]") {
    on_every_bench([](Bench& bench) {
        for (const Float3& normal : {Float3{0, 0, 1}, {1, 0, 0}, {0, 0.6f, 0.8f}}) {
            check_arrival(bench, {}, sun, 0, one_of(normal));
            check_arrival(bench, {}, lamp, 0, one_of(normal));
        }
        check_arrival(bench, {}, PointLight{{0, 0, 8}, {1, 1, 1}}, 0);  // at the receiver itself: no NaN
        check_arrival(bench, {{{0, 0, 8}, 1}}, PointLight{{0, 0, 8}, {1, 1, 1}}, 0);
    });
}
