// From block order to rows. The bits are not looked at, so this serves floats and ints alike.
#ifndef GNOMON_RESOLVE_H
#define GNOMON_RESOLVE_H

#include "types.h"

// 8 pixels of the left block and as many of the right as there are: 16 are a cache line. Where STREAM is 1 (a CPU
// writing into the film itself), whole lines go past the caches: nothing reads them again soon, and the line need not
// be fetched before it is written.
static inline void write_row(global const int* left, global const int* right, global int* to, int pixels) {
    if (pixels < 2 * BLOCK_SIDE) {
        for (int i = 0; i < pixels; ++i) to[i] = i < BLOCK_SIDE ? left[i] : right[i - BLOCK_SIDE];
        return;
    }
#if STREAM && CLANG_TO_MACHINE
    if (((size_t)to & 63) == 0) {
        __builtin_nontemporal_store((int16)(vload8(0, left), vload8(0, right)), (global int16*)to);
        return;
    }
#endif
    vstore8(vload8(0, left), 0, to);
    vstore8(vload8(0, right), 1, to);
}

// One row of `count` neighbouring blocks, 1 or 2, of which the first is `block`; `components` values a ray.
static inline void resolve_row(global const int* blocks, int components, Tile tile, Planes planes, int block, int count,
                               int row, global int* plane0, global int* plane1, global int* plane2) {
    const int x = tile.x + block % tile.blocks_x * BLOCK_SIDE, y = tile.y + block / tile.blocks_x * BLOCK_SIDE + row;
    if (y >= planes.height) return;
    const int pixels = min(planes.width - x, count * BLOCK_SIDE);
    global const int* left = blocks + ((size_t)block * components * BLOCK_SIDE + row) * BLOCK_SIDE;
    global const int* right = left + components * BLOCK_RAYS;
    const size_t to = (size_t)(y - planes.first_y) * (size_t)planes.pitch + (size_t)(x - planes.first_x);
    write_row(left, right, plane0 + to, pixels);
    if (components < 3) return;
    write_row(left + BLOCK_RAYS, right + BLOCK_RAYS, plane1 + to, pixels);
    write_row(left + 2 * BLOCK_RAYS, right + 2 * BLOCK_RAYS, plane2 + to, pixels);
}

#endif
