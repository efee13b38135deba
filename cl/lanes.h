// The lane types: kernels are written once over realw, floatw and their masks, LANES values wide (1, 4, 8 or 16, set
// with -D), PACKETS of them a work-item. Every operation acts on each lane alone, so the bits do not depend on either
// number.
//
// Rays and spheres are reals (real.h). Bounds are floats always, with masks and ids of 32 bits: floatw, intw. Where
// reals are doubles, masks of reals are as wide as these, and so are ids beside them: wholew. Where reals are floats
// both pairs are one, and what converts between them does nothing.
//
// A comparison gives 1 for true when LANES is 1 and -1 when it is more; masks are therefore only ever combined with &
// and |, negated with !, and used by choose(mask, a, b), which reads both alike. Literals are floats: they widen by
// themselves.
#ifndef GNOMON_LANES_H
#define GNOMON_LANES_H

#include "types.h"

// -D FAST=1: a * b + c may be rounded once.
#if FAST
#pragma OPENCL FP_CONTRACT ON
#else
#pragma OPENCL FP_CONTRACT OFF
#endif

#define CONCAT_(a, b) a##b
#define CONCAT(a, b) CONCAT_(a, b)

#define INDEX_OF_16 ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))

#if LANES == 1
typedef float floatw;
typedef int intw;
typedef real realw;
typedef int wholew;  // comparisons of scalars give int
#define LANE_INDEX 0
#define convert_floatw (float)
#define convert_intw (int)
#define convert_realw (real)
#define convert_wholew (int)
#define as_floatw as_float
#define as_intw as_int
#else
typedef CONCAT(float, LANES) floatw;
typedef CONCAT(int, LANES) intw;
typedef CONCAT(REAL, LANES) realw;
typedef CONCAT(WHOLE, LANES) wholew;
#define convert_floatw CONCAT(convert_float, LANES)
#define convert_intw CONCAT(convert_int, LANES)
#define convert_realw CONCAT(convert_, CONCAT(REAL, LANES))
#define convert_wholew CONCAT(convert_, CONCAT(WHOLE, LANES))
#define as_floatw CONCAT(as_float, LANES)
#define as_intw CONCAT(as_int, LANES)
#if LANES == 4
#define LANE_INDEX ((int4)(0, 1, 2, 3))
#elif LANES == 8
#define LANE_INDEX ((int8)(0, 1, 2, 3, 4, 5, 6, 7))
#elif LANES == 16
#define LANE_INDEX INDEX_OF_16
#else
#error "LANES must be 1, 4, 8 or 16"
#endif
#endif

#define wide(x) ((realw)(x))
#define wide_float(x) ((floatw)(x))
// Whether a work-item's rays are all those of a block: what is kept of that is then nobody else's.
#define IS_BLOCK (LANES * PACKETS == BLOCK_RAYS)
// What 4 packets of a block have stays in the 32 registers that a CPU with vectors of 16 has. Narrower vectors are
// more, and registers 16 or so: from memory, in a loop that is one, intersect_closest is a tenth faster, and compiled
// sooner.
#if PACKETS > 4
#define FOR_PACKETS(k) ONE_PACKET_AT_A_TIME(k)
#else
#define FOR_PACKETS(k) _Pragma("unroll") for (int k = 0; k < PACKETS; ++k)
#endif
#define ONE_AT_A_TIME _Pragma("unroll 1")                                        // less code
#define ONE_PACKET_AT_A_TIME(k) ONE_AT_A_TIME for (int k = 0; k < PACKETS; ++k)  // but in memory

// Between the two pairs of types.
#if REAL_IS_DOUBLE
#define floats_of(v) convert_floatw(v)
#define ints_of(v) convert_intw(v)
#define wholes_of(v) convert_wholew(v)
#else
#define floats_of(v) (v)
#define ints_of(v) (v)
#define wholes_of(v) (v)
#endif

// Reductions over the lanes, by halves: the any() builtin, and horizontal builtins in general, compile to scalar code
// on PoCL.
#define REDUCE_BY_HALVES(name, type, combine)                                                       \
    INLINE type name##_of_2(CONCAT(type, 2) v) { return combine(v.x, v.y); }                        \
    INLINE type name##_of_4(CONCAT(type, 4) v) { return CONCAT(name, _of_2)(combine(v.lo, v.hi)); } \
    INLINE type name##_of_8(CONCAT(type, 8) v) { return CONCAT(name, _of_4)(combine(v.lo, v.hi)); } \
    INLINE type name##_of_16(CONCAT(type, 16) v) { return CONCAT(name, _of_8)(combine(v.lo, v.hi)); }
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

