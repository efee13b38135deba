// What a reader sees: a speed and beside it the error, a line for each renderer.
#pragma once

#include <string>

#include "measure.h"
#include "process.h"

namespace bench {

/// Explains the columns.
void print_head();

/// gnomon's line, the peer's, and one for each kernel; `how` they were measured. `benign` has as many spheres and is no
/// adversary; it may be null.
void print_scene(const SceneTimes& times, const SceneTimes* benign, const std::string& peer, const Measure& how);

void print_process(const ProcessTimes& times);

}  // namespace bench
