// scan_counts: from how often each digit comes to where it goes, the second step of a radix sort.
//
// Reads totals, and replaces counts (both of count_digits) by the place of each slice's first pair with that digit. One
// work-item: DIGITS_AN_ITEM digits.
#include "slices.h"

kernel void scan_counts(const int slices, const int items, global uint* restrict counts,
                        global const uint* restrict totals, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    const int first = item * DIGITS_AN_ITEM;
    uint place[DIGITS_AN_ITEM], next = 0;
    for (int d = 0; d < first; ++d) next += totals[d];
    for (int i = 0; i < DIGITS_AN_ITEM; ++i) {
        place[i] = next;
        next += totals[first + i];
    }
    uint16 places = vload16(0, place);
    for (int slice = 0; slice < slices; ++slice) {
        global uint* of_slice = counts + (size_t)slice * DIGITS + first;
        const uint16 count = vload16(0, of_slice);
        vstore16(places, 0, of_slice);
        places += count;
    }
}
