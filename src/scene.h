// What to render: plain data, in double, in the scene file's own units.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "vec.h"

namespace gnomon {

/// Linear red, green, blue.
struct Rgb {
    double r = 0, g = 0, b = 0;
};

struct ImageSize {
    int width = 1024, height = 768;  ///< pixels
};

/// A pinhole. `at` is a point; `fov` is vertical, in degrees.
struct Camera {
    Vec3 eye, at{0, 0, 1}, up{0, 1, 0};
    double fov = 60;
};

struct Sphere {
    Vec3 center;
    double radius = 1;
    Rgb albedo{1, 1, 1};  ///< the reflected share of the light that arrives, Lambert
};

/// Parallel light; `direction_to_light` need not be a unit vector. Irradiance on a facing surface, power per area.
struct DirectionalLight {
    Vec3 direction_to_light;
    Rgb irradiance;
};

/// Light from one point, the same in all directions: power / (4 pi d^2) arrives at distance d.
struct PointLight {
    Vec3 position;
    Rgb power;
};

using Light = std::variant<DirectionalLight, PointLight>;

/// A sphere's id is its index; lights add up in their order.
struct Scene {
    ImageSize image;
    Camera camera;
    std::vector<Sphere> spheres;
    std::vector<Light> lights;
    std::string sha1;  ///< of the file it was read from, 40 hex digits; empty for a scene made in memory
};

}  // namespace gnomon
