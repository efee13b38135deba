// Spheres in clusters of 16: one of them for all lanes, or one for each lane.
#ifndef GNOMON_CLUSTER_H
#define GNOMON_CLUSTER_H

#include "lanes.h"

// One sphere out of a cluster; the same for all lanes.
typedef struct {
    Real3 center;
    float reach;
    real r2, power;
    int id;
} PencilSphere;

INLINE PencilSphere sphere_of(global const PencilCluster* c, int i) {
    return (PencilSphere){{c->x[i], c->y[i], c->z[i]}, c->reach[i], c->r2[i], c->power[i], c->id[i]};
}

// Whether a sphere looks small from the apex, r^2 < |f|^2 / 2, which is r^2 < C = |f|^2 - r^2.
INLINE int looks_small(PencilSphere s) { return s.r2 < s.power; }

// Whether the apex is well apart from its surface, r^2 < 4/5 |f|^2, which is r^2 < 4 C. It says which formula decides
// whether a line meets it: see sphere.h.
INLINE int is_apart(PencilSphere s) { return s.r2 < 4 * s.power; }

// BOUND_LANES neighbouring values.
INLINE floatb bounds_at(global const float* values, int first) { return *(global const floatb*)(values + first); }
INLINE floatb floats_at(global const real* values, int first) {
#if REAL_IS_DOUBLE
    return convert_floatb(*(global const realb*)(values + first));
#else
    return bounds_at(values, first);
#endif
}
INLINE intb ids_at(global const int* values, int first) { return *(global const intb*)(values + first); }

// Which children of a node lie beside a rectangle, or are none.
INLINE Beyond children_beside(global const Node* n, int first, float x0, float x1, float y0, float y1) {
    const Beyond x = either(EXCEEDS(bounds_at(n->x0, first), x1), EXCEEDS(x0, bounds_at(n->x1, first)));
    const Beyond y = either(EXCEEDS(bounds_at(n->y0, first), y1), EXCEEDS(y0, bounds_at(n->y1, first)));
    return either(either(x, y), beyond_where(ids_at(n->child, first) < 0));
}

// The places that hold a sphere, as bits.
INLINE int filled(global const PencilCluster* c) {
    int places = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) places |= bound_bits(ids_at(c->id, first) >= 0) << first;
    return places;
}

#endif
