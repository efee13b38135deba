// What lights give the hits of a packet: shade_light's, for LIGHTS of them at once (-D).
#ifndef GNOMON_SHADING_H
#define GNOMON_SHADING_H

#include "shadow.h"

// Of all spheres.
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

// The radiance `sum` with what arrives of one light, `share` of its phi, and is reflected.
INLINE vec3w reflected(vec3w albedo, Real3 phi, realw share, vec3w sum) {
    const vec3w part = scale_w(share, albedo);
    return (vec3w){fma(part.x, wide(phi.x), sum.x), fma(part.y, wide(phi.y), sum.y), fma(part.z, wide(phi.z), sum.z)};
}

// Where what is shaded lies, and where it goes.
typedef struct {
    Hits hits;
    Hierarchy hierarchy;
    Albedos albedos;
    global real *arrivals, *radiance;
#if RESOLVES
    global int *plane0, *plane1, *plane2;
#endif
} Shaded;

// Of so many lights what arrives is read.
#if SHADOWS == SHADOWS_READ
#define LIGHTS_READ LIGHTS
#else
#define LIGHTS_READ (LIGHTS - 1)
#endif

// work(0), work(1), ... up to all lights: for with an index Mesa's rusticl (22.3) reads wrong arguments.
#define FIRST_1(work) work(0)
#define FIRST_2(work) FIRST_1(work) work(1)
#define FIRST_3(work) FIRST_2(work) work(2)
#define FIRST_4(work) FIRST_3(work) work(3)
#define FOR_LIGHTS(work) CONCAT(FIRST_, LIGHTS)(work)

// What of each light arrives at the hits of packet k.
typedef struct {
    realw share[LIGHTS];
} Arrivals;

INLINE Arrivals arrivals_at(Shaded at, Pass pass, realw traced, int item, int k) {
    Arrivals arrivals;
#define READ(i) arrivals.share[i] = i < LIGHTS_READ ? load_r(arrival_of(at.arrivals, pass, i), item, k) : traced;
    FOR_LIGHTS(READ)
    return arrivals;
}

INLINE wholew lit_by_any(Arrivals arrivals) {
    wholew lit = 0;
#define FIND_LIT(i) lit |= arrivals.share[i] > 0.0f;
    FOR_LIGHTS(FIND_LIT)
    return lit;
}

// The radiance of packet k with what arrives of the lights, at the hits that are lit.
INLINE vec3w add_lights(Shaded at, Shading shading, Arrivals arrivals, wholew lit, int item, int k) {
    vec3w sum = {wide(0.0f), wide(0.0f), wide(0.0f)};
    if (!shading.first) sum = load_3(at.radiance, item, k);
    if (!any_lane(lit)) return sum;
#if ALBEDOS_OF_RAYS
    const vec3w albedo = load_albedo(at.albedos.values, item, k);
#else
    const vec3w albedo = albedo_of(at.albedos, at.hits.ids, item, k, lit);
#endif
#define ADD(i) sum = reflected(albedo, shading.phi[i], arrivals.share[i], sum);
    FOR_LIGHTS(ADD)
    return sum;
}

#endif
