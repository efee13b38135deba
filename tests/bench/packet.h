// Neighbouring pixels, as many as a vector holds: their rays, what these hit and how it is lit, in plain loops that a
// compiler turns into vectors. For embree.cpp alone, which is compiled for the machine that it is built on.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "scene.h"

namespace bench {

// Embree takes packets wider than the CPU's vectors apart, ray by ray.
#ifdef __AVX512F__
constexpr int packet_columns = 4, packet_rows = 4;
#define OF_PACKET(name) name##16
#else
constexpr int packet_columns = 4, packet_rows = 2;
#define OF_PACKET(name) name##8
#endif
constexpr int packet_rays = packet_columns * packet_rows;

struct alignas(64) Lanes {
    float v[packet_rays];
    float& operator[](int k) { return v[k]; }
    const float& operator[](int k) const { return v[k]; }
};
struct Lanes3 {
    Lanes x, y, z;
};
struct alignas(64) Mask {
    int v[packet_rays];  ///< -1 or 0, as Embree takes it
};

struct Float3 {
    float x, y, z;
};

/// The image plane at distance 1: ahead + across * [-1, 1] + up * [-1, 1].
struct View {
    Float3 eye, ahead, across, up;
    float per_column, per_row;  ///< 1 / width, 1 / height
};

struct PeerLight {
    bool is_point;
    Float3 to;  ///< the position, or the unit vector to the light
    Float3 phi;
};

struct Surface {
    Mask hit;
    Lanes3 position, normal;
    Lanes offset;  ///< along the normal, to where shadow rays begin
};

inline Float3 to_float3(const gnomon::Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

inline View view_of(const gnomon::Scene& scene) {
    const gnomon::Camera& camera = scene.camera;
    const gnomon::Vec3 ahead = normalize(camera.at - camera.eye), side = normalize(cross(camera.up, ahead));
    const double top = std::tan(camera.fov * std::acos(-1.0) / 360);
    const double edge = top * scene.image.width / scene.image.height;
    return {to_float3(camera.eye),
            to_float3(ahead),
            to_float3(side * edge),
            to_float3(cross(ahead, side) * top),
            1.0f / static_cast<float>(scene.image.width),
            1.0f / static_cast<float>(scene.image.height)};
}

inline PeerLight light_of(const gnomon::Light& light) {
    const auto rgb = [](const gnomon::Rgb& c) { return to_float3({c.r, c.g, c.b}); };
    if (const auto* lamp = std::get_if<gnomon::PointLight>(&light))
        return {true, to_float3(lamp->position), rgb(lamp->power)};
    const auto& sun = std::get<gnomon::DirectionalLight>(light);
    return {false, to_float3(normalize(sun.direction_to_light)), rgb(sun.irradiance)};
}

/// A ray or packet of Embree's that starts afresh. `Ray` is RTCRay8 or RTCRay16 of either version.
template <class Ray>
void begin(Ray& ray, int k) {
    ray.tnear[k] = 0;
    ray.tfar[k] = std::numeric_limits<float>::infinity();
    ray.time[k] = 0;
    ray.mask[k] = ~0u;
    ray.flags[k] = 0;
    ray.id[k] = static_cast<unsigned>(k);
}

/// Rays of the pixels from column i and row j on.
template <class Ray>
void aim(const View& view, int i, int j, Ray& ray) {
    for (int k = 0; k < packet_rays; ++k) {
        const float x = static_cast<float>(2 * (i + k % packet_columns) + 1) * view.per_column - 1;
        const float y = 1 - static_cast<float>(2 * (j + k / packet_columns) + 1) * view.per_row;
        const float dx = view.ahead.x + x * view.across.x + y * view.up.x;
        const float dy = view.ahead.y + x * view.across.y + y * view.up.y;
        const float dz = view.ahead.z + x * view.across.z + y * view.up.z;
        const float scale = 1 / std::sqrt(dx * dx + dy * dy + dz * dz);
        begin(ray, k);
        ray.org_x[k] = view.eye.x, ray.org_y[k] = view.eye.y, ray.org_z[k] = view.eye.z;
        ray.dir_x[k] = dx * scale, ray.dir_y[k] = dy * scale, ray.dir_z[k] = dz * scale;
    }
}

/// Where a closest-hit packet ended. Embree's normal of a sphere is as long as its radius.
template <class RayHit>
void land(const RayHit& packet, unsigned none, Surface& s) {
    // Embree's hit is off by a few roundings of the numbers that it was computed from. These shares of them, each a
    // power of two, are the least with which no sphere of S4, S100 and S1e4 shadows itself: half the share of the
    // radius, or a quarter of the position's, gives it spots; twice as much, and twice as many pixels lose a shadow.
    constexpr float of_position = 1.0f / (1 << 22), of_radius = 1.0f / (1 << 22);
    const auto& ray = packet.ray;
    for (int k = 0; k < packet_rays; ++k) {
        const bool hit = packet.hit.geomID[k] != none;
        const float nx = packet.hit.Ng_x[k], ny = packet.hit.Ng_y[k], nz = packet.hit.Ng_z[k],
                    t = hit ? ray.tfar[k] : 0;
        const float radius = std::sqrt(nx * nx + ny * ny + nz * nz), scale = hit ? 1 / radius : 0;
        s.hit.v[k] = hit ? -1 : 0;
        s.position.x[k] = ray.org_x[k] + t * ray.dir_x[k];
        s.position.y[k] = ray.org_y[k] + t * ray.dir_y[k];
        s.position.z[k] = ray.org_z[k] + t * ray.dir_z[k];
        s.normal.x[k] = nx * scale, s.normal.y[k] = ny * scale, s.normal.z[k] = nz * scale;
        const float reach = std::fabs(ray.org_x[k]) + std::fabs(ray.org_y[k]) + std::fabs(ray.org_z[k]) + t;
        s.offset[k] = of_position * reach + of_radius * radius;
    }
}

/// Shadow rays to a light where it is not behind the surface, each with the share of its phi that would arrive, times
/// 1 / pi. Returns whether there is any.
template <class Ray>
bool aim_at(const PeerLight& light, const Surface& s, Ray& ray, Mask& valid, Lanes& share) {
    constexpr float per_pi = 0.318309886f, per_sphere = 0.0795774715f;  // 1 / (4 pi)
    int any = 0;
    for (int k = 0; k < packet_rays; ++k) {
        float x = light.to.x, y = light.to.y, z = light.to.z, falloff = 1;
        begin(ray, k);
        if (light.is_point) {
            x -= s.position.x[k], y -= s.position.y[k], z -= s.position.z[k];
            const float squared = x * x + y * y + z * z, distance = std::sqrt(squared), scale = 1 / distance;
            x *= scale, y *= scale, z *= scale;
            falloff = per_sphere / squared;
            ray.tfar[k] = distance;
        }
        const float cosine = s.normal.x[k] * x + s.normal.y[k] * y + s.normal.z[k] * z;
        ray.org_x[k] = s.position.x[k] + s.offset[k] * s.normal.x[k], ray.dir_x[k] = x;
        ray.org_y[k] = s.position.y[k] + s.offset[k] * s.normal.y[k], ray.dir_y[k] = y;
        ray.org_z[k] = s.position.z[k] + s.offset[k] * s.normal.z[k], ray.dir_z[k] = z;
        valid.v[k] = s.hit.v[k] & (cosine > 0 ? -1 : 0);
        share[k] = cosine * falloff * per_pi;
        any |= valid.v[k];
    }
    return any != 0;
}

}  // namespace bench
