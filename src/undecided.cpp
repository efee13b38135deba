#include "undecided.h"

namespace gnomon {

namespace {

/// Of a tile's ray.
int pixel_of(int ray, const Tile& tile, const ImageSize& image) {
    const int block = ray / BLOCK_RAYS, inside = ray % BLOCK_RAYS;
    const int i = tile.x + block % tile.blocks_x * BLOCK_SIDE + inside % BLOCK_SIDE,
              j = tile.y + block / tile.blocks_x * BLOCK_SIDE + inside / BLOCK_SIDE;
    return j * image.width + i;
}

}  // namespace

UndecidedRays::UndecidedRays(const DeviceMemory& memory, const Plan& plan, int blocks)
    : bytes_(static_cast<size_t>(blocks) * words_of_block * sizeof(uint32_t)),
      doubts_bytes_(static_cast<size_t>(blocks) * BLOCK_RAYS / static_cast<size_t>(plan.doubt_rays) * 2 *
                    static_cast<size_t>(real_bytes(plan.accuracy))),
      adds_up_(plan.rays_per_item() < plan.doubt_rays),
      words_(memory.room<uint32_t>(int64_t{blocks} * words_of_block)),
      doubts_(memory.room<uint8_t>(static_cast<int64_t>(doubts_bytes_))) {}

void UndecidedRays::clear(const cl::CommandQueue& queue, std::vector<cl::Event>& busy) const {
    queue.enqueueFillBuffer(words_, uint32_t{0}, 0, bytes_, nullptr, &busy.emplace_back());
    if (adds_up_) queue.enqueueFillBuffer(doubts_, uint32_t{0}, 0, doubts_bytes_, nullptr, &busy.emplace_back());
}

void UndecidedRays::read(const cl::CommandQueue& queue, std::vector<uint32_t>& words) const {
    words.resize(bytes_ / sizeof(uint32_t));
    queue.enqueueReadBuffer(words_, CL_FALSE, 0, bytes_, words.data());
}

std::vector<int> undecided_rays(const std::vector<uint32_t>& words) {
    std::vector<int> rays;
    for (size_t word = 0; word < words.size(); ++word)
        for (uint32_t rest = words[word], bit = 0; rest != 0; rest >>= 1, ++bit)
            if (rest & 1) rays.push_back(static_cast<int>(32 * word + bit));
    return rays;
}

std::vector<int> undecided_pixels(const std::vector<uint32_t>& words, const std::vector<Tile>& tiles,
                                  const ImageSize& image) {
    std::vector<int> pixels;
    auto tile = tiles.begin();
    int first = 0;  // of the tile's rays
    for (const int ray : undecided_rays(words)) {
        for (; ray - first >= tile->blocks * BLOCK_RAYS; ++tile) first += tile->blocks * BLOCK_RAYS;
        pixels.push_back(pixel_of(ray - first, *tile, image));
    }
    return pixels;
}

}  // namespace gnomon
