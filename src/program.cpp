#include "program.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "clock.h"
#include "error.h"
#include "kernel_source.h"

namespace gnomon {

Programs::Programs(const cl::Context& context, const std::vector<cl::Device>& devices, const DeviceInfo& info)
    : context_(context),
      devices_(devices),
      info_(info),
      cache_(binary_cache_for(info)),
      policy_(info.compiles_at_once() ? std::launch::async : std::launch::deferred) {
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
void Programs::load(Compiled& made) const {
    const auto kept = cache_ ? cache_->find(made.cache_key) : std::nullopt;
    if (!kept) return;
    const std::vector<unsigned char> binary(kept->begin(), kept->end());
    const cl::Program::Binaries binaries(devices_.size(), binary);  // the device's parts run its code
    try {
        cl::Program program(context_, devices_, binaries);
        program.build(devices_, made.built.options.c_str());
        made.program = program;
        made.built.from_cache = true;
    } catch (const cl::Error& error) {
        made.warning = "the driver refuses a kernel that it built before (" + describe(error) +
                       "): " + cache_->file_of(made.cache_key).string() + "; it is built again";
    }
}

void Programs::compile(Compiled& made, const std::string& source) const {
    made.program = cl::Program(context_, source);
    try {
        made.program.build(devices_, made.built.options.c_str());
    } catch (const cl::Error& error) {
        throw Error(Blame::run,
                    "cannot build kernel " + made.name + " (" + made.built.options + "): " + describe(error) + "\n" +
                        made.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(devices_.front()),
                    info_.name);
    }
}

Programs::Compiled Programs::load_or_compile(const Variant& variant) const {
    const double start = now();
    Compiled made;
    made.name = to_string(variant.kernel);
    made.built.options = options(variant);
    const std::string source = kernel_source(made.name);
    if (cache_) made.cache_key = cache_key(source, made.built.options);
    load(made);
    if (!made.built.from_cache) compile(made, source);
    made.built.kernel = cl::Kernel(made.program, made.name.c_str());
    made.built.group_limit = group_limit_of(made.built.kernel);
    made.built.build_seconds = now() - start;
    return made;
}

void Programs::keep(const Compiled& made) {
    const auto binaries = made.program.getInfo<CL_PROGRAM_BINARIES>();
    try {
        cache_->keep(made.cache_key, {binaries.front().begin(), binaries.front().end()});
    } catch (const Error& error) {
        warnings_.push_back(std::string("built kernels are not kept: ") + error.what());
        cache_.reset();
    }
}

const BuiltKernel& Programs::add(const std::string& key, const Compiled& made) {
    if (!made.warning.empty()) warnings_.push_back(made.warning);
    if (!made.built.from_cache && cache_) keep(made);
    return built_[key] = made.built;
}

const BuiltKernel& Programs::get(const Variant& variant) {
    const auto known = built_.find(key(variant));
    return known != built_.end() ? known->second : add(key(variant), load_or_compile(variant));
}

void Programs::build(const std::vector<Variant>& variants, const Stop* stop) {
    std::map<std::string, std::future<Compiled>> started;
    for (const Variant& variant : variants)
        if (!has(variant))
            started[key(variant)] = std::async(policy_, [this, variant] { return load_or_compile(variant); });
    std::map<std::string, Compiled> done;
    for (auto& [key, compiled] : started) {
        check(stop);
        done[key] = compiled.get();
    }
    for (const auto& [key, compiled] : done) add(key, compiled);
}

}  // namespace gnomon
