// Deals work to workers while they work.
#pragma once

#include <functional>

#include "opencl.h"

namespace gnomon {

/// What workers do. `launch` and `ended` are called one at a time, but on threads of the driver too: they must not wait
/// for commands (OpenCL 1.2, 5.9, clSetEventCallback).
struct Deal {
    size_t workers = 1;
    /// Launches what a worker does next, flushed, and returns the event that ends it; none when nothing is left for it.
    std::function<cl::Event(size_t worker)> launch;
    /// That has ended. Returns the share of all work that is done.
    std::function<double(size_t worker)> ended;
    std::function<void(double)> progress;  ///< if not empty, is told that share, by the caller's thread
};

/// Gives every worker something to do, and again when that has ended, until nothing is left: a core that others use
/// besides does less. Where the driver calls back on the thread that did the work, as PoCL does, no other thread takes
/// a core for it. Throws the first error of a launch, or progress' own, when nothing is under way any more.
void deal(const Deal& what);

}  // namespace gnomon
