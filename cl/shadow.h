// The shadow rays of a work-item toward one light: what of it arrives at each hit.
//
// A surface that does not face the light is in its own shadow. One that does leaves its own sphere for good, since a
// ball is convex: that sphere is skipped by id, exactly, and there is no epsilon.
#ifndef GNOMON_SHADOW_H
#define GNOMON_SHADOW_H

#include "certain_shadow.h"
#include "receivers.h"

// The shadow rays of all packets, and what arrives at their hits if nothing is in between. The result is the hits of
// which it is open whether they face the light, as bits of the work-item.
INLINE ulong face_light(Hits hits, LightPencil light, Certainty certainty, int item, ShadowRay* ray, realw* share) {
    wholew open = 0;
    FOR_PACKETS(k) {
        ray[k] = shadow_ray(light, position_of(hits, item, k));
#if CERTIFIED
        share[k] = certainly_unshadowed(hits, light, ray[k], certainty, item, k, &open);
#else
        share[k] = unshadowed(hits, light, ray[k], item, k);
#endif
    }
#if CERTIFIED
    if (UNLIKELY(any_lane(open))) return facing_alone(hits, light, certainty, item);
#endif
    return 0;
}

// Takes from the hits that the sphere occludes what they had; the result is not 0 when there were any. Most spheres
// occlude nothing of a work-item, which is found first, in a third of the work.
INLINE int occlude(PencilSphere s, const ShadowRay* ray, const wholew* id, realw* share) {
    wholew any = 0, changed = 0;
    FOR_PACKETS(k) any |= (share[k] > 0.0f) & (id[k] != s.id) & may_occlude(s, ray[k]);
    if (!any_lane(any)) return 0;
    FOR_PACKETS(k) {
        const wholew closes = (share[k] > 0.0f) & (id[k] != s.id) & occludes(s, ray[k]);
        share[k] = choose(closes, wide(0.0f), share[k]);
        changed |= closes;
    }
    return any_lane(changed);
}

// Traces a group's rays as one fat ray. What occludes others of the work-item on its way may close them too.
INLINE void trace_group(Hits hits, Hierarchy hierarchy, LightPencil light, const ShadowRay* ray, int item,
                        const wholew* id, const wholew* group, realw* share) {
    int face;
    const FatShadowRay fat = fat_ray_of_group(hits, light, ray, group, item, &face);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = shadow_candidates(fat, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (occlude(s, ray, id, share) && !any_still_lit(group, share)) return;
        }
}

// Takes from `left` the hits that are at most sqrt(ratio) times as far from the eye as the nearest: neighbours, in a
// block, whose shadow rays stay together. `far`: squared distances.
INLINE void take_group(const floatw* far, float ratio, wholew* left, wholew* group) {
    floatw nearest = wide_float(INFINITY);
    FOR_PACKETS(k) nearest = LESS_WHERE(ints_of(left[k]), far[k], nearest);
    const floatw limit = wide_float(REDUCE(least, nearest) * ratio);
    FOR_PACKETS(k) {
        group[k] = left[k] & wholes_of(far[k] <= limit);
        left[k] &= !group[k];
    }
}

// ray[k]: the shadow rays of packet k; share[k]: what would arrive at its hits; where something is in between it
// becomes 0. Where there are levels, hits are traced together whose distances from the eye differ by less than the
// factor group_depth (> 1). The result is the hits whose shadow is open, as bits of the work-item.
INLINE ulong trace_shadows(Hits hits, Hierarchy hierarchy, LightPencil light, const ShadowRay* ray, float group_depth,
                           int item, realw* share, Certainty certainty) {
    ulong open = 0;
    wholew id[PACKETS], group[PACKETS];
    FOR_PACKETS(k) id[k] = load_i(hits.ids, item, k);
#if WALK == WALK_NODES
    floatw far[PACKETS];
    wholew left[PACKETS];
    FOR_PACKETS(k) {
        const vec3w position = position_of(hits, item, k);
        far[k] = floats_of(dot_w(position, position));
        left[k] = share[k] > 0.0f;
    }
    while (any_open(left)) {
        take_group(far, group_depth * group_depth, left, group);
#else
    FOR_PACKETS(k) group[k] = share[k] > 0.0f;
    if (any_open(group)) {
#endif
#if CERTIFIED
        open |= trace_certainly(hits, hierarchy, light, ray, certainty, item, id, group, share);
#else
        trace_group(hits, hierarchy, light, ray, item, id, group, share);
#endif
    }
    return open;
}

#endif
