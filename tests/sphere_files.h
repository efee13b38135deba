// Files of spheres as other programs write them, for the tests that read them.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "catch.h"
#include "scene.h"

namespace gnomon::test {

/// A folder of a test's own, gone with the object.
class TempFolder {
  public:
    TempFolder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("gnomon_spheres_" + std::to_string(getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directory(path_);
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return *this / name;
    }

  private:
    std::filesystem::path path_;
};

template <class T>
std::string bytes_of(T value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    const uint16_t probe = 1;
    const bool host_is_big = *reinterpret_cast<const unsigned char*>(&probe) == 0;
    if (big_endian != host_is_big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

template <class T>
std::string bytes_of(const std::vector<T>& values, bool big_endian = false) {
    std::string bytes;
    for (const T value : values) bytes += bytes_of(value, big_endian);
    return bytes;
}

/// An .npy file with this header, padded as NumPy does, so that data starts at a multiple of 64, and then by so much.
inline std::string npy(const std::string& dict, const std::string& data, char version = 1, size_t shift = 0) {
    const size_t length_size = version == 1 ? 2 : 4, before = 8 + length_size;
    std::string header = dict;
    while ((before + header.size() + 1) % 64 != shift) header += ' ';
    header += '\n';
    const std::string length =
        version == 1 ? bytes_of(static_cast<uint16_t>(header.size())) : bytes_of(static_cast<uint32_t>(header.size()));
    return "\x93NUMPY" + std::string{version, '\0'} + length + header + data;
}

inline std::string npy_dict(const std::string& descr, size_t rows, size_t columns, bool fortran_order = false) {
    return "{'descr': '" + descr + "', 'fortran_order': " + (fortran_order ? "True" : "False") + ", 'shape': (" +
           std::to_string(rows) + ", " + std::to_string(columns) + "), }";
}

/// The shortest text that is certain to be this number again.
inline std::string text_of(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

/// Rows of x y z radius, and red green blue if columns are 7, of floats in all their digits.
inline std::vector<float> grains(size_t count, int columns) {
    std::mt19937 random(3);
    const auto share = [&] { return static_cast<float>(random()) / 4294967296.0f; };
    std::vector<float> rows;
    for (size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) rows.push_back(200 * share() - 100);
        rows.push_back(0.01f + 3 * share());
        for (int channel = 4; channel < columns; ++channel) rows.push_back(share());
    }
    return rows;
}

/// The header of a PLY file with one element of spheres, all properties of one type.
inline std::string ply_header(const std::string& format, const std::string& type, size_t count, int columns) {
    std::string header =
        "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " + std::to_string(count) + "\n";
    const std::vector<std::string> names{"x", "y", "z", "radius", "red", "green", "blue"};
    for (int i = 0; i < columns; ++i) header += "property " + type + " " + names[static_cast<size_t>(i)] + "\n";
    return header + "end_header\n";
}

/// Rows as lines of words.
template <class T>
std::string lines_of(const std::vector<T>& values, int columns, const std::string& before = "") {
    std::string text;
    for (size_t i = 0; i < values.size(); ++i) {
        const bool is_first = i % static_cast<size_t>(columns) == 0;
        text += (is_first ? (i > 0 ? "\n" + before : before) : " ") + text_of(static_cast<double>(values[i]));
    }
    return text + "\n";
}

inline std::vector<double> values_of(const Sphere& sphere) {
    const auto& [center, radius, albedo] = sphere;
    return {center.x, center.y, center.z, radius, albedo.r, albedo.g, albedo.b};
}

}  // namespace gnomon::test