// A mask of bounds as bits, and whether a mask of reals has any lane. Where clang compiles for the CPU itself, one
// instruction (from a mask register, or of signs) or a horizontal builtin takes the place of the halves; by way of
// SPIR-V neither has a translation.
#if CLANG_TO_MACHINE && defined(__AVX__)
INLINE int bits_of_8(int8 mask) { return __builtin_ia32_movmskps256(as_float8(mask)); }
#endif
#if CLANG_TO_MACHINE && defined(__AVX512DQ__)
INLINE int bits_of_16(int16 mask) { return (ushort)__builtin_ia32_cvtd2mask512(mask); }
#elif CLANG_TO_MACHINE && defined(__AVX__)
INLINE int bits_of_16(int16 mask) { return bits_of_8(mask.lo) | bits_of_8(mask.hi) << 8; }
#else
INLINE int bits_of_16(int16 mask) { return or_of_16(mask & (int16)(1) << INDEX_OF_16); }
#endif
#if CLANG_TO_MACHINE && LANES >= 8 && defined(__AVX__)
INLINE int lane_bits(intw mask) { return CONCAT(bits_of_, LANES)(mask); }
#else
INLINE int lane_bits(intw mask) { return REDUCE(or, mask & ((intw)(1) << LANE_INDEX)); }
#endif
#if CLANG_TO_MACHINE && LANES == 16 && defined(__AVX512DQ__)
INLINE int any_lane(wholew mask) { return lane_bits(ints_of(mask)); }
#elif CLANG_TO_MACHINE && LANES > 1
INLINE int any_lane(wholew mask) { return __builtin_reduce_or(mask) != 0; }
#else
INLINE int any_lane(wholew mask) { return REDUCE(or, ints_of(mask)); }
#endif

// a where the mask holds, else b. In OpenCL C that is `mask ? a : b`, of which clang makes and, or and not of bits
// where a, b are vectors; told so, it blends, keeps masks in mask registers if there are any, and sees a minimum in
// LESS_WHERE.
#if CLANG_TO_MACHINE && LANES == 16 && defined(__AVX512DQ__) && !REAL_IS_DOUBLE
#define BLEND(which, mask, a, b) which((ushort)lane_bits(mask), a, b)
INLINE floatw __attribute__((overloadable)) choose(intw mask, floatw a, floatw b) {
    return as_floatw(BLEND(__builtin_ia32_selectps_512, mask, a, b));
}
INLINE intw __attribute__((overloadable)) choose(intw mask, intw a, intw b) {
    return as_intw(BLEND(__builtin_ia32_selectd_512, mask, a, b));
}
#elif CLANG_TO_MACHINE && LANES == 8 && defined(__AVX__) && !REAL_IS_DOUBLE
INLINE floatw __attribute__((overloadable)) choose(intw mask, floatw a, floatw b) {
    return __builtin_ia32_blendvps256(b, a, as_floatw(mask));
}
INLINE intw __attribute__((overloadable)) choose(intw mask, intw a, intw b) {
    return as_intw(choose(mask, as_floatw(a), as_floatw(b)));
}
#else
#define choose(mask, a, b) ((mask) ? (a) : (b))
#endif

// The less, or more, of a and b where the mask holds, else b.
#define LESS_WHERE(mask, a, b) choose(mask, choose((a) < (b), a, b), b)
#define MORE_WHERE(mask, a, b) choose(mask, choose((a) > (b), a, b), b)

#define ALL_LANES ((1 << LANES) - 1)
INLINE intw lanes_of_bits(int bits) { return ((intw)(bits) >> LANE_INDEX & 1) != 0; }

// A condition that hardly ever holds.
#if CLANG_TO_MACHINE
#define UNLIKELY(condition) __builtin_expect((condition) != 0, 0)
#else
#define UNLIKELY(condition) (condition)
#endif

// One lane's value.
#define LANE_OF(v, lane) (((const real*)&(v))[lane])

