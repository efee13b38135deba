// Scene files: JSON in, Scene out.
#pragma once

#include <string>
#include <vector>

#include "scene.h"

namespace gnomon {

/// A scene and what is odd, but not wrong, about its file (one line each, with file and JSON path).
struct LoadedScene {
    Scene scene;
    std::vector<std::string> warnings;
};

/// Reads and checks a scene file, and the files of spheres that it names. Throws Error(Blame::input) with file, JSON
/// path, what was found and what is expected.
LoadedScene load_scene(const std::string& path);

/// The same from text; `name` stands for the file in messages, and its folder is where files of spheres are found.
LoadedScene parse_scene(const std::string& text, const std::string& name);

/// "WxH" as --size takes it; throws Error(Blame::input). The limits are those of a scene file's image.
ImageSize parse_size(const std::string& text);

}  // namespace gnomon
