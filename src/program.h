// Kernel variants, built on first use and kept.
#pragma once

#include <future>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "binary_cache.h"
#include "opencl.h"
#include "plan.h"
#include "stop.h"

namespace gnomon {

/// A built kernel, and what building it took.
struct BuiltKernel {
    cl::Kernel kernel;
    std::string options;
    double build_seconds = 0;
    bool from_cache = false;  ///< a binary of an earlier run was used
    int group_limit = 1;  ///< work-items that a group of it may have: registers may allow fewer than the device does
};

/// The kernels of one device. Not for use by several threads at once.
class Programs {
  public:
    /// `devices`: those on whose queues kernels are launched, the whole device first and then parts of it, which share
    /// what is built where the driver knows that they are alike.
    Programs(const cl::Context& context, const std::vector<cl::Device>& devices, const DeviceInfo& info);

    /// Builds those variants that were not built before, all at once where the driver's compiler allows it. Throws as
    /// get() does, and Stopped.
    void build(const std::vector<Variant>& variants, const Stop* stop);

    /// Builds the variant unless it was built before. Throws Error(Blame::run) with the compiler's log.
    const BuiltKernel& get(const Variant& variant);

    bool has(const Variant& variant) const { return built_.count(key(variant)) > 0; }

    /// What the user should know of binaries that could not be used or kept; each is told once.
    std::vector<std::string> take_warnings() { return std::exchange(warnings_, {}); }

  private:
    std::string options(const Variant& variant) const;
    int group_limit_of(const cl::Kernel& kernel) const;
    std::string key(const Variant& variant) const;  // kernel and options, as the compiler sees them
    std::string cache_key(const std::string& source, const std::string& options) const;
    struct Compiled {
        std::string name, cache_key, warning;
        cl::Program program;
        BuiltKernel built;
    };
    // Any thread may call these three.
    void load(Compiled& made) const;
    void compile(Compiled& made, const std::string& source) const;
    Compiled load_or_compile(const Variant& variant) const;

    const BuiltKernel& add(const std::string& key, const Compiled& made);
    void keep(const Compiled& made);

    cl::Context context_;
    std::vector<cl::Device> devices_;
    DeviceInfo info_;
    std::optional<BinaryCache> cache_;
    std::launch policy_;  // how several are built
    std::vector<std::string> warnings_;
    std::string common_options_;
    std::map<std::string, BuiltKernel> built_;
};

}  // namespace gnomon
