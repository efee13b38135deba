// Where a picture passes from one sphere to another, or to none.
#pragma once

#include <cstdint>
#include <vector>

#include "film.h"

namespace gnomon {

/// Sets `bit` in the mark of each pixel that has another id than one of its neighbours (8 of them, fewer at the
/// picture's border). `marks` has one byte a pixel, rows from the top, as `ids` has; `width` divides their number.
void mark_silhouettes(const Plane<int32_t>& ids, size_t width, uint8_t bit, std::vector<uint8_t>& marks);

}  // namespace gnomon
