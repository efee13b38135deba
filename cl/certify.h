// What rounding may decide, in the kernels that are built with -D CERTIFIED=1: for each decision a bound of its error.
// docs/accuracy.md derives every constant. Decisions that a bound does not settle are left to `refine_*`.
//
// u = 2^-24. `base` is how far the scene's own numbers may be off, in the frame's unit (pairs of floats hold 48 bits);
// 0 < 4 base covers what a sphere and an apex have of it together. All bounds are written so that NaN settles nothing.
#ifndef GNOMON_CERTIFY_H
#define GNOMON_CERTIFY_H

#include "cluster.h"

#if REAL_IS_DOUBLE
#define ROUNDING 0x1p-53
#define POWER_ROUNDING 0x1p-50
#define EYE_TURN (32 * ROUNDING)
#else
#define ROUNDING 0x1p-24f
#define POWER_ROUNDING 0x1p-42f
#define EYE_TURN (5 * ROUNDING)
#endif

// How far a sphere's numbers, as a pencil has them, may be from the truth.
typedef struct {
    real shift;         // of its centre across and along a ray, and of b = f . dir
    real discriminant;  // of D, wherever D is near 0 or above
    real power;         // of C
} Doubt;

// `turn` is how far a ray may be turned (radians), `base` how far the centre is off before it was rounded.
//   shift: the turn takes the centre's foot |f| turn; the centre's rounding is |f| u, and b's dot product 3 |f| u, its
//   ray's length 5 |f| u.
//   D = r^2 - m^2, m the distance of the line from the centre: 2 m shift + shift^2, and m <= r + shift where D's sign
//   is in doubt. D = b^2 - C: |b| <= sqrt(2) r there. r^2, and three fma, 4 u r^2 each at most.
//   C: two_float.h.
static inline Doubt doubt_of(PencilSphere s, real turn, real base) {
    const real squared = MORE(s.power + s.r2, 0.0f), distance = sqrt(squared), radius = sqrt(s.r2);
    const real shift = fma(distance, turn + 12 * ROUNDING, base);
    return (Doubt){shift, fma(fma(radius, (real)3.0f, 3 * shift), shift, 12 * ROUNDING * s.r2),
                   fma(4 * ROUNDING, fabs(s.power), fma(16 * base, distance, POWER_ROUNDING * (squared + s.r2)))};
}

// How far a root may be off, for a ray that is turned by EYE_TURN at most.
//   Rounding. b: centre and dot product round each of its terms 4 times at most, and the ray's length is 5 u off: 9 u
//   of the terms' sum. D = b^2 - C: 2 b db, and C's and its own rounding. D = r^2 - m^2: 2 r dm, dm the centre's
//   rounding, and 12 u r^2 as above. Both of sphere_root's formulas are t = C / q or t = q with q = |b| + sqrt(D), so
//   that |dt| <= t dq / (q - dq) + t dC / C, and dq = db + dD / sqrt(D). Turning. A point at distance t moves by t turn
//   across the ray, and along it by the tangent of the angle between ray and normal, m / sqrt(D), as much. This changes
//   D by 2 b m turn.
// Twice the first-order terms serve while D is known to half of itself; beyond, nothing is known.
static inline realw root_doubt(Doubt doubt, PencilSphere s, vec3w dir, real base, realw b, realw d, realw root,
                               realw t) {
    const real radius = sqrt(s.r2), off = fma(2 * ROUNDING, sqrt(MORE(s.power + s.r2, 0.0f)), base);
    const realw terms = fma(fabs(dir.x), wide(fabs(s.center.x)),
                            fma(fabs(dir.y), wide(fabs(s.center.y)), fabs(dir.z) * fabs(s.center.z)));
    const realw b_off = fma(wide(9 * ROUNDING), terms, wide(base)), q = fabs(b) + root;
    const real own = 12 * ROUNDING * s.r2;
    const realw rounded =
        looks_small(s) ? wide(fma(2 * radius, off, own)) : fma(fabs(b), 2 * b_off, wide(doubt.power + own));
    const realw turned = fabs(b) * (2 * radius * EYE_TURN);
    // Over one denominator, root q, for quotients are slow.
    const realw share = (fma(b_off, root, rounded) + EYE_TURN * radius * q) / (root * q);
    const realw known = t * fma(wide(2.0f), share, wide(fma((real)1.1f, doubt.power / fabs(s.power), 8 * ROUNDING)));
    return rounded + turned < 0.5f * d ? known : wide(INFINITY);
}

#endif
