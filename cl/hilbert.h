// Places along Hilbert's curve, 10 bits an axis, 16 at a time. Neighbours on the curve are neighbours in space: runs of
// 16 fill little more than a third of the space that runs along Morton's curve do, which leaps.
//
// J. Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707 (2004) 381: coordinates to the curve's transposed
// index by exchanges and inversions of low bits, then a Gray decoding.
#ifndef GNOMON_HILBERT_H
#define GNOMON_HILBERT_H

#include "types.h"

// Spreads the low 10 bits of v to every third bit.
static inline uint16 spread(uint16 v) {
    v = (v | v << 16) & 0x030000FF;
    v = (v | v << 8) & 0x0300F00F;
    v = (v | v << 4) & 0x030C30C3;
    return (v | v << 2) & 0x09249249;
}

// All bits where this one is set, none elsewhere: as a condition a vector would count by the sign of its components.
static inline uint16 where_set(uint16 v, uint bit) { return as_uint16((v & bit) != 0); }

// Where this bit of `other` is set, inverts the lower bits of `first`; elsewhere exchanges them with those of `other`.
static inline void turn(uint bit, uint16* first, uint16* other) {
    const uint16 set = where_set(*other, bit), change = (set | (*first ^ *other)) & (bit - 1);
    *first ^= change;
    *other ^= change & ~set;
}

// KEY_BITS.
static inline uint16 hilbert_index(uint16 x, uint16 y, uint16 z) {
    for (uint bit = 1u << (HILBERT_BITS - 1); bit > 1; bit >>= 1) {
        x ^= where_set(x, bit) & (bit - 1);
        turn(bit, &x, &y);
        turn(bit, &x, &z);
    }
    y ^= x;
    z ^= y;
    uint16 flips = 0;
    for (uint bit = 1u << (HILBERT_BITS - 1); bit > 1; bit >>= 1) flips ^= where_set(z, bit) & (bit - 1);
    return spread(z ^ flips) | spread(y ^ flips) << 1 | spread(x ^ flips) << 2;
}

#endif
