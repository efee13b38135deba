#include "undecided.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace gnomon {

namespace {

/// Of a tile's ray.
int pixel_of(int ray, const Tile& tile, const ImageSize& image) {
    const int block = ray / BLOCK_RAYS, inside = ray % BLOCK_RAYS;
    const int i = tile.x + block % tile.blocks_x * BLOCK_SIDE + inside % BLOCK_SIDE,
              j = tile.y + block / tile.blocks_x * BLOCK_SIDE + inside / BLOCK_SIDE;
    return j * image.width + i;
}

/// Of those that are set, in order. Few are: words are looked at by the cache line.
std::vector<int> places_of_bits(const uint32_t* words, size_t count) {
    constexpr size_t line = 16;
    std::vector<int> places;
    for (size_t first = 0; first < count; first += line) {
        const size_t end = std::min(first + line, count);
        if (std::accumulate(words + first, words + end, 0u, std::bit_or<>()) == 0) continue;
        for (size_t word = first; word < end; ++word)
            for (uint32_t rest = words[word]; rest != 0; rest &= rest - 1)
                places.push_back(static_cast<int>(32 * word) + __builtin_ctz(rest));
    }
    return places;
}

}  // namespace

UndecidedRays::UndecidedRays(const DeviceMemory& memory, const Plan& plan, int blocks)
    : bytes_(static_cast<size_t>(blocks) * words_of_block * sizeof(uint32_t)),
      doubts_bytes_(static_cast<size_t>(blocks) * BLOCK_RAYS / static_cast<size_t>(plan.doubt_rays) * 2 *
                    static_cast<size_t>(real_bytes(plan.accuracy))),
      adds_rays_(plan.adds_to_blocks()),
      adds_doubts_(plan.rays_per_item() < plan.doubt_rays) {
    if (!plan.certified) return;
    words_ = memory.room<uint32_t>(int64_t{blocks} * words_of_block);
    doubts_ = memory.room<uint8_t>(static_cast<int64_t>(doubts_bytes_));
}

void UndecidedRays::clear(const cl::CommandQueue& queue, std::vector<cl::Event>& busy) const {
    if (adds_rays_) queue.enqueueFillBuffer(words_, uint32_t{0}, 0, bytes_, nullptr, &busy.emplace_back());
    if (adds_doubts_) queue.enqueueFillBuffer(doubts_, uint32_t{0}, 0, doubts_bytes_, nullptr, &busy.emplace_back());
}

std::vector<int> UndecidedRays::read(const cl::CommandQueue& queue, const std::vector<cl::Event>& after,
                                     int blocks) const {
    const size_t bytes = static_cast<size_t>(blocks) * words_of_block * sizeof(uint32_t);
    // Mapped: where the device shares the host's memory nothing is copied.
    void* mapped = queue.enqueueMapBuffer(words_, CL_TRUE, CL_MAP_READ, 0, bytes, &after);
    std::vector<int> rays = places_of_bits(static_cast<const uint32_t*>(mapped), bytes / sizeof(uint32_t));
    queue.enqueueUnmapMemObject(words_, mapped);
    return rays;
}

std::vector<int> pixels_of(const std::vector<int>& rays, const std::vector<Tile>& tiles, const ImageSize& image) {
    std::vector<int> pixels;
    pixels.reserve(rays.size());
    auto tile = tiles.begin();
    int first = 0;  // of the tile's rays
    for (const int ray : rays) {
        for (; ray - first >= tile->blocks * BLOCK_RAYS; ++tile) first += tile->blocks * BLOCK_RAYS;
        pixels.push_back(pixel_of(ray - first, *tile, image));
    }
    return pixels;
}

}  // namespace gnomon
