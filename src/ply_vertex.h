// Which of a PLY vertex's properties make a sphere.
#pragma once

#include <string>
#include <vector>

#include "ply_header.h"
#include "table_rows.h"

namespace gnomon {

/// A vertex's properties as columns of a table's row.
struct PlyVertexPlan {
    static constexpr int unused = -1;

    std::vector<int> column;  ///< of each property; unused for those to skip
    int columns = columns_without_albedo;
    bool has_radius = false;
    bool fits_float = true;  ///< no property that is used has more digits
};

/// By the properties' names; throws Error(Blame::input) for missing ones, and types that make no sense.
PlyVertexPlan plan_ply_vertex(const PlyElement& vertex, const std::string& path);

}  // namespace gnomon
