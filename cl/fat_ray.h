// A fat ray: all rays of a work-item as one, to pass over the spheres that none of them can meet, LANES spheres at a
// time. What it keeps holds every sphere that the exact tests (sphere.h, parallel_pencil.h, point_pencil.h) could
// accept, so it changes time and no bit.
//
// Rays from one apex: let a be a unit axis and h = max |dir - a|. A line along dir passes the centre f at |f x dir|,
// which is at least |f x a| - |f| h; so a sphere with |f x a| > r + |f| h is met by none. In units of u |f|, u = 2^-24:
//
//    8  an exact test accepts lines that pass at most this far outside the sphere: sphere_discriminant's `across` is
//       3 roundings on values up to |f|; b^2 - C, wrong by at most 4 |f|^2, moves the distance by 4 |f|^2 / (2 r),
//       which is less than 3 |f| where r^2 >= |f|^2 / 2
//    8  |f x a| is evaluated here as |f - (f . a) a|, 3 roundings a component, and the axis is a unit vector to 3
//    8  h is rounded 4 times, and h <= 2
//    3  r + |f| h, and the squares
//
// Together 27 < 32, so reach = r + 2^-19 max(|f|, r), rounded up, is wide enough for all. A ball that holds spheres
// with |f| <= |F| + R adds their 8, for 2 max(|F|, R), to its own 19: 35 < 64, so its reach is R + 2^-18 max(|F|, R).
#ifndef GNOMON_FAT_RAY_H
#define GNOMON_FAT_RAY_H

#include "cluster.h"

// All rays of a work-item that leave one apex, as far as `distance`.
typedef struct {
    vec3w axis;  // the same in all lanes
    floatw h, distance;
} FatRay;

// `open` says which of the rays count; at least one does. Where the axis cannot be had (rays all around) it is NaN.
static inline FatRay fat_ray(const vec3w* dir, const intw* open) {
    vec3w sum = {wide(0.0f), wide(0.0f), wide(0.0f)};
    FOR_PACKETS(k) {
        sum.x += open[k] ? dir[k].x : wide(0.0f);
        sum.y += open[k] ? dir[k].y : wide(0.0f);
        sum.z += open[k] ? dir[k].z : wide(0.0f);
    }
    const float x = REDUCE(sum, sum.x), y = REDUCE(sum, sum.y), z = REDUCE(sum, sum.z);
    const float scale = 1.0f / sqrt(fma(x, x, fma(y, y, z * z)));
    const vec3w axis = {wide(x * scale), wide(y * scale), wide(z * scale)};
    floatw widest = wide(0.0f);
    FOR_PACKETS(k) {
        const vec3w off = {dir[k].x - axis.x, dir[k].y - axis.y, dir[k].z - axis.z};
        widest = MORE(open[k] ? dot_w(off, off) : wide(0.0f), widest);
    }
    return (FatRay){axis, wide(sqrt(REDUCE(most, widest))), wide(INFINITY)};
}

// Which of 16 the fat ray may meet: those that it cannot be shown to miss, so that NaN keeps them.
static inline int candidates(FatRay fat, global const Bounds* b) {
    int kept = 0;
    for (int first = 0; first < CLUSTER; first += LANES) {
        const vec3w f = {lanes_at(b->x, first), lanes_at(b->y, first), lanes_at(b->z, first)};
        const floatw distance = lanes_at(b->distance, first), reach = lanes_at(b->reach, first);
        const vec3w across = fma_w(-dot_w(f, fat.axis), fat.axis, f);
        const floatw limit = fma(distance, fat.h, reach);
        const intw misses = (dot_w(across, across) > limit * limit) | (distance - reach > fat.distance);
        kept |= lane_bits(!(misses | (ids_at(b->id, first) < 0))) << first;
    }
    return kept;
}

#endif
