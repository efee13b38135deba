// Times a scene's frames, gnomon's and the peer's in turn, and the errors of what they show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check.h"
#include "compare.h"
#include "render.h"
#include "scene.h"

namespace bench {

/// Seconds of the same thing, again and again.
struct Series {
    std::vector<double> seconds;
    double median() const;
    double least() const;
    double most() const;
};

struct Measure {
    int runs = 21;      ///< frames a scene at most
    double limit = 20;  ///< seconds: fewer frames when they would take longer, and no frame of the peer's takes longer
    int threads = 1;    ///< the peer's
    bool with_peer = true;
    gnomon::RenderOptions options;
};

/// gnomon's frames: whole render() calls, kernels warm, the hierarchy built anew each time.
struct OwnTimes {
    gnomon::RenderStats stats;  ///< of the last
    Series frame, prepare, trace;
    double longest_launch = 0;  ///< seconds on the device, of all frames, the first too
    std::vector<Series> kernels;
    gnomon::Check check;
};

struct PeerTimes {
    std::string mode;
    bool late = false;  ///< given up at the limit: then nothing else is known
    Series build, frame, total;
    gnomon::Check check;
    Difference difference;
};

struct SceneTimes {
    std::string name, about;
    std::optional<double> load_seconds;  ///< of a scene file
    gnomon::ImageSize image;
    OwnTimes own;
    std::optional<PeerTimes> peer;
};

/// Fills in all but name, about and load_seconds.
SceneTimes measure(gnomon::Renderer& renderer, const gnomon::Scene& scene, const Measure& how);

}  // namespace bench
