// Few spheres in clusters, made on the host (flat_clusters).
#include <algorithm>
#include <cmath>
#include <numeric>

#include "crowds.h"
#include "flat_clusters.h"
#include "hierarchy.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Rows of x y z radius and three numbers that do not count.
SphereRows rows_of(const std::vector<Sphere>& spheres, int64_t first = 0) {
    SphereRows rows;
    rows.first = first;
    rows.count = static_cast<int64_t>(spheres.size());
    for (const Sphere& s : spheres)
        for (const double number : {s.center.x, s.center.y, s.center.z, s.radius, 1.0, 0.0, 0.0})
            rows.made.push_back(static_cast<float>(number));
    rows.rows = rows.made.data();
    return rows;
}
SphereRows rows_along_x(const std::vector<double>& places, int64_t first = 0) {
    std::vector<Sphere> spheres;
    for (const double x : places) spheres.push_back({{x, 2, 3}, 0.5});
    return rows_of(spheres, first);
}

/// Of all clusters, but not of their balls.
std::vector<int> ids_of(const FlatClusters& made, int clusters) {
    std::vector<int> ids;
    for (int c = 0; c < clusters; ++c) {
        const Cluster& cluster = made.clusters[static_cast<size_t>(c)];
        ids.insert(ids.end(), std::begin(cluster.id), std::end(cluster.id));
    }
    return ids;
}

/// `ids`, and empty places up to whole clusters.
std::vector<int> filled_up(std::vector<int> ids) {
    ids.resize((ids.size() + CLUSTER - 1) / CLUSTER * CLUSTER, -1);
    return ids;
}

double distance(const Cluster& a, size_t i, const Cluster& b, size_t j) {
    const auto off = [](float p, float q) { return static_cast<double>(p) - static_cast<double>(q); };
    return std::hypot(off(a.x[i], b.x[j]), off(a.y[i], b.y[j]), off(a.z[i], b.z[j]));
}

}  // namespace

TEST_CASE("flat_clusters: one cluster is in the order of ids, and its last places are empty", "[flat]") {
    std::vector<double> x(CLUSTER - 1);
    std::iota(x.rbegin(), x.rend(), 0.0);
    const FlatClusters made = flat_clusters(rows_along_x(x, 100));
    std::vector<int> ids(x.size());
    std::iota(ids.begin(), ids.end(), 100);
    CHECK(ids_of(made, 1) == filled_up(ids));
    const Cluster& only = made.clusters[0];
    CHECK(std::vector<float>{only.x[0], only.y[0], only.z[0], only.radius[0]} ==
          std::vector<float>{CLUSTER - 2, 2, 3, 0.5f});
    CHECK(made.rests.empty());
}

TEST_CASE("flat_clusters: neighbours are in one cluster", "[flat]") {
    std::vector<double> x;
    for (int i = 0; i < CLUSTER; ++i) x.insert(x.end(), {i * 1.0, 1000.0 + i});  // every other one is far away
    const std::vector<int> ids = ids_of(flat_clusters(rows_along_x(x)), 2);
    CHECK(std::all_of(ids.begin(), ids.begin() + CLUSTER, [](int id) { return id % 2 == 0; }));
    CHECK(std::all_of(ids.begin() + CLUSTER, ids.end(), [](int id) { return id % 2 == 1; }));
}

TEST_CASE("flat_clusters: large spheres come first", "[flat]") {
    std::vector<Sphere> spheres(40, {{0, 0, 0}, 1});
    for (size_t i = 0; i < spheres.size(); ++i) spheres[i].center.x = static_cast<double>(i);
    spheres[17].radius = 100;
    spheres[30].radius = 50;
    const std::vector<int> ids = ids_of(flat_clusters(rows_of(spheres)), 3);
    for (const int large : {17, 30}) CHECK(std::find(ids.begin(), ids.end(), large) - ids.begin() < CLUSTER);
}

TEST_CASE("flat_clusters: of coincident spheres the lowest id stands for all", "[flat]") {
    CHECK(ids_of(flat_clusters(rows_along_x({1, 1, 0.0, -0.0, 2, 1})), 1) == filled_up({0, 2, 4}));
    // Unless what rounding left over differs.
    SphereRows rows = rows_along_x({1, 1, 1});
    for (const float rest : {1e-9f, 0.0f, 1e-9f}) rows.rests.insert(rows.rests.end(), {rest, 0, 0, 0});
    const FlatClusters made = flat_clusters(rows);
    CHECK(ids_of(made, 1) == filled_up({0, 1}));
    CHECK(made.rests[0].x[0] == 1e-9f);
    CHECK(made.rests[0].x[1] == 0);
}

TEST_CASE("flat_clusters: every sphere is there once, inside the ball around its cluster", "[flat]") {
    for (const Crowd crowd : crowds)
        for (const int n : {65, 150, 256}) {
            INFO(n << " " << to_string(crowd));
            const HierarchyShape shape = hierarchy_over(n);
            const FlatClusters made = flat_clusters(rows_of(scene_of(crowd, n).spheres));
            REQUIRE(made.clusters.size() == static_cast<size_t>(shape.clusters + 1));
            const Cluster& balls = made.clusters.back();
            int spheres = 0;
            std::vector<bool> seen(static_cast<size_t>(n));
            for (size_t c = 0; c < static_cast<size_t>(shape.clusters); ++c)
                for (size_t i = 0; i < CLUSTER; ++i) {
                    const Cluster& cluster = made.clusters[c];
                    if (cluster.id[i] < 0) continue;
                    CHECK(!seen[static_cast<size_t>(cluster.id[i])]);
                    seen[static_cast<size_t>(cluster.id[i])] = true;
                    ++spheres;
                    const double reach = distance(cluster, i, balls, c) + static_cast<double>(cluster.radius[i]);
                    CHECK(balls.id[c] == static_cast<int>(c));
                    // 2^-14 more than it needs, less what radius and distance are rounded by.
                    CHECK(reach <= static_cast<double>(balls.radius[c]) * (1 - 0x1p-15));
                }
            CHECK(spheres == (crowd == Crowd::coincident ? 3 : n));
        }
}
