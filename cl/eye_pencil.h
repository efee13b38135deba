// The eye's pencil: pixel centres to unit directions, and those of a work-item's pixels as one fat ray.
#ifndef GNOMON_EYE_PENCIL_H
#define GNOMON_EYE_PENCIL_H

#include "fat_ray.h"
#include "ieee.h"

// A pixel of the image.
typedef struct {
    int i, j;
} Pixel;

// That of packet k's first ray.
INLINE Pixel first_pixel(Tile tile, int item, int k) {
    // Unsigned, so that dividing by powers of two is shifting. All packets lie in one block, which is found once.
    const uint first = (uint)item * (LANES * PACKETS), block = first / BLOCK_RAYS,
               inside = first % BLOCK_RAYS + (uint)(k * LANES), row = block / (uint)tile.blocks_x,
               column = block - row * (uint)tile.blocks_x;
    return (Pixel){tile.x + (int)(column * BLOCK_SIDE + inside % BLOCK_SIDE),
                   tile.y + (int)(row * BLOCK_SIDE + inside / BLOCK_SIDE)};
}

// Twice the distance from the image's middle, in pixels: whole numbers below 2^24, so exact as reals.
#define RIGHT_OF(eye, i) (2 * (i) + 1 - (eye).width)
#define UP_OF(eye, j) ((eye).height - 1 - 2 * (j))

// The unit directions of pixels so far from the middle.
INLINE vec3w eye_ray(EyePencil eye, realw right, realw up) {
    const vec3w along = fma_w(right, broadcast(eye.right), fma_w(up, broadcast(eye.up), broadcast(eye.forward)));
    return scale_w(divide(wide(1.0f), square_root(dot_w(along, along))), along);
}

// Those of packet k. Pixels outside the image get NaN, which meets nothing, because every comparison with it is false.
INLINE vec3w eye_rays(EyePencil eye, Tile tile, int item, int k) {
    const Pixel first = first_pixel(tile, item, k);
    const intw i = first.i + LANE_INDEX % BLOCK_SIDE, j = first.j + LANE_INDEX / BLOCK_SIDE;
    const realw right = choose(wholes_of(i < eye.width), convert_realw(RIGHT_OF(eye, i)), wide(NAN)),
                up = choose(wholes_of(j < eye.height), convert_realw(UP_OF(eye, j)), wide(NAN));
    return eye_ray(eye, right, up);
}

INLINE float dot_3(Float3 a, Float3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

// All rays of a work-item, from its corner pixels: `basis` is the camera's, so X and Y are multiples of a pixel's width
// and height, and no ray need be there where nothing is to be met. A ray is turned against its pixel by less than 5 u:
// sqrt(3) u for eye's vectors, 2 for the two fma, 1 for the last product. A pixel's width is off by 5 u, 3 of them the
// dot product's and 1 a vector, and the product by 1, which turns by half of that at most. Together that is less than
// the 11 u for X and Y in reach.h. (Rays of doubles are turned by next to nothing; here, eye's vectors are then
// rounded.)
INLINE FatRay eye_fat_ray(EyePencil eye, Tile tile, int item, Basis basis) {
    const int rays = LANES * PACKETS, columns = min(rays, BLOCK_SIDE), rows = (rays + BLOCK_SIDE - 1) / BLOCK_SIDE;
    const Pixel first = first_pixel(tile, item, 0);
    const float pixel_x = dot_3(float3_of(eye.right), basis.u), pixel_y = dot_3(float3_of(eye.up), basis.v);
    return fat_ray_between(
        pixel_x * (float)RIGHT_OF(eye, first.i), pixel_x * (float)RIGHT_OF(eye, first.i + columns - 1),
        pixel_y * (float)UP_OF(eye, first.j + rows - 1), pixel_y * (float)UP_OF(eye, first.j), basis);
}

#endif
