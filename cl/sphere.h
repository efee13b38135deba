// A line t dir, |dir| = 1, from a pencil's apex against a sphere of centre f and radius r, both seen from that apex.
//
// With b = f . dir and C = |f|^2 - r^2 (the power of the apex) the line meets the sphere where t^2 - 2 b t + C = 0, so
// the roots are b -+ sqrt(D) with D = b^2 - C, and their product is C.
//
// D is a difference of nearly equal numbers in two situations, and no formula serves both:
//   the apex is far from the surface: b^2 and C are both about |f|^2, and their difference loses (|f| / r)^2 ulp.
//     D = r^2 - |f - b dir|^2 subtracts the squared distance of the centre from the line instead (Hearn and Baker;
//     Haines, Gunther and Akenine-Moller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, 2019,
//     ch. 7), in which an error of b counts in the second order only.
//   the apex is near the surface: |f - b dir| is then a difference of two numbers near r. C, rounded once from its
//   exact
//     value, carries the distance to the surface, and b^2 - C loses nothing.
// Of t, whose error is mostly that of b, the first is the better until r^2 is 4/5 |f|^2 (is_apart).
#ifndef GNOMON_SPHERE_H
#define GNOMON_SPHERE_H

#include "cluster.h"
#include "ieee.h"

INLINE realw sphere_discriminant(PencilSphere s, vec3w dir, realw b) {
    if (!is_apart(s)) return fma(b, b, wide(-s.power));
    const vec3w across = fma_w(-b, dir, broadcast(s.center));  // from the line to the centre, shortest way
    return fma(-across.x, across.x, fma(-across.y, across.y, fma(-across.z, across.z, wide(s.r2))));
}

// Whether the line meets the sphere anywhere at t > 0, as far as a D tells that may be off by `edge`: seen from outside
// the centre must lie ahead. No b is <= NaN; one that is NaN has such a D.
INLINE wholew may_meet(PencilSphere s, realw b, realw discriminant, real edge) {
    const real behind = s.power <= 0 ? NAN : 0;
    return (discriminant >= wide(-edge)) & !(b <= wide(behind));
}

// The smallest root > 0 of a line that meets the sphere. Roots of equal sign are never subtracted: the one of larger
// magnitude is q = b +- sqrt(D), with the sign of b, and the other is C / q. From inside, or on the surface, that is
// the far root; where there is none the result is not > 0.
INLINE realw sphere_root(PencilSphere s, realw b, realw discriminant) {
    const realw root = square_root(discriminant);
    const realw q = choose(b > 0.0f, b + root, b - root);
    const realw other = divide(wide(s.power), q);
    return choose(b <= wide(s.power > 0 ? INFINITY : 0), other, q);
}

#endif
