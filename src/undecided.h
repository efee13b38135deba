// The rays that rounding may have decided: a bit each, 32 a word, in block order, tile after tile. With what is to be
// known of the others' hits.
#pragma once

#include <cstdint>
#include <vector>

#include "device_memory.h"
#include "plan.h"

namespace gnomon {

/// On the device.
class UndecidedRays {
  public:
    /// For the rays of so many blocks of such a plan; not cleared. Of pictures that are not certified there are none.
    UndecidedRays(const DeviceMemory& memory, const Plan& plan, int blocks);

    /// Sets none, where kernels add to what there is; `busy` then holds the end of it too.
    void clear(const cl::CommandQueue& queue, std::vector<cl::Event>& busy) const;
    /// Those of so many blocks that are set, in order, once all of `after` has ended; waits for that.
    std::vector<int> read(const cl::CommandQueue& queue, const std::vector<cl::Event>& after, int blocks) const;

    const cl::Buffer& words() const { return words_; }
    /// Two reals each for Plan::doubt_rays (cl/certify.h).
    const cl::Buffer& doubts() const { return doubts_; }

  private:
    static constexpr int words_of_block = BLOCK_RAYS / 32;

    size_t bytes_, doubts_bytes_;
    bool adds_rays_, adds_doubts_;
    cl::Buffer words_, doubts_;
};

/// The pixels of rays that the tiles have one after the other, as places in the image row by row.
std::vector<int> pixels_of(const std::vector<int>& rays, const std::vector<Tile>& tiles, const ImageSize& image);

}  // namespace gnomon
