// The shadow rays of a work-item in certified pictures: as shadow.h has them, but what rounding may decide is left
// open.
#ifndef GNOMON_CERTAIN_SHADOW_H
#define GNOMON_CERTAIN_SHADOW_H

#include "receivers.h"

#if CERTIFIED

// What is to be known of a work-item's hits, besides those that are undecided already (certify.h): how far what they
// share may be off, and the numbers of each.
typedef struct {
    LightDoubt doubt;
    real curvature, base;
} Certainty;

// The normal is off by what the position is, the centre's rounding, u |f| <= u (t + r), and its own, over the radius.
INLINE LightDoubt doubt_at(LightPencil light, real position, real curvature, real base) {
    const real share = position * curvature;
    const real normal = share < 0.5f ? fma((real)AN_ANGLE, share, 12 * ROUNDING) : INFINITY;
    return light_doubt(light, position, normal, base);
}

INLINE Certainty certainty_of(Hits hits, LightPencil light, Pass pass, int item) {
    const int place = doubts_place(pass.first_block, item);
    const real curvature = hits.doubts[place + 1], base = pass.base_doubt;
    const LightDoubt doubt = doubt_at(light, hits.doubts[place], curvature, base);
    return (Certainty){doubt, curvature, base};
}

// Which hits may not face the light by their own doubts, as bits of the work-item. Few work-items have any: they make
// their rays anew, so that those of hits that are not lit need not be kept.
INLINE ulong facing_alone(Hits hits, LightPencil light, Certainty certainty, int item) {
    ulong left = 0;
    ONE_PACKET_AT_A_TIME(k) {
        const vec3w position = position_of(hits, item, k), normal = load_3(hits.normals, item, k);
        const ShadowRay ray = shadow_ray(light, position);
        const wholew hit = load_i(hits.ids, item, k) >= 0;
        const int open = lane_bits(ints_of(hit & may_face(light, ray, position, normal, certainty.doubt)));
#if DOUBT_RAYS == 1
        left |= (ulong)(uint)open << k * LANES;
#else
        if (!open) continue;
        const realw off = own_position_doubt(position, normal, certainty.curvature, certainty.base);
        for (int rest = open; rest; rest &= rest - 1) {
            const int lane = lowest_bit(rest);
            const LightDoubt own = doubt_at(light, LANE_OF(off, lane), certainty.curvature, certainty.base);
            const int facing = lane_bits(ints_of(may_face(light, ray, position, normal, own))) >> lane & 1;
            left |= (ulong)facing << (k * LANES + lane);
        }
#endif
    }
    return left;
}

// As `unshadowed`; adds the hits that may not face the light by what all have in common to `open`.
INLINE realw certainly_unshadowed(Hits hits, LightPencil light, ShadowRay ray, Certainty certainty, int item, int k,
                                  wholew* open) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return wide(0.0f);
    const vec3w position = position_of(hits, item, k), normal = load_3(hits.normals, item, k);
    *open |= hit & may_face(light, ray, position, normal, certainty.doubt);
    return unshadowed(hits, light, ray, item, k);
}

// Whether any ray of the group may be occluded, found in a third of the work.
INLINE int may_occlude_any(PencilSphere s, const ShadowRay* ray, LineEdge line, const wholew* id, const wholew* group,
                           const realw* share) {
    wholew any = 0;
    FOR_PACKETS(k) any |= still_lit(group, share, k) & (id[k] != s.id) & line_may_meet(s, ray[k], line);
    return any_lane(any);
}

// As `occlude`, for hits of the group, where that is certain; where it is not, `unsure` says so.
INLINE int certainly_occlude(PencilSphere s, const ShadowRay* ray, LightDoubt doubt, RayDoubt most, const wholew* id,
                             const wholew* group, wholew* unsure, realw* share) {
    const LineEdge line = line_edge(s, doubt, most, rough_distance_of(s));
    // A loop for each formula, or LLVM would ask in each round which it is.
    const int may = formula_of_line(s) ? may_occlude_any(s, ray, line, id, group, share)
                                       : may_occlude_any(s, ray, line, id, group, share);
    if (!may) return 0;
    const Edge edge = edge_of(s, doubt, most, line);
    wholew changed = 0;
    FOR_PACKETS(k) {
        const realw doubts = occluded_by(s, ray[k], edge);
        const wholew may = still_lit(group, share, k) & (id[k] != s.id) & !(doubts < -1.0f);
        const wholew closes = may & (doubts > 1.0f);
        unsure[k] |= may & !closes;
        share[k] = choose(closes, wide(0.0f), share[k]);
        changed |= closes;
    }
    return any_lane(changed);
}

