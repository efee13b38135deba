// Runs gnuplot.
#pragma once

#include <string>
#include <vector>

namespace gnomon::report {

/// Whether there is a gnuplot on the PATH that starts.
bool has_gnuplot();

/// The SVGs that the scripts draw, in their order; each script runs in a temporary folder and writes to "out.svg".
/// Throws Error(Blame::run) with what gnuplot says.
std::vector<std::string> draw(const std::vector<std::string>& scripts);

}  // namespace gnomon::report
