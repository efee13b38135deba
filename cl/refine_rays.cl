// refine_rays: the eye's rays of listed pixels.
//
// Reads places of pixels in the image, row by row: places[first] to places[first + count]. Writes dirs (block order, 3
// a ray) in their order; where a block has no pixel NaN, which meets nothing. Leaves none of its rays undecided (one
// bit a ray), before other kernels do. One work-item: one ray.
#include "eye_pencil.h"
#include "ray_buffers.h"

kernel void refine_rays(const EyePencil eye, global const int* restrict places, const int first, const int count,
                        const int items, global real* restrict dirs, global uint* restrict undecided,
                        const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    if (item % 32 == 0) undecided[item / 32] = 0;
    const int place = item < count ? places[first + item] : 0;
    const vec3w dir =
        eye_ray(eye, convert_realw(RIGHT_OF(eye, place % eye.width)), convert_realw(UP_OF(eye, place / eye.width)));
    store_3(item < count ? dir : broadcast((Real3){NAN, NAN, NAN}), dirs, item, 0);
}
