// The shadow pencil of a directional light: all rays run along dir, so whether one meets a sphere is a question of the
// plane across dir (is the point in the disc?), without a root. Positions are relative to the eye, in the basis (u, v,
// dir).
#ifndef GNOMON_PARALLEL_PENCIL_H
#define GNOMON_PARALLEL_PENCIL_H

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

#endif
