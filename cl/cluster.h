// Spheres in clusters of 16: one of them for all lanes, or one for each lane.
#ifndef GNOMON_CLUSTER_H
#define GNOMON_CLUSTER_H

#include "lanes.h"

// One sphere out of a cluster; the same for all lanes.
typedef struct {
    Float3 center;
    float r2, power;
    int form, id;
} PencilSphere;

static inline PencilSphere sphere_of(global const SphereCluster* c, int i) {
    global const Bounds* b = &c->bounds;
    return (PencilSphere){{b->x[i], b->y[i], b->z[i]}, c->r2[i], c->power[i], c->form[i], b->id[i]};
}

// The position of the lowest bit set.
static inline int lowest_bit(int mask) { return 31 - clz(mask & -mask); }

// LANES neighbouring values.
static inline floatw lanes_at(global const float* values, int first) { return *(global const floatw*)(values + first); }
static inline intw ids_at(global const int* values, int first) { return *(global const intw*)(values + first); }
// A mask's lanes as bits.
static inline int lane_bits(intw mask) { return REDUCE(or, mask & ((intw)(1) << LANE_INDEX)); }

#endif
