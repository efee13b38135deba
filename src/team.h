// Devices that render one picture together.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "device_renderer.h"

namespace gnomon {

/// Each device has the spheres, and a hierarchy over them, to itself, and takes a tile when it is free. The cores of a
/// CPU, when all are there, are one device, whose spheres they share.
class Team {
  public:
    /// Throws Error with the name of the device that fails.
    explicit Team(const std::vector<DeviceInfo>& devices);

    bool has_several() const { return members_.size() > 1; }
    /// Throws Error(Blame::input) for an accuracy that some device does not have.
    void check_accuracy(Accuracy accuracy) const;
    /// A plan for each device, all of the same tiles.
    std::vector<Plan> make_plans(const Scene& scene, const Survey& survey, const RenderOptions& options) const;

    /// The whole film; what all devices did is added up. When one fails, or a stop is asked for, the others end after
    /// the tiles that they have: its error is thrown.
    RenderStats render(const Scene& scene, const Survey& survey, const Frame& frame, const std::vector<Plan>& plans,
                       const RenderOptions& options, Film& film);

  private:
    using MakeJob = std::function<Job(size_t member, const RenderOptions& options)>;

    std::vector<RenderStats> render_at_once(const MakeJob& make_job, const RenderOptions& options, TileQueue& queue,
                                            Film& film);

    std::vector<std::unique_ptr<DeviceRenderer>> members_;
};

}  // namespace gnomon
