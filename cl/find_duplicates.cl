// find_duplicates: the sorted spheres without those that coincide with one of a lower id.
//
// Reads sorted pairs of key and row, and the rows. Writes order: the row for each place, or -1 for a sphere that is
// there already. Coincident spheres have equal keys, and those are neighbours in the order of their ids: looking back
// over them finds the first. Runs of more than max_run equal keys are not looked through; crowded then becomes 1, and
// the spheres must be sorted by longer keys (sphere_keys). Those end with a hash: after them (hashed = 1) looking back
// ends where the hash changes, and no run is too long, for spheres with equal hashes coincide or are few.
// One work-item: 16 places.
#include "sphere_rows.h"

static int is_duplicate(SphereRows spheres, global const uint2* sorted, int place, int hashed) {
    const uint2 own = sorted[place];
    const uint hash = hashed ? hash_of(spheres, (int)own.y) : 0;
    for (int i = place - 1; i >= 0 && sorted[i].x == own.x; --i) {
        if (coincide(spheres, (int)sorted[i].y, (int)own.y)) return 1;
        if (hashed && hash_of(spheres, (int)sorted[i].y) != hash) return 0;
    }
    return 0;
}

kernel void find_duplicates(global const float* restrict rows, global const float* restrict rests, const int columns,
                            global const uint2* restrict sorted, const int hashed, const int max_run, const int count,
                            const int items, global int* restrict order, global int* restrict crowded,
                            const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    const SphereRows spheres = {rows, rests, columns};
    for (int place = item * CLUSTER; place < min((item + 1) * CLUSTER, count); ++place) {
        const uint2 own = sorted[place];
        order[place] = (int)own.y;
        if (place == 0 || sorted[place - 1].x != own.x) continue;
        if (place >= max_run && sorted[place - max_run].x == own.x)
            *crowded = 1;
        else if (is_duplicate(spheres, sorted, place, hashed))
            order[place] = -1;
    }
}
