// intersect_shadow: does anything stand between each hit and one light?
//
// Reads what intersect_closest wrote (t, normal, id) with dirs, and the spheres as this light's pencil sees them.
// Writes lit: 1 where a hit faces the light and nothing is in between, else 0. One work-item: PACKETS * LANES
// neighbouring rays.
//
// A surface that does not face the light is in its own shadow. One that does leaves its own sphere for good, since a
// ball is convex: that sphere is skipped by id, exactly, and there is no epsilon.
#include "lanes.h"

#include "light_pencil.h"

kernel void intersect_shadow(global const float* restrict dirs, global const float* restrict ts,
                             global const float* restrict normals, global const int* restrict ids,
                             global const PencilSphere* restrict spheres, const int sphere_count,
                             const LightPencil light, const int items, global int* restrict lit) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    ShadowRay ray[PACKETS];
    intw id[PACKETS], open[PACKETS];  // open: facing the light, and nothing found in between so far
    intw any_open = 0;
    FOR_PACKETS(k) {
        id[k] = load_i(ids, item, k);
        const vec3w position = scale_w(load_f(ts, item, k), load_3(dirs, item, k));
        const intw faces = (id[k] >= 0) & (facing(light, position, load_3(normals, item, k)) > 0.0f);
        open[k] = faces;
        any_open |= faces;
        ray[k] = shadow_ray(light, position);
    }
    for (int i = 0; any_lane(any_open) && i < sphere_count; ++i) {
        const PencilSphere s = spheres[i];
        int changed = 0;
        FOR_PACKETS(k) {
            const intw closes = open[k] & occludes(s, ray[k]) & (id[k] != s.id);
            if (!any_lane(closes)) continue;
            open[k] &= !closes;
            changed = 1;
        }
        if (!changed) continue;
        any_open = 0;
        FOR_PACKETS(k) any_open |= open[k];
    }
    FOR_PACKETS(k) store_i(open[k] ? (intw)(1) : (intw)(0), lit, item, k);
}
