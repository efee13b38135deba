// The type in which rays and spheres are computed: float or, with -D REAL_IS_DOUBLE=1, double. On the device a program
// has one of them, `real`; on the host each struct of reals is a template, NameOf<float> and NameOf<double>, and Name
// is that of floats.
#ifndef GNOMON_REAL_H
#define GNOMON_REAL_H

// For what rays and pictures are made with: inlined before anything else is done to the kernel. Where that comes later
// PoCL moves structs that go by value through memory, with LLVM 18 (PoCL 6) in pieces of other sizes than it then
// reads: intersect_closest takes 1.7 times as long, in certified pictures 2.3 times; with LLVM 15 (PoCL 3.1) 1.2 times
// where nodes are walked down. Of other drivers Oclgrind, told to inline, finds no kernel in the program.
#if CLANG_TO_MACHINE
#pragma clang diagnostic ignored "-Wpsabi"  // how wide vectors go by value differs from CPU to CPU: these never do
#define INLINE __attribute__((always_inline)) static inline
#else
#define INLINE static inline
#endif

// A function of its own, called: of what a kernel inlines PoCL compiles three copies, the kernel and two loops over a
// group's work-items, and of this one. Whoever asks which work-item it is is inlined all the same. For what takes long
// enough: shade_light, called for two blocks at once, is as fast; intersect_closest, for one, was 6 to 13 % slower.
#if CLANG_TO_MACHINE
#define APART __attribute__((noinline)) static
#else
#define APART INLINE
#endif

#ifdef __cplusplus
#define STRUCT_OF_REALS(name)     \
    template <class real>         \
    struct name##Of;              \
    using name = name##Of<float>; \
    template <class real>         \
    struct name##Of
#define OF_REALS(name) name##Of<real>
#else
#include "builtins.h"
#define STRUCT_OF_REALS(name) \
    typedef struct name name; \
    struct name
#define OF_REALS(name) name
#if REAL_IS_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define REAL double
#define WHOLE long  // as wide: comparisons of vectors give it
#else
#define REAL float
#define WHOLE int
#endif
typedef REAL real;
#endif

#endif
