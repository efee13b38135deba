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
#if CERTIFIED
    realw off;  // how far the ray may be turned, in radians
#endif
} ShadowRay;

static inline vec3w from_light(LightPencil light, vec3w position) {
    return (vec3w){position.x - light.origin.x, position.y - light.origin.y, position.z - light.origin.z};
}

// A receiver at the light itself gets NaN, which meets nothing.
static inline ShadowRay shadow_ray(LightPencil light, vec3w position) {
    const vec3w way = from_light(light, position);
    const realw distance = square_root(dot_w(way, way));
    ShadowRay ray;
    ray.dir = scale_w(divide(wide(1.0f), distance), way);
    ray.distance = distance;
    return ray;
}

// n . l / d^2 = (d n . l) / d^3, the share of the light's power that arrives at the receiver, but for a factor: > 0
// where the surface faces the light, and NaN, which is not > 0, at the light.
static inline realw arriving(LightPencil light, ShadowRay ray, vec3w position, vec3w normal) {
    const vec3w way = from_light(light, position);
    return divide(-dot_w(way, normal), dot_w(way, way) * ray.distance);
}

// From outside (C > 0), with the centre ahead: the segment meets the sphere when its line does and the near root lies
// before the receiver, because the foot of the centre does or because the receiver is in the ball. From inside the ball
// (C <= 0) it does when the receiver is out of it; from a light on the surface only if the way starts inward.
static inline wholew occludes(PencilSphere s, ShadowRay ray) {
    const realw b = dot_r(s.center, ray.dir), beyond = b - ray.distance;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    if (is_apart(s)) return (discriminant >= 0.0f) & (b > 0.0f) & ((beyond < 0.0f) | (beyond * beyond < discriminant));
    // The receiver's power |d dir - f|^2 - r^2 = C - d (2 b - d).
    const realw power = fma(-ray.distance, b + beyond, wide(s.power));
    const wholew outside = (b > 0.0f) & ((power < 0.0f) | ((beyond < 0.0f) & (discriminant >= 0.0f)));
    const wholew inside = (power > 0.0f) & ((b > 0.0f) | (wide(s.power) < 0.0f));
    return s.power > 0 ? outside : inside;
}

// Whether it may: where it does not, occludes is 0.
static inline wholew may_occlude(PencilSphere s, ShadowRay ray) {
    if (!is_apart(s)) return (wholew)(-1);
    const realw b = dot_r(s.center, ray.dir);
    return (sphere_discriminant(s, ray.dir, b) >= 0.0f) & (b > 0.0f);
}

#if CERTIFIED

static inline real from_eye(LightPencil light) {
    return root_of(
        fma(light.origin.x, light.origin.x, fma(light.origin.y, light.origin.y, light.origin.z * light.origin.z)));
}
// How far the light itself may be off: its place is rounded, u |o|.
static inline real light_off(LightPencil light, real base) { return fma(2 * ROUNDING, from_eye(light), base); }

// How far the shadow rays of a work-item may be off at most.
typedef struct {
    real turn;    // radians
    real length;  // of the way between light and receiver
    real farthest, light;
} RayDoubt;

// `position` is how far the receiver is off. The way between both rounds once; its length 4 u more, and its direction
// 5 u.
static inline realw ray_off(LightPencil light, ShadowRay ray, realw position, real base) {
    const realw way = position + wide(fma(4 * ROUNDING, from_eye(light), light_off(light, base)));
    const realw turn = fma(2 * way, divide(wide(1.0f), ray.distance), wide(5 * ROUNDING));
    return turn < 1.0f ? turn : wide(INFINITY);
}

static inline real most_off(const ShadowRay* ray, const wholew* open) {
    floatw most = wide_float(0.0f);
    FOR_PACKETS(k) most = MORE(most, ints_of(open[k]) ? floats_of(ray[k].off) : wide_float(0.0f));
    return REDUCE(most, most) * (1 + 0x1p-20f);  // doubles became floats
}

