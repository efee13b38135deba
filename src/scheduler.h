// Runs a plan: tiles through the chain of kernels, several at once, chained by events.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "binder.h"
#include "chunked_spheres.h"
#include "film.h"
#include "launcher.h"
#include "plan.h"
#include "workers.h"

namespace gnomon {

/// What a run measured: for each variant of the plan launches and device seconds, and how many eye rays hit.
struct Measured {
    std::vector<int> launches;
    std::vector<double> seconds;
    int64_t hits = 0;
    std::vector<int> undecided;  ///< pixels, as places in the image row by row, in any order
};

/// One run of one plan. The film must have the plan's size and the planes that its steps resolve.
class Scheduler {
  public:
    /// `tiles` are the buffers of the tiles under way, `kernels` the plan's variants, built.
    Scheduler(const Workers& workers, const DeviceMemory& memory, const Plan& plan, const SceneBuffers& scene,
              const std::vector<TileBuffers>& tiles, std::vector<cl::Kernel> kernels, Film& film);

    /// Where the spheres are if the plan cuts the scene.
    void take_spheres_from(ChunkedSpheres& chunks) { chunks_ = &chunks; }

    /// Launches everything, after these events, and waits for it; the film is then complete.
    Measured run(const std::vector<cl::Event>& after, const std::function<void(double)>& progress);

  private:
    /// A tile under way: the queue of its worker, its buffers, and the events after which they are free.
    struct Slot {
        cl::CommandQueue queue;
        TileBuffers buffers;
        std::vector<cl::Event> busy;
        int first_group;  // of its work-groups, in hit_counts_
        int first_block;  // of its blocks, in all tiles'
    };
    struct Launched {
        int variant;
        cl::Event event;
    };

    void run_ahead(const std::function<void(double)>& progress);
    void deal_to_cores(const std::function<void(double)>& progress);
    void enqueue(size_t tile, Slot& slot);
    size_t groups(Kernel kernel, const Tile& tile) const;
    void launch(size_t tile, const TileLaunch& what, Slot& slot);
    void launch_chunks(size_t tile, const Step& step, Slot& slot);
    void look_up_albedos(const Tile& tile, Slot& slot);
    const SphereBuffers& resident_spheres(const Step& step) const;
    void read_planes(Output output, const Tile& tile, Slot& slot);
    void await(size_t tile, const std::function<void(double)>& progress);
    void collect(size_t tile);
    void map_film();

    cl::CommandQueue queue_;                 // of the whole device
    std::vector<cl::CommandQueue> workers_;  // on which tiles run
    const Plan& plan_;
    const SceneBuffers& scene_;
    ChunkedSpheres* chunks_ = nullptr;
    std::vector<cl::Kernel> kernels_;
    Film& film_;
    std::vector<Slot> slots_;
    std::vector<std::vector<Launched>> launched_;  // for each tile
    cl::Buffer hit_counts_;                        // for each work-group of intersect_closest, tile after tile
    UndecidedRays undecided_;
    std::vector<int> first_groups_, first_blocks_;  // of each tile, in hit_counts_ and in all tiles' blocks
    int groups_ = 0;                                // of all tiles
    std::optional<Binder> binder_;
    Measured measured_;
};

}  // namespace gnomon
