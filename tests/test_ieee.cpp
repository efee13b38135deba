// cl/ieee.h alone: divide and square_root are correctly rounded.
#include "kernel_harness.h"
#include "kernel_source.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

// What follows generate_rays.cl, which brings ieee.h with it. Values, not rays: LANES of them a work-item.
const char* const kernels = R"(
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

constexpr size_t count = 1 << 16;

cl::Program build(Bench& bench, int lanes, bool correctly_rounded) {
    cl::Program program(bench.context, kernel_source("generate_rays") + kernels);
    std::string options = "-D PACKETS=1 -D LANES=" + std::to_string(lanes);
    if (correctly_rounded) options += " -D CORRECTLY_ROUNDED -cl-fp32-correctly-rounded-divide-sqrt";
    program.build({bench.device}, options.c_str());
    return program;
}

/// Runs a kernel over vectors of `count` values, and counts the results that are not the expected bits (any NaN is as
/// good as another).
template <class... Inputs>
int wrong(Bench& bench, const cl::Program& program, const char* name, int lanes, const std::vector<float>& expected,
          const Inputs&... inputs) {
    const GuardedBuffer<float> result(bench, count);
    const int items = static_cast<int>(count) / lanes;
    bench.launch(cl::Kernel(program, name), items, GuardedBuffer<float>(bench, inputs).buffer()..., items,
                 result.buffer());
    const std::vector<float> values = result.read();
    int differing = 0;
    for (size_t i = 0; i < count; ++i)
        differing += std::isnan(expected[i]) ? !std::isnan(values[i]) : bits(values[i]) != bits(expected[i]);
    return differing;
}

/// Of random sign, significand and, between 2^-e and 2^e, exponent.
float any_float(Random& random, int e) {
    const double significand = 1 + static_cast<double>(random.word() >> 41) * 0x1p-23;
    const int exponent = static_cast<int>(random.uniform(-e, e));
    return static_cast<float>(std::ldexp(random.word() & 1 ? significand : -significand, exponent));
}

struct Operands {
    std::vector<float> a, b, quotient, root;  ///< root: of |a|
};

/// The b and the odd m of 25 bits, the middle of two floats, with a 2^25 = b m - 1 or + 1: a / b could not be closer to
/// it, 2^-48.
void hard_quotient(Random& random, float& a, float& b) {
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
float hard_square(int64_t rest) {
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
Operands operands(int exponents) {
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

std::vector<float> magnitudes(std::vector<float> values) {
    for (float& v : values) v = std::fabs(v);
    return values;
}

/// `ulp` floats up.
float moved(float value, int ulp) {
    for (; ulp > 0; --ulp) value = std::nextafter(value, INFINITY);
    for (; ulp < 0; ++ulp) value = std::nextafter(value, -INFINITY);
    return value;
}

template <class Test>
void with_each_build(Test test) {
    on_every_bench([&](Bench& bench) {
        for (const int lanes : {1, 4, 8, 16})
            for (const bool correctly_rounded : {false, true}) {
                if (correctly_rounded && !bench.info.correctly_rounded) continue;
                INFO("LANES " << lanes << (correctly_rounded ? ", correctly rounded" : ""));
                test(bench, build(bench, lanes, correctly_rounded), lanes);
            }
    });
}

}  // namespace

TEST_CASE("ieee.h: quotients and roots are rounded correctly", "[ieee]") {
    // Exponents that keep residuals, 48 binary digits below, normal numbers.
    const Operands o = operands(30);
    with_each_build([&](Bench& bench, const cl::Program& program, int lanes) {
        CHECK(wrong(bench, program, "test_divide", lanes, o.quotient, o.a, o.b) == 0);
        CHECK(wrong(bench, program, "test_root", lanes, o.root, magnitudes(o.a), o.b) == 0);
    });
}

TEST_CASE("ieee.h: zero, infinity and NaN are what IEEE 754 says", "[ieee]") {
    const float values[] = {0, -0.0f, 1, -1, 3, INFINITY, -INFINITY, NAN};
    std::vector<float> a(count, 1), b(count, 1), quotients(count, 1), roots(count, 1);
    for (size_t i = 0; i < 8; ++i)
        for (size_t k = 0; k < 8; ++k) {
            const size_t at = 8 * i + k;
            a[at] = values[i];
            b[at] = values[k];
            quotients[at] = a[at] / b[at];
            roots[at] = std::sqrt(a[at]);
        }
    with_each_build([&](Bench& bench, const cl::Program& program, int lanes) {
        CHECK(wrong(bench, program, "test_divide", lanes, quotients, a, b) == 0);
        CHECK(wrong(bench, program, "test_root", lanes, roots, a, b) == 0);
    });
}

TEST_CASE("ieee.h: the correction starts from anything within 3 ulp", "[ieee]") {
    const Operands o = operands(30);
    with_each_build([&](Bench& bench, const cl::Program& program, int lanes) {
        for (int first = -3; first <= 3; ++first)
            for (const int second : {-3, 0, 3}) {
                INFO(first << " and " << second << " ulp");
                std::vector<float> q(count), r(count), s(count), h(count);
                for (size_t i = 0; i < count; ++i) {
                    q[i] = moved(o.quotient[i], first);
                    r[i] = moved(1 / o.b[i], second);
                    s[i] = moved(o.root[i], first);
                    h[i] = moved(0.5f / s[i], second);
                }
                CHECK(wrong(bench, program, "test_correct_quotient", lanes, o.quotient, o.a, o.b, q, r) == 0);
                CHECK(wrong(bench, program, "test_correct_root", lanes, o.root, magnitudes(o.a), o.b, s, h) == 0);
            }
    });
}
