// The renderer as a library: a device, scenes in, films out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accuracy.h"
#include "device.h"
#include "film.h"
#include "scene.h"
#include "stop.h"

namespace gnomon {

struct RenderOptions {
    Outputs outputs;
    bool shadows = true;
    Accuracy accuracy = Accuracy::strict;
    int lanes = 0;        ///< rays a vector: 1, 4, 8 or 16; 0 lets the plan choose
    uint64_t memory = 0;  ///< bytes of the device that may be used; 0: all that it offers
    int tile = 0;         ///< rays a tile, rounded to whole 8 x 8 blocks; 0 lets the plan choose
    /// The spheres are those of the last call, untouched: what was built over them is used again, whatever camera,
    /// lights and image have become. (Where the scene is cut it is built anew.)
    bool same_spheres = false;
    /// Seconds that no launch should take on the device. A picture is cut so, as it turns out how long launches take;
    /// the bits stay the same.
    double longest_launch = 0.1;
    const Stop* stop = nullptr;  ///< may ask render() to stop: it then throws Stopped, and the film holds anything
    std::function<void(double)> progress = {};  ///< called now and then with the share that is done, 0 to 1
};

/// What one kernel variant cost. Seconds are the device's own (profiling counters); launches may overlap.
struct KernelStats {
    std::string device;   ///< its number
    std::string kernel;   ///< its name
    std::string options;  ///< how it was built, -D and all
    double build_seconds = 0;
    bool from_cache = false;  ///< what an earlier run had built was used
    int launches = 0;
    double seconds = 0;
    double longest = 0;  ///< seconds of the longest launch
    int64_t rays = 0;    ///< pixels for the eye's kernels; hits, once for each light, for the lights'
};

/// What one of the devices did.
struct DeviceShare {
    DeviceInfo device;
    int tiles = 0;
    int64_t rays = 0;    ///< as in RenderStats
    double seconds = 0;  ///< from the first launch to the last of its values in the film
};

struct RenderStats {
    Accuracy accuracy = Accuracy::strict;
    int lanes = 0, packets = 0, tiles = 0;
    int workers = 0;  ///< on tiles: 1, the whole device; more, so many of its cores, each on a tile of its own
    int64_t tile_rays = 0;
    int64_t planned_bytes = 0, peak_bytes = 0;  ///< of the device: what the plan said, and what it came to
    int chunks = 1;                             ///< in which the spheres went through the device
    int64_t pixels = 0, hits = 0, spheres = 0, lights = 0;
    double prepare_seconds = 0;  ///< the spheres as each pencil sees them, and their buffers
    double build_seconds = 0;    ///< kernels; 0 when they were built before
    double trace_seconds = 0;    ///< from the first launch to the last value in the film
    std::vector<KernelStats> kernels;
    int64_t undecided = 0;  ///< pixels that rounding may have decided, and that were decided again
    int64_t decided_exactly = 0;
    double decide_seconds = 0;
    double longest_launch = 0;  ///< seconds, of all launches
    std::vector<DeviceShare> shares;
    std::vector<std::string> warnings;  ///< what to tell the user

    /// Eye rays, and one shadow ray for each hit and light when shadows are on.
    int64_t rays = 0;
};

/// Renders on one device, or several: then each takes the next tile when it is free, and the bits are the same. Keeps
/// contexts and the kernels that were built between pictures.
/// Throws Error(Blame::run) when the device or its compiler fails, Error(Blame::input) for an accuracy that the device
/// does not have.
class Renderer {
  public:
    explicit Renderer(const DeviceInfo& device);
    /// All must be different. Numbers that differ from device to device (lanes, workers, ...) are then the first one's
    /// in RenderStats, and bytes those of all.
    explicit Renderer(const std::vector<DeviceInfo>& devices);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Renders into `film`, whose memory is reused when size and outputs are those it has.
    RenderStats render(const Scene& scene, const RenderOptions& options, Film& film);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace gnomon
