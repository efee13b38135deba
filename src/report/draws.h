// Random numbers that are the same everywhere: std::mt19937_64 is defined to the bit, the distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "vec.h"

namespace gnomon::report {

class Draws {
  public:
    explicit Draws(uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// Uniform in the logarithm.
    double scale(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    double sign() { return engine_() >> 63 ? 1 : -1; }
    /// Uniform on the unit sphere (Archimedes: a slice's area is its thickness).
    Vec3 direction() {
        const double z = uniform(-1, 1), angle = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }
    /// A unit vector at right angles to a unit vector.
    Vec3 across(const Vec3& axis) {
        Vec3 other = cross(axis, direction());
        while (!(length(other) > 0.1)) other = cross(axis, direction());
        return normalize(other);
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace gnomon::report
