// Twice a real's precision: an unevaluated sum hi + lo of two reals. The same bits on every device; of floats, without
// double. Sums and products here are exact (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B; Dekker, "A
// floating-point technique for extending the available precision", Numer. Math. 18, 1971).
//
// In kernels 16 values at a time. The host includes this in a class that says what the types are (flat_view.cpp), and
// has one value at a time.
#ifndef GNOMON_TWO_REALS_H
#define GNOMON_TWO_REALS_H

#include "types.h"

#ifndef __cplusplus
#pragma OPENCL FP_CONTRACT OFF
typedef float16 floatn;
#if REAL_IS_DOUBLE
typedef double16 realn;
typedef long16 wholen;
#define reals_of_n(v) convert_double16(v)
#define floats_of_n(v) convert_float16(v)
#define wholes_of_n(v) convert_long16(v)
#define HOLDS_TWO_FLOATS 1
#else
typedef float16 realn;
typedef int16 wholen;
#define reals_of_n(v) (v)
#define floats_of_n(v) (v)
#define wholes_of_n(v) (v)
#define HOLDS_TWO_FLOATS 0
#endif
#endif

typedef struct {
    realn hi, lo;
} TwoReals;

INLINE TwoReals two(realn hi, realn lo) {
    TwoReals sum;
    sum.hi = hi;
    sum.lo = lo;
    return sum;
}

// A number and what rounding to float left over. A double holds their sum exactly: the rest is a multiple of the last
// place of the double that was split, rounded to 24 bits; what that lost is 2^-48 of the number.
INLINE TwoReals number_of(floatn value, floatn rest) {
    return HOLDS_TWO_FLOATS ? two(reals_of_n(value) + reals_of_n(rest), 0.0f)
                            : two(reals_of_n(value), reals_of_n(rest));
}

INLINE TwoReals two_sum(realn a, realn b) {
    const realn sum = a + b, b_part = sum - a;
    return two(sum, (a - (sum - b_part)) + (b - b_part));
}
INLINE TwoReals two_product(realn a, realn b) {
    const realn product = a * b;
    return two(product, fma(a, b, -product));
}

// c - (o + o_rest): the leading difference is exact, so what is lost is u^2 of the operands (u = 2^-24, of
// doubles 2^-53).
INLINE TwoReals two_difference(TwoReals c, real o, real o_rest) {
    const TwoReals d = two_sum(c.hi, (realn)(-o));
    return two_sum(d.hi, d.lo + (c.lo - o_rest));
}

typedef struct {
    TwoReals x, y, z;
} TwoReals3;

// |f|^2 - r^2 for f and r, rounded from a sum with an error of some 4 u^2 (|f|^2 + r^2) (Ogita, Rump
// and Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005, algorithm Dot2).
INLINE realn power_of(TwoReals3 f, TwoReals r) {
    const TwoReals xx = two_product(f.x.hi, f.x.hi), yy = two_product(f.y.hi, f.y.hi);
    const TwoReals zz = two_product(f.z.hi, f.z.hi), rr = two_product(r.hi, r.hi);
    const TwoReals a = two_sum(xx.hi, yy.hi), b = two_sum(a.hi, zz.hi), c = two_sum(b.hi, -rr.hi);
    const realn cross = fma(f.x.hi, f.x.lo, fma(f.y.hi, f.y.lo, fma(f.z.hi, f.z.lo, -r.hi * r.lo)));
    return c.hi + (((xx.lo + yy.lo) + (zz.lo - rr.lo)) + (a.lo + b.lo + c.lo) + 2.0f * cross);
}

// axis . f, likewise.
INLINE realn along(Real3 axis, TwoReals3 f) {
    const TwoReals x = two_product((realn)(axis.x), f.x.hi), y = two_product((realn)(axis.y), f.y.hi);
    const TwoReals z = two_product((realn)(axis.z), f.z.hi);
    const TwoReals a = two_sum(x.hi, y.hi), b = two_sum(a.hi, z.hi);
    const realn low = fma((realn)(axis.x), f.x.lo, fma((realn)(axis.y), f.y.lo, (realn)(axis.z) * f.z.lo));
    return b.hi + ((x.lo + y.lo + z.lo) + (a.lo + b.lo) + low);
}

#endif
