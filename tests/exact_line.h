// A line and a sphere in exact arithmetic (interval.h): where they meet, and what blocks the way to a light.
#pragma once

#include <optional>

#include "interval.h"
#include "oracle.h"

namespace gnomon::oracle {

struct Line {
    Vector origin, dir;  // dir has unit length
};
Line line_of(const Ray& ray);
/// Through the centre of pixel (i, j).
Line line_of(const Scene& scene, int i, int j);

/// What is known of a line and a sphere: it meets the sphere at the roots of t^2 - 2 middle t + power = 0.
struct Quadratic {
    Interval middle, power, discriminant;

    Quadratic(const Line& line, const Sphere& sphere);
};

/// The smallest root > 0.
std::optional<Interval> first_root(const Quadratic& q);

/// Whether the line meets the surface at t > 0, and, for the second, before the light that stands on it at `distance`.
bool blocks(const Line& line, const Sphere& sphere);
bool blocks(const Line& line, const Sphere& sphere, const Vector& light, const Interval& distance);

/// A line in double, which tells far spheres apart from those that intervals must look at.
///
/// With u = 2^-53, lengths |.| and the sphere's centre f as seen from the origin: the origin is off by 2 u |origin|, f
/// by that and the difference's rounding u |f|, the direction by 2 u. So f . dir and f x dir are off by 2 u |origin| +
/// (1 + 2) u |f|, their own roundings (3 sqrt(3) u |f|), and the length's (2 u |f|): all below 16 u (|origin| + |f|).
/// Twice that is generous; the smallest normal number stands for underflow, and what overflows is kept.
class Sight {
  public:
    explicit Sight(const Line& line);
    /// False only if the sphere does not meet the ray before `distance`.
    bool may_meet(const Sphere& sphere, double distance) const;

  private:
    Vec3 origin_, dir_;
};

}  // namespace gnomon::oracle
