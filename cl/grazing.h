// Rays that graze a sphere, and whose roots are therefore computed in twice the precision (compensated_root.h). A ray
// grazes by its own D alone, so that the bits depend on no other ray.
//
// With x = r / sqrt(D), 1 / the cosine between ray and normal, the t of sphere.h is off in proportion to x, and where
// |D| is small its sign may be wrong. |D| < 2^-12 r^2, x > 64, is grazing: few enough rays to cost next to nothing, and
// more than may have the wrong sign (docs/accuracy.md, "How far t is off").
#ifndef GNOMON_GRAZING_H
#define GNOMON_GRAZING_H

#include "compensated_root.h"

// |D| from which on rays do not graze.
INLINE real grazing_edge(PencilSphere s) {
#if FAST
    return 0;  // no ray grazes
#else
    return 0x1p-12f * s.r2;
#endif
}

// Of rays that may meet the sphere. Doubles are there for their precision: all of them are treated so.
INLINE wholew is_grazing(realw discriminant, real edge) {
#if REAL_IS_DOUBLE
    return (wholew)(-1);
#else
    return discriminant < wide(edge);
#endif
}

#endif
