// list_undecided: the pixels that rounding may have decided.
//
// Reads doubts (2 a ray, block order). Writes the undecided pixels, each as its place in the image row by row, to
// undecided, from undecided[1] on in any order, and adds their number to undecided[0]. One work-item: PACKETS * LANES
// neighbouring rays.
#include "ray_buffers.h"

kernel void list_undecided(global const real* restrict doubts, const Tile tile, const int width, const int height,
                           const int items, global int* restrict undecided) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    FOR_PACKETS(k) {
        const realw doubt = *(global const realw*)(doubts + lane_address(item, k, 0, 2));
        for (int rest = lane_bits(ints_of(doubt == INFINITY)); rest; rest &= rest - 1) {
            const int ray = (item * PACKETS + k) * LANES + lowest_bit(rest), block = ray / BLOCK_RAYS;
            const int i = tile.x + block % tile.blocks_x * BLOCK_SIDE + ray % BLOCK_SIDE,
                      j = tile.y + block / tile.blocks_x * BLOCK_SIDE + ray % BLOCK_RAYS / BLOCK_SIDE;
            if (i < width && j < height) undecided[1 + atomic_inc(undecided)] = j * width + i;
        }
    }
}
