// Verdicts for a terminal and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify.h"

namespace gnomon::verify {

/// A table of the devices, and below it a line for each difference, error and note.
std::string to_text(const std::vector<Verdict>& verdicts);

/// {"same": ..., "devices": [{"device": ..., "same": ..., "pictures": ..., "differences": [...], ...}]}
nlohmann::ordered_json to_json(const std::vector<Verdict>& verdicts);

}  // namespace gnomon::verify
