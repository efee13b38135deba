// resolve: from block order to rows.
//
// Reads blocks (`components` values a ray). Writes component c to rows of plane c (planes above `components` are not
// touched); (first_x, first_y) is the pixel of the planes' first value, pitch their values a row. The bits are not
// looked at, so this serves floats and ints alike. One work-item: one row of one block, 8 pixels.
#include "types.h"

static void write_row(global const int* from, global int* to, int pixels) {
    if (pixels >= BLOCK_SIDE) {
        vstore8(vload8(0, from), 0, to);
        return;
    }
    for (int i = 0; i < pixels; ++i) to[i] = from[i];
}

kernel void resolve(global const int* restrict blocks, const int components, const Tile tile, const int width,
                    const int height, const int first_x, const int first_y, const int pitch, const int items,
                    global int* plane0, global int* plane1, global int* plane2) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    const int block = item / BLOCK_SIDE, row = item % BLOCK_SIDE;
    const int x = tile.x + block % tile.blocks_x * BLOCK_SIDE, y = tile.y + block / tile.blocks_x * BLOCK_SIDE + row;
    if (y >= height) return;
    global const int* from = blocks + (size_t)(block * components) * BLOCK_RAYS + row * BLOCK_SIDE;
    const size_t to = (size_t)(y - first_y) * (size_t)pitch + (size_t)(x - first_x);
    write_row(from, plane0 + to, width - x);
    if (components < 3) return;
    write_row(from + BLOCK_RAYS, plane1 + to, width - x);
    write_row(from + 2 * BLOCK_RAYS, plane2 + to, width - x);
}
