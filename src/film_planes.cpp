#include "film_planes.h"

#include <algorithm>
#include <array>

namespace gnomon {

std::vector<std::pair<void*, size_t>> planes_of(Film& film, Output output) {
    std::vector<std::pair<void*, size_t>> planes;
    const auto add = [&](auto& plane) { planes.emplace_back(plane.data(), plane.bytes()); };
    switch (output) {
        case Output::radiance:
            std::for_each(std::begin(film.radiance), std::end(film.radiance), add);
            break;
        case Output::distance:
            add(film.distance);
            break;
        case Output::normal:
            std::for_each(std::begin(film.normal), std::end(film.normal), add);
            break;
        case Output::id:
            add(film.id);
            break;
    }
    return planes;
}

void read_tile(const cl::CommandQueue& queue, const cl::Buffer* planes, Output output, const Tile& tile, Film& film,
               std::vector<cl::Event>& busy) {
    const auto x = static_cast<size_t>(tile.x), y = static_cast<size_t>(tile.y), value = sizeof(float);
    const auto tile_width = static_cast<size_t>(tile.blocks_x) * BLOCK_SIDE, width = static_cast<size_t>(film.width);
    const auto tile_height = static_cast<size_t>(tile.blocks / tile.blocks_x) * BLOCK_SIDE;
    const std::array<size_t, 3> region{std::min(tile_width, width - x) * value,
                                       std::min(tile_height, static_cast<size_t>(film.height) - y), 1};
    const std::vector<cl::Event> resolved = busy;
    for (const auto& [data, bytes] : planes_of(film, output))
        queue.enqueueReadBufferRect(*planes++, CL_FALSE, {0, 0, 0}, {x * value, y, 0}, region, tile_width * value, 0,
                                    width * value, 0, data, &resolved, &busy.emplace_back());
    cl::Event all;
    queue.enqueueMarkerWithWaitList(&busy, &all);
    busy = {all};
}

/// A buffer over host memory shows its values there once it is mapped (OpenCL 1.2, 5.2.1); on a device that shares the
/// memory that copies nothing.
void map_planes(const cl::CommandQueue& queue, const std::vector<cl::Buffer>& planes) {
    std::vector<void*> mapped;
    for (const cl::Buffer& plane : planes)
        mapped.push_back(queue.enqueueMapBuffer(plane, CL_FALSE, CL_MAP_READ, 0, plane.getInfo<CL_MEM_SIZE>()));
    queue.finish();
    for (size_t i = 0; i < planes.size(); ++i) queue.enqueueUnmapMemObject(planes[i], mapped[i]);
}

}  // namespace gnomon
