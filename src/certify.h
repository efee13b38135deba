// Single pixels that are computed again.
#pragma once

#include <cstdint>
#include <vector>

#include "film.h"
#include "scene.h"
#include "stop.h"

namespace gnomon {

/// What one pixel shows.
struct Pixel {
    int32_t id;  ///< -1 for a miss
    double t;
    Vec3 normal;
    Rgb radiance;
};

/// Into the planes that the film has, rounded to float.
void put(Film& film, size_t at, const Pixel& pixel);

/// Decides these pixels (places in the image, row by row) exactly; distances are in the unit.
void decide_exactly(const Scene& scene, bool shadows, const std::vector<int>& pixels, double unit, Film& film,
                    const Stop* stop = nullptr);

}  // namespace gnomon
