// The hard scenes and the recorded fingerprints, from the binary.
#pragma once

#include <map>
#include <string>

namespace gnomon {

/// File name to text: scenes/*.json and recorded.json, as they were at build time. Made by cmake/embed.cmake.
const std::map<std::string, std::string>& embedded_verify_files();

}  // namespace gnomon
