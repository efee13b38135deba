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
#include "shading.h"

// The rays of one place: a work-item's, or those of a pair of blocks.
APART void shade(const Shaded* at, const LightPencil* light, const Pass* pass, const Shading* shading, int place) {
#if RESOLVES
    const Pair pair = pair_of(pass->tile, place);
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
        const Certainty certainty = certainty_of(at->hits, *light, *pass, item);
        ulong open = face_light(at->hits, *light, certainty, item, ray, share);
#if SHADOWS == SHADOWS_TRACED
        open |= trace_shadows(at->hits, at->hierarchy, *light, ray, pass->group_depth, item, share, certainty);
#endif
        leave_open(open, at->hits, *pass, item);
#endif
        if (pass->arrival >= 0) {
            FOR_PACKETS(k) store_r(share[k], arrival_of(at->arrivals, *pass, pass->arrival), item, k);
            continue;
        }
        FOR_PACKETS(k) {
            const Arrivals all = arrivals_at(*at, *pass, share[k], item, k);
            const wholew lit = lit_by_any(all);
            if (!any_lane(lit) && !shading->first && !shading->last) continue;
            const vec3w sum = add_lights(*at, *shading, all, lit, item, k);
#if RESOLVES
            if (shading->last) {
                keep_3(sum, kept, item - begin, k);
                continue;
            }
#endif
            store_3(sum, at->radiance, item, k);
        }
    }
#if RESOLVES
    if (shading->last)
        for (int row = 0; row < BLOCK_SIDE; ++row)
            resolve_row((private const real*)kept, 3, pass->tile, shading->planes, pair, row, at->plane0, at->plane1,
                        at->plane2);
#endif
}

kernel void shade_light(HITS_GIVEN,
#if SHADOWS != SHADOWS_OFF
                        global real* arrivals,
#endif
                        global const PencilCluster* restrict clusters, global const Node* restrict nodes,
                        global const float* restrict albedos, global real* radiance,
#if RESOLVES
                        global int* plane0, global int* plane1, global int* plane2,
#endif
                        const LightPencil light, const Pass pass, const Shading shading, const int first_item) {
    const int place = first_item + (int)get_global_id(0);
    if (place >= pass.items) return;
#if SHADOWS == SHADOWS_OFF
    global real* arrivals = 0;
#endif
    const Shaded at = {
        .hits = HITS_READ,
        .hierarchy = {clusters, nodes, pass.levels, pass.last},
        .albedos = {albedos + shading.first_albedo, shading.albedo_stride},
        .arrivals = arrivals,
        .radiance = radiance,
#if RESOLVES
        .plane0 = plane0,
        .plane1 = plane1,
        .plane2 = plane2,
#endif
    };
    shade(&at, &light, &pass, &shading, place);
}
