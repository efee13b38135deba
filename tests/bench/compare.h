// Two renderers' pictures of one scene, all pixels of them.
#pragma once

#include <cstdint>

#include "film.h"
#include "peer.h"
#include "scene.h"

namespace bench {

struct Difference {
    int64_t pixels = 0;
    int64_t other_id = 0;      ///< another first hit; spheres that coincide count as one
    int64_t other_lights = 0;  ///< the same hit, but not the same lights arrive at it
};

/// `ours` and `theirs` hold ids, `ours` radiance; `arrivals` are theirs.
Difference compare(const gnomon::Scene& scene, const gnomon::Film& ours, const gnomon::Film& theirs,
                   const Arrivals& arrivals);

}  // namespace bench
