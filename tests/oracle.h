// The picture as it is: every decision of a pixel, exactly, by intervals of as many digits as it takes (interval.h). It
// rounds nothing, and so needs no formula but the textbook's; it shares no code with the kernels and src/reference.
//
// What is true is what real numbers say about the scene's doubles: rays through the pixels' centres with
// x_c = up x z_c, y_c = z_c x x_c and the vertical field of view in degrees, row 0 at the top; the smallest root t > 0
// (from inside a sphere, or on it, the far one); a line that touches a sphere meets it; the lowest id wins a tie, and
// spheres that coincide count as the one with the lowest id. A surface is lit where n . l > 0 and no other sphere's
// surface meets the ray to the light at t > 0, and for a point light before it. What is at a light is not lit.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "scene.h"

namespace gnomon::oracle {

/// From `origin` along `dir`, which need not have unit length: t is a distance all the same.
struct Ray {
    Vec3 origin, dir;
};

/// Where a ray first meets spheres. Numbers are within 2^-52 of the truth: t relative to itself, the normal's
/// components relative to 1.
struct Hit {
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    int64_t id = -1;                            ///< -1 for a miss
    double t = infinity;                        ///< in units of the scene
    Vec3 normal{infinity, infinity, infinity};  ///< outward, unit length
    double condition = 0;                       ///< of t, see `condition` in oracle.cpp

    explicit operator bool() const { return id >= 0; }
};

struct Pixel {
    Hit hit;
    std::vector<bool> lit;       ///< one a light: whether anything of it arrives
    std::vector<Rgb> reflected;  ///< one a light: the radiance it adds, 0 where it does not arrive
    Rgb radiance;                ///< their sum
};

/// A pixel's decisions alone.
struct Decisions {
    int64_t id = -1;                ///< -1 for a miss
    std::vector<bool> facing, lit;  ///< one a light: n . l > 0; whether, in addition, nothing is in between
};
inline bool operator==(const Decisions& a, const Decisions& b) {
    return a.id == b.id && a.facing == b.facing && a.lit == b.lit;
}

/// A sphere, or all of them that coincide, by the lowest id.
struct Kept {
    int64_t id;
    Sphere sphere;
};

/// How a ray's line lies to a sphere: the sign of the discriminant, and of the power |origin - centre|^2 - r^2.
struct Position {
    int discriminant;  ///< -1 passes it, 0 touches it, 1 meets it twice
    int power;         ///< the origin: -1 inside, 0 on it, 1 outside
};
Position position(const Ray& ray, const Sphere& sphere);

/// The first hit of one sphere, of id 0. Spheres and rays of floats are given as they are: floats are doubles.
Hit meet(const Ray& ray, const Sphere& sphere);

/// All that is to know of one scene, which must stay as it is.
class Oracle {
  public:
    explicit Oracle(const Scene& scene);

    /// Pixel (i, j), counted from the upper left.
    Pixel look(int i, int j) const;
    /// What is seen along any ray.
    Pixel look(const Ray& ray) const;
    /// The decisions alone.
    Decisions decide(int i, int j) const;

    const std::vector<Kept>& spheres() const { return spheres_; }

  private:
    class Numbers;

    const Scene& scene_;
    std::vector<Kept> spheres_;  // one of those that coincide, by id
};

}  // namespace gnomon::oracle
