// Few spheres in clusters, made on the host (flat_clusters).
#include <numeric>

#include "catch.h"
#include "flat_clusters.h"

using namespace gnomon;

namespace {

/// Rows of x y z radius and three numbers that do not count.
SphereRows rows_of(const std::vector<float>& x, int64_t first = 0) {
    SphereRows rows;
    rows.first = first;
    rows.count = static_cast<int64_t>(x.size());
    for (size_t i = 0; i < x.size(); ++i)
        for (const float number : {x[i], 2.0f, 3.0f, 0.5f, static_cast<float>(i), 0.0f, 0.0f})
            rows.made.push_back(number);
    rows.rows = rows.made.data();
    return rows;
}

std::vector<int> ids_of(const FlatClusters& made) {
    std::vector<int> ids;
    for (const Cluster& cluster : made.clusters) ids.insert(ids.end(), std::begin(cluster.id), std::end(cluster.id));
    return ids;
}

/// `ids`, and empty places up to whole clusters.
std::vector<int> filled_up(std::vector<int> ids) {
    ids.resize((ids.size() + CLUSTER - 1) / CLUSTER * CLUSTER, -1);
    return ids;
}

}  // namespace

TEST_CASE("flat_clusters: places are in the order of ids, and the last are empty", "[flat]") {
    std::vector<float> x(CLUSTER + 1);
    std::iota(x.begin(), x.end(), 0.0f);
    const FlatClusters made = flat_clusters(rows_of(x, 100));
    std::vector<int> ids(x.size());
    std::iota(ids.begin(), ids.end(), 100);
    CHECK(ids_of(made) == filled_up(ids));
    const Cluster& second = made.clusters[1];
    CHECK(std::vector<float>{second.x[0], second.y[0], second.z[0], second.radius[0]} ==
          std::vector<float>{CLUSTER, 2, 3, 0.5f});
    CHECK(made.rests.empty());
}

TEST_CASE("flat_clusters: a sphere that coincides with one of a lower id has an empty place", "[flat]") {
    CHECK(ids_of(flat_clusters(rows_of({1, 1, 0.0f, -0.0f, 2, 1}))) == filled_up({0, -1, 2, -1, 4, -1}));
    // Unless what rounding left over differs.
    SphereRows rows = rows_of({1, 1, 1});
    for (const float rest : {1e-9f, 0.0f, 1e-9f}) rows.rests.insert(rows.rests.end(), {rest, 0, 0, 0});
    const FlatClusters made = flat_clusters(rows);
    CHECK(ids_of(made) == filled_up({0, 1, -1}));
    CHECK(made.rests[0].x[0] == 1e-9f);
    CHECK(made.rests[0].x[1] == 0);
}
