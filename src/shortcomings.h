// What a device lacks, and what is done about it.
#pragma once

#include <string>
#include <vector>

#include "device.h"

namespace gnomon {

struct Shortcoming {
    std::string lack;    ///< "no double"
    std::string answer;  ///< what follows for pictures
    bool usable = true;  ///< else no picture is rendered
};

/// Whatever is less than full OpenCL 1.2 with all its options, or has a price, in the order of a listing.
std::vector<Shortcoming> shortcomings(const DeviceInfo& device);

/// The most spheres that the driver's compiler bears: Mesa's rusticl 22.3 ends the process, by a fault in its LLVM
/// code, when it compiles kernels that walk through clusters of spheres. (25.0 compiles them rightly.)
int64_t most_spheres(const DeviceInfo& device);

/// Throws Error(Blame::run) for more than that.
void check_spheres(int64_t count, const DeviceInfo& device);

/// Throws Error(Blame::run) for a device on which pictures would be wrong, or none at all.
void check_usable(const DeviceInfo& device);

}  // namespace gnomon
