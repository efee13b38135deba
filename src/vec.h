// Three doubles and the algebra that a camera and a light need.
#pragma once

#include <cmath>

namespace gnomon {

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
/// Euclidean length; three-argument hypot neither overflows nor underflows on the way.
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }
inline Vec3 normalize(Vec3 a) {
    const double l = length(a);
    return {a.x / l, a.y / l, a.z / l};
}

}  // namespace gnomon
