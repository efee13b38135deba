// Single pixels, decided exactly: intervals of growing precision (MPFI) hold the real-number picture of the scene's
// doubles, until the sign of every quantity that decides something is certain.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "scene.h"

namespace gnomon::exact {

/// What one pixel shows.
struct Pixel {
    int32_t id = -1;  ///< -1 for a miss
    double t;         ///< distance; infinity for a miss
    Vec3 normal;      ///< outward; infinite for a miss
    Rgb radiance{0, 0, 0};
};

/// A quantity that this many bits do not tell from 0 counts as 0: they would tell apart whatever does not cancel to
/// more than 60 times the precision in which scenes are given.
constexpr int most_bits = 4096;
/// What a decision is tried with first, and twice as many then, up to so many: what those leave open is 0 as a rule.
constexpr int least_bits = 128, patient_bits = 512;

/// The camera, to so many bits.
struct Eye;

/// Decides pixels of one scene. The scene must outlive it.
class Decider {
  public:
    Decider(const Scene& scene, bool shadows);

    /// Pixel (i, j), row 0 at the top.
    Pixel decide(int i, int j);

  private:
    const Eye& eye(int bits);

    const Scene& scene_;
    bool shadows_;
    std::vector<Sphere> spheres_;
    std::map<int, std::shared_ptr<const Eye>> eyes_;  // by bits: as dear as the rest of a pixel
};

}  // namespace gnomon::exact
