// Devices against the record, and against each other where they differ from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record.h"

namespace gnomon::verify {

/// The first pixel, row by row, that differs from the same picture of a device which has it as recorded; both values.
struct Pixel {
    int x = 0, y = 0;  ///< from the left, from the top
    std::string channel;
    double value = 0, expected = 0;
    std::string device;  ///< which has the expected one
};

/// A picture that is not as recorded.
struct Difference {
    size_t scene;  ///< index of the case
    Mode mode;
    std::string picture;
    std::vector<std::string> results;  ///< that differ, in the order in which they are computed
    std::vector<Place> places;         ///< the first pixel that differs is one of these, all of one row
    std::string suspect;               ///< the kernel
    std::optional<Pixel> pixel;        ///< if another device tells

    /// "pixel (3, 4)" or what is known of it.
    std::string place() const;
};

/// What became of a device.
struct Verdict {
    DeviceInfo device;
    int pictures = 0;  ///< that were compared
    std::vector<Difference> differences;
    std::vector<std::string> notes;  ///< what was not tried, and why
    std::string error;               ///< that ended it; empty when none did
    double seconds = 0;

    bool same() const { return differences.empty() && error.empty(); }
};

/// Renders all cases in all of the device's modes. What the device or its compiler fails at becomes the verdict's
/// error, and ends it. Throws Error when the record lacks a picture.
Verdict verify_device(const DeviceInfo& device, const std::vector<Case>& cases, const Record& record, const Say& say);

/// The first pixel of which any bit differs, row by row, and in it the first channel, ids first, since they are
/// computed first. Both films have all results and one size. The device is left open.
std::optional<Pixel> first_pixel(const Film& film, const Film& expected);

/// Finds the pixels: each picture that differs is rendered again there and on the first of the devices that has it as
/// recorded, if there is one.
void find_pixels(std::vector<Verdict>& verdicts, const std::vector<Case>& cases, const Say& say);

}  // namespace gnomon::verify
