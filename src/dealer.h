// Deals tiles to workers while they work.
#pragma once

#include <functional>

#include "opencl.h"

namespace gnomon {

/// What to do with tiles 0, 1, ... `launch` and `ended` are called one at a time, but on threads of the driver too:
/// they must not wait for commands (OpenCL 1.2, 5.9, clSetEventCallback).
struct Deal {
    size_t tiles = 0, workers = 1;
    /// Launches a tile on a worker, flushed, and returns the event that ends it.
    std::function<cl::Event(size_t tile, size_t worker)> launch;
    std::function<void(size_t tile)> ended;
    std::function<void(double)> progress;  ///< if not empty, is told the share that has ended, by the caller's thread
};

/// Gives every worker a tile, and the next one when that has ended, until all are: a core that others use besides gets
/// fewer. Where the driver calls back on the thread that did the work, as PoCL does, no other thread takes a core for
/// it. Throws the first error of a launch, or progress' own, when no tile is under way any more.
void deal(const Deal& what);

}  // namespace gnomon
