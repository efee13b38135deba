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

// n . l: > 0 where the surface faces the light.
static inline floatw facing(LightPencil light, vec3w position, vec3w normal) { return dot_f(light.dir, normal); }

// n . l, the share of the irradiance that arrives.
static inline floatw geometry(LightPencil light, vec3w position, vec3w normal) { return dot_f(light.dir, normal); }

// Whether the sphere meets the ray at any t > 0, that is: its line comes closer than the radius, and the farther root
// s + sqrt(D) is > 0, with s the way along dir from the receiver to the foot of the centre. For a sphere that looks
// large the receiver's own power |c - p|^2 - r^2 = C - 2 c.p + |p|^2 says on which side of the surface it is (see
// sphere.h).
static inline intw occludes(PencilSphere s, ShadowRay ray) {
    const floatw ahead = wide(s.center.z) - ray.from.z;
    if (s.form == FORM_LARGE) {
        const floatw power = wide(s.power) + fma(wide(-2.0f), dot_f(s.center, ray.from), ray.squared);
        return (power < 0.0f) | ((ahead > 0.0f) & (fma(ahead, ahead, -power) >= 0.0f));
    }
    const floatw x = wide(s.center.x) - ray.from.x, y = wide(s.center.y) - ray.from.y;
    const floatw discriminant = fma(-x, x, fma(-y, y, wide(s.r2)));
    return (discriminant >= 0.0f) & ((ahead > 0.0f) | (ahead * ahead < discriminant));
}

#if LANES > 1

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

// Which spheres of a cluster may occlude one of the rays. occludes() compares differences of the very numbers that are
// compared here; it rounds each three times at most, by less than 8 u r, and the sums here round once, by u (|f| + r).
// The sphere's reach, r + 32 u |f| with r < |f| (fat_ray.h), holds both. A sphere that looks large has an infinite
// reach.
static inline int shadow_candidates(FatShadowRay fat, global const SphereCluster* c) {
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += LANES) {
        const floatw x = cluster_lanes(c->x, first), y = cluster_lanes(c->y, first), z = cluster_lanes(c->z, first);
        const floatw reach = cluster_lanes(c->reach, first);
        const intw misses = (x - reach > fat.x1) | (x + reach < fat.x0) | (y - reach > fat.y1) | (y + reach < fat.y0) |
                            (z + reach < fat.back);
        kept |= lane_bits(!misses) << first;
    }
    return kept;
}

#endif

#endif
