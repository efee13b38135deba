// Twice float's precision in lanes: an unevaluated sum hi + lo, as two_reals.h has it for the spheres of a cluster.
// Exact sums and products are Knuth's and Dekker's (see there); dot products are Dot2 (Ogita, Rump and Oishi, "Accurate
// sum and dot product", SIAM J. Sci. Comput. 26, 2005), off by some 2^-46 of the sum of the products' magnitudes.
#ifndef GNOMON_TWOFOLD_H
#define GNOMON_TWOFOLD_H

#include "lanes.h"

typedef struct {
    realw hi, lo;
} Twofold;

INLINE Twofold two_sum_w(realw a, realw b) {
    const realw sum = a + b, b_part = sum - a;
    return (Twofold){sum, (a - (sum - b_part)) + (b - b_part)};
}
// For |a| >= |b|, or a = 0.
INLINE Twofold fast_two_sum_w(realw a, realw b) {
    const realw sum = a + b;
    return (Twofold){sum, b - (sum - a)};
}
INLINE Twofold two_product_w(realw a, realw b) {
    const realw product = a * b;
    return (Twofold){product, fma(a, b, -product)};
}

// Dot products whose lo may still be some ulp of hi.
INLINE Twofold parts_of_dot(vec3w a, vec3w b) {
    const Twofold x = two_product_w(a.x, b.x), y = two_product_w(a.y, b.y), z = two_product_w(a.z, b.z);
    const Twofold xy = two_sum_w(x.hi, y.hi), xyz = two_sum_w(xy.hi, z.hi);
    return (Twofold){xyz.hi, (xy.lo + xyz.lo) + (x.lo + y.lo + z.lo)};
}
INLINE Twofold twofold_dot(vec3w a, vec3w b) {
    const Twofold parts = parts_of_dot(a, b);
    return fast_two_sum_w(parts.hi, parts.lo);
}

// f - b dir, one component.
INLINE Twofold twofold_across(realw f, Twofold b, realw dir) {
    const Twofold product = two_product_w(b.hi, dir), difference = two_sum_w(f, -product.hi);
    return fast_two_sum_w(difference.hi, difference.lo - fma(b.lo, dir, product.lo));
}

// x^2 + y^2 + z^2, likewise.
INLINE Twofold parts_of_square_sum(Twofold x, Twofold y, Twofold z) {
    const Twofold xx = two_product_w(x.hi, x.hi), yy = two_product_w(y.hi, y.hi), zz = two_product_w(z.hi, z.hi);
    const Twofold xy = two_sum_w(xx.hi, yy.hi), xyz = two_sum_w(xy.hi, zz.hi);
    const realw cross = 2.0f * fma(x.hi, x.lo, fma(y.hi, y.lo, z.hi * z.lo));
    return (Twofold){xyz.hi, (xy.lo + xyz.lo) + (xx.lo + yy.lo + zz.lo) + cross};
}
INLINE Twofold twofold_square_sum(Twofold x, Twofold y, Twofold z) {
    const Twofold parts = parts_of_square_sum(x, y, z);
    return fast_two_sum_w(parts.hi, parts.lo);
}

#endif
