// The eye's pencil: pixel centres to unit directions.
#ifndef GNOMON_EYE_PENCIL_H
#define GNOMON_EYE_PENCIL_H

#include "ieee.h"

// The directions of packet k. Pixels outside the image get NaN, which meets nothing, because every comparison with it
// is false.
static inline vec3w eye_rays(EyePencil eye, Tile tile, int item, int k) {
    // Unsigned, so that dividing by powers of two is shifting.
    const uint ray = ((uint)item * PACKETS + (uint)k) * LANES, block = ray / BLOCK_RAYS,
               row = block / (uint)tile.blocks_x;
    const int x = tile.x + (int)(block - row * (uint)tile.blocks_x) * BLOCK_SIDE, y = tile.y + (int)row * BLOCK_SIDE;
    const intw lane = (int)(ray % BLOCK_RAYS) + LANE_INDEX;
    const intw i = x + lane % BLOCK_SIDE, j = y + lane / BLOCK_SIDE;
    // Twice the distance from the image's middle, in pixels: whole numbers below 2^24, so exact.
    const floatw right = to_floatw(2 * i + 1 - eye.width), up = to_floatw(eye.height - 1 - 2 * j);
    const vec3w along = fma_w(right, broadcast(eye.right), fma_w(up, broadcast(eye.up), broadcast(eye.forward)));
    const floatw scale = divide(wide(1.0f), square_root(dot_w(along, along)));
    const intw inside = (i < eye.width) & (j < eye.height);
    return scale_w(inside ? scale : wide(NAN), along);
}

#endif
