// Draws that are the same on every machine.
#pragma once

#include <cstdint>

#include "scene.h"

namespace bench {

/// splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014); 24 bits a draw.
class Random {
  public:
    explicit Random(uint64_t seed) : state_(seed) {}
    double in(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 40) / 16777216.0; }

    gnomon::Sphere sphere(const gnomon::Vec3& low, const gnomon::Vec3& high, double r_low, double r_high) {
        gnomon::Sphere s;
        s.center.x = in(low.x, high.x);
        s.center.y = in(low.y, high.y);
        s.center.z = in(low.z, high.z);
        s.radius = in(r_low, r_high);
        s.albedo.r = in(0.2, 0.9);
        s.albedo.g = in(0.2, 0.9);
        s.albedo.b = in(0.2, 0.9);
        return s;
    }

  private:
    uint64_t next() {
        uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    uint64_t state_;
};

}  // namespace bench
