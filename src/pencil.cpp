#include "pencil.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>

namespace gnomon {

namespace {

constexpr double pi = 3.14159265358979323846;

Float3 rounded(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Vec3 widened(const Float3& v) { return {v.x, v.y, v.z}; }

/// The smallest float that is not below v, give or take the rounding of v itself (2^-53, far inside the bounds of
/// fat_ray.h).
float rounded_up(double v) {
    const float f = static_cast<float>(v);
    return f < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// Collects spheres in clusters of 16.
class Clusters {
  public:
    explicit Clusters(size_t spheres) : clusters_((spheres + CLUSTER - 1) / CLUSTER, SphereCluster{}) {}

    /// A sphere whose centre lies at `center` from the apex; the kernels are told that it lies at `placed`.
    void add(const Vec3& center, double radius, int id, const Vec3& placed) {
        SphereCluster& c = clusters_[count_ / CLUSTER];
        const size_t i = count_++ % CLUSTER;
        const Float3 p = rounded(placed);
        const double distance = length(center);
        c.x[i] = p.x;
        c.y[i] = p.y;
        c.z[i] = p.z;
        c.r2[i] = static_cast<float>(radius * radius);
        c.power[i] = static_cast<float>((distance - radius) * (distance + radius));
        c.form[i] = radius * radius < distance * distance / 2 ? FORM_SMALL : FORM_LARGE;
        c.distance[i] = rounded_up(distance);
        c.reach[i] = rounded_up(radius + std::max(distance, radius) * 0x1p-19);  // derived in cl/fat_ray.h
        c.id[i] = id;
    }
    std::vector<SphereCluster> take() { return std::move(clusters_); }

  private:
    std::vector<SphereCluster> clusters_;
    size_t count_ = 0;
};

std::vector<SphereCluster> spheres_from(const Vec3& apex, const Scene& scene, const std::vector<int>& ids) {
    Clusters clusters(ids.size());
    for (const int id : ids) {
        const Sphere& sphere = scene.spheres[static_cast<size_t>(id)];
        clusters.add(sphere.center - apex, sphere.radius, id, sphere.center - apex);
    }
    return clusters.take();
}

/// Hash and equality of centre and radius, for the spheres behind a vector's indices.
struct Geometry {
    const std::vector<Sphere>& spheres;

    size_t operator()(int id) const {
        const Sphere& s = spheres[static_cast<size_t>(id)];
        size_t h = 0;
        for (const double v : {s.center.x, s.center.y, s.center.z, s.radius})
            h = (h ^ std::hash<double>()(v)) * 0x9E3779B97F4A7C15u;  // 2^64 / golden ratio: Knuth's multiplicative hash
        return h ^ h >> 32;
    }
    bool operator()(int a, int b) const {
        const Sphere &s = spheres[static_cast<size_t>(a)], &t = spheres[static_cast<size_t>(b)];
        return s.center.x == t.center.x && s.center.y == t.center.y && s.center.z == t.center.z && s.radius == t.radius;
    }
};

}  // namespace

EyePencil eye_pencil(const Camera& camera, const ImageSize& image) {
    const Vec3 z = normalize(camera.at - camera.eye), x = normalize(cross(camera.up, z)), y = cross(z, x);
    const double half_height = std::tan(camera.fov * pi / 360);  // of the image plane at distance 1
    const double half_pixel = half_height / image.height;
    return {rounded(z), rounded(x * half_pixel), rounded(y * half_pixel), image.width, image.height};
}

ParallelPencil parallel_pencil(const DirectionalLight& light) {
    const Vec3 dir = normalize(light.direction_to_light);
    const Vec3 other = std::fabs(dir.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};  // at least 30 degrees off dir
    const Vec3 u = normalize(cross(other, dir)), v = cross(dir, u);
    return {rounded(u), rounded(v), rounded(dir)};
}

PointPencil point_pencil(const PointLight& light, const Camera& camera) {
    return {rounded(light.position - camera.eye)};
}

Float3 lambert_factor(const DirectionalLight& light) {
    const Rgb& e = light.irradiance;
    return rounded(Vec3{e.r, e.g, e.b} * (1 / pi));
}

Float3 lambert_factor(const PointLight& light) {
    const Rgb& p = light.power;
    return rounded(Vec3{p.r, p.g, p.b} * (1 / (4 * pi * pi)));
}

std::vector<int> distinct_spheres(const std::vector<Sphere>& spheres) {
    const Geometry geometry{spheres};
    std::unordered_set<int, Geometry, Geometry> known(spheres.size() * 2, geometry, geometry);
    std::vector<int> ids;
    for (int id = 0; id < static_cast<int>(spheres.size()); ++id)
        if (known.insert(id).second) ids.push_back(id);
    return ids;
}

std::vector<SphereCluster> spheres_from_eye(const Scene& scene, const std::vector<int>& ids) {
    return spheres_from(scene.camera.eye, scene, ids);
}

std::vector<SphereCluster> spheres_from_point(const PointPencil& pencil, const Scene& scene,
                                              const std::vector<int>& ids) {
    // The light is where the kernel's float says it is, for spheres and receivers alike.
    return spheres_from(scene.camera.eye + widened(pencil.origin), scene, ids);
}

std::vector<SphereCluster> spheres_along(const ParallelPencil& pencil, const Scene& scene,
                                         const std::vector<int>& ids) {
    const Vec3 u = widened(pencil.u), v = widened(pencil.v), dir = widened(pencil.dir);
    Clusters clusters(ids.size());
    for (const int id : ids) {
        const Sphere& sphere = scene.spheres[static_cast<size_t>(id)];
        const Vec3 center = sphere.center - scene.camera.eye;
        // Through the rounded basis, as the kernel takes the receivers through it.
        clusters.add(center, sphere.radius, id, {dot(u, center), dot(v, center), dot(dir, center)});
    }
    return clusters.take();
}

}  // namespace gnomon
