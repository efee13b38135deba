// The lane type: kernels are written once over floatw and intw, LANES values wide (1, 4, 8 or 16, set with -D), PACKETS
// of them a work-item. Every operation acts on each lane alone, so the bits do not depend on either number.
//
// A comparison gives 1 for true when LANES is 1 and -1 when it is more; masks are therefore only ever combined with &
// and |, negated with !, and used by `mask ? a : b`, which reads both alike.
#ifndef GNOMON_LANES_H
#define GNOMON_LANES_H

#include "types.h"

#pragma OPENCL FP_CONTRACT OFF

#define CONCAT_(a, b) a##b
#define CONCAT(a, b) CONCAT_(a, b)

#if LANES == 1
typedef float floatw;
typedef int intw;
#define LANE_INDEX 0
#define to_floatw(i) ((float)(i))
#else
typedef CONCAT(float, LANES) floatw;
typedef CONCAT(int, LANES) intw;
#define to_floatw CONCAT(convert_float, LANES)
#if LANES == 4
#define LANE_INDEX ((int4)(0, 1, 2, 3))
#elif LANES == 8
#define LANE_INDEX ((int8)(0, 1, 2, 3, 4, 5, 6, 7))
#elif LANES == 16
#define LANE_INDEX ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#else
#error "LANES must be 1, 4, 8 or 16"
#endif
#endif

#define wide(x) ((floatw)(x))
#define FOR_PACKETS(k) _Pragma("unroll") for (int k = 0; k < PACKETS; ++k)

// Reductions over the lanes by halves: the any() builtin, and horizontal builtins in general, compile to scalar code on
// PoCL.
static inline int or_of_2(int2 v) { return v.x | v.y; }
static inline int or_of_4(int4 v) { return or_of_2(v.lo | v.hi); }
static inline int or_of_8(int8 v) { return or_of_4(v.lo | v.hi); }
static inline int or_of_16(int16 v) { return or_of_8(v.lo | v.hi); }
static inline int max_of_2(int2 v) { return v.x > v.y ? v.x : v.y; }
static inline int max_of_4(int4 v) { return max_of_2(v.lo > v.hi ? v.lo : v.hi); }
static inline int max_of_8(int8 v) { return max_of_4(v.lo > v.hi ? v.lo : v.hi); }
static inline int max_of_16(int16 v) { return max_of_8(v.lo > v.hi ? v.lo : v.hi); }
static inline int sum_of_2(int2 v) { return v.x + v.y; }
static inline int sum_of_4(int4 v) { return sum_of_2(v.lo + v.hi); }
static inline int sum_of_8(int8 v) { return sum_of_4(v.lo + v.hi); }
static inline int sum_of_16(int16 v) { return sum_of_8(v.lo + v.hi); }

#if LANES == 1
static inline int any_lane(intw mask) { return mask; }
static inline int max_lane(intw v) { return v; }
static inline int sum_lanes(intw v) { return v; }
#else
#if defined(__has_builtin)
#if __has_builtin(__builtin_reduce_or)
#define GNOMON_REDUCE_OR
#endif
#endif
#ifdef GNOMON_REDUCE_OR
static inline int any_lane(intw mask) { return __builtin_reduce_or(mask); }
#else
static inline int any_lane(intw mask) { return CONCAT(or_of_, LANES)(mask); }
#endif
static inline int max_lane(intw v) { return CONCAT(max_of_, LANES)(v); }
static inline int sum_lanes(intw v) { return CONCAT(sum_of_, LANES)(v); }
#endif

// Three components of LANES rays.
typedef struct {
    floatw x, y, z;
} vec3w;

// Sums of three products in one fixed order, two roundings fewer than without fma.
static inline floatw dot_w(vec3w a, vec3w b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
static inline floatw dot_f(Float3 a, vec3w b) { return fma(wide(a.x), b.x, fma(wide(a.y), b.y, wide(a.z) * b.z)); }
// s a, and s a + b, one rounding a component.
static inline vec3w scale_w(floatw s, vec3w a) { return (vec3w){s * a.x, s * a.y, s * a.z}; }
static inline vec3w fma_w(floatw s, vec3w a, vec3w b) {
    return (vec3w){fma(s, a.x, b.x), fma(s, a.y, b.y), fma(s, a.z, b.z)};
}
static inline vec3w broadcast(Float3 a) { return (vec3w){wide(a.x), wide(a.y), wide(a.z)}; }
static inline vec3w select_w(intw mask, vec3w a, vec3w b) {
    return (vec3w){mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

// Where packet k of work-item `item` finds component c of n in a block-ordered buffer.
static inline size_t lane_address(int item, int k, int c, int n) {
    const int ray = (item * PACKETS + k) * LANES;
    return (size_t)(ray / BLOCK_RAYS * n + c) * BLOCK_RAYS + (size_t)(ray % BLOCK_RAYS);
}

static inline floatw load_f(global const float* p, int item, int k) {
    return *(global const floatw*)(p + lane_address(item, k, 0, 1));
}
static inline intw load_i(global const int* p, int item, int k) {
    return *(global const intw*)(p + lane_address(item, k, 0, 1));
}
static inline vec3w load_3(global const float* p, int item, int k) {
    return (vec3w){*(global const floatw*)(p + lane_address(item, k, 0, 3)),
                   *(global const floatw*)(p + lane_address(item, k, 1, 3)),
                   *(global const floatw*)(p + lane_address(item, k, 2, 3))};
}
static inline void store_f(floatw v, global float* p, int item, int k) {
    *(global floatw*)(p + lane_address(item, k, 0, 1)) = v;
}
static inline void store_i(intw v, global int* p, int item, int k) {
    *(global intw*)(p + lane_address(item, k, 0, 1)) = v;
}
static inline void store_3(vec3w v, global float* p, int item, int k) {
    *(global floatw*)(p + lane_address(item, k, 0, 3)) = v.x;
    *(global floatw*)(p + lane_address(item, k, 1, 3)) = v.y;
    *(global floatw*)(p + lane_address(item, k, 2, 3)) = v.z;
}

#endif
