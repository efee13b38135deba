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
    CHECK(lanes_for(1) == 4);
    CHECK(lanes_for(0) == 4);
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

TEST_CASE("what does not fit the device is refused before it is tried, with sizes", "[plan]") {
    // Centre and radius alone are 16 bytes a sphere.
    const auto too_many = [](uint64_t bytes) { return static_cast<int64_t>(bytes / 16 + 1); };
    DeviceLimits limits;
    limits.max_alloc_bytes = uint64_t{16} << 20;
    const auto try_spheres = [&](int64_t distinct) { make_plan(lit_sphere(), spheres(distinct), {}, limits); };
    CHECK_NOTHROW(try_spheres(1000));
    const std::string one_buffer = refusal(1, [&] { try_spheres(too_many(limits.max_alloc_bytes)); });
    CHECK(contains(one_buffer, " MiB of it in one buffer"));
    CHECK(contains(one_buffer, "the device offers "));
    CHECK(contains(one_buffer, "a smaller --tile"));
    limits.max_alloc_bytes = limits.global_bytes;
    const std::string all = refusal(1, [&] { try_spheres(too_many(limits.global_bytes / 2)); });  // for eye and light
    CHECK(contains(all, " MiB on the device"));
    CHECK(contains(all, "more memory"));
    limits = DeviceLimits();
    limits.max_alloc_bytes = 1 << 20;
    RenderOptions options;
    options.tile = 1 << 20;
    CHECK(contains(refusal(1, [&] { make_plan(lit_sphere(), spheres(1), options, limits); }),
                   " MiB of it in one buffer"));
    options.tile = 1 << 10;
    CHECK_NOTHROW(make_plan(lit_sphere(), spheres(1), options, limits));
}

TEST_CASE("every buffer counts in what a plan needs", "[plan]") {
    const auto bytes = [](int64_t distinct, const RenderOptions& options) {
        return make_plan(lit_sphere(), spheres(distinct), options, {}).device_bytes;
    };
    RenderOptions shadowed, open;
    open.shadows = false;
    const uint64_t seen_by_eye = bytes(3200, open) - bytes(1600, open);
    CHECK(seen_by_eye >= 1600 * 16);
    CHECK(bytes(3200, shadowed) - bytes(1600, shadowed) > seen_by_eye + 1600 * 16);  // and by the light
    open.tile = 64;
    const uint64_t small = bytes(1, open);
    open.tile = 128;
    CHECK(bytes(1, open) - small == 64 * bytes_per_ray * tile_sets);
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
    const DeviceLimits limits(info);
    CHECK_FALSE(limits.cpu);
    CHECK(limits.native_width_float == 2);
    CHECK(limits.max_work_group == 3);
    CHECK(limits.global_bytes == 4);
    CHECK(limits.max_alloc_bytes == 5);
    CHECK(limits.shares_memory);
    info.type = DeviceType::cpu;
    CHECK(DeviceLimits(info).cpu);
}
