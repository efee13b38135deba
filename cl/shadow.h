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

// What arrives (arriving(), > 0) at the hits of packet k if nothing is in between, else 0.
static inline realw unshadowed(Hits hits, LightPencil light, int item, int k) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return wide(0.0f);
    const vec3w position = scale_w(load_r(hits.ts, item, k), load_3(hits.dirs, item, k));
    const realw share = arriving(light, position, load_3(hits.normals, item, k));
    const wholew lit = hit & (share > 0.0f);
    return lit ? share : wide(0.0f);
}

#if CERTIFIED

// The doubts of packet k (intersect_closest): of the position, +inf where it is undecided, and of the normal.
static inline realw position_doubt(global const real* doubts, int item, int k) {
    return *(global const realw*)(doubts + lane_address(item, k, 0, 2));
}
static inline realw normal_doubt(global const real* doubts, int item, int k) {
    return *(global const realw*)(doubts + lane_address(item, k, 1, 2));
}
// Leaves the rays of a mask undecided.
static inline void leave_undecided(wholew which, global real* doubts, int item, int k) {
    if (!any_lane(which)) return;
    const realw before = position_doubt(doubts, item, k);
    *(global realw*)(doubts + lane_address(item, k, 0, 2)) = which ? wide(INFINITY) : before;
}

// As `unshadowed`; hits of which rounding may decide whether they face the light are left undecided.
static inline realw certainly_unshadowed(Hits hits, LightPencil light, real base, global real* doubts, int item,
                                         int k) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return wide(0.0f);
    const realw t = load_r(hits.ts, item, k), off = position_doubt(doubts, item, k);
    const vec3w position = scale_w(t, load_3(hits.dirs, item, k)), normal = load_3(hits.normals, item, k);
    wholew faces, averted;
    judge_facing(light, position, normal, t, off, normal_doubt(doubts, item, k), base, &faces, &averted);
    leave_undecided(hit & !(faces | averted), doubts, item, k);
    const realw share = arriving(light, position, normal);
    return hit & faces & (share > 0.0f) ? share : wide(0.0f);
}

#endif

static inline int any_open(const wholew* open) {
    wholew any = 0;
    FOR_PACKETS(k) any |= open[k];
    return any_lane(any);
}

// Takes from the open hits that the sphere occludes what they had; the result is not 0 when there were any.
static inline int occlude(PencilSphere s, const ShadowRay* ray, const wholew* id, wholew* open, realw* share) {
    wholew changed = 0;
    FOR_PACKETS(k) {
        const wholew closes = open[k] & occludes(s, ray[k]) & (id[k] != s.id);
        share[k] = closes ? wide(0.0f) : share[k];
        open[k] &= !closes;
        changed |= closes;
    }
    return any_lane(changed);
}

#if CERTIFIED
// As `occlude`, where that is certain; where it is not, `unsure` says so and the hit stays open.
static inline int certainly_occlude(PencilSphere s, const ShadowRay* ray, RayDoubt doubt, real base, const wholew* id,
                                    wholew* open, wholew* unsure, realw* share) {
    const Edge edge = edge_of(s, doubt, base);
    wholew near[PACKETS], any = 0, changed = 0;
    FOR_PACKETS(k) {
        near[k] = open[k] & (id[k] != s.id) & is_near(s, ray[k], edge);
        any |= near[k];
    }
    if (!any_lane(any)) return 0;
    FOR_PACKETS(k) {
        wholew closes, clear;
        judge_occlusion(s, ray[k], doubt, edge, &closes, &clear);
        const wholew other = near[k];
        unsure[k] |= other & !(closes | clear);
        closes &= other;
        share[k] = closes ? wide(0.0f) : share[k];
        open[k] &= !closes;
        changed |= closes;
    }
    return any_lane(changed);
}

