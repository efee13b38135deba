// How far what arrives of a light may be off, and where float may see another shadow than the reference. All of it in
// units of u; a hundredth more is for what is of higher order. The eye is the origin, so that centres are seen from it
// as they are.
#pragma once

#include "shadow_harness.h"

namespace gnomon::test {

/// n . l, or n . l / d^2, with its sign.
inline double share(const reference::Hit& hit, const Light& light) {
    const double cosine = reference::cosine(hit, light);
    const auto* point = std::get_if<PointLight>(&light);
    const Vec3 way = point ? point->position - hit.position : Vec3{1, 0, 0};
    return cosine / dot(way, way);
}

/// Directional: l's rounding 1, the dot product 3.
/// Point, a float from the eye: the way is off by |p| (the position's product) and d (its own rounding), the dot
/// product 3 d: |p| + 4 d, over d. d^2 is relatively off by 2 (|p| / d + 1) + 3; d^3 by half as much again, and 1 each
/// for root and product: 3 |p| / d + 9.5; the quotient 1.
inline double share_bound(const reference::Hit& hit, const Light& light) {
    const auto* point = std::get_if<PointLight>(&light);
    if (!point) return 1.01 * 4 * u;
    const double d = length(point->position - hit.position), p = length(hit.position) / d;
    const double c = std::fabs(reference::cosine(hit, light));
    return 1.01 * u * (p + 4 + c * (3 * p + 10.5)) / (d * d);
}

/// A sphere at c. From coordinates in the light's basis: the position's product |p|, its dot product 3 |p|, the
/// centre's rounding |c|, the difference and the basis |c - p| each: e = 4 |p| + |c| + 2 |c - p| in every coordinate.
/// The disc: sqrt(2) e across and, for r^2 and two fma, 3 r^2 in D, 1.5 r in its edge; where the receiver is next to
/// the surface sqrt(3) e and, for `ahead` squared, 0.5 r more.
/// The receiver's power: `from` is off by 4 sqrt(3) |p| < 7 |p|, the basis by sqrt(3) at either end. -2 c . p: 14 + 1 x
/// 2 + 7 + dot product 6 = 29; |p|^2: 14 + 3.5 + 3 < 21; C's rounding; the sum 2 |c| |p| + |p|^2; the last addition.
/// Discriminant: 2 ahead e, and that, and the rounding of fma.
inline bool doubtful(const Sphere& s, const reference::Hit& hit, const DirectionalLight& light) {
    const Vec3 p = hit.position, way = s.center - p, l = normalize(light.direction_to_light);
    const double r = s.radius, c = length(s.center), ahead = dot(way, l), m = length(cross(way, l));
    const double e = u * (4 * length(p) + c + 2 * length(way)), away = length(way);
    if (r * r < c * c / 2 || length(p) >= r)
        return std::fabs(m - r) <= 1.01 * (std::sqrt(2) * e + 1.5 * u * r) ||
               std::fabs(away - r) <= 1.01 * (std::sqrt(3) * e + 2 * u * r);
    const double C = (c - r) * (c + r), power = (away - r) * (away + r), D = (r - m) * (r + m);
    const double power_error = u * (std::fabs(C) + 31 * c * length(p) + 22 * dot(p, p) + std::fabs(power));
    return std::fabs(power) <= 1.01 * power_error ||
           (ahead > -e && std::fabs(D) <= 1.01 * (2 * std::fabs(ahead) * e + e * e + power_error + u * std::fabs(D)));
}

/// A sphere at f from the light, a receiver at p from the eye and d from the light. d: |p| + 3.5 d. The direction:
/// across |p| / d + 1, the product 1; in length 4.5. b: the centre's rounding 1, the dot product 3, the direction:
/// |f| (|p| / d + 10.5).
/// Small: the line passes off by |f| (|p| / d + 2 + 1) and m; f - b dir is off along the line by |f| (|p| / d + 15),
/// which counts by its square; r^2 and three fma 4 r^2 in D, 2 r in its edge. Next to the surface the errors of b and d
/// besides, and the rounding of their difference and its square.
/// Large: D = b^2 - C, and the power C - d (2 b - d), factor by factor.
inline bool doubtful(const Sphere& s, const reference::Hit& hit, const PointLight& light) {
    const Vec3 f = s.center - light.position, to = hit.position - light.position, dir = normalize(to);
    const double r = s.radius, d = length(to), p = length(hit.position), b = dot(f, dir), m = length(cross(f, dir));
    const double distance = length(f), C = (distance - r) * (distance + r), beyond = b - d;
    const double away = length(s.center - hit.position);
    const double d_error = u * (p + 3.5 * d), b_error = u * distance * (p / d + 10.5);
    if (r * r < distance * distance / 2) {
        const double along = u * distance * (p / d + 15);
        const double edge = u * distance * (p / d + 3) + u * m + 2 * u * r + along * along / (2 * r);
        return std::fabs(m - r) <= 1.01 * edge || std::fabs(away - r) <= 1.01 * (edge + b_error + d_error + 2 * u * r);
    }
    const double power = (away - r) * (away + r), D = (r - m) * (r + m);
    const double power_error = u * std::fabs(C) + d_error * (2 * std::fabs(b) + d) + u * std::fabs(power) +
                               d * (2 * b_error + d_error + u * std::fabs(beyond) + u * std::fabs(b + beyond));
    return std::fabs(power) <= 1.01 * power_error ||
           (C > 0 && std::fabs(D) <= 1.01 * (2 * std::fabs(b) * b_error + u * std::fabs(C) + u * std::fabs(D)));
}

/// Whether rounding may decide about some sphere other than the hit's own.
inline bool doubtful(const Scene& scene, const reference::Hit& hit, const Light& light) {
    for (size_t i = 0; i < scene.spheres.size(); ++i)
        if (static_cast<int>(i) != hit.id &&
            std::visit([&](const auto& l) { return doubtful(scene.spheres[i], hit, l); }, light))
            return true;
    return false;
}

/// Receivers whose arrival is not the reference's.
struct ShadowCount {
    int64_t lit = 0, shadowed = 0, away = 0;  ///< by the reference; away: hits that do not face the light
    int64_t flips = 0;                        ///< in doubt, and not as the reference has it
    int64_t wrong = 0;
};

inline void compare(const Scene& scene, const Receivers& hits, const std::vector<float>& arrived, const Light& light,
                    ShadowCount& count) {
    for (size_t i = 0; i < hits.size(); ++i) {
        const double a = static_cast<double>(arrived[i]);
        if (hits.ids[i] < 0) {
            count.wrong += a != 0;
            continue;
        }
        const reference::Hit hit = hits.hit(i);
        const double expected = share(hit, light), bound = share_bound(hit, light);
        const bool shadowed = reference::in_between(scene, hit, light);
        ++(expected <= 0 ? count.away : shadowed ? count.shadowed : count.lit);
        const bool value_right = a == 0 ? expected <= bound || shadowed : a > 0 && std::fabs(a - expected) <= bound;
        if (value_right && !(a > 0 && shadowed)) continue;
        const bool flip = (a == 0 || std::fabs(a - expected) <= bound) && doubtful(scene, hit, light);
        ++(flip ? count.flips : count.wrong);
    }
}

}  // namespace gnomon::test
