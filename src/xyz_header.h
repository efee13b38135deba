// The first two lines of XYZ files: how many atoms, and what stands in their lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

enum class XyzUse { skip, species, position, radius, color, rest };

/// Words of an atom's line that belong together; "rest" is all to the line's end, however many.
struct XyzColumns {
    XyzUse use;
    int64_t words;
    bool integers = false;
};

/// The columns that a comment line declares as Properties=species:S:1:pos:R:3:..., else species, position and what may
/// follow. Throws Error(Blame::input); `where` stands for the line in messages. The format:
/// https://github.com/libAtoms/extxyz
std::vector<XyzColumns> read_xyz_columns(std::string_view comment, const std::string& where);

}  // namespace gnomon
