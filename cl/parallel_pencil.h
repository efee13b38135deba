// The shadow pencil of a directional light: all rays run along one axis, so whether one meets a sphere is a question of
// the plane across its axis (is the point in the disc?), without a root. Positions are relative to the eye, in the
// pencil's basis.
#ifndef GNOMON_PARALLEL_PENCIL_H
#define GNOMON_PARALLEL_PENCIL_H

#include "certify.h"
#include "cluster.h"
#include "hits_box.h"
#include "ieee.h"

typedef ParallelPencil LightPencil;

// What a receiver's shadow ray shares among all spheres.
typedef struct {
    vec3w from;     // the receiver in the basis
    realw squared;  // its squared distance from the eye
} ShadowRay;

INLINE ShadowRay shadow_ray(LightPencil light, vec3w position) {
    const vec3w from = {dot_r(light.u, position), dot_r(light.v, position), dot_r(light.axis, position)};
    ShadowRay ray;
    ray.from = from;
    ray.squared = dot_w(from, from);
    return ray;
}

// n . l, the share of the light's irradiance that arrives: > 0 where the surface faces the light.
INLINE realw arriving(LightPencil light, ShadowRay ray, vec3w position, vec3w normal) {
    return dot_r(light.axis, normal);
}

// D = r^2 - |across|^2: >= 0 where the line comes no farther from the centre than the radius.
INLINE realw disc_discriminant(PencilSphere s, ShadowRay ray) {
    const realw x = wide(s.center.x) - ray.from.x, y = wide(s.center.y) - ray.from.y;
    return fma(-x, x, fma(-y, y, wide(s.r2)));
}

// Whether the sphere meets the ray at any t > 0, that is: its line comes closer than the radius, and the farther root
// ahead + sqrt(D) is > 0, with `ahead` the way along the axis from the receiver p to the foot of the centre c.
//   D = r^2 - |across|^2, whose error is a few u r (|p| + |c|), serves spheres that look small, and receivers far away.
//   The receiver's own power |c - p|^2 - r^2 = C - 2 c . p + |p|^2 = ahead^2 - D says on which side of the surface it
//   is (see sphere.h). Its error is a few u |p| (|p| + |c|): less for a sphere that looks large (|c| < 1.5 r) where |p|
//   < r.
INLINE wholew occludes(PencilSphere s, ShadowRay ray) {
    const realw ahead = wide(s.center.z) - ray.from.z, discriminant = disc_discriminant(s, ray);
    const wholew by_disc = (discriminant >= 0.0f) & ((ahead > 0.0f) | (ahead * ahead < discriminant));
    if (looks_small(s)) return by_disc;
    const realw power = wide(s.power) + fma(wide(-2.0f), dot_r(s.center, ray.from), ray.squared);
    const wholew by_power = (power < 0.0f) | ((ahead > 0.0f) & (fma(ahead, ahead, -power) >= 0.0f));
    return choose(ray.squared < wide(s.r2), by_power, by_disc);
}

// Whether it may: where it does not, occludes is 0.
INLINE wholew may_occlude(PencilSphere s, ShadowRay ray) {
    const real within = looks_small(s) ? 0 : s.r2;
    return (disc_discriminant(s, ray) >= 0.0f) | (ray.squared < wide(within));
}

// All shadow rays of a work-item: across the light no wider than this rectangle, and none starts behind `back`.
typedef struct {
    float x0, x1, y0, y1, back;
} FatShadowRay;

// The face (point_pencil.h) from which the rays are told apart: here there is but one.
INLINE int face_of(LightPencil light, const ShadowRay* ray, const wholew* open) { return 0; }

// `open` says which of the rays count.
INLINE FatShadowRay fat_shadow_ray(LightPencil light, int face, const ShadowRay* ray, const wholew* open) {
#if WALK == WALK_SPHERES
    return (FatShadowRay){0};  // nobody looks at it
#endif
    floatw x0 = wide_float(INFINITY), x1 = -x0, y0 = x0, y1 = -x0, back = x0;
    FOR_PACKETS(k) {
        const float3w from = floats_of_3(ray[k].from);
        const intw counts = ints_of(open[k]);
        x0 = LESS_WHERE(counts, from.x, x0);
        x1 = MORE_WHERE(counts, from.x, x1);
        y0 = LESS_WHERE(counts, from.y, y0);
        y1 = MORE_WHERE(counts, from.y, y1);
        back = LESS_WHERE(counts, from.z, back);
    }
    return (FatShadowRay){REDUCE(least, x0), REDUCE(most, x1), REDUCE(least, y0), REDUCE(most, y1),
                          REDUCE(least, back)};
}

#if BOXES
INLINE int face_of_box(LightPencil light, HitsBox box) { return 0; }
INLINE FatShadowRay fat_ray_to_box(LightPencil light, int face, HitsBox box) {
    const Extent extent = extent_of(box, (Basis){light.u, light.v, light.axis});
    return (FatShadowRay){extent.least.x, extent.most.x, extent.least.y, extent.most.y, extent.least.z};
}
#endif

// Which spheres of a cluster may occlude one of the rays, as bits: see reach.h.
INLINE int shadow_candidates(FatShadowRay fat, global const PencilCluster* c) {
#if WALK == WALK_SPHERES
    return filled(c);
#endif
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) {
        const floatb x = floats_at(c->x, first), y = floats_at(c->y, first), z = floats_at(c->z, first);
        const floatb reach = bounds_at(c->reach, first);
        const Beyond beside_x = either(EXCEEDS(x - reach, fat.x1), EXCEEDS(fat.x0, x + reach));
        const Beyond beside_y = either(EXCEEDS(y - reach, fat.y1), EXCEEDS(fat.y0, y + reach));
        kept |= bits_within(either(either(beside_x, beside_y), EXCEEDS(fat.back, z + reach))) << first;
    }
    return kept;
}

// The same for balls around clusters.
INLINE int shadow_ball_candidates(FatShadowRay fat, global const PencilCluster* c) { return shadow_candidates(fat, c); }

// The same for the children of a node.
INLINE int shadow_node_candidates(FatShadowRay fat, global const Node* n) {
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) {
        const Beyond beside = children_beside(n, first, fat.x0, fat.x1, fat.y0, fat.y1);
        kept |= bits_within(either(EXCEEDS(fat.back, bounds_at(n->depth, first)), beside)) << first;
    }
    return kept;
}

#endif
