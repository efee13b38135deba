// What a plan must know of a scene's spheres, and the frame in which they are rendered.
#pragma once

#include <cstdint>

#include "scene.h"

namespace gnomon {

/// One pass over all spheres.
struct Survey {
    int64_t count = 0;
    Vec3 low, high;  ///< the box around all centres
    double largest_radius = 0;
    double middle_radius = 0;  ///< of a sample
    bool floats = true;        ///< all numbers are floats exactly
    bool one_albedo = false;   ///< all spheres are rows of one table without albedos of their own
};
Survey survey(const Scene& scene);

/// Where the device's coordinates start, and their unit: x becomes (x - origin) / unit.
///
/// Spheres whose numbers are floats stay as they are. Others are split into two floats, 2^-48 of their distance from
/// the origin apart from the truth: it lies in their midst. The unit is a power of two, 1 for scenes that reach between
/// 2^-20 and 2^40 from the eye, where the cube of a distance, the largest power that a kernel takes, stays well inside
/// float's range; else about how far they reach.
struct Frame {
    Vec3 origin;
    double unit = 1;
    bool floats = true;  ///< the spheres are floats in this frame

    Vec3 place(const Vec3& p) const { return (p - origin) * (1 / unit); }
    bool operator==(const Frame& f) const {
        return unit == f.unit && origin.x == f.origin.x && origin.y == f.origin.y && origin.z == f.origin.z &&
               floats == f.floats;
    }
    bool is_scene() const { return unit == 1 && origin.x == 0 && origin.y == 0 && origin.z == 0; }
};
Frame choose_frame(const Scene& scene, const Survey& survey);

}  // namespace gnomon
