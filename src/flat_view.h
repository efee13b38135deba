// What one pencil sees of few spheres, on the host.
#pragma once

#include <vector>

#include "flat_clusters.h"

namespace gnomon {

/// From an apex or, for a parallel light, from the eye, which is then the apex, in the light's basis. The same bits as
/// project_spheres writes: to build that kernel takes far longer than this.
template <class real>
std::vector<PencilClusterOf<real>> flat_view(const FlatClusters& spheres, const ApexOf<real>& apex,
                                             const ParallelPencilOf<real>& light, bool is_parallel);

}  // namespace gnomon
