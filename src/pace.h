// How long the launches of each kernel take, and how many work-items one may have so that it ends in time.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace gnomon {

/// Seconds that a launch may take. Systems end launches that hold a display up after 2 s (Windows) or 5 s (X with
/// NVIDIA's driver), and whoever presses Ctrl-C waits for what is under way.
constexpr double longest_launch = 0.1;

/// What is known of one kernel on one device.
class KernelPace {
  public:
    /// So many work-items took so long in one launch.
    void measured(int64_t items, double seconds);
    /// The driver has compiled and loaded the kernel, which it does while that is launched for the first time.
    bool is_loaded() const { return loaded_; }
    void set_loaded() { loaded_ = true; }

    /// How many of `left` work-items the next launch should have, in whole times `least`, to take no more than `bound`
    /// seconds: `least` while nothing is known, then as measured, but at most `growth` times the largest yet.
    int64_t part(int64_t left, int64_t least, double bound) const;
    /// A launch of all of them would be more than `growth` times the largest yet.
    bool is_growing(int64_t left) const { return left > growth * most_; }

    /// Seconds that so many should take.
    double expected(int64_t items) const { return slow_ * static_cast<double>(items); }
    /// All but that it is loaded.
    void forget() { slow_ = 0, most_ = 0; }

  private:
    static constexpr int64_t growth = 16;

    double slow_ = 0;   // seconds a work-item, the most of late
    int64_t most_ = 0;  // work-items of the largest launch that was measured
    bool loaded_ = false;
};

/// That of all kernels of a device.
class Pace {
  public:
    /// `most`: work-items that any launch may have.
    explicit Pace(int64_t most = std::numeric_limits<int64_t>::max()) : most_(most) {}

    /// For a picture of so many spheres: what was measured with fewer says too little.
    void expect(double bound, int64_t spheres);

    /// `kernel` with its options; stays where it is.
    KernelPace& of(const std::string& kernel) { return kernels_[kernel]; }
    double bound() const { return bound_; }
    int64_t most() const { return most_; }
    bool is_bounded() const { return most_ < std::numeric_limits<int64_t>::max(); }

  private:
    std::map<std::string, KernelPace> kernels_;
    int64_t most_;
    double bound_ = longest_launch;
    int64_t spheres_ = 0;
};

}  // namespace gnomon
