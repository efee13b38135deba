// What rounding may decide, in the kernels that are built with -D CERTIFIED=1: for each decision a bound of its error,
// derived in docs/accuracy.md. What a bound does not settle is left undecided, to be computed again.
//
// Most bounds are one number for a sphere and a work-item: rays only compare with them. What they settle, a ray's own
// bound would settle too, and what they leave is held against that, so that nothing depends on LANES.
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
#define STEEPEST 0x1p16
#else
#define ROUNDING 0x1p-24f
#define POWER_ROUNDING 0x1p-43f
#define EYE_TURN (5 * ROUNDING)
#define STEEPEST 0x1p10f
#endif

// t is off by less than this, in parts of itself, wherever anything is said of it.
#define MOST_OFF 0x1p-8f

// Where a vector is off by less than half its length, it is turned by no more than this times that over its length:
// arc sine of 1/2 is 1.0472 times that.
#define AN_ANGLE 1.0625f

// How far a sphere's numbers, as a pencil has them, may be from the truth.
typedef struct {
    real shift;         // of its centre across and along a ray, and of b = f . dir
    real discriminant;  // of D, wherever D is near 0 or above
    real power;         // of C, beside 4 u of itself
    real radius, distance;
} Doubt;

// At least |f|, and hardly more. 2^-124 so that squares count that vanish.
INLINE real distance_of(PencilSphere s) {
    const Real3 f = s.center;
    const real squared = fma(f.x, f.x, fma(f.y, f.y, fma(f.z, f.z, (real)0x1p-124f)));
    return (1 + 4 * ROUNDING) * root_of(squared);
}
// At least |f|, and no more than sqrt(3) times as much, sooner.
INLINE real rough_distance_of(PencilSphere s) { return fabs(s.center.x) + fabs(s.center.y) + fabs(s.center.z); }

// At least r: of floats, which have no root at hand, more by 2^-17 |f|.
INLINE real radius_of(PencilSphere s) {
#if REAL_IS_DOUBLE
    return root_of(s.r2);
#else
    return s.reach;
#endif
}

// Where D is in doubt it is off by this times the shift, and by the rest of a sphere's own roundings.
typedef struct {
    real slope;  // but for 4 times the shift
    real rest;
} DiscriminantDoubt;

INLINE DiscriminantDoubt discriminant_doubt(PencilSphere s, real radius, real power_off) {
    if (is_apart(s)) return (DiscriminantDoubt){2 * radius, 12 * ROUNDING * s.r2};
    const real power = fabs(s.power);
    return (DiscriminantDoubt){2 * root_of(power), fma(12 * ROUNDING, power, 2 * power_off)};
}

// What C is off by beside 4 u of itself.
INLINE real power_doubt(PencilSphere s, real distance, real radius, real base) {
    return 16 * base * (distance + radius) + POWER_ROUNDING * (distance * distance + s.r2);
}
// A little less than 1 over a doubt, so that what is more than 1 when multiplied by it is sure (docs/accuracy.md).
INLINE real inverse_of(real doubt) { return quotient_of(1 - 4 * ROUNDING, doubt); }

// Whether the apex is surely outside the sphere, or surely inside.
INLINE int surely_outside(PencilSphere s, real power_off) { return s.power > 2 * power_off; }
INLINE int surely_inside(PencilSphere s, real power_off) { return -s.power > 2 * power_off; }

// Where it is not sure that the sphere is missed: D may be 0 or above and, from outside, the centre may lie ahead.
INLINE wholew may_be_met(PencilSphere s, Doubt doubt, realw b, realw discriminant) {
    const real behind = surely_outside(s, doubt.power) ? -doubt.shift : -INFINITY;
    return !((discriminant < -doubt.discriminant) | (b < behind));
}

// Seen from the eye, whose place is off by `base`.
INLINE Doubt doubt_of(PencilSphere s, real base) {
    const real distance = distance_of(s), radius = radius_of(s);
    const real shift = fma(EYE_TURN + 12 * ROUNDING, distance, 4 * base);
    const real power = power_doubt(s, distance, radius, base);
    const DiscriminantDoubt of = discriminant_doubt(s, radius, power);
    return (Doubt){shift, fma(fma((real)4, shift, of.slope), shift, of.rest), power, radius, distance};
}

// What may be said of a sphere's roots. With x = r / sqrt(D), 1 / the cosine between ray and normal, t is off by no
// more than steep (1 + x) t.
typedef struct {
    real steep;
    real plain;  // where D is above, the ray surely meets the sphere, and t is known so
    real back;   // elsewhere it is not met before the foot of the centre less this
} RootDoubt;

// Floats take no sphere for plain that is steeper than most are: the numbers of a hit's own sphere need not be kept.
#if !REAL_IS_DOUBLE
#define MOST_STEEP (40 * ROUNDING)
#endif

