#include "scheduler.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dealer.h"
#include "film_planes.h"

namespace gnomon {

namespace {

/// Beside most chunks rays pass, and through few of them most of what they meet: of 10^8 spheres one launch over all
/// rays takes 0.2 s where the last took 0.01, one over a part of them 0.02.
constexpr int parts_beside_chunks = 64;

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

bool deals_tiles(const Plan& plan) {
    const bool is_shared_cpu = plan.shares_tiles && plan.stream && plan.flat() && !plan.memory.by_view;
    return plan.workers > 1 || is_shared_cpu;
}

Measured::Share Measured::all_shares() const {
    Share all;
    for (const Share& share : shares) {
        all.tiles += share.tiles;
        all.pixels += share.pixels;
        all.hits += share.hits;
    }
    return all;
}

Scheduler::Scheduler(const Workers& workers, const DeviceMemory& memory, const Plan& plan, const SceneBuffers& scene,
                     const std::vector<TileBuffers>& tiles, std::vector<cl::Kernel> kernels, Pace& pace,
                     const Stop* stop, Film& film)
    : queue_(workers.whole()),
      workers_(workers.queues(plan.workers)),
      plan_(plan),
      scene_(scene),
      kernels_(std::move(kernels)),
      pace_(pace),
      units_(workers.units(plan.workers)),
      film_(film),
      undecided_(memory, plan, blocks_of(plan)) {
    for (const TileBuffers& buffers : tiles) {
        const size_t worker = slots_.size() % workers_.size();
        slots_.push_back({worker, workers_[worker], buffers, {}, 0, plan.steps.size(), 0});
    }
    for (const Variant& variant : plan.variants) paces_.push_back(&pace.of(variant.name()));
    for (size_t i = 0; i < workers_.size(); ++i)
        launches_.emplace_back(pace, stop,
                               [this](int tag, int64_t items, double seconds) { ended(tag, items, seconds); });
    measured_.launches.resize(plan.variants.size());
    measured_.seconds.resize(plan.variants.size());
    measured_.longest.resize(plan.variants.size());
    measured_.shares.resize(workers_.size());
    workers_of_tiles_.resize(plan.tiles.size());
    int blocks = 0;
    for (const Tile& tile : plan.tiles) {
        first_blocks_.push_back(blocks);
        blocks += tile.blocks;
        last_items_ += plan.items(plan.steps.back().kernel, tile);
    }
    hit_counts_ = memory.room<int>(blocks);
    binder_.emplace(workers.context(), plan, scene, film, hit_counts_, undecided_);
}

Measured Scheduler::run(TileQueue& tiles, const std::vector<cl::Event>& after,
                        const std::function<void(double)>& progress) {
    tiles_ = &tiles;
    std::vector<int> hits(static_cast<size_t>(blocks_of(plan_)));
    // Commands under way write into the film and the counts: never leave before they have ended.
    struct Finish {
        Scheduler& scheduler;
        ~Finish() {
            for (const cl::CommandQueue& queue : scheduler.workers_) clFinish(queue());
            clFinish(scheduler.queue_());
        }
    } finish{*this};
    std::vector<cl::Event> ready = after;
    if (plan_.adds_to_blocks())
        queue_.enqueueFillBuffer(hit_counts_, 0, 0, hits.size() * sizeof(int), nullptr, &ready.emplace_back());
    if (plan_.certified) undecided_.clear(queue_, ready);
    queue_.flush();  // or other queues might wait for it forever (OpenCL 1.2, 5.13)
    for (Slot& slot : slots_) slot.busy = ready;
    if (deals_tiles(plan_))
        deal_to_workers(progress);
    else
        run_ahead(progress);
    queue_.enqueueReadBuffer(hit_counts_, CL_FALSE, 0, hits.size() * sizeof(int), hits.data());
    if (plan_.write_in_place)
        map_planes(queue_, binder_->planes());
    else
        queue_.finish();
    count_hits(hits);
    if (plan_.certified)
        measured_.undecided = pixels_of(undecided_.read(queue_, {}, blocks_of(plan_)), plan_.tiles, plan_.image);
    queue_.finish();
    return measured_;
}

/// All cores share each launch. The host is ahead of them: each time it wakes up it takes a core from a device that is
/// the CPU.
void Scheduler::run_ahead(const std::function<void(double)>& progress) {
    if (progress) tell_ = &progress;
    for (size_t i = 0;; i = (i + 1) % slots_.size()) {
        if (plan_.shares_tiles) await_room();
        if (!take_tile(slots_[i])) break;
        for (const Step& step : plan_.steps) launch_step(slots_[i], step);
        slots_[i].queue.flush();
    }
    if (progress) launches_.front().await_all();
    queue_.finish();
    launches_.front().measure_all();
}

/// Each core works on a tile of its own, and takes the next one itself. It does so where the driver calls back, and
/// must not wait there.
void Scheduler::deal_to_workers(const std::function<void(double)>& progress) {
    for (const Step& step : plan_.steps)
        if (!paces_[static_cast<size_t>(step.variant)]->is_loaded())
            launches_.front().load(slots_.front().queue, work(slots_.front(), step));
    Deal turns{workers_.size(), {}, {}, progress};
    turns.launch = [this](size_t worker) { return launch_turn(worker); };
    turns.ended = [this](size_t worker) {
        launches_[worker].measure_all();
        return share_;
    };
    deal(turns);
}

/// What is taken too early another device cannot take.
void Scheduler::await_room() {
    while (!due_.empty() && done_items_ >= due_.front()) due_.pop_front();
    while (due_.size() >= slots_.size()) {
        launches_.front().await_oldest();
        while (!due_.empty() && done_items_ >= due_.front()) due_.pop_front();
    }
}

bool Scheduler::take_tile(Slot& slot) {
    const std::optional<size_t> next = tiles_->take();
    if (!next) return false;
    slot.tile = *next;
    workers_of_tiles_[slot.tile] = slot.worker;
    slot.step = 0;
    slot.item = 0;
    const Tile& tile = tile_of(slot);
    taken_items_ += plan_.items(plan_.steps.back().kernel, tile);
    due_.push_back(taken_items_);
    const auto inside = [](int from, int blocks, int size) { return std::min(blocks * BLOCK_SIDE, size - from); };
    Measured::Share& share = measured_.shares[slot.worker];
    share.tiles += 1;
    share.pixels += int64_t{inside(tile.x, tile.blocks_x, plan_.image.width)} *
                    inside(tile.y, tile.blocks / tile.blocks_x, plan_.image.height);
    return true;
}

/// All of a tile, unless a launch must be cut: then what comes after a part waits until that has been measured; or
/// unless lights are so many that the tile takes longer than one launch may.
cl::Event Scheduler::launch_turn(size_t worker) {
    Slot& slot = slots_[worker];
    if (slot.step == plan_.steps.size() && !take_tile(slot)) return {};
    const Launches& launches = launches_[worker];
    bool whole = true;
    while (whole && slot.step < plan_.steps.size() && (launches.empty() || launches.expected() < pace_.bound())) {
        const Step& step = plan_.steps[slot.step];
        const Work all = work(slot, step);
        slot.item += launches_[worker].launch_part(slot.queue, all, slot.item, slot.busy);
        whole = slot.item == all.items;
        if (whole) end_step(step, slot);
    }
    slot.queue.flush();
    return slot.busy.back();
}

void Scheduler::launch_step(Slot& slot, const Step& step) {
    if (chunks_ && meets_spheres(step.kernel, plan_))
        launch_chunks(step, slot);
    else
        launches_.front().launch(slot.queue, work(slot, step), slot.busy);
    end_step(step, slot);
}

TileLaunch Scheduler::launch_of(const Slot& slot, const Step& step) const {
    return {step, tile_of(slot), slot.buffers, first_blocks_[slot.tile], &scene_.seen_by(step.light)};
}

/// What a step launches for the slot's tile; all of the tile's arguments are set.
Work Scheduler::work(const Slot& slot, const Step& step) {
    const auto variant = static_cast<size_t>(step.variant);
    binder_->bind(kernels_[variant], launch_of(slot, step));
    return work_of(slot, step);
}

Work Scheduler::work_of(const Slot& slot, const Step& step) const {
    const auto variant = static_cast<size_t>(step.variant);
    const bool last = &step == &plan_.steps.back();
    const int tag = step.variant + (last ? static_cast<int>(kernels_.size()) : 0);
    return {kernels_[variant],
            paces_[variant],
            tag,
            plan_.items(step.kernel, tile_of(slot)),
            plan_.local_size,
            units_,
            plan_.memory.cut ? parts_beside_chunks : 1};
}

void Scheduler::end_step(const Step& step, Slot& slot) {
    if (step.kernel == Kernel::resolve && !plan_.write_in_place)
        read_tile(slot.queue, slot.buffers.planes, step.output, tile_of(slot), film_, slot.busy);
    ++slot.step;
    slot.item = 0;
}

/// One launch for each chunk; of these only one is on the device at a time.
void Scheduler::launch_chunks(const Step& step, Slot& slot) {
    for (int chunk = 0; chunk < chunks_->chunks(); ++chunk) {
        queue_.finish();
        const SphereBuffers spheres = chunks_->seen(step.light, chunk);
        TileLaunch launch = launch_of(slot, step);
        launch.spheres = &spheres;
        launch.first_chunk = chunk == 0;
        binder_->bind(kernels_[static_cast<size_t>(step.variant)], launch);
        launches_.front().launch(slot.queue, work_of(slot, step), slot.busy);
        queue_.finish();
        launches_.front().measure_all();
    }
    if (step.kernel == Kernel::intersect_closest && plan_.albedos_of_rays) look_up_albedos(tile_of(slot), slot);
}

void Scheduler::look_up_albedos(const Tile& tile, Slot& slot) {
    std::vector<int> ids(static_cast<size_t>(tile.blocks) * BLOCK_RAYS);
    queue_.enqueueReadBuffer(slot.buffers.ids, CL_TRUE, 0, ids.size() * sizeof(int), ids.data());
    const std::vector<float> albedos = chunks_->albedos_of(ids);
    queue_.enqueueWriteBuffer(slot.buffers.albedos, CL_TRUE, 0, albedos.size() * sizeof(float), albedos.data());
}

void Scheduler::count_hits(const std::vector<int>& of_blocks) {
    for (size_t tile = 0; tile < first_blocks_.size(); ++tile) {
        const auto begin = of_blocks.begin() + first_blocks_[tile], end = begin + plan_.tiles[tile].blocks;
        measured_.shares[workers_of_tiles_[tile]].hits += std::accumulate(begin, end, int64_t{0});
    }
}

/// Adds up what launches took. By those of the last step, whose tags are beyond the variants, it is known how much is
/// done.
void Scheduler::ended(int tag, int64_t items, double seconds) {
    const bool last = static_cast<size_t>(tag) >= kernels_.size();
    const size_t variant = static_cast<size_t>(tag) - (last ? kernels_.size() : 0);
    measured_.launches[variant] += 1;
    measured_.seconds[variant] += seconds;
    measured_.longest[variant] = std::max(measured_.longest[variant], seconds);
    if (!last) return;
    done_items_ += items;
    share_ = tiles_->done(this, static_cast<double>(done_items_) / static_cast<double>(last_items_));
    if (tell_) (*tell_)(share_);
}

}  // namespace gnomon
