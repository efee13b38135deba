// A point light's shadow pencil in certified pictures: what rounding may decide of a shadow ray (point_pencil.h).
// Derived in docs/accuracy.md.
#ifndef GNOMON_POINT_DOUBT_H
#define GNOMON_POINT_DOUBT_H

#include "certify.h"
#include "point_pencil.h"

#if CERTIFIED

// How far what does not differ from sphere to sphere may be off.
typedef struct {
    real way;            // between light and receiver
    real normal, place;  // of (o - p) . n, times the way, and besides
    real center;         // the light itself, and a sphere
} LightDoubt;

// `position` is how far the receiver is off. Its place is rounded, u |o|, and the way between both once; its length 4 u
// more, and its direction 5 u.
INLINE LightDoubt light_doubt(LightPencil light, real position, real normal, real base) {
    const real from_eye = root_of(
        fma(light.origin.x, light.origin.x, fma(light.origin.y, light.origin.y, light.origin.z * light.origin.z)));
    const real own = fma(2 * ROUNDING, from_eye, base), rounded = 4 * ROUNDING * from_eye;
    return (LightDoubt){position + (rounded + own), normal + 8 * ROUNDING, position + (rounded + base), base + own};
}

// Rays may be turned by so much (radians), and their receivers are no farther than this.
typedef struct {
    real turn, distance;
} RayDoubt;

INLINE RayDoubt doubt_between(LightDoubt doubt, real inverse, real distance) {
    const real turn = fma(AN_ANGLE * doubt.way, inverse, 5 * ROUNDING);
    return (RayDoubt){turn < AN_ANGLE / 2 ? turn : INFINITY, distance};
}
// The most of a group.
INLINE RayDoubt ray_doubt(LightDoubt doubt, const ShadowRay* ray, const wholew* open) {
    floatw farthest = wide_float(0.0f), inverse = farthest;
    FOR_PACKETS(k) {
        farthest = MORE_WHERE(ints_of(open[k]), floats_of(ray[k].distance), farthest);
        inverse = MORE_WHERE(ints_of(open[k]), floats_of(ray[k].inverse), inverse);
    }
    const real up = 1 + 0x1p-20f;  // doubles became floats
    return doubt_between(doubt, REDUCE(most, inverse) * up, REDUCE(most, farthest) * up);
}
INLINE RayDoubt own_ray_doubt(LightDoubt own, ShadowRay ray, int lane) {
    return doubt_between(own, LANE_OF(ray.inverse, lane), LANE_OF(ray.distance, lane));
}

// How far the line of a ray may be off, and D: infinitely where that says nothing, from inside.
typedef struct {
    real shift, discriminant, from_light;
    int inside;
} LineEdge;

// For a sphere no farther from the light than that. Of spheres apart, which the light is surely outside of or nothing
// is said of them, no power is asked yet.
INLINE LineEdge line_edge(PencilSphere s, LightDoubt doubt, RayDoubt ray, real from_light) {
    const real radius = radius_of(s);
    const real power_off = is_apart(s) ? 0 : power_doubt(s, from_light, radius, doubt.center);
    const DiscriminantDoubt of = discriminant_doubt(s, radius, power_off);
    const real shift = fma(ray.turn, from_light, fma(12 * ROUNDING, from_light, 4 * doubt.center));
    const real discriminant = fma(fma((real)4, shift, of.slope), shift, of.rest);
    const int inside = !is_apart(s) && surely_inside(s, power_off);
    return (LineEdge){shift, inside ? INFINITY : discriminant, from_light, inside};
}

// Whether the line of the ray may meet the sphere: where it does not, the ray is surely clear.
INLINE wholew line_may_meet(PencilSphere s, ShadowRay ray, LineEdge edge) {
    return !(sphere_discriminant(s, ray.dir, dot_r(s.center, ray.dir)) < wide(-edge.discriminant));
}

// Which of two formulas is D's.
INLINE int formula_of_line(PencilSphere s) { return is_apart(s); }

// The inverse of how far D may be off, what says whether the sphere is met before the receiver, and b.
typedef struct {
    real discriminant, before, ahead;
    int outside, inside;
} Edge;