INLINE RootDoubt root_doubt(PencilSphere s, Doubt doubt) {
    const int outside = surely_outside(s, doubt.power);
    const real steep = 25 * ROUNDING + EYE_TURN + quotient_of(3 * doubt.power, fabs(s.power));
    const real least = MORE((real)(1 / STEEPEST), steep * (2 / MOST_OFF));
    const real inside = doubt.distance + doubt.radius;
    const real farthest = is_apart(s) ? doubt.distance : outside ? root_of(s.power) : inside;
#if REAL_IS_DOUBLE
    const int known = least <= 1;
#else
    const int known = least <= 1 && steep <= MOST_STEEP;
#endif
    const real plain = known ? MORE(least * least * s.r2, 10 * steep * farthest * doubt.radius) : INFINITY;
    return (RootDoubt){steep, plain, outside && known ? fma((real)1.5f, root_of(plain), doubt.shift) : INFINITY};
}

// At least 1 / x, and no more than 9/8 of it, for x > 0 that is no smaller than 2^-126. With x = 2^e (1 + m), the
// difference of the bits is 2^(-e - 1) (2 - m), and (1 + m) (2 - m) / 2 lies between 1 and 9/8.
INLINE realw reciprocal_bound(realw x) {
#if REAL_IS_DOUBLE
    return divide(wide(1.0f), x);
#else
    return as_floatw(0x7f000000 - as_intw(x));
#endif
}

// How far the position of a plain meeting may be off: by t's doubt along the ray and, the ray's turn and two roundings,
// by 8 u t across it; 12 u t more is what a light's pencil rounds (parallel_pencil.h). cosine: between ray and normal,
// at least.
INLINE realw position_doubt(realw t, realw cosine, real steep, real base) {
    return fma(t, fma(wide(1.3f * steep), reciprocal_bound(cosine), wide(steep + 20 * ROUNDING)), wide(base));
}

#if !REAL_IS_DOUBLE
// The same of a hit, as intersect_closest wrote it, with its own steepness: the cosine that is found from that is off
// by 4 u, and from the ray's turn (6 u) and the normal's doubt (certain_shadow.h) by no more than `turned`; and 1.3
// over it is enough whatever it is. What hits share is by more above position_doubt, so that it is no less than any of
// them has.
INLINE realw own_position_doubt(vec3w position, vec3w normal, real curvature, real base) {
    const realw t = square_root(dot_w(position, position)), cosine = divide(fabs(dot_w(position, normal)), t);
    const realw first = position_doubt(t, cosine, MOST_STEEP, base);
    const realw turned = fma(wide(AN_ANGLE * curvature), first, wide(24 * ROUNDING));
    const realw loose = (1 / 1.3f) * cosine, sharp = cosine - turned;
    const realw least = choose(sharp > loose, sharp, loose);
    return fma(t, divide(wide(MOST_STEEP), least) + (MOST_STEEP + 20 * ROUNDING), wide(base));
}
#define SHARED_DOUBT 1.01f
#endif

// The undecided rays of a picture: a bit each, 32 rays a word, those of a tile from that of first_block on.
typedef struct {
    global uint* words;
    int first_block;
} Undecided;

// A mask of packet k as bits of its work-item.
INLINE ulong bits_of_packet(wholew which, int k) { return (ulong)(uint)lane_bits(ints_of(which)) << (k * LANES); }

#if CERTIFIED
// What lights must know of hits that are not undecided, of DOUBT_RAYS neighbouring rays together (those of a block, or
// each ray alone, so that it does not depend on LANES): how far the position of any may be off, and the most curved
// sphere, 1 / radius, as far as the normal tells. Where they are several work-items', both are 0 before.
INLINE int doubts_place(int first_block, int item) {
    return 2 * (int)(((ulong)first_block * BLOCK_RAYS + (ulong)item * (LANES * PACKETS)) / DOUBT_RAYS);
}
#if REAL_IS_DOUBLE
#define MOST_OF(v) (v)  // each ray alone
#else
#define MOST_OF(v) REDUCE(most, v)
#endif
INLINE void keep_doubts(realw position, realw curvature, global real* doubts, int place) {
#if DOUBT_RAYS > 1
    position *= SHARED_DOUBT;
#endif
#if LANES * PACKETS >= DOUBT_RAYS
    doubts[place] = MOST_OF(position);
    doubts[place + 1] = MOST_OF(curvature);
#else
    atomic_max((global int*)(doubts + place), as_int(MOST_OF(position)));  // floats >= 0 are ordered as their bits
    atomic_max((global int*)(doubts + place + 1), as_int(MOST_OF(curvature)));
#endif
}
#endif

INLINE void leave_undecided(ulong rays, Undecided undecided, int item) {
    if (!UNLIKELY(rays)) return;
    const uint first = (uint)item * (LANES * PACKETS);
    global uint* word = undecided.words + undecided.first_block * (BLOCK_RAYS / 32) + first / 32;
    atomic_or(word, (uint)rays << first % 32);
#if LANES * PACKETS > 32
    atomic_or(word + 1, (uint)(rays >> 32));
#endif
}

// Says which rays of a block are undecided, before anybody adds to them, or adds those of what is not all of it.
INLINE void say_undecided(ulong rays, Undecided undecided, int item) {
#if IS_BLOCK
    global uint* word = undecided.words + (undecided.first_block + item) * (BLOCK_RAYS / 32);
    word[0] = (uint)rays;
    word[1] = (uint)(rays >> 32);
#else
    leave_undecided(rays, undecided, item);
#endif
}

#endif
