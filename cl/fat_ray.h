// A fat ray: all rays of a work-item that leave one apex, as one, to pass over what none of them can meet, LANES
// spheres or nodes at a time. What it keeps holds every sphere that the exact tests (sphere.h, point_pencil.h) could
// accept, so it changes time and no bit: reach.h derives why.
#ifndef GNOMON_FAT_RAY_H
#define GNOMON_FAT_RAY_H

#include "cluster.h"

// The rays lie between four planes through the apex, whose unit normals point outward: their directions' X = d . u /
// d . axis and Y = d . v / d . axis are those of a rectangle.
typedef struct {
    float x0, x1, y0, y1;
    Float3 plane[4];
    Float3 axis;
    float distance;  // what begins beyond is of no interest
} FatRay;

// The normal of the plane through the apex and X = x or Y = x, times `scale`.
INLINE Float3 side(Float3 across, Float3 axis, float x, float scale) {
    return (Float3){fma(-x, axis.x, across.x) * scale, fma(-x, axis.y, across.y) * scale,
                    fma(-x, axis.z, across.z) * scale};
}

// Where a side is infinite its normal is NaN, and everything is kept.
INLINE FatRay fat_ray_between(float x0, float x1, float y0, float y1, Basis basis) {
    const float4 at = (float4)(x0, x1, y0, y1);
    const float4 scale = (float4)(-1.0f, 1.0f, -1.0f, 1.0f) / sqrt(fma(at, at, (float4)(1.0f)));
    FatRay fat = {x0, x1, y0, y1, {{0, 0, 0}}, basis.axis, INFINITY};
    fat.plane[0] = side(basis.u, basis.axis, x0, scale.x);
    fat.plane[1] = side(basis.u, basis.axis, x1, scale.y);
    fat.plane[2] = side(basis.v, basis.axis, y0, scale.z);
    fat.plane[3] = side(basis.v, basis.axis, y1, scale.w);
    return fat;
}

// `open` says which of the rays count. Where one is not on the axis's side the rectangle is the whole plane.
INLINE FatRay fat_ray(const vec3w* dir, const wholew* open, Basis basis) {
#if WALK == WALK_SPHERES
    return (FatRay){0};  // nobody looks at it
#else
    floatw x0 = wide_float(INFINITY), x1 = -x0, y0 = x0, y1 = -x0, ahead = x0;
    FOR_PACKETS(k) {
        const float3w d = floats_of_3(dir[k]);
        const intw counts = ints_of(open[k]);
        const floatw along = dot_f(basis.axis, d), scale = wide_float(1.0f) / along;
        const floatw x = dot_f(basis.u, d) * scale, y = dot_f(basis.v, d) * scale;
        x0 = LESS_WHERE(counts, x, x0);
        x1 = MORE_WHERE(counts, x, x1);
        y0 = LESS_WHERE(counts, y, y0);
        y1 = MORE_WHERE(counts, y, y1);
        ahead = LESS_WHERE(counts, along, ahead);
    }
    if (!(REDUCE(least, ahead) > 0.0f)) return fat_ray_between(-INFINITY, INFINITY, -INFINITY, INFINITY, basis);
    return fat_ray_between(REDUCE(least, x0), REDUCE(most, x1), REDUCE(least, y0), REDUCE(most, y1), basis);
#endif
}

// Which spheres of a cluster the fat ray may meet, as bits: those that it cannot be shown to miss, so that NaN keeps
// them.
INLINE int candidates(FatRay fat, global const PencilCluster* c) {
#if WALK == WALK_SPHERES && RAYS != RAYS_GENERATED
    return filled(c);
#endif
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) {
        const float3b f = {floats_at(c->x, first), floats_at(c->y, first), floats_at(c->z, first)};
        const floatb reach = bounds_at(c->reach, first);
        const floatb a = dot_b(fat.plane[0], f), b = dot_b(fat.plane[1], f);
        const floatb d = dot_b(fat.plane[2], f), e = dot_b(fat.plane[3], f);
        const floatb begins = dot_b(fat.axis, f) - reach;
        const Beyond beside =
            either(either(EXCEEDS(a, reach), EXCEEDS(b, reach)), either(EXCEEDS(d, reach), EXCEEDS(e, reach)));
        kept |= bits_within(either(EXCEEDS(begins, fat.distance), beside)) << first;
    }
    return kept;
}

// The same for the children of a node.
INLINE int node_candidates(FatRay fat, global const Node* n) {
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += BOUND_LANES) {
        const Beyond beside = children_beside(n, first, fat.x0, fat.x1, fat.y0, fat.y1);
        kept |= bits_within(either(EXCEEDS(bounds_at(n->depth, first), fat.distance), beside)) << first;
    }
    return kept;
}

#endif
