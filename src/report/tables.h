// The report's tables: columns and cells as text, for the terminal and for HTML.
#pragma once

#include <string>
#include <vector>

#include "report.h"

namespace gnomon::report {

struct Table {
    std::string title, about;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< the first cell is a name, the others are numbers
    std::string verdict;                         ///< which rows are on the Pareto front, and whether the default is
};

Table table_of(const RootTable& table);
Table table_of(const PictureTable& table);
/// Where each formula does worst: case, error and the ray to all bits.
Table worst_rays(const DeviceReport& device);

/// What the columns mean.
extern const char* const legend;

/// As lines of text.
std::string to_text(const Table& table);
/// The whole report for a terminal.
std::string to_text(const Report& report);

}  // namespace gnomon::report
