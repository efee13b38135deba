#include "sphere_io.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "error.h"
#include "mapped_file.h"
#include "npy.h"
#include "ply.h"
#include "table_rows.h"
#include "text_lines.h"
#include "xyz.h"

namespace gnomon {

namespace {

struct Format {
    const char* extension;
    SphereTable (*read)(const SharedFile&, const SphereDefaults&);
    const char* row_name;  ///< what a row is called there
    int64_t first_row;     ///< the number of the first
};
constexpr std::array<Format, 4> formats{{{".npy", read_npy, "row", 0},
                                         {".ply", read_ply, "vertex", 0},
                                         {".xyz", read_xyz, "line", xyz_first_line},
                                         {".extxyz", read_xyz, "line", xyz_first_line}}};

const Format& format_of(const std::string& path) {
    const std::string extension = lower_case(std::filesystem::path(path).extension().string());
    const auto same = [&](const Format& format) { return extension == format.extension; };
    const auto found = std::find_if(formats.begin(), formats.end(), same);
    if (found != formats.end()) return *found;
    throw Error(Blame::input, "found no format for spheres, expected .npy, .ply, .xyz or .extxyz", path);
}

}  // namespace

SphereTable load_spheres(const std::string& path, const SphereDefaults& defaults) {
    return load_spheres(open_spheres(path), defaults);
}

SharedFile open_spheres(const std::string& path) {
    format_of(path);  // a wrong name is told before anything about the file
    return std::make_shared<const MappedFile>(path);
}

SphereTable load_spheres(const SharedFile& file, const SphereDefaults& defaults) {
    const std::string& path = file->path();
    const Format& format = format_of(path);
    const SphereTable table = format.read(file, defaults);
    const WrongValue wrong = find_wrong_value(table);
    file->expect_unchanged();
    if (!wrong.message.empty()) throw Error(Blame::input, wrong.message, row_location(path, wrong.row));
    return table;
}

std::string row_location(const std::string& path, int64_t row) {
    const Format& format = format_of(path);
    return path + ": " + format.row_name + " " + std::to_string(row + format.first_row);
}

}  // namespace gnomon
