// Which lights reach which pixels, as the kernels see it and as the reference does.
#pragma once

#include <vector>

#include "render.h"
#include "roots_error.h"
#include "scene.h"

namespace gnomon::report {

/// A picture says what arrives in all, not from which light: so each light is rendered alone, in white, and reaches a
/// hit where the radiance is not 0. Compared for those of the sampled pixels whose hit is right, and whose albedo is
/// not 0. `film` has the ids of the picture.
Decisions shadow_bits(Renderer& renderer, const Scene& scene, const RenderOptions& options, const Film& film,
                      const std::vector<size_t>& sample);

}  // namespace gnomon::report
