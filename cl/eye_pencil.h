// The eye's pencil: pixel centres to unit directions.
#ifndef GNOMON_EYE_PENCIL_H
#define GNOMON_EYE_PENCIL_H

#include "ieee.h"

// The directions of packet k. Pixels outside the image get NaN, which meets nothing, because every comparison with it
// is false.
static inline vec3w eye_rays(EyePencil eye, Tile tile, int item, int k) {
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
    return scale_w(inside ? scale : wide(NAN), along);
}

#endif
