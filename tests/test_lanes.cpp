// cl/lanes.h and cl/cluster.h alone: what is made of all lanes together.
#include "kernel_harness.h"
#include "kernel_source.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

// What follows intersect_closest.cl, which brings both headers with it. A work-item has LANES values and 8 results.
const char* const kernels = R"(
kernel void test_lanes(global const int* a, global const float* b, int items, global int* ints, global float* floats) {
    const int i = (int)get_global_id(0);
    if (i >= items) return;
    const intw v = load_i(a, i, 0);
    const floatw f = load_r(b, i, 0);
    global int* to = ints + 8 * i;
    to[0] = REDUCE(or, v);
    to[1] = REDUCE(count, v);
    to[2] = REDUCE(highest, v);
    to[3] = any_lane(f > 0.0f) != 0;
#if LANES > 1
    to[4] = lane_bits(f > 0.0f);
#else
    to[4] = f > 0.0f;
#endif
    to[5] = lowest_bit(a[i] | 1 << 27);
    floats[8 * i] = REDUCE(sum, f);
    floats[8 * i + 1] = REDUCE(least, f);
    floats[8 * i + 2] = REDUCE(most, f);
}
)";

struct Expected {
    std::vector<int> ints;
    std::vector<float> floats;
};

/// `values` and `halves` in groups of `lanes`.
Expected reduce(const std::vector<int>& values, const std::vector<float>& halves, size_t lanes) {
    Expected e{sentinels<int>(values.size() / lanes * 8), sentinels<float>(values.size() / lanes * 8)};
    for (size_t i = 0; i < values.size(); i += lanes) {
        int* to = &e.ints[i / lanes * 8];
        float* sums = &e.floats[i / lanes * 8];
        std::fill(to, to + 5, 0);
        to[2] = values[i];
        sums[0] = 0;
        sums[1] = sums[2] = halves[i];
        for (size_t k = 0; k < lanes; ++k) {
            to[0] |= values[i + k];
            to[1] += values[i + k];
            to[2] = std::max(to[2], values[i + k]);
            to[4] |= (halves[i + k] > 0) << k;
            sums[0] += halves[i + k];
            sums[1] = std::min(sums[1], halves[i + k]);
            sums[2] = std::max(sums[2], halves[i + k]);
        }
        to[3] = to[4] != 0;
        to[5] = 0;
        while (!((values[i / lanes] | 1 << 27) >> to[5] & 1)) ++to[5];
    }
    return e;
}

}  // namespace

TEST_CASE("lanes.h: reductions take every lane once", "[lanes]") {
    on_every_bench([](Bench& bench) {
        Random random(41);
        std::vector<int> values;
        std::vector<float> halves;  // of small whole numbers, mostly negative: any order of a sum is exact
        for (int i = 0; i < 4096; ++i) {
            values.push_back(static_cast<int>(random.word() % 3 ? 1u << random.word() % 26 : random.word() % 1000));
            if (random.word() % 2) values.back() = -values.back();
            halves.push_back(static_cast<float>(random.uniform(-2000, random.word() % 16 ? 0 : 2000)));
            halves.back() = std::floor(halves.back()) / 2;
        }
        for (const size_t lanes : {1, 4, 8, 16}) {
            INFO("LANES " << lanes);
            cl::Program program(bench.context, kernel_source("intersect_closest") + kernels);
            program.build({bench.device}, ("-D PACKETS=1 -D LANES=" + std::to_string(lanes)).c_str());
            const int items = static_cast<int>(values.size() / lanes);
            const GuardedBuffer<int> a(bench, values), ints(bench, values.size() / lanes * 8);
            const GuardedBuffer<float> b(bench, halves), floats(bench, values.size() / lanes * 8);
            bench.launch(cl::Kernel(program, "test_lanes"), items, a.buffer(), b.buffer(), items, ints.buffer(),
                         floats.buffer());
            const Expected expected = reduce(values, halves, lanes);
            CHECK(ints.read() == expected.ints);
            CHECK(same_bits(floats.read(), expected.floats));
        }
    });
}
