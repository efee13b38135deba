#include "flat_clusters.h"

#include <algorithm>
#include <array>
#include <set>

namespace gnomon {

namespace {

/// x y z radius.
using Numbers = std::array<float, 4>;

/// Row `row` of so many columns.
Numbers numbers_at(const float* rows, size_t row, size_t columns) {
    Numbers numbers;
    std::copy_n(rows + row * columns, numbers.size(), numbers.begin());
    return numbers;
}

template <class AnyCluster>
void put(AnyCluster& cluster, size_t place, const Numbers& numbers) {
    cluster.x[place] = numbers[0];
    cluster.y[place] = numbers[1];
    cluster.z[place] = numbers[2];
    cluster.radius[place] = numbers[3];
}

}  // namespace

FlatClusters flat_clusters(const SphereRows& rows) {
    const auto count = static_cast<size_t>(rows.count), clusters = (count + CLUSTER - 1) / CLUSTER;
    Cluster empty{};
    std::fill(std::begin(empty.id), std::end(empty.id), -1);
    FlatClusters made{std::vector<Cluster>(clusters, empty), {}};
    if (!rows.rests.empty()) made.rests.resize(clusters);
    std::set<std::pair<Numbers, Numbers>> known;
    for (size_t row = 0; row < count; ++row) {
        const Numbers sphere = numbers_at(rows.rows, row, static_cast<size_t>(rows.columns)),
                      rest = rows.rests.empty() ? Numbers{} : numbers_at(rows.rests.data(), row, 4);
        if (!known.insert({sphere, rest}).second) continue;
        Cluster& cluster = made.clusters[row / CLUSTER];
        put(cluster, row % CLUSTER, sphere);
        cluster.id[row % CLUSTER] = static_cast<int>(rows.first) + static_cast<int>(row);
        if (!rows.rests.empty()) put(made.rests[row / CLUSTER], row % CLUSTER, rest);
    }
    return made;
}

}  // namespace gnomon
