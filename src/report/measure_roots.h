// Runs the formulas on a device.
#pragma once

#include <vector>

#include "cases.h"
#include "formulas.h"
#include "opencl.h"
#include "plan.h"
#include "program.h"
#include "statistics.h"

namespace gnomon::report {

/// What a formula finds for the rays of a case, in block order, and the device's time for a ray.
struct Roots {
    std::vector<float> ts, normals;
    Series ns_per_ray;
};

/// Component c of n of a ray, in block order.
inline size_t in_block_order(size_t ray, size_t c, size_t n) {
    return (ray / BLOCK_RAYS * n + c) * BLOCK_RAYS + ray % BLOCK_RAYS;
}

/// A device and measure_roots, built for each formula in the lane width that pictures have there.
class RootsBench {
  public:
    /// Throws Error(Blame::run) when the device fails.
    explicit RootsBench(const DeviceInfo& device);

    /// Each of the formulas, `rounds` times, in turn: what disturbs one disturbs all.
    std::vector<Roots> measure(const RootCase& rays, const std::vector<Formula>& formulas, int rounds);

  private:
    struct Buffers;
    cl::Kernel kernel(const Formula& formula);
    double nanoseconds_per_ray(const cl::Kernel& kernel, int64_t rays);
    Roots read(const Buffers& buffers, size_t rays);

    DeviceInfo info_;
    Plan plan_;  // of a scene that stands for any
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    Programs programs_;
};

}  // namespace gnomon::report
