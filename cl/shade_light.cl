// shade_light: adds one light's Lambert term, albedo * phi * arrival, to the radiance of the hits that it lights.
//
// What arrives at each hit follows, as SHADOWS says, from what intersect_closest wrote and nothing else (SHADOWS_OFF);
// from arrival, as intersect_shadow wrote it (SHADOWS_READ); or from shadow rays that are traced here, in the same
// launch, as intersect_shadow would (SHADOWS_TRACED). What is not needed is not touched. phi is the light's irradiance
// / pi (directional) or power / (4 pi^2) (point). Adds to radiance (3 a ray, block order), or sets it for the first
// light. Albedos are those of ids or, with -D ALBEDOS_OF_RAYS=1, of the rays in their order. With -D RESOLVES=1 the
// last light's launch resolves the radiance too, as `resolve` would. With -D CERTIFIED=1 hits of which rounding may
// decide whether they are lit are left undecided, by doubts and undecided as intersect_closest wrote them. One
// work-item: PACKETS * LANES neighbouring rays; with RESOLVES a pair of blocks, so that the memory takes one pair's
// pixels while the next is computed.
#define WORD real
#include "resolve.h"
#include "shadow.h"

typedef struct {
    global const float* values;
    int stride;  // from id to id, 0 where all are the same
} Albedos;

// Those of the ids of packet k, by a loop over the distinct ones, of which neighbours have few: gathers are slower, and
// so is finding the next id in a register.
INLINE vec3w albedo_of(Albedos albedos, global const int* ids, int item, int k, wholew wanted) {
    const wholew id = load_i(ids, item, k);
    vec3w albedo = {wide(0.0f), wide(0.0f), wide(0.0f)};
    for (int rest = lane_bits(ints_of(wanted)); rest;) {
        const int next = ids[lane_address(item, k, 0, 1) + (size_t)lowest_bit(rest)];
        const wholew same = id == next;
        const float3 found = vload3(0, albedos.values + (size_t)next * albedos.stride);
        albedo = select_w(same, broadcast((Real3){found.x, found.y, found.z}), albedo);
        rest &= ~lane_bits(ints_of(same));
    }
    return albedo;
}

#if ALBEDOS_OF_RAYS
// Those of packet k: three floats a ray.
INLINE vec3w load_albedo(global const float* p, int item, int k) {
    return (vec3w){convert_realw(*(global const floatw*)(p + lane_address(item, k, 0, 3))),
                   convert_realw(*(global const floatw*)(p + lane_address(item, k, 1, 3))),
                   convert_realw(*(global const floatw*)(p + lane_address(item, k, 2, 3)))};
}
#endif

// Adds what the light gives the hits of packet k, of which `share` arrives.
INLINE void add_light(Hits hits, Albedos albedos, Real3 phi, realw share, int first, int item, int k,
                      global real* radiance) {
    const wholew lit = share > 0.0f;
    const int any_lit = any_lane(lit);
    if (!any_lit && !first) return;
    vec3w sum = {wide(0.0f), wide(0.0f), wide(0.0f)};
    if (!first) sum = load_3(radiance, item, k);
    if (any_lit) {
#if ALBEDOS_OF_RAYS
        const vec3w albedo = load_albedo(albedos.values, item, k);
#else
        const vec3w albedo = albedo_of(albedos, hits.ids, item, k, lit);
#endif
        const vec3w reflected = scale_w(share, albedo);
        sum = (vec3w){fma(reflected.x, wide(phi.x), sum.x), fma(reflected.y, wide(phi.y), sum.y),
                      fma(reflected.z, wide(phi.z), sum.z)};
    }
    store_3(sum, radiance, item, k);
}

kernel void shade_light(global const real* restrict dirs, global const real* restrict ts,
                        global const real* restrict normals, global const int* restrict ids,
#if SHADOWS == SHADOWS_READ
                        global const real* restrict arrival,
#endif
                        global const PencilCluster* restrict clusters, global const Node* restrict nodes,
                        global const float* restrict albedos, global real* radiance,
#if RESOLVES
                        global int* plane0, global int* plane1, global int* plane2,
#endif
#if CERTIFIED
                        global const real* restrict doubts, global uint* undecided,
#endif
                        const LightPencil light, const Pass pass, const Shading shading, const int first_item) {
    const int place = first_item + (int)get_global_id(0);
    if (place >= pass.items) return;
#if RESOLVES
    const Pair pair = pair_of(pass.tile, place);
    const int each = BLOCK_RAYS / (LANES * PACKETS), begin = pair.first * each, end = begin + pair.count * each;
#else
    const int begin = place, end = begin + 1;
#endif
    ONE_AT_A_TIME for (int item = begin; item < end; ++item) {
        const Hits hits = {dirs, ts, normals, ids};
        realw share[PACKETS];
#if SHADOWS == SHADOWS_READ
        FOR_PACKETS(k) share[k] = load_r(arrival, item, k);
#else
        ShadowRay ray[PACKETS];
#if CERTIFIED
        const Certainty certainty =
            certainty_of(light, doubts, pass.base_doubt, (Undecided){undecided, pass.first_block}, item);
        ulong open = 0;
#else
        const Certainty certainty = {0};
#endif
        FOR_PACKETS(k) {
            ray[k] = shadow_ray(light, position_of(hits, item, k));
#if CERTIFIED
            share[k] = certainly_unshadowed(hits, light, ray[k], certainty, item, k, &open);
#else
            share[k] = unshadowed(hits, light, ray[k], item, k);
#endif
        }
#if CERTIFIED
        if (UNLIKELY(open))
            leave_undecided(facing_alone(hits, light, ray, certainty, item, open), certainty.undecided, item);
#endif
#endif
#if SHADOWS == SHADOWS_TRACED
        const Hierarchy hierarchy = {clusters, nodes, pass.levels, pass.last};
        trace_shadows(hits, hierarchy, light, ray, pass.group_depth, item, share, certainty);
#endif
        const Albedos all = {albedos + shading.first_albedo, shading.albedo_stride};
        FOR_PACKETS(k) add_light(hits, all, shading.phi, share[k], shading.first, item, k, radiance);
    }
#if RESOLVES
    if (shading.last)
        for (int row = 0; row < BLOCK_SIDE; ++row)
            resolve_row(radiance, 3, pass.tile, shading.planes, pair, row, plane0, plane1, plane2);
#endif
}
