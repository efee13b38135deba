// The shadow pencil of a point light: rays leave the light, so spheres are seen from there (sphere.h), and an occluder
// counts when it meets the open segment between light and receiver.
#ifndef GNOMON_POINT_PENCIL_H
#define GNOMON_POINT_PENCIL_H

#include "certify.h"
#include "fat_ray.h"
#include "sphere.h"

typedef PointPencil LightPencil;

// What a receiver's shadow ray shares among all spheres.
typedef struct {
    vec3w dir;       // unit, from the light to the receiver
    realw distance;  // between the two
} ShadowRay;

static inline vec3w from_light(LightPencil light, vec3w position) {
    return (vec3w){position.x - light.origin.x, position.y - light.origin.y, position.z - light.origin.z};
}

// A receiver at the light itself gets NaN, which meets nothing.
static inline ShadowRay shadow_ray(LightPencil light, vec3w position) {
    const vec3w way = from_light(light, position);
    const realw distance = square_root(dot_w(way, way));
    return (ShadowRay){scale_w(divide(wide(1.0f), distance), way), distance};
}

// n . l / d^2 = (d n . l) / d^3, the share of the light's power that arrives, but for a factor: > 0 where the surface
// faces the light, and NaN, which is not > 0, at the light.
static inline realw arriving(LightPencil light, vec3w position, vec3w normal) {
    const vec3w way = from_light(light, position);
    const realw squared = dot_w(way, way);
    return divide(-dot_w(way, normal), squared * square_root(squared));
}

// From outside (C > 0), with the centre ahead: the segment meets the sphere when its line does and the near root lies
// before the receiver, because the foot of the centre does or because the receiver is in the ball. From inside the ball
// (C <= 0) it does when the receiver is out of it; from a light on the surface only if the way starts inward.
static inline wholew occludes(PencilSphere s, ShadowRay ray) {
    const realw b = dot_r(s.center, ray.dir), beyond = b - ray.distance;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    if (looks_small(s))
        return (discriminant >= 0.0f) & (b > 0.0f) & ((beyond < 0.0f) | (beyond * beyond < discriminant));
    // The receiver's power |d dir - f|^2 - r^2 = C - d (2 b - d).
    const realw power = fma(-ray.distance, b + beyond, wide(s.power));
    const wholew outside = (b > 0.0f) & ((power < 0.0f) | ((beyond < 0.0f) & (discriminant >= 0.0f)));
    const wholew inside = (power > 0.0f) & ((b > 0.0f) | (wide(s.power) < 0.0f));
    return wide(s.power) > 0.0f ? outside : inside;
}

#if CERTIFIED

// How far the shadow rays of a work-item may be off, as this pencil has them.
typedef struct {
    real turn;    // radians
    real length;  // of the way between light and receiver
    real light;   // of the light itself, from the eye
} RayDoubt;

static inline real from_eye(LightPencil light) {
    return sqrt(
        fma(light.origin.x, light.origin.x, fma(light.origin.y, light.origin.y, light.origin.z * light.origin.z)));
}

// `position` is the most that one of the receivers is off. The light's place is rounded, u |o|; the way between both
// rounds once; its length 4 u more, and its direction 5 u.
static inline RayDoubt ray_doubt(LightPencil light, real position, const ShadowRay* ray, const wholew* open,
                                 real base) {
    floatw nearest = wide_float(INFINITY);
    FOR_PACKETS(k) nearest = LESS(ints_of(open[k]) ? floats_of(ray[k].distance) : nearest, nearest);
    const float shortest = REDUCE(least, nearest) * (1 - 0x1p-20f);  // doubles became floats
    const real off = fma(2 * ROUNDING, from_eye(light), base), way = position + fma(4 * ROUNDING, from_eye(light), off);
    return (RayDoubt){way < 0.5f * shortest ? 2 * way / shortest + 5 * ROUNDING : INFINITY, way, off};
}

// What settles how a sphere and a ray meet.
typedef struct {
    real met, before;  // of D, and of what says that it is before the receiver
    real ahead;        // of b
    int outside, inside;
} Edge;

// `shift` is of where along the ray the foot of the centre is, and the receiver.
static inline Edge edge_of(PencilSphere s, RayDoubt doubt, real base) {
    const Doubt of = doubt_of(s, doubt.turn, base + doubt.light);
    const real power_off = power_doubt(s, of, base + doubt.light), shift = fma((real)2, doubt.length, of.shift);
    const real before = 3 * fma(3 * of.radius + 3 * shift, shift, 12 * ROUNDING * s.r2);
    return (Edge){of.discriminant, before, of.shift, surely_outside(s, power_off), surely_inside(s, power_off)};
}

