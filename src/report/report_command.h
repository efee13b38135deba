// gnomon report [SCENE...] ...
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "device_options.h"
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
    std::vector<report::NamedScene> chosen_scenes() const;
    report::Report measured() const;

    CLI::App* command_;
    std::optional<DeviceOptions> devices_;
    std::vector<std::string> scenes_;
    std::string folder_ = ".";
    bool quick_ = false;
};

}  // namespace gnomon
