// The whole program as a user runs it: process start, scene file, device, kernels, picture, image file, check.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "measure.h"

namespace bench {

struct ProcessTimes {
    std::string name;
    Series first;                  ///< nothing of the kernels on disk: all are compiled
    Series wall;                   ///< once the first run has left them there
    nlohmann::ordered_json stats;  ///< what --stats wrote in a run of its own
};

/// `gnomon render scene.json -o picture.png` so many times with empty caches of kernels, PoCL's and gnomon's, and as
/// often again after one of these runs. `device` is as --device takes it. Throws Error(Blame::run) when the program
/// fails.
ProcessTimes time_process(const std::string& name, const gnomon::Scene& scene, const std::string& device, int runs);

}  // namespace bench
