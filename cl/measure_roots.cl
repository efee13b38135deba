// measure_roots: one formula of the ray/sphere intersection, alone, for `gnomon report`.
//
// Reads dirs (block order, 3 a ray) and a sphere for each block, both `items` work-items long; -D FORMULA names the
// formula (formulas.h). Writes per ray t and the outward unit normal (a miss: +inf, (inf, inf, inf)), as
// intersect_closest does. For launches that are long enough to be timed the input is gone through again and again until
// `all_items` have been written. One work-item: PACKETS * LANES neighbouring rays of a block.
#include "formulas.h"
#include "ray_buffers.h"

kernel void measure_roots(global const float* restrict dirs, global const RootSphere* restrict spheres, const int items,
                          const int all_items, global float* restrict ts, global float* restrict normals,
                          const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= all_items) return;
    const int from = item % items;
    const RootSphere sphere = spheres[(uint)from * (LANES * PACKETS) / BLOCK_RAYS];
    FOR_PACKETS(k) {
        const Root root = CONCAT(intersect_, FORMULA)(sphere, load_3(dirs, from, k));
        store_r(root.t, ts, item, k);
        store_3(root.normal, normals, item, k);
    }
}
