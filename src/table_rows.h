// Rows of spheres, whichever file they came from: making tables of them, and looking for values that cannot be.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene.h"
#include "sphere_io.h"

namespace gnomon {

/// The most spheres in a scene: their ids are 32-bit numbers.
constexpr int64_t max_spheres = 2147483647;

constexpr int columns_without_albedo = 4, columns_with_albedo = 7;
constexpr int radius_column = 3, albedo_column = 4;

/// A table that owns its rows, checked by nobody yet.
template <class T>
SphereTable table_of(std::vector<T> values, int columns, Rgb albedo) {
    const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
    return {owner, owner->data(), static_cast<int64_t>(owner->size()) / columns, columns, albedo};
}

/// The first value that no sphere can have: not finite in single precision, no radius > 0, an albedo < 0.
struct WrongValue {
    int64_t row = 0;
    std::string message;  ///< empty when there is none
};
WrongValue find_wrong_value(const SphereTable& table);

/// Throws Error(Blame::input) unless a file may claim so many spheres. `found` is the count as the file has it.
void expect_few_spheres(int64_t count, const std::string& where);

/// The albedo of all when the file has none.
inline Rgb default_albedo(const SphereDefaults& defaults) { return defaults.albedo.value_or(Rgb{1, 1, 1}); }

/// The radius that stands in for a file's missing one; throws Error(Blame::input) without. `missing` says what.
double default_radius(const SphereDefaults& defaults, const std::string& missing, const std::string& path);

}  // namespace gnomon
