// The subcommands: each declares its flags, and runs.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "image_io.h"
#include "render.h"
#include "report/report_command.h"
#include "verify/verify_command.h"

namespace gnomon {

/// gnomon render SCENE.json ...
class RenderCommand {
  public:
    explicit RenderCommand(CLI::App& app);
    bool chosen() const { return command_->parsed(); }
    /// The exit code; throws Error.
    int run();

  private:
    void say(const std::string& line) const;

    CLI::App* command_;
    std::string scene_path_, size_, view_ = "radiance", accuracy_ = "strict", stats_path_;
    std::vector<std::string> outputs_, devices_;
    Display display_;
    bool no_shadows_ = false, quiet_ = false;
    RenderOptions options_;
};

/// gnomon devices
class DevicesCommand {
  public:
    explicit DevicesCommand(CLI::App& app);
    bool chosen() const { return command_->parsed(); }
    /// The exit code; throws Error.
    int run() const;

  private:
    CLI::App* command_;
    bool json_ = false;
};

/// gnomon diff A.exr B.exr ...
class DiffCommand {
  public:
    explicit DiffCommand(CLI::App& app);
    bool chosen() const { return command_->parsed(); }
    /// The exit code: 0 same, 1 different; throws Error, all of them with code 2.
    int run() const;

  private:
    void check_outputs() const;
    int compare() const;

    CLI::App* command_;
    std::string path_a_, path_b_, output_, json_path_;
    std::vector<std::string> tolerances_;
    int64_t allowed_ = 0;
    bool quiet_ = false;
};

}  // namespace gnomon
