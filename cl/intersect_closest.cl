// intersect_closest: the first sphere that each ray of the eye's pencil meets.
//
// Reads the hierarchy of the spheres as the eye sees them, and dirs (block order, 3 a ray) or, with -D
// RAYS=RAYS_GENERATED, nothing else: it makes the rays itself, as generate_rays would. Writes per ray the hit's
// position from the eye, t dir, the outward unit normal, the id and t (a miss: no position, (inf, inf, inf), -1, +inf);
// with -D HITS=HITS_FOR_LIGHTS no t, and of vectors of rays that all miss the ids alone. Says in hit_counts, one a
// block and first_block of them before these, how many of its rays hit; where the spheres come in chunks or a work-item
// is less than a block, adds it. Where the spheres come in chunks (-D CHUNKS=1) and this is not the first of them, what
// was written for those before is read, and stays where nothing is closer. With -D CERTIFIED=1 it also says, or adds,
// in undecided (a bit a ray, from first_block's on) of which rays rounding may decide what they hit, and keeps in
// doubts what is to be known of all others' hits (certify.h); with -D BOXES=1 the boxes around blocks' hits. One
// work-item: PACKETS * LANES neighbouring rays of a block against the spheres that their fat ray may meet.
#include "certain_hit.h"
#include "closest_hit.h"
#include "eye_pencil.h"
#include "fat_ray.h"
#include "hits_box.h"
#include "hits_out.h"

#define FAT FatRay
#define NODE_CANDIDATES node_candidates
#define BALL_CANDIDATES candidates
#include "hierarchy.h"

// The next cluster with spheres that the fat ray may meet, and these as bits; -1 after the last.
INLINE int next_candidates(Hierarchy hierarchy, Traversal* traversal, FatRay fat, int* spheres) {
    int c;
    do {
        c = next_cluster(hierarchy, traversal, fat);
        *spheres = c < 0 ? 0 : candidates(fat, hierarchy.clusters + c);
    } while (c >= 0 && !*spheres);
    return c;
}

// Where the farthest of the closest hits is; rays that are none do not count.
INLINE float farthest_hit(const Hit* hit, const wholew* valid) {
    floatw farthest = wide_float(0.0f);
    FOR_PACKETS(k) farthest = MORE_WHERE(ints_of(valid[k]), floats_of(reaches(hit[k])), farthest);
    return REDUCE(most, farthest);
}

kernel void intersect_closest(
#if RAYS == RAYS_READ
    global const real* restrict dirs,
#endif
    global const PencilCluster* restrict clusters, global const Node* restrict nodes, global real* restrict positions,
    global real* restrict normals, global int* restrict ids,
#if HITS == HITS_ALL
    global real* restrict ts,
#endif
#if BOXES
    global HitsBox* restrict boxes,
#endif
    global int* restrict hit_counts,
#if CERTIFIED
    global real* restrict doubts, global uint* restrict undecided,
#endif
    const EyePencil eye, const Basis basis, const Pass pass, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= pass.items) return;
    const Hierarchy hierarchy = {clusters, nodes, pass.levels, pass.last};
    const real base = pass.base_doubt;
    const HitsOut out = HITS_OUT;
    vec3w dir[PACKETS];
    Hit hit[PACKETS];
    Bounds bounds = no_bounds();

    wholew valid[PACKETS];
#if RAYS == RAYS_GENERATED
    // Most work-items that meet nothing are known before their rays are.
    FatRay fat = eye_fat_ray(eye, pass.tile, item, basis);
    Traversal traversal = begin(hierarchy, fat);
    int rest, c = next_candidates(hierarchy, &traversal, fat, &rest);
    if (c < 0) {
        store_misses(out, item);
        if (IS_BLOCK) count_hits(hit_counts + pass.first_block, item, 0);
#if CERTIFIED
        if (IS_BLOCK) say_undecided(0, (Undecided){undecided, pass.first_block}, item);
#endif
        return;
    }
#endif
    FOR_PACKETS(k) {
#if RAYS == RAYS_GENERATED
        dir[k] = eye_rays(eye, pass.tile, item, k);
#else
        dir[k] = load_3(dirs, item, k);
#endif
        valid[k] = dir[k].x == dir[k].x;  // pixels outside the image are NaN
        hit[k] = no_hit();
    }
#if CHUNKS
    if (!pass.first_chunk) FOR_PACKETS(k) {
            hit[k].t = load_r(ts, item, k);
            hit[k].id = load_i(ids, item, k);
        }
#endif
#if RAYS == RAYS_READ
    FatRay fat = fat_ray(dir, valid, basis);
#if CHUNKS
    fat.distance = farthest_hit(hit, valid);
#endif
    Traversal traversal = begin(hierarchy, fat);
    int rest, c = next_candidates(hierarchy, &traversal, fat, &rest);
#endif
    for (; c >= 0; c = next_candidates(hierarchy, &traversal, fat, &rest)) {
        int closer = 0;
        for (; rest; rest &= rest - 1)
            closer |= intersect(sphere_of(clusters + c, lowest_bit(rest)), dir, base, hit, &bounds);
#if WALK == WALK_NODES
        if (!closer) continue;
        traversal.farthest = farthest_hit(hit, valid);
        fat.distance = traversal.farthest;
#endif
    }
#if BOXES
    LaneBoxes around = no_boxes();
#endif
    wholew hits = 0;
#if CERTIFIED
    EasyHits easy = no_hits();
#endif
    FOR_PACKETS(k) {
        realw inverse;
        vec3w normal = outward_normal(hit[k], dir[k], &inverse);
#if CERTIFIED
        add_hit(&easy, hit[k], other_than(hit[k], &bounds, k), fabs(dot_w(dir[k], normal)), inverse, base);
#endif
        hits += choose(hit[k].id >= 0, (wholew)(1), (wholew)(0));
#if CHUNKS
        if (!pass.first_chunk) {
            const wholew before = load_i(ids, item, k);  // hits that stayed as they were have no centre here
            normal = select_w(hit[k].id != before, normal, load_3(normals, item, k));
            hits -= choose(before >= 0, (wholew)(1), (wholew)(0));
        }
#endif
        const vec3w position = scale_w(hit[k].t, dir[k]);
        store_hit(hit[k], position, normal, out, item, k);
#if BOXES
        add_to_boxes(&around, position, hit[k].id >= 0);
#endif
    }
#if BOXES
    boxes[item] = box_of(around);
#endif

#if CERTIFIED
    HitDoubts doubt = easy_doubts(easy, bounds.steep, base);
    ulong open = 0;
    if (!are_easy(easy)) open = undecided_hits(dir, hit, &bounds, base, &doubt);
    keep_doubts(doubt.position, doubt.curvature, doubts, doubts_place(pass.first_block, item));
    say_undecided(open, (Undecided){undecided, pass.first_block}, item);
#endif
    count_hits(hit_counts + pass.first_block, item, REDUCE(count, ints_of(hits)));
}
