// generate_rays: pixel centres -> unit directions of the eye's pencil.
//
// Reads nothing. Writes dirs (3 reals a ray, block order), NaN for pixels outside the image. One work-item: PACKETS *
// LANES neighbouring rays of a block.
#include "eye_pencil.h"
#include "ray_buffers.h"

kernel void generate_rays(const EyePencil eye, const Tile tile, const int items, global real* restrict dirs,
                          const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    FOR_PACKETS(k) store_3(eye_rays(eye, tile, item, k), dirs, item, k);
}
