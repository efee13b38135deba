#include "scheduler.h"

#include <algorithm>
#include <numeric>

namespace gnomon {

namespace {

// The host runs this many tiles ahead of the device before it waits, so that waiting costs no device time, and progress
// and memory for events stay bounded.
constexpr size_t tiles_ahead = 8;

/// The film's planes behind one output, as 32-bit values.
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

}  // namespace

Scheduler::Scheduler(const cl::Context& context, const cl::CommandQueue& queue, const DeviceMemory& memory,
                     const Plan& plan, const SceneBuffers& scene, const std::vector<TileBuffers>& tiles,
                     std::vector<cl::Kernel> kernels, Film& film)
    : context_(context), queue_(queue), plan_(plan), scene_(scene), kernels_(std::move(kernels)), film_(film) {
    for (const TileBuffers& buffers : tiles) slots_.push_back({buffers, {}, 0});
    launched_.resize(plan.tiles.size());
    measured_.launches.resize(plan.variants.size());
    measured_.seconds.resize(plan.variants.size());
    for (const Tile& tile : plan.tiles) {
        first_groups_.push_back(groups_);
        groups_ += static_cast<int>(groups(Kernel::intersect_closest, tile));
    }
    hit_counts_ = memory.room<int>(groups_);
    if (!plan.write_in_place) return;
    for (const Step& step : plan.steps)
        if (step.kernel == Kernel::resolve)
            for (const auto& [data, bytes] : planes_of(film, step.output))
                planes_[static_cast<size_t>(step.output)].emplace_back(context, CL_MEM_WRITE_ONLY | CL_MEM_USE_HOST_PTR,
                                                                       bytes, data);
}

Measured Scheduler::run(const std::function<void(double)>& progress) {
    // Commands under way write into the film and the counts: never leave before they have ended.
    struct Finish {
        cl::CommandQueue& queue;
        ~Finish() { clFinish(queue()); }
    } finish{queue_};
    const size_t count = plan_.tiles.size();
    cl::Event cleared;
    queue_.enqueueFillBuffer(hit_counts_, 0, 0, static_cast<size_t>(groups_) * sizeof(int), nullptr, &cleared);
    for (Slot& slot : slots_) slot.busy = {cleared};
    for (size_t tile = 0; tile < count + tiles_ahead; ++tile) {
        if (tile < count) enqueue(tile);
        if (tile < tiles_ahead || tile - tiles_ahead >= count) continue;
        collect(tile - tiles_ahead);
        if (progress) progress(static_cast<double>(tile - tiles_ahead + 1) / static_cast<double>(count));
    }
    if (plan_.write_in_place) map_film();
    queue_.finish();
    std::vector<int> hits(static_cast<size_t>(groups_));
    queue_.enqueueReadBuffer(hit_counts_, CL_TRUE, 0, hits.size() * sizeof(int), hits.data());
    measured_.hits = std::accumulate(hits.begin(), hits.end(), int64_t{0});
    return measured_;
}

void Scheduler::enqueue(size_t index) {
    const Tile& tile = plan_.tiles[index];
    Slot& slot = slots_[index % slots_.size()];
    slot.first_group = first_groups_[index];
    for (const Step& step : plan_.steps) {
        launch(step, tile, slot);
        launched_[index].push_back({step.variant, slot.busy.front()});
        if (step.kernel == Kernel::resolve && !plan_.write_in_place) read_planes(step.output, tile, slot);
    }
    queue_.flush();
}

size_t Scheduler::groups(Kernel kernel, const Tile& tile) const {
    return static_cast<size_t>((plan_.items(kernel, tile) + plan_.local_size - 1) / plan_.local_size);
}

void Scheduler::launch(const Step& step, const Tile& tile, Slot& slot) {
    cl::Kernel& kernel = kernels_[static_cast<size_t>(step.variant)];
    bind(kernel, step, tile, slot);
    const size_t local = static_cast<size_t>(plan_.local_size), global = groups(step.kernel, tile) * local;
    cl::Event done;
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, global, local, &slot.busy, &done);
    slot.busy = {done};
}

