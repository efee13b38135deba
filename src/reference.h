// What the picture should be: double precision, every sphere against every ray, the textbook quadratic a t^2 + b t + c
// in world coordinates, and a camera made of its image plane's corners. It shares no formula with the kernels: tests
// hold them against it, and so does every rendering that reports a speed (check.h).
#pragma once

#include <vector>

#include "scene.h"

namespace gnomon::reference {

struct Ray {
    Vec3 origin, dir;  // dir has unit length
};

struct Hit {
    double t;  // infinity for a miss
    int id;    // -1 for a miss
    Vec3 position, normal;
};

/// Roots of |origin + t dir - center| = radius in ascending order; `real` is false when there are none.
struct Roots {
    bool real;
    double near, far;
    double discriminant;  // b^2 - 4 a c
};
Roots intersect(const Ray& ray, const Sphere& sphere);

/// The ray through the centre of pixel (i, j), row 0 at the top.
Ray eye_ray(const Scene& scene, int i, int j);

/// Smallest t > 0; of equal t the lowest id.
Hit closest_hit(const Scene& scene, const Ray& ray);

/// Whether anything but the hit sphere itself (or one that coincides with it) lies between the hit and the light.
bool in_between(const Scene& scene, const Hit& hit, const Light& light);

/// n . l, unit vectors; the light's direction from a surface point.
double cosine(const Hit& hit, const Light& light);

/// One light's Lambert term, without regard to shadows.
Rgb lambert(const Scene& scene, const Hit& hit, const Light& light);

/// The sum over all lights.
Rgb radiance(const Scene& scene, const Hit& hit, bool shadows);

}  // namespace gnomon::reference
