// scan_counts: from how often each digit comes to where it goes, the second step of a radix sort.
//
// Reads totals, and replaces counts (both of count_digits) by the place of each slice's first pair with that digit. One
// work-item: one digit.
#include "slices.h"

kernel void scan_counts(const int slices, const int items, global uint* restrict counts,
                        global const uint* restrict totals, const int first_item) {
    const int digit = first_item + (int)get_global_id(0);
    if (digit >= items) return;
    uint place = 0;
    for (int d = 0; d < digit; ++d) place += totals[d];
    for (int slice = 0; slice < slices; ++slice) {
        global uint* count = counts + (size_t)slice * DIGITS + digit;
        const uint here = *count;
        *count = place;
        place += here;
    }
}
