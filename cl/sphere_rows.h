// The spheres of the scene in the order of their ids: rows of 4 numbers, x y z radius, or more, of which the first 4
// count; and, where they are no floats, what rounding left over, in rows of 4.
#ifndef GNOMON_SPHERE_ROWS_H
#define GNOMON_SPHERE_ROWS_H

#include "types.h"

typedef struct {
    global const float *rows, *rests;
    int columns;
} SphereRows;

static inline float4 row_of(SphereRows spheres, int id) {
    return vload4(0, spheres.rows + (size_t)id * spheres.columns);
}
static inline float4 rest_of(SphereRows spheres, int id) {
#if RESTS
    return vload4(id, spheres.rests);
#else
    return (float4)(0.0f);
#endif
}

// Whether two spheres are one, to the last bit that any kernel sees (and -0 is 0).
static inline int coincide(SphereRows spheres, int a, int b) {
    if (!all(row_of(spheres, a) == row_of(spheres, b))) return 0;
    return all(rest_of(spheres, a) == rest_of(spheres, b));
}

// KEY_BITS, the same for all that coincide.
static inline uint hash_of(SphereRows spheres, int id) {
    // Adding 0 makes -0 into 0. A product and a shift for each number: Fowler, Noll and Vo's hash, on words.
    const uint4 row = as_uint4(row_of(spheres, id) + 0.0f), rest = as_uint4(rest_of(spheres, id) + 0.0f);
    const uint words[8] = {row.x, row.y, row.z, row.w, rest.x, rest.y, rest.z, rest.w};
    uint hash = 2166136261u;
    for (int i = 0; i < 8; ++i) {
        hash = (hash ^ words[i]) * 16777619u;
        hash ^= hash >> 15;
    }
    return hash >> (32 - KEY_BITS);
}

#endif
