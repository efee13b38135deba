// shade_light: adds one light's Lambert term, albedo * phi * geometry, to the radiance of the hits that it lights.
//
// Reads what intersect_closest wrote with dirs, the albedo of every sphere, and lit where SHADOWS is 1 (where it is 0
// lit is not touched: whatever faces the light is lit). phi is the light's irradiance / pi (directional) or power / (4
// pi^2) (point). Adds to radiance (3 a ray, block order), or sets it for the first light. One work-item: PACKETS *
// LANES rays.
#include "lanes.h"

#include "light_pencil.h"

// The albedo of LANES ids by a loop over the distinct ones, of which neighbours have few: gathers are slower.
static inline vec3w albedo_of(global const Float3* restrict albedos, intw id, intw wanted) {
    vec3w albedo = {wide(0.0f), wide(0.0f), wide(0.0f)};
    for (int next; (next = REDUCE(highest, wanted ? id : (intw)(-1))) >= 0;) {
        const intw same = id == next;
        albedo = select_w(same, broadcast(albedos[next]), albedo);
        wanted = wanted & !same;
    }
    return albedo;
}

kernel void shade_light(global const float* restrict dirs, global const float* restrict ts,
                        global const float* restrict normals, global const int* restrict ids,
                        global const int* restrict lit, global const Float3* restrict albedos, const LightPencil light,
                        const Float3 phi, const int first, const int items, global float* restrict radiance) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    FOR_PACKETS(k) {
        const intw id = load_i(ids, item, k);
        const vec3w normal = load_3(normals, item, k);
        const vec3w position = scale_w(load_f(ts, item, k), load_3(dirs, item, k));
#if SHADOWS
        const intw shines = load_i(lit, item, k) != 0;
#else
        const intw shines = (id >= 0) & (facing(light, position, normal) > 0.0f);
#endif
        const vec3w zero = {wide(0.0f), wide(0.0f), wide(0.0f)};
        vec3w sum = zero;
        if (!first) sum = load_3(radiance, item, k);
        if (any_lane(shines)) {
            const vec3w reflected = scale_w(geometry(light, position, normal), albedo_of(albedos, id, shines));
            const vec3w added = {fma(reflected.x, wide(phi.x), sum.x), fma(reflected.y, wide(phi.y), sum.y),
                                 fma(reflected.z, wide(phi.z), sum.z)};
            sum = select_w(shines, added, sum);
        } else if (!first) {
            continue;
        }
        store_3(sum, radiance, item, k);
    }
}
