// Pictures as hashes of their bits.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "film.h"

namespace gnomon::verify {

/// What is compared apart, in the order in which it is computed: who is wrong in one is often wrong in the next.
constexpr std::array<const char*, 4> results{"id", "distance", "normal", "radiance"};

/// SHA-1 of the bits of each result, and 16 bits of it for each row and each column of pixels, all results together:
/// they say where a picture differs, the others whether it does.
struct Fingerprint {
    std::array<std::string, results.size()> sha1;  ///< 40 hex digits
    std::string rows, columns;                     ///< 4 hex digits each, from the top, from the left
};

/// Of a film that has all results. Bits are those of a little-endian host.
Fingerprint fingerprint(const Film& film);

/// Of the radiance alone.
std::string radiance_sha1(const Film& film);

/// Places in which two lists of 4 hex digits each differ, ascending. Lists of different lengths differ everywhere.
std::vector<int> differing(const std::string& a, const std::string& b);

}  // namespace gnomon::verify
