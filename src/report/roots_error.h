// How wrong a formula is: what it found against what is exact.
#pragma once

#include <optional>
#include <vector>

#include "cases.h"
#include "exact.h"
#include "measure_roots.h"
#include "statistics.h"

namespace gnomon::report {

/// So many wrong decisions of so many.
struct Decisions {
    int64_t wrong = 0, of = 0;
    std::optional<double> per_million() const;  ///< none of none
};

/// The ray whose t is farthest off.
struct WorstRay {
    RootSphere sphere;
    Float3 dir;
    float t;
    double exact;
};

/// t in ulp of the exact value and the normal's direction in radians, for rays that hit in truth and were found to;
/// maxima over a sample are lower bounds.
struct RootError {
    Summary t, normal;
    Histogram ulps;
    Decisions missed;      ///< of the rays that hit
    Decisions false_hits;  ///< of those that do not
    std::optional<WorstRay> worst;
};

std::vector<ExactHit> exact_hits(const RootCase& rays);
RootError compare(const RootCase& rays, const std::vector<ExactHit>& exact, const Roots& found);

/// The same for one cell of a grid: the largest error of t, none if no hit was found, and the wrong decisions of both
/// kinds.
struct Cell {
    std::optional<double> max_ulps;
    Decisions wrong;
};
std::vector<Cell> compare_cells(const Grid& grid, const RootCase& rays, const std::vector<ExactHit>& exact,
                                const Roots& found);

}  // namespace gnomon::report
