// What to render: plain data, in double, in the scene file's own units.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
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

/// Many spheres, as a file or a simulation keeps them: rows of 4 numbers, x y z radius, or of 7, with the albedo's red,
/// green and blue. Its numbers are those of Sphere.
struct SphereTable {
    std::shared_ptr<const void> owner;  ///< what the rows lie in and live as long as: a vector, a file that is mapped
    std::variant<const float*, const double*> rows;
    int64_t count = 0;
    int columns = 4;      ///< 4 or 7
    Rgb albedo{1, 1, 1};  ///< of all, when rows have 4 columns
    /// May be called when `count` rows from `first` on were read and will not be for a while: their memory can go to
    /// others. Empty for rows that are nowhere else.
    std::function<void(int64_t first, int64_t count)> forget = {};

    Sphere operator[](size_t row) const;
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

/// A sphere's id is its index, counted through `spheres` and then through the tables; lights add up in their order.
struct Scene {
    ImageSize image;
    Camera camera;
    std::vector<Sphere> spheres;
    std::vector<SphereTable> tables;
    std::vector<Light> lights;
    std::string sha1;  ///< of the file it was read from, 40 hex digits; empty for a scene made in memory
};

/// How many spheres there are in all.
int64_t sphere_count(const Scene& scene);
/// The sphere with this id, 0 <= id < sphere_count(scene).
Sphere sphere_of(const Scene& scene, int64_t id);

/// Calls visit(id, sphere) for the spheres with ids from `first` on, in their order.
template <class Visit>
void for_each_sphere(const Scene& scene, int64_t first, int64_t count, Visit visit) {
    int64_t id = 0;
    const int64_t end = first + count;
    const auto some = [&](const auto& spheres, int64_t size) {
        for (int64_t i = first > id ? first - id : 0; i < size && id + i < end; ++i)
            visit(id + i, spheres[static_cast<size_t>(i)]);
        id += size;
    };
    some(scene.spheres, static_cast<int64_t>(scene.spheres.size()));
    for (const SphereTable& table : scene.tables) some(table, table.count);
}
template <class Visit>
void for_each_sphere(const Scene& scene, Visit visit) {
    for_each_sphere(scene, 0, sphere_count(scene), visit);
}

}  // namespace gnomon
