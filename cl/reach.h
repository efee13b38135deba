// How far a sphere may reach: its radius, widened so that no conservative test (fat_ray.h, parallel_pencil.h, bounds.h)
// passes over a sphere that an exact test (sphere.h, parallel_pencil.h, point_pencil.h) accepts.
//
// In units of u |f|, u = 2^-24, |f| the distance of the centre from the apex, for spheres with |f| >= r:
//
//    8  an exact test accepts lines that pass at most this far outside the sphere: sphere_discriminant's `across` is
//       3 roundings on values up to |f|; b^2 - C, wrong by at most 4 |f|^2, moves the distance by 4 |f|^2 / (2 r),
//       which is less than 3 |f| where r^2 >= |f|^2 / 2
//   15  a ray's X = d . u / d . axis: two dot products of 3 roundings each, two for 1 / z and the product, 1 for each
//       unit vector. X is then the exact coordinate of a direction that is turned by at most 11 of these units; its ray
//       meets the sphere at a distance of at most |f| + r <= 2 |f|, but only the part across it counts, at the foot of
//       the centre, at most |f|. The same for Y, both at right angles: 11 sqrt(2) < 16.
//   13  planes: a normal is 4 roundings off, its dot product with f 3 more; rectangles: the coordinates p = f . u and
//       z = f . axis are 3 each, p +- reach and z -+ reach 1 each, and the quotient 1, which is a coordinate's
//
// Together 37 < 128: reach = r + 2^-17 max(|f|, r) leaves room for the roundings of |f| and of reach itself, and for
// certified pictures, in which what is passed over must be clear of a ray by more (docs/accuracy.md). Spheres with
// |f| < r hold the apex; seen from there nothing is farther than 2 r, and the same holds with r for |f|.
// In a parallel pencil occludes() accepts rays that pass at most 8 u max(|c|, r) outside, and the sums round once.
//
// A light's rays may be bounded by the box around a block's hits instead (hits_box.h). Its coordinates in a basis hold
// those of all hits with the roundings that these have, 3 each, and X has one quotient more: fewer than the 11 of a
// ray.
//
// A ball around a cluster (flat_clusters.cpp), of centre F and radius R, is passed over in the same way, and with it
// the spheres inside, whose max(|f|, r) is at most |F| + R. It is larger by 2^-14 R, 1024 u R, than they need: with the
// 128 u |F| of its own reach these are as clear of the rays as if they had been tested themselves.
//
// All of this holds where reals are doubles too: exact tests then accept less, and bounds are floats as before, of
// which some were rounded once more. These are, in the same units: the radius and the distance of which reach is made,
// 1 each; the centre, 1; a ray's direction, 1; and the farthest t or distance (at most |f| + r) 2 or, in a parallel
// pencil, a receiver's coordinates (where they decide no farther from 0 than |c| + r) 2. Together that is 6, and
// 37 + 6 < 128.
//
// And on devices that do not round quotients and roots correctly, whose quotients are off by up to 2.5 ulp, 5 u, and
// roots by 3 ulp, 6 u (OpenCL C 1.2, table 7.1). A ray's X has one quotient: 15 and not 11 of those units, 15 sqrt(2) <
// 22 instead of 16. A plane's normal has a quotient and a root: 13 and not 4, with the dot product 16; a rectangle's
// quotient is 5 and not 1: 17 and not 13. Together 8 + 22 + 17 = 47, in double 53 < 128. The distance of which reach is
// made is off by 6 u of itself, which is 2^-21 of what is added, and a node's depth by 6 u |f|, which alone is less.
#ifndef GNOMON_REACH_H
#define GNOMON_REACH_H

#include "two_reals.h"

static inline floatn reach_of(floatn radius, floatn distance) {
    return fma(distance > radius ? distance : radius, (floatn)(0x1p-17f), radius);
}

#endif
