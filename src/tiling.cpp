#include "tiling.h"

#include <algorithm>
#include <cmath>

#include "error.h"

namespace gnomon {

namespace {

// Rays in a tile that the whole device works on. On a CPU the buffers of the tiles under way should stay in the caches,
// and a launch should cost little beside its work: two tiles of 128 Ki rays are 12 MiB, and a launch of one takes 0.1
// ms or more. A GPU wants to be filled. Rays of doubles take twice as much room.
constexpr int cpu_tile_rays = 1 << 17, gpu_tile_rays = 1 << 20;
constexpr int max_tile_rays = 1 << 24;

// What a core's cache holds if nobody can tell.
constexpr int64_t assumed_core_cache = 1 << 20;
// Rays in a tile that one core works on, at least: few spheres take 0.1 ms for 16 Ki rays, a tile's launches 20 us.
// Until the end comes tiles are larger: what a core's own cache does not hold, the one that all cores share mostly
// does, and with 512 KiB a core S4 and S100 took 1.15 times as long in tiles of 16 Ki rays, and S4 1.02 times in such
// of 48 Ki.
constexpr int64_t least_core_tile_rays = 1 << 14, usual_core_tile_rays = 6 << 14;
// Tiles are launched one at a time: with more workers than this they would wait for it longer than they work.
constexpr int most_workers = 8;

void check(int asked) {
    if (asked == 0 || (asked >= BLOCK_RAYS && asked <= max_tile_rays)) return;
    throw Error(Blame::input,
                "found " + std::to_string(asked) + ", expected rays a tile, " + std::to_string(BLOCK_RAYS) + " to " +
                    std::to_string(max_tile_rays),
                "--tile");
}

/// Row by row. `rays_of_next` says how many rays the next tile has at most, when so many blocks are left: whole rows of
/// blocks where they fit, equal parts of what is left of a row where they do not.
template <class RaysOfNext>
std::vector<Tile> cut(const ImageSize& image, RaysOfNext rays_of_next) {
    const int blocks_x = (image.width + BLOCK_SIDE - 1) / BLOCK_SIDE,
              blocks_y = (image.height + BLOCK_SIDE - 1) / BLOCK_SIDE;
    std::vector<Tile> tiles;
    for (int x = 0, y = 0; y < blocks_y;) {
        const int left_x = blocks_x - x, left_y = blocks_y - y;
        const auto blocks = static_cast<int>(rays_of_next(int64_t{left_y} * blocks_x - x) / BLOCK_RAYS);
        const int parts = (left_x + blocks - 1) / blocks, wide = (left_x + parts - 1) / parts,
                  high = wide == blocks_x ? std::clamp(blocks / blocks_x, 1, left_y) : 1;
        tiles.push_back({x * BLOCK_SIDE, y * BLOCK_SIDE, wide, wide * high});
        x = (x + wide) % blocks_x;
        if (x == 0) y += high;
    }
    return tiles;
}

std::vector<Tile> cut_alike(const ImageSize& image, int rays) {
    return cut(image, [=](int64_t) { return rays; });
}

/// About square ones: in the next row of blocks rays meet much of what those above them met, and find it in the core's
/// cache while rows are short. 10^6 spheres are traced in 109 ms instead of 114. Blocks are resolved two by two, so
/// that widths are even where they can be.
std::vector<Tile> cut_squares(const ImageSize& image, int rays) {
    const int blocks_x = (image.width + BLOCK_SIDE - 1) / BLOCK_SIDE,
              blocks_y = (image.height + BLOCK_SIDE - 1) / BLOCK_SIDE, blocks = rays / BLOCK_RAYS;
    const auto side = static_cast<int>(std::sqrt(blocks));
    const int widest = side > 1 ? side / 2 * 2 : 1, columns = (blocks_x + widest - 1) / widest;
    const int wide = std::min(((blocks_x + columns - 1) / columns + 1) / 2 * 2, widest), highest = blocks / wide;
    const int rows = (blocks_y + highest - 1) / highest, high = (blocks_y + rows - 1) / rows;
    std::vector<Tile> tiles;
    for (int y = 0; y < blocks_y; y += high)
        for (int x = 0; x < blocks_x; x += wide) {
            const int width = std::min(wide, blocks_x - x);
            tiles.push_back({x * BLOCK_SIDE, y * BLOCK_SIDE, width, width * std::min(high, blocks_y - y)});
        }
    return tiles;
}

/// To the end tiles become smaller, half of a worker's share of the rest, so that all workers end at about the same
/// time (guided self-scheduling, Polychronopoulos and Kuck 1987, with half the share).
std::vector<Tile> cut_for_workers(const ImageSize& image, int workers, int64_t most) {
    return cut(image, [=](int64_t blocks_left) {
        return std::clamp(blocks_left * BLOCK_RAYS / (2 * workers), std::min(least_core_tile_rays, most), most);
    });
}

/// A core's own cache holds one tile, and there is nothing else for it to do meanwhile.
Tiling for_cores(const ImageSize& image, int asked, int real_bytes, const DeviceLimits& limits) {
    const int workers = limits.sub_devices;
    return {asked > 0 ? cut_alike(image, asked) : cut_for_workers(image, workers, core_tile_rays(real_bytes, limits)),
            workers, workers};
}

/// One tile computes while another is read back.
Tiling for_whole_device(const ImageSize& image, int asked, int real_bytes, const DeviceLimits& limits) {
    const int liked = (limits.cpu ? cpu_tile_rays : gpu_tile_rays) * 4 / real_bytes;
    Tiling tiling{cut_squares(image, asked > 0 ? asked : liked), 1, 2};
    tiling.sets = std::min(tiling.sets, static_cast<int>(tiling.tiles.size()));
    return tiling;
}

}  // namespace

int Tiling::largest() const {
    int blocks = 0;
    for (const Tile& tile : tiles) blocks = std::max(blocks, tile.blocks);
    return blocks;
}

Tiling one_by_one(const ImageSize& image, int rays) { return {cut_alike(image, rays), 1, 1}; }

/// What intersect_closest hands on to the lights' launches (position, normal, id) should still be in the core's cache
/// when they read it. That of one and a half times as many rays as fit was found the fastest: fewer mean more launches.
int64_t core_tile_rays(int real_bytes, const DeviceLimits& limits) {
    const int64_t cache =
        limits.core_cache_bytes > 0 ? static_cast<int64_t>(limits.core_cache_bytes) : assumed_core_cache;
    const int64_t handed_on = (3 + 3) * real_bytes + 4;
    return std::clamp<int64_t>(cache * 3 / 2 / handed_on, usual_core_tile_rays, cpu_tile_rays);
}

Tiling for_team(const ImageSize& image, int workers, int rays) {
    return {cut_for_workers(image, workers, std::min(rays, cpu_tile_rays)), 1, 1};
}

Tiling choose_tiling(const ImageSize& image, int asked, bool even, int real_bytes, const DeviceLimits& limits) {
    check(asked);
    if (limits.cores_apart) return for_cores(image, asked, real_bytes, limits);
    if (even && limits.sub_devices > 1 && limits.sub_devices <= most_workers) {
        const Tiling shared = for_cores(image, asked, real_bytes, limits);
        if (shared.tiles.size() >= 2 * static_cast<size_t>(shared.workers)) return shared;
    }
    return for_whole_device(image, asked, real_bytes, limits);
}

}  // namespace gnomon
