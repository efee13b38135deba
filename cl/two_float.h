// Twice float's precision, 16 values at a time: an unevaluated sum hi + lo of two floats. The same bits on every
// device, with or without double. Sums and products here are exact (Knuth, The Art of Computer Programming 2, 4.2.2,
// theorem B; Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18, 1971).
#ifndef GNOMON_TWO_FLOAT_H
#define GNOMON_TWO_FLOAT_H

#include "types.h"

#pragma OPENCL FP_CONTRACT OFF

typedef struct {
    float16 hi, lo;
} TwoFloat;

static inline TwoFloat two_sum(float16 a, float16 b) {
    const float16 sum = a + b, b_part = sum - a;
    return (TwoFloat){sum, (a - (sum - b_part)) + (b - b_part)};
}
static inline TwoFloat two_product(float16 a, float16 b) {
    const float16 product = a * b;
    return (TwoFloat){product, fma(a, b, -product)};
}

// (c + c_rest) - (o + o_rest): the leading difference is exact, so what is lost is 2^-48 of the operands.
static inline TwoFloat two_difference(float16 c, float16 c_rest, float o, float o_rest) {
    const TwoFloat d = two_sum(c, (float16)(-o));
    return two_sum(d.hi, d.lo + (c_rest - o_rest));
}

typedef struct {
    TwoFloat x, y, z;
} TwoFloat3;

// |f|^2 - r^2 for f and r = radius + rest, rounded from a sum with an error of some 2^-46 (|f|^2 + r^2) (Ogita, Rump
// and Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005, algorithm Dot2).
static inline float16 power_of(TwoFloat3 f, float16 radius, float16 rest) {
    const TwoFloat xx = two_product(f.x.hi, f.x.hi), yy = two_product(f.y.hi, f.y.hi);
    const TwoFloat zz = two_product(f.z.hi, f.z.hi), rr = two_product(radius, radius);
    const TwoFloat a = two_sum(xx.hi, yy.hi), b = two_sum(a.hi, zz.hi), c = two_sum(b.hi, -rr.hi);
    const float16 cross = fma(f.x.hi, f.x.lo, fma(f.y.hi, f.y.lo, fma(f.z.hi, f.z.lo, -radius * rest)));
    return c.hi + (((xx.lo + yy.lo) + (zz.lo - rr.lo)) + (a.lo + b.lo + c.lo) + 2.0f * cross);
}

// axis . f, likewise.
static inline float16 along(Float3 axis, TwoFloat3 f) {
    const TwoFloat x = two_product((float16)(axis.x), f.x.hi), y = two_product((float16)(axis.y), f.y.hi);
    const TwoFloat z = two_product((float16)(axis.z), f.z.hi);
    const TwoFloat a = two_sum(x.hi, y.hi), b = two_sum(a.hi, z.hi);
    const float16 low = fma((float16)(axis.x), f.x.lo, fma((float16)(axis.y), f.y.lo, (float16)(axis.z) * f.z.lo));
    return b.hi + ((x.lo + y.lo + z.lo) + (a.lo + b.lo) + low);
}

#endif