// The rays' common doubt. Of reals that are doubles floats are taken, and a little more.
static inline RayDoubt common_doubt(LightPencil light, const ShadowRay* ray, const floatw* t, const floatw* off,
                                    const wholew* open, real base) {
    const floatw none = 0.0f, all = INFINITY;
    floatw most_off = none, farthest = none, shortest = all, longest = none;
    FOR_PACKETS(k) {
        const intw counts = ints_of(open[k]);
        const floatw way = floats_of(way_of(ray[k]));
        most_off = MORE(counts ? off[k] : none, most_off);
        farthest = MORE(counts ? t[k] : none, farthest);
        shortest = LESS(counts ? way : all, shortest);
        longest = MORE(counts ? way : none, longest);
    }
    const float more = 1 + 0x1p-20f, less = 1 - 0x1p-20f;
    return ray_doubt(light, REDUCE(most, most_off) * more, REDUCE(most, farthest) * more,
                     REDUCE(least, shortest) * less, REDUCE(most, longest) * more, base);
}

static inline void trace_certain_group(Hierarchy hierarchy, LightPencil light, const ShadowRay* ray, const floatw* t,
                                       const floatw* off, real base, const wholew* id, wholew* open, wholew* unsure,
                                       realw* share) {
    const int face = face_of(light, ray, open);
    const RayDoubt doubt = common_doubt(light, ray, t, off, open, base);
    const FatShadowRay fat = widened(fat_shadow_ray(light, face, ray, open), light, face, doubt);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = shadow_candidates(fat, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (certainly_occlude(s, ray, doubt, base, id, open, unsure, share) && !any_open(open)) return;
        }
}
#endif

// Traces the open rays as one fat ray.
static inline void trace_group(Hierarchy hierarchy, LightPencil light, const ShadowRay* ray, const wholew* id,
                               wholew* open, realw* share) {
    const int face = face_of(light, ray, open);
    const FatShadowRay fat = fat_shadow_ray(light, face, ray, open);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = shadow_candidates(fat, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (occlude(s, ray, id, open, share) && !any_open(open)) return;
        }
}

// Takes from `left` the hits of which a value is at most `ratio` times that of the least of them. By their distances
// from the eye: neighbours, in a block, whose shadow rays stay together. By their doubts: hits that one doubt serves.
static inline void take_group(const floatw* value, float ratio, wholew* left, wholew* group) {
    floatw lowest = wide_float(INFINITY);
    FOR_PACKETS(k) lowest = LESS(ints_of(left[k]) ? value[k] : lowest, lowest);
    const floatw limit = wide_float(REDUCE(least, lowest) * ratio);
    FOR_PACKETS(k) {
        group[k] = left[k] & wholes_of(value[k] <= limit);
        left[k] &= !group[k];
    }
}

// share[k]: what would arrive at the hits of packet k; where something is in between it becomes 0. Where there are
// levels, hits are traced together whose distances from the eye differ by less than the factor group_depth (> 1). With
// -D CERTIFIED=1 hits whose shadow rounding may decide are left undecided in `doubts`, as those are that were so
// before.
static inline void trace_shadows(Hits hits, Hierarchy hierarchy, LightPencil light, float group_depth, int item,
                                 realw* share, real base, global real* doubts) {
    ShadowRay ray[PACKETS];
    floatw t[PACKETS];
    wholew id[PACKETS], left[PACKETS], group[PACKETS];
#if CERTIFIED
    floatw off[PACKETS];
    wholew unsure[PACKETS];
#endif
    FOR_PACKETS(k) {
        left[k] = share[k] > 0.0f;
        id[k] = load_i(hits.ids, item, k);
        const realw distance = load_r(hits.ts, item, k);
        t[k] = floats_of(distance);
        ray[k] = shadow_ray(light, scale_w(distance, load_3(hits.dirs, item, k)));
#if CERTIFIED
        off[k] = floats_of(position_doubt(doubts, item, k));
        left[k] &= wholes_of(off[k] < INFINITY);
        unsure[k] = 0;
#endif
    }
#if WALK != WALK_NODES && !CERTIFIED
    FOR_PACKETS(k) group[k] = left[k];
    if (any_open(group)) {
#else
    while (any_open(left)) {
#if WALK == WALK_NODES
        take_group(t, group_depth, left, group);
#else
        take_group(off, 8.0f, left, group);
#endif
#endif
#if CERTIFIED
        trace_certain_group(hierarchy, light, ray, t, off, base, id, group, unsure, share);
        FOR_PACKETS(k) leave_undecided(unsure[k] & group[k], doubts, item, k);
#else
        trace_group(hierarchy, light, ray, id, group, share);
#endif
    }
}

#endif
