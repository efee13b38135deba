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
    const vec3w f = broadcast(s.center);
    const realw r2 = wide(s.r2), radius = square_root(r2);
    const Twofold f2 = twofold_dot(f, f), square = two_product_w(radius, radius);
    const Twofold difference = two_sum_w(f2.hi, -square.hi);
    const Twofold power = fast_two_sum_w(difference.hi, difference.lo + (f2.lo - square.lo));
    const wholew real_radius = square.hi == r2;
    const realw none = wide(0.0f);
    const wholew real_centre = real_radius & (power.hi == wide(s.power));
    return (SphereRests){real_radius ? square.lo : none, real_centre ? power.lo : none};
}

// By how much |dir|^2 is more than 1.
INLINE realw excess(vec3w dir) {
    const Twofold squared = twofold_dot(dir, dir);
    return (squared.hi - 1.0f) + squared.lo;
}

// D, for `along` = f . dir: r^2 - |f - foot dir|^2, with foot = along / |dir|^2, or b^2 - C.
INLINE Twofold compensated_discriminant(PencilSphere s, SphereRests rests, vec3w dir, Twofold along, realw e,
                                        Twofold b) {
    if (!is_apart(s)) {
        const Twofold square = two_product_w(b.hi, b.hi), difference = two_sum_w(square.hi, wide(-s.power));
        const realw low = fma(2.0f * b.hi, b.lo, square.lo);
        return fast_two_sum_w(difference.hi, difference.lo + (low - rests.power));
    }
    const Twofold foot = fast_two_sum_w(along.hi, fma(along.hi, e * (e - 1.0f), along.lo));
    const Twofold x = twofold_across(wide(s.center.x), foot, dir.x), y = twofold_across(wide(s.center.y), foot, dir.y),
                  z = twofold_across(wide(s.center.z), foot, dir.z);
    const Twofold distance2 = twofold_square_sum(x, y, z), difference = two_sum_w(wide(s.r2), -distance2.hi);
    return fast_two_sum_w(difference.hi, difference.lo + (rests.r2 - distance2.lo));
}

// The distance, and the sign of D. 1 / |dir|^2 and 1 / |dir| are 1 - e + e^2 and 1 - e / 2 + 3/8 e^2, e below 18 u.
INLINE realw compensated_root(PencilSphere s, SphereRests rests, vec3w dir, realw* discriminant) {
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
