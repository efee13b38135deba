// What the tests of single kernels share: a device with its kernels, buffers that notice a value written beside them,
// rays in block order, and launches shaped as the scheduler's.
#pragma once

#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "arguments.h"
#include "catch.h"
#include "opencl.h"
#include "program.h"
#include "scenes.h"

namespace gnomon::test {

/// Rays a vector, vectors a work-item.
struct Width {
    int lanes, packets;

    int rays() const { return lanes * packets; }
    std::vector<std::string> defines(const std::vector<std::string>& others = {}) const {
        std::vector<std::string> all = {"LANES=" + std::to_string(lanes), "PACKETS=" + std::to_string(packets)};
        all.insert(all.end(), others.begin(), others.end());
        return all;
    }
};
inline std::ostream& operator<<(std::ostream& out, const Width& w) {
    return out << "LANES " << w.lanes << ", PACKETS " << w.packets;
}

/// The first, of one ray a work-item, tests every sphere: the others are held against it. A work-item of the last of
/// each lane number is a whole block.
constexpr Width widths[] = {{1, 1}, {4, 4}, {4, 16}, {8, 4}, {8, 8}, {16, 4}};

/// A device and its kernels.
class Bench {
  public:
    explicit Bench(const DeviceInfo& of)
        : info(of),
          device(open_device(of)),
          context(device),
          queue(context, device, CL_QUEUE_PROFILING_ENABLE),
          programs(context, {device}, of),
          local(of.type == DeviceType::cpu ? 16 : 64) {}

    /// Sets all arguments and launches. There is always a work-item more than `items`, which must do nothing.
    template <class... Values>
    void launch(cl::Kernel kernel, int items, const Values&... values) {
        Arguments(kernel).add(values...);
        // A kernel of cl/ has one more, the first work-item.
        if (sizeof...(values) < kernel.getInfo<CL_KERNEL_NUM_ARGS>()) kernel.setArg(sizeof...(values), 0);
        launch_bound(kernel, items);
    }
    /// All arguments are set.
    void launch_bound(const cl::Kernel& kernel, int items) {
        queue.enqueueNDRangeKernel(kernel, cl::NullRange, static_cast<size_t>((items / local + 1) * local),
                                   static_cast<size_t>(local));
    }

    DeviceInfo info;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;
    Programs programs;
    int local;  ///< work-items a group
};

/// Runs `test` with each OpenCL device. The benches outlive the tests, so that kernels are built once.
template <class Test>
void on_every_bench(Test test) {
    static auto& benches = *new std::map<std::string, std::unique_ptr<Bench>>;
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            std::unique_ptr<Bench>& bench = benches[device.number()];
            if (!bench) bench = std::make_unique<Bench>(device);
            test(*bench);
        }
}

/// A NaN that no arithmetic makes.
constexpr uint32_t sentinel = 0xFFC5A5A5;

template <class T>
std::vector<T> sentinels(size_t count) {
    std::vector<uint32_t> words(count * sizeof(T) / 4, sentinel);
    std::vector<T> values(count);
    std::memcpy(values.data(), words.data(), words.size() * 4);
    return values;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
inline uint32_t bits(float value) {
    uint32_t word;
    std::memcpy(&word, &value, 4);
    return word;
}

/// A buffer between sentinels. Kernels are given the inner part, a sub-buffer.
template <class T>
class GuardedBuffer {
  public:
    GuardedBuffer(Bench& bench, const std::vector<T>& values)
        : bench_(bench), count_(values.size()), uploaded_(2 * guard + count_ * sizeof(T) / 4, sentinel) {
        std::memcpy(uploaded_.data() + guard, values.data(), count_ * sizeof(T));
        whole_ =
            cl::Buffer(bench.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, uploaded_.size() * 4, uploaded_.data());
        const cl_buffer_region region{guard * 4, count_ * sizeof(T)};
        inner_ = whole_.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region);
    }
    /// An output: full of sentinels.
    GuardedBuffer(Bench& bench, size_t count) : GuardedBuffer(bench, sentinels<T>(count)) {}

    const cl::Buffer& buffer() const { return inner_; }

    /// What it holds now; checks that nothing was written before or after it.
    std::vector<T> read() const {
        const std::vector<uint32_t> now = all();
        const auto clean = [&](size_t from) {
            return std::all_of(&now[from], &now[from] + guard, [](uint32_t word) { return word == sentinel; });
        };
        CHECK(clean(0));
        CHECK(clean(now.size() - guard));
        std::vector<T> values(count_);
        std::memcpy(values.data(), now.data() + guard, count_ * sizeof(T));
        return values;
    }

    /// Of an input.
    void check_unchanged() const { CHECK(same_bits(all(), uploaded_)); }

  private:
    // 64 KiB: a multiple of every device's alignment, and more than a stray work-group of whole blocks writes.
    static constexpr size_t guard = size_t{1} << 14;  // words

    std::vector<uint32_t> all() const {
        std::vector<uint32_t> words(uploaded_.size());
        bench_.queue.enqueueReadBuffer(whole_, CL_TRUE, 0, words.size() * 4, words.data());
        return words;
    }

    Bench& bench_;
    size_t count_;
    std::vector<uint32_t> uploaded_;
    cl::Buffer whole_, inner_;
};

