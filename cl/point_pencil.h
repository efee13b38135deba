// The shadow pencil of a point light: rays leave the light, so spheres are seen from there (sphere.h), and an occluder
// counts when it meets the open segment between light and receiver.
#ifndef GNOMON_POINT_PENCIL_H
#define GNOMON_POINT_PENCIL_H

#include "certify.h"
#include "fat_ray.h"
#include "hits_box.h"
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

INLINE vec3w from_light(LightPencil light, vec3w position) {
    return (vec3w){position.x - light.origin.x, position.y - light.origin.y, position.z - light.origin.z};
}

// A receiver at the light itself gets NaN, which meets nothing.
INLINE ShadowRay shadow_ray(LightPencil light, vec3w position) {
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
INLINE realw arriving(LightPencil light, ShadowRay ray, vec3w position, vec3w normal) {
    const vec3w way = from_light(light, position);
    return divide(-dot_w(way, normal), dot_w(way, way) * ray.distance);
}

// From outside (C > 0), with the centre ahead: the segment meets the sphere when its line does and the near root lies
// before the receiver, because the foot of the centre does or because the receiver is in the ball. From inside the ball
// (C <= 0) it does when the receiver is out of it; from a light on the surface only if the way starts inward.
INLINE wholew occludes(PencilSphere s, ShadowRay ray) {
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
INLINE wholew may_occlude(PencilSphere s, ShadowRay ray) {
    if (!is_apart(s)) return (wholew)(-1);
    const realw b = dot_r(s.center, ray.dir);
    return (sphere_discriminant(s, ray.dir, b) >= 0.0f) & (b > 0.0f);
}

// All shadow rays of a work-item leave the light: see fat_ray.h.
typedef FatRay FatShadowRay;

// The face of the light whose axis is closest to a direction.
INLINE int face_toward(LightPencil light, float x, float y, float z) {
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

// The face of the light that most of the rays leave through.
INLINE int face_of(LightPencil light, const ShadowRay* ray, const wholew* open) {
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
    return face_toward(light, REDUCE(sum, sum.x), REDUCE(sum, sum.y), REDUCE(sum, sum.z));
}

INLINE FatShadowRay fat_shadow_ray(LightPencil light, int face, const ShadowRay* ray, const wholew* open) {
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

#if BOXES
INLINE HitsBox box_from_light(LightPencil light, HitsBox box) {
    const Float3 o = light.origin, l = box.least, m = box.most;
    return (HitsBox){{l.x - o.x, l.y - o.y, l.z - o.z}, {m.x - o.x, m.y - o.y, m.z - o.z}};
}
// The face toward the middle of the box.
INLINE int face_of_box(LightPencil light, HitsBox box) {
    if (light.faces == 1) return 0;
    const HitsBox b = box_from_light(light, box);
    return face_toward(light, b.least.x + b.most.x, b.least.y + b.most.y, b.least.z + b.most.z);
}
// Where not all of the box is on the axis's side the rectangle is the whole plane.
INLINE FatShadowRay fat_ray_to_box(LightPencil light, int face, HitsBox box) {
    const Extent extent = extent_of(box_from_light(light, box), light.face[face]);
    if (!(extent.least.z > 0.0f)) return fat_ray_between(-INFINITY, INFINITY, -INFINITY, INFINITY, light.face[face]);
    const float4 sides = (float4)(extent.least.x, extent.most.x, extent.least.y, extent.most.y),
                 near = sides / extent.least.z, far = sides / extent.most.z;
    const float4 least = near < far ? near : far, most = near < far ? far : near;
    FatRay fat = fat_ray_between(least.x, most.y, least.z, most.w, light.face[face]);
    fat.distance = extent.most.z;  // along the axis, which is how far what may be in between begins
    return fat;
}
#endif

INLINE int shadow_candidates(FatShadowRay fat, global const PencilCluster* c) { return candidates(fat, c); }
// Certified pictures say more exactly, sphere by sphere, what is too far (point_doubt.h).
INLINE int shadow_ball_candidates(FatShadowRay fat, global const PencilCluster* c) {
#if CERTIFIED
    fat.distance = INFINITY;
#endif
    return candidates(fat, c);
}
INLINE int shadow_node_candidates(FatShadowRay fat, global const Node* n) { return node_candidates(fat, n); }

#endif
