#include "accuracy.h"

#include "device.h"
#include "error.h"

namespace gnomon {

const char* to_string(Accuracy accuracy) {
    static constexpr const char* names[] = {"fast", "strict", "certified", "double"};
    return names[static_cast<int>(accuracy)];
}

Accuracy parse_accuracy(const std::string& name) {
    for (const Accuracy accuracy : {Accuracy::fast, Accuracy::strict, Accuracy::certified, Accuracy::full})
        if (name == to_string(accuracy)) return accuracy;
    throw Error(Blame::input, "found \"" + name + "\", expected fast, strict, certified or double", "--accuracy");
}

std::string build_options(Accuracy accuracy) {
    // Not -cl-finite-math-only or -cl-fast-relaxed-math: misses are infinite, and rays outside the image are NaN.
    if (accuracy == Accuracy::fast)
        return " -D FAST=1 -cl-mad-enable -cl-no-signed-zeros -cl-unsafe-math-optimizations";
    return computes_in_double(accuracy) ? " -D REAL_IS_DOUBLE=1" : "";
}

std::vector<Accuracy> available_accuracies(const DeviceInfo& device) {
    std::vector<Accuracy> all{Accuracy::fast, Accuracy::strict, Accuracy::certified};
    if (device.fp64) all.push_back(Accuracy::full);
    return all;
}

void check_accuracy(Accuracy accuracy, const DeviceInfo& device) {
    if (computes_in_double(accuracy) && !device.fp64)
        throw Error(Blame::input, "the device " + device.name + " computes in float only (it lacks cl_khr_fp64)",
                    "--accuracy double", "use fast, strict or certified, or another --device");
}

}  // namespace gnomon
