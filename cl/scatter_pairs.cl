// scatter_pairs: brings pairs into the order of one digit, the last step of a radix sort's pass. Pairs with equal
// digits keep their order.
//
// Reads pairs and places (as scan_counts left them, and counted up here). Writes sorted. One work-item: one slice.
#include "slices.h"

kernel void scatter_pairs(global const uint2* restrict pairs, const int count, const int shift, const int items,
                          global uint* restrict places, global uint2* restrict sorted, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    global uint* mine = places + (size_t)item * DIGITS;
    const Slice slice = slice_of(item, items, count);
    for (int i = slice.from; i < slice.to; ++i) {
        const uint2 pair = pairs[i];
        sorted[mine[digit_of(pair.x, shift)]++] = pair;
    }
}
