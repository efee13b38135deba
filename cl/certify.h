// What rounding may decide, in the kernels that are built with -D CERTIFIED=1: for each decision a bound of its error,
// derived in docs/accuracy.md. What a bound does not settle is left undecided, to be computed again.
//
// Bounds are one number for a sphere, or for a sphere and a work-item: rays only compare with them. That leaves more
// undecided than a bound for each ray would, but a thousandth of the rays computed again costs less than that.
//
// u = 2^-24. `base` is how far the scene's own numbers may be off, in the frame's unit (pairs of floats hold 48 bits);
// 4 base covers what a sphere and an apex have of it together. All bounds are written so that NaN settles nothing.
#ifndef GNOMON_CERTIFY_H
#define GNOMON_CERTIFY_H

#include "cluster.h"
#include "ieee.h"

// STEEPEST: where the cosine between ray and normal is less than 1 / STEEPEST the sphere is grazed, and nothing is said
// of t. EYE_TURN: how far a ray of the eye's may be turned, in radians. Doubles, in which few rays are computed, leave
// as little as they can.
#if REAL_IS_DOUBLE
#define ROUNDING 0x1p-53
#define POWER_ROUNDING 0x1p-50
#define EYE_TURN (32 * ROUNDING)
#define STEEPEST 0x1p12
#else
#define ROUNDING 0x1p-24f
#define POWER_ROUNDING 0x1p-42f
#define EYE_TURN (5 * ROUNDING)
#define STEEPEST 0x1p7f
#endif

// t is off by less than this, in parts of itself, wherever anything is said of it.
#define MOST_OFF 0x1p-8f

// How far a sphere's numbers, as a pencil has them, may be from the truth.
typedef struct {
    real shift;         // of its centre across and along a ray, and of b = f . dir
    real discriminant;  // of D, wherever D is near 0 or above
    real radius, distance;
} Doubt;

// At least |f|, and no more than sqrt(3) times as much.
static inline real distance_of(PencilSphere s) { return fabs(s.center.x) + fabs(s.center.y) + fabs(s.center.z); }

// Where D is in doubt it is off by this times the shift, and by roundings.
static inline real discriminant_slope(PencilSphere s, real radius, real shift) {
    return (is_apart(s) ? 2 : 3) * radius + 3 * shift;
}

// `turn` is how far a ray may be turned (radians), `base` how far the centre is off before it was rounded.
static inline Doubt doubt_of(PencilSphere s, real turn, real base) {
    const real distance = distance_of(s), radius = root_of(s.r2);
    const real shift = distance * (turn + 12 * ROUNDING) + 4 * base;
    return (Doubt){shift, discriminant_slope(s, radius, shift) * shift + 12 * ROUNDING * s.r2, radius, distance};
}

// What C is off by beside 4 u of itself.
static inline real power_doubt(PencilSphere s, Doubt doubt, real base) {
    return 16 * base * (doubt.distance + doubt.radius) + POWER_ROUNDING * (doubt.distance * doubt.distance + s.r2);
}
// Whether the apex is surely outside the sphere, or surely inside.
static inline int surely_outside(PencilSphere s, real power_off) { return s.power > 2 * power_off; }
static inline int surely_inside(PencilSphere s, real power_off) { return -s.power > 2 * power_off; }

// What may be said of a sphere's roots. With x = r / sqrt(D), 1 / the cosine between ray and normal, t is off by no
// more than steep (1 + x) t.
typedef struct {
    real steep;
    real plain;  // where D is above, the ray surely meets the sphere, and t is known so
    real back;   // elsewhere it is not met before the foot of the centre less this
} RootDoubt;

// Floats take no sphere for plain that is steeper than most are: the numbers of a hit's own sphere need not be kept.
#if !REAL_IS_DOUBLE
#define STEEP_SMALL (64 * ROUNDING)
#define STEEP_LARGE (138 * ROUNDING)
#endif

// `off` is the power's doubt.
static inline RootDoubt root_doubt(PencilSphere s, Doubt doubt, real off) {
    const int outside = surely_outside(s, off);
    const int small = looks_small(s);
    const real steep = (small ? 58 : 98) * ROUNDING + quotient_of(5 * off, fabs(s.power));
    const real least = MORE((real)(1 / STEEPEST), steep * (2 / MOST_OFF));
    const real farthest = outside ? doubt.distance : doubt.distance + doubt.radius;
#if REAL_IS_DOUBLE
    const int known = least <= 1;
#else
    const int known = least <= 1 && steep <= (small ? STEEP_SMALL : STEEP_LARGE);
#endif
    const real plain = known ? MORE(least * least * s.r2, 10 * steep * farthest * doubt.radius) : INFINITY;
    return (RootDoubt){steep, plain, outside && known ? 1.5f * root_of(plain) : INFINITY};
}

// The undecided rays of a picture: a bit each, 32 rays a word, those of a tile from first_word on.
typedef struct {
    global uint* words;
    int first_word;
} Undecided;

// A mask of packet k as bits of its work-item.
static inline ulong bits_of_packet(wholew which, int k) {
    return (ulong)(uint)lane_bits(ints_of(which)) << (k * LANES);
}

static inline void leave_undecided(ulong rays, Undecided undecided, int item) {
    if (!rays) return;
    const uint first = (uint)item * (LANES * PACKETS);
    global uint* word = undecided.words + undecided.first_word + first / 32;
    atomic_or(word, (uint)rays << first % 32);
#if LANES * PACKETS > 32
    atomic_or(word + 1, (uint)(rays >> 32));
#endif
}

#endif
