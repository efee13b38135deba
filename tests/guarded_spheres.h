// The hierarchy of one pencil, built on a device, for kernels that are tested alone.
#pragma once

#include <algorithm>

#include "kernel_harness.h"
#include "sphere_clusters.h"

namespace gnomon::test {

/// What one pencil sees of a scene, read back.
template <class real>
struct PencilSpheresOf {
    std::vector<PencilClusterOf<real>> clusters;
    std::vector<Node> nodes;  ///< of all its faces
    int levels = 0, last = 0;
    std::string walk = "WALK_NODES";  ///< cl/types.h
};
using PencilSpheres = PencilSpheresOf<float>;

/// With which kernels compute in this type.
template <class real>
constexpr Accuracy accuracy_of = sizeof(real) == sizeof(double) ? Accuracy::full : Accuracy::strict;

template <class T>
std::vector<T> read_back(Bench& bench, const cl::Buffer& buffer, size_t count) {
    std::vector<T> values(count);
    if (count > 0) bench.queue.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(T), values.data());
    return values;
}

/// How sorting is shared out.
struct Sharing {
    int slices = 32;
};

/// The scene's spheres in the order of the hierarchy, on the device.
class DeviceSpheres {
  public:
    DeviceSpheres(Bench& bench, const Scene& scene, const Sharing& sharing = {})
        : survey(gnomon::survey(scene)),
          frame(choose_frame(scene, survey)),
          bench_(bench),
          memory_(bench.context, bench.info.shares_memory),
          launcher_(bench.queue, bench.programs, pace_, std::max(bench.info.compute_units, 1)),
          rows_(sphere_rows(scene, frame, 0, survey.count)) {
        plan_.local_size = bench.local;
        plan_.max_slices = sharing.slices;
        SphereKernels kernels(memory_, launcher_, plan_);
        buffers = hierarchy_over(survey.count).is_flat() ? few_clusters(rows_)
                                                         : kernels.gather(upload(memory_, rows_), survey, frame);
    }
    /// The view must be one of the same reals.
    template <class real = float>
    PencilSpheresOf<real> seen(const PencilView& view) {
        plan_.accuracy = accuracy_of<real>;
        const SphereBuffers seen = SphereKernels(memory_, launcher_, plan_).project(buffers, view);
        const HierarchyShape& shape = buffers.shape;
        return {read_back<PencilClusterOf<real>>(bench_, seen.clusters, static_cast<size_t>(shape.all_clusters())),
                read_back<Node>(bench_, seen.nodes, view.faces.size() * static_cast<size_t>(shape.all_nodes())),
                seen.levels, seen.last, shape.is_flat() ? "WALK_CLUSTERS" : "WALK_NODES"};
    }
    std::vector<Cluster> clusters() const {
        if (buffers.shape.is_flat())  // but for those of balls
            return {buffers.few.clusters.begin(), buffers.few.clusters.begin() + buffers.shape.clusters};
        return read_back<Cluster>(bench_, buffers.clusters, static_cast<size_t>(buffers.shape.clusters));
    }

    Survey survey;
    Frame frame;
    ClusterBuffers buffers;

  private:
    Bench& bench_;
    DeviceMemory memory_;
    Pace pace_;
    Launcher launcher_;
    Plan plan_;
    SphereRows rows_;
};

template <class real = float>
PencilSpheresOf<real> seen_from_eye(Bench& bench, const Scene& scene) {
    DeviceSpheres spheres(bench, scene);
    return spheres.seen<real>(view_of_eye<real>(scene.camera, spheres.frame));
}

template <class real>
struct GuardedSpheres {
    GuardedBuffer<PencilClusterOf<real>> clusters;
    GuardedBuffer<Node> nodes;

    GuardedSpheres(Bench& bench, const PencilSpheresOf<real>& spheres)
        : clusters(bench, spheres.clusters),
          nodes(bench, spheres.nodes.empty() ? std::vector<Node>(1) : spheres.nodes) {}  // no buffer is empty
    void check_unchanged() const {
        clusters.check_unchanged();
        nodes.check_unchanged();
    }
};

/// By brute force: every ray against every sphere, without bounds, nodes and balls.
template <class real>
PencilSpheresOf<real> brute(PencilSpheresOf<real> spheres) {
    if (spheres.walk == "WALK_CLUSTERS" && spheres.levels > 0) spheres.clusters.pop_back();
    spheres.levels = 0;
    spheres.last = static_cast<int>(spheres.clusters.size()) - 1;
    spheres.walk = "WALK_SPHERES";
    return spheres;
}

}  // namespace gnomon::test
