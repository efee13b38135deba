// Few spheres in clusters, made on the host.
#pragma once

#include <vector>

#include "../cl/types.h"
#include "sphere_rows.h"

namespace gnomon {

/// As gather_spheres writes them; no rests where all numbers are floats.
struct FlatClusters {
    std::vector<Cluster> clusters;
    std::vector<ClusterRest> rests;
};

/// At most flat_spheres, neighbours together and large ones apart. Of coincident spheres the one of the lowest id
/// stands for all. Of the balls around clusters, if there are any, another cluster is made. For so few, to build the
/// kernels that do this would take longer than all else that has to be built.
FlatClusters flat_clusters(const SphereRows& rows);

}  // namespace gnomon
