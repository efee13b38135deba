// The spheres as the device reads them: rows of floats, in the order of their ids.
#pragma once

#include <cstdint>
#include <functional>

#include "huge_pages.h"
#include "scene.h"
#include "survey.h"

namespace gnomon {

/// Some of a scene's spheres in its frame: rows of 4 or 7 floats, x y z radius and the albedo. Where numbers are no
/// floats, rests hold what rounding left over, 4 a row.
struct SphereRows {
    const float* rows = nullptr;  ///< into the scene's own table where it holds what is wanted, else into `made`
    int columns = 7;
    int64_t first = 0, count = 0;  ///< ids first, first + 1, ...
    HugeVector<int> ids;           ///< or, when it is not empty, these, ascending
    Rgb albedo;                    ///< of all, when there are 4 columns
    HugeVector<float> made, rests;
    std::function<void()> forget = {};  ///< to be called, if there is one, when the rows were read: see SphereTable
};

/// Rows first to first + count. The scene must outlive them.
SphereRows sphere_rows(const Scene& scene, const Frame& frame, int64_t first, int64_t count);

}  // namespace gnomon
