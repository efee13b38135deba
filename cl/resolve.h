// From block order to rows. Whoever includes this says with WORD what a value is: an int, of which the bits are not
// looked at, or a real; doubles, with -D REAL_IS_DOUBLE=1, are rounded to floats; and with FROM in which address space
// blocks lie.
#ifndef GNOMON_RESOLVE_H
#define GNOMON_RESOLVE_H

#include "types.h"

typedef WORD word;
#if REAL_IS_DOUBLE
INLINE int word_of(word value) { return as_int((float)value); }
INLINE int8 words_of(FROM const word* values) { return as_int8(convert_float8(vload8(0, values))); }
#else
INLINE int word_of(word value) { return as_int(value); }
INLINE int8 words_of(FROM const word* values) { return as_int8(vload8(0, values)); }
#endif

// Two neighbouring blocks or, at a tile's right end, one.
typedef struct {
    int first, count;
} Pair;

INLINE Pair pair_of(Tile tile, int pair) {
    const int pairs = (tile.blocks_x + 1) / 2, x = pair % pairs * 2;
    return (Pair){pair / pairs * tile.blocks_x + x, min(2, tile.blocks_x - x)};
}

// 8 pixels of the left block and as many of the right as there are: 16 are a cache line. Where STREAM is 1 (a CPU
// writing into the film itself), whole lines go past the caches: nothing reads them again soon, and the line need not
// be fetched before it is written.
INLINE void write_row(FROM const word* left, FROM const word* right, global int* to, int pixels) {
    if (pixels < 2 * BLOCK_SIDE) {
        for (int i = 0; i < pixels; ++i) to[i] = word_of(i < BLOCK_SIDE ? left[i] : right[i - BLOCK_SIDE]);
        return;
    }
#if STREAM && CLANG_TO_MACHINE
    if (((size_t)to & 63) == 0) {
        __builtin_nontemporal_store((int16)(words_of(left), words_of(right)), (global int16*)to);
        return;
    }
#endif
    vstore8(words_of(left), 0, to);
    vstore8(words_of(right), 1, to);
}

// One row of a pair, of which `blocks` has the first; `components` values a ray.
INLINE void resolve_row(FROM const word* blocks, int components, Tile tile, Planes planes, Pair pair, int row,
                        global int* plane0, global int* plane1, global int* plane2) {
    const int x = tile.x + pair.first % tile.blocks_x * BLOCK_SIDE,
              y = tile.y + pair.first / tile.blocks_x * BLOCK_SIDE + row;
    if (y >= planes.height) return;
    const int pixels = min(planes.width - x, pair.count * BLOCK_SIDE);
    FROM const word* left = blocks + row * BLOCK_SIDE;
    FROM const word* right = left + components * BLOCK_RAYS;
    const size_t to = (size_t)(y - planes.first_y) * (size_t)planes.pitch + (size_t)(x - planes.first_x);
    write_row(left, right, plane0 + to, pixels);
    if (components < 3) return;
    write_row(left + BLOCK_RAYS, right + BLOCK_RAYS, plane1 + to, pixels);
    write_row(left + 2 * BLOCK_RAYS, right + 2 * BLOCK_RAYS, plane2 + to, pixels);
}

#endif
