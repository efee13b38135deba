#include "pencil.h"

#include <cmath>

namespace gnomon {

namespace {

constexpr double pi = 3.14159265358979323846;

Float3 rounded(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

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

}  // namespace gnomon
