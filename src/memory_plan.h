// How a scene and the rays under way share a device's memory.
#pragma once

#include <cstdint>

#include "footprint.h"

namespace gnomon {

/// Bytes that a device offers.
struct MemoryLimits {
    int64_t all = 0, one_buffer = 0;
};

struct MemoryNeeds {
    SphereFootprint sphere;
    int64_t spheres = 0;
    int views = 1;                ///< pencils
    int64_t image_rays = 0;       ///< in whole blocks
    int64_t tile_rays = 0;        ///< of the largest tile, while the scene is not cut
    int64_t asked_tile_rays = 0;  ///< 0: as many as fit
    int64_t tiles_under_way = 1;
    bool all_views = false;          ///< are needed at once, if they fit
    int64_t arrivals = 0;            ///< of so many lights what arrives is kept
    bool generate_rays = false;      ///< in a launch of its own, as always beside chunks
    int64_t film_bytes_per_ray = 0;  ///< of a tile, where the film is read back from the device
    int64_t other_bytes = 0;         ///< whatever else there is
};

/// Either the scene lies on the device as all pencils see it, and small tiles go through one after the other; or one
/// pencil sees it at a time (by_view), and a tile, as large as can be, stays for all of them: that takes less memory
/// when spheres are many more than rays, or pencils are many. Where the scene does not fit it is cut into chunks
/// besides, and one of them is seen by one pencil at a time.
struct MemoryPlan {
    bool by_view = false, cut = false;
    int64_t chunk_spheres = 0;  ///< the most in a chunk
    bool resident = true;       ///< chunks stay in order; else they are put in order again for each pencil
    int64_t tile_rays = 0;
    int64_t peak_bytes = 0;  ///< of the device
};

/// Bytes of one ray in a tile's buffers: position, normal and radiance 3 reals each, t 1, and 1 for each light of which
/// what arrives is kept; id 4. Besides, 3 reals for its direction if a launch of its own makes the rays, and 12 for the
/// albedo if the scene is cut.
constexpr int64_t bytes_per_ray(int64_t real_bytes, int64_t arrivals) {
    return (3 + 3 + 3 + 1 + arrivals) * real_bytes + 4;
}
constexpr int64_t bytes_per_vector(int64_t real_bytes) { return 3 * real_bytes; }
constexpr int64_t bytes_per_albedo = 12;

/// Throws Error(Blame::run) when not even small chunks fit.
MemoryPlan plan_memory(const MemoryNeeds& needs, const MemoryLimits& limits);

}  // namespace gnomon
