#include "scheduler.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dealer.h"

namespace gnomon {

namespace {

// The host runs this many tiles ahead of the device before it waits: each time it wakes it takes a core from a device
// that is the CPU. Memory for events stays bounded.
constexpr size_t tiles_ahead = 256;

int blocks_of(const Plan& plan) {
    int blocks = 0;
    for (const Tile& tile : plan.tiles) blocks += tile.blocks;
    return blocks;
}

bool meets_spheres(Kernel kernel, const Plan& plan) {
    return kernel == Kernel::intersect_closest || kernel == Kernel::intersect_shadow ||
           (kernel == Kernel::shade_light && plan.shadows == Shadows::traced);
}

}  // namespace

Scheduler::Scheduler(const Workers& workers, const DeviceMemory& memory, const Plan& plan, const SceneBuffers& scene,
                     const std::vector<TileBuffers>& tiles, std::vector<cl::Kernel> kernels, Film& film)
    : queue_(workers.whole()),
      workers_(workers.queues(plan.workers)),
      plan_(plan),
      scene_(scene),
      kernels_(std::move(kernels)),
      film_(film),
      undecided_(memory, plan.certified ? blocks_of(plan) : 1) {
    for (const TileBuffers& buffers : tiles)
        slots_.push_back({workers_[slots_.size() % workers_.size()], buffers, {}, 0, 0});
    launched_.resize(plan.tiles.size());
    measured_.launches.resize(plan.variants.size());
    measured_.seconds.resize(plan.variants.size());
    int blocks = 0;
    for (const Tile& tile : plan.tiles) {
        first_blocks_.push_back(blocks);
        blocks += tile.blocks;
        first_groups_.push_back(groups_);
        groups_ += static_cast<int>(groups(Kernel::intersect_closest, tile));
    }
    hit_counts_ = memory.room<int>(groups_);
    binder_.emplace(workers.context(), plan, scene, film, hit_counts_, undecided_);
}

Measured Scheduler::run(const std::vector<cl::Event>& after, const std::function<void(double)>& progress) {
    std::vector<int> hits(static_cast<size_t>(groups_));
    std::vector<uint32_t> undecided;
    // Commands under way write into the film and the counts: never leave before they have ended.
    struct Finish {
        Scheduler& scheduler;
        ~Finish() {
            for (const cl::CommandQueue& queue : scheduler.workers_) clFinish(queue());
            clFinish(scheduler.queue_());
        }
    } finish{*this};
    std::vector<cl::Event> ready = after;
    queue_.enqueueFillBuffer(hit_counts_, 0, 0, static_cast<size_t>(groups_) * sizeof(int), nullptr,
                             &ready.emplace_back());
    if (plan_.certified) undecided_.clear(queue_, &ready.emplace_back());
    queue_.flush();  // or other queues might wait for it forever (OpenCL 1.2, 5.13)
    for (Slot& slot : slots_) slot.busy = ready;
    if (plan_.workers > 1)
        deal_to_cores(progress);
    else
        run_ahead(progress);
    queue_.enqueueReadBuffer(hit_counts_, CL_FALSE, 0, hits.size() * sizeof(int), hits.data());
    if (plan_.certified) undecided_.read(queue_, undecided);
    if (plan_.write_in_place) map_film();
    queue_.finish();
    measured_.undecided = undecided_pixels(undecided, plan_.tiles, plan_.image);
    measured_.hits = std::accumulate(hits.begin(), hits.end(), int64_t{0});
    return measured_;
}

/// All cores share each launch. The host is ahead of them.
void Scheduler::run_ahead(const std::function<void(double)>& progress) {
    const size_t count = plan_.tiles.size();
    for (size_t tile = 0; tile < count; ++tile) {
        enqueue(tile, slots_[tile % slots_.size()]);
        if (tile >= tiles_ahead) await(tile - tiles_ahead, progress);
    }
    if (progress)
        for (size_t tile = count - std::min(count, tiles_ahead); tile < count; ++tile) await(tile, progress);
    queue_.finish();
    for (size_t tile = 0; tile < count; ++tile) collect(tile);
}

/// Each core works on a tile of its own, and takes the next one itself.
void Scheduler::deal_to_cores(const std::function<void(double)>& progress) {
    Deal tiles{plan_.tiles.size(), workers_.size(), {}, [this](size_t tile) { collect(tile); }, progress};
    tiles.launch = [this](size_t tile, size_t worker) {
        Slot& slot = slots_[worker];
        enqueue(tile, slot);
        return slot.busy.back();
    };
    deal(tiles);
}

void Scheduler::await(size_t tile, const std::function<void(double)>& progress) {
    launched_[tile].back().event.wait();
    collect(tile);
    if (progress) progress(static_cast<double>(tile + 1) / static_cast<double>(plan_.tiles.size()));
}

void Scheduler::enqueue(size_t index, Slot& slot) {
    const Tile& tile = plan_.tiles[index];
    slot.first_group = first_groups_[index];
    slot.first_block = first_blocks_[index];
    for (const Step& step : plan_.steps) {
        if (chunks_ && meets_spheres(step.kernel, plan_))
            launch_chunks(index, step, slot);
        else
            launch(index, {step, tile, slot.buffers, slot.first_group, slot.first_block, &resident_spheres(step)},
                   slot);
        if (step.kernel == Kernel::resolve && !plan_.write_in_place) read_planes(step.output, tile, slot);
    }
    slot.queue.flush();
}

const SphereBuffers& Scheduler::resident_spheres(const Step& step) const {
    return step.light < 0 ? scene_.spheres : scene_.lights[static_cast<size_t>(step.light)].spheres;
}

/// One launch for each chunk; of these only one is on the device at a time.
void Scheduler::launch_chunks(size_t index, const Step& step, Slot& slot) {
    for (int chunk = 0; chunk < chunks_->chunks(); ++chunk) {
        queue_.finish();
        const SphereBuffers spheres = chunks_->seen(step.light, chunk);
        launch(index,
               {step, plan_.tiles[index], slot.buffers, slot.first_group, slot.first_block, &spheres, chunk == 0},
               slot);
        queue_.finish();
    }
    if (step.kernel == Kernel::intersect_closest && plan_.albedos_of_rays) look_up_albedos(plan_.tiles[index], slot);
}

void Scheduler::look_up_albedos(const Tile& tile, Slot& slot) {
    std::vector<int> ids(static_cast<size_t>(tile.blocks) * BLOCK_RAYS);
    queue_.enqueueReadBuffer(slot.buffers.ids, CL_TRUE, 0, ids.size() * sizeof(int), ids.data());
    const std::vector<float> albedos = chunks_->albedos_of(ids);
    queue_.enqueueWriteBuffer(slot.buffers.albedos, CL_TRUE, 0, albedos.size() * sizeof(float), albedos.data());
}

size_t Scheduler::groups(Kernel kernel, const Tile& tile) const {
    return static_cast<size_t>((plan_.items(kernel, tile) + plan_.local_size - 1) / plan_.local_size);
}

void Scheduler::launch(size_t index, const TileLaunch& what, Slot& slot) {
    const int variant = what.step.variant;
    cl::Kernel& kernel = kernels_[static_cast<size_t>(variant)];
    binder_->bind(kernel, what);
    const size_t local = static_cast<size_t>(plan_.local_size), global = groups(what.step.kernel, what.tile) * local;
    cl::Event done;
    slot.queue.enqueueNDRangeKernel(kernel, cl::NullRange, global, local, &slot.busy, &done);
    slot.busy = {done};
    launched_[index].push_back({variant, done});
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
        slot.queue.enqueueReadBufferRect(slot.buffers.planes[c++], CL_FALSE, {0, 0, 0}, {x * value, y, 0}, region,
                                         tile_width * value, 0, width * value, 0, data, &resolved, &done);
        slot.busy.push_back(done);
    }
    cl::Event all;
    slot.queue.enqueueMarkerWithWaitList(&slot.busy, &all);
    slot.busy = {all};
}

/// Adds up what the launches of a tile took that has ended.
void Scheduler::collect(size_t tile) {
    for (const Launched& l : launched_[tile]) {
        measured_.launches[static_cast<size_t>(l.variant)] += 1;
        measured_.seconds[static_cast<size_t>(l.variant)] += seconds_of(l.event);
    }
    launched_[tile].clear();
}

/// A buffer over host memory shows its values there once it is mapped (OpenCL 1.2, 5.2.1); on a device that shares the
/// memory that copies nothing.
void Scheduler::map_film() {
    std::vector<std::pair<cl::Buffer, void*>> mapped;
    for (const Output output : {Output::radiance, Output::distance, Output::normal, Output::id})
        for (const cl::Buffer& plane : binder_->planes(output)) {
            const size_t bytes = plane.getInfo<CL_MEM_SIZE>();
            mapped.emplace_back(plane, queue_.enqueueMapBuffer(plane, CL_FALSE, CL_MAP_READ, 0, bytes));
        }
    queue_.finish();
    for (const auto& [plane, at] : mapped) queue_.enqueueUnmapMemObject(plane, at);
}

}  // namespace gnomon
