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
    real turn;      // radians
    real length;    // of the way between light and receiver
    real farthest;  // the longest of these ways
    real light;     // of the light itself, from the eye
} RayDoubt;

static inline real from_eye(LightPencil light) {
    return sqrt(
        fma(light.origin.x, light.origin.x, fma(light.origin.y, light.origin.y, light.origin.z * light.origin.z)));
}

// `position` is the most that one of the receivers is off. The light's place is rounded, 1 u |o|; the way between both
// rounds once; its length 4 u more, and its direction 5 u.
static inline RayDoubt ray_doubt(LightPencil light, real position, real farthest, real shortest, real longest,
                                 real base) {
    const real off = fma(2 * ROUNDING, from_eye(light), base),
               way = fma(4 * ROUNDING, farthest + from_eye(light), position) + off;
    const real turn = way < 0.5f * shortest ? fma((real)2.0f, way / shortest, 5 * ROUNDING) : INFINITY;
    return (RayDoubt){turn, way, longest, off};
}

static inline realw way_of(ShadowRay ray) { return ray.distance; }

typedef Doubt Edge;
static inline Edge edge_of(PencilSphere s, RayDoubt doubt, real base) {
    return doubt_of(s, doubt.turn, base + doubt.light);
}

// Where the sphere is not surely passed.
static inline wholew is_near(PencilSphere s, ShadowRay ray, Edge edge) {
    return !(sphere_discriminant(s, ray.dir, dot_r(s.center, ray.dir)) < -edge.discriminant);
}

// Where it surely occludes the ray, and where it surely does not.
static inline void judge_occlusion(PencilSphere s, ShadowRay ray, RayDoubt doubt, Edge d, wholew* closes,
                                   wholew* clear) {
    const real edge = d.discriminant, farther = fma((real)2.0f, doubt.length, d.shift), radius = sqrt(s.r2);
    const int outside = s.power > d.power, inside = s.power < -d.power;
    const realw b = dot_r(s.center, ray.dir), beyond = b - ray.distance;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    // The receiver's power. beyond^2 - D, and next to the surface |beyond| <= r; for spheres that look large C - d (2 b
    // - d), which is off by what the receiver is, times the diameter, and by roundings: b's 9 u |f| (root_doubt), twice
    // d times, and 4 u of the terms.
    realw power = fma(beyond, beyond, -discriminant);
    real power_edge = fma(fma(radius, (real)2.0f, 3 * farther), farther, 2 * edge);
    if (!looks_small(s)) {
        const real away = sqrt(MORE(s.power + s.r2, 0.0f)), d_most = doubt.farthest;
        power = fma(-ray.distance, b + beyond, wide(s.power));
        power_edge = fma(2 * radius + 3 * doubt.length, doubt.length, d.power) +
                     ROUNDING * fma(d_most, fma((real)26.0f, away, 4 * d_most), 4 * fabs(s.power));
    }
    const wholew passes = discriminant < -edge, in = power<-power_edge, out = power> power_edge;
    const wholew foot = (discriminant > edge) & (b > d.shift) & (beyond < -farther);
    const wholew none = 0;
    *closes = outside ? in | foot : inside ? out : none;
    *clear = outside ? passes | (b < -d.shift) | ((beyond > farther) & out) : inside ? in : passes;
}

static inline void judge_facing(LightPencil light, vec3w position, vec3w normal, realw t, realw off, realw turned,
                                real base, wholew* faces, wholew* averted) {
    const vec3w way = from_light(light, position);
    const realw distance = sqrt(dot_w(way, way)), place = wide(fma(4 * ROUNDING, from_eye(light), base));
    const realw edge = fma(distance, turned + 8 * ROUNDING, fma(t, wide(4 * ROUNDING), off) + place);
    const realw facing = -dot_w(way, normal);
    *faces = facing > edge;
    *averted = facing < -edge;
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
