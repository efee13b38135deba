// The kernels that put spheres in order: sphere_keys, the radix sort, find_duplicates, gather_spheres.
#include <set>

#include "crowds.h"
#include "guarded_spheres.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

struct Pair {
    uint32_t key, row;
};

int slices_over(size_t pairs) { return static_cast<int>(pairs / 100 + 1); }

/// One pass by the digit at `shift`.
std::vector<Pair> one_pass(Bench& bench, const std::vector<Pair>& pairs, int shift, int slices) {
    const int count = static_cast<int>(pairs.size());
    const GuardedBuffer<Pair> in(bench, pairs), out(bench, pairs.size());
    const GuardedBuffer<uint32_t> counts(bench, static_cast<size_t>(slices) * DIGITS),
        totals(bench, std::vector<uint32_t>(DIGITS, 0));
    const auto kernel = [&](Kernel k) { return bench.programs.get(sphere_variant(k, Accuracy::strict)).kernel; };
    bench.launch(kernel(Kernel::count_digits), slices, in.buffer(), count, shift, slices, counts.buffer(),
                 totals.buffer());
    bench.launch(kernel(Kernel::scan_counts), DIGITS / DIGITS_AN_ITEM, slices, DIGITS / DIGITS_AN_ITEM, counts.buffer(),
                 totals.buffer());
    bench.launch(kernel(Kernel::scatter_pairs), slices, in.buffer(), count, shift, slices, counts.buffer(),
                 out.buffer());
    in.check_unchanged();
    counts.read();
    totals.read();
    return out.read();
}

/// The rows of a scene's clusters, place after place; -1 where a place is empty.
std::vector<int> ids_of(const std::vector<Cluster>& clusters) {
    std::vector<int> ids;
    for (const Cluster& c : clusters) ids.insert(ids.end(), c.id, c.id + CLUSTER);
    return ids;
}

/// The mean over clusters of the volume of a box around their centres, to the power of 1/3.
double mean_size(const std::vector<Cluster>& clusters) {
    double sum = 0;
    for (const Cluster& c : clusters) {
        double volume = 1;
        for (const float* axis : {c.x, c.y, c.z}) {
            float low = INFINITY, high = -INFINITY;
            for (int i = 0; i < CLUSTER; ++i)
                if (c.id[i] >= 0) low = std::min(low, axis[i]), high = std::max(high, axis[i]);
            volume *= static_cast<double>(high - low);
        }
        sum += std::cbrt(volume);
    }
    return sum / static_cast<double>(clusters.size());
}

}  // namespace

TEST_CASE("radix sort: a pass brings pairs into the order of one digit and keeps the rest", "[sort]") {
    on_every_bench([](Bench& bench) {
        Random random(3);
        for (const size_t count : {1, 15, 16, 255, 1000, 30011})
            for (const int shift : {0, 10, 20, 30})
                for (const bool one_digit : {false, true}) {
                    INFO(count << " pairs, shift " << shift << (one_digit ? ", all digits equal" : ""));
                    std::vector<Pair> pairs;
                    for (uint32_t row = 0; row < count; ++row)
                        pairs.push_back({one_digit ? 0x7f7f7f7f : static_cast<uint32_t>(random.word()), row});
                    std::vector<Pair> expected = pairs;
                    std::stable_sort(expected.begin(), expected.end(), [&](const Pair& a, const Pair& b) {
                        return (a.key >> shift & 1023) < (b.key >> shift & 1023);
                    });
                    for (const int slices : {1, 3, slices_over(count)})
                        CHECK(same_bits(one_pass(bench, pairs, shift, slices), expected));
                }
    });
}

TEST_CASE("sphere_keys: neighbours on the curve are neighbours in space", "[sort]") {
    on_every_bench([](Bench& bench) {
        // A sphere in the middle of each cell of a cube of 16 at the grid's corner, which Hilbert's curve fills first,
        // from each cell to one that shares a side with it. No other curve that fills a cube by its eighths does.
        constexpr int side = 16, count = side * side * side;
        std::vector<float> rows;
        for (int cell = 0; cell < count; ++cell)
            for (const int at : {cell % side, cell / side % side, cell / side / side, 0})
                rows.push_back(static_cast<float>(at) + 0.5f);
        const GuardedBuffer<float> spheres(bench, rows), rests(bench, 1);
        const GuardedBuffer<Pair> sorted(bench, 1), keys(bench, count);
        bench.launch(bench.programs.get(sphere_variant(Kernel::sphere_keys, Accuracy::strict)).kernel, count / CLUSTER,
                     spheres.buffer(), rests.buffer(), 4, sorted.buffer(), 1, 0, Float3{0, 0, 0}, 1.0f, INFINITY, count,
                     count / CLUSTER, keys.buffer());
        std::vector<Pair> curve = keys.read();
        std::sort(curve.begin(), curve.end(), [](const Pair& a, const Pair& b) { return a.key < b.key; });
        int wrong = 0;
        for (size_t i = 0; i < count; ++i) {
            float step = 0;
            for (size_t axis = 0; i > 0 && axis < 3; ++axis)
                step += std::fabs(rows[4 * curve[i].row + axis] - rows[4 * curve[i - 1].row + axis]);
            wrong += !(curve[i].key == i && (i == 0 || step == 1));
        }
        CHECK(wrong == 0);
    });
}

