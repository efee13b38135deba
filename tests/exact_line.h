// A line and a sphere in exact arithmetic: where they meet, and what blocks the way to a light. Real is an interval, of
// many digits (interval.h) or between doubles (quick_interval.h).
#pragma once

#include <optional>

#include "interval.h"
#include "oracle.h"

namespace gnomon::oracle {

template <class Real>
struct Line {
    Vector<Real> origin, dir;  // dir has unit length
};
Line<Interval> line_of(const Ray& ray);

/// What makes rays through pixels of an image: the camera's basis, x and y of half a pixel's length in the plane z = 1.
template <class Real>
struct Pinhole {
    Vector<Real> eye, x, y, z;
    ImageSize image;

    /// Through the centre of pixel (i, j).
    Line<Real> line(int i, int j) const;
};
Pinhole<Interval> pinhole_of(const Scene& scene);

/// What is known of a line and a sphere: it meets the sphere at the roots of t^2 - 2 middle t + power = 0.
template <class Real>
struct Quadratic {
    Real middle, power, discriminant;

    Quadratic(const Line<Real>& line, const Sphere& sphere);
};

/// The smallest root > 0.
template <class Real>
std::optional<Real> first_root(const Quadratic<Real>& q);

/// Whether the line meets the surface at t > 0, and, for the second, before the light that stands on it at `distance`.
template <class Real>
bool blocks(const Line<Real>& line, const Sphere& sphere);
template <class Real>
bool blocks(const Line<Real>& line, const Sphere& sphere, const Vector<Real>& light, const Real& distance);

/// A line in double, which tells far spheres apart from those that intervals must look at.
///
/// With u = 2^-53, lengths |.| and the sphere's centre f as seen from the origin: the origin is off by 2 u |origin|, f
/// by that and the difference's rounding u |f|, the direction by 2 u. So f . dir and f x dir are off by 2 u |origin| +
/// (1 + 2) u |f|, their own roundings (3 sqrt(3) u |f|), and the length's (2 u |f|): all below 16 u (|origin| + |f|).
/// Twice that is generous; the smallest normal number stands for underflow, and what overflows is kept. What an origin
/// or a direction, not known better, is off in addition counts twice too.
class Sight {
  public:
    template <class Real>
    explicit Sight(const Line<Real>& line);
    /// False only if the sphere does not meet the ray before `distance`.
    bool may_meet(const Sphere& sphere, double distance) const;

  private:
    Known origin_, dir_;
};

}  // namespace gnomon::oracle
