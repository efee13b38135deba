// resolve: from block order to rows.
//
// Reads blocks (`components` values a ray). Writes component c to rows of plane c (planes above `components` are not
// touched); (first_x, first_y) is the pixel of the planes' first value, pitch their values a row. The bits are not
// looked at, so this serves floats and ints alike. One work-item: one row of two neighbouring blocks, 16 pixels, which
// is a cache line.
#include "types.h"

// Where STREAM is 1 (a CPU writing into the film itself), whole lines go past the caches: nothing reads them again
// soon, and the line need not be fetched before it is written.
static void write_row(global const int* left, global const int* right, global int* to, int pixels) {
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

kernel void resolve(global const int* restrict blocks, const int components, const Tile tile, const int width,
                    const int height, const int first_x, const int first_y, const int pitch, const int items,
                    global int* plane0, global int* plane1, global int* plane2) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    const int pairs = (tile.blocks_x + 1) / 2, pair = item / BLOCK_SIDE, row = item % BLOCK_SIDE;
    const int block_x = pair % pairs * 2, block_y = pair / pairs;
    const int x = tile.x + block_x * BLOCK_SIDE, y = tile.y + block_y * BLOCK_SIDE + row;
    if (y >= height) return;
    const int block_values = components * BLOCK_RAYS, blocks_here = min(2, tile.blocks_x - block_x);
    const int pixels = min(width - x, blocks_here * BLOCK_SIDE);
    global const int* left = blocks + (size_t)(block_y * tile.blocks_x + block_x) * block_values + row * BLOCK_SIDE;
    global const int* right = left + block_values;
    const size_t to = (size_t)(y - first_y) * (size_t)pitch + (size_t)(x - first_x);
    write_row(left, right, plane0 + to, pixels);
    if (components < 3) return;
    write_row(left + BLOCK_RAYS, right + BLOCK_RAYS, plane1 + to, pixels);
    write_row(left + 2 * BLOCK_RAYS, right + 2 * BLOCK_RAYS, plane2 + to, pixels);
}
