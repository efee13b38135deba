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
#define as_floatw as_float
#define as_intw as_int
#else
typedef CONCAT(float, LANES) floatw;
typedef CONCAT(int, LANES) intw;
#define to_floatw CONCAT(convert_float, LANES)
#define as_floatw CONCAT(as_float, LANES)
#define as_intw CONCAT(as_int, LANES)
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

// Reductions over the lanes, by halves: the any() builtin, and horizontal builtins in general, compile to scalar code
// on PoCL.
#define REDUCE_BY_HALVES(name, type, combine)                                                              \
    static inline type name##_of_2(CONCAT(type, 2) v) { return combine(v.x, v.y); }                        \
    static inline type name##_of_4(CONCAT(type, 4) v) { return CONCAT(name, _of_2)(combine(v.lo, v.hi)); } \
    static inline type name##_of_8(CONCAT(type, 8) v) { return CONCAT(name, _of_4)(combine(v.lo, v.hi)); } \
    static inline type name##_of_16(CONCAT(type, 16) v) { return CONCAT(name, _of_8)(combine(v.lo, v.hi)); }
#define OR(a, b) ((a) | (b))
#define PLUS(a, b) ((a) + (b))
#define LESS(a, b) ((a) < (b) ? (a) : (b))  // the second where one is NaN
#define MORE(a, b) ((a) > (b) ? (a) : (b))
REDUCE_BY_HALVES(or, int, OR)
REDUCE_BY_HALVES(count, int, PLUS)
REDUCE_BY_HALVES(highest, int, MORE)
REDUCE_BY_HALVES(sum, float, PLUS)
REDUCE_BY_HALVES(least, float, LESS)
REDUCE_BY_HALVES(most, float, MORE)

#if LANES == 1
#define REDUCE(name, v) (v)
#else
#define REDUCE(name, v) CONCAT(name##_of_, LANES)(v)
#endif

// Whether a mask has any lane, and its lanes as bits. Where clang compiles for the CPU itself, one instruction (from a
// mask register) or a horizontal builtin takes the place of the halves; by way of SPIR-V neither has a translation.
#if CLANG_TO_MACHINE && LANES == 16 && defined(__AVX512DQ__)
static inline int lane_bits(intw mask) { return (ushort)__builtin_ia32_cvtd2mask512(mask); }
static inline int any_lane(intw mask) { return lane_bits(mask); }
#else
static inline int lane_bits(intw mask) { return REDUCE(or, mask & ((intw)(1) << LANE_INDEX)); }
#if CLANG_TO_MACHINE && LANES > 1
static inline int any_lane(intw mask) { return __builtin_reduce_or(mask); }
#else
static inline int any_lane(intw mask) { return REDUCE(or, mask); }
#endif
#endif

// The position of the lowest bit set.
static inline int lowest_bit(int mask) { return 31 - clz(mask & -mask); }

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

// Where packet k of work-item `item` finds component c of n in a block-ordered buffer. Unsigned, so that dividing by
// powers of two is shifting.
static inline size_t lane_address(int item, int k, int c, int n) {
    const uint first = (uint)item * (LANES * PACKETS);
    return (size_t)(first / BLOCK_RAYS * (uint)n + (uint)c) * BLOCK_RAYS + first % BLOCK_RAYS + (uint)(k * LANES);
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
static inline void store_2(floatw x, floatw y, global float* p, int item, int k) {
    *(global floatw*)(p + lane_address(item, k, 0, 2)) = x;
    *(global floatw*)(p + lane_address(item, k, 1, 2)) = y;
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
