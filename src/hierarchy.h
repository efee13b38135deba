// The order of the spheres, and balls around 16, 256, ... of them: what all pencils share.
#pragma once

#include <cstddef>
#include <vector>

#include "../cl/types.h"
#include "scene.h"

namespace gnomon {

struct Ball {
    Vec3 center;
    double radius = 0;
};

/// Spheres sorted so that neighbours in the order are neighbours in space, and of like size; sphere k lies in cluster k
/// / 16.
struct Hierarchy {
    std::vector<int> order;     ///< ids of the distinct spheres
    std::vector<Ball> spheres;  ///< those spheres
    std::vector<std::vector<Ball>>
        levels;  ///< levels[0]: around each cluster; levels[k]: around 16 balls of levels[k - 1]
};

/// Up to so many spheres the clusters are visited one after the other: no levels.
constexpr size_t flat_spheres = CLUSTER * CLUSTER;

/// Coincident spheres count as one: the lowest id stands for all. Linear in the number of spheres, but for the sort.
/// The last level has at most 16 balls, the root's children.
Hierarchy build_hierarchy(const std::vector<Sphere>& spheres);

}  // namespace gnomon
