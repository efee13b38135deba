#include "reference.h"

#include <cmath>
#include <limits>

namespace gnomon::reference {

namespace {

const double pi = std::acos(-1.0);
const double infinity = std::numeric_limits<double>::infinity();

double norm(const Vec3& v) { return std::sqrt(dot(v, v)); }
Vec3 unit(const Vec3& v) { return v * (1 / norm(v)); }

bool coincide(const Sphere& a, const Sphere& b) { return norm(a.center - b.center) == 0 && a.radius == b.radius; }

/// The way from a point to a light: direction, and how far the light is.
Ray toward(const Vec3& position, const Light& light, double& distance) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
        const Vec3 way = point->position - position;
        distance = norm(way);
        return {position, unit(way)};
    }
    distance = infinity;
    return {position, unit(std::get<DirectionalLight>(light).direction_to_light)};
}

}  // namespace

Roots intersect(const Ray& ray, const Sphere& sphere) {
    const Vec3 from_center = ray.origin - sphere.center;
    const double a = dot(ray.dir, ray.dir), b = 2 * dot(from_center, ray.dir);
    const double c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {false, infinity, infinity, discriminant};
    const double root = std::sqrt(discriminant);
    return {true, (-b - root) / (2 * a), (-b + root) / (2 * a), discriminant};
}

Ray eye_ray(const Scene& scene, int i, int j) {
    const Camera& camera = scene.camera;
    const Vec3 ahead = unit(camera.at - camera.eye);
    const Vec3 side = unit(cross(camera.up, ahead)), above = cross(ahead, side);
    const double top = std::tan(camera.fov / 2 * pi / 180), edge = top * scene.image.width / scene.image.height;
    const Vec3 corner = ahead - side * edge + above * top;  // of the image, upper left
    const Vec3 across = side * (2 * edge), down = above * (-2 * top);
    const Vec3 point = corner + across * ((i + 0.5) / scene.image.width) + down * ((j + 0.5) / scene.image.height);
    return {camera.eye, unit(point)};
}

Hit closest_hit(const Scene& scene, const Ray& ray) {
    Hit hit{infinity, -1, {infinity, infinity, infinity}, {infinity, infinity, infinity}};
    for_each_sphere(scene, [&](int64_t id, const Sphere& sphere) {
        const Roots roots = intersect(ray, sphere);
        const double t = roots.near > 0 ? roots.near : roots.far;
        if (!roots.real || !(t > 0) || !(t < hit.t)) return;
        hit.t = t;
        hit.id = static_cast<int>(id);
    });
    if (hit.id < 0) return hit;
    hit.position = ray.origin + ray.dir * hit.t;
    hit.normal = unit(hit.position - sphere_of(scene, hit.id).center);
    return hit;
}

bool in_between(const Scene& scene, const Hit& hit, const Light& light) {
    double distance = 0;
    const Ray ray = toward(hit.position, light, distance);
    const Sphere own = sphere_of(scene, hit.id);
    bool found = false;
    for_each_sphere(scene, [&](int64_t, const Sphere& sphere) {
        const Roots roots = intersect(ray, sphere);
        if (!roots.real || coincide(sphere, own)) return;
        found = found || (roots.near > 0 && roots.near < distance) || (roots.far > 0 && roots.far < distance);
    });
    return found;
}

double cosine(const Hit& hit, const Light& light) {
    double distance = 0;
    return dot(hit.normal, toward(hit.position, light, distance).dir);
}

Rgb lambert(const Scene& scene, const Hit& hit, const Light& light) {
    const double c = cosine(hit, light);
    if (!(c > 0)) return {};
    double factor = c / pi;
    Rgb phi{};
    if (const auto* point = std::get_if<PointLight>(&light)) {
        const Vec3 way = point->position - hit.position;
        factor /= 4 * pi * dot(way, way);
        phi = point->power;
    } else {
        phi = std::get<DirectionalLight>(light).irradiance;
    }
    const Rgb rho = sphere_of(scene, hit.id).albedo;
    return {rho.r * phi.r * factor, rho.g * phi.g * factor, rho.b * phi.b * factor};
}

Rgb radiance(const Scene& scene, const Hit& hit, bool shadows) {
    Rgb sum{};
    if (hit.id < 0) return sum;
    for (const Light& light : scene.lights) {
        if (shadows && in_between(scene, hit, light)) continue;
        const Rgb term = lambert(scene, hit, light);
        sum = {sum.r + term.r, sum.g + term.g, sum.b + term.b};
    }
    return sum;
}

}  // namespace gnomon::reference
