// --device and --all-devices, for the subcommands that take several devices.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "device.h"

namespace gnomon {

/// Which devices a command line means. Must stay where it is while the command line is read.
class DeviceOptions {
  public:
    explicit DeviceOptions(CLI::App& command);
    /// Each device once, in the order in which they were asked for; without any the one that GNOMON_DEVICE or
    /// choose_device() names. Throws Error.
    std::vector<DeviceInfo> chosen() const;

  private:
    std::vector<std::string> requests_;
    bool all_ = false;
};

}  // namespace gnomon
