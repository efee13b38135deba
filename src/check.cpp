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

std::vector<size_t> sampled_pixels(const Scene& scene, const Film& film, bool shadows, int64_t pixels, int64_t tests) {
    const auto work = (sphere_count(scene) + 1) * static_cast<int64_t>(1 + (shadows ? scene.lights.size() : 0));
    const int64_t count = std::clamp<int64_t>(tests / work, 1, std::min(pixels, static_cast<int64_t>(film.pixels())));
    std::vector<size_t> sample;
    for (int64_t i = 0; i < count; ++i) sample.push_back(spread(i, film.pixels()));
    return sample;
}

Check check(const Scene& scene, const Film& film, bool shadows, int64_t pixels, int64_t tests) {
    Check result;
    std::vector<double> offs;  // of the radiance, pixel by pixel
    std::vector<bool> other_ids;
    double brightest = 0;
    for (const size_t p : sampled_pixels(scene, film, shadows, pixels, tests)) {
        const auto width = static_cast<size_t>(film.width);
        const auto ray = reference::eye_ray(scene, static_cast<int>(p % width), static_cast<int>(p / width));
        const auto hit = reference::closest_hit(scene, ray);
        ++result.pixels;
        other_ids.push_back(!film.id.empty() && film.id[p] != hit.id);
        result.wrong_ids += other_ids.back();
        if (!film.distance.empty() && hit.id >= 0 && std::isfinite(film.distance[p]))
            result.max_distance = std::max(result.max_distance, std::fabs(film.distance[p] - hit.t) / hit.t);
        offs.push_back(0);
        if (film.radiance[0].empty()) continue;
        const Compared radiance = compare(film, reference::radiance(scene, hit, shadows), p);
        offs.back() = radiance.off;
        brightest = std::max(brightest, radiance.expected);
    }
    double squares = 0;
    for (size_t i = 0; i < offs.size(); ++i) {
        const double relative = brightest > 0 ? offs[i] / brightest : offs[i];
        const bool flipped = relative > flip;
        result.flips += flipped;
        result.wrong_pixels += flipped || other_ids[i];
        if (flipped) continue;
        result.max_radiance = std::max(result.max_radiance, relative);
        squares += relative * relative;
    }
    const auto right = static_cast<double>(result.pixels - result.flips);
    result.rms_radiance = right > 0 ? std::sqrt(squares / right) : 0;
    return result;
}

}  // namespace gnomon
