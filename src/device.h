// Which OpenCL devices there are, and which one a user means.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gnomon {

enum class DeviceType { cpu, gpu, accel, other };

/// One device as its driver describes it.
struct DeviceInfo {
    int platform = 0, device = 0;  ///< as `clinfo -l` numbers them
    int parts = 0, part = 0;       ///< of a device that is cut into equal parts: how many, and which; 0: whole
    DeviceType type = DeviceType::other;
    std::string name, platform_name, version, driver;
    int compute_units = 0;
    int sub_devices = 0;            ///< of one compute unit each, into which a CPU can be split; 0: it cannot be
    bool cores_apart = false;       ///< each of these takes tiles of its own, whatever the scene
    uint64_t core_cache_bytes = 0;  ///< of the cache that a CPU's core has for itself (level 2); 0: unknown
    int native_width_float = 0;     ///< CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT
    uint64_t max_work_group = 0, global_bytes = 0, max_alloc_bytes = 0;
    bool shares_memory = false;      ///< with the host
    bool correctly_rounded = false;  ///< divide and sqrt, when asked (CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT)
    bool out_of_order = false, fp64 = false;
    uint64_t max_kernel_group = 0;     ///< work-items in a group of any kernel; 0: the driver says it of each
    int address_bits = 64;             ///< 32 or 64
    uint64_t max_parameter_bytes = 0;  ///< of a kernel's arguments together
    uint64_t max_constant_bytes = 0;   ///< of constant memory, of which kernels use none
    bool fast_fma = true;              ///< in hardware: every device has it correctly rounded, some in software
    bool subnormals = true;            ///< floats below 2^-126 are kept, not made 0
    bool ieee = true;                  ///< floats are rounded to nearest, and have infinities and NaN
    bool little_endian = true, has_compiler = true;
    int opencl_major = 1, opencl_minor = 2;

    /// "P:D", or "P:D/N.I" of part I of N.
    std::string number() const;
    /// Of a whole device, as far as it tells parts from each other and from the whole.
    DeviceInfo part_of(int parts, int part) const;
    /// PoCL on a CPU, whose compiler is clang.
    bool is_pocl() const { return type == DeviceType::cpu && platform_name == "Portable Computing Language"; }
    /// Whether its compiler works for several threads at once, as OpenCL demands. PoCL's has one lock, and who waits
    /// there cannot stop between two kernels; Oclgrind's crashes.
    bool compiles_at_once() const { return !is_pocl() && platform_name != "Oclgrind"; }
};

const char* to_string(DeviceType type);

/// Asks PoCL for a core of its own for each of its threads: left to the system two of them may share a core for frames
/// on end. To be called before devices are listed. Does nothing where POCL_AFFINITY is set already, or where the
/// process may not run on all cores, which PoCL would not heed.
void pin_device_threads();

/// All devices of all platforms that have any. Throws Error(Blame::run) when there is no OpenCL platform at all.
std::vector<DeviceInfo> list_devices();

/// The device that `request` means among `devices`: "P:D", "cpu", "gpu", "accel", or part of a name or platform (case
/// ignored); empty: the first GPU, else the first CPU, else the first. Throws Error(Blame::input) with the list when
/// none or several match.
const DeviceInfo& choose_device(const std::vector<DeviceInfo>& devices, const std::string& request);

/// The devices that several requests mean, each once. "all" means all; with "/N" behind it a request means N equal
/// parts of the device (clCreateSubDevices). No request: as choose_device() without. Throws Error(Blame::input) besides
/// when a device is asked for twice, whole or in parts, or cannot be cut like that.
std::vector<DeviceInfo> choose_devices(const std::vector<DeviceInfo>& devices,
                                       const std::vector<std::string>& requests);

/// The same devices, but for CPUs of which all cores are there, each as a part: these become one device with its
/// `cores_apart`.
std::vector<DeviceInfo> with_cores_joined(const std::vector<DeviceInfo>& devices);

}  // namespace gnomon
