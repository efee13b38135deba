// shade_light: adds lights' Lambert terms, albedo * phi * arrival, to the radiance of the hits that they light.
//
// Of so many LIGHTS, up to four, what arrives at each hit is read, as intersect_shadow wrote it in arrivals. For the
// last it follows, as SHADOWS says, from what intersect_closest wrote and nothing else (SHADOWS_OFF), or from shadow
// rays that are traced here, in the same launch, as intersect_shadow would (SHADOWS_TRACED); with SHADOWS_READ that is
// read too. A pass that writes an arrival ends there: for lights of one kind this kernel is intersect_shadow too, and
// that need not be built. What is not needed is not touched, and what lights share is looked up once. phi is a light's
// irradiance / pi (directional) or power / (4 pi^2) (point). Adds to radiance (3 a ray, block order), or sets it for
// the first lights. Albedos are those of ids or, with -D ALBEDOS_OF_RAYS=1, of the rays in their order. With -D
// RESOLVES=1 the last launch, as `resolve` would, writes the rows of radiance and not their blocks. With -D CERTIFIED=1
// hits of which rounding may decide whether they are lit are left undecided, by doubts and undecided as
// intersect_closest wrote them. One work-item: PACKETS * LANES neighbouring rays; with RESOLVES a pair of blocks, so
// that the memory takes one pair's pixels while the next is computed.
#define WORD real
#define FROM private
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

INLINE vec3w reflected(vec3w albedo, Real3 phi, realw share, vec3w sum) {
    const vec3w part = scale_w(share, albedo);
    return (vec3w){fma(part.x, wide(phi.x), sum.x), fma(part.y, wide(phi.y), sum.y), fma(part.z, wide(phi.z), sum.z)};
}

// Where what is shaded lies.
typedef struct {
    Hits hits;
    Albedos albedos;
    global real *arrivals, *radiance;
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

kernel void shade_light(global const real* restrict dirs, global const real* restrict ts,
                        global const real* restrict normals, global const int* restrict ids,
#if SHADOWS != SHADOWS_OFF
                        global real* arrivals,
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
#if SHADOWS == SHADOWS_OFF
    global real* arrivals = 0;
#endif
    const Shaded at = {
        {dirs, ts, normals, ids}, {albedos + shading.first_albedo, shading.albedo_stride}, arrivals, radiance};
#if RESOLVES
    const Pair pair = pair_of(pass.tile, place);
    const int each = BLOCK_RAYS / (LANES * PACKETS), begin = pair.first * each, end = begin + pair.count * each;
    realw kept[2 * 3 * BLOCK_RAYS / LANES];  // the pair's radiance, which nobody else reads
#else
    const int begin = place, end = begin + 1;
#endif
    ONE_AT_A_TIME for (int item = begin; item < end; ++item) {
        realw share[PACKETS];
#if SHADOWS == SHADOWS_READ
        FOR_PACKETS(k) share[k] = wide(0.0f);
#else
        ShadowRay ray[PACKETS];
        const Certainty certainty = CERTAINTY;
        face_light(at.hits, light, certainty, item, ray, share);
#endif
#if SHADOWS == SHADOWS_TRACED
        const Hierarchy hierarchy = {clusters, nodes, pass.levels, pass.last};
        trace_shadows(at.hits, hierarchy, light, ray, pass.group_depth, item, share, certainty);
#endif
        if (pass.arrival >= 0) {
            FOR_PACKETS(k) store_r(share[k], arrival_of(arrivals, pass, pass.arrival), item, k);
            continue;
        }
        FOR_PACKETS(k) {
            const Arrivals all = arrivals_at(at, pass, share[k], item, k);
            const wholew lit = lit_by_any(all);
            if (!any_lane(lit) && !shading.first && !shading.last) continue;
            const vec3w sum = add_lights(at, shading, all, lit, item, k);
#if RESOLVES
            if (shading.last) {
                keep_3(sum, kept, item - begin, k);
                continue;
            }
#endif
            store_3(sum, radiance, item, k);
        }
    }
#if RESOLVES
    if (shading.last)
        for (int row = 0; row < BLOCK_SIDE; ++row)
            resolve_row((private const real*)kept, 3, pass.tile, shading.planes, pair, row, plane0, plane1, plane2);
#endif
}
