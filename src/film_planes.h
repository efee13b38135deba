// How a device's results get into the film: a tile's rows are copied, or the film's memory is the device's too.
#pragma once

#include <utility>
#include <vector>

#include "film.h"
#include "opencl.h"
#include "plan.h"

namespace gnomon {

/// The film's planes behind one output: 32-bit values and bytes.
std::vector<std::pair<void*, size_t>> planes_of(Film& film, Output output);

/// Copies a tile's rows of one output, from a buffer for each of its planes, once all of `busy` has ended; `busy` is
/// then the end of that.
void read_tile(const cl::CommandQueue& queue, const cl::Buffer* planes, Output output, const Tile& tile, Film& film,
               std::vector<cl::Event>& busy);

/// Shows on the host what kernels wrote into buffers over the film's memory; waits for the queue.
void map_planes(const cl::CommandQueue& queue, const std::vector<cl::Buffer>& planes);

}  // namespace gnomon
