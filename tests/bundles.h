// Bundles of rays, and spheres that their outermost ray alone touches: inputs for which a fat ray could be too thin.
#pragma once

#include "kernel_harness.h"

namespace gnomon::test {

inline Vec3 across(const Vec3& v, const Vec3& dir) { return v - dir * dot(v, dir); }

/// `rays` directions about an axis; the first is the one farthest from their mean.
inline std::vector<Float3> bundle(Random& random, size_t rays, double spread) {
    const Vec3 axis = random.direction();
    std::vector<Float3> dirs;
    Vec3 sum;
    for (size_t i = 0; i < rays; ++i) {
        const Vec3 d = normalize(axis + random.direction() * (spread * random.uniform(0, 1)));
        dirs.push_back(to_float(d));
        sum = sum + to_double(dirs.back());
    }
    const Vec3 mean = normalize(sum);
    const auto off = [&](const Float3& d) { return length(to_double(d) - mean); };
    std::swap(dirs[0], *std::max_element(dirs.begin(), dirs.end(),
                                         [&](const Float3& a, const Float3& b) { return off(a) < off(b); }));
    return dirs;
}

/// A sphere at `distance` that the bundle's first ray touches on the side away from the others, within `roundings` u r.
inline Sphere touching(const std::vector<Float3>& dirs, double distance, double radius, double roundings) {
    Vec3 sum;
    for (const Float3& d : dirs) sum = sum + to_double(d);
    const Vec3 d = normalize(to_double(dirs[0]));
    const Vec3 outward = normalize(across(d - normalize(sum), d));
    return {d * distance + outward * (radius * (1 + roundings * u)), radius};
}

constexpr size_t bundle_sizes[] = {16, 32, 64};  // rays a work-item, of the widths above 1

}  // namespace gnomon::test
