#include "footprint.h"

#include <algorithm>

#include "../cl/types.h"

namespace gnomon {

namespace {

constexpr int64_t word = 4;

int64_t nodes_of(int64_t spheres) { return hierarchy_over(spheres).all_nodes(); }
int64_t clusters_of(int64_t spheres) { return hierarchy_over(spheres).all_clusters(); }

/// Clusters as a pencil sees them.
int64_t seen(int64_t spheres, int real_bytes) {
    const size_t cluster = real_bytes == sizeof(double) ? sizeof(PencilClusterOf<double>) : sizeof(PencilCluster);
    return clusters_of(spheres) * static_cast<int64_t>(cluster);
}

}  // namespace

int64_t SphereFootprint::rows(int64_t spheres) const {
    return copies_rows ? spheres * word * (columns + (has_rests ? 4 : 0) + (has_ids ? 1 : 0)) : 0;
}

int64_t SphereFootprint::sorting(int64_t spheres) const {
    const int64_t pair = 2 * word, order = word, counts = DIGITS * word;
    return spheres * (2 * pair + order) + (slices + 1) * counts;
}

int64_t SphereFootprint::clusters(int64_t spheres) const {
    return clusters_of(spheres) * static_cast<int64_t>(sizeof(Cluster) + (has_rests ? sizeof(ClusterRest) : 0));
}

int64_t SphereFootprint::view(int64_t spheres) const {
    return seen(spheres, real_bytes) + faces * nodes_of(spheres) * static_cast<int64_t>(sizeof(Node));
}

int64_t SphereFootprint::building(int64_t spheres) const {
    return rows(spheres) + std::max(sorting(spheres), word * spheres + clusters(spheres));
}

int64_t SphereFootprint::largest_buffer(int64_t spheres) const {
    return std::max({spheres * word * columns, seen(spheres, real_bytes),
                     faces * nodes_of(spheres) * static_cast<int64_t>(sizeof(Node))});
}

}  // namespace gnomon
