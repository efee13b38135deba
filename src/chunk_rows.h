// The rows of one chunk, out of a scene's.
#pragma once

#include "partition.h"
#include "sphere_rows.h"

namespace gnomon {

/// The rows of one chunk, with their ids, in the order of these. `rows` may hold those of another: its memory is used.
void rows_of_chunk(const Scene& scene, const Frame& frame, const Partition& partition, int chunk, SphereRows& rows);

}  // namespace gnomon
