// Spheres as one pencil sees them: 16 of a cluster in project_spheres, one at a time where they are few and the host
// does it (flat_view.cpp). One text, and so the same bits.
#ifndef GNOMON_PROJECTION_H
#define GNOMON_PROJECTION_H

#include "reach.h"
#include "two_reals.h"

// As a PencilCluster has them.
typedef struct {
    realn x, y, z;
    floatn reach;
    realn r2, power;
} Projected;

// From the apex or, for a parallel light, in its basis from the eye, which is then the apex.
static inline Projected projected(TwoReals3 center, TwoReals radius, Apex apex, ParallelPencil light, int parallel) {
    TwoReals3 f;
    f.x = two_difference(center.x, apex.hi.x, apex.lo.x);
    f.y = two_difference(center.y, apex.hi.y, apex.lo.y);
    f.z = two_difference(center.z, apex.hi.z, apex.lo.z);
    Projected seen;
    seen.x = parallel ? along(light.u, f) : f.x.hi;
    seen.y = parallel ? along(light.v, f) : f.y.hi;
    seen.z = parallel ? along(light.axis, f) : f.z.hi;
    const realn distance = sqrt(fma(seen.x, seen.x, fma(seen.y, seen.y, seen.z * seen.z)));
    seen.reach = reach_of(floats_of_n(radius.hi), floats_of_n(distance));
    seen.r2 = fma(radius.hi, radius.hi, 2.0f * radius.hi * radius.lo);
    seen.power = power_of(f, radius);
    return seen;
}

#endif
