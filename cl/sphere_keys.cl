// sphere_keys: one word of the key by which spheres are sorted.
//
// Reads the rows and, unless this is the first word, the spheres' order so far (pairs' second halves). Writes pairs of
// word and row. Words, the most significant first: 0, size class and the first 10 bits of each coordinate; 1 and 2, the
// next 10 bits each; 3, a hash that is the same for spheres that coincide. Words other than the first are for scenes in
// which many spheres lie close together. One work-item: 16 spheres.
#include "hilbert.h"
#include "sphere_rows.h"
#include "two_reals.h"

// Spheres much larger than most would spoil the bounds of their small neighbours: those of more than MUCH_LARGER times
// the middle radius come after the others, by factors of 64. Where there are none the host says that the middle is
// infinite.
static inline uint16 size_class(float16 radius, float middle) {
    const float first = MUCH_LARGER * middle;
    const int16 larger = (radius > first) + (radius > 64.0f * first) + (radius > 4096.0f * first);
    return as_uint16(-larger);
}

// 10 bits of a place along an axis: those before the point, or, for later words, the next ones.
static inline uint16 digits(TwoReals place, int word) {
    const float cells = 1 << HILBERT_BITS;
    for (int i = 0; i < word; ++i)
        place = two_sum((place.hi - floor(place.hi)) * cells, place.lo * cells);  // all exact
    const float16 inside = place.hi > cells - 1 ? (float16)(cells - 1) : place.hi;
    return convert_uint16(inside > 0.0f ? inside : (float16)(0.0f));
}

// In cells of the coarsest grid, from the corner of the box: `scale` is a power of two, so this is exact but for what
// is added to the rest.
static inline TwoReals place_of(const float* at, const float* rest, float low, float scale) {
    const TwoReals offset = two_difference(number_of(vload16(0, at), vload16(0, rest)), low, 0.0f);
    return two(offset.hi * scale, offset.lo * scale);
}

// `low` is the corner of the box around all centres; `scale` 2^10 over its longest side, or less.
kernel void sphere_keys(global const float* restrict rows, global const float* restrict rests, const int columns,
                        global const uint2* restrict sorted, const int first, const int word, const Float3 low,
                        const float scale, const float middle_radius, const int count, const int items,
                        global uint2* restrict pairs, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    const SphereRows spheres = {rows, rests, columns};
    float x[CLUSTER], y[CLUSTER], z[CLUSTER], radius[CLUSTER];
    float x_rest[CLUSTER], y_rest[CLUSTER], z_rest[CLUSTER];
    uint id[CLUSTER], key[CLUSTER];
    const int here = min(CLUSTER, count - item * CLUSTER);
    for (int i = 0; i < CLUSTER; ++i) {
        const int place = item * CLUSTER + min(i, here - 1);
        id[i] = first ? (uint)place : sorted[place].y;
        const float4 row = row_of(spheres, (int)id[i]), rest = rest_of(spheres, (int)id[i]);
        x[i] = row.x;
        y[i] = row.y;
        z[i] = row.z;
        radius[i] = row.w;
        x_rest[i] = rest.x;
        y_rest[i] = rest.y;
        z_rest[i] = rest.z;
    }
    if (word == HASH_WORD) {
        for (int i = 0; i < here; ++i) pairs[item * CLUSTER + i] = (uint2)(hash_of(spheres, (int)id[i]), id[i]);
        return;
    }
    uint16 index =
        hilbert_index(digits(place_of(x, x_rest, low.x, scale), word), digits(place_of(y, y_rest, low.y, scale), word),
                      digits(place_of(z, z_rest, low.z, scale), word));
    if (word == 0) index |= size_class(vload16(0, radius), middle_radius) << KEY_BITS;
    vstore16(index, 0, key);
    for (int i = 0; i < here; ++i) pairs[item * CLUSTER + i] = (uint2)(key[i], id[i]);
}
