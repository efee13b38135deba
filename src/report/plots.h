// The figures, as scripts for gnuplot with their data in them. Pure.
#pragma once

#include <string>
#include <vector>

#include "report.h"

namespace gnomon::report {

/// Time against error, a panel for each case; and for each scene.
std::string pareto_of_roots(const DeviceReport& device);
std::string pareto_of_pictures(const DeviceReport& device);
/// How often t is how far off, a panel for each case.
std::string histograms(const DeviceReport& device);
/// Over distance and impact, a panel for each formula: the largest error of t, and the share of wrong decisions.
std::string heat_of_t(const DeviceReport& device);
std::string heat_of_decisions(const DeviceReport& device);

/// All of them, drawn. Throws Error(Blame::run) when gnuplot fails.
std::vector<Figure> figures(const DeviceReport& device);

/// The drawing alone, as it stands inside a page that has others: its ids begin with `prefix`.
std::string inlined(const std::string& svg, const std::string& prefix);

}  // namespace gnomon::report
