// How many bytes of a device a scene takes: known before the first launch.
#pragma once

#include <cstdint>

#include "hierarchy.h"

namespace gnomon {

/// What decides how many bytes a sphere takes.
struct SphereFootprint {
    bool has_rests = false;    ///< numbers are pairs of floats
    bool copies_rows = false;  ///< the device does not read the host's memory
    int columns = 4;           ///< of the rows
    bool has_ids = false;      ///< rows come with their ids
    int faces = 1;             ///< the most that a pencil has
    int slices = 1;            ///< into which sorting is cut
    int real_bytes = 4;        ///< of a number as pencils see spheres

    int64_t rows(int64_t spheres) const;      ///< as they are read; 0 where they are the host's
    int64_t sorting(int64_t spheres) const;   ///< while they are put in order
    int64_t clusters(int64_t spheres) const;  ///< in order
    int64_t view(int64_t spheres) const;      ///< as one pencil sees them
    /// The most at any time while spheres are read, sorted and gathered, their clusters included.
    int64_t building(int64_t spheres) const;
    int64_t largest_buffer(int64_t spheres) const;
};

}  // namespace gnomon
