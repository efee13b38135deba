// The header of NumPy's .npy files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// What the array's numbers are and how they lie, from the byte `data_start` on.
struct NpyHeader {
    std::string descr;  ///< byte order, kind and size: "<f4"
    bool fortran_order = false;
    std::vector<int64_t> shape;
    std::size_t data_start = 0;
};

/// Reads versions 1.0, 2.0 and 3.0. Throws Error(Blame::input); `path` stands for the file in messages.
/// The format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
NpyHeader read_npy_header(std::string_view bytes, const std::string& path);

}  // namespace gnomon
