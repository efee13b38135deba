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
    realw inverse;  // 1 / distance
#endif
} ShadowRay;

static inline vec3w from_light(LightPencil light, vec3w position) {
    return (vec3w){position.x - light.origin.x, position.y - light.origin.y, position.z - light.origin.z};
}

// A receiver at the light itself gets NaN, which meets nothing.
static inline ShadowRay shadow_ray(LightPencil light, vec3w position) {
    const vec3w way = from_light(light, position);
    const realw distance = square_root(dot_w(way, way));
    const realw inverse = divide(wide(1.0f), distance);
    ShadowRay ray;
    ray.dir = scale_w(inverse, way);
    ray.distance = distance;
#if CERTIFIED
    ray.inverse = inverse;
#endif
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

// How far what does not differ from sphere to sphere may be off.
typedef struct {
    real way;            // between light and receiver
    real normal, place;  // of (o - p) . n, times the way, and besides
    real center;         // the light itself, and a sphere
} LightDoubt;

// `position` is how far the receiver is off. Its place is rounded, u |o|, and the way between both once; its length 4 u
// more, and its direction 5 u.
static inline LightDoubt light_doubt(LightPencil light, real position, real normal, real base) {
    const real from_eye = root_of(
        fma(light.origin.x, light.origin.x, fma(light.origin.y, light.origin.y, light.origin.z * light.origin.z)));
    const real own = fma(2 * ROUNDING, from_eye, base), rounded = 4 * ROUNDING * from_eye;
    return (LightDoubt){position + (rounded + own), normal + 8 * ROUNDING, position + (rounded + base), base + own};
}

// Rays may be turned by so much (radians), and their receivers are no farther than this.
typedef struct {
    real turn, distance;
} RayDoubt;

// 3/2 of what the way is off over its length serves while that is below 1/2.
static inline RayDoubt doubt_between(LightDoubt doubt, real inverse, real distance) {
    const real turn = fma(1.5f * doubt.way, inverse, 5 * ROUNDING);
    return (RayDoubt){turn < 0.75f ? turn : INFINITY, distance};
}
// The most of a group.
static inline RayDoubt ray_doubt(LightDoubt doubt, const ShadowRay* ray, const wholew* open) {
    floatw farthest = wide_float(0.0f), inverse = farthest;
    FOR_PACKETS(k) {
        farthest = MORE_WHERE(ints_of(open[k]), floats_of(ray[k].distance), farthest);
        inverse = MORE_WHERE(ints_of(open[k]), floats_of(ray[k].inverse), inverse);
    }
    const real up = 1 + 0x1p-20f;  // doubles became floats
    return doubt_between(doubt, REDUCE(most, inverse) * up, REDUCE(most, farthest) * up);
}
static inline RayDoubt own_ray_doubt(LightDoubt own, ShadowRay ray, int lane) {
    return doubt_between(own, LANE_OF(ray.inverse, lane), LANE_OF(ray.distance, lane));
}

// How far D may be off, what says whether the sphere is met before the receiver, and b.
typedef struct {
    real discriminant, before, ahead;
    int outside, inside;
} Edge;

// Next to the surface the foot is no farther from the receiver than the radius; the power of the receiver seen from a
// large sphere is off by what that is, times the diameter, and by roundings: 9 u |f| of b, 4 u of each term.
static inline Edge edge_of(PencilSphere s, LightDoubt doubt, RayDoubt ray) {
    const real from_light = distance_of(s), radius = radius_of(s);
    const real power_off = power_doubt(s, from_light, radius, doubt.center);
    const DiscriminantDoubt of = discriminant_doubt(s, radius, power_off);
    const real shift = fma(ray.turn, from_light, fma(12 * ROUNDING, from_light, 4 * doubt.center));
    const real discriminant = fma(fma((real)4, shift, of.slope), shift, of.rest);
    const real along = shift + 2 * doubt.way;
    real before;
    if (is_apart(s)) {
        before = fma(along, 2 * (along + radius), discriminant);
    } else {
        const real rounded = fma(ray.distance, fma((real)4, ray.distance, 26 * from_light), 8 * fabs(s.power));
        before =
            fma(fma((real)3, doubt.way, 2 * radius), doubt.way, power_off) + 9 * along * along + ROUNDING * rounded;
    }
    return (Edge){discriminant, before, shift, surely_outside(s, power_off), surely_inside(s, power_off)};
}

// From outside D >= 0 says that the line meets the sphere, and D + before |before| >= 0 that the nearer root comes
// before the receiver; from inside it is met where the receiver is not in the ball.
typedef struct {
    realw b, discriminant, power, nearer;
} Meeting;

static inline Meeting meeting(PencilSphere s, ShadowRay ray) {
    const realw b = dot_r(s.center, ray.dir), before = ray.distance - b;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    const realw power = is_apart(s) ? fma(before, before, -discriminant) : fma(ray.distance, before - b, wide(s.power));
    const realw nearer =
        is_apart(s) ? fma(before, fabs(before), discriminant) : fma(before, before + fabs(before), -power);
    return (Meeting){b, discriminant, power, nearer};
}

// Whether the sphere surely occludes the ray, and whether it surely does not.
static inline wholew surely_met(Meeting at, Edge edge) {
    if (edge.outside)
        return (at.discriminant > wide(edge.discriminant)) & (at.b > wide(edge.ahead)) &
               (at.nearer > wide(edge.before));
    return edge.inside ? at.power > wide(edge.before) : (wholew)(0);
}
static inline wholew surely_clear(Meeting at, Edge edge) {
    if (edge.outside)
        return (at.discriminant < wide(-edge.discriminant)) | (at.b < wide(-edge.ahead)) |
               (at.nearer < wide(-edge.before));
    return edge.inside ? at.power < wide(-edge.before) : at.discriminant < wide(-edge.discriminant);
}

// Where it is open whether the surface faces the light: (o - p) . n is off by the normal's doubt and 8 u, times the
// way, and by the way's.
static inline wholew may_face(LightPencil light, ShadowRay ray, vec3w position, vec3w normal, LightDoubt doubt) {
    const realw edge = fma(ray.distance, wide(doubt.normal), wide(doubt.place));
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
    return fabs(turn) * MORE(fabs(x), 1.0f) < 0x1p-8f ? fma(2 * turn, fma(x, x, 1.0f), x) : turn * INFINITY;
}

// So wide that what is passed over is clear of each ray by its own doubt: docs/accuracy.md, "What is passed over".
static inline FatShadowRay widened(FatShadowRay fat, LightPencil light, int face, RayDoubt doubt) {
    const float turn = 6 * (float)doubt.turn;
    FatRay wider = fat_ray_between(outward(fat.x0, -turn), outward(fat.x1, turn), outward(fat.y0, -turn),
                                   outward(fat.y1, turn), light.face[face]);
    wider.distance = fma(turn, fat.distance, fat.distance);
    return wider;
}

// As `candidates`, but what begins behind all receivers is passed over only where it does so by an eighth of the radius
// and 32 times what the way ahead may be off.
static inline int certain_shadow_candidates(FatShadowRay fat, RayDoubt doubt, global const PencilCluster* c) {
#if WALK != WALK_CLUSTERS
    return candidates(fat, c);
#endif
    const float turn = (float)doubt.turn, distance = (float)doubt.distance;
    const float slope = 32 * (turn + (float)(12 * ROUNDING)), farthest = fma(64 * turn, distance, distance);
    fat.distance = INFINITY;
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += LANES) {
        const float3w f = {floats_at(c->x, first), floats_at(c->y, first), floats_at(c->z, first)};
        const floatw begin = dot_f(fat.axis, f) - 1.125f * lanes_at(c->reach, first);
        const intw beyond = fma(wide_float(-slope), fabs(f.x) + fabs(f.y) + fabs(f.z), begin) > farthest;
        kept |= lane_bits(!beyond) << first;
    }
    return kept & candidates(fat, c);
}
#endif

#endif
