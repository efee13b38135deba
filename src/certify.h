// The pixels that rounding may have decided, decided again.
#pragma once

#include <vector>

#include "film.h"
#include "scene.h"

namespace gnomon {

/// Decides these pixels (places in the image, row by row) exactly and writes what they show into the planes that the
/// film has; distances in units of 1 / per_unit.
void decide_again(const Scene& scene, bool shadows, const std::vector<int>& pixels, double per_unit, Film& film);

}  // namespace gnomon
