#include "flat_clusters.h"

#include <algorithm>
#include <array>
#include <set>

#include "hierarchy.h"
#include "vec.h"

namespace gnomon {

namespace {

/// x y z radius.
using Numbers = std::array<float, 4>;

struct FlatSphere {
    Numbers numbers, rest;
    int id;

    double exact(size_t i) const { return static_cast<double>(numbers[i]) + static_cast<double>(rest[i]); }
    Vec3 center() const { return {exact(0), exact(1), exact(2)}; }
};
using Spheres = std::vector<FlatSphere>;
using At = Spheres::iterator;

/// Row `row` of so many columns.
Numbers numbers_at(const float* rows, size_t row, size_t columns) {
    Numbers numbers;
    std::copy_n(rows + row * columns, numbers.size(), numbers.begin());
    return numbers;
}

Spheres distinct_spheres(const SphereRows& rows) {
    Spheres spheres;
    std::set<std::pair<Numbers, Numbers>> known;
    for (size_t row = 0; row < static_cast<size_t>(rows.count); ++row) {
        const Numbers numbers = numbers_at(rows.rows, row, static_cast<size_t>(rows.columns)),
                      rest = rows.rests.empty() ? Numbers{} : numbers_at(rows.rests.data(), row, 4);
        if (known.insert({numbers, rest}).second)
            spheres.push_back({numbers, rest, static_cast<int>(rows.first) + static_cast<int>(row)});
    }
    return spheres;
}

At whole_clusters(At begin, At end, std::ptrdiff_t spheres) {
    return begin + std::min((spheres + CLUSTER - 1) / CLUSTER * CLUSTER, end - begin);
}

/// By halves, across the longest side of the box around the centres.
void arrange(At begin, At end) {
    if (end - begin <= CLUSTER) return;
    const auto by = [](size_t i) {
        return [i](const FlatSphere& a, const FlatSphere& b) {
            return std::pair(a.numbers[i], a.id) < std::pair(b.numbers[i], b.id);
        };
    };
    const auto side = [&](size_t i) {
        const auto [low, high] = std::minmax_element(begin, end, by(i));
        return high->exact(i) - low->exact(i);
    };
    const std::array<double, 3> sides{side(0), side(1), side(2)};
    const auto longest = static_cast<size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    const At middle = whole_clusters(begin, end, (end - begin) / 2);
    std::sort(begin, end, by(longest));
    arrange(begin, middle);
    arrange(middle, end);
}

/// Those that are much larger than most first: the cluster that they are in reaches far.
void sort_into_clusters(Spheres& spheres) {
    if (spheres.size() <= CLUSTER) return;
    std::sort(spheres.begin(), spheres.end(), [](const FlatSphere& a, const FlatSphere& b) {
        return std::pair(-a.numbers[3], a.id) < std::pair(-b.numbers[3], b.id);
    });
    const double large = 4 * spheres[spheres.size() / 2].exact(3);
    const At others =
        std::find_if(spheres.begin(), spheres.end(), [=](const FlatSphere& s) { return s.exact(3) <= large; });
    const At rest = whole_clusters(spheres.begin(), spheres.end(), others - spheres.begin());
    arrange(spheres.begin(), rest);
    arrange(rest, spheres.end());
}

template <class AnyCluster>
void put(AnyCluster& cluster, size_t place, const Numbers& numbers) {
    cluster.x[place] = numbers[0];
    cluster.y[place] = numbers[1];
    cluster.z[place] = numbers[2];
    cluster.radius[place] = numbers[3];
}

void put(FlatClusters& made, size_t place, const FlatSphere& sphere) {
    Cluster& cluster = made.clusters[place / CLUSTER];
    put(cluster, place % CLUSTER, sphere.numbers);
    cluster.id[place % CLUSTER] = sphere.id;
    if (!made.rests.empty()) put(made.rests[place / CLUSTER], place % CLUSTER, sphere.rest);
}

/// A ball around spheres, larger by 2^-14 than it need be: cl/reach.h.
Numbers ball_around(At begin, At end) {
    const auto middle = [=](size_t i) {
        double low = begin->exact(i), high = low;
        for (At s = begin; s < end; ++s) {
            low = std::min(low, s->exact(i) - s->exact(3));
            high = std::max(high, s->exact(i) + s->exact(3));
        }
        return static_cast<float>((low + high) / 2);
    };
    const FlatSphere ball{{middle(0), middle(1), middle(2), 0}, {}, 0};
    double radius = 0;
    for (At s = begin; s < end; ++s) radius = std::max(radius, length(s->center() - ball.center()) + s->exact(3));
    return {ball.numbers[0], ball.numbers[1], ball.numbers[2], static_cast<float>(radius * (1 + 0x1p-14))};
}

void add_balls(FlatClusters& made, Spheres& spheres) {
    const size_t first = (made.clusters.size() - 1) * CLUSTER;
    for (size_t i = 0; i < spheres.size(); i += CLUSTER) {
        const At begin = spheres.begin() + static_cast<std::ptrdiff_t>(i);
        const auto cluster = static_cast<int>(i / CLUSTER);
        put(made, first + i / CLUSTER,
            {ball_around(begin, whole_clusters(begin, spheres.end(), CLUSTER)), {}, cluster});
    }
}

}  // namespace

FlatClusters flat_clusters(const SphereRows& rows) {
    const HierarchyShape shape = hierarchy_over(rows.count);
    Cluster empty{};
    std::fill(std::begin(empty.id), std::end(empty.id), -1);
    FlatClusters made{std::vector<Cluster>(static_cast<size_t>(shape.all_clusters()), empty), {}};
    if (!rows.rests.empty()) made.rests.resize(made.clusters.size());
    Spheres spheres = distinct_spheres(rows);
    sort_into_clusters(spheres);
    for (size_t i = 0; i < spheres.size(); ++i) put(made, i, spheres[i]);
    if (shape.has_balls()) add_balls(made, spheres);
    return made;
}

}  // namespace gnomon
