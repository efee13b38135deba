// The report as one page that needs nothing but itself.
#pragma once

#include <string>

#include "report.h"

namespace gnomon::report {

std::string to_html(const Report& report);

}  // namespace gnomon::report
