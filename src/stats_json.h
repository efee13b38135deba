// What --stats and devices --json write.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "check.h"
#include "render.h"

namespace gnomon {

/// Everything that a rendering on the command line measured.
struct RunStats {
    std::string scene_path;
    double load_seconds = 0, device_seconds = 0, write_seconds = 0, check_seconds = 0;
    RenderStats render;
    Check check;
};

nlohmann::ordered_json to_json(const DeviceInfo& device);
nlohmann::ordered_json to_json(const RunStats& run, const Scene& scene, const std::vector<DeviceInfo>& devices);

/// One line: device, picture, seconds a stage, and the speed with its error.
std::string summary(const RunStats& run, const std::vector<DeviceInfo>& devices, const ImageSize& image);
/// One line: which device did how much.
std::string shares(const RenderStats& stats);

}  // namespace gnomon