inline Float3 to_float(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline Vec3 to_double(const Float3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Where block order has component c of n of a ray.
inline size_t place(size_t ray, size_t c, size_t n) {
    return (ray / BLOCK_RAYS * n + c) * BLOCK_RAYS + ray % BLOCK_RAYS;
}

struct Pixel {
    int i, j;
};
/// Which one a tile's ray goes through.
inline Pixel pixel_of(const Tile& tile, size_t ray) {
    const int block = static_cast<int>(ray) / BLOCK_RAYS, inner = static_cast<int>(ray) % BLOCK_RAYS;
    return {tile.x + block % tile.blocks_x * BLOCK_SIDE + inner % BLOCK_SIDE,
            tile.y + block / tile.blocks_x * BLOCK_SIDE + inner / BLOCK_SIDE};
}

/// Block order; the last block is filled up with `rest`.
template <class real>
std::vector<real> packed(const std::vector<Real3Of<real>>& rays, real rest = NAN) {
    std::vector<real> values((rays.size() + BLOCK_RAYS - 1) / BLOCK_RAYS * BLOCK_RAYS * 3, rest);
    for (size_t i = 0; i < rays.size(); ++i) {
        values[place(i, 0, 3)] = rays[i].x;
        values[place(i, 1, 3)] = rays[i].y;
        values[place(i, 2, 3)] = rays[i].z;
    }
    return values;
}
template <class real>
Real3Of<real> unpacked(const std::vector<real>& values, size_t ray) {
    return {values[place(ray, 0, 3)], values[place(ray, 1, 3)], values[place(ray, 2, 3)]};
}

/// Random numbers, the same everywhere: std::mt19937_64 is defined to the bit, the distributions are not.
class Random {
  public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    uint64_t word() { return engine_(); }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// Uniform in the logarithm.
    double scale(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    /// Uniform on the unit sphere (Archimedes: a slice's area is its thickness).
    Vec3 direction() {
        const double z = uniform(-1, 1), angle = uniform(-3.14159265358979, 3.14159265358979), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

  private:
    std::mt19937_64 engine_;
};

/// Whether lights' rays are bounded by the box around a block's hits, as a plan would have it.
inline bool has_boxes(Width w, const std::string& walk) { return walk == "WALK_CLUSTERS" && w.rays() == BLOCK_RAYS; }

inline std::string define_boxes(bool has) { return has ? "BOXES=1" : "BOXES=0"; }

/// The boxes around the hits of blocks, from packed positions.
inline std::vector<HitsBox> boxes_around(const std::vector<float>& positions, const std::vector<int>& ids) {
    constexpr Float3 least{INFINITY, INFINITY, INFINITY}, most{-INFINITY, -INFINITY, -INFINITY};
    std::vector<HitsBox> boxes((ids.size() + BLOCK_RAYS - 1) / BLOCK_RAYS, HitsBox{least, most});
    for (size_t ray = 0; ray < ids.size(); ++ray) {
        if (ids[ray] < 0) continue;
        const Float3 p = unpacked(positions, ray);
        HitsBox& box = boxes[ray / BLOCK_RAYS];
        box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y), std::min(box.least.z, p.z)};
        box.most = {std::max(box.most.x, p.x), std::max(box.most.y, p.y), std::max(box.most.z, p.z)};
    }
    return boxes;
}

}  // namespace gnomon::test
