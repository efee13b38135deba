// Files of many spheres: arrays, point clouds and molecules in, tables out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mapped_file.h"
#include "scene.h"

namespace gnomon {

/// What holds for the spheres of a file that says nothing about it. Values as in a scene file.
struct SphereDefaults {
    std::optional<double> radius;
    std::optional<Rgb> albedo;  ///< without it, white
};

/// Reads and checks a file of spheres: NumPy's .npy, .ply, .xyz or .extxyz, by its extension. An .npy file's rows stay
/// in the file where its layout allows; it must not change while the table lives, which forget() refuses too.
/// Throws Error(Blame::input) with file, row and what was found.
SphereTable load_spheres(const std::string& path, const SphereDefaults& defaults = {});
/// The same in two steps, for a file that is read more than once.
SharedFile open_spheres(const std::string& path);
SphereTable load_spheres(const SharedFile& file, const SphereDefaults& defaults);

/// The rows whose albedo is above 1, of a table with 7 columns: the first few and the number of all.
struct BrightRows {
    std::vector<int64_t> first;
    int64_t count = 0;
};
BrightRows bright_rows(const SphereTable& table, size_t most);

/// A row of a table that load_spheres() read, as messages begin: "grains.ply: vertex 7".
std::string row_location(const std::string& path, int64_t row);

}  // namespace gnomon