static inline RayDoubt ray_doubt(LightPencil light, const ShadowRay* ray, const wholew* open, real base) {
    floatw farthest = wide_float(0.0f);
    FOR_PACKETS(k) farthest = MORE(farthest, ints_of(open[k]) ? floats_of(ray[k].distance) : wide_float(0.0f));
    const real most = REDUCE(most, farthest) * (1 + 0x1p-20f), turn = most_off(ray, open);
    return (RayDoubt){turn, 0.5f * turn * most, most, light_off(light, base)};
}

// Of a ray that is turned by `off`, D is off by no more than `fixed` and `slope` times that, and what says whether it
// is met before the receiver by `before`.
typedef struct {
    real fixed, slope, before;
    real ahead;  // of b
    int outside, inside;
} Edge;

static inline Edge edge_of(PencilSphere s, RayDoubt doubt, real base) {
    const real centre = base + doubt.light;
    const Doubt of = doubt_of(s, doubt.turn, centre);
    const real power_off = power_doubt(s, of, centre), shift = fma((real)2, doubt.length, of.shift);
    // Next to the surface the foot is no farther from the receiver than the radius; the power of the receiver seen from
    // a large sphere is off by what that is, times the diameter, and by roundings: 9 u |f| of b, 4 u of each term.
    const real near = is_apart(s) ? 3 * fma(3 * (of.radius + shift), shift, 12 * ROUNDING * s.r2)
                                  : fma(2 * of.radius + 3 * doubt.length, doubt.length, power_off) + 9 * shift * shift +
                                        ROUNDING * fma(doubt.farthest, fma((real)26, of.distance, 4 * doubt.farthest),
                                                       8 * fabs(s.power));
    const real slope = discriminant_slope(s, of.radius, of.shift), own = fma(12 * ROUNDING, of.distance, 4 * centre);
    return (Edge){fma(slope, own, 12 * ROUNDING * s.r2), slope * of.distance,        near, of.shift,
                  surely_outside(s, power_off),          surely_inside(s, power_off)};
}

// Where the ray's line surely misses the sphere, which judge_occlusion then calls clear.
static inline wholew surely_misses(PencilSphere s, ShadowRay ray, Edge edge) {
    if (edge.inside) return (wholew)(0);
    const realw discriminant = sphere_discriminant(s, ray.dir, dot_r(s.center, ray.dir));
    return discriminant < -fma(ray.off, wide(edge.slope), wide(edge.fixed));
}

// Where the sphere surely occludes the ray, and where it surely does not. From outside D >= 0 says that its line meets
// it, and D + before |before| >= 0 that the nearer root comes before the receiver; from inside it is met where the
// receiver is not in the ball.
static inline void judge_occlusion(PencilSphere s, ShadowRay ray, Edge edge, wholew* closes, wholew* clear) {
    const realw b = dot_r(s.center, ray.dir), before = ray.distance - b;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    const realw off = fma(ray.off, wide(edge.slope), wide(edge.fixed));
    const realw power = is_apart(s) ? fma(before, before, -discriminant) : fma(ray.distance, before - b, wide(s.power));
    if (edge.outside) {
        const realw nearer = fma(before, before + fabs(before), -power);
        *closes = (discriminant > off) & (b > edge.ahead) & (nearer > edge.before);
        *clear = (discriminant < -off) | (b < -edge.ahead) | (nearer < -edge.before);
        return;
    }
    *closes = edge.inside ? power > edge.before : (wholew)(0);
    *clear = edge.inside ? power < -edge.before : discriminant < -off;
}

// Where it is open whether the surface faces the light: (o - p) . n is off by the normal's doubt and 8 u, times the
// way, and by the way's.
static inline wholew may_face(LightPencil light, ShadowRay ray, vec3w position, vec3w normal, realw off, realw turned,
                              real base) {
    const realw place = off + wide(fma(4 * ROUNDING, from_eye(light), base));
    const realw edge = fma(ray.distance, turned + 8 * ROUNDING, place);
    return !(fabs(dot_w(from_light(light, position), normal)) > edge);
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
        sum.x += choose(counts, dir.x, wide_float(0.0f));
        sum.y += choose(counts, dir.y, wide_float(0.0f));
        sum.z += choose(counts, dir.z, wide_float(0.0f));
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
        farthest = MORE_WHERE(ints_of(open[k]), floats_of(ray[k].distance), farthest);
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