void Scheduler::bind(cl::Kernel& kernel, const Step& step, const Tile& tile, const Slot& slot) {
    const TileBuffers& b = slot.buffers;
    const int items = plan_.items(step.kernel, tile);
    switch (step.kernel) {
        case Kernel::generate_rays:
            return set_arguments(kernel, scene_.eye, tile, items, b.dirs);
        case Kernel::intersect_closest:
            return set_arguments(kernel, b.dirs, scene_.eye_basis, scene_.spheres.clusters, scene_.spheres.nodes,
                                 scene_.spheres.levels, scene_.spheres.last, items, b.ts, b.normals, b.ids,
                                 slot.first_group, hit_counts_);
        case Kernel::intersect_shadow:
        case Kernel::shade_light:
            return bind_light(kernel, step, slot, items);
        case Kernel::resolve:
            return bind_resolve(kernel, step, tile, slot);
        default:  // the kernels before the tiles are no steps
            break;
    }
}

void Scheduler::bind_light(cl::Kernel& kernel, const Step& step, const Slot& slot, int items) {
    const TileBuffers& b = slot.buffers;
    const LightBuffers& light = scene_.lights[static_cast<size_t>(step.light)];
    const SphereBuffers& s = light.spheres;
    const int first = step.first ? 1 : 0;
    const auto with = [&](const auto& pencil) {
        if (step.kernel == Kernel::intersect_shadow)
            set_arguments(kernel, b.dirs, b.ts, b.normals, b.ids, s.clusters, s.nodes, s.levels, s.last,
                          plan_.group_depth, pencil, items, b.arrival);
        else
            set_arguments(kernel, b.dirs, b.ts, b.normals, b.ids, b.arrival, s.clusters, s.nodes, s.levels, s.last,
                          plan_.group_depth, scene_.albedos.values, scene_.albedos.first, scene_.albedos.stride, pencil,
                          light.phi, first, items, b.radiance);
    };
    std::visit(with, light.pencil);
}

void Scheduler::bind_resolve(cl::Kernel& kernel, const Step& step, const Tile& tile, const Slot& slot) {
    const TileBuffers& b = slot.buffers;
    const cl::Buffer* const sources[] = {&b.radiance, &b.ts, &b.normals, &b.ids};
    const bool in_place = plan_.write_in_place;
    const auto output = static_cast<size_t>(step.output);
    const int components = step.output == Output::radiance || step.output == Output::normal ? 3 : 1;
    const auto plane = [&](size_t c) -> const cl::Buffer& {
        return in_place ? planes_[output][std::min(c, planes_[output].size() - 1)] : b.planes[c];
    };
    set_arguments(kernel, *sources[output], components, tile, film_.width, film_.height, in_place ? 0 : tile.x,
                  in_place ? 0 : tile.y, in_place ? film_.width : tile.blocks_x * BLOCK_SIDE,
                  plan_.items(step.kernel, tile), plane(0), plane(1), plane(2));
}

void Scheduler::read_planes(Output output, const Tile& tile, Slot& slot) {
    const auto x = static_cast<size_t>(tile.x), y = static_cast<size_t>(tile.y), value = sizeof(float);
    const auto tile_width = static_cast<size_t>(tile.blocks_x) * BLOCK_SIDE, width = static_cast<size_t>(film_.width);
    const auto tile_height = static_cast<size_t>(tile.blocks / tile.blocks_x) * BLOCK_SIDE;
    const std::array<size_t, 3> region{std::min(tile_width, width - x) * value,
                                       std::min(tile_height, static_cast<size_t>(film_.height) - y), 1};
    const std::vector<cl::Event> resolved = slot.busy;
    size_t c = 0;
    for (const auto& [data, bytes] : planes_of(film_, output)) {
        cl::Event done;
        queue_.enqueueReadBufferRect(slot.buffers.planes[c++], CL_FALSE, {0, 0, 0}, {x * value, y, 0}, region,
                                     tile_width * value, 0, width * value, 0, data, &resolved, &done);
        slot.busy.push_back(done);
    }
}

/// Waits for a tile and adds up what its launches took.
void Scheduler::collect(size_t tile) {
    launched_[tile].back().event.wait();
    for (const Launched& l : launched_[tile]) {
        measured_.launches[static_cast<size_t>(l.variant)] += 1;
        measured_.seconds[static_cast<size_t>(l.variant)] += seconds_of(l.event);
    }
    launched_[tile].clear();
}

/// A buffer over host memory shows its values there once it is mapped (OpenCL 1.2, 5.2.1); on a device that shares the
/// memory that copies nothing.
void Scheduler::map_film() {
    queue_.finish();
    for (const auto& planes : planes_)
        for (const cl::Buffer& plane : planes) {
            const size_t bytes = plane.getInfo<CL_MEM_SIZE>();
            queue_.enqueueUnmapMemObject(plane, queue_.enqueueMapBuffer(plane, CL_TRUE, CL_MAP_READ, 0, bytes));
        }
}

}  // namespace gnomon
