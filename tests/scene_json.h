#pragma once

#include <nlohmann/json.hpp>

#include "scene.h"

namespace gnomon::test {

/// As scene files have it; every number is read back as it was.
nlohmann::ordered_json to_json(const Scene& scene);

}  // namespace gnomon::test
