#include "table_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <limits>
#include <type_traits>
#include <variant>

#include "error.h"

namespace gnomon {

namespace {

constexpr const char* column_names[columns_with_albedo] = {"x", "y", "z", "radius", "red", "green", "blue"};

/// What the values of each column may be. A NaN is outside of everything.
template <class T>
struct Limits {
    T low[columns_with_albedo], high[columns_with_albedo];

    bool hold(int column, T value) const { return value >= low[column] && value <= high[column]; }
};

/// The limits of a sphere's values. Doubles too must be finite in single precision, in which they are rendered.
template <class T>
Limits<T> sphere_limits() {
    constexpr T most = FLT_MAX, above_zero = std::numeric_limits<T>::denorm_min();
    return {{-most, -most, -most, above_zero, 0, 0, 0}, {most, most, most, most, most, most, most}};
}

/// The limits of what reflects no more than arrives, for values that are spheres'.
template <class T>
Limits<T> dim_limits() {
    Limits<T> limits = sphere_limits<T>();
    std::fill_n(limits.high + albedo_column, columns_with_albedo - albedo_column, T(1));
    return limits;
}

/// Whether all values are within the limits. Without a branch, over a fixed number of rows at a time: compilers make
/// vector instructions of it, and files of many millions of spheres are checked as fast as memory can be read.
template <int columns, class T>
bool all_within(const T* values, int64_t count, const Limits<T>& limits) {
    constexpr int tile = 16 * columns;  // whole vectors of any width up to 64 bytes, for 7 columns too
    T low[tile], high[tile];
    for (int i = 0; i < tile; ++i) low[i] = limits.low[i % columns], high[i] = limits.high[i % columns];
    int outside = 0;
    const auto compare = [&](const T* v, int i) { outside |= !(v[i] >= low[i]) | !(v[i] <= high[i]); };
    int64_t done = 0;
    for (; done + tile <= count; done += tile)
        for (int i = 0; i < tile; ++i) compare(values + done, i);
    for (int i = 0; done + i < count; ++i) compare(values + done, i);
    return outside == 0;
}

/// Calls visit(row, column) for each row with a value outside the limits, until it returns false; the column is that
/// of the row's first such value.
template <int columns, class T, class Visit>
void for_each_outside(const T* rows, int64_t count, const Limits<T>& limits, Visit visit) {
    constexpr int64_t block = 1024;  // rows; in the first cache when the rows are looked at one by one
    for (int64_t start = 0; start < count; start += block) {
        const int64_t end = std::min(start + block, count);
        if (all_within<columns>(rows + start * columns, (end - start) * columns, limits)) continue;
        for (int64_t row = start; row < end; ++row) {
            int column = 0;
            while (column < columns && limits.hold(column, rows[row * columns + column])) ++column;
            if (column < columns && !visit(row, column)) return;
        }
    }
}

template <class T, class Visit>
void for_each_outside(const SphereTable& table, const T* rows, const Limits<T>& limits, Visit visit) {
    if (table.columns == columns_with_albedo)
        for_each_outside<columns_with_albedo>(rows, table.count, limits, visit);
    else
        for_each_outside<columns_without_albedo>(rows, table.count, limits, visit);
}

/// What the column's limits are, for messages. A value beyond the range of float is told so in any column.
template <class T>
const char* expected(int column, T value) {
    const bool is_finite = value >= -T(FLT_MAX) && value <= T(FLT_MAX);
    if (!is_finite) return "a number from -3.4028234e38 to 3.4028234e38 (single precision)";
    return column == radius_column ? "a number > 0" : "a number >= 0";
}

}  // namespace

WrongValue find_wrong_value(const SphereTable& table) {
    WrongValue wrong;
    const auto search = [&](const auto* rows) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(rows)>>;
        for_each_outside(table, rows, sphere_limits<T>(), [&](int64_t row, int column) {
            const T value = rows[row * table.columns + column];
            const char* name = column_names[column];
            wrong = {row, fmt::format("found {} {}, expected {}", name, value, expected(column, value))};
            return false;
        });
    };
    std::visit(search, table.rows);
    return wrong;
}

BrightRows bright_rows(const SphereTable& table, size_t most) {
    BrightRows bright;
    if (table.columns != columns_with_albedo) return bright;
    const auto search = [&](const auto* rows) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(rows)>>;
        for_each_outside(table, rows, dim_limits<T>(), [&](int64_t row, int) {
            if (bright.first.size() < most) bright.first.push_back(row);
            ++bright.count;
            return true;
        });
    };
    std::visit(search, table.rows);
    return bright;
}

void expect_few_spheres(int64_t count, const std::string& where) {
    if (count <= max_spheres) return;
    throw Error(Blame::input, fmt::format("found {} spheres, expected at most {}", count, max_spheres), where);
}

double default_radius(const SphereDefaults& defaults, const std::string& missing, const std::string& path) {
    if (defaults.radius) return *defaults.radius;
    throw Error(Blame::input, "found no radius: " + missing, path,
                "give all the same one: {\"file\": ..., \"radius\": ...}");
}

}  // namespace gnomon
