// The whole program as a user runs it: process start, scene file, device, kernels, picture, image file, check.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "measure.h"

namespace bench {

struct ProcessTimes {
    std::string name;
    Series wall;
    nlohmann::ordered_json stats;  ///< what --stats wrote in a run of its own
};

/// `gnomon render scene.json -o picture.png` so many times, after once unmeasured, which fills the driver's cache of
/// kernels. `device` is as --device takes it. Throws Error(Blame::run) when the program fails.
ProcessTimes time_process(const std::string& name, const gnomon::Scene& scene, const std::string& device, int runs);

}  // namespace bench
