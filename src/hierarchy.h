// How many clusters and nodes there are over so many spheres: the hierarchy's shape follows from their number alone.
#pragma once

#include <cstdint>
#include <vector>

namespace gnomon {

/// Up to so many spheres the clusters are visited one after the other: no sorting, no nodes.
constexpr int64_t flat_spheres = 256;

/// Up to so many spheres every ray is tested against all: to pass over some costs a block as much as testing four or
/// so, and few are far from most blocks.
constexpr int64_t few_spheres = 6;

struct HierarchyShape {
    int64_t spheres = 0;
    int clusters = 0;  ///< of 16 spheres
    std::vector<int>
        nodes;  ///< on each level, the lowest first: 16 clusters a node, then 16 nodes; the last level has one

    int levels() const { return static_cast<int>(nodes.size()); }
    int all_nodes() const;
    /// The last node, which is the root; without nodes the last cluster.
    int last() const { return (nodes.empty() ? clusters : all_nodes()) - 1; }
    bool is_flat() const { return nodes.empty(); }
};

/// `flat`: how many spheres have no nodes.
HierarchyShape hierarchy_over(int64_t spheres, int64_t flat = flat_spheres);

}  // namespace gnomon
