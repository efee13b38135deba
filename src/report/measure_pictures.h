// Times whole pictures, in each accuracy, and how wrong they are.
#pragma once

#include <string>
#include <vector>

#include "check.h"
#include "render.h"
#include "roots_error.h"
#include "scene.h"
#include "statistics.h"

namespace gnomon::report {

struct KernelTime {
    std::string kernel, options;
    Series ns_per_ray;
    int64_t rays = 0;
};

/// Against the double-precision reference (check.h), on sampled pixels.
struct PictureError {
    Check check;
    Decisions shadow_bits;  ///< whether a light reaches the hit; where the hit is right and the light could be seen
};

struct Picture {
    Accuracy accuracy;
    Series seconds;  ///< a whole render() call, kernels warm, the hierarchy built anew
    int64_t rays = 0;
    std::vector<KernelTime> kernels;
    PictureError error;
};

struct NamedScene {
    std::string name;
    Scene scene;
};

/// How much to do: frames that are timed, and the sample, in pixels and in ray-sphere tests of the reference.
struct PictureEffort {
    int frames = 15;
    int64_t pixels = 1 << 15, tests = int64_t{1} << 28;
};

/// In turn, so that what else the machine does meets all accuracies alike.
std::vector<Picture> measure_pictures(Renderer& renderer, const Scene& scene, const std::vector<Accuracy>& accuracies,
                                      const PictureEffort& effort);

}  // namespace gnomon::report
