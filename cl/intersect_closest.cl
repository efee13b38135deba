// intersect_closest: the first sphere that each ray of the eye's pencil meets.
//
// Reads dirs (block order, 3 a ray) and the spheres as the eye sees them, ascending in id. Writes per ray t, the
// outward unit normal and the id (a miss: +inf, (inf, inf, inf), -1), and per work-item how many of its rays hit. One
// work-item: PACKETS * LANES neighbouring rays of a block against all spheres.
#include "sphere.h"

kernel void intersect_closest(global const float* restrict dirs, global const PencilSphere* restrict spheres,
                              const int sphere_count, const int items, global float* restrict ts,
                              global float* restrict normals, global int* restrict ids,
                              global int* restrict hit_counts) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    vec3w dir[PACKETS], center[PACKETS];  // center: of the closest sphere so far
    floatw t[PACKETS];
    intw id[PACKETS];
    FOR_PACKETS(k) {
        dir[k] = load_3(dirs, item, k);
        center[k] = (vec3w){wide(0.0f), wide(0.0f), wide(0.0f)};
        t[k] = wide(INFINITY);
        id[k] = (intw)(-1);
    }
    for (int i = 0; i < sphere_count; ++i) {
        const PencilSphere s = spheres[i];
        FOR_PACKETS(k) {
            const floatw b = dot_f(s.center, dir[k]);
            const floatw discriminant = sphere_discriminant(s, dir[k], b);
            const intw meets = sphere_meets(s, b, discriminant);
            if (!any_lane(meets)) continue;
            const floatw root = sphere_root(s, b, discriminant);
            // Strictly closer: ids ascend, so of equal distances the lowest id stays.
            const intw closer = meets & (root > 0.0f) & (root < t[k]);
            t[k] = closer ? root : t[k];
            id[k] = closer ? (intw)(s.id) : id[k];
            center[k] = select_w(closer, broadcast(s.center), center[k]);
        }
    }
    intw hits = 0;
    FOR_PACKETS(k) {
        const intw hit = id[k] >= 0;
        const vec3w outward = fma_w(t[k], dir[k], (vec3w){-center[k].x, -center[k].y, -center[k].z});
        const floatw scale = divide(wide(1.0f), square_root(dot_w(outward, outward)));
        const vec3w infinite = {wide(INFINITY), wide(INFINITY), wide(INFINITY)};
        store_f(t[k], ts, item, k);
        store_3(select_w(hit, scale_w(scale, outward), infinite), normals, item, k);
        store_i(id[k], ids, item, k);
        hits += hit ? (intw)(1) : (intw)(0);
    }
    hit_counts[item] = sum_lanes(hits);
}
