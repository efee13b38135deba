#include "survey.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <vector>

#include "rounding.h"

namespace gnomon {

namespace {

/// The box, the largest radius and exactness of some rows, in the type in which they are stored.
template <class Number>
struct Part {
    static constexpr Number infinity = std::numeric_limits<Number>::infinity();
    Number low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity}, radius = 0;
    bool floats = true;

    void add(Number x, Number y, Number z, Number r) {
        const Number p[] = {x, y, z};
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
        radius = std::max(radius, r);
        if constexpr (sizeof(Number) > sizeof(float))
            floats = floats && is_float(x) && is_float(y) && is_float(z) && is_float(r);
    }
};

template <class Number>
void include(Survey& s, const Part<Number>& part, int64_t count) {
    if (count == 0) return;
    const Vec3 low{part.low[0], part.low[1], part.low[2]}, high{part.high[0], part.high[1], part.high[2]};
    const bool first = s.count == 0;
    s.low = first ? low : Vec3{std::min(s.low.x, low.x), std::min(s.low.y, low.y), std::min(s.low.z, low.z)};
    s.high = first ? high : Vec3{std::max(s.high.x, high.x), std::max(s.high.y, high.y), std::max(s.high.z, high.z)};
    s.largest_radius = std::max<double>(s.largest_radius, part.radius);
    s.floats = s.floats && part.floats;
    s.count += count;
}

template <class Number>
Part<Number> part_of(const Number* rows, int columns, int64_t count) {
    Part<Number> part;
    for (const Number *row = rows, *end = rows + count * columns; row != end; row += columns)
        part.add(row[0], row[1], row[2], row[3]);
    return part;
}

/// In two halves, at once where there are many: a pass over 10^7 rows takes 20 ms.
template <class Number>
void include_table(Survey& s, const Number* rows, int columns, int64_t count) {
    constexpr int64_t worth_a_thread = 1 << 16;
    const int64_t half = count < worth_a_thread ? 0 : count / 2;
    auto first =
        std::async(half > 0 ? std::launch::async : std::launch::deferred, part_of<Number>, rows, columns, half);
    const Part<Number> second = part_of(rows + half * columns, columns, count - half);
    include(s, first.get(), half);
    include(s, second, count - half);
}

double middle_radius(const Scene& scene, int64_t count) {
    constexpr int64_t most = 1001;
    const int64_t sample = std::min(count, most);
    std::vector<double> radii;
    for (int64_t i = 0; i < sample; ++i) radii.push_back(sphere_of(scene, i * count / sample).radius);
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    return *middle;
}

/// An upper bound of how far spheres reach from the eye.
double reach(const Survey& s, const Vec3& eye) {
    const auto farther = [](double low, double high, double e) {
        return std::max(std::fabs(low - e), std::fabs(high - e));
    };
    return length({farther(s.low.x, s.high.x, eye.x), farther(s.low.y, s.high.y, eye.y),
                   farther(s.low.z, s.high.z, eye.z)}) +
           s.largest_radius;
}

}  // namespace

Survey survey(const Scene& scene) {
    Survey s;
    Part<double> part;
    for (const Sphere& sphere : scene.spheres)
        part.add(sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius);
    include(s, part, static_cast<int64_t>(scene.spheres.size()));
    for (const SphereTable& table : scene.tables)
        std::visit([&](const auto* rows) { include_table(s, rows, table.columns, table.count); }, table.rows);
    s.one_albedo = scene.spheres.empty() && scene.tables.size() == 1 && scene.tables.front().columns == 4;
    if (s.count > 0) s.middle_radius = middle_radius(scene, s.count);
    return s;
}

Frame choose_frame(const Scene& scene, const Survey& survey) {
    Frame frame;
    if (survey.count == 0) return frame;
    const double farthest = reach(survey, scene.camera.eye);
    const bool in_range = farthest >= 0x1p-20 && farthest <= 0x1p40;
    if (in_range && survey.floats) return frame;
    frame.floats = false;
    frame.origin = survey.low * 0.5 + survey.high * 0.5;
    if (!in_range) frame.unit = std::ldexp(1.0, std::ilogb(farthest));
    return frame;
}

}  // namespace gnomon
