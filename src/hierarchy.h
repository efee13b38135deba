// How many clusters and nodes there are over so many spheres: the hierarchy's shape follows from their number alone.
#pragma once

#include <cstdint>
#include <vector>

namespace gnomon {

/// Up to so many spheres, 16 clusters, there are no nodes.
constexpr int64_t flat_spheres = 256;

/// Without nodes there are balls around so many clusters or more: to look at the balls costs a block as much as to look
/// through a cluster, and of fewer hardly more than one is passed over.
constexpr int least_balls = 5;

/// Up to so many spheres every ray is tested against all: to pass over some costs a block as much as testing four or
/// so, and few are far from most blocks.
constexpr int64_t few_spheres = 6;

struct HierarchyShape {
    int64_t spheres = 0;
    int clusters = 0;  ///< of 16 spheres
    std::vector<int>
        nodes;  ///< on each level, the lowest first: 16 clusters a node, then 16 nodes; the last level has one

    bool is_flat() const { return nodes.empty(); }
    bool has_balls() const { return is_flat() && clusters >= least_balls; }
    /// Of nodes, or of balls.
    int levels() const { return has_balls() ? 1 : static_cast<int>(nodes.size()); }
    int all_nodes() const;
    /// With that of balls, which is the last.
    int all_clusters() const { return clusters + (has_balls() ? 1 : 0); }
    /// The last node, which is the root; without nodes the last cluster.
    int last() const { return (is_flat() ? all_clusters() : all_nodes()) - 1; }
};

/// `flat`: how many spheres have no nodes.
HierarchyShape hierarchy_over(int64_t spheres, int64_t flat = flat_spheres);

}  // namespace gnomon
