// Spheres that do not fit a device are cut into chunks: each holds what lies in one part of space.
#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"
#include "survey.h"

namespace gnomon {

/// Coincident spheres are always in one chunk, so that which of them counts does not depend on the cut.
struct Partition {
    /// Of each block's ids (id_blocks.h) those in chunk 0, then those in chunk 1, ..., ascending, from the block's
    /// first on.
    std::vector<uint16_t> places;
    /// Where in a block those of each chunk begin and the last ones end: chunks() + 1 numbers a block.
    std::vector<uint32_t> starts;
    std::vector<int64_t> sizes;  ///< of each chunk

    int chunks() const { return static_cast<int>(sizes.size()); }
};

/// Chunks of no more than `capacity` spheres, in the order of Morton's curve through a grid; where a cell of that holds
/// more, it is cut by a hash of the spheres. One pass over the spheres, two where a cell is cut. Throws
/// Error(Blame::run) when more spheres coincide than fit a chunk.
Partition cut_into_chunks(const Scene& scene, const Survey& survey, const Frame& frame, int64_t capacity);

}  // namespace gnomon
