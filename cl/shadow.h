// The shadow rays of a work-item toward one light: what of it arrives at each hit.
//
// A surface that does not face the light is in its own shadow. One that does leaves its own sphere for good, since a
// ball is convex: that sphere is skipped by id, exactly, and there is no epsilon.
#ifndef GNOMON_SHADOW_H
#define GNOMON_SHADOW_H

#include "lanes.h"

#include "light_pencil.h"

// What intersect_closest wrote, with the rays that it read.
typedef struct {
    global const float *dirs, *ts, *normals;
    global const int* ids;
} Hits;

// What arrives (arriving(), > 0) at the hits of packet k if nothing is in between, else 0.
static inline floatw unshadowed(Hits hits, LightPencil light, int item, int k) {
    const vec3w position = scale_w(load_f(hits.ts, item, k), load_3(hits.dirs, item, k));
    const floatw share = arriving(light, position, load_3(hits.normals, item, k));
    const intw lit = (load_i(hits.ids, item, k) >= 0) & (share > 0.0f);
    return lit ? share : wide(0.0f);
}

static inline int any_open(const floatw* share) {
    intw any = 0;
    FOR_PACKETS(k) any |= share[k] > 0.0f;
    return any_lane(any);
}

// Takes from the hits that the sphere occludes what they had; the result is not 0 when there were any.
static inline int occlude(PencilSphere s, const ShadowRay* ray, const intw* id, floatw* share) {
    int changed = 0;
    FOR_PACKETS(k) {
        const intw closes = (share[k] > 0.0f) & occludes(s, ray[k]) & (id[k] != s.id);
        if (!any_lane(closes)) continue;
        share[k] = closes ? wide(0.0f) : share[k];
        changed = 1;
    }
    return changed;
}

// share[k]: what arrives at the hits of packet k.
static inline void trace_shadows(Hits hits, global const SphereCluster* clusters, int sphere_count, LightPencil light,
                                 int item, floatw* share) {
    ShadowRay ray[PACKETS];
    intw id[PACKETS];
    FOR_PACKETS(k) {
        share[k] = unshadowed(hits, light, item, k);
        id[k] = load_i(hits.ids, item, k);
        ray[k] = shadow_ray(light, scale_w(load_f(hits.ts, item, k), load_3(hits.dirs, item, k)));
    }
    if (!any_open(share)) return;
#if LANES > 1
    intw open[PACKETS];
    FOR_PACKETS(k) open[k] = share[k] > 0.0f;
    const FatShadowRay fat = fat_shadow_ray(ray, open);
#endif
    for (int c = 0; c * CLUSTER < sphere_count; ++c) {
        int rest = spheres_in_cluster(c, sphere_count);
#if LANES > 1
        rest &= shadow_candidates(fat, clusters + c);
#endif
        for (; rest; rest &= rest - 1)
            if (occlude(sphere_of(clusters + c, lowest_bit(rest)), ray, id, share) && !any_open(share)) return;
    }
}

#endif
