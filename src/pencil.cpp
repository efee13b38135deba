#include "pencil.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>

#include "rounding.h"

namespace gnomon {

namespace {

constexpr double pi = 3.14159265358979323846;

template <class real>
Real3Of<real> rounded(const Vec3& v) {
    if constexpr (sizeof(real) == sizeof(double))
        return {v.x, v.y, v.z};
    else
        return {round_to_float(v.x), round_to_float(v.y), round_to_float(v.z)};
}
template <class real>
Vec3 widened(const Real3Of<real>& v) {
    return {v.x, v.y, v.z};
}

/// Three directions, of which two span the plane across the third.
struct Directions {
    Vec3 u, v, axis;
};
Basis rounded_basis(const Directions& d) { return {rounded<float>(d.u), rounded<float>(d.v), rounded<float>(d.axis)}; }

// With 50 digits: where `up` is nearly parallel to the view, their cross product in double loses most of its own.
using Digits = boost::multiprecision::static_mpfr_float_50;
using Precise = std::array<Digits, 3>;

Precise precise(const Vec3& v) { return {Digits(v.x), Digits(v.y), Digits(v.z)}; }
Precise cross(const Precise& a, const Precise& b) {
    return {Digits(a[1] * b[2] - a[2] * b[1]), Digits(a[2] * b[0] - a[0] * b[2]), Digits(a[0] * b[1] - a[1] * b[0])};
}
Vec3 unit(const Precise& v) {
    const Digits length = sqrt(Digits(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    return {static_cast<double>(Digits(v[0] / length)), static_cast<double>(Digits(v[1] / length)),
            static_cast<double>(Digits(v[2] / length))};
}

Directions view(const Camera& camera) {
    const Precise eye = precise(camera.eye), at = precise(camera.at);
    const Precise z{Digits(at[0] - eye[0]), Digits(at[1] - eye[1]), Digits(at[2] - eye[2])};
    const Precise x = cross(precise(camera.up), z);
    return {unit(x), unit(cross(z, x)), unit(z)};
}

Directions across(const Vec3& axis) {
    const Vec3 other = std::fabs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};  // at least 30 degrees off
    const Vec3 u = normalize(cross(other, axis));
    return {u, cross(axis, u), axis};
}

/// Whether the box around all spheres lies on the axis's side of a point, and so much that its picture on a plane at
/// distance 1 stays small: no corner farther off the axis than 75 degrees.
bool sees_all(const Vec3& point, const Vec3& axis, const Survey& s) {
    constexpr double cosine = 0.26;
    const double r = s.largest_radius;
    for (const double x : {s.low.x - r, s.high.x + r})
        for (const double y : {s.low.y - r, s.high.y + r})
            for (const double z : {s.low.z - r, s.high.z + r}) {
                const Vec3 way = Vec3{x, y, z} - point;
                if (!(dot(way, axis) > cosine * length(way))) return false;
            }
    return true;
}

/// What is left of a sum beside its double (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
double rest_of_sum(double a, double b) {
    const double sum = a + b, b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
}

/// The place of the eye, and from there the way to a pencil's apex.
template <class real>
ApexOf<real> apex_of(const Vec3& eye, const Vec3& way) {
    const Vec3 p = eye + way;
    if constexpr (sizeof(real) == sizeof(double))
        return {rounded<real>(p), {rest_of_sum(eye.x, way.x), rest_of_sum(eye.y, way.y), rest_of_sum(eye.z, way.z)}};
    else
        return {rounded<real>(p), {rest_of_float(p.x), rest_of_float(p.y), rest_of_float(p.z)}};
}

}  // namespace

template <class real>
EyePencilOf<real> eye_pencil(const Camera& camera, const ImageSize& image) {
    const Directions d = view(camera);
    const double half_height = std::tan(camera.fov * pi / 360);  // of the image plane at distance 1
    const double half_pixel = half_height / image.height;
    return {rounded<real>(d.axis), rounded<real>(d.u * half_pixel), rounded<real>(d.v * half_pixel), image.width,
            image.height};
}

Basis eye_basis(const Camera& camera) { return rounded_basis(view(camera)); }

template <class real>
ParallelPencilOf<real> parallel_pencil(const DirectionalLight& light) {
    const Directions d = across(normalize(light.direction_to_light));
    return {rounded<real>(d.u), rounded<real>(d.v), rounded<real>(d.axis)};
}

template <class real>
PointPencilOf<real> point_pencil(const PointLight& light, const Camera& camera, const Survey& survey,
                                 const Frame& frame) {
    PointPencilOf<real> pencil{rounded<real>((light.position - camera.eye) * (1 / frame.unit)), 1, {}};
    const Vec3 way = survey.low * 0.5 + survey.high * 0.5 - light.position;
    const double distance = length(way);
    if (distance > 0 && std::isfinite(distance) && sees_all(light.position, way * (1 / distance), survey)) {
        pencil.face[0] = rounded_basis(across(way * (1 / distance)));
        return pencil;
    }
    pencil.faces = 0;
    for (const double sign : {-1.0, 1.0})
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
            pencil.face[pencil.faces++] = rounded_basis(across(axis * sign));
    return pencil;
}

template <class real>
ApexOf<real> eye_apex(const Camera& camera, const Frame& frame) {
    return apex_of<real>(frame.place(camera.eye), {});
}

template <class real>
ApexOf<real> point_apex(const PointPencilOf<real>& pencil, const Camera& camera, const Frame& frame) {
    return apex_of<real>(frame.place(camera.eye), widened(pencil.origin));
}

template <class real>
Real3Of<real> lambert_factor(const DirectionalLight& light, double) {
    const Rgb& e = light.irradiance;
    return rounded<real>(Vec3{e.r, e.g, e.b} * (1 / pi));
}

template <class real>
Real3Of<real> lambert_factor(const PointLight& light, double unit) {
    const Rgb& p = light.power;
    // Divided twice: the square of an extreme unit may be out of range where the scaled power is not.
    return rounded<real>(Vec3{p.r, p.g, p.b} * (1 / unit) * (1 / unit) * (1 / (4 * pi * pi)));
}

float base_doubt(const Scene& scene, const Survey& survey, const Frame& frame) {
    const auto size = [&](const Vec3& p) { return length(frame.place(p)); };
    double largest = std::max({size(survey.low), size(survey.high), size(scene.camera.eye)}) +
                     2 * length((survey.high - survey.low) * (1 / frame.unit)) + survey.largest_radius / frame.unit;
    for (const Light& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light)) largest = std::max(largest, size(point->position));
    return static_cast<float>(std::ldexp(largest, -46));
}

template EyePencilOf<float> eye_pencil(const Camera&, const ImageSize&);
template ParallelPencilOf<float> parallel_pencil(const DirectionalLight&);
template PointPencilOf<float> point_pencil(const PointLight&, const Camera&, const Survey&, const Frame&);
template ApexOf<float> eye_apex(const Camera&, const Frame&);
template ApexOf<float> point_apex(const PointPencilOf<float>&, const Camera&, const Frame&);
template Real3Of<float> lambert_factor(const DirectionalLight&, double);
template Real3Of<float> lambert_factor(const PointLight&, double);
template EyePencilOf<double> eye_pencil(const Camera&, const ImageSize&);
template ParallelPencilOf<double> parallel_pencil(const DirectionalLight&);
template PointPencilOf<double> point_pencil(const PointLight&, const Camera&, const Survey&, const Frame&);
template ApexOf<double> eye_apex(const Camera&, const Frame&);
template ApexOf<double> point_apex(const PointPencilOf<double>&, const Camera&, const Frame&);
template Real3Of<double> lambert_factor(const DirectionalLight&, double);
template Real3Of<double> lambert_factor(const PointLight&, double);

}  // namespace gnomon
