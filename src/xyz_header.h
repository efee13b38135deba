// The first two lines of XYZ files: how many atoms, and what stands in their lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

enum class XyzUse { skip, species, position, radius, color };

/// Words of an atom's line that belong together.
struct XyzColumns {
    XyzUse use;
    int64_t words;
};

/// The columns that a comment line declares as Properties=species:S:1:pos:R:3:..., else species and position.
/// Throws Error(Blame::input); `where` stands for the line in messages.
/// The format: https://github.com/libAtoms/extxyz
std::vector<XyzColumns> read_xyz_columns(std::string_view comment, const std::string& where);

}  // namespace gnomon
