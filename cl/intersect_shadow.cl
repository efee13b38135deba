// intersect_shadow: does anything stand between each hit and one light?
//
// Reads what intersect_closest wrote (t, normal, id) with dirs, and the spheres as this light's pencil sees them.
// Writes lit: 1 where a hit faces the light and nothing is in between, else 0. One work-item: PACKETS * LANES
// neighbouring rays against the spheres that their fat ray may meet.
//
// A surface that does not face the light is in its own shadow. One that does leaves its own sphere for good, since a
// ball is convex: that sphere is skipped by id, exactly, and there is no epsilon.
#include "lanes.h"

#include "light_pencil.h"

// Takes the rays that the sphere occludes from the open ones; the result is not 0 when there were any.
static inline int close_occluded(PencilSphere s, const ShadowRay* ray, const intw* id, intw* open) {
    int changed = 0;
    FOR_PACKETS(k) {
        const intw closes = open[k] & occludes(s, ray[k]) & (id[k] != s.id);
        if (!any_lane(closes)) continue;
        open[k] &= !closes;
        changed = 1;
    }
    return changed;
}

static inline int any_open(const intw* open) {
    intw any = 0;
    FOR_PACKETS(k) any |= open[k];
    return any_lane(any);
}

// `open`: facing the light, and nothing found in between so far.
static inline void trace(global const SphereCluster* clusters, int sphere_count, const ShadowRay* ray, const intw* id,
                         intw* open) {
    if (!any_open(open)) return;
#if LANES > 1
    const FatShadowRay fat = fat_shadow_ray(ray, open);
#endif
    for (int c = 0; c * CLUSTER < sphere_count; ++c) {
        int rest = spheres_in_cluster(c, sphere_count);
#if LANES > 1
        rest &= shadow_candidates(fat, clusters + c);
#endif
        for (; rest; rest &= rest - 1)
            if (close_occluded(sphere_of(clusters + c, lowest_bit(rest)), ray, id, open) && !any_open(open)) return;
    }
}

kernel void intersect_shadow(global const float* restrict dirs, global const float* restrict ts,
                             global const float* restrict normals, global const int* restrict ids,
                             global const SphereCluster* restrict clusters, const int sphere_count,
                             const LightPencil light, const int items, global int* restrict lit) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    ShadowRay ray[PACKETS];
    intw id[PACKETS], open[PACKETS];
    FOR_PACKETS(k) {
        id[k] = load_i(ids, item, k);
        const vec3w position = scale_w(load_f(ts, item, k), load_3(dirs, item, k));
        open[k] = (id[k] >= 0) & (facing(light, position, load_3(normals, item, k)) > 0.0f);
        ray[k] = shadow_ray(light, position);
    }
    trace(clusters, sphere_count, ray, id, open);
    FOR_PACKETS(k) store_i(open[k] ? (intw)(1) : (intw)(0), lit, item, k);
}
