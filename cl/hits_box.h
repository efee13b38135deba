// The box around a block's hits, which stands for them where a light's rays are to be traced as one: intersect_closest
// finds it once for all lights, where a work-item is a block (-D BOXES=1). It holds hits that get no light too, and so
// may let more candidates through than the rays themselves would; it changes time and no bit.
#ifndef GNOMON_HITS_BOX_H
#define GNOMON_HITS_BOX_H

#include "lanes.h"

#if BOXES

// Around the hits so far of each lane.
typedef struct {
    floatw x0, x1, y0, y1, z0, z1;
} LaneBoxes;

INLINE LaneBoxes no_boxes() {
    const floatw least = wide_float(INFINITY), most = -least;
    return (LaneBoxes){least, most, least, most, least, most};
}
INLINE void add_to_boxes(LaneBoxes* b, vec3w position, wholew hits) {
    const float3w p = floats_of_3(position);
    const intw counts = ints_of(hits);
    b->x0 = LESS_WHERE(counts, p.x, b->x0);
    b->x1 = MORE_WHERE(counts, p.x, b->x1);
    b->y0 = LESS_WHERE(counts, p.y, b->y0);
    b->y1 = MORE_WHERE(counts, p.y, b->y1);
    b->z0 = LESS_WHERE(counts, p.z, b->z0);
    b->z1 = MORE_WHERE(counts, p.z, b->z1);
}
INLINE HitsBox box_of(LaneBoxes b) {
    return (HitsBox){{REDUCE(least, b.x0), REDUCE(least, b.y0), REDUCE(least, b.z0)},
                     {REDUCE(most, b.x1), REDUCE(most, b.y1), REDUCE(most, b.z1)}};
}

// The least and the most of each coordinate in a basis: x, y and z are those along u, v and the axis.
typedef struct {
    float4 least, most;
} Extent;

// Rounding is monotonic, and so is fma in each of its operands: with each term at its least, a sum that is rounded as
// dot_r's is at most what dot_r is at any place in the box.
INLINE Extent extent_of(HitsBox box, Basis basis) {
    const float4 x = (float4)(basis.u.x, basis.v.x, basis.axis.x, 0.0f),
                 y = (float4)(basis.u.y, basis.v.y, basis.axis.y, 0.0f),
                 z = (float4)(basis.u.z, basis.v.z, basis.axis.z, 0.0f);
    const float4 x0 = (float4)(box.least.x), x1 = (float4)(box.most.x), y0 = (float4)(box.least.y),
                 y1 = (float4)(box.most.y), z0 = (float4)(box.least.z), z1 = (float4)(box.most.z);
    return (Extent){fma(x, x < 0.0f ? x1 : x0, fma(y, y < 0.0f ? y1 : y0, z * (z < 0.0f ? z1 : z0))),
                    fma(x, x < 0.0f ? x0 : x1, fma(y, y < 0.0f ? y0 : y1, z * (z < 0.0f ? z0 : z1)))};
}

#endif

#endif
