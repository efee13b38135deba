// How exactly kernels compute.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

struct DeviceInfo;

enum class Accuracy {
    fast,       ///< float, with whatever the compiler and the device make faster; the bits are nobody's promise
    strict,     ///< float, IEEE operations only: the same bits everywhere
    certified,  ///< strict, and every decision that rounding may have made is made again, exactly: docs/accuracy.md
    full        ///< "double": as strict, in double from the rays to the radiance; the film is rounded to float once
};

const char* to_string(Accuracy accuracy);
/// The one that is called so. Throws Error(Blame::input) with what there is.
Accuracy parse_accuracy(const std::string& name);

inline bool computes_in_double(Accuracy accuracy) { return accuracy == Accuracy::full; }
/// Of a ray's or a sphere's number in kernels: 4 or 8.
inline int real_bytes(Accuracy accuracy) { return computes_in_double(accuracy) ? 8 : 4; }

/// With a blank before each: what kernels are built with that trace rays and shade hits.
std::string build_options(Accuracy accuracy);

/// Those that a device can compute in.
std::vector<Accuracy> available_accuracies(const DeviceInfo& device);

/// Throws Error(Blame::input) where the device cannot compute so, and says how it can.
void check_accuracy(Accuracy accuracy, const DeviceInfo& device);

}  // namespace gnomon
