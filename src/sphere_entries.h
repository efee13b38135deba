// The key "spheres" of a scene file: spheres one by one, and files of many.
#pragma once

#include <string>

#include "json_reader.h"
#include "scene_io.h"

namespace gnomon {

/// Reads the list, or its one entry alone, into the scene; files are found from `folder`. What reflects more light
/// than arrives is added to the warnings, a few lines of it.
void read_spheres(const JsonReader& spheres, const std::string& folder, LoadedScene& loaded);

}  // namespace gnomon
