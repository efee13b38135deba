#include "memory_plan.h"

#include <algorithm>
#include <string>

#include "../cl/types.h"
#include "error.h"

namespace gnomon {

namespace {

constexpr int64_t max_tile_rays = int64_t{1} << 24;
/// Fewer spheres to a chunk would be launched for longer than they are traced.
constexpr int64_t least_chunk = 4096;
/// Where so many chunks would be needed for all to stay, they are rather made again.
constexpr int64_t most_resident_chunks = 64;
/// The largest number up to `high` that is allowed; `allowed` holds for all smaller ones.
template <class Allowed>
int64_t largest(int64_t high, Allowed allowed) {
    int64_t low = 0;
    while (low < high) {
        const int64_t middle = low + (high - low + 1) / 2;
        (allowed(middle) ? low : high) = allowed(middle) ? middle : middle - 1;
    }
    return low;
}

/// Of all its buffers, without an albedo, and of the largest.
int64_t bytes_per_whole_ray(const MemoryNeeds& n) {
    const int64_t direction = n.generate_rays ? bytes_per_vector(n.sphere.real_bytes) : 0;
    return bytes_per_ray(n.sphere.real_bytes, n.arrivals) + direction + n.film_bytes_per_ray;
}
int64_t bytes_per_position(const MemoryNeeds& n) { return bytes_per_vector(n.sphere.real_bytes); }

std::string mebibytes(int64_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB"; }

/// With all pencils' views.
int64_t whole_peak(const MemoryNeeds& n) {
    const SphereFootprint& s = n.sphere;
    return n.other_bytes + n.tiles_under_way * n.tile_rays * bytes_per_whole_ray(n) +
           std::max(s.building(n.spheres), s.rows(n.spheres) + s.clusters(n.spheres) + n.views * s.view(n.spheres));
}

/// With one at a time.
int64_t one_view_peak(const MemoryNeeds& n, int64_t tile_rays) {
    const SphereFootprint& s = n.sphere;
    return n.other_bytes + tile_rays * bytes_per_whole_ray(n) +
           std::max(s.building(n.spheres), s.rows(n.spheres) + s.clusters(n.spheres) + s.view(n.spheres));
}

int64_t bytes_per_cut_ray(MemoryNeeds n) {
    n.generate_rays = true;
    return bytes_per_whole_ray(n) + bytes_per_albedo;
}

/// Rays that stay on the device while the chunks go by.
int64_t tile_beside_chunks(const MemoryNeeds& n, const MemoryLimits& limits) {
    const int64_t ray = bytes_per_cut_ray(n);
    const int64_t wanted = n.asked_tile_rays > 0 ? n.asked_tile_rays : limits.all / 4 / ray;
    const int64_t most = std::min({wanted, n.image_rays, max_tile_rays, limits.one_buffer / bytes_per_position(n)});
    return std::max<int64_t>(most / BLOCK_RAYS, 1) * BLOCK_RAYS;
}

[[noreturn]] void refuse(const MemoryNeeds& n, const MemoryLimits& limits, int64_t tile_rays) {
    const SphereFootprint& s = n.sphere;
    const int64_t least = n.other_bytes + tile_rays * bytes_per_cut_ray(n) +
                          std::max(s.building(least_chunk), s.clusters(least_chunk) + s.view(least_chunk));
    throw Error(Blame::run,
                "the scene needs at least " + mebibytes(least) + " on the device, and " +
                    mebibytes(std::max(s.largest_buffer(least_chunk), tile_rays * bytes_per_position(n))) +
                    " in one buffer; it may use " + mebibytes(limits.all) + ", " + mebibytes(limits.one_buffer) +
                    " in one buffer",
                "", "allow more memory (--memory), use a device with more, or a smaller --tile");
}

}  // namespace

MemoryPlan plan_memory(const MemoryNeeds& n, const MemoryLimits& limits) {
    const SphereFootprint& s = n.sphere;
    const bool one_buffer_holds =
        s.largest_buffer(n.spheres) <= limits.one_buffer && n.tile_rays * bytes_per_position(n) <= limits.one_buffer;
    const int64_t tile_rays = tile_beside_chunks(n, limits);
    const int64_t whole = whole_peak(n), one_view = one_view_peak(n, tile_rays);
    if (one_buffer_holds && std::min(whole, one_view) <= limits.all) {
        // Smaller tiles would have every pencil's view made again for each.
        const bool views_made_once = tile_rays >= n.image_rays;
        if (whole <= limits.all && (n.all_views || whole <= one_view || !views_made_once))
            return {false, false, n.spheres, true, n.tile_rays, whole};
        return {true, false, n.spheres, true, tile_rays, one_view};
    }
    SphereFootprint chunk = s;
    chunk.columns = 4;
    chunk.has_ids = true;
    const int64_t rest = limits.all - n.other_bytes - tile_rays * bytes_per_cut_ray(n);
    // Rows that the device reads in the host's memory take memory all the same.
    const auto fits = [&](int64_t spheres, int64_t beside) {
        SphereFootprint counted = chunk;
        counted.copies_rows = true;
        return counted.largest_buffer(spheres) <= limits.one_buffer &&
               beside + std::max(counted.building(spheres), counted.clusters(spheres) + counted.view(spheres)) <= rest;
    };
    const int64_t all_clusters = s.clusters(n.spheres);
    const int64_t beside_all = largest(n.spheres, [&](int64_t k) { return fits(k, all_clusters); });
    const bool resident = beside_all * most_resident_chunks >= n.spheres && beside_all >= least_chunk;
    const int64_t size = resident ? beside_all : largest(n.spheres, [&](int64_t k) { return fits(k, 0); });
    if (size < std::min(least_chunk, n.spheres)) refuse(n, limits, tile_rays);
    const int64_t peak = n.other_bytes + tile_rays * bytes_per_cut_ray(n) + (resident ? all_clusters : 0) +
                         std::max(chunk.building(size), chunk.clusters(size) + chunk.view(size));
    return {true, true, size, resident, tile_rays, peak};
}

}  // namespace gnomon
