#include "npy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "bytes.h"
#include "error.h"
#include "json_parse.h"
#include "npy_header.h"
#include "table_rows.h"

namespace gnomon {

namespace {

/// An array's numbers: where they begin in the file, and how they lie.
struct Layout {
    const char* data;
    int64_t count;
    int columns;
    ByteOrder order;
    bool column_by_column;  ///< what NumPy calls Fortran's order: the array was transposed before it was saved
};

std::string shown(const std::vector<int64_t>& shape) {
    constexpr size_t most = 8;
    const auto end = shape.begin() + static_cast<std::ptrdiff_t>(std::min(most, shape.size()));
    return fmt::format("({}{})", fmt::join(shape.begin(), end, ", "),
                       shape.size() > most ? ", ..."
                       : shape.size() == 1 ? ","
                                           : "");
}

int columns_of(const NpyHeader& header, const std::string& path) {
    const bool is_table = header.shape.size() == 2;
    for (const int columns : {columns_without_albedo, columns_with_albedo})
        if (is_table && header.shape[1] == columns) return columns;
    throw Error(Blame::input,
                "found an array of shape " + shown(header.shape) +
                    ", expected (N, 4): x y z radius, or (N, 7): with red green blue",
                path);
}

/// The file must hold the array's numbers, all of them and nothing more.
void expect_size(int64_t count, int64_t row_size, std::size_t bytes, const std::string& path) {
    expect_few_spheres(count, path);
    const auto size = static_cast<int64_t>(bytes);
    if (count > size / row_size)
        throw Error(Blame::input, fmt::format("found data for {} of {} rows", size / row_size, count), path,
                    "was the file written to its end?");
    if (count < size / row_size || size % row_size != 0)
        throw Error(Blame::input, fmt::format("found {} bytes after the {} rows", size - count * row_size, count),
                    path);
}

template <class T>
std::vector<T> copied(const Layout& layout) {
    std::vector<T> values(static_cast<size_t>(layout.count * layout.columns));
    const int64_t row_step = layout.column_by_column ? 1 : layout.columns;
    const int64_t column_step = layout.column_by_column ? layout.count : 1;
    auto value = values.begin();
    for (int64_t row = 0; row < layout.count; ++row)
        for (int column = 0; column < layout.columns; ++column) {
            const int64_t index = row * row_step + column * column_step;
            *value++ = load<T>(layout.data + index * static_cast<int64_t>(sizeof(T)), layout.order);
        }
    return values;
}

template <class T>
SphereTable table_in(const SharedFile& file, const Layout& layout, Rgb albedo) {
    const bool aligned = reinterpret_cast<std::uintptr_t>(layout.data) % alignof(T) == 0;
    if (!aligned || layout.order != host_order || layout.column_by_column)
        return table_of(copied<T>(layout), layout.columns, albedo);
    const T* rows = reinterpret_cast<const T*>(layout.data);
    const size_t row_size = static_cast<size_t>(layout.columns) * sizeof(T);
    const auto forget = [file, rows, row_size, columns = layout.columns](int64_t first, int64_t count) {
        file->forget(rows + first * columns, static_cast<size_t>(count) * row_size);
    };
    return {file, rows, layout.count, layout.columns, albedo, forget};
}

}  // namespace

SphereTable read_npy(const SharedFile& file, const SphereDefaults& defaults) {
    const NpyHeader header = read_npy_header(file->bytes(), file->path());
    const std::string &path = file->path(), &descr = header.descr;
    if (descr != "<f4" && descr != "<f8" && descr != ">f4" && descr != ">f8")
        throw Error(Blame::input, "found numbers of type " + quote(descr) + ", expected <f4, <f8, >f4 or >f8", path,
                    "in Python: array.astype(numpy.float32)");
    const bool is_float = descr[2] == '4';
    const int columns = columns_of(header, path);
    const int64_t row_size = columns * static_cast<int64_t>(is_float ? sizeof(float) : sizeof(double));
    expect_size(header.shape[0], row_size, file->bytes().size() - header.data_start, path);

    const Layout layout{file->bytes().data() + header.data_start, header.shape[0], columns,
                        descr[0] == '<' ? ByteOrder::little : ByteOrder::big, header.fortran_order};
    const Rgb albedo = default_albedo(defaults);
    return is_float ? table_in<float>(file, layout, albedo) : table_in<double>(file, layout, albedo);
}

}  // namespace gnomon
