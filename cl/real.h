// The type in which rays and spheres are computed: float or, with -D REAL_IS_DOUBLE=1, double. On the device a program
// has one of them, `real`; on the host each struct of reals is a template, NameOf<float> and NameOf<double>, and Name
// is that of floats.
#ifndef GNOMON_REAL_H
#define GNOMON_REAL_H

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
