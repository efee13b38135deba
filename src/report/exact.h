// Where a ray meets a sphere, to 60 digits: what the formulas are held against.
#pragma once

#include "../../cl/types.h"
#include "vec.h"

namespace gnomon::report {

struct ExactHit {
    bool hits;
    double t;     ///< rounded to double: 2^-29 ulp of a float; infinity for a miss
    Vec3 normal;  ///< outward, unit length, rounded likewise
};

/// The smallest t > 0 at which t dir meets the sphere, for the floats as they are: |dir| need not be 1, and `power` is
/// not looked at. By the quadratic in full, a t^2 + b t + c = 0; nothing cancels that 60 digits do not hold: products
/// of four floats have 96 bits, and those of numbers 10^7 apart share a sum of less than 200.
ExactHit exact_hit(const RootSphere& sphere, const Float3& dir);

/// |center|^2 - radius^2, rounded once.
float exact_power(const Float3& center, float radius);

}  // namespace gnomon::report
