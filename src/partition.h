// Spheres that do not fit a device are cut into chunks: each holds what lies in one part of space.
#pragma once

#include <cstdint>
#include <vector>

#include "sphere_rows.h"

namespace gnomon {

/// Coincident spheres are always in one chunk, so that which of them counts does not depend on the cut.
struct Partition {
    std::vector<uint16_t> chunk_of;  ///< of each id
    std::vector<int64_t> sizes;      ///< of each chunk
    std::vector<int64_t> early;      ///< how many of each chunk are in the first half of the ids

    int chunks() const { return static_cast<int>(sizes.size()); }
};

/// Chunks of no more than `capacity` spheres, in the order of Morton's curve through a grid; where a cell of that holds
/// more, it is cut by a hash of the spheres. One pass over the spheres, two where a cell is cut. Throws
/// Error(Blame::run) when more spheres coincide than fit a chunk.
Partition cut_into_chunks(const Scene& scene, const Survey& survey, const Frame& frame, int64_t capacity);

/// The rows of one chunk, with their ids, in the order of these. `rows` may hold those of another: its memory is used.
void rows_of_chunk(const Scene& scene, const Frame& frame, const Partition& partition, int chunk, SphereRows& rows);

}  // namespace gnomon
