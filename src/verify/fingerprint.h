// Pictures as hashes of their bits.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "film.h"

namespace gnomon::verify {

/// What is compared apart, in the order in which it is computed: who is wrong in one is often wrong in the next.
constexpr std::array<const char*, 4> results{"id", "distance", "normal", "radiance"};

/// Four ways to cut a picture into lines of pixels, so that each pixel is where four of them cross: rows from the top,
/// columns from the left, and the two diagonals, which leave a picture at one side and enter it at the other, by where
/// they cross the first row.
constexpr std::array<const char*, 4> lines{"rows", "columns", "falling", "rising"};

/// SHA-1 of the bits of each result, and 16 bits of it for each line of pixels, all results together: they say where a
/// picture differs, the others whether it does.
struct Fingerprint {
    std::array<std::string, results.size()> sha1;  ///< 40 hex digits
    std::array<std::string, lines.size()> shorts;  ///< 4 hex digits a line
};

/// A pixel, from the left and from the top.
struct Place {
    int x, y;
};

/// Of a film that has all results. Bits are those of a little-endian host.
Fingerprint fingerprint(const Film& film);

/// Of the radiance alone.
std::string radiance_sha1(const Film& film);

/// The pixels, of the first row that has any, that lie on four lines which differ. Where few pixels differ it is the
/// first that does; else that is one of them. None if all lines are the same, or of pictures of other sizes.
std::vector<Place> first_differing(const Fingerprint& a, const Fingerprint& b);

}  // namespace gnomon::verify
