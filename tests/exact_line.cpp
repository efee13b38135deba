#include "exact_line.h"

#include <cmath>
#include <limits>

namespace gnomon::oracle {

namespace {

Interval power_of(const Vector& point, const Sphere& sphere) {
    const Vector way = point - Vector(sphere.center);
    return dot(way, way) - Interval(sphere.radius) * sphere.radius;
}

/// Which of the two roots, where there are any, are > 0 as seen from a point of this power.
struct Ahead {
    bool any, both;
};
Ahead ahead(const Interval& middle, const Interval& power) {
    const int side = sign(power);
    const bool forward = side < 0 || sign(middle) > 0;
    return {forward, forward && side > 0};
}

}  // namespace

Line line_of(const Ray& ray) { return {Vector(ray.origin), unit(Vector(ray.dir))}; }

// Offsets are odd whole numbers of half pixels, of which the image is 2 height high.
Line line_of(const Scene& scene, int i, int j) {
    const Camera& camera = scene.camera;
    const Vector z = unit(Vector(camera.at) - Vector(camera.eye)), x = unit(cross(Vector(camera.up), z));
    const Vector y = cross(z, x);
    const Interval half_pixel = tan(Interval(camera.fov) * pi() / 360) / scene.image.height;
    const int right = 2 * i + 1 - scene.image.width, up = scene.image.height - 2 * j - 1;
    return {Vector(camera.eye), unit(x * (half_pixel * right) + y * (half_pixel * up) + z)};
}

Quadratic::Quadratic(const Line& line, const Sphere& sphere)
    : middle(dot(Vector(sphere.center) - line.origin, line.dir)),
      power(power_of(line.origin, sphere)),
      discriminant(middle * middle - power) {}

std::optional<Interval> first_root(const Quadratic& q) {
    const Ahead roots = ahead(q.middle, q.power);
    if (!roots.any || sign(q.discriminant) < 0) return {};
    const Interval half = root(q.discriminant);
    return roots.both ? q.middle - half : q.middle + half;
}

bool blocks(const Line& line, const Sphere& sphere) {
    const Quadratic q(line, sphere);
    return ahead(q.middle, q.power).any && sign(q.discriminant) >= 0;
}
// Seen from the light, t runs the other way.
bool blocks(const Line& line, const Sphere& sphere, const Vector& light, const Interval& distance) {
    const Quadratic q(line, sphere);
    const Ahead here = ahead(q.middle, q.power);
    if (!here.any || sign(q.discriminant) < 0) return false;
    const Ahead there = ahead(distance - q.middle, power_of(light, sphere));
    return (here.both && there.any) || there.both;
}

Sight::Sight(const Line& line) : dir_(nearest(line.dir)) {
    const Vector& o = line.origin;
    const Interval scale = abs(o.x) + abs(o.y) + abs(o.z);
    origin_ = {nearest(o.x, scale), nearest(o.y, scale), nearest(o.z, scale)};
}

bool Sight::may_meet(const Sphere& sphere, double distance) const {
    const Vec3 f = sphere.center - origin_;
    const double error = 0x1p-48 * (length(origin_) + length(f)) + std::numeric_limits<double>::min();
    const double across = length(cross(f, dir_)), along = dot(f, dir_), reach = sphere.radius + error;
    if (!std::isfinite(across) || !std::isfinite(along)) return true;
    return across <= reach && along >= -reach && along <= distance + reach;
}

}  // namespace gnomon::oracle
