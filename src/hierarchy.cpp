#include "hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace gnomon {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An axis-parallel box.
struct Box {
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    void add(const Vec3& center, double radius) {
        low = {std::min(low.x, center.x - radius), std::min(low.y, center.y - radius),
               std::min(low.z, center.z - radius)};
        high = {std::max(high.x, center.x + radius), std::max(high.y, center.y + radius),
                std::max(high.z, center.z + radius)};
    }
    Vec3 center() const { return (low + high) * 0.5; }
};

/// Spreads the low 20 bits of v to every third bit.
uint64_t spread(uint64_t v) {
    v = (v | v << 32) & 0x000F00000000FFFF;
    v = (v | v << 16) & 0x000F0000FF0000FF;
    v = (v | v << 8) & 0x000F00F00F00F00F;
    v = (v | v << 4) & 0x00C30C30C30C30C3;
    return (v | v << 2) & 0x0249249249249249;
}

/// Places along Morton's curve through a box, 20 bits an axis.
class Curve {
  public:
    explicit Curve(const Box& box) : low_(box.low) {
        const Vec3 size = box.high - box.low;
        const double side = std::max({size.x, size.y, size.z});
        scale_ = side > 0 ? ((1 << 20) - 1) / side : 0;
    }
    uint64_t key(const Vec3& p) const { return axis(p.x - low_.x) | axis(p.y - low_.y) << 1 | axis(p.z - low_.z) << 2; }

  private:
    uint64_t axis(double offset) const { return spread(static_cast<uint64_t>(offset * scale_)); }

    Vec3 low_;
    double scale_;
};

/// Spheres much larger than most would spoil the balls of their small neighbours: they come after them, by factors
/// of 64.
uint64_t size_class(double radius, double median) {
    if (radius <= 8 * median) return 0;
    return 1 + static_cast<uint64_t>(std::log2(radius / (8 * median)) / 6);
}

double median_radius(const std::vector<Sphere>& spheres) {
    std::vector<double> radii;
    radii.reserve(spheres.size());
    for (const Sphere& s : spheres) radii.push_back(s.radius);
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    return *middle;
}

using Keyed = std::pair<uint64_t, int>;

std::vector<Keyed> sorted(const std::vector<Sphere>& spheres) {
    Box box;
    for (const Sphere& s : spheres) box.add(s.center, 0);
    const Curve curve(box);
    const double median = median_radius(spheres);
    std::vector<Keyed> keys;
    keys.reserve(spheres.size());
    for (const Sphere& s : spheres)
        keys.emplace_back(std::min<uint64_t>(size_class(s.radius, median), 15) << 60 | curve.key(s.center),
                          static_cast<int>(keys.size()));
    std::sort(keys.begin(), keys.end());
    return keys;
}

auto geometry(const Sphere& s) { return std::tie(s.center.x, s.center.y, s.center.z, s.radius); }

/// Spheres of equal keys brought into an order in which coincident ones are neighbours, the lowest id first, and
/// without the others.
std::vector<int> distinct(const std::vector<Sphere>& spheres, std::vector<Keyed> keys) {
    const auto of = [&](const Keyed& k) -> const Sphere& { return spheres[static_cast<size_t>(k.second)]; };
    const auto before = [&](const Keyed& a, const Keyed& b) {
        return std::tuple_cat(geometry(of(a)), std::tie(a.second)) <
               std::tuple_cat(geometry(of(b)), std::tie(b.second));
    };
    std::vector<int> order;
    order.reserve(keys.size());
    for (auto first = keys.begin(); first != keys.end();) {
        const auto end = std::find_if(first, keys.end(), [&](const Keyed& k) { return k.first != first->first; });
        if (end - first > 1) std::sort(first, end, before);
        for (auto k = first; k != end; ++k)
            if (k == first || geometry(of(*k)) != geometry(of(*(k - 1)))) order.push_back(k->second);
        first = end;
    }
    return order;
}

/// One ball around each 16.
std::vector<Ball> around(const std::vector<Ball>& balls) {
    std::vector<Ball> result;
    result.reserve((balls.size() + CLUSTER - 1) / CLUSTER);
    for (size_t first = 0; first < balls.size(); first += CLUSTER) {
        const size_t end = std::min(first + CLUSTER, balls.size());
        Box box;
        for (size_t i = first; i < end; ++i) box.add(balls[i].center, balls[i].radius);
        Ball outer{box.center(), 0};
        for (size_t i = first; i < end; ++i) {
            const Vec3 off = balls[i].center - outer.center;
            outer.radius = std::max(outer.radius, std::sqrt(dot(off, off)) + balls[i].radius);
        }
        result.push_back(outer);
    }
    return result;
}

}  // namespace

Hierarchy build_hierarchy(const std::vector<Sphere>& spheres) {
    Hierarchy h;
    if (spheres.empty()) return h;
    h.order = distinct(spheres, sorted(spheres));
    h.spheres.reserve(h.order.size());
    for (const int id : h.order) {
        const Sphere& s = spheres[static_cast<size_t>(id)];
        h.spheres.push_back({s.center, s.radius});
    }
    if (h.order.size() <= flat_spheres) return h;
    h.levels.push_back(around(h.spheres));
    while (h.levels.back().size() > CLUSTER) h.levels.push_back(around(h.levels.back()));
    return h;
}

}  // namespace gnomon
