// Kernel variants, built on first use and kept.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "opencl.h"
#include "plan.h"

namespace gnomon {

/// A built kernel, and what building it took.
struct BuiltKernel {
    cl::Kernel kernel;
    std::string options;
    double build_seconds = 0;
};

/// The kernels of one device. Not for use by several threads at once.
class Programs {
  public:
    /// `devices`: those on whose queues kernels are launched, the whole device first and then parts of it, which share
    /// what is built where the driver knows that they are alike.
    Programs(const cl::Context& context, const std::vector<cl::Device>& devices, const DeviceInfo& info);

    /// Builds the variant unless it was built before. Throws Error(Blame::run) with the compiler's log.
    const BuiltKernel& get(const Variant& variant);

    bool has(const Variant& variant) const { return built_.count(key(variant)) > 0; }

  private:
    std::string options(const Variant& variant) const;
    std::string key(const Variant& variant) const;  // kernel and options, as the compiler sees them

    cl::Context context_;
    std::vector<cl::Device> devices_;
    std::string device_name_;
    bool correctly_rounded_;
    std::string common_options_;
    std::map<std::string, BuiltKernel> built_;
};

}  // namespace gnomon
