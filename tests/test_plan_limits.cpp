// Plans under a device's limits: lanes, groups, memory, and what is refused.
#include "catch.h"
#include "plan.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene lit_sphere() {
    Scene scene = looking_ahead(1024, 768);
    scene.spheres = {{{0, 0, 10}, 2, {1, 1, 1}}};
    scene.lights = {DirectionalLight{{0, 1, 0}, {1, 1, 1}}};
    return scene;
}

/// Of so many of them.
Survey spheres(int64_t count) {
    Survey result = survey(lit_sphere());
    result.count = count;
    return result;
}

int lanes_for(int native_width, bool cpu = true, int asked = 0) {
    DeviceLimits limits;
    limits.cpu = cpu;
    limits.native_width_float = native_width;
    RenderOptions options;
    options.lanes = asked;
    return make_plan(lit_sphere(), spheres(1), options, limits).lanes;
}

std::string refused(const RenderOptions& options) {
    return refusal(2, [&] { make_plan(lit_sphere(), spheres(1), options, {}); });
}

}  // namespace

TEST_CASE("a CPU gets lanes as wide as its vectors, a GPU one", "[plan]") {
    CHECK(lanes_for(32) == 16);
    CHECK(lanes_for(16) == 16);
    CHECK(lanes_for(8) == 8);
    CHECK(lanes_for(4) == 4);
    CHECK(lanes_for(2) == 4);
    CHECK(lanes_for(1) == 1);
    CHECK(lanes_for(0) == 1);
    CHECK(lanes_for(1, false) == 1);
    CHECK(lanes_for(16, false) == 1);
    for (const int asked : {1, 4, 8, 16}) {
        CHECK(lanes_for(16, true, asked) == asked);
        CHECK(lanes_for(1, false, asked) == asked);
    }
}

TEST_CASE("work-items share a block's rays evenly, and their groups fit the device", "[plan]") {
    for (const int lanes : {1, 4, 8, 16})
        for (const uint64_t most : {1, 8, 64, 4096})
            for (const bool cpu : {true, false}) {
                DeviceLimits limits;
                limits.cpu = cpu;
                limits.max_work_group = most;
                RenderOptions options;
                options.lanes = lanes;
                const Plan plan = make_plan(lit_sphere(), spheres(1), options, limits);
                CHECK((plan.local_size >= 1 && static_cast<uint64_t>(plan.local_size) <= most));
                CHECK(BLOCK_RAYS % plan.rays_per_item() == 0);
                const Tile& tile = plan.tiles.front();
                CHECK(plan.items(Kernel::intersect_closest, tile) * plan.rays_per_item() == tile.blocks * BLOCK_RAYS);
            }
}

TEST_CASE("lanes that there are not are refused", "[plan]") {
    for (const int lanes : {3, 2, -1, 5, 32}) {
        RenderOptions options;
        options.lanes = lanes;
        const std::string message = refused(options);
        CHECK(contains(message, "found " + std::to_string(lanes)));
        CHECK(contains(message, "1, 4, 8 or 16"));
    }
}

TEST_CASE("tiles that cannot be are refused", "[plan]") {
    for (const int tile : {1, 63, -1, -64, 1 << 30}) {
        RenderOptions options;
        options.tile = tile;
        const std::string message = refused(options);
        CHECK(contains(message, "--tile"));
        CHECK(contains(message, "found " + std::to_string(tile)));
    }
}

TEST_CASE("the film is written in place only where device and host share memory", "[plan]") {
    DeviceLimits limits;
    CHECK(make_plan(lit_sphere(), spheres(1), {}, limits).write_in_place);
    limits.max_alloc_bytes = 1024 * 768 * 4 - 1;  // a plane does not fit one buffer, a tile does
    CHECK_FALSE(make_plan(lit_sphere(), spheres(1), {}, limits).write_in_place);
    limits = DeviceLimits();
    limits.shares_memory = false;
    CHECK_FALSE(make_plan(lit_sphere(), spheres(1), {}, limits).write_in_place);
}

TEST_CASE("limits are those of the device", "[plan]") {
    DeviceInfo info;
    info.type = DeviceType::gpu;
    info.native_width_float = 2;
    info.max_work_group = 3;
    info.global_bytes = 4;
    info.max_alloc_bytes = 5;
    info.shares_memory = true;
    info.sub_devices = 6;
    info.core_cache_bytes = 7;
    const DeviceLimits limits(info);
    CHECK_FALSE(limits.cpu);
    CHECK(limits.native_width_float == 2);
    CHECK(limits.max_work_group == 3);
    CHECK(limits.global_bytes == 4);
    CHECK(limits.max_alloc_bytes == 5);
    CHECK(limits.shares_memory);
    CHECK(limits.sub_devices == 6);
    CHECK(limits.core_cache_bytes == 7);
    info.type = DeviceType::cpu;
    CHECK(DeviceLimits(info).cpu);
}
