// cl/ieee.h alone: divide and square_root are correctly rounded.
#include "ieee_operands.h"
#include "kernel_source.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

constexpr size_t count = 1 << 16;

cl::Program build(Bench& bench, int lanes, bool correctly_rounded) {
    cl::Program program(bench.context, kernel_source("generate_rays") + ieee_kernels);
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
    const Operands o = operands(count, 30);
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
    const Operands o = operands(count, 30);
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
