#include "crowd.h"

#include <cmath>

namespace bench {

using namespace gnomon;

namespace {

constexpr int64_t most_singles = 1000;
constexpr double pi = 3.14159265358979323846;

}  // namespace

Crowd::Crowd(int64_t expected, int columns) : columns_(columns) {
    rows_->reserve(static_cast<size_t>(expected * columns));
}

void Crowd::add(const Sphere& s) {
    const double row[] = {s.center.x, s.center.y, s.center.z, s.radius, s.albedo.r, s.albedo.g, s.albedo.b};
    for (int i = 0; i < columns_; ++i) rows_->push_back(static_cast<float>(row[i]));
}

void Crowd::move_to(Scene& scene) {
    const SphereTable table{rows_, rows_->data(), count(), columns_, {0.55, 0.55, 0.55}};
    if (table.count > most_singles) {
        scene.tables.push_back(table);
    } else {
        for (int64_t row = 0; row < table.count; ++row) scene.spheres.push_back(table[row]);
    }
    rows_ = std::make_shared<std::vector<float>>();
}

double mean_radius(const Cloud& cloud, int64_t count) {
    // The mean of r^3, uniform from 0.5 to 1.5 r0, is 1.25 r0^3.
    const double volume = cloud.fill * cloud.side * cloud.side * cloud.side;
    return std::cbrt(volume / (static_cast<double>(count) * 1.25 * 4 / 3 * pi));
}

void add_cloud(Crowd& crowd, const Cloud& cloud, int64_t count, Random& random) {
    const double half = cloud.side / 2, r0 = mean_radius(cloud, count);
    const Vec3 corner{half, half, half};
    for (const int64_t wanted = crowd.count() + count; crowd.count() < wanted;) {
        const Sphere sphere = random.sphere(cloud.center - corner, cloud.center + corner, 0.5 * r0, 1.5 * r0);
        if (cloud.hole && length(sphere.center - *cloud.hole) < 3 * r0) continue;
        crowd.add(sphere);
    }
}

}  // namespace bench
