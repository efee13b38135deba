// The scenes that the benchmark renders.
#pragma once

#include <string>
#include <vector>

#include "scene.h"

namespace bench {

struct NamedScene {
    std::string name;
    gnomon::Scene scene;
};

/// 1920 x 1080. S4: a ground and three spheres under a directional and a point light; S100: the ground and 99 small
/// spheres at random under two directional lights and a point light.
std::vector<NamedScene> scenes();

}  // namespace bench
