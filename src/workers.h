// The queues of a device: its own, and one for each of its cores where it is a CPU that can be split.
#pragma once

#include <vector>

#include "opencl.h"

namespace gnomon {

/// What all cores share is handed on by each launch to whichever core comes first, through caches that the cores of a
/// virtual machine, or of two sockets, may not share. On a core's own queue it stays in the cache of that core. The
/// cores are sub-devices (OpenCL 1.2, 4.3); buffers, events and programs are common to them and the whole device, as
/// all are in one context.
class Workers {
  public:
    /// Splits the device if `info` says that it can be. Throws cl::Error.
    explicit Workers(const DeviceInfo& info);

    const cl::Context& context() const { return context_; }
    /// The whole device, then its cores: programs must be built for all of them.
    const std::vector<cl::Device>& devices() const { return devices_; }
    /// All cores share what is launched here.
    const cl::CommandQueue& whole() const { return queues_.front(); }
    /// The queues for so many workers: for 1 the whole device's, else those of the first cores.
    std::vector<cl::CommandQueue> queues(int workers) const;
    /// Compute units of each of them.
    int units(int workers) const { return workers == 1 ? units_ : 1; }

  private:
    std::vector<cl::Device> devices_;
    cl::Context context_;
    std::vector<cl::CommandQueue> queues_;  // of each device
    int units_;
};

}  // namespace gnomon
