#include "hierarchy.h"

#include <numeric>

#include "../cl/types.h"

namespace gnomon {

namespace {

int groups_of_16(int64_t count) { return static_cast<int>((count + CLUSTER - 1) / CLUSTER); }

}  // namespace

int HierarchyShape::all_nodes() const { return std::accumulate(nodes.begin(), nodes.end(), 0); }

HierarchyShape hierarchy_over(int64_t spheres, int64_t flat) {
    HierarchyShape shape;
    shape.spheres = spheres;
    shape.clusters = groups_of_16(spheres);
    if (spheres <= flat) return shape;
    shape.nodes.push_back(groups_of_16(shape.clusters));
    while (shape.nodes.back() > 1) shape.nodes.push_back(groups_of_16(shape.nodes.back()));
    return shape;
}

}  // namespace gnomon
