// What of a scene lies on a device when: whole, or in chunks that fit.
#include "../cl/types.h"
#include "memory_plan.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

constexpr int64_t MiB = 1 << 20;

MemoryNeeds needs_of(int64_t spheres, int views = 3) {
    MemoryNeeds needs;
    needs.spheres = spheres;
    needs.views = views;
    needs.image_rays = 1920 * 1080;
    needs.tile_rays = 1 << 17;
    needs.tiles_under_way = 2;
    return needs;
}

/// What is on the device at once with chunks of so many spheres.
int64_t peak(const MemoryNeeds& needs, const MemoryPlan& plan) {
    SphereFootprint s = needs.sphere;
    s.columns = 4;
    s.has_ids = true;
    const int64_t n = plan.chunk_spheres, beside = plan.resident ? s.clusters(needs.spheres) : 0;
    return plan.tile_rays *
               (bytes_per_ray(s.real_bytes, needs.arrivals) + bytes_per_vector(s.real_bytes) + bytes_per_albedo) +
           beside + std::max(s.building(n), s.clusters(n) + s.view(n));
}

}  // namespace

TEST_CASE("memory: what fits is not cut, and every buffer counts", "[memory]") {
    const MemoryLimits limits{1024 * MiB, 512 * MiB};
    constexpr int64_t spheres = 500000;
    const MemoryNeeds needs = needs_of(spheres);
    const MemoryPlan plan = plan_memory(needs, limits);
    CHECK_FALSE(plan.cut);
    CHECK_FALSE(plan.by_view);
    CHECK(plan.chunk_spheres == needs.spheres);
    CHECK(plan.tile_rays == needs.tile_rays);
    // 28 bytes a sphere and view, nodes besides; 20 in order; 48 a ray in two tiles.
    const int64_t least = spheres * (3 * 28 + 20) + 2 * needs.tile_rays * 48;
    CHECK(plan.peak_bytes >= least);
    CHECK(plan.peak_bytes < least + spheres * 3 * 2 + MiB);
    CHECK(plan_memory(needs_of(spheres, 4), limits).peak_bytes > plan.peak_bytes + 28 * spheres);
    MemoryNeeds copied = needs;
    copied.sphere.copies_rows = true;
    CHECK(plan_memory(copied, limits).peak_bytes == plan.peak_bytes + 16 * spheres);
    copied.sphere.columns = 7;
    CHECK(plan_memory(copied, limits).peak_bytes == plan.peak_bytes + 28 * spheres);
    MemoryNeeds faces = needs;
    faces.sphere.faces = 6;
    CHECK(plan_memory(faces, limits).peak_bytes > plan.peak_bytes);
    MemoryNeeds rests = needs;
    rests.sphere.has_rests = true;
    CHECK(plan_memory(rests, limits).peak_bytes == plan.peak_bytes + 16 * spheres);
    MemoryNeeds rays = needs;
    rays.generate_rays = true;
    CHECK(plan_memory(rays, limits).peak_bytes == plan.peak_bytes + 2 * needs.tile_rays * 12);
    MemoryNeeds film = needs;
    film.film_bytes_per_ray = 12;
    film.other_bytes = 1000;
    CHECK(plan_memory(film, limits).peak_bytes == plan.peak_bytes + 2 * needs.tile_rays * 12 + 1000);
}

TEST_CASE("memory: one view at a time where that takes less", "[memory]") {
    const MemoryLimits limits{4096 * MiB, 2048 * MiB};
    const MemoryNeeds many = needs_of(10000000), lights = needs_of(1000000, 65);
    for (const MemoryNeeds& needs : {many, lights}) {
        const MemoryPlan plan = plan_memory(needs, limits);
        CHECK((plan.by_view && !plan.cut));
        CHECK(plan.tile_rays == needs.image_rays);
        const int64_t least = needs.spheres * (28 + 20) + needs.image_rays * 44;
        CHECK(plan.peak_bytes >= least);
        CHECK(plan.peak_bytes < least + needs.spheres * 2 + MiB);
    }
}

TEST_CASE("memory: small tiles do not have views made again for each", "[memory]") {
    MemoryNeeds needs = needs_of(4);
    needs.tile_rays = needs.asked_tile_rays = 1 << 14;
    CHECK_FALSE(plan_memory(needs, {4096 * MiB, 2048 * MiB}).by_view);
}

TEST_CASE("memory: what does not fit is cut into chunks that do", "[memory]") {
    for (const int64_t spheres : {int64_t{100000}, int64_t{10000000}, int64_t{2000000000}})
        for (const int64_t all : {8 * MiB, 64 * MiB, 512 * MiB, 4096 * MiB})
            for (const bool rests : {false, true}) {
                MemoryNeeds needs = needs_of(spheres);
                needs.sphere.has_rests = rests;
                needs.sphere.slices = 32;
                needs.tile_rays = 1 << 14;
                const MemoryLimits limits{all, all / 4};
                INFO(spheres << " spheres, " << all / MiB << " MiB" << (rests ? ", rests" : ""));
                const MemoryPlan plan = plan_memory(needs, limits);
                if (!plan.cut) {
                    CHECK(plan.peak_bytes <= all);
                    continue;
                }
                CHECK(plan.peak_bytes == peak(needs, plan));
                CHECK(plan.peak_bytes <= all);
                CHECK(needs.sphere.largest_buffer(plan.chunk_spheres) <= limits.one_buffer);
                CHECK(plan.tile_rays % BLOCK_RAYS == 0);
                CHECK(plan.tile_rays * bytes_per_albedo <= limits.one_buffer);
                CHECK(plan.chunk_spheres > 0);
            }
}

TEST_CASE("memory: chunks stay when there is room, and are made again when there is not", "[memory]") {
    const MemoryNeeds needs = needs_of(10000000);  // 200 MB in order
    CHECK_FALSE(plan_memory(needs, {4096 * MiB, 2048 * MiB}).cut);
    const MemoryPlan stays = plan_memory(needs, {512 * MiB, 512 * MiB}),
                     leaves = plan_memory(needs, {160 * MiB, 160 * MiB});
    CHECK((stays.cut && stays.resident));
    CHECK((leaves.cut && !leaves.resident));
    // A buffer too large is reason enough.
    const MemoryPlan one_buffer = plan_memory(needs, {4096 * MiB, 64 * MiB});
    CHECK((one_buffer.cut && one_buffer.resident));
    CHECK(one_buffer.chunk_spheres <= 64 * MiB / 28);
}

TEST_CASE("memory: where not even small chunks fit, the refusal says what would", "[memory]") {
    const std::string message = refusal(1, [] { plan_memory(needs_of(1000000), {64 * 1024, 64 * 1024}); });
    CHECK(contains(message, "MiB on the device"));
    CHECK(contains(message, "in one buffer; it may use 1 MiB"));
    CHECK(contains(message, "--memory"));
    CHECK(contains(message, "--tile"));
}

TEST_CASE("memory: few spheres and a huge image", "[memory]") {
    MemoryNeeds needs = needs_of(4);
    needs.image_rays = int64_t{1} << 30;
    CHECK_FALSE(plan_memory(needs, {64 * MiB, 64 * MiB}).cut);
    needs.tile_rays = int64_t{1} << 24;  // asked for by the user, more than there is
    needs.asked_tile_rays = needs.tile_rays;
    CHECK_THROWS_AS(plan_memory(needs, {64 * MiB, 64 * MiB}), Error);
}
