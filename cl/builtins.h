// What the kernels use of OpenCL C's library, declared (-D DECLARE_BUILTINS=1) as the specification has it: OpenCL C
// 1.2, 6.12. PoCL has clang read all 15 000 declarations before each kernel, most of the time that a small one takes to
// build; told that they are there already (-D _OPENCL_H_, their header's guard), it does not. Types and macros, such as
// as_int16() and INFINITY, are in another header, a short one, which it reads all the same.
#ifndef GNOMON_BUILTINS_H
#define GNOMON_BUILTINS_H

#if DECLARE_BUILTINS

#define PURE __attribute__((overloadable, const))
#define READS __attribute__((overloadable, pure))
#define WRITES __attribute__((overloadable))
#define MEETS __attribute__((overloadable, convergent))  // all work-items of a group: not to be moved into a branch

// 6.12.1, work-items.
size_t PURE get_global_id(uint dimension);
size_t PURE get_local_id(uint dimension);
size_t PURE get_local_size(uint dimension);
size_t PURE get_group_id(uint dimension);
void MEETS barrier(uint fences);  // 6.12.8

// 6.12.2, floating point.
#define DECLARE_REALS(type)          \
    type PURE fabs(type);            \
    type PURE floor(type);           \
    type PURE fma(type, type, type); \
    type PURE sqrt(type);
// 6.12.7, vectors in memory. A pointer of no named space is private in OpenCL C 1.2 and generic later (PoCL 6).
#define DECLARE_VECTORS(scalar, vector, n)                 \
    vector READS vload##n(size_t, const global scalar*);   \
    vector READS vload##n(size_t, const scalar*);          \
    void WRITES vstore##n(vector, size_t, global scalar*); \
    void WRITES vstore##n(vector, size_t, scalar*);
// 6.2.3, conversions, all between types of n lanes.
#define DECLARE_CONVERSIONS(n)                \
    float##n PURE convert_float##n(int##n);   \
    float##n PURE convert_float##n(uint##n);  \
    float##n PURE convert_float##n(float##n); \
    int##n PURE convert_int##n(int##n);       \
    int##n PURE convert_int##n(uint##n);      \
    int##n PURE convert_int##n(float##n);     \
    uint##n PURE convert_uint##n(uint##n);    \
    uint##n PURE convert_uint##n(float##n);
#define DECLARE_FOR_WIDTH(n)            \
    DECLARE_REALS(float##n)             \
    DECLARE_CONVERSIONS(n)              \
    DECLARE_VECTORS(float, float##n, n) \
    DECLARE_VECTORS(int, int##n, n)     \
    DECLARE_VECTORS(uint, uint##n, n)
#define DECLARE_DOUBLES(n)                       \
    DECLARE_REALS(double##n)                     \
    DECLARE_VECTORS(double, double##n, n)        \
    double##n PURE convert_double##n(float##n);  \
    double##n PURE convert_double##n(double##n); \
    double##n PURE convert_double##n(int##n);    \
    double##n PURE convert_double##n(long##n);   \
    float##n PURE convert_float##n(double##n);   \
    float##n PURE convert_float##n(long##n);     \
    int##n PURE convert_int##n(double##n);       \
    int##n PURE convert_int##n(long##n);         \
    uint##n PURE convert_uint##n(double##n);     \
    long##n PURE convert_long##n(long##n);       \
    long##n PURE convert_long##n(int##n);        \
    long##n PURE convert_long##n(double##n);

DECLARE_REALS(float)
DECLARE_FOR_WIDTH(4)
DECLARE_FOR_WIDTH(8)
DECLARE_FOR_WIDTH(16)
DECLARE_VECTORS(float, float3, 3)
#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
DECLARE_REALS(double)
DECLARE_DOUBLES(4)
DECLARE_DOUBLES(8)
DECLARE_DOUBLES(16)
#endif

// 6.12.3, whole numbers; 6.12.6, relations; 6.12.11, atomics.
int PURE min(int, int);
int PURE max(int, int);
int PURE clz(int);
uint PURE clz(uint);
int PURE all(int4);
int PURE all(int8);
int PURE any(int4);
uint WRITES atomic_or(volatile global uint*, uint);
int WRITES atomic_or(volatile global int*, int);
int WRITES atomic_max(volatile global int*, int);
uint WRITES atomic_add(volatile global uint*, uint);
int WRITES atomic_add(volatile global int*, int);
uint WRITES atomic_add(volatile local uint*, uint);
int WRITES atomic_add(volatile local int*, int);

#endif

#endif
