// resolve: from block order to rows.
//
// Reads blocks (`components` values a ray: words or, with -D REAL_IS_DOUBLE=1, doubles, which become floats). Writes
// component c to rows of plane c (planes above `components` are not touched). One work-item: one row of two
// neighbouring blocks, 16 pixels, which is a cache line.
#include "types.h"
#if REAL_IS_DOUBLE
#define WORD double
#else
#define WORD int
#endif
#define FROM global
#include "resolve.h"

kernel void resolve(global const word* restrict blocks, const int components, const Tile tile, const Planes planes,
                    const int items, global int* plane0, global int* plane1, global int* plane2, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    const Pair pair = pair_of(tile, item / BLOCK_SIDE);
    resolve_row(blocks + (size_t)pair.first * (size_t)components * BLOCK_RAYS, components, tile, planes, pair,
                item % BLOCK_SIDE, plane0, plane1, plane2);
}
