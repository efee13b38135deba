// One device with what it keeps between pictures; renders the tiles that it takes from a queue.
#pragma once

#include <optional>
#include <vector>

#include "buffers.h"
#include "launcher.h"
#include "program.h"
#include "scheduler.h"
#include "workers.h"

namespace gnomon {

/// What is to be rendered.
struct Job {
    const Scene& scene;
    const Survey& survey;
    const Frame& frame;
    const Plan& plan;
    const RenderOptions& options;
};

/// What is known before the first launch.
RenderStats planned(const Plan& plan, const Scene& scene);

/// For use by one thread at a time.
class DeviceRenderer {
  public:
    /// Throws cl::Error.
    explicit DeviceRenderer(const DeviceInfo& info);

    const DeviceInfo& info() const { return info_; }

    /// From the spheres to the part of the film that the queue's tiles are, and what that took. The spheres are those
    /// of the last picture if the job says so. Throws Error, with the device's name, and Stopped.
    RenderStats render(const Job& job, TileQueue& queue, Film& film);

  private:
    /// The spheres' rows on the device, and what they lie in.
    struct Rows {
        SphereRows rows;
        RowBuffers buffers;
        AlbedoBuffer albedos;
    };
    /// The spheres on the device.
    struct Still {
        Survey survey;
        Frame frame;
        Rows rows;
        ClusterBuffers clusters;  // unless the scene is cut
    };

    int group_limit(const Plan& plan);
    Plan in_smaller_groups(const Job& job, int most) const;
    void make_room(const Plan& plan);
    std::vector<cl::Kernel> build(const Job& job, RenderStats& stats);
    Rows upload_rows(const Job& job);
    const Still& still_spheres(const Job& job, SphereKernels& kernels);
    void run(const Job& job, const std::vector<cl::Kernel>& kernels, TileQueue& queue, Film& film, RenderStats& stats);
    std::vector<int> open_alone(const Job& job, const SceneBuffers& buffers, const std::vector<int>& pixels, Film& film,
                                RenderStats& stats);
    std::vector<int> refine(const Job& job, const Still& spheres, const std::vector<int>& pixels, Film& film,
                            RenderStats& stats);
    void decide_again(const Job& job, const Still& spheres, const SceneBuffers& buffers, const std::vector<int>& pixels,
                      Film& film, RenderStats& stats);

    DeviceInfo info_;
    Workers workers_;
    Programs programs_;
    DeviceMemory memory_;
    TilePool tiles_, single_tiles_, refined_tiles_;
    Pace pace_, core_pace_;       // of the whole device, and of a core of it
    std::optional<Still> still_;  // of the last picture
};

}  // namespace gnomon
