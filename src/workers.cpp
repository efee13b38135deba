#include "workers.h"

#include <algorithm>

namespace gnomon {

namespace {

/// The device and, if it can be split, its cores.
std::vector<cl::Device> open(const DeviceInfo& info) {
    const cl::Device whole = open_device(info);
    std::vector<cl::Device> devices{whole};
    if (info.sub_devices == 0) return devices;
    const std::vector<cl::Device> cores = equal_parts(whole, 1);
    devices.insert(devices.end(), cores.begin(), cores.end());
    return devices;
}

cl::CommandQueue make_queue(const cl::Context& context, const cl::Device& device, const DeviceInfo& info) {
    cl_command_queue_properties properties = CL_QUEUE_PROFILING_ENABLE;
    if (info.out_of_order) properties |= CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE;
    return cl::CommandQueue(context, device, properties);
}

}  // namespace

Workers::Workers(const DeviceInfo& info)
    : devices_(open(info)), context_(devices_), units_(std::max(info.compute_units, 1)) {
    for (const cl::Device& device : devices_) queues_.push_back(make_queue(context_, device, info));
}

std::vector<cl::CommandQueue> Workers::queues(int workers) const {
    if (workers == 1) return {whole()};
    return {queues_.begin() + 1, queues_.begin() + 1 + workers};
}

}  // namespace gnomon
