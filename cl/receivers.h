// Where the shadow rays of a work-item begin: the hits, as intersect_closest wrote them, and which of them still get
// light.
#ifndef GNOMON_RECEIVERS_H
#define GNOMON_RECEIVERS_H

#include "light_pencil.h"
#include "ray_buffers.h"

#define FAT FatShadowRay
#define NODE_CANDIDATES shadow_node_candidates
#define BALL_CANDIDATES shadow_ball_candidates
#include "hierarchy.h"

// What intersect_closest wrote.
typedef struct {
    global const real *positions, *normals;
    global const int* ids;
#if BOXES
    global const HitsBox* boxes;
#endif
#if CERTIFIED
    global const real* doubts;
    global uint* undecided;
#endif
} Hits;
// A kernel takes HITS_GIVEN as its first arguments; HITS_READ is what they are.
#if BOXES
#define BOXES_GIVEN , global const HitsBox* restrict boxes
#define BOXES_READ .boxes = boxes,
#else
#define BOXES_GIVEN
#define BOXES_READ
#endif
#if CERTIFIED
#define DOUBTS_GIVEN , global const real *restrict doubts, global uint *undecided
#define DOUBTS_READ .doubts = doubts, .undecided = undecided,
#else
#define DOUBTS_GIVEN
#define DOUBTS_READ
#endif
#define HITS_GIVEN                                                              \
    global const real *restrict positions, global const real *restrict normals, \
        global const int *restrict ids BOXES_GIVEN DOUBTS_GIVEN
#define HITS_READ \
    { .positions = positions, .normals = normals, .ids = ids, BOXES_READ DOUBTS_READ }

// What arrives of each of the lights that a launch of shade_light adds, one after the other.
INLINE global real* arrival_of(global real* arrivals, Pass pass, int light) {
    return arrivals + (size_t)light * (size_t)pass.tile.blocks * BLOCK_RAYS;
}

INLINE vec3w position_of(Hits hits, int item, int k) { return load_3(hits.positions, item, k); }

// What arrives (arriving(), > 0) at the hits of packet k if nothing is in between, else 0.
INLINE realw unshadowed(Hits hits, LightPencil light, ShadowRay ray, int item, int k) {
    const wholew hit = load_i(hits.ids, item, k) >= 0;
    if (!any_lane(hit)) return wide(0.0f);
    const realw share = arriving(light, ray, position_of(hits, item, k), load_3(hits.normals, item, k));
    const wholew lit = hit & (share > 0.0f);
    return choose(lit, share, wide(0.0f));
}

// A group's rays as one, from the face of the light that they leave through.
INLINE FatShadowRay fat_ray_of_group(Hits hits, LightPencil light, const ShadowRay* ray, const wholew* group, int item,
                                     int* face) {
#if BOXES
    const HitsBox box = hits.boxes[item];
    *face = face_of_box(light, box);
    return fat_ray_to_box(light, *face, box);
#else
    *face = face_of(light, ray, group);
    return fat_shadow_ray(light, *face, ray, group);
#endif
}

INLINE int any_open(const wholew* open) {
    wholew any = 0;
    FOR_PACKETS(k) any |= open[k];
    return any_lane(any);
}

// Hits of the group at which something arrives yet: of one group, where no nodes are walked down, all that are lit.
INLINE wholew still_lit(const wholew* group, const realw* share, int k) {
#if WALK == WALK_NODES
    return group[k] & (share[k] > 0.0f);
#else
    return share[k] > 0.0f;
#endif
}

// Whether there are any.
INLINE int any_still_lit(const wholew* group, const realw* share) {
    wholew any = 0;
    FOR_PACKETS(k) any |= still_lit(group, share, k);
    return any_lane(any);
}

#endif
