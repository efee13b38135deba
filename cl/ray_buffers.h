// Lanes to and from buffers of rays, which lie there in blocks (types.h).
#ifndef GNOMON_RAY_BUFFERS_H
#define GNOMON_RAY_BUFFERS_H

#include "lanes.h"

// Where packet k of work-item `item` finds component c of n in a block-ordered buffer. Unsigned, so that dividing by
// powers of two is shifting.
INLINE size_t lane_address(int item, int k, int c, int n) {
    const uint first = (uint)item * (LANES * PACKETS);
    return (size_t)(first / BLOCK_RAYS * (uint)n + (uint)c) * BLOCK_RAYS + first % BLOCK_RAYS + (uint)(k * LANES);
}

INLINE realw load_r(global const real* p, int item, int k) {
    return *(global const realw*)(p + lane_address(item, k, 0, 1));
}
INLINE wholew load_i(global const int* p, int item, int k) {
    return wholes_of(*(global const intw*)(p + lane_address(item, k, 0, 1)));
}
INLINE vec3w load_3(global const real* p, int item, int k) {
    return (vec3w){*(global const realw*)(p + lane_address(item, k, 0, 3)),
                   *(global const realw*)(p + lane_address(item, k, 1, 3)),
                   *(global const realw*)(p + lane_address(item, k, 2, 3))};
}
INLINE void store_r(realw v, global real* p, int item, int k) { *(global realw*)(p + lane_address(item, k, 0, 1)) = v; }
INLINE void store_i(wholew v, global int* p, int item, int k) {
    *(global intw*)(p + lane_address(item, k, 0, 1)) = ints_of(v);
}
// The same in memory of the work-item's own.
INLINE void keep_3(vec3w v, private realw* p, int item, int k) {
    p[lane_address(item, k, 0, 3) / LANES] = v.x;
    p[lane_address(item, k, 1, 3) / LANES] = v.y;
    p[lane_address(item, k, 2, 3) / LANES] = v.z;
}
INLINE void store_3(vec3w v, global real* p, int item, int k) {
    *(global realw*)(p + lane_address(item, k, 0, 3)) = v.x;
    *(global realw*)(p + lane_address(item, k, 1, 3)) = v.y;
    *(global realw*)(p + lane_address(item, k, 2, 3)) = v.z;
}

#endif
