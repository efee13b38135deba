// The report as JSON, whole.
#pragma once

#include <nlohmann/json.hpp>

#include "report.h"

namespace gnomon::report {

/// Every object that has a time has an "error" too. Floats of a worst ray are strings in C's %a, all bits.
nlohmann::ordered_json to_json(const Report& report);

}  // namespace gnomon::report
