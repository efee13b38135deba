#include "roots_error.h"

#include <algorithm>
#include <cmath>

namespace gnomon::report {

namespace {

Vec3 normal_of(const Roots& roots, size_t ray) {
    return {roots.normals[in_block_order(ray, 0, 3)], roots.normals[in_block_order(ray, 1, 3)],
            roots.normals[in_block_order(ray, 2, 3)]};
}

/// In radians; by the arc tangent, since the cosine of a small angle is 1.
double angle(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

}  // namespace

std::optional<double> Decisions::per_million() const {
    if (of == 0) return {};
    return 1e6 * static_cast<double>(wrong) / static_cast<double>(of);
}

std::vector<ExactHit> exact_hits(const RootCase& rays) {
    std::vector<ExactHit> hits;
    hits.reserve(rays.dirs.size());
    for (size_t i = 0; i < rays.dirs.size(); ++i) hits.push_back(exact_hit(rays.spheres[i / BLOCK_RAYS], rays.dirs[i]));
    return hits;
}

RootError compare(const RootCase& rays, const std::vector<ExactHit>& exact, const Roots& found) {
    RootError error;
    std::vector<double> ts, normals;
    std::vector<size_t> places;
    for (size_t i = 0; i < exact.size(); ++i) {
        const bool hits = std::isfinite(found.ts[i]);  // neither a miss nor NaN
        Decisions& decisions = exact[i].hits ? error.missed : error.false_hits;
        ++decisions.of;
        decisions.wrong += hits != exact[i].hits;
        if (!hits || !exact[i].hits) continue;
        ts.push_back(ulps(found.ts[i], exact[i].t));
        error.ulps.add(ts.back());
        normals.push_back(angle(normal_of(found, i), exact[i].normal));
        places.push_back(i);
    }
    error.t = summarize(ts);
    error.normal = summarize(normals);
    if (ts.empty()) return error;
    const size_t worst = places[error.t.worst];
    error.worst = WorstRay{rays.spheres[worst / BLOCK_RAYS], rays.dirs[worst], found.ts[worst], exact[worst].t};
    return error;
}

std::vector<Cell> compare_cells(const Grid& grid, const RootCase& rays, const std::vector<ExactHit>& exact,
                                const Roots& found) {
    std::vector<Cell> cells(static_cast<size_t>(grid.cells()));
    const size_t cell_rays = rays.dirs.size() / cells.size();
    for (size_t i = 0; i < exact.size(); ++i) {
        Cell& cell = cells[i / cell_rays];
        const bool hits = std::isfinite(found.ts[i]);
        ++cell.wrong.of;
        cell.wrong.wrong += hits != exact[i].hits;
        if (hits && exact[i].hits) cell.max_ulps = std::max(cell.max_ulps.value_or(0), ulps(found.ts[i], exact[i].t));
    }
    return cells;
}

}  // namespace gnomon::report
