// The example scenes, from the binary.
#pragma once

#include <map>
#include <string>

namespace gnomon {

/// File name to text, as they were at build time. Made by cmake/embed.cmake.
const std::map<std::string, std::string>& embedded_scenes();

}  // namespace gnomon
