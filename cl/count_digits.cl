// count_digits: how often each digit comes, the first step of a radix sort.
//
// Reads pairs of key and value. Writes counts (DIGITS for each slice) and adds them to totals[digit], which start at 0.
// One work-item: one slice.
#include "slices.h"

kernel void count_digits(global const uint2* restrict pairs, const int count, const int shift, const int items,
                         global uint* restrict counts, global uint* restrict totals, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    global uint* mine = counts + (size_t)item * DIGITS;
    for (int d = 0; d < DIGITS; ++d) mine[d] = 0;
    const Slice slice = slice_of(item, items, count);
    for (int i = slice.from; i < slice.to; ++i) ++mine[digit_of(pairs[i].x, shift)];
    for (int d = 0; d < DIGITS; ++d)
        if (mine[d] > 0) atomic_add(totals + d, mine[d]);
}
