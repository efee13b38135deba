#include "device.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <mutex>
#include <utility>

#include "error.h"
#include "opencl.h"

namespace gnomon {

namespace {

/// Drivers pad their strings with blanks and zeros.
std::string trimmed(std::string s) {
    const auto blank = [](char c) { return c == '\0' || std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!s.empty() && blank(s.back())) s.pop_back();
    s.erase(s.begin(), std::find_if_not(s.begin(), s.end(), blank));
    return s;
}

DeviceType type_of(cl_device_type type) {
    if (type & CL_DEVICE_TYPE_GPU) return DeviceType::gpu;
    if (type & CL_DEVICE_TYPE_ACCELERATOR) return DeviceType::accel;
    return type & CL_DEVICE_TYPE_CPU ? DeviceType::cpu : DeviceType::other;
}

std::vector<cl::Platform> platforms() {
    std::vector<cl::Platform> found;
    try {
        cl::Platform::get(&found);
    } catch (const cl::Error& error) {
        if (error.err() != -1001) throw;  // CL_PLATFORM_NOT_FOUND_KHR, of the extension cl_khr_icd: no driver installed
    }
    return found;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
    std::vector<cl::Device> found;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
    } catch (const cl::Error& error) {
        if (error.err() != CL_DEVICE_NOT_FOUND) throw;  // rusticl and Clover offer platforms without devices
    }
    return found;
}

/// 0 where it cannot be split, or that would mean nothing.
int sub_devices_of(const cl::Device& device) {
    const cl_uint units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    const auto ways = device.getInfo<CL_DEVICE_PARTITION_PROPERTIES>();
    const bool useful = type_of(device.getInfo<CL_DEVICE_TYPE>()) == DeviceType::cpu && units > 1;
    const bool can = std::find(ways.begin(), ways.end(), CL_DEVICE_PARTITION_EQUALLY) != ways.end() &&
                     device.getInfo<CL_DEVICE_PARTITION_MAX_SUB_DEVICES>() >= units;
    return useful && can ? static_cast<int>(units) : 0;
}

/// OpenCL does not tell: CL_DEVICE_GLOBAL_MEM_CACHE_SIZE may be that of the last level, which cores share.
uint64_t core_cache_bytes() { return static_cast<uint64_t>(std::max(sysconf(_SC_LEVEL2_CACHE_SIZE), 0L)); }

void inspect_arithmetic(const cl::Device& device, DeviceInfo& info) {
    const cl_device_fp_config floats = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    constexpr cl_device_fp_config ieee = CL_FP_ROUND_TO_NEAREST | CL_FP_INF_NAN;
    info.correctly_rounded = (floats & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    info.fast_fma = (floats & CL_FP_FMA) != 0;
    info.subnormals = (floats & CL_FP_DENORM) != 0;
    info.ieee = (floats & ieee) == ieee;
}

/// "OpenCL 1.2 ..." (OpenCL 1.2, table 4.3).
void read_version(DeviceInfo& info) {
    if (std::sscanf(info.version.c_str(), "OpenCL %d.%d", &info.opencl_major, &info.opencl_minor) != 2)
        info.opencl_major = info.opencl_minor = 0;
}

DeviceInfo inspect(const cl::Device& device, int platform, int number) {
    DeviceInfo info;
    info.platform = platform;
    info.device = number;
    info.type = type_of(device.getInfo<CL_DEVICE_TYPE>());
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.platform_name = trimmed(cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>());
    info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    read_version(info);
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.compute_units = static_cast<int>(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
    info.sub_devices = sub_devices_of(device);
    info.core_cache_bytes = info.type == DeviceType::cpu ? core_cache_bytes() : 0;
    info.native_width_float = static_cast<int>(device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>());
    info.max_work_group = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    info.global_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.max_alloc_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    info.shares_memory = device.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>() != 0;
    info.out_of_order = (device.getInfo<CL_DEVICE_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0;
    info.fp64 = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
    inspect_arithmetic(device, info);
    info.address_bits = static_cast<int>(device.getInfo<CL_DEVICE_ADDRESS_BITS>());
    info.max_parameter_bytes = device.getInfo<CL_DEVICE_MAX_PARAMETER_SIZE>();
    info.max_constant_bytes = device.getInfo<CL_DEVICE_MAX_CONSTANT_BUFFER_SIZE>();
    info.little_endian = device.getInfo<CL_DEVICE_ENDIAN_LITTLE>() != 0;
    info.has_compiler = device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>() != 0;
    return info;
}

}  // namespace

const char* to_string(DeviceType type) {
    switch (type) {
        case DeviceType::cpu:
            return "cpu";
        case DeviceType::gpu:
            return "gpu";
        case DeviceType::accel:
            return "accel";
        case DeviceType::other:
            break;
    }
    return "other";
}

std::string DeviceInfo::number() const {
    const std::string whole = std::to_string(platform) + ":" + std::to_string(device);
    return parts == 0 ? whole : whole + "/" + std::to_string(parts) + "." + std::to_string(part);
}

DeviceInfo DeviceInfo::part_of(int number_of_parts, int number) const {
    DeviceInfo info = *this;
    info.parts = number_of_parts;
    info.part = number;
    return info;
}

void pin_device_threads() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;  // more cores than a set holds
    if (CPU_COUNT(&allowed) == sysconf(_SC_NPROCESSORS_ONLN)) setenv("POCL_AFFINITY", "1", 0);
}

std::vector<DeviceInfo> list_devices() try {
    std::vector<DeviceInfo> result;
    const std::vector<cl::Platform> found = platforms();
    for (size_t p = 0; p < found.size(); ++p) {
        const std::vector<cl::Device> devices = devices_of(found[p]);
        for (size_t d = 0; d < devices.size(); ++d)
            result.push_back(inspect(devices[d], static_cast<int>(p), static_cast<int>(d)));
    }
    if (result.empty())
        throw Error(Blame::run, found.empty() ? "no OpenCL platform is installed" : "no OpenCL platform has a device",
                    "", "install one: Debian's package pocl-opencl-icd runs kernels on the CPU");
    return result;
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), "listing OpenCL devices", "`clinfo` shows what the drivers say");
}

