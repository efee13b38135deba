// The shadow rays of a work-item toward one light: what of it arrives at each hit.
//
// A surface that does not face the light is in its own shadow. One that does leaves its own sphere for good, since a
// ball is convex: that sphere is skipped by id, exactly, and there is no epsilon.
#ifndef GNOMON_SHADOW_H
#define GNOMON_SHADOW_H

#include "light_pencil.h"
#include "ray_buffers.h"

#define FAT FatShadowRay
#define NODE_CANDIDATES shadow_node_candidates
#include "hierarchy.h"

// What intersect_closest wrote, with the rays that it read.
typedef struct {
    global const real *dirs, *ts, *normals;
    global const int* ids;
} Hits;

static inline vec3w position_of(Hits hits, int item, int k) {
    return scale_w(load_r(hits.ts, item, k), load_3(hits.dirs, item, k));
}

// What arrives (arriving(), > 0) at the hits of packet k if nothing is in between, else 0.
static inline realw unshadowed(Hits hits, LightPencil light, ShadowRay ray, int item, int k) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return wide(0.0f);
    const realw share = arriving(light, ray, position_of(hits, item, k), load_3(hits.normals, item, k));
    const wholew lit = hit & (share > 0.0f);
    return choose(lit, share, wide(0.0f));
}

#if CERTIFIED
// What intersect_closest wrote beside hits: how far their positions may be off, +inf where they are undecided, which
// these are, and the most curved sphere of those that a work-item hits, 1 / radius.
typedef struct {
    global const real* doubts;
    global const float* curvatures;
    real base;
    Undecided undecided;
} Certainty;

// The hits of packet k of which rounding may decide whether they face the light, as bits of the work-item. The normal
// is off by what the position is, the centre's rounding, u |f| <= u (t + r), and its own, over the radius; twice that
// serves while it is below 1/2.
static inline ulong facing_unsure(Hits hits, LightPencil light, ShadowRay ray, Certainty certainty, int item, int k) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return 0;
    const realw off = load_r(certainty.doubts, item, k);
    const realw share = off * certainty.curvatures[item];
    const realw turned = share < 0.5f ? fma(wide(2.0f), share, wide(12 * ROUNDING)) : wide(INFINITY);
    const wholew open =
        may_face(light, ray, position_of(hits, item, k), load_3(hits.normals, item, k), off, turned, certainty.base);
    return bits_of_packet(hit & (off < INFINITY) & open, k);
}

#else
typedef struct {
    int nothing;
} Certainty;
#endif

static inline int any_open(const wholew* open) {
    wholew any = 0;
    FOR_PACKETS(k) any |= open[k];
    return any_lane(any);
}

// Whether anything arrives yet at a hit of the group.
static inline int any_lit(const wholew* group, const realw* share) {
    wholew any = 0;
    FOR_PACKETS(k) any |= group[k] & (share[k] > 0.0f);
    return any_lane(any);
}

// Takes from the hits that the sphere occludes what they had; the result is not 0 when there were any. Most spheres
// occlude nothing of a work-item, which is found first, in a third of the work.
static inline int occlude(PencilSphere s, const ShadowRay* ray, const wholew* id, realw* share) {
    wholew any = 0, changed = 0;
    FOR_PACKETS(k) any |= (share[k] > 0.0f) & (id[k] != s.id) & may_occlude(s, ray[k]);
    if (!any_lane(any)) return 0;
    FOR_PACKETS(k) {
        const wholew closes = (share[k] > 0.0f) & (id[k] != s.id) & occludes(s, ray[k]);
        share[k] = choose(closes, wide(0.0f), share[k]);
        changed |= closes;
    }
    return any_lane(changed);
}

