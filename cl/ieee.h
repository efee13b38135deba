// Divide and square root of reals, correctly rounded on every device; with -D FAST=1 as the device has them.
#ifndef GNOMON_IEEE_H
#define GNOMON_IEEE_H

#include "lanes.h"

#if !REAL_IS_DOUBLE
// From a quotient or root that is a few ulp off (OpenCL C 1.2, table 7.1: 2.5 ulp for x / y, 3 for sqrt) to the
// correctly rounded one. Operands and results must be normal numbers away from the ends of the range.
//
// q: the first residual step brings it within one ulp, where the residual of the second is exact; with a reciprocal
// that is correctly rounded but for rare halves, q + r y then rounds correctly (Markstein, "Computation of elementary
// functions on the IBM RISC System/6000 processor", IBM J. Res. Dev. 34, 1990).
INLINE floatw correct_quotient(floatw a, floatw b, floatw q, floatw reciprocal) {
    const floatw y1 = fma(fma(-b, reciprocal, wide(1.0f)), reciprocal, reciprocal);
    const floatw y = fma(fma(-b, y1, wide(1.0f)), y1, y1);
    const floatw q1 = fma(fma(-q, b, a), y, q);
    return fma(fma(-q1, b, a), y, q1);
}
// s: one step brings it within one ulp; Tuckerman's test then says which of three neighbours is nearest: s- if
// s s- >= a, s+ if s s+ < a, else s. The sign of an fma is exact.
INLINE floatw correct_root(floatw a, floatw s, floatw half_reciprocal) {
    const floatw s1 = fma(fma(-s, s, a), half_reciprocal, s);
    const floatw below = as_floatw(as_intw(s1) - 1), above = as_floatw(as_intw(s1) + 1);
    const intw is_below = fma(-s1, below, a) <= 0.0f, is_above = fma(-s1, above, a) > 0.0f;
    const floatw nearest = is_above ? above : s1;
    return is_below ? below : nearest;
}

#endif

// Doubles are rounded correctly by every device that has them (OpenCL C 1.2, 7.4).
#if REAL_IS_DOUBLE || FAST || defined(CORRECTLY_ROUNDED)
INLINE realw divide(realw a, realw b) { return a / b; }
INLINE realw square_root(realw a) { return sqrt(a); }
#else
INLINE floatw divide(floatw a, floatw b) {
    const floatw q = a / b;
    const floatw corrected = correct_quotient(a, b, q, wide(1.0f) / b);
    const intw finite = (q - q == 0.0f) & (b - b == 0.0f) & (q != 0.0f);  // nothing to correct in inf, NaN and zero
    return finite ? corrected : q;
}
INLINE floatw square_root(floatw a) {
    const floatw s = sqrt(a);
    const floatw corrected = correct_root(a, s, wide(0.5f) / s);
    const intw finite = (a > 0.0f) & (s - s == 0.0f);
    return finite ? corrected : s;
}
#endif

// Of one real. What bounds are made of decides which rays are left undecided, and so the picture's bits.
#if REAL_IS_DOUBLE || FAST || defined(CORRECTLY_ROUNDED)
INLINE real quotient_of(real a, real b) { return a / b; }
INLINE real root_of(real a) { return sqrt(a); }
#elif LANES == 1
INLINE real quotient_of(real a, real b) { return divide(a, b); }
INLINE real root_of(real a) { return square_root(a); }
#else
INLINE real quotient_of(real a, real b) { return divide(wide(a), wide(b)).s0; }
INLINE real root_of(real a) { return square_root(wide(a)).s0; }
#endif

#endif
