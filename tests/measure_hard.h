// How far renderings of hard scenes are from the oracle.
#pragma once

#include <string>

#include "hard/hard_case.h"
#include "render.h"

namespace gnomon::test {

/// What a case came to, and where the worst of it is.
struct Measured {
    Figures figures;
    int64_t pixels = 0;
    std::string first_wrong, worst_t, worst_normal;  ///< scene and pixel; empty when there is none
};

/// Renders the case's scenes with these options, `times` as wide and high (unless they are very wide or high already),
/// once for each light, and compares pixels spread over the picture, at most 8192 a scene, with the oracle.
Measured measure(Renderer& renderer, const HardCase& hard, const RenderOptions& options, int times = 1);

}  // namespace gnomon::test