#if CERTIFIED
// As `occlude`, for hits of the group, where that is certain; where it is not, `unsure` says so.
static inline int certainly_occlude(PencilSphere s, const ShadowRay* ray, Edge edge, const wholew* id,
                                    const wholew* group, wholew* unsure, realw* share) {
    wholew may[PACKETS], any = 0, changed = 0;
    FOR_PACKETS(k) {
        may[k] = group[k] & (share[k] > 0.0f) & (id[k] != s.id) & !surely_misses(s, ray[k], edge);
        any |= may[k];
    }
    if (!any_lane(any)) return 0;
    FOR_PACKETS(k) {
        wholew closes, clear;
        judge_occlusion(s, ray[k], edge, &closes, &clear);
        unsure[k] |= may[k] & !(closes | clear);
        closes &= may[k];
        share[k] = choose(closes, wide(0.0f), share[k]);
        changed |= closes;
    }
    return any_lane(changed);
}

// As `trace_group`. What is certainly occluded is so whatever else is unsure.
static inline void trace_certain_group(Hierarchy hierarchy, LightPencil light, const ShadowRay* ray,
                                       Certainty certainty, const wholew* id, const wholew* group, wholew* unsure,
                                       realw* share) {
    const int face = face_of(light, ray, group);
    const RayDoubt doubt = ray_doubt(light, ray, group, certainty.base);
    const FatShadowRay fat = widened(fat_shadow_ray(light, face, ray, group), light, face, doubt);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = shadow_candidates(fat, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            const Edge edge = edge_of(s, doubt, certainty.base);
            if (certainly_occlude(s, ray, edge, id, group, unsure, share) && !any_lit(group, share)) return;
        }
}
#endif

// Traces a group's rays as one fat ray. What occludes others of the work-item on its way may close them too.
static inline void trace_group(Hierarchy hierarchy, LightPencil light, const ShadowRay* ray, const wholew* id,
                               const wholew* group, realw* share) {
    const int face = face_of(light, ray, group);
    const FatShadowRay fat = fat_shadow_ray(light, face, ray, group);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = shadow_candidates(fat, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (occlude(s, ray, id, share) && !any_lit(group, share)) return;
        }
}

// Takes from `left` the hits whose t is at most `ratio` times that of the nearest: neighbours, in a block, whose shadow
// rays stay together.
static inline void take_group(const floatw* t, float ratio, wholew* left, wholew* group) {
    floatw nearest = wide_float(INFINITY);
    FOR_PACKETS(k) nearest = LESS_WHERE(ints_of(left[k]), t[k], nearest);
    const floatw limit = wide_float(REDUCE(least, nearest) * ratio);
    FOR_PACKETS(k) {
        group[k] = left[k] & wholes_of(t[k] <= limit);
        left[k] &= !group[k];
    }
}

// ray[k]: the shadow rays of packet k; share[k]: what would arrive at its hits; where something is in between it
// becomes 0. Where there are levels, hits are traced together whose distances from the eye differ by less than the
// factor group_depth (> 1). With -D CERTIFIED=1 hits whose shadow rounding may decide are left undecided.
static inline void trace_shadows(Hits hits, Hierarchy hierarchy, LightPencil light, ShadowRay* ray, float group_depth,
                                 int item, realw* share, Certainty certainty) {
    floatw t[PACKETS];
    wholew id[PACKETS], left[PACKETS], group[PACKETS];
    FOR_PACKETS(k) {
        left[k] = share[k] > 0.0f;
        id[k] = load_i(hits.ids, item, k);
        t[k] = floats_of(load_r(hits.ts, item, k));
#if CERTIFIED
        const realw off = load_r(certainty.doubts, item, k);
        ray[k].off = ray_off(light, ray[k], off, certainty.base);
        left[k] &= off < INFINITY;
#endif
    }
#if WALK == WALK_NODES
    while (any_open(left)) {
        take_group(t, group_depth, left, group);
#else
    FOR_PACKETS(k) group[k] = left[k];
    if (any_open(group)) {
#endif
#if CERTIFIED
        wholew unsure[PACKETS];
        FOR_PACKETS(k) unsure[k] = 0;
        trace_certain_group(hierarchy, light, ray, certainty, id, group, unsure, share);
        ulong open = 0;
        FOR_PACKETS(k) open |= bits_of_packet(unsure[k] & (share[k] > 0.0f), k);
        leave_undecided(open, certainty.undecided, item);
#else
        trace_group(hierarchy, light, ray, id, group, share);
#endif
    }
}

#endif
