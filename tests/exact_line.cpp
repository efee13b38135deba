#include "exact_line.h"

#include <cmath>
#include <limits>

#include "quick_interval.h"

namespace gnomon::oracle {

namespace {

template <class Real>
Real square(const Real& x) {
    return x * x;
}

template <class Real>
Real power_of(const Vector<Real>& point, const Sphere& sphere) {
    const Vector<Real> way = point - Vector<Real>(sphere.center);
    return dot(way, way) - square(Real(sphere.radius));
}

/// Which of the two roots, where there are any, are > 0 as seen from a point of this power.
struct Ahead {
    bool any, both;
};
template <class Real>
Ahead ahead(const Real& middle, const Real& power) {
    const int side = sign(power);
    const bool forward = side < 0 || sign(middle) > 0;
    return {forward, forward && side > 0};
}

}  // namespace

Line<Interval> line_of(const Ray& ray) { return {Vector<Interval>(ray.origin), unit(Vector<Interval>(ray.dir))}; }

Pinhole<Interval> pinhole_of(const Scene& scene) {
    using V = Vector<Interval>;
    const Camera& camera = scene.camera;
    const V z = unit(V(camera.at) - V(camera.eye)), x = unit(cross(V(camera.up), z));
    const Interval half_pixel = tan(Interval(camera.fov) * pi() / 360) / scene.image.height;
    return {V(camera.eye), x * half_pixel, cross(z, x) * half_pixel, z, scene.image};
}

// Offsets are odd whole numbers of half pixels, of which the image is 2 height high.
template <class Real>
Line<Real> Pinhole<Real>::line(int i, int j) const {
    const double right = 2 * i + 1 - image.width, up = image.height - 2 * j - 1;
    return {eye, unit(x * Real(right) + y * Real(up) + z)};
}

// The discriminant, middle^2 - power, is r^2 - |f x dir|^2 too (Lagrange's identity), with f the centre as seen from
// the origin: of a sphere that looks small, doubles know more by that.
template <class Real>
Quadratic<Real>::Quadratic(const Line<Real>& line, const Sphere& sphere)
    : middle(dot(Vector<Real>(sphere.center) - line.origin, line.dir)),
      power(power_of(line.origin, sphere)),
      discriminant(narrower(Real(square(middle) - power), [&] {
          const Vector<Real> across = cross(Vector<Real>(sphere.center) - line.origin, line.dir);
          return square(Real(sphere.radius)) - dot(across, across);
      })) {}

template <class Real>
std::optional<Real> first_root(const Quadratic<Real>& q) {
    const Ahead roots = ahead(q.middle, q.power);
    if (!roots.any || sign(q.discriminant) < 0) return {};
    const Real half = root(q.discriminant);
    return roots.both ? q.middle - half : q.middle + half;
}

template <class Real>
bool blocks(const Line<Real>& line, const Sphere& sphere) {
    const Quadratic q(line, sphere);
    return ahead(q.middle, q.power).any && sign(q.discriminant) >= 0;
}
// Seen from the light, t runs the other way.
template <class Real>
bool blocks(const Line<Real>& line, const Sphere& sphere, const Vector<Real>& light, const Real& distance) {
    const Quadratic q(line, sphere);
    const Ahead here = ahead(q.middle, q.power);
    if (!here.any || sign(q.discriminant) < 0) return false;
    const Ahead there = ahead(Real(distance - q.middle), power_of(light, sphere));
    return (here.both && there.any) || there.both;
}

template <class Real>
Sight::Sight(const Line<Real>& line)
    : origin_(known(line.origin, Real(abs(line.origin.x) + abs(line.origin.y) + abs(line.origin.z)))),
      dir_(known(line.dir, Real(1))) {}

bool Sight::may_meet(const Sphere& sphere, double distance) const {
    const Vec3 f = sphere.center - origin_.value;
    const double far = length(f);
    const double error = 0x1p-48 * (length(origin_.value) + far) + 2 * (origin_.off + dir_.off * far) +
                         std::numeric_limits<double>::min();
    const double across = length(cross(f, dir_.value)), along = dot(f, dir_.value), reach = sphere.radius + error;
    if (!std::isfinite(across) || !std::isfinite(along)) return true;
    return across <= reach && along >= -reach && along <= distance + reach;
}

// For each of the two kinds of intervals.
#define FOR_INTERVALS(Real)                                                                   \
    template struct Pinhole<Real>;                                                            \
    template struct Quadratic<Real>;                                                          \
    template std::optional<Real> first_root(const Quadratic<Real>&);                          \
    template bool blocks(const Line<Real>&, const Sphere&);                                   \
    template bool blocks(const Line<Real>&, const Sphere&, const Vector<Real>&, const Real&); \
    template Sight::Sight(const Line<Real>&);
FOR_INTERVALS(Interval)
FOR_INTERVALS(QuickInterval)
#undef FOR_INTERVALS

}  // namespace gnomon::oracle
