// The spheres, and the balls over them, as the rays of one pencil see them.
#pragma once

#include <vector>

#include "../cl/types.h"
#include "hierarchy.h"
#include "pencil.h"

namespace gnomon {

/// The hierarchy of cl/hierarchy.h, ready for the device.
struct PencilSpheres {
    std::vector<SphereCluster> clusters;
    std::vector<Bounds> nodes;  ///< level by level, the lowest first; the last is the root
    int levels = 0;
    /// The last node; without nodes the last cluster.
    int last() const { return static_cast<int>(levels > 0 ? nodes.size() : clusters.size()) - 1; }
};

PencilSpheres seen_from_eye(const Camera& camera, const Hierarchy& hierarchy);
/// Along a directional light: in the pencil's basis, still relative to the eye.
PencilSpheres seen_along(const ParallelPencil& pencil, const Camera& camera, const Hierarchy& hierarchy);
/// From a point light.
PencilSpheres seen_from_point(const PointPencil& pencil, const Camera& camera, const Hierarchy& hierarchy);

}  // namespace gnomon
