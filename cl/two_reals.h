// Twice a real's precision, 16 values at a time: an unevaluated sum hi + lo of two reals. The same bits on every
// device; of floats, without double. Sums and products here are exact (Knuth, The Art of Computer Programming 2, 4.2.2,
// theorem B; Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18, 1971).
#ifndef GNOMON_TWO_REALS_H
#define GNOMON_TWO_REALS_H

#include "types.h"

#pragma OPENCL FP_CONTRACT OFF

#if REAL_IS_DOUBLE
typedef double16 real16;
typedef long16 wholes16;
#define wholes_of_16(v) convert_long16(v)
#define floats_of_16(v) convert_float16(v)
#else
typedef float16 real16;
typedef int16 wholes16;
#define wholes_of_16(v) (v)
#define floats_of_16(v) (v)
#endif

typedef struct {
    real16 hi, lo;
} TwoReals;

// A number and what rounding to float left over. A double holds their sum exactly: the rest is a multiple of the last
// place of the double that was split, rounded to 24 bits; what that lost is 2^-48 of the number.
static inline TwoReals number_of(float16 value, float16 rest) {
#if REAL_IS_DOUBLE
    return (TwoReals){convert_double16(value) + convert_double16(rest), 0.0f};
#else
    return (TwoReals){value, rest};
#endif
}

static inline TwoReals two_sum(real16 a, real16 b) {
    const real16 sum = a + b, b_part = sum - a;
    return (TwoReals){sum, (a - (sum - b_part)) + (b - b_part)};
}
static inline TwoReals two_product(real16 a, real16 b) {
    const real16 product = a * b;
    return (TwoReals){product, fma(a, b, -product)};
}

// c - (o + o_rest): the leading difference is exact, so what is lost is u^2 of the operands (u = 2^-24, of
// doubles 2^-53).
static inline TwoReals two_difference(TwoReals c, real o, real o_rest) {
    const TwoReals d = two_sum(c.hi, (real16)(-o));
    return two_sum(d.hi, d.lo + (c.lo - o_rest));
}

typedef struct {
    TwoReals x, y, z;
} TwoReals3;

// |f|^2 - r^2 for f and r, rounded from a sum with an error of some 4 u^2 (|f|^2 + r^2) (Ogita, Rump
// and Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005, algorithm Dot2).
static inline real16 power_of(TwoReals3 f, TwoReals r) {
    const TwoReals xx = two_product(f.x.hi, f.x.hi), yy = two_product(f.y.hi, f.y.hi);
    const TwoReals zz = two_product(f.z.hi, f.z.hi), rr = two_product(r.hi, r.hi);
    const TwoReals a = two_sum(xx.hi, yy.hi), b = two_sum(a.hi, zz.hi), c = two_sum(b.hi, -rr.hi);
    const real16 cross = fma(f.x.hi, f.x.lo, fma(f.y.hi, f.y.lo, fma(f.z.hi, f.z.lo, -r.hi * r.lo)));
    return c.hi + (((xx.lo + yy.lo) + (zz.lo - rr.lo)) + (a.lo + b.lo + c.lo) + 2.0f * cross);
}

// axis . f, likewise.
static inline real16 along(Real3 axis, TwoReals3 f) {
    const TwoReals x = two_product((real16)(axis.x), f.x.hi), y = two_product((real16)(axis.y), f.y.hi);
    const TwoReals z = two_product((real16)(axis.z), f.z.hi);
    const TwoReals a = two_sum(x.hi, y.hi), b = two_sum(a.hi, z.hi);
    const real16 low = fma((real16)(axis.x), f.x.lo, fma((real16)(axis.y), f.y.lo, (real16)(axis.z) * f.z.lo));
    return b.hi + ((x.lo + y.lo + z.lo) + (a.lo + b.lo) + low);
}

#endif
