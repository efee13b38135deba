// Sorting walks over slices of neighbouring pairs, one a work-item.
#ifndef GNOMON_SLICES_H
#define GNOMON_SLICES_H

#include "types.h"

typedef struct {
    int from, to;
} Slice;

static inline Slice slice_of(int item, int slices, int count) {
    const int size = (count + slices - 1) / slices, from = min(item * size, count);
    return (Slice){from, min(from + size, count)};
}

static inline uint digit_of(uint key, int shift) { return key >> shift & (DIGITS - 1); }

#endif
