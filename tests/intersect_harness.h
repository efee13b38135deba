// intersect_closest alone, and how far its roots may be off.
#pragma once

#include <algorithm>

#include "guarded_spheres.h"
#include "kernel_harness.h"
#include "pencil.h"
#include "reference.h"

namespace gnomon::test {

/// What intersect_closest writes.
template <class real>
struct HitsOf {
    std::vector<real> ts, normals, positions;
    std::vector<int> ids, counts;
};
using Hits = HitsOf<float>;

template <class real>
bool same_bits(const HitsOf<real>& a, const HitsOf<real>& b) {
    return same_bits(a.ts, b.ts) && same_bits(a.normals, b.normals) && same_bits(a.ids, b.ids);
}

/// Launches over packed directions; checks guards, inputs and the hits counted.
template <class real>
HitsOf<real> closest(Bench& bench, Width w, const Camera& camera, const PencilSpheresOf<real>& spheres,
                     const std::vector<real>& packed_dirs) {
    INFO(w);
    constexpr int first_block = 3, counted_before = 1000;
    const size_t rays = packed_dirs.size() / 3;
    const int items = static_cast<int>(rays) / w.rays();
    const size_t blocks = (rays + BLOCK_RAYS - 1) / BLOCK_RAYS;
    const GuardedBuffer<real> dirs(bench, packed_dirs), positions(bench, 3 * rays), normals(bench, 3 * rays),
        ts(bench, rays);
    const GuardedSpheres<real> in(bench, spheres);
    const GuardedBuffer<int> ids(bench, rays), counts(bench, std::vector<int>(first_block + blocks, counted_before));
    bench.launch(bench.programs
                     .get({Kernel::intersect_closest, w.defines({"WALK=" + spheres.walk, "CHUNKS=0", "RAYS=RAYS_READ"}),
                           accuracy_of<real>})
                     .kernel,
                 items, dirs.buffer(), in.clusters.buffer(), in.nodes.buffer(), positions.buffer(), normals.buffer(),
                 ids.buffer(), ts.buffer(), counts.buffer(), EyePencilOf<real>{}, eye_basis(camera),
                 Pass{{}, items, first_block, spheres.levels, spheres.last, 1, 0, 0, 0});
    HitsOf<real> hits{ts.read(), normals.read(), positions.read(), ids.read(), counts.read()};
    dirs.check_unchanged();
    in.check_unchanged();
    std::vector<int> expected(first_block + blocks, counted_before);
    if (w.rays() == BLOCK_RAYS) std::fill(expected.begin() + first_block, expected.end(), 0);  // said, not added
    int elsewhere = 0;
    for (size_t ray = 0; ray < rays; ++ray) {
        expected[first_block + ray / BLOCK_RAYS] += hits.ids[ray] >= 0;
        const Real3Of<real> d = unpacked(packed_dirs, ray), position = unpacked(hits.positions, ray);
        const real t = hits.ts[ray];
        elsewhere += hits.ids[ray] >= 0 && !(position.x == t * d.x && position.y == t * d.y && position.z == t * d.z);
    }
    CHECK(hits.counts == expected);
    CHECK(elsewhere == 0);
    return hits;
}

/// By brute force, after checking that the hierarchy gives the same bits in all widths.
template <class real>
HitsOf<real> closest(Bench& bench, const Scene& scene, const std::vector<Real3Of<real>>& rays) {
    const PencilSpheresOf<real> spheres = seen_from_eye<real>(bench, scene);
    const std::vector<real> dirs = packed(rays);
    const HitsOf<real> hits = closest(bench, widths[0], scene.camera, brute(spheres), dirs);
    for (const Width& w : widths) {
        INFO(w);
        CHECK(same_bits(closest(bench, w, scene.camera, spheres, dirs), hits));
    }
    return hits;
}

/// Blocks without hits may have any.
inline void check_boxes(const std::vector<HitsBox>& boxes, const Hits& hits) {
    const std::vector<HitsBox> expected = boxes_around(hits.positions, hits.ids);
    const auto same = [](const Float3& a, const Float3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    int wrong = 0;
    for (size_t i = 0; i < boxes.size(); ++i)
        if (expected[i].least.x <= expected[i].most.x)
            wrong += !(same(boxes[i].least, expected[i].least) && same(boxes[i].most, expected[i].most));
    CHECK(wrong == 0);
}

/// Of the pixels of a tile, with the rays that intersect_closest generates itself. For lights alone ts stays as it was.
inline Hits closest_of_pixels(Bench& bench, Width w, const Scene& scene, const Tile& tile, const PencilSpheres& spheres,
                              bool for_lights = false) {
    INFO(w << " " << spheres.walk);
    const size_t rays = static_cast<size_t>(tile.blocks) * BLOCK_RAYS;
    const int items = static_cast<int>(rays) / w.rays();
    const GuardedSpheres<float> in(bench, spheres);
    const GuardedBuffer<float> positions(bench, 3 * rays), ts(bench, rays), normals(bench, 3 * rays);
    const GuardedBuffer<int> ids(bench, rays);
    const GuardedBuffer<int> counts(bench, std::vector<int>(static_cast<size_t>(tile.blocks)));
    const bool has = has_boxes(w, spheres.walk);
    const GuardedBuffer<HitsBox> boxes(bench, static_cast<size_t>(tile.blocks));
    const Variant variant{Kernel::intersect_closest,
                          w.defines({"WALK=" + spheres.walk, "CHUNKS=0", "RAYS=RAYS_GENERATED",
                                     for_lights ? "HITS=HITS_FOR_LIGHTS" : "HITS=HITS_ALL", define_boxes(has)})};
    cl::Kernel kernel = bench.programs.get(variant).kernel;
    Arguments(kernel)
        .add(in.clusters.buffer(), in.nodes.buffer(), positions.buffer(), normals.buffer(), ids.buffer())
        .add_if(!for_lights, ts.buffer())
        .add_if(has, boxes.buffer())
        .add(counts.buffer(), eye_pencil(scene.camera, scene.image), eye_basis(scene.camera),
             Pass{tile, items, 0, spheres.levels, spheres.last, 1, 0, 0, 0}, cl_int(0));
    bench.launch_bound(kernel, items);
    in.check_unchanged();
    const Hits hits{ts.read(), normals.read(), positions.read(), ids.read(), counts.read()};
    if (has) check_boxes(boxes.read(), hits);
    return hits;
}

/// The rays that intersect_closest generates, as the positions tell where the eye is the middle of a ball: t is 1 but
/// for the frame's unit, a power of 2, so that both products are exact.
inline std::vector<float> generated_rays(Bench& bench, Width w, const Scene& scene, const Tile& tile) {
    Scene inside = scene;
    inside.spheres = {{scene.camera.eye, 1, {}}};
    const Hits hits = closest_of_pixels(bench, w, scene, tile, brute(seen_from_eye(bench, inside)));
    std::vector<float> dirs = hits.positions;
    for (size_t i = 0; i < dirs.size(); ++i) dirs[i] /= hits.ts[i / (3 * BLOCK_RAYS) * BLOCK_RAYS + i % BLOCK_RAYS];
    return dirs;
}

template <class real>
bool is_miss(const HitsOf<real>& hits, size_t ray) {
    const Real3Of<real> n = unpacked(hits.normals, ray);
    return hits.ids[ray] == -1 && hits.ts[ray] == INFINITY && n.x == INFINITY && n.y == INFINITY && n.z == INFINITY;
}

/// How far the kernel may be off at one sphere, of centre f from the apex (reals, exact) and radius r, along d; the
/// unit roundoff of these reals is u. With b = f . d, m the distance of the line from f, D = r^2 - m^2, C = |f|^2 -
/// r^2:
///
/// The direction is the rounding of a unit vector: its length is off by u. b: the dot product 3 u |f| (each term
/// passes at most three roundings, Cauchy-Schwarz), the length u |f|: 4 u |f|.
/// D, of spheres apart: what is wrong with b and the length moves f - b dir along the line only, by 4 + 1 = 5 u |f|,
/// and so its square by 25 u^2 |f|^2; its own rounding is 2 u m^2, r^2's and three fma's 4 u max(r^2, m^2). D, of
/// others: 2 b 4 u |f|, C's rounding u |C|, the fma's u |D|. Root: |sqrt(D + e) - sqrt(D)| <= min(e / sqrt(D),
/// sqrt(e)), and its own rounding u sqrt(D). q = b +- sqrt(D): both, and u |q|. The other root C / q: relative, q's
/// error and u each for C and the quotient.
struct Doubt {
    double d_error;  ///< of the discriminant
    double t_error;  ///< of the distance that the kernel would choose
};
inline Doubt doubt(const Vec3& f, double r, const Vec3& d, double unit = u) {
    const double f2 = dot(f, f), b = dot(f, d), m2 = dot(cross(f, d), cross(f, d)), C = f2 - r * r, D = r * r - m2;
    const double length_f = std::sqrt(f2), root = std::sqrt(std::max(0.0, D));
    const double e = r * r < 0.8 * f2 ? 25 * unit * unit * f2 + 2 * unit * m2 + 4 * unit * std::max(r * r, m2)
                                      : 8 * unit * std::fabs(b) * length_f + unit * std::fabs(C) + unit * std::fabs(D);
    const double root_error = std::min(root > 0 ? e / root : INFINITY, std::sqrt(e)) + unit * root;
    const double q = b > 0 ? b + root : b - root, q_error = 4 * unit * length_f + root_error + unit * std::fabs(q);
    const double t_error =
        C > 0 || b <= 0 ? std::fabs(C / q) * (q_error / (std::fabs(q) - q_error) + 2 * unit) : q_error;
    return {1.01 * e, 1.01 * t_error};  // a hundredth for what is of higher order in unit
}

}  // namespace gnomon::test
