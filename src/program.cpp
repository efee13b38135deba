#include "program.h"

#include "clock.h"
#include "error.h"
#include "kernel_source.h"

namespace gnomon {

Programs::Programs(const cl::Context& context, const std::vector<cl::Device>& devices, const DeviceInfo& info)
    : context_(context), devices_(devices), device_name_(info.name), correctly_rounded_(info.correctly_rounded) {
    // PoCL on a CPU: clang's builtins are at hand.
    const bool pocl = info.platform_name == "Portable Computing Language" && info.type == DeviceType::cpu;
    common_options_ = pocl ? " -D CLANG_TO_MACHINE=1" : " -D CLANG_TO_MACHINE=0";
}

std::string Programs::options(const Variant& variant) const {
    // Where the device cannot round divide and sqrt correctly, cl/ieee.h corrects them.
    const bool rounded = correctly_rounded_ && variant.accuracy != Accuracy::fast;
    const std::string rounding = rounded ? " -D CORRECTLY_ROUNDED -cl-fp32-correctly-rounded-divide-sqrt" : "";
    return variant.options() + rounding + common_options_;
}

std::string Programs::key(const Variant& variant) const {
    return std::string(to_string(variant.kernel)) + " " + options(variant);
}

const BuiltKernel& Programs::get(const Variant& variant) {
    const auto known = built_.find(key(variant));
    if (known != built_.end()) return known->second;
    const double start = now();
    const std::string name = to_string(variant.kernel), options = this->options(variant);
    cl::Program program(context_, kernel_source(name));
    try {
        program.build(devices_, options.c_str());
    } catch (const cl::Error& error) {
        throw Error(Blame::run,
                    "cannot build kernel " + name + " (" + options + "): " + describe(error) + "\n" +
                        program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(devices_.front()),
                    device_name_);
    }
    const cl::Kernel kernel(program, name.c_str());
    return built_[key(variant)] = {kernel, options, now() - start};
}

}  // namespace gnomon
