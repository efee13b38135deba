// The text of the kernels, from the binary or from disk.
#pragma once

#include <map>
#include <string>

namespace gnomon {

/// The files of cl/ as they were at build time: name to text. Made by cmake/embed.cmake.
const std::map<std::string, std::string>& embedded_kernel_files();

/// One source string for cl/NAME.cl, its #include "..." lines replaced by the files, with #line so that the
/// compiler's messages name the real file and line. The files come from the folder that the environment variable
/// GNOMON_CL_DIR names, else from the binary. Throws Error(Blame::run) for a file that is not there.
std::string kernel_source(const std::string& name);

}  // namespace gnomon
