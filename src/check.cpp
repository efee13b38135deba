#include "check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference.h"

namespace gnomon {

namespace {

// Radiance that differs by more than this share of the brightest is not rounding but another decision. The float
// chain's worst rounding is a few 2^-24 amplified by |position| / radius of the sphere, 10^3 on a sphere of one pixel.
constexpr double flip = 1e-3;

struct Compared {
    double off, expected;
};

Compared compare(const Film& film, const Rgb& expected, size_t pixel) {
    const double wanted[] = {expected.r, expected.g, expected.b};
    Compared result{0, 0};
    for (size_t c = 0; c < 3; ++c) {
        result.off = std::max(result.off, std::fabs(static_cast<double>(film.radiance[c][pixel]) - wanted[c]));
        result.expected = std::max(result.expected, wanted[c]);
    }
    return result;
}

/// Rounds of the golden ratio visit an interval evenly for any number of samples (Weyl's sequence).
size_t spread(int64_t i, size_t pixels) {
    const double share = std::fmod(static_cast<double>(i) * 0.6180339887498949, 1.0);
    return std::min(pixels - 1, static_cast<size_t>(share * static_cast<double>(pixels)));
}

}  // namespace

Check check(const Scene& scene, const Film& film, bool shadows, int64_t pixels, int64_t tests) {
    const auto work = (sphere_count(scene) + 1) * static_cast<int64_t>(1 + (shadows ? scene.lights.size() : 0));
    const int64_t count = std::clamp<int64_t>(tests / work, 1, std::min(pixels, static_cast<int64_t>(film.pixels())));
    Check result;
    std::vector<double> offs;
    double brightest = 0;
    for (int64_t i = 0; i < count; ++i) {
        const size_t p = spread(i, film.pixels()), width = static_cast<size_t>(film.width);
        const auto ray = reference::eye_ray(scene, static_cast<int>(p % width), static_cast<int>(p / width));
        const auto hit = reference::closest_hit(scene, ray);
        ++result.pixels;
        if (!film.id.empty() && film.id[p] != hit.id) ++result.wrong_ids;
        if (!film.distance.empty() && hit.id >= 0 && std::isfinite(film.distance[p]))
            result.max_distance = std::max(result.max_distance, std::fabs(film.distance[p] - hit.t) / hit.t);
        if (film.radiance[0].empty()) continue;
        const Compared radiance = compare(film, reference::radiance(scene, hit, shadows), p);
        offs.push_back(radiance.off);
        brightest = std::max(brightest, radiance.expected);
    }
    for (const double off : offs) {
        const double relative = brightest > 0 ? off / brightest : off;
        result.flips += relative > flip;
        if (relative <= flip) result.max_radiance = std::max(result.max_radiance, relative);
    }
    return result;
}

}  // namespace gnomon
