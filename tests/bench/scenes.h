// The scenes that the benchmark renders.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene.h"

namespace bench {

struct NamedScene {
    std::string name;
    std::function<gnomon::Scene()> make;
};

/// 1920 x 1080. S4: a ground and three spheres under a directional and a point light; S100: the ground and 99 small
/// spheres at random under two directional lights and a point light; S1e4 and S1e6: so many small spheres in a cube.
std::vector<NamedScene> scenes();

}  // namespace bench
