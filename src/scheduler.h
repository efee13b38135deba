// Runs a plan: tiles through the chain of kernels, several at once, chained by events.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "binder.h"
#include "chunked_spheres.h"
#include "film.h"
#include "launcher.h"
#include "plan.h"
#include "tile_queue.h"
#include "workers.h"

namespace gnomon {

/// Whether workers take the next tile themselves when they have ended one: cores do, and parts of a CPU that render few
/// spheres together with others. There is then no thread of ours that takes a core from them.
bool deals_tiles(const Plan& plan);

/// What a run measured: for each variant of the plan launches, device seconds, and those of the longest launch.
struct Measured {
    std::vector<int> launches;
    std::vector<double> seconds, longest;
    /// What a worker did: tiles that it took.
    struct Share {
        int tiles = 0;
        int64_t pixels = 0, hits = 0;
    };
    std::vector<Share> shares;  ///< of the workers
    Share all_shares() const;
    std::vector<int> undecided;  ///< pixels, as places in the image row by row, in any order
};

/// One run of one plan. The film must have the plan's size and the planes that its steps resolve.
class Scheduler {
  public:
    /// `tiles` are the buffers of the tiles under way, `kernels` the plan's variants, built; `pace` is that of the
    /// plan's workers.
    Scheduler(const Workers& workers, const DeviceMemory& memory, const Plan& plan, const SceneBuffers& scene,
              const std::vector<TileBuffers>& tiles, std::vector<cl::Kernel> kernels, Pace& pace, const Stop* stop,
              Film& film);

    /// Where the spheres are if the plan cuts the scene.
    void take_spheres_from(ChunkedSpheres& chunks) { chunks_ = &chunks; }

    /// Launches everything that the queue hands out, after these events, and waits for it.
    Measured run(TileQueue& tiles, const std::vector<cl::Event>& after, const std::function<void(double)>& progress);

  private:
    /// A tile under way: its worker and the queue of that, its buffers, the events after which they are free, and what
    /// is to be launched next.
    struct Slot {
        size_t worker;
        cl::CommandQueue queue;
        TileBuffers buffers;
        std::vector<cl::Event> busy;
        size_t tile = 0;
        size_t step = 0;   // of the plan's; none is left when it is their number
        int64_t item = 0;  // of the step's work-items
    };

    void run_ahead(const std::function<void(double)>& progress);
    void deal_to_workers(const std::function<void(double)>& progress);
    bool take_tile(Slot& slot);
    void await_room();
    cl::Event launch_turn(size_t worker);
    void launch_step(Slot& slot, const Step& step);
    const Tile& tile_of(const Slot& slot) const { return plan_.tiles[slot.tile]; }
    TileLaunch launch_of(const Slot& slot, const Step& step) const;
    Work work(const Slot& slot, const Step& step);
    Work work_of(const Slot& slot, const Step& step) const;
    void end_step(const Step& step, Slot& slot);
    void launch_chunks(const Step& step, Slot& slot);
    void look_up_albedos(const Tile& tile, Slot& slot);
    void count_hits(const std::vector<int>& of_blocks);
    void ended(int tag, int64_t items, double seconds);

    cl::CommandQueue queue_;                 // of the whole device
    std::vector<cl::CommandQueue> workers_;  // on which tiles run
    const Plan& plan_;
    const SceneBuffers& scene_;
    ChunkedSpheres* chunks_ = nullptr;
    std::vector<cl::Kernel> kernels_;
    std::vector<KernelPace*> paces_;  // of the kernels
    const Pace& pace_;
    int units_;  // compute units of a worker
    Film& film_;
    TileQueue* tiles_ = nullptr;
    std::vector<Slot> slots_;
    std::vector<Launches> launches_;  // of each worker
    cl::Buffer hit_counts_;           // of each block, tile after tile
    UndecidedRays undecided_;
    std::vector<int> first_blocks_;         // of each tile, among all tiles'
    std::vector<size_t> workers_of_tiles_;  // who took each
    // Work-items of the last step: of all tiles, of those that were taken, and those that have ended.
    int64_t last_items_ = 0, taken_items_ = 0, done_items_ = 0;
    std::deque<int64_t> due_;  // done_items_ when each tile under way has ended, in order
    double share_ = 0;         // of all tiles, that is done
    const std::function<void(double)>* tell_ = nullptr;
    std::optional<Binder> binder_;
    Measured measured_;
};

}  // namespace gnomon
