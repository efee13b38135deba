// What intersect_closest hands on: the hits of each packet, and how many they are (receivers.h reads them).
#ifndef GNOMON_HITS_OUT_H
#define GNOMON_HITS_OUT_H

#include "closest_hit.h"
#include "ray_buffers.h"

typedef struct {
    global real *positions, *normals;
    global int* ids;
#if HITS == HITS_ALL
    global real* ts;
#endif
} HitsOut;
#if HITS == HITS_ALL
#define HITS_OUT \
    { positions, normals, ids, ts }
#else
#define HITS_OUT \
    { positions, normals, ids }
#endif

INLINE void store_hit(Hit hit, vec3w position, vec3w normal, HitsOut out, int item, int k) {
    store_i(hit.id, out.ids, item, k);
#if HITS == HITS_ALL
    store_r(hit.t, out.ts, item, k);
#else
    if (LANES > 1 && !any_lane(hit.id >= 0)) return;
#endif
    store_3(position, out.positions, item, k);
    store_3(normal, out.normals, item, k);
}

INLINE void store_misses(HitsOut out, int item) {
    const vec3w infinite = broadcast((Real3){INFINITY, INFINITY, INFINITY});
    FOR_PACKETS(k) store_hit(no_hit(), infinite, infinite, out, item, k);
}

// Says how many rays of the block hit or, of what is not all of it or of the first chunk alone, how many more. Where
// nobody else adds to it, not at once: an atomic waits until all that was stored before it has reached the cache, a
// tenth of this kernel's time.
INLINE void count_hits(global int* counts, int item, int more) {
    global int* count = counts + (uint)item * (LANES * PACKETS) / BLOCK_RAYS;
#if IS_BLOCK && CHUNKS
    *count += more;
#elif IS_BLOCK
    *count = more;
#else
    atomic_add(count, more);
#endif
}

#endif