// The position of the lowest bit set, of which there is one.
#if CLANG_TO_MACHINE
INLINE int lowest_bit(int mask) { return __builtin_ctz((uint)mask); }
#else
INLINE int lowest_bit(int mask) { return 31 - clz(mask & -mask); }
#endif

// Three components of LANES rays.
typedef struct {
    realw x, y, z;
} vec3w;

// Sums of three products in one fixed order, two roundings fewer than without fma.
INLINE realw dot_w(vec3w a, vec3w b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
INLINE realw dot_r(Real3 a, vec3w b) { return fma(wide(a.x), b.x, fma(wide(a.y), b.y, wide(a.z) * b.z)); }
// s a, and s a + b, one rounding a component.
INLINE vec3w scale_w(realw s, vec3w a) { return (vec3w){s * a.x, s * a.y, s * a.z}; }
INLINE vec3w fma_w(realw s, vec3w a, vec3w b) { return (vec3w){fma(s, a.x, b.x), fma(s, a.y, b.y), fma(s, a.z, b.z)}; }
INLINE vec3w broadcast(Real3 a) { return (vec3w){wide(a.x), wide(a.y), wide(a.z)}; }
INLINE vec3w select_w(wholew mask, vec3w a, vec3w b) {
    return (vec3w){choose(mask, a.x, b.x), choose(mask, a.y, b.y), choose(mask, a.z, b.z)};
}

// The same for bounds.
typedef struct {
    floatw x, y, z;
} float3w;
INLINE float3w floats_of_3(vec3w a) { return (float3w){floats_of(a.x), floats_of(a.y), floats_of(a.z)}; }
INLINE floatw dot_f(Float3 a, float3w b) {
    return fma(wide_float(a.x), b.x, fma(wide_float(a.y), b.y, wide_float(a.z) * b.z));
}

// Bounds are held against a work-item so many at a time, whatever its LANES: where clang compiles for the CPU itself
// all 16 of a cluster or a node.
#if CLANG_TO_MACHINE
#define BOUND_LANES 16
typedef float16 floatb;
typedef int16 intb;
#define bound_bits bits_of_16
#define convert_floatb convert_float16
typedef CONCAT(REAL, 16) realb;
#else
#define BOUND_LANES LANES
typedef floatw floatb;
typedef intw intb;
#define bound_bits lane_bits
#define convert_floatb convert_floatw
typedef realw realb;
#endif
typedef struct {
    floatb x, y, z;
} float3b;
INLINE floatb dot_b(Float3 a, float3b b) {
    return fma((floatb)(a.x), b.x, fma((floatb)(a.y), b.y, (floatb)(a.z) * b.z));
}

// Which bounds lie beyond others, EXCEEDS(a, b) for a > b, and `either` of two such. Without AVX-512's mask registers
// LLVM packs masks that are combined to words and bytes and widens the result again, which is half of what it costs to
// hold a cluster against a ray: there it is by how much, a - b, of which the larger is kept, or the second where one is
// NaN (inf - inf). A difference is above 0 only if a > b, since rounding is monotonic; where it is flushed to 0, or is
// NaN, what lies beyond is kept, as what is near may be.
#if CLANG_TO_MACHINE && defined(__AVX__) && !defined(__AVX512F__)
typedef floatb Beyond;
#define EXCEEDS(a, b) ((a) - (b))
INLINE Beyond either(Beyond a, Beyond b) { return a > b ? a : b; }
INLINE Beyond beyond_where(intb mask) { return mask ? (floatb)(INFINITY) : (floatb)(-INFINITY); }
INLINE intb mask_of(Beyond beyond) { return beyond > 0.0f; }
#else
typedef intb Beyond;
#define EXCEEDS(a, b) ((a) > (b))
INLINE Beyond either(Beyond a, Beyond b) { return a | b; }
INLINE Beyond beyond_where(intb mask) { return mask; }
INLINE intb mask_of(Beyond beyond) { return beyond; }
#endif

// Those that lie beyond nothing, as bits.
INLINE int bits_within(Beyond beyond) { return ~bound_bits(mask_of(beyond)) & ((1 << BOUND_LANES) - 1); }

INLINE Float3 float3_of(Real3 a) { return (Float3){(float)a.x, (float)a.y, (float)a.z}; }

#endif
