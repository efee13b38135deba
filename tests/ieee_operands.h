// Quotients and roots with their correctly rounded results, the hardest among them, and kernels that compute them.
#pragma once

#include "kernel_harness.h"

namespace gnomon::test {

// What follows generate_rays.cl, which brings ieee.h with it. Values, not rays: LANES of them a work-item.
inline const char* const ieee_kernels = R"(
kernel void test_divide(global const float* a, global const float* b, int items, global float* result) {
    const int i = (int)get_global_id(0);
    if (i < items) store_r(divide(load_r(a, i, 0), load_r(b, i, 0)), result, i, 0);
}
kernel void test_root(global const float* a, global const float* b, int items, global float* result) {
    const int i = (int)get_global_id(0);
    if (i < items) store_r(square_root(load_r(a, i, 0)), result, i, 0);
}
kernel void test_correct_quotient(global const float* a, global const float* b, global const float* q,
                                  global const float* r, int items, global float* result) {
    const int i = (int)get_global_id(0);
    if (i < items)
        store_r(correct_quotient(load_r(a, i, 0), load_r(b, i, 0), load_r(q, i, 0), load_r(r, i, 0)), result, i, 0);
}
kernel void test_correct_root(global const float* a, global const float* b, global const float* s,
                              global const float* h, int items, global float* result) {
    const int i = (int)get_global_id(0);
    if (i < items) store_r(correct_root(load_r(a, i, 0), load_r(s, i, 0), load_r(h, i, 0)), result, i, 0);
}
)";

/// Of random sign, significand and, between 2^-e and 2^e, exponent.
inline float any_float(Random& random, int e) {
    const double significand = 1 + static_cast<double>(random.word() >> 41) * 0x1p-23;
    const int exponent = static_cast<int>(random.uniform(-e, e));
    return static_cast<float>(std::ldexp(random.word() & 1 ? significand : -significand, exponent));
}

struct Operands {
    std::vector<float> a, b, quotient, root;  ///< root: of |a|
};

/// The b and the odd m of 25 bits, the middle of two floats, with a 2^25 = b m - 1 or + 1: a / b could not be closer to
/// it, 2^-48.
inline void hard_quotient(Random& random, float& a, float& b) {
    for (;;) {
        const uint64_t odd = (1 << 23) | random.word() % (1 << 23) | 1, one = random.word() & 1 ? 1 : ~uint64_t{0};
        uint64_t inverse = odd;  // by Newton's iteration: of 3 bits, 6, 12, 24, 48
        for (int i = 0; i < 4; ++i) inverse *= 2 - odd * inverse;
        const uint64_t m = inverse * one % (1 << 25);
        if (m < 1 << 24) continue;
        a = static_cast<float>((odd * m - one) >> 25);
        b = static_cast<float>(odd);
        return;
    }
}

/// An odd m of 25 bits, the middle of two floats, whose square is a 2^25 or a 2^26 but for a number `rest` of 1 modulo
/// 8 (only these have roots, found bit by bit).
inline float hard_square(int64_t rest) {
    int64_t m = 1;
    for (int bit = 3; bit < 26; ++bit)
        if ((m * m - rest) % (int64_t{2} << bit) != 0) m += int64_t{1} << (bit - 1);
    m %= 1 << 25;
    if (m < 1 << 24) m = (1 << 25) - m;
    return static_cast<float>(static_cast<double>(m * m - rest) * 0x1p-48);
}

/// In turn: any operands, and the hardest for the quotient and for the root. The expected values are rounded twice, to
/// double and to float, which is the same as once: for p = 24 bits, 2 p + 2 <= 53 (S. Figueroa, "When is double
/// rounding innocuous?", SIGNUM Newsletter 30(3), 1995).
inline Operands operands(size_t count, int exponents) {
    Random random(5);
    Operands o;
    for (size_t i = 0; i < count; ++i) {
        float a = any_float(random, exponents), b = any_float(random, exponents);
        if (i % 4 == 1) {
            hard_quotient(random, a, b);
            a = std::ldexp(i % 8 == 1 ? -a : a, static_cast<int>(random.uniform(-40, 0)));
        }
        if (i % 4 == 2) a = std::ldexp(hard_square(8 * static_cast<int64_t>(random.word() % 9) - 31), i % 8 ? 4 : -6);
        o.a.push_back(a);
        o.b.push_back(b);
        o.quotient.push_back(static_cast<float>(static_cast<double>(a) / static_cast<double>(b)));
        o.root.push_back(static_cast<float>(std::sqrt(std::fabs(static_cast<double>(a)))));
    }
    return o;
}

inline std::vector<float> magnitudes(std::vector<float> values) {
    for (float& v : values) v = std::fabs(v);
    return values;
}

}  // namespace gnomon::test
