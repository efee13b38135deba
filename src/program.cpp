#include "program.h"

#include <algorithm>
#include <limits>

#include "clock.h"
#include "error.h"
#include "kernel_source.h"

namespace gnomon {

Programs::Programs(const cl::Context& context, const std::vector<cl::Device>& devices, const DeviceInfo& info)
    : context_(context), devices_(devices), info_(info), cache_(binary_cache_for(info)) {
    // PoCL on a CPU: clang's builtins are at hand.
    common_options_ = info.is_pocl() ? " -D CLANG_TO_MACHINE=1" : " -D CLANG_TO_MACHINE=0";
    // cl/builtins.h takes the place of the header that this driver would read first, and of no other driver's.
    if (info.is_pocl()) common_options_ += " -D DECLARE_BUILTINS=1 -D _OPENCL_H_";
}

std::string Programs::options(const Variant& variant) const {
    // Where the device cannot round divide and sqrt correctly, cl/ieee.h corrects them.
    const bool rounded = info_.correctly_rounded && variant.accuracy != Accuracy::fast;
    const std::string rounding = rounded ? " -D CORRECTLY_ROUNDED -cl-fp32-correctly-rounded-divide-sqrt" : "";
    return variant.options() + rounding + common_options_;
}

std::string Programs::key(const Variant& variant) const {
    return std::string(to_string(variant.kernel)) + " " + options(variant);
}

int Programs::group_limit_of(const cl::Kernel& kernel) const {
    uint64_t most = info_.max_kernel_group;
    if (most == 0) most = kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(devices_.front());
    return static_cast<int>(std::min<uint64_t>(most, std::numeric_limits<int>::max()));
}

std::string Programs::cache_key(const std::string& source, const std::string& options) const {
    std::string key;
    for (const std::string& part : {info_.platform_name, info_.name, info_.version, info_.driver, options, source})
        key += part + '\n';
    return key;
}

// A binary that the driver refuses is one that it would not make today: it is built, and kept, anew.
std::optional<cl::Program> Programs::from_cache(const std::string& cache_key, const std::string& options) {
    const auto kept = cache_ ? cache_->find(cache_key) : std::nullopt;
    if (!kept) return std::nullopt;
    const std::vector<unsigned char> binary(kept->begin(), kept->end());
    const cl::Program::Binaries binaries(devices_.size(), binary);  // the device's parts run its code
    try {
        cl::Program program(context_, devices_, binaries);
        program.build(devices_, options.c_str());
        return program;
    } catch (const cl::Error& error) {
        warnings_.push_back("the driver refuses a kernel that it built before (" + describe(error) +
                            "): " + cache_->file_of(cache_key).string() + "; it is built again");
        return std::nullopt;
    }
}

cl::Program Programs::from_source(const std::string& name, const std::string& source,
                                  const std::string& options) const {
    cl::Program program(context_, source);
    try {
        program.build(devices_, options.c_str());
    } catch (const cl::Error& error) {
        throw Error(Blame::run,
                    "cannot build kernel " + name + " (" + options + "): " + describe(error) + "\n" +
                        program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(devices_.front()),
                    info_.name);
    }
    return program;
}

void Programs::keep(const std::string& cache_key, const cl::Program& program) {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    try {
        cache_->keep(cache_key, {binaries.front().begin(), binaries.front().end()});
    } catch (const Error& error) {
        warnings_.push_back(std::string("built kernels are not kept: ") + error.what());
        cache_.reset();
    }
}

const BuiltKernel& Programs::get(const Variant& variant) {
    const auto known = built_.find(key(variant));
    if (known != built_.end()) return known->second;
    const double start = now();
    const std::string name = to_string(variant.kernel), options = this->options(variant), source = kernel_source(name);
    const std::string cache_key = cache_ ? this->cache_key(source, options) : "";
    const std::optional<cl::Program> kept = from_cache(cache_key, options);
    const cl::Program program = kept ? *kept : from_source(name, source, options);
    if (!kept && cache_) keep(cache_key, program);
    const cl::Kernel kernel(program, name.c_str());
    return built_[key(variant)] = {kernel, options, now() - start, kept.has_value(), group_limit_of(kernel)};
}

}  // namespace gnomon
