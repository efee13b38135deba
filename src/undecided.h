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
    /// For the rays of so many blocks of such a plan; not cleared.
    UndecidedRays(const DeviceMemory& memory, const Plan& plan, int blocks);

    /// Sets none; `busy` then holds the end of it too.
    void clear(const cl::CommandQueue& queue, std::vector<cl::Event>& busy) const;
    /// As `words` once what the queue holds has ended; does not wait for that.
    void read(const cl::CommandQueue& queue, std::vector<uint32_t>& words) const;

    const cl::Buffer& words() const { return words_; }
    /// Two reals each for Plan::doubt_rays (cl/certify.h).
    const cl::Buffer& doubts() const { return doubts_; }
    static int first_word(int first_block) { return first_block * words_of_block; }

  private:
    static constexpr int words_of_block = BLOCK_RAYS / 32;

    size_t bytes_, doubts_bytes_;
    bool adds_up_;  // the doubts of several work-items
    cl::Buffer words_, doubts_;
};

/// The rays that are set, in order.
std::vector<int> undecided_rays(const std::vector<uint32_t>& words);
/// Their pixels, as places in the image row by row, of rays that the tiles have one after the other. Pixels outside the
/// image are decided.
std::vector<int> undecided_pixels(const std::vector<uint32_t>& words, const std::vector<Tile>& tiles,
                                  const ImageSize& image);

}  // namespace gnomon
