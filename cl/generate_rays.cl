// generate_rays: pixel centres -> unit directions of the eye's pencil.
//
// Reads nothing. Writes dirs (3 floats a ray, block order). One work-item: PACKETS * LANES neighbouring rays of a
// block. Pixels outside the image get NaN, which meets nothing, because every comparison with it is false.
#include "ieee.h"

kernel void generate_rays(const EyePencil eye, const Tile tile, const int items, global float* restrict dirs) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    FOR_PACKETS(k) {
        const int ray = (item * PACKETS + k) * LANES;
        const int block = ray / BLOCK_RAYS;
        const intw lane = ray % BLOCK_RAYS + LANE_INDEX;
        const intw i = tile.x + block % tile.blocks_x * BLOCK_SIDE + lane % BLOCK_SIDE;
        const intw j = tile.y + block / tile.blocks_x * BLOCK_SIDE + lane / BLOCK_SIDE;
        // Twice the distance from the image's middle, in pixels: whole numbers below 2^24, so exact.
        const floatw x = to_floatw(2 * i + 1 - eye.width), y = to_floatw(eye.height - 1 - 2 * j);
        const vec3w along = fma_w(x, broadcast(eye.right), fma_w(y, broadcast(eye.up), broadcast(eye.forward)));
        const floatw scale = divide(wide(1.0f), square_root(dot_w(along, along)));
        const intw inside = (i < eye.width) & (j < eye.height);
        store_3(scale_w(inside ? scale : wide(NAN), along), dirs, item, k);
    }
}
