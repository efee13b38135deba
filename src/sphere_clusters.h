// The spheres on the device: sorted along a curve through space, in clusters, and what each pencil sees of them. All of
// it is done by kernels, or on the host for few spheres.
#pragma once

#include "device_memory.h"
#include "flat_clusters.h"
#include "hierarchy.h"
#include "launcher.h"
#include "pencil.h"
#include "sphere_rows.h"

namespace gnomon {

/// Rows on the device; see cl/sphere_rows.h.
struct RowBuffers {
    cl::Buffer rows, rests, ids;
    int columns = 0, first_id = 0, count = 0;
    bool has_rests = false, has_ids = false;
};
RowBuffers upload(const DeviceMemory& memory, const SphereRows& rows);

/// The scene's spheres in the order of the hierarchy, the same for all pencils.
struct ClusterBuffers {
    cl::Buffer clusters, rests;
    HierarchyShape shape;
    bool has_rests = false;
    FlatClusters few;  ///< in place of what is on the device, where the shape is flat
};
/// Spheres of a scene that is flat. Coincident spheres count as one: the lowest id stands for all.
ClusterBuffers few_clusters(const SphereRows& rows);

/// The spheres and the nodes over them as one pencil sees them: cl/hierarchy.h.
struct SphereBuffers {
    cl::Buffer clusters, nodes;
    int levels = 0, last = 0;
};

/// From where a pencil sees spheres, and the faces for which it keeps bounds.
struct PencilView {
    Either<ApexOf> apex;
    Either<ParallelPencilOf> parallel;  ///< used if is_parallel
    bool is_parallel = false;
    std::vector<Basis> faces;
};
template <class real = float>
PencilView view_of_eye(const Camera& camera, const Frame& frame) {
    return {eye_apex<real>(camera, frame), ParallelPencilOf<real>{}, false, {eye_basis(camera)}};
}
/// The clusters are then in the pencil's basis, and bounds look at no other.
template <class real>
PencilView view_of(const ParallelPencilOf<real>& pencil, const Camera& camera, const Frame& frame) {
    return {eye_apex<real>(camera, frame), pencil, true, {Basis{}}};
}
template <class real>
PencilView view_of(const PointPencilOf<real>& pencil, const Camera& camera, const Frame& frame) {
    return {
        point_apex(pencil, camera, frame), ParallelPencilOf<real>{}, false, {pencil.face, pencil.face + pencil.faces}};
}

/// Builds hierarchies on one device.
class SphereKernels {
  public:
    SphereKernels(const DeviceMemory& memory, Launcher& launcher, const Plan& plan)
        : memory_(memory), launcher_(launcher), plan_(plan) {}

    /// Likewise, but sorted for a hierarchy.
    ClusterBuffers gather(const RowBuffers& rows, const Survey& survey, const Frame& frame);
    /// No view waits for another: Launcher::branch.
    SphereBuffers project(const ClusterBuffers& spheres, const PencilView& view);

  private:
    struct Pairs;
    void sort(Pairs& pairs, const RowBuffers& rows, int word, bool first, const Survey& survey, const Frame& frame);
    bool find_duplicates(const Pairs& pairs, const RowBuffers& rows, bool hashed, int longest, const cl::Buffer& order);
    void order(const RowBuffers& rows, const Survey& survey, const Frame& frame, const cl::Buffer& order);
    template <class real>
    cl::Buffer look(const FlatClusters& spheres, const PencilView& view) const;
    void bound(const SphereBuffers& spheres, const HierarchyShape& shape, const PencilView& view);

    const DeviceMemory& memory_;
    Launcher& launcher_;
    const Plan& plan_;
};

}  // namespace gnomon
