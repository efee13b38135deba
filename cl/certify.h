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
#define EYE_TURN (32 * ROUNDING)  // how far a ray of the eye's may be turned, in radians
#else
#define ROUNDING 0x1p-24f
#define POWER_ROUNDING 0x1p-42f
#define EYE_TURN (5 * ROUNDING)
#endif

// A meeting is plain if D is known to a quarter, and t to 2^-10, of itself. Nearly all are, and need no closer look.
#define PLAIN 0x1p-12f
#define PLAINLY 0x1p-10f

// How far a sphere's numbers, as a pencil has them, may be from the truth.
typedef struct {
    real shift;         // of its centre across and along a ray, and of b = f . dir
    real discriminant;  // of D, wherever D is near 0 or above
    real power;         // of C
    real radius, distance;
} Doubt;

// `turn` is how far a ray may be turned (radians), `base` how far the centre is off before it was rounded.
static inline Doubt doubt_of(PencilSphere s, real turn, real base) {
    // At least |f|, and no more than sqrt(3) times as much.
    const real distance = fabs(s.center.x) + fabs(s.center.y) + fabs(s.center.z), radius = sqrt(s.r2);
    const real shift = distance * (turn + 12 * ROUNDING) + 4 * base;
    return (Doubt){shift, (3 * radius + 3 * shift) * shift + 12 * ROUNDING * s.r2,
                   4 * ROUNDING * fabs(s.power) + 16 * base * distance + POWER_ROUNDING * (distance * distance + s.r2),
                   radius, distance};
}

// The sum of |f_i d_i|.
static inline realw terms_of(vec3w f, vec3w dir) {
    return fma(fabs(dir.x), fabs(f.x), fma(fabs(dir.y), fabs(f.y), fabs(dir.z) * fabs(f.z)));
}

// dq + tau r q / sqrt(D), times sqrt(D): what of a root's error is over sqrt(D) q.
static inline realw root_error(realw b_off, realw discriminant_off, realw radius, realw root, realw q) {
    return fma(b_off, root, fma(radius * EYE_TURN, q, discriminant_off));
}

// Whether a meeting, D > doubt.discriminant, is plain. For small spheres dq / q and the turn are at most 24 u r /
// sqrt(D) while the base is below 2 u |f|.
static inline wholew is_plain(Doubt doubt, PencilSphere s, vec3w dir, real base, realw b, realw discriminant) {
    if (looks_small(s)) {
        const real least = (24 * ROUNDING + 14 * base / doubt.distance) / PLAIN;
        return discriminant > MORE(s.r2 * (least * least), 4 * doubt.discriminant);
    }
    const realw root = sqrt(discriminant), q = fabs(b) + root;
    const realw b_off = fma(wide(9 * ROUNDING), terms_of(broadcast(s.center), dir), wide(base));
    const realw off = fma(fabs(b), 2 * b_off, wide(doubt.power));
    const realw turned = fabs(b) * (2 * doubt.radius * EYE_TURN);
    return (root_error(b_off, off, wide(doubt.radius), root, q) < PLAIN * root * q) &
           (off + turned < 0.25f * discriminant) & (wide(doubt.power) < PLAIN * fabs(wide(s.power)));
}

// How far the root t of a sphere of centre f may be off, if D is known to a quarter and t to 2^-8 of itself, else
// infinitely. At a hit sqrt(D) is |b - t|.
static inline realw root_doubt(vec3w f, vec3w dir, realw t, real base) {
    const realw b = dot_w(f, dir), root = fabs(b - t), q = fabs(b) + root, squared = dot_w(f, f);
    const vec3w out = fma_w(t, dir, (vec3w){-f.x, -f.y, -f.z});
    const realw r2 = dot_w(out, out), radius = sqrt(r2), own = 12 * ROUNDING * r2;
    const realw power = q * t,
                power_off = fma(power, wide(4 * ROUNDING), POWER_ROUNDING * (squared + r2)) + 16 * base * sqrt(squared);
    const realw b_off = fma(wide(9 * ROUNDING), terms_of(f, dir), wide(base));
    const realw of_small = fma(2 * radius, fma(wide(2 * ROUNDING), sqrt(squared), wide(base)), own);
    const realw of_large = fma(fabs(b), 2 * b_off, power_off);
    const realw off = 2 * r2 < squared ? of_small : of_large, turned = fabs(b) * (2 * radius * EYE_TURN);
    const realw error = root_error(b_off, off, radius, root, q);
    const realw share = fma(power_off, root, error * t) / (root * power);
    const wholew known = (share < 4 * PLAIN) & (off + turned < 0.25f * root * root);
    return known ? t * fma(wide(2.5f), share, wide(8 * ROUNDING)) : wide(INFINITY);
}

#endif
