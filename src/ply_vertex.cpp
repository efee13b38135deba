#include "ply_vertex.h"

#include <algorithm>
#include <array>

#include "error.h"
#include "json_parse.h"

namespace gnomon {

namespace {

constexpr std::array<const char*, columns_with_albedo> used_names{"x", "y", "z", "radius", "red", "green", "blue"};

bool has(const PlyElement& element, const std::string& name) {
    const auto named = [&](const PlyProperty& property) { return property.name == name; };
    return std::any_of(element.properties.begin(), element.properties.end(), named);
}

bool fits_float(PlyType type) { return type != PlyType::int32 && type != PlyType::uint32 && type != PlyType::float64; }

/// The column for a property, which must be of a type that makes sense there.
int column_of(const PlyProperty& property, const std::string& path) {
    const auto name = std::find(used_names.begin(), used_names.end(), property.name);
    if (name == used_names.end()) return PlyVertexPlan::unused;
    const auto column = static_cast<int>(name - used_names.begin());
    if (property.length_type) throw Error(Blame::input, "found a list, expected a number", path + ": " + property.name);
    const bool is_share = property.type == PlyType::uint8 || property.type >= PlyType::float32;
    if (column >= albedo_column && !is_share)
        throw Error(Blame::input, "found another type, expected uchar, float or double", path + ": " + property.name);
    return column;
}

void expect_names(const PlyElement& vertex, const std::string& path) {
    const auto missing = [&](const char* name) { return !has(vertex, name); };
    const auto refuse = [&](const std::string& what) { throw Error(Blame::input, what, path); };
    for (const char* name : {"x", "y", "z"})
        if (missing(name)) refuse("found no property " + quote(name) + " of the vertices");
    const std::array<const char*, 3> colors{"red", "green", "blue"};
    const auto count = std::count_if(colors.begin(), colors.end(), missing);
    if (count != 0 && count != 3) refuse("found some of red, green and blue, expected all or none");
}

}  // namespace

PlyVertexPlan plan_ply_vertex(const PlyElement& vertex, const std::string& path) {
    expect_names(vertex, path);
    PlyVertexPlan plan;
    plan.has_radius = has(vertex, "radius");
    if (has(vertex, "red")) plan.columns = columns_with_albedo;
    for (const PlyProperty& property : vertex.properties) {
        plan.column.push_back(column_of(property, path));
        if (plan.column.back() != PlyVertexPlan::unused && !fits_float(property.type)) plan.fits_float = false;
    }
    return plan;
}

}  // namespace gnomon