#if DOUBT_RAYS > 1
// The same for one ray of a packet, by its own doubts: 1 if it is occluded, 2 if that is open.
INLINE int trace_alone(Hierarchy hierarchy, FatShadowRay fat, RayDoubt most, ShadowRay ray, LightDoubt own, int id,
                       int lane) {
    const RayDoubt alone = own_ray_doubt(own, ray, lane);
    int open = 0;
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = certain_shadow_candidates(fat, most, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (s.id == id) continue;
            const LineEdge line = line_edge(s, own, alone, distance_of(s));
            const realw doubts = occluded_by(s, ray, edge_of(s, own, alone, line));
            if (LANE_OF(doubts, lane) > 1) return 1;
            open |= !(LANE_OF(doubts, lane) < -1);
        }
    return open ? 2 : 0;
}

// Of the rays in `open`, bits of the work-item, those that are open even so; `occluded` gets those that are occluded.
// They are few, and this works on copies, so that everything else stays in registers.
INLINE ulong trace_each_alone(Hits hits, Hierarchy hierarchy, LightPencil light, FatShadowRay fat, RayDoubt most,
                              const ShadowRay* ray, Certainty certainty, int item, ulong open, ulong* occluded) {
    ShadowRay rays[PACKETS];
    FOR_PACKETS(k) rays[k] = ray[k];
    ulong left = 0, closed = 0;
    ONE_PACKET_AT_A_TIME(k) {
        int rest = (int)(open >> k * LANES) & ALL_LANES;
        if (!rest) continue;
        const vec3w position = position_of(hits, item, k), normal = load_3(hits.normals, item, k);
        const realw off = own_position_doubt(position, normal, certainty.curvature, certainty.base);
        for (; rest; rest &= rest - 1) {
            const int lane = lowest_bit(rest), id = hits.ids[lane_address(item, k, 0, 1) + (size_t)lane];
            const LightDoubt own = doubt_at(light, LANE_OF(off, lane), certainty.curvature, certainty.base);
            const ulong found = (ulong)trace_alone(hierarchy, fat, most, rays[k], own, id, lane);
            closed |= (found & 1) << (k * LANES + lane);
            left |= (found >> 1) << (k * LANES + lane);
        }
    }
    *occluded = closed;
    return left;
}
#endif

// As `trace_group`. What is certainly occluded is so whatever else is unsure.
INLINE void trace_certain_group(Hierarchy hierarchy, FatShadowRay fat, RayDoubt most, const ShadowRay* ray,
                                LightDoubt doubt, const wholew* id, const wholew* group, wholew* unsure, realw* share) {
    Traversal traversal = begin(hierarchy, fat);
    for (int c; (c = next_cluster(hierarchy, &traversal, fat)) >= 0;)
        for (int rest = certain_shadow_candidates(fat, most, hierarchy.clusters + c); rest; rest &= rest - 1) {
            const PencilSphere s = sphere_of(hierarchy.clusters + c, lowest_bit(rest));
            if (certainly_occlude(s, ray, doubt, most, id, group, unsure, share) && !any_still_lit(group, share))
                return;
        }
}

// Takes from the hits of a group what is certainly occluded; the result is those that are open, as bits of the
// work-item.
INLINE ulong trace_certainly(Hits hits, Hierarchy hierarchy, LightPencil light, const ShadowRay* ray,
                             Certainty certainty, int item, const wholew* id, const wholew* group, realw* share) {
    int face;
    const FatShadowRay plain = fat_ray_of_group(hits, light, ray, group, item, &face);
    const RayDoubt most = ray_doubt(certainty.doubt, ray, group);
    const FatShadowRay fat = widened(plain, light, face, most);
    hierarchy.nodes += face * (hierarchy.last + 1);  // each face has its own
    wholew unsure[PACKETS];
    FOR_PACKETS(k) unsure[k] = 0;
    trace_certain_group(hierarchy, fat, most, ray, certainty.doubt, id, group, unsure, share);
    wholew any = 0;
    FOR_PACKETS(k) any |= unsure[k] & (share[k] > 0.0f);
    if (!UNLIKELY(any_lane(any))) return 0;
    ulong open = 0;
    FOR_PACKETS(k) open |= bits_of_packet(unsure[k] & (share[k] > 0.0f), k);
#if DOUBT_RAYS > 1
    ulong occluded;
    open = trace_each_alone(hits, hierarchy, light, fat, most, ray, certainty, item, open, &occluded);
    FOR_PACKETS(k) share[k] = choose(lanes_of_bits((int)(occluded >> k * LANES)), wide(0.0f), share[k]);
#endif
    return open;
}

// Once nothing is read any more: before, what a work-item may not need would have to be read as well, since this
// writes.
INLINE void leave_open(ulong open, Hits hits, Pass pass, int item) {
    leave_undecided(open, (Undecided){hits.undecided, pass.first_block}, item);
}

#else
typedef struct {
    int nothing;
} Certainty;
INLINE Certainty certainty_of(Hits hits, LightPencil light, Pass pass, int item) { return (Certainty){0}; }
INLINE void leave_open(ulong open, Hits hits, Pass pass, int item) {}
#endif

#endif
