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

// Takes from `left` the hits that are not much farther from the eye than the nearest of them: neighbours, in a block,
// whose shadow rays stay together.
static inline void take_group(const floatw* t, float group_depth, wholew* left, wholew* group) {
    floatw nearest = wide_float(INFINITY);
    FOR_PACKETS(k) nearest = LESS(ints_of(left[k]) ? t[k] : nearest, nearest);
    const floatw limit = wide_float(REDUCE(least, nearest) * group_depth);
    FOR_PACKETS(k) {
        group[k] = left[k] & wholes_of(t[k] <= limit);
        left[k] &= !group[k];
    }
}

// share[k]: what would arrive at the hits of packet k; where something is in between it becomes 0. Where there are
// levels, hits are traced together whose distances from the eye differ by less than the factor group_depth (> 1).
static inline void trace_shadows(Hits hits, Hierarchy hierarchy, LightPencil light, float group_depth, int item,
                                 realw* share) {
    ShadowRay ray[PACKETS];
    floatw t[PACKETS];
    wholew id[PACKETS], left[PACKETS], group[PACKETS];
    FOR_PACKETS(k) {
        left[k] = share[k] > 0.0f;
        id[k] = load_i(hits.ids, item, k);
        const realw distance = load_r(hits.ts, item, k);
        t[k] = floats_of(distance);
        ray[k] = shadow_ray(light, scale_w(distance, load_3(hits.dirs, item, k)));
    }
#if WALK != WALK_NODES
    if (any_open(left)) trace_group(hierarchy, light, ray, id, left, share);
#else
    while (any_open(left)) {
        take_group(t, group_depth, left, group);
        trace_group(hierarchy, light, ray, id, group, share);
    }
#endif
}

#endif
