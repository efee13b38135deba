// Formulas of the smallest t > 0 at which a ray t dir meets a sphere, and of the outward normal there, one function
// each, so that `gnomon report` can measure them side by side. The apex is the origin, |dir| = 1 but for rounding. With
// f = center, a = |dir|^2, b = f . dir and C = |f|^2 - radius^2 the roots solve a t^2 - 2 b t + C = 0.
#ifndef GNOMON_FORMULAS_H
#define GNOMON_FORMULAS_H

#include "certify.h"
#include "grazing.h"

// A miss has t = +inf and the normal (inf, inf, inf).
typedef struct {
    realw t;
    vec3w normal;
} Root;

// near <= far, both roots of a line that meets the sphere where `meets`.
static inline realw first_root(wholew meets, realw near, realw far) {
    const realw t = near > 0.0f ? near : far;
    return (meets & (t > 0.0f)) ? t : wide(INFINITY);
}

// t dir - f, brought to unit length, as intersect_closest has it.
static inline Root with_normal(RootSphere s, vec3w dir, realw t) {
    const vec3w infinite = {wide(INFINITY), wide(INFINITY), wide(INFINITY)};
    const vec3w out = fma_w(t, dir, broadcast((Real3){-s.center.x, -s.center.y, -s.center.z}));
    const vec3w unit = scale_w(divide(wide(1.0f), square_root(dot_w(out, out))), out);
    return (Root){t, select_w(t < wide(INFINITY), unit, infinite)};
}

// B^2 - 4 A C with B = -2 b, as textbooks have it, every operation rounded.
static inline Root intersect_textbook(RootSphere s, vec3w dir) {
    const Float3 f = s.center;
    const realw a = dir.x * dir.x + dir.y * dir.y + dir.z * dir.z;
    const realw b = -2.0f * (f.x * dir.x + f.y * dir.y + f.z * dir.z);
    const float c = f.x * f.x + f.y * f.y + f.z * f.z - s.radius * s.radius;
    const realw discriminant = b * b - 4.0f * a * c;
    const realw root = square_root(discriminant);
    const realw near = divide(-b - root, 2.0f * a), far = divide(root - b, 2.0f * a);
    return with_normal(s, dir, first_root(discriminant >= 0.0f, near, far));
}

// The squared distance of the centre from the line is subtracted from radius^2, and roots of equal sign are not
// subtracted (Hearn and Baker; Haines, Gunther and Akenine-Moller, "Precision improvements for ray/sphere
// intersection", Ray Tracing Gems, 2019, ch. 7, for |dir| = 1). C is computed in float.
static inline Root intersect_perpendicular(RootSphere s, vec3w dir) {
    const Float3 f = s.center;
    const float r2 = s.radius * s.radius, c = fma(f.x, f.x, fma(f.y, f.y, f.z * f.z)) - r2;
    const realw b = dot_r(f, dir);
    const vec3w across = fma_w(-b, dir, broadcast(f));
    const realw discriminant = wide(r2) - dot_w(across, across), root = square_root(discriminant);
    const realw q = b > 0.0f ? b + root : b - root, other = divide(wide(c), q);
    const realw near = b > 0.0f ? other : q, far = b > 0.0f ? q : other;
    return with_normal(s, dir, first_root(discriminant >= 0.0f, near, far));
}

// As kernels have it. No less than the radius is what its reach must be (radius_of).
static inline PencilSphere pencil_sphere(RootSphere s) {
    return (PencilSphere){
        .center = {s.center.x, s.center.y, s.center.z}, .r2 = s.radius * s.radius, .power = s.power, .reach = s.radius};
}

// What every picture is made with: sphere.h, and grazing.h.
static inline Root intersect_pencil(RootSphere s, vec3w dir) {
    const PencilSphere sphere = pencil_sphere(s);
    const realw b = dot_r(s.center, dir), discriminant = sphere_discriminant(sphere, dir, b);
    const real edge = grazing_edge(sphere);
    const wholew meets = may_meet(sphere, b, discriminant, edge), grazes = meets & is_grazing(discriminant, edge);
    realw t = wide(INFINITY);
    if (any_lane(meets & !grazes)) {
        const realw root = sphere_root(sphere, b, discriminant);
        t = choose(meets & !grazes & (root > 0.0f), root, t);
    }
    if (any_lane(grazes)) {
        realw exact;
        const realw root = compensated_root(sphere, rests_of(sphere), dir, &exact);
        t = choose(grazes & (exact >= 0.0f) & (root > 0.0f), root, t);
    }
    return with_normal(s, dir, t);
}

