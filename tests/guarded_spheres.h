// The hierarchy of one pencil, on a device, for kernels that are tested alone.
#pragma once

#include <algorithm>

#include "kernel_harness.h"
#include "pencil_spheres.h"

namespace gnomon::test {

struct GuardedSpheres {
    GuardedBuffer<SphereCluster> clusters;
    GuardedBuffer<Bounds> nodes;

    GuardedSpheres(Bench& bench, const PencilSpheres& spheres)
        : clusters(bench, spheres.clusters),
          nodes(bench, spheres.nodes.empty() ? std::vector<Bounds>(1) : spheres.nodes) {}  // no buffer is empty
    void check_unchanged() const {
        clusters.check_unchanged();
        nodes.check_unchanged();
    }
};

/// The same with everything within reach of every ray: brute force, by the same kernels.
inline PencilSpheres within_reach(PencilSpheres spheres) {
    const auto widen = [](Bounds& b) { std::fill(std::begin(b.reach), std::end(b.reach), INFINITY); };
    for (SphereCluster& c : spheres.clusters) widen(c.bounds);
    for (Bounds& b : spheres.nodes) widen(b);
    return spheres;
}

}  // namespace gnomon::test
