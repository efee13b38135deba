// The scenes that are measured when none is named.
#pragma once

#include <vector>

#include "measure_pictures.h"

namespace gnomon::report {

/// The two example scenes, and a ground with 99 small spheres at random under two directional lights and a point light.
std::vector<NamedScene> default_scenes();

}  // namespace gnomon::report
