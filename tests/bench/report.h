// The same as JSON, whole.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "device.h"
#include "measure.h"
#include "process.h"

namespace bench {

nlohmann::ordered_json to_json(const SceneTimes& times);
nlohmann::ordered_json to_json(const ProcessTimes& times);

/// What was measured on: program, device, driver, processor and how much of it, peer, date.
nlohmann::ordered_json circumstances(const gnomon::DeviceInfo& device, int cores, const std::string& peer);

/// The processor's name as the system has it, "unknown" where it does not say.
std::string cpu_name();
/// Now, UTC, as ISO 8601 writes it.
std::string date();

}  // namespace bench