namespace {

/// The equal parts of a device; all of it, if there is one.
std::vector<cl::Device> parts_of(const cl::Device& device, int parts) {
    if (parts == 0) return {device};
    return equal_parts(device, static_cast<int>(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()) / parts);
}

cl::Device open_whole(const DeviceInfo& info) {
    return devices_of(platforms().at(static_cast<size_t>(info.platform))).at(static_cast<size_t>(info.device));
}

}  // namespace

DeviceInfo whole_of(const DeviceInfo& part) { return inspect(open_whole(part), part.platform, part.device); }

std::vector<DeviceInfo> parts_of(const DeviceInfo& whole, int parts) {
    std::vector<DeviceInfo> result;
    for (const cl::Device& device : parts_of(open_whole(whole), parts)) {
        result.push_back(inspect(device, whole.platform, whole.device).part_of(parts, static_cast<int>(result.size())));
        result.back().global_bytes /= static_cast<uint64_t>(parts);  // they share what the whole has
    }
    return result;
}

// They are kept until the process ends: PoCL's threads may give the last event back, and look at the part that it was
// of, when whoever waited for it has already let go of queue, context and part, of which a context retains the whole
// device alone (PoCL 3.1, clCreateContext.c, clReleaseEvent.c).
std::vector<cl::Device> equal_parts(const cl::Device& device, int units) {
    static std::mutex mutex;
    static auto& made = *new std::map<std::pair<cl_device_id, int>, std::vector<cl::Device>>;  // never destroyed
    const std::lock_guard<std::mutex> lock(mutex);
    std::vector<cl::Device>& parts = made[{device(), units}];
    const cl_device_partition_property equally[] = {CL_DEVICE_PARTITION_EQUALLY, units, 0};
    if (parts.empty()) cl::Device(device).createSubDevices(equally, &parts);
    return parts;
}

cl::Device open_device(const DeviceInfo& info) {
    return parts_of(open_whole(info), info.parts).at(static_cast<size_t>(info.part));
}

}  // namespace gnomon
