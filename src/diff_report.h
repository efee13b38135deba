// What gnomon diff prints, and what its --json writes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "picture_diff.h"

namespace gnomon {

/// A comparison on the command line.
struct DiffRun {
    std::string path_a, path_b;
    Tolerances tolerances;
    int64_t allowed = 0;  ///< pixels that may differ
    PictureDiff diff;

    bool same() const { return diff.different.all() <= allowed; }
};

/// All figures. JSON has no NaN and no infinity: as values of a pixel these are the strings "nan", "inf" and "-inf".
nlohmann::ordered_json to_json(const DiffRun& run);

/// What was compared, a table with a row for each channel (inside and at silhouettes apart), and the verdict.
std::string describe_diff(const DiffRun& run);

}  // namespace gnomon
