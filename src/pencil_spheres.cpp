#include "pencil_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gnomon {

namespace {

Vec3 widened(const Float3& v) { return {v.x, v.y, v.z}; }

/// The smallest float that is not below v, give or take the rounding of v itself (2^-53, far inside the bounds of
/// fat_ray.h).
float rounded_up(double v) {
    const float f = static_cast<float>(v);
    return f < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// How a pencil sees a point: from its apex, or, when it has none, from the eye in its basis.
struct View {
    Vec3 apex;
    const ParallelPencil* basis = nullptr;

    Vec3 place(const Vec3& from) const {
        if (!basis) return from;
        // Through the rounded basis, as the kernel takes the receivers through it.
        return {dot(widened(basis->u), from), dot(widened(basis->v), from), dot(widened(basis->dir), from)};
    }
};

// Derived in cl/fat_ray.h.
constexpr double sphere_slack = 0x1p-19, ball_slack = 0x1p-18;

/// Fills place i and returns the distance of the centre from the apex.
double fill(Bounds& b, size_t i, const View& view, const Vec3& center, double radius, double slack, int id) {
    const Vec3 from = center - view.apex, placed = view.place(from);
    const double distance = std::sqrt(dot(from, from));  // in the scene's unit (unit.h) the squares are in range
    b.x[i] = static_cast<float>(placed.x);
    b.y[i] = static_cast<float>(placed.y);
    b.z[i] = static_cast<float>(placed.z);
    b.distance[i] = rounded_up(distance);
    b.reach[i] = rounded_up(radius + std::max(distance, radius) * slack);
    b.id[i] = id;
    return distance;
}

Bounds empty() {
    Bounds b{};
    std::fill(std::begin(b.id), std::end(b.id), -1);
    return b;
}

std::vector<SphereCluster> clusters_of(const View& view, const Hierarchy& h) {
    std::vector<SphereCluster> clusters((h.order.size() + CLUSTER - 1) / CLUSTER, SphereCluster{empty(), {}, {}, {}});
    for (size_t k = 0; k < h.order.size(); ++k) {
        const Ball& s = h.spheres[k];
        SphereCluster& c = clusters[k / CLUSTER];
        const size_t i = k % CLUSTER;
        const double distance = fill(c.bounds, i, view, s.center, s.radius, sphere_slack, h.order[k]);
        const double r2 = s.radius * s.radius;
        c.r2[i] = static_cast<float>(r2);
        c.power[i] = static_cast<float>((distance - s.radius) * (distance + s.radius));
        c.form[i] = r2 < distance * distance / 2 ? FORM_SMALL : FORM_LARGE;
    }
    return clusters;
}

/// The same node with its children sorted by where they begin: since all rays leave the apex, that is the order in
/// which every ray meets them.
Bounds front_to_back(const Bounds& b) {
    int order[CLUSTER];
    std::iota(std::begin(order), std::end(order), 0);
    const auto begins = [&](int i) {
        return b.id[i] < 0 ? std::numeric_limits<float>::infinity() : b.distance[i] - b.reach[i];
    };
    std::stable_sort(std::begin(order), std::end(order), [&](int i, int j) { return begins(i) < begins(j); });
    Bounds sorted = empty();
    for (int to = 0; to < CLUSTER; ++to) {
        const int from = order[to];
        sorted.x[to] = b.x[from];
        sorted.y[to] = b.y[from];
        sorted.z[to] = b.z[from];
        sorted.distance[to] = b.distance[from];
        sorted.reach[to] = b.reach[from];
        sorted.id[to] = b.id[from];
    }
    return sorted;
}

/// The nodes over one level's balls; their children are numbered from `first_child` on.
void add_nodes(std::vector<Bounds>& nodes, const View& view, const std::vector<Ball>& balls, int first_child) {
    for (size_t first = 0; first < balls.size(); first += CLUSTER) {
        Bounds node = empty();
        for (size_t i = 0; i < CLUSTER && first + i < balls.size(); ++i)
            fill(node, i, view, balls[first + i].center, balls[first + i].radius, ball_slack,
                 first_child + static_cast<int>(first + i));
        nodes.push_back(view.basis ? node : front_to_back(node));
    }
}

PencilSpheres seen(const View& view, const Hierarchy& h) {
    PencilSpheres result;
    result.clusters = clusters_of(view, h);
    result.levels = static_cast<int>(h.levels.size());
    int first_child = 0;  // of the lowest level: clusters
    for (const std::vector<Ball>& balls : h.levels) {
        const int first_node = static_cast<int>(result.nodes.size());
        add_nodes(result.nodes, view, balls, first_child);
        first_child = first_node;
    }
    return result;
}

}  // namespace

PencilSpheres seen_from_eye(const Camera& camera, const Hierarchy& hierarchy) { return seen({camera.eye}, hierarchy); }

PencilSpheres seen_along(const ParallelPencil& pencil, const Camera& camera, const Hierarchy& hierarchy) {
    return seen({camera.eye, &pencil}, hierarchy);
}

PencilSpheres seen_from_point(const PointPencil& pencil, const Camera& camera, const Hierarchy& hierarchy) {
    // The light is where the kernel's float says it is, for spheres and receivers alike.
    return seen({camera.eye + widened(pencil.origin)}, hierarchy);
}

}  // namespace gnomon
