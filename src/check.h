// A rendering's error, to stand beside its speed.
#pragma once

#include <cstdint>
#include <vector>

#include "film.h"
#include "scene.h"

namespace gnomon {

/// How far sampled pixels of a film are from the double-precision reference. Maxima over a sample are lower bounds.
struct Check {
    int64_t pixels = 0;       ///< sampled
    int64_t wrong_ids = 0;    ///< another first hit (only if the film holds ids)
    double max_distance = 0;  ///< relative, where the ids agree and the film holds distances
    double max_radiance = 0;  ///< relative to the brightest value of the sampled pixels, where it is no flip
    double rms_radiance = 0;  ///< likewise, the root of the mean square
    int64_t flips = 0;  ///< pixels whose radiance is off by more than a rounding: a shadow or a hit decided otherwise
    int64_t wrong_pixels = 0;  ///< with a wrong id or a flip
};

/// The pixels that check() compares, spread over the picture.
std::vector<size_t> sampled_pixels(const Scene& scene, const Film& film, bool shadows, int64_t pixels, int64_t tests);

/// Compares at most `pixels` pixels, spread over the picture, and fewer when the scene is so large that the reference
/// would need more than about `tests` ray-sphere tests (1 to 10 ns each).
Check check(const Scene& scene, const Film& film, bool shadows, int64_t pixels = 1024,
            int64_t tests = int64_t{1} << 22);

}  // namespace gnomon
