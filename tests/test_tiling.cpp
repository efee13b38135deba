// Who works on which tiles: the whole device on all, or each core on its own.
#include <algorithm>

#include "catch.h"
#include "plan.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene lit(int width, int height) {
    Scene scene = looking_ahead(width, height);
    scene.spheres = {{{0, 0, 10}, 2, {1, 1, 1}}};
    scene.lights = {DirectionalLight{{0, 1, 0}, {1, 1, 1}}};
    return scene;
}

Plan plan_of(int width, int height, const DeviceLimits& limits = {}, const RenderOptions& options = {},
             int64_t spheres = 1) {
    const Scene scene = lit(width, height);
    Survey all = survey(scene);
    all.count = spheres;
    return make_plan(scene, all, options, limits);
}

}  // namespace

TEST_CASE("tiling: each core of a CPU that can be split has tiles of its own, and one set of buffers",
          "[plan][tiling]") {
    for (const int cores : {2, 4, 8}) {
        DeviceLimits limits;
        limits.sub_devices = cores;
        const Plan plan = plan_of(1920, 1080, limits);
        CHECK(plan.workers == cores);
        CHECK(plan.tile_sets == cores);
        CHECK(plan.tiles.size() >= 2 * static_cast<size_t>(cores));
    }
    CHECK(plan_of(1920, 1080, {}, {}, 256).workers == 2);
    RenderOptions certified;
    certified.accuracy = Accuracy::certified;
    CHECK(plan_of(1920, 1080, {}, certified).workers == 2);
}

TEST_CASE("tiling: the whole device works on all tiles where cores would not pay", "[plan][tiling]") {
    DeviceLimits one, many, gpu;
    one.sub_devices = 0;   // cannot be split
    many.sub_devices = 9;  // would wait for launches
    gpu.cpu = false;
    gpu.sub_devices = 0;
    for (const DeviceLimits& limits : {one, many, gpu}) {
        const Plan plan = plan_of(1920, 1080, limits);
        CHECK(plan.workers == 1);
        CHECK(plan.tile_sets == (plan.memory.by_view ? 1 : 2));
    }
    CHECK(plan_of(1920, 1080, {}, {}, 257).workers == 1);  // a hierarchy: all that is hard may lie in one tile
    const Plan small = plan_of(64, 64);
    CHECK((small.workers == 1 && small.tile_sets == 1 && small.tiles.size() == 1));
    RenderOptions large, narrow;
    large.tile = 1 << 20;  // two tiles
    CHECK(plan_of(1920, 1080, {}, large).workers == 1);
    large.tile = 1 << 17;
    CHECK(plan_of(1920, 1080, {}, large).workers == 2);
    narrow.memory = 1 << 20;
    const Plan by_view = plan_of(1920, 1080, {}, narrow, 200);
    CHECK((by_view.memory.by_view && by_view.workers == 1 && by_view.tile_sets == 1));
}

TEST_CASE("tiling: a core's tile follows its cache, and the last tiles are small", "[plan][tiling]") {
    DeviceLimits small, large, unknown;
    small.core_cache_bytes = 1 << 19;
    large.core_cache_bytes = 2 << 20;
    unknown.core_cache_bytes = 0;
    const auto largest = [](const Plan& plan) { return plan.tile_blocks * BLOCK_RAYS; };
    CHECK(largest(plan_of(1920, 1080, small)) == largest(plan_of(1920, 1080)));  // launches cost more than the cache
    CHECK(largest(plan_of(1920, 1080)) < largest(plan_of(1920, 1080, large)));
    CHECK(largest(plan_of(1920, 1080)) == largest(plan_of(1920, 1080, unknown)));
    RenderOptions doubles;
    doubles.accuracy = Accuracy::full;
    CHECK(largest(plan_of(1920, 1080, large, doubles)) < largest(plan_of(1920, 1080, large)));
    const Plan plan = plan_of(1920, 1080);
    CHECK(plan.tiles.front().blocks == plan.tile_blocks);
    CHECK(plan.tiles.back().blocks * 6 == plan.tile_blocks);
    CHECK(std::is_sorted(plan.tiles.rbegin(), plan.tiles.rend(),
                         [](const Tile& a, const Tile& b) { return a.blocks < b.blocks; }));
}

TEST_CASE("tiling: the whole device's tiles are about square, and whole pairs of blocks wide", "[plan][tiling]") {
    DeviceLimits whole;
    whole.sub_devices = 0;
    for (const int rays : {1 << 10, 1 << 14, 1 << 17})
        for (const ImageSize image : {ImageSize{1920, 1080}, ImageSize{1000, 1000}, ImageSize{8, 4096}}) {
            RenderOptions options;
            options.tile = rays;
            const Plan plan = plan_of(image.width, image.height, whole, options);
            CHECK(plan.tile_blocks * BLOCK_RAYS <= rays);
            for (const Tile& tile : plan.tiles) {
                const int high = tile.blocks / tile.blocks_x;
                CHECK((tile.blocks_x % 2 == 0 || tile.x + tile.blocks_x * BLOCK_SIDE >= image.width));
                CHECK(tile.x % (2 * BLOCK_SIDE) == 0);
                // Cutting into equal parts and making them even narrows a tile to no less than half.
                CHECK(tile.blocks_x * tile.blocks_x <= rays / BLOCK_RAYS);
                CHECK((high <= 4 * tile.blocks_x || image.width < 64 ||
                       tile.x + tile.blocks_x * BLOCK_SIDE >= image.width));
            }
        }
}

TEST_CASE("tiling: memory is planned for the tiles of all workers", "[plan][tiling][memory]") {
    DeviceLimits four, whole;
    four.sub_devices = 4;
    whole.sub_devices = 0;
    const auto tiles = [](const Plan& plan) {
        return int64_t{plan.tile_sets} * plan.tile_blocks * BLOCK_RAYS * bytes_per_ray(4, 1);  // under one light
    };
    for (const DeviceLimits& limits : {four, whole, DeviceLimits{}}) {
        const Plan plan = plan_of(1920, 1080, limits);
        CHECK(plan.memory.peak_bytes >= tiles(plan));
        CHECK(plan.memory.peak_bytes < tiles(plan) + (1 << 20));  // of spheres there is one
    }
}

TEST_CASE("tiling: what is used is said, the bits are the same, and memory is what was planned",
          "[tiling][determinism]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            DeviceInfo unsplit = device;
            unsplit.sub_devices = 0;
            Renderer cores(device), whole(unsplit);
            const Scene scene = mixed(640, 480);
            Film first, second;
            std::vector<double> shares;
            RenderOptions options = all_outputs();
            options.progress = [&](double share) { shares.push_back(share); };
            cores.render(scene, all_outputs(), first);  // how long launches take is found out
            whole.render(scene, all_outputs(), second);
            const RenderStats split = cores.render(scene, options, first), one = whole.render(scene, options, second);
            CHECK(split.workers == std::max(device.sub_devices <= 8 ? device.sub_devices : 1, 1));
            CHECK(one.workers == 1);
            CHECK(same_bits(first, second));
            CHECK(split.hits == one.hits);
            CHECK(split.rays == one.rays);
            for (const RenderStats& stats : {split, one}) {
                CHECK(stats.peak_bytes <= stats.planned_bytes);
                CHECK(stats.peak_bytes > stats.planned_bytes / 2);
                for (const KernelStats& k : stats.kernels)
                    if (k.kernel == "intersect_closest") CHECK(k.launches >= stats.tiles);  // more if one was cut
            }
            CHECK(std::count(shares.begin(), shares.end(), 1.0) == 2);  // at the end of each picture
        }
}
