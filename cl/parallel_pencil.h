// The shadow pencil of a directional light: all rays run along dir, so whether one meets a sphere is a question of the
// plane across dir (is the point in the disc?), without a root. Positions are relative to the eye, in the basis (u, v,
// dir).
#ifndef GNOMON_PARALLEL_PENCIL_H
#define GNOMON_PARALLEL_PENCIL_H

#include "cluster.h"
#include "ieee.h"

typedef ParallelPencil LightPencil;

// What a receiver's shadow ray shares among all spheres.
typedef struct {
    vec3w from;      // the receiver in the basis (u, v, dir)
    floatw squared;  // its squared distance from the eye
} ShadowRay;

static inline ShadowRay shadow_ray(LightPencil light, vec3w position) {
    const vec3w from = {dot_f(light.u, position), dot_f(light.v, position), dot_f(light.dir, position)};
    return (ShadowRay){from, dot_w(from, from)};
}

// n . l, the share of the light's irradiance that arrives: > 0 where the surface faces the light.
static inline floatw arriving(LightPencil light, vec3w position, vec3w normal) { return dot_f(light.dir, normal); }

// Whether the sphere meets the ray at any t > 0, that is: its line comes closer than the radius, and the farther root
// ahead + sqrt(D) is > 0, with `ahead` the way along dir from the receiver p to the foot of the centre c.
//   D = r^2 - |across|^2, whose error is a few u r (|p| + |c|), serves spheres that look small, and receivers far away.
//   The receiver's own power |c - p|^2 - r^2 = C - 2 c . p + |p|^2 = ahead^2 - D says on which side of the surface it
//   is (see sphere.h). Its error is a few u |p| (|p| + |c|): less for a sphere that looks large (|c| < 1.5 r) where |p|
//   < r.
static inline intw occludes(PencilSphere s, ShadowRay ray) {
    const floatw ahead = wide(s.center.z) - ray.from.z;
    const floatw x = wide(s.center.x) - ray.from.x, y = wide(s.center.y) - ray.from.y;
    const floatw discriminant = fma(-x, x, fma(-y, y, wide(s.r2)));
    const intw by_disc = (discriminant >= 0.0f) & ((ahead > 0.0f) | (ahead * ahead < discriminant));
    if (s.form == FORM_SMALL) return by_disc;
    const floatw power = wide(s.power) + fma(wide(-2.0f), dot_f(s.center, ray.from), ray.squared);
    const intw by_power = (power < 0.0f) | ((ahead > 0.0f) & (fma(ahead, ahead, -power) >= 0.0f));
    return ray.squared < wide(s.r2) ? by_power : by_disc;
}

// All shadow rays of a work-item: across the light no wider than this rectangle, and none starts behind `back`.
typedef struct {
    float x0, x1, y0, y1, back;
} FatShadowRay;

// `open` says which of the rays count.
static inline FatShadowRay fat_shadow_ray(const ShadowRay* ray, const intw* open) {
    floatw x0 = wide(INFINITY), x1 = -x0, y0 = x0, y1 = -x0, back = x0;
    FOR_PACKETS(k) {
        const vec3w from = ray[k].from;
        x0 = LESS(open[k] ? from.x : x0, x0);
        x1 = MORE(open[k] ? from.x : x1, x1);
        y0 = LESS(open[k] ? from.y : y0, y0);
        y1 = MORE(open[k] ? from.y : y1, y1);
        back = LESS(open[k] ? from.z : back, back);
    }
    return (FatShadowRay){REDUCE(least, x0), REDUCE(most, x1), REDUCE(least, y0), REDUCE(most, y1),
                          REDUCE(least, back)};
}

// Which spheres of a cluster may occlude one of the rays. occludes() accepts rays that pass at most 8 u max(|c|, r)
// outside a sphere, by the errors given there (for `power` divided by 2 r, where |p| < r and |c| < 1.5 r); the sums
// here round once, by less than 3 u max(|c|, r). The sphere's reach, r + 32 u max(|c|, r) (fat_ray.h), holds both.
static inline int shadow_candidates(FatShadowRay fat, global const Bounds* b) {
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += LANES) {
        const floatw x = lanes_at(b->x, first), y = lanes_at(b->y, first), z = lanes_at(b->z, first);
        const floatw reach = lanes_at(b->reach, first);
        const intw misses = (x - reach > fat.x1) | (x + reach < fat.x0) | (y - reach > fat.y1) | (y + reach < fat.y0) |
                            (z + reach < fat.back);
        kept |= lane_bits(!(misses | (ids_at(b->id, first) < 0))) << first;
    }
    return kept;
}

#endif
