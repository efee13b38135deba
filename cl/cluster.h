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
    return (PencilSphere){{c->x[i], c->y[i], c->z[i]}, c->r2[i], c->power[i], c->form[i], c->id[i]};
}

// The position of the lowest bit set.
static inline int lowest_bit(int mask) { return 31 - clz(mask & -mask); }

static inline int spheres_in_cluster(int cluster, int sphere_count) {
    const int rest = sphere_count - cluster * CLUSTER;
    return rest < CLUSTER ? (1 << rest) - 1 : (1 << CLUSTER) - 1;
}

#if LANES > 1
// One value of LANES neighbouring spheres.
static inline floatw cluster_lanes(global const float* values, int first) {
    return *(global const floatw*)(values + first);
}
// A mask's lanes as bits.
static inline int lane_bits(intw mask) { return REDUCE(or, mask & ((intw)(1) << LANE_INDEX)); }
#endif

#endif