// The perpendicular formula with a, b, C, the vector across and the discriminant to twice float's precision
// (twofold.h). a = 1 + e with e near 2^-24, of which the first order is kept: the second, 2^-48, is below the rest. The
// normal is made of the vector across and the half chord, which lose nothing for how far away the sphere is.
static inline Root intersect_compensated(RootSphere s, vec3w dir) {
    const vec3w f = broadcast(s.center), infinite = {wide(INFINITY), wide(INFINITY), wide(INFINITY)};
    const Twofold a = twofold_dot(dir, dir), along = twofold_dot(f, dir);
    const realw e = (a.hi - 1.0f) + a.lo;
    const Twofold b = fast_two_sum_w(along.hi, fma(-along.hi, e, along.lo));  // b / a, the foot of the centre
    const Twofold x = twofold_across(f.x, b, dir.x), y = twofold_across(f.y, b, dir.y),
                  z = twofold_across(f.z, b, dir.z);
    const Twofold r2 = two_product_w(wide(s.radius), wide(s.radius));
    const Twofold distance2 = twofold_square_sum(x, y, z), f2 = twofold_dot(f, f);
    const Twofold difference = two_sum_w(r2.hi, -distance2.hi), power = two_sum_w(f2.hi, -r2.hi);
    const realw discriminant = difference.hi + (difference.lo + (r2.lo - distance2.lo));
    const realw c = power.hi + (power.lo + (f2.lo - r2.lo));
    const realw half_chord = square_root(discriminant), s_over_a = fma(-0.5f * e, half_chord, half_chord);
    const realw q = b.hi > 0.0f ? b.hi + (b.lo + s_over_a) : b.hi + (b.lo - s_over_a);
    const realw other = divide(fma(-c, e, c), q);
    const realw near = b.hi > 0.0f ? other : q, far = b.hi > 0.0f ? q : other;
    const realw t = first_root(discriminant >= 0.0f, near, far), side = near > 0.0f ? -half_chord : half_chord;
    const vec3w out = {fma(side, dir.x, -x.hi), fma(side, dir.y, -y.hi), fma(side, dir.z, -z.hi)};
    const vec3w unit = scale_w(divide(wide(1.0f), wide(s.radius)), out);
    return (Root){t, select_w(t < wide(INFINITY), unit, infinite)};
}

#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#if LANES == 1
typedef double doublew;
#define to_doublew(v) ((double)(v))
#else
typedef CONCAT(double, LANES) doublew;
#define to_doublew CONCAT(convert_double, LANES)
#endif

// The perpendicular formula in double, rounded to float at the end.
static inline Root intersect_double(RootSphere s, vec3w dir) {
    const double fx = s.center.x, fy = s.center.y, fz = s.center.z, r2 = (double)s.radius * s.radius;
    const double c = fx * fx + fy * fy + fz * fz - r2;
    const doublew dx = to_doublew(dir.x), dy = to_doublew(dir.y), dz = to_doublew(dir.z);
    const doublew a = dx * dx + dy * dy + dz * dz, b = (fx * dx + fy * dy + fz * dz) / a;
    const doublew x = fx - b * dx, y = fy - b * dy, z = fz - b * dz;
    const doublew discriminant = r2 - (x * x + y * y + z * z), root = sqrt(discriminant / a);
    const doublew q = b > 0.0 ? b + root : b - root, other = c / (a * q);
    const doublew near = b > 0.0 ? other : q, far = b > 0.0 ? q : other, t = near > 0.0 ? near : far;
    const doublew side = near > 0.0 ? -root : root, scale = 1.0 / s.radius;
    const doublew hit = discriminant >= 0.0 && t > 0.0 ? t : (doublew)(INFINITY);
    const vec3w unit = {convert_realw((side * dx - x) * scale), convert_realw((side * dy - y) * scale),
                        convert_realw((side * dz - z) * scale)};
    const vec3w infinite = {wide(INFINITY), wide(INFINITY), wide(INFINITY)};
    const realw rounded = convert_realw(hit);
    return (Root){rounded, select_w(rounded < wide(INFINITY), unit, infinite)};
}

// What certified pictures are made with: the pencil's root where the bounds of certify.h settle that the ray meets the
// sphere or misses it, else the one in double.
static inline Root intersect_certified(RootSphere s, vec3w dir) {
    const PencilSphere sphere = pencil_sphere(s);
    const Doubt doubt = doubt_of(sphere, 0);
    const realw b = dot_r(s.center, dir), discriminant = sphere_discriminant(sphere, dir, b);
    const wholew near = may_be_met(sphere, doubt, b, discriminant);
    const wholew plain = near & (discriminant > root_doubt(sphere, doubt).plain), open = near & !plain;
    const vec3w infinite = {wide(INFINITY), wide(INFINITY), wide(INFINITY)};
    const Root root = intersect_pencil(s, dir);
    const Root settled = {choose(plain, root.t, wide(INFINITY)), select_w(plain, root.normal, infinite)};
    if (!any_lane(open)) return settled;
    const Root again = intersect_double(s, dir);
    return (Root){choose(open, again.t, settled.t), select_w(open, again.normal, settled.normal)};
}
#endif

#endif