TEST_CASE("clusters: every distinct sphere is there once, by its lowest id, and nothing else", "[sort]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds)
            for (const int count : {1, 17, 256, 257, 5000}) {
                INFO(to_string(crowd) << ", " << count);
                const Scene scene = scene_of(crowd, count);
                const DeviceSpheres spheres(bench, scene);
                const std::vector<int> ids = ids_of(spheres.clusters());
                std::multiset<int> found;
                std::copy_if(ids.begin(), ids.end(), std::inserter(found, found.end()), [](int id) { return id >= 0; });
                std::multiset<int> expected;
                for (int id = 0; id < (crowd == Crowd::coincident ? std::min(count, 3) : count); ++id)
                    expected.insert(id);
                CHECK(found == expected);
                int wrong = 0;
                for (const Cluster& c : spheres.clusters())
                    for (int i = 0; i < CLUSTER; ++i) {
                        if (c.id[i] < 0) continue;
                        const Sphere& s = scene.spheres[static_cast<size_t>(c.id[i])];
                        const Vec3 place = spheres.frame.place(s.center);
                        wrong +=
                            !(c.x[i] == static_cast<float>(place.x) && c.y[i] == static_cast<float>(place.y) &&
                              c.z[i] == static_cast<float>(place.z) && c.radius[i] == static_cast<float>(s.radius));
                    }
                CHECK(wrong == 0);
            }
    });
}

TEST_CASE("clusters: their order does not depend on how the sort is shared out", "[sort]") {
    on_every_bench([](Bench& bench) {
        const Scene scene = scene_of(Crowd::teapot_in_a_stadium, 20000);
        const std::vector<int> ids = ids_of(DeviceSpheres(bench, scene, {1}).clusters());
        for (const int slices : {2, 7, 64}) CHECK(ids_of(DeviceSpheres(bench, scene, {slices}).clusters()) == ids);
    });
}

TEST_CASE("clusters: coincident spheres among many in one place are found", "[sort]") {
    on_every_bench([](Bench& bench) {
        // Pairs that coincide, and near them others that share their keys: at 30 bits all, at 90 some.
        Scene scene;
        Random random(5);
        scene.spheres.push_back({{1e6, 1e6, 1e6}, 1});
        for (int i = 0; i < 3000; ++i) {
            const auto off = [&] { return random.uniform(-1, 1) * (i % 2 == 0 ? 1e-3 : 1e-7); };
            scene.spheres.push_back({{off(), off(), off()}, 1e-4});
        }
        const size_t distinct = scene.spheres.size();
        for (size_t i = 0; i < distinct; i += 3) scene.spheres.push_back(scene.spheres[i]);
        for (size_t i = 0; i < distinct; i += 7) scene.spheres.push_back(scene.spheres[i]);
        // Nearly as the first ones, but no twins.
        for (size_t i = 1; i < 1000; i += 5) {
            scene.spheres.push_back(scene.spheres[i]);
            scene.spheres.back().radius = 2e-4;
        }
        const DeviceSpheres spheres(bench, scene);
        const std::vector<int> ids = ids_of(spheres.clusters());
        std::set<int> found(ids.begin(), ids.end());
        found.erase(-1);
        CHECK(std::count_if(ids.begin(), ids.end(), [](int id) { return id >= 0; }) ==
              static_cast<std::ptrdiff_t>(distinct + 200));
        for (size_t id = 0; id < distinct; ++id) CHECK(found.count(static_cast<int>(id)) == 1);
    });
}

TEST_CASE("clusters: neighbours in the order are neighbours in space", "[sort]") {
    on_every_bench([](Bench& bench) {
        // A cluster of 16 among n would fill a box of (16 / n)^(1/3) of the whole, if it were a cube. The boxes around
        // centres on Hilbert's curve are about as large, on Morton's 1.28 times.
        const Scene scene = scene_of(Crowd::strewn, 20000);
        const double cube = 100 * std::cbrt(16.0 / 20000);
        CHECK(mean_size(DeviceSpheres(bench, scene).clusters()) < 1.05 * cube);
        // The tiny spout of the teapot is told apart, too: 10 bits would make it one place.
        const Scene teapot = scene_of(Crowd::teapot_in_a_stadium, 20000);
        double sum = 0;
        int spouts = 0;
        for (const Cluster& c : DeviceSpheres(bench, teapot).clusters())
            if (std::all_of(c.radius, c.radius + CLUSTER, [](float r) { return r == 5e-5f; })) {
                sum += mean_size({c});
                ++spouts;
            }
        REQUIRE(spouts > 400);
        CHECK(sum / spouts < 2.5 * 2e-3 * std::cbrt(16.0 / 10000));
    });
}
