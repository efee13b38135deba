// What intersect_closest says for certain, held against the oracle: of rays that it does not leave undecided the id is
// right, and the position is no farther off than its doubt.
#include <cmath>

#include "catch.h"
#include "intersect_harness.h"
#include "oracle.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// What a certified program writes, each ray with doubts of its own.
template <class real>
struct Certified {
    std::vector<real> ts, doubts;
    std::vector<int> ids, undecided;

    double position_doubt(size_t ray) const { return static_cast<double>(doubts[2 * ray]); }
    bool sure(size_t ray) const { return (static_cast<uint32_t>(undecided[ray / 32]) >> ray % 32 & 1) == 0; }
};

template <class real>
Certified<real> closest_certified(Bench& bench, const Scene& scene, const std::vector<real>& packed_dirs) {
    constexpr Width w{1, 1};
    DeviceSpheres made(bench, scene);
    const PencilSpheresOf<real> spheres = brute(made.seen<real>(view_of_eye<real>(scene.camera, made.frame)));
    const size_t rays = packed_dirs.size() / 3;
    const int items = static_cast<int>(rays) / w.rays();
    const GuardedSpheres<real> in(bench, spheres);
    const GuardedBuffer<real> dirs(bench, packed_dirs), positions(bench, 3 * rays), ts(bench, rays),
        normals(bench, 3 * rays), doubts(bench, 2 * rays);
    const GuardedBuffer<int> ids(bench, rays), counts(bench, std::vector<int>(rays)),
        undecided(bench, std::vector<int>(rays / 32));
    const Variant variant{
        Kernel::intersect_closest,
        w.defines({"WALK=" + spheres.walk, "CHUNKS=0", "CERTIFIED=1", "DOUBT_RAYS=1", "RAYS=RAYS_READ"}),
        accuracy_of<real>};
    bench.launch(bench.programs.get(variant).kernel, items, dirs.buffer(), in.clusters.buffer(), in.nodes.buffer(),
                 positions.buffer(), normals.buffer(), ids.buffer(), ts.buffer(), counts.buffer(), doubts.buffer(),
                 undecided.buffer(), EyePencilOf<real>{}, eye_basis(scene.camera),
                 Pass{{}, items, 0, spheres.levels, spheres.last, 1, 0, 0, base_doubt(scene, made.survey, made.frame)});
    in.check_unchanged();
    return {ts.read(), doubts.read(), ids.read(), undecided.read()};
}

/// Rays that pass the sphere's centre at all distances, and at those close to its radius more than at others.
std::vector<Vec3> around(Random& random, const Sphere& sphere, int rays) {
    std::vector<Vec3> dirs;
    for (int i = 0; i < rays; ++i) {
        const double off = random.scale(1e-9, 1) * (i % 2 == 0 ? 1 : -1);
        const Vec3 across = normalize(cross(sphere.center, random.direction()));
        const double sine = std::min(1.0, sphere.radius * (1 + off) / length(sphere.center));
        dirs.push_back(normalize(normalize(sphere.center) * std::sqrt(1 - sine * sine) + across * sine));
    }
    return dirs;
}

struct Tally {
    int64_t rays = 0, sure = 0, hits = 0, wrong_ids = 0, wrong_positions = 0;
};

template <class real>
void compare(Bench& bench, const Scene& scene, const std::vector<Vec3>& dirs, Tally& tally) {
    std::vector<Real3Of<real>> rounded;
    for (const Vec3& d : dirs)
        rounded.push_back({static_cast<real>(d.x), static_cast<real>(d.y), static_cast<real>(d.z)});
    const Certified<real> certified = closest_certified<real>(bench, scene, packed(rounded));
    const double unit = choose_frame(scene, survey(scene)).unit;
    const oracle::Oracle truth(scene);
    for (size_t i = 0; i < dirs.size(); ++i) {
        ++tally.rays;
        if (!certified.sure(i)) continue;
        ++tally.sure;
        const oracle::Hit hit = truth.look(oracle::Ray{scene.camera.eye, dirs[i]}).hit;
        tally.wrong_ids += hit.id != certified.ids[i];
        if (!hit || hit.id != certified.ids[i]) continue;
        ++tally.hits;
        const Vec3 d{rounded[i].x, rounded[i].y, rounded[i].z};
        const double t = hit.t / unit, off = length(d * static_cast<double>(certified.ts[i]) - dirs[i] * t);
        tally.wrong_positions += !(off <= certified.position_doubt(i) + 0x1p-50 * t);  // this test's own
    }
}

/// A sphere, seen from outside or within, and one of nearly its size that cuts through it.
Scene pair_of(Random& random, bool inside) {
    Scene scene;
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 50};
    const Vec3 center = random.direction() * random.scale(1e-2, 1e4);
    const double r = length(center) * (inside ? random.scale(1.0001, 1e3) : 1 - random.scale(1e-4, 0.9999));
    const double nudge = r * random.scale(1e-8, 1e-2);
    scene.spheres = {{center, r}, {center + random.direction() * nudge, r - nudge * random.uniform(-1, 1)}};
    return scene;
}

template <class real>
Tally tally(Bench& bench, int pairs) {
    Random random(91);
    Tally all;
    for (int i = 0; i < pairs; ++i) {
        const Scene scene = pair_of(random, i % 3 == 2);
        compare<real>(bench, scene, around(random, scene.spheres[0], 4 * BLOCK_RAYS), all);
    }
    return all;
}

void hold(const Tally& t, double least_sure) {
    INFO(t.rays << " rays, " << t.sure << " sure, " << t.hits << " of them hits");
    CHECK(t.wrong_ids == 0);
    CHECK(t.wrong_positions == 0);
    CHECK(static_cast<double>(t.sure) >= least_sure * static_cast<double>(t.rays));  // or nothing is held
    CHECK(t.hits * 8 > t.sure);
}

}  // namespace

TEST_CASE("certified hits: in float what is said to be sure is true", "[certified]") {
    on_every_bench([](Bench& bench) { hold(tally<float>(bench, 60), 0.2); });
}

TEST_CASE("certified hits: in double what is said to be sure is true, and nearly all is", "[certified][double]") {
    on_every_bench([](Bench& bench) {
        if (bench.info.fp64) hold(tally<double>(bench, 30), 0.8);
    });
}

TEST_CASE("certified hits, many more rays", "[.long]") {
    on_every_bench([](Bench& bench) {
        hold(tally<float>(bench, 3000), 0.2);
        if (bench.info.fp64) hold(tally<double>(bench, 500), 0.8);
    });
}
