// gnomon verify ...
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "device_options.h"

namespace gnomon {

/// Compares the bits of devices with those recorded.
class VerifyCommand {
  public:
    explicit VerifyCommand(CLI::App& app);
    bool chosen() const { return command_->parsed(); }
    /// The exit code: 0 all the same, 1 any difference or a device that failed; throws Error.
    int run() const;

  private:
    int record() const;
    int compare() const;

    CLI::App* command_;
    std::optional<DeviceOptions> devices_;
    std::string json_path_, record_path_;
    bool quick_ = false;
};

}  // namespace gnomon
