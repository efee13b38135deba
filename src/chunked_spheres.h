// Spheres as one pencil sees them at a time, chunk by chunk where they do not lie on the device all at once.
#pragma once

#include <vector>

#include "partition.h"
#include "sphere_clusters.h"

namespace gnomon {

class ChunkedSpheres {
  public:
    /// Cuts the scene if the plan says so, else `all` are its spheres. The rest must outlive this.
    ChunkedSpheres(const DeviceMemory& memory, SphereKernels& kernels, Launcher& launcher, const Scene& scene,
                   const Survey& survey, const Frame& frame, const Plan& plan, const ClusterBuffers* all);

    int chunks() const { return static_cast<int>(gathered_.size()); }

    /// One chunk as the eye (light < 0) or a light's pencil sees it; ready when this returns. What was seen before must
    /// be given back by then, for there is room for one.
    SphereBuffers seen(int light, int chunk);

    /// Of spheres, in the order of rays (cl/types.h): three floats for each id, 0 where it is negative.
    std::vector<float> albedos_of(const std::vector<int>& ids) const;

  private:
    ClusterBuffers gather(int chunk);
    PencilView view(int light) const;

    const DeviceMemory& memory_;
    SphereKernels& kernels_;
    Launcher& launcher_;
    const Scene& scene_;
    const Survey& survey_;
    const Frame& frame_;
    Accuracy accuracy_;
    bool resident_;
    Partition partition_;                   // if the scene is cut
    std::vector<ClusterBuffers> gathered_;  // of each chunk, if they stay
    SphereRows chunk_rows_;                 // of the chunk that was gathered last
};

}  // namespace gnomon