// Where the sphere surely occludes the ray, and where it surely does not. From outside D >= 0 says that its line meets
// it, and D + before |before| >= 0 that the nearer root comes before the receiver; from inside it is met where the
// receiver is not in the ball.
static inline void judge_occlusion(PencilSphere s, ShadowRay ray, Edge edge, wholew* closes, wholew* clear) {
    const realw b = dot_r(s.center, ray.dir), before = ray.distance - b;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    if (edge.outside) {
        const realw nearer = fma(before, fabs(before), discriminant);
        *closes = (discriminant > edge.met) & (b > edge.ahead) & (nearer > edge.before);
        *clear = (discriminant < -edge.met) | (b < -edge.ahead) | (nearer < -edge.before);
        return;
    }
    const realw power = fma(before, before, -discriminant);
    *closes = edge.inside ? power > edge.before : (wholew)(0);
    *clear = edge.inside ? power < -edge.before : discriminant < -edge.met;
}

// Where it is open whether the surface faces the light: (o - p) . n is off by the normal's doubt and 8 u, times the way,
// and by the way's.
static inline wholew may_face(LightPencil light, vec3w position, vec3w normal, real off, real turned, real base) {
    const vec3w way = from_light(light, position);
    const real place = fma(4 * ROUNDING, from_eye(light), base) + off;
    const realw edge = fma(square_root(dot_w(way, way)), wide(turned + 8 * ROUNDING), wide(place));
    return !(fabs(dot_w(way, normal)) > edge);
}

#endif

// All shadow rays of a work-item leave the light: see fat_ray.h.
typedef FatRay FatShadowRay;

// The face of the light that most of the rays leave through.
static inline int face_of(LightPencil light, const ShadowRay* ray, const wholew* open) {
#if WALK == WALK_SPHERES
    return 0;  // nobody looks at it
#endif
    if (light.faces == 1) return 0;
    float3w sum = {wide_float(0.0f), wide_float(0.0f), wide_float(0.0f)};
    FOR_PACKETS(k) {
        const float3w dir = floats_of_3(ray[k].dir);
        const intw counts = ints_of(open[k]);
        sum.x += counts ? dir.x : wide_float(0.0f);
        sum.y += counts ? dir.y : wide_float(0.0f);
        sum.z += counts ? dir.z : wide_float(0.0f);
    }
    const float x = REDUCE(sum, sum.x), y = REDUCE(sum, sum.y), z = REDUCE(sum, sum.z);
    int best = 0;
    float most = -INFINITY;
    for (int i = 0; i < light.faces; ++i) {
        const Float3 axis = light.face[i].axis;
        const float along = fma(axis.x, x, fma(axis.y, y, axis.z * z));
        best = along > most ? i : best;
        most = along > most ? along : most;
    }
    return best;
}

static inline FatShadowRay fat_shadow_ray(LightPencil light, int face, const ShadowRay* ray, const wholew* open) {
    vec3w dir[PACKETS];
    floatw farthest = wide_float(0.0f);
    FOR_PACKETS(k) {
        dir[k] = ray[k].dir;
        farthest = MORE(ints_of(open[k]) ? floats_of(ray[k].distance) : farthest, farthest);
    }
    FatRay fat = fat_ray(dir, open, light.face[face]);
    fat.distance = REDUCE(most, farthest);
    return fat;
}

static inline int shadow_candidates(FatShadowRay fat, global const PencilCluster* c) { return candidates(fat, c); }
static inline int shadow_node_candidates(FatShadowRay fat, global const Node* n) { return node_candidates(fat, n); }

#if CERTIFIED
// Turning a ray by a small angle moves X by (1 + X^2) of it, and by less than twice that while the angle and X times it
// are below 1/4.
static inline float outward(float x, float turn) {
    return fabs(turn) * MORE(fabs(x), 1.0f) < 0.25f ? fma(2 * turn, fma(x, x, 1.0f), x) : turn * INFINITY;
}

// Wide enough for rays that are as far off as `doubt` says.
static inline FatShadowRay widened(FatShadowRay fat, LightPencil light, int face, RayDoubt doubt) {
    const float turn = (float)doubt.turn;
    FatRay wider = fat_ray_between(outward(fat.x0, -turn), outward(fat.x1, turn), outward(fat.y0, -turn),
                                   outward(fat.y1, turn), light.face[face]);
    wider.distance = fat.distance + doubt.length;
    return wider;
}
#endif

#endif
