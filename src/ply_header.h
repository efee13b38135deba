// The header of PLY files: which elements there are, and of what.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// In bytes, in a binary file.
int size_of(PlyType type);

struct PlyIntegers {
    int64_t low, high;

    bool hold(int64_t number) const { return number >= low && number <= high; }
};
/// What an integer type can hold.
PlyIntegers integers_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;                        ///< of a list: of its items
    std::optional<PlyType> length_type;  ///< of the number before a list's items; none for one number alone
};

struct PlyElement {
    std::string name;
    int64_t count;
    std::vector<PlyProperty> properties;

    /// What one of them takes at least, with its lists empty.
    int64_t least_size(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format;
    std::vector<PlyElement> elements;
    std::size_t data_start;
};

/// Throws Error(Blame::input); `path` stands for the file in messages.
/// The format: Greg Turk, The PLY Polygon File Format, 1994.
PlyHeader read_ply_header(std::string_view bytes, const std::string& path);

}  // namespace gnomon
