// One channel of two pictures: by how much it differs, and where.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "film.h"

namespace gnomon {

/// What is known of a pixel, as bits of a byte.
enum Mark : uint8_t {
    silhouette_mark = 1,  ///< at a silhouette
    unequal_mark = 2,     ///< a channel has another value, however close
    different_mark = 4,   ///< a channel differs by more than its tolerance, or the ids differ
};

/// A pixel, counted in rows from the top, and both values there.
template <class Value>
struct Sample {
    size_t pixel;
    Value a, b;
};

/// Which percentiles are found, in tenths of a percent.
inline constexpr std::array<int64_t, 4> permilles{500, 900, 990, 999};

/// NaN and infinities are values, each of which equals itself and nothing else. -0 equals 0.
bool equal_values(float a, float b);

/// How two planes differ in some of their pixels. NaN beside NaN, or an infinity beside itself, is in no figure below.
/// `nonfinite` counts NaN and infinities against anything else, and all other figures are those of the `finite` pixels,
/// in which both values are.
struct Differences {
    int64_t finite = 0;
    int64_t over = 0;                                    ///< pixels whose |a - b| is above the tolerance
    int64_t nonfinite = 0;                               ///< pixels too, and none of those in `over`
    double max = 0, sum_of_squares = 0;                  ///< of |a - b|, unit of the channel
    std::array<double, permilles.size()> percentiles{};  ///< nearest rank: the least value that so many do not exceed
    std::optional<Sample<float>> worst;                  ///< the first pixel with the maximum, unless that is 0
    std::optional<Sample<float>> first_nonfinite;

    double rms() const;
    int64_t different() const { return over + nonfinite; }
};

/// Differences in all pixels, and apart: those marked as silhouettes, and the others.
struct ChannelDiff {
    Differences all, inside, silhouette;
};

/// Compares planes of the same size. `tolerance` is absolute, `marks` has one byte a pixel and gets the unequal and the
/// different ones. `room` is scratch space, to be used again for the next channel.
ChannelDiff diff_channel(const Plane<float>& a, const Plane<float>& b, double tolerance, std::vector<uint8_t>& marks,
                         std::vector<double>& room);

}  // namespace gnomon
