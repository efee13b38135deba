// gnomon report [SCENE...] ...
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "device.h"
#include "report.h"

namespace gnomon {

/// Measures speed and error together, and writes them down.
class ReportCommand {
  public:
    explicit ReportCommand(CLI::App& app);
    bool chosen() const { return command_->parsed(); }
    /// The exit code; throws Error.
    int run() const;

  private:
    std::vector<DeviceInfo> chosen_devices() const;
    std::vector<report::NamedScene> chosen_scenes() const;
    report::Report measured() const;

    CLI::App* command_;
    std::vector<std::string> scenes_, devices_;
    std::string folder_ = ".";
    bool all_devices_ = false, quick_ = false;
};

}  // namespace gnomon
