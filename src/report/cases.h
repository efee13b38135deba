// What the formulas are measured on: easy rays and hard ones, drawn from fixed seeds, the same everywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../../cl/types.h"

namespace gnomon::report {

/// Rays from the origin against spheres, as the kernel measure_roots reads them.
struct RootCase {
    std::string name, about;
    std::vector<RootSphere> spheres;
    std::vector<Float3> dirs;  ///< BLOCK_RAYS for each sphere, unit length but for rounding to float
};

/// All cases but the grid, of about `rays` rays each.
std::vector<RootCase> root_cases(int64_t rays);

/// Cells over log10(distance / radius), 0 to `decades`, and impact / radius, 0 to `impacts`. (The impact is the
/// distance of the centre from the line.)
struct Grid {
    int columns = 28, rows = 25;
    double decades = 7, impacts = 1.25;
    int blocks = 1;  ///< spheres a cell, of BLOCK_RAYS rays each

    int cells() const { return columns * rows; }
};
/// Cell after cell, row after row, the lowest distance and impact first.
RootCase grid_case(const Grid& grid);

}  // namespace gnomon::report