// Next to the surface the foot is no farther from the receiver than the radius; the power of the receiver seen from a
// large sphere is off by what that is, times the diameter, and by roundings: 9 u |f| of b, 4 u of each term.
INLINE Edge edge_of(PencilSphere s, LightDoubt doubt, RayDoubt ray, LineEdge line) {
    const real radius = radius_of(s), power_off = power_doubt(s, line.from_light, radius, doubt.center);
    const real along = line.shift + 2 * doubt.way;
    real before;
    if (is_apart(s)) {
        before = fma(along, 2 * (along + radius), line.discriminant);
    } else {
        const real rounded = fma(ray.distance, fma((real)4, ray.distance, 26 * line.from_light), 8 * fabs(s.power));
        before =
            fma(fma((real)3, doubt.way, 2 * radius), doubt.way, power_off) + 9 * along * along + ROUNDING * rounded;
    }
    return (Edge){inverse_of(line.discriminant), inverse_of(before), inverse_of(line.shift),
                  surely_outside(s, power_off), line.inside};
}

// By how many of its doubts the ray is occluded: more than 1 is sure, and so is less than -1, that it is not. From
// outside D >= 0 says that the line meets the sphere, and D + before |before| >= 0 that the nearer root comes before
// the receiver; from inside it is met where the receiver is not in the ball. NaN where either is.
INLINE realw occluded_by(PencilSphere s, ShadowRay ray, Edge edge) {
    const realw b = dot_r(s.center, ray.dir), before = ray.distance - b;
    const realw discriminant = sphere_discriminant(s, ray.dir, b);
    const realw power = is_apart(s) ? fma(before, before, -discriminant) : fma(ray.distance, before - b, wide(s.power));
    if (edge.inside) return power * wide(edge.before);
    const realw meets = discriminant * wide(edge.discriminant);
    if (!edge.outside) return choose(meets < 0.0f, meets, wide(0.0f));
    const realw nearer =
        is_apart(s) ? fma(before, fabs(before), discriminant) : fma(before, before + fabs(before), -power);
    const realw ahead = b * wide(edge.ahead), first = nearer * wide(edge.before);
    const realw least = choose(ahead < meets, ahead, meets);
    return choose(least < first, least, first);
}

// Where it is open whether the surface faces the light: (o - p) . n is off by the normal's doubt and 8 u, times the
// way, and by the way's.
INLINE wholew may_face(LightPencil light, ShadowRay ray, vec3w position, vec3w normal, LightDoubt doubt) {
    const realw edge = fma(ray.distance, wide(doubt.normal), wide(doubt.place));
    return !(fabs(dot_w(from_light(light, position), normal)) > edge);
}

// Turning a ray by a small angle moves X by (1 + X^2) of it, and by less than twice that while the angle and X times it
// are below 1/4.
INLINE float outward(float x, float turn) {
    return fabs(turn) * MORE(fabs(x), 1.0f) < 0x1p-8f ? fma(2 * turn, fma(x, x, 1.0f), x) : turn * INFINITY;
}

// So wide that what is passed over is clear of each ray by its own doubt: docs/accuracy.md, "What is passed over".
INLINE FatShadowRay widened(FatShadowRay fat, LightPencil light, int face, RayDoubt doubt) {
    const float turn = 6 * (float)doubt.turn;
    FatRay wider = fat_ray_between(outward(fat.x0, -turn), outward(fat.x1, turn), outward(fat.y0, -turn),
                                   outward(fat.y1, turn), light.face[face]);
    wider.distance = fma(turn, fat.distance, fat.distance);
    return wider;
}

// As `candidates`, but what begins behind all receivers is passed over only where it does so by an eighth of the radius
// and 32 times what the way ahead may be off.
INLINE int certain_shadow_candidates(FatShadowRay fat, RayDoubt doubt, global const PencilCluster* c) {
#if WALK != WALK_CLUSTERS
    return candidates(fat, c);
#endif
    const float turn = (float)doubt.turn, distance = (float)doubt.distance;
    const float slope = 32 * (turn + (float)(12 * ROUNDING)), farthest = fma(64 * turn, distance, distance);
    fat.distance = INFINITY;
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) {
        const float3b f = {floats_at(c->x, first), floats_at(c->y, first), floats_at(c->z, first)};
        const floatb begin = dot_b(fat.axis, f) - 1.125f * bounds_at(c->reach, first);
        const floatb surely = fma((floatb)(-slope), fabs(f.x) + fabs(f.y) + fabs(f.z), begin);
        kept |= bits_within(EXCEEDS(surely, farthest)) << first;
    }
    return kept & candidates(fat, c);
}

#endif

#endif
