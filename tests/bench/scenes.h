// The scenes that the benchmark renders, 1920 x 1080 all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene.h"

namespace bench {

struct NamedScene {
    std::string name;
    std::string about;
    std::function<gnomon::Scene()> make;
    bool usual = false;  ///< rendered when no scene is named
};

/// S4: a ground and three spheres under a directional and a point light; S100: the ground and 99 small spheres at
/// random under two directional lights and a point light; S1e4 to S1e8: so many small spheres in a cube.
std::vector<NamedScene> scenes();

/// The cube of `count` spheres, first and named "benign", and scenes of about as many spheres that are made to be slow.
std::vector<NamedScene> adversaries(int64_t count);

/// `count` spheres in the cube [-50, 50)^3 whose volumes add up to 5 % of it, under a directional and a point light.
gnomon::Scene cube(int64_t count, int columns = 7);

/// What the scenes have in common.
gnomon::Light directional(gnomon::Vec3 direction, double irradiance);
gnomon::Light point(gnomon::Vec3 position, double power);
gnomon::Scene empty_cube();

}  // namespace bench
