// The first root of a line and a sphere (sphere.h) in twice a real's precision (twofold.h): right to little more than
// half an ulp of t for the numbers that a pencil has, whatever the angle between ray and surface, and whatever the
// direction's length lacks of 1.
#ifndef GNOMON_COMPENSATED_ROOT_H
#define GNOMON_COMPENSATED_ROOT_H

#include "ieee.h"
#include "sphere.h"
#include "twofold.h"

// What rounding to r2 and power left over. A radius that is a real comes back as the root of its square; where the
// centre is one too, |f|^2 - r^2 rounds to the power that the sphere has. Where either does not come out so, that
// number was made of others than reals: nothing is known of what rounding left.
typedef struct {
    realw r2, power;
} SphereRests;

INLINE SphereRests rests_of(PencilSphere s) {
    const realw r2 = wide(s.r2), radius = square_root(r2), none = wide(0.0f);
    const Twofold square = two_product_w(radius, radius);
    const wholew real_radius = square.hi == r2;
    const realw r2_rest = choose(real_radius, square.lo, none);
#if !REAL_IS_DOUBLE
    if (is_apart(s)) return (SphereRests){r2_rest, none};  // compensated_root does not look at C
#endif
    const vec3w f = broadcast(s.center);
    const Twofold f2 = twofold_dot(f, f), difference = two_sum_w(f2.hi, -square.hi);
    const Twofold power = fast_two_sum_w(difference.hi, difference.lo + (f2.lo - square.lo));
    const wholew real_centre = real_radius & (power.hi == wide(s.power));
    return (SphereRests){r2_rest, choose(real_centre, power.lo, none)};
}

// By how much |dir|^2 is more than 1: e, below 18 u. 1 / |dir|^2 and 1 / |dir| are 1 - e + e^2 and 1 - e / 2 + 3/8 e^2.
INLINE realw excess(vec3w dir) {
    const Twofold squared = parts_of_dot(dir, dir);
    return (squared.hi - 1.0f) + squared.lo;
}

// |f - foot dir|^2, the squared distance of the centre from the line, with foot = f . dir / |dir|^2.
INLINE Twofold distance2_of(PencilSphere s, vec3w dir, Twofold foot) {
    const Twofold x = twofold_across(wide(s.center.x), foot, dir.x), y = twofold_across(wide(s.center.y), foot, dir.y),
                  z = twofold_across(wide(s.center.z), foot, dir.z);
    return parts_of_square_sum(x, y, z);
}

// Of floats only rays come here with |D| < 2^-12 r^2 (grazing.h), and what is not close is simpler: r^2 and the squared
// distance are within a factor of 2, and their difference is exact (Sterbenz); b > 0.44 |f| and sqrt(D) < r / 64, so
// that b - sqrt(D), the root, loses nothing: three roundings of the size of sqrt(D) are each 2^-6 ulp of it. e^2 is
// 2^-39.
INLINE realw grazing_root_apart(PencilSphere s, SphereRests rests, vec3w dir, realw* discriminant) {
    const Twofold along = parts_of_dot(broadcast(s.center), dir);
    const realw e = excess(dir);
    const Twofold distance2 = distance2_of(s, dir, fast_two_sum_w(along.hi, fma(along.hi, -e, along.lo)));
    *discriminant = (wide(s.r2) - distance2.hi) + (rests.r2 - distance2.lo);
    return along.hi + (fma(along.hi, -0.5f * e, along.lo) - square_root(*discriminant));
}

// r^2 - |f - foot dir|^2 or, close to the sphere, b^2 - C.
INLINE Twofold compensated_discriminant(PencilSphere s, SphereRests rests, vec3w dir, Twofold along, realw e,
                                        Twofold b) {
    if (!is_apart(s)) {
        const Twofold square = two_product_w(b.hi, b.hi), difference = two_sum_w(square.hi, wide(-s.power));
        const realw low = fma(2.0f * b.hi, b.lo, square.lo);
        return fast_two_sum_w(difference.hi, difference.lo + (low - rests.power));
    }
    const Twofold foot = fast_two_sum_w(along.hi, fma(along.hi, e * (e - 1.0f), along.lo));
    const Twofold distance2 = distance2_of(s, dir, foot), difference = two_sum_w(wide(s.r2), -distance2.hi);
    return fast_two_sum_w(difference.hi, difference.lo + (rests.r2 - distance2.lo));
}

// The distance, and the sign of D.
INLINE realw compensated_root(PencilSphere s, SphereRests rests, vec3w dir, realw* discriminant) {
#if !REAL_IS_DOUBLE
    if (is_apart(s)) return grazing_root_apart(s, rests, dir, discriminant);
#endif
    const Twofold along = twofold_dot(broadcast(s.center), dir);
    const realw e = excess(dir);
    const Twofold b = fast_two_sum_w(along.hi, fma(along.hi, e * fma(wide(0.375f), e, wide(-0.5f)), along.lo));
    const Twofold D = compensated_discriminant(s, rests, dir, along, e, b);
    *discriminant = D.hi;
    const realw root = square_root(D.hi), rest = divide(fma(-root, root, D.hi) + D.lo, 2.0f * root);
    const wholew ahead = b.hi > 0.0f;
    const Twofold sum = two_sum_w(b.hi, ahead ? root : -root);
    const realw low = root > 0.0f ? rest : wide(0.0f);
    const Twofold q = fast_two_sum_w(sum.hi, sum.lo + (b.lo + (ahead ? low : -low)));
    const realw power = wide(s.power), inverse = divide(wide(1.0f), q.hi), other = power * inverse;
    const realw residual = fma(-other, q.hi, power) + fma(-other, q.lo, rests.power);
    return choose((power > 0.0f) | !ahead, fma(residual, inverse, other), q.hi);
}

#endif
