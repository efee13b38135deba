// The sRGB curve's table, and the four views.
#include "display.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.h"

namespace gnomon {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr LinearColour black{0, 0, 0};

/// The farthest hit's grey: 63 of 255 once encoded, which the eye still tells from the black of a miss.
constexpr double farthest_grey = 0.05;

bool has_view(const Film& film, View view) {
    switch (view) {
        case View::radiance:
            return !film.radiance[0].empty();
        case View::distance:
            return !film.distance.empty();
        case View::normal:
            return !film.normal[0].empty();
        case View::id:
            return !film.id.empty();
    }
    return false;
}

/// A fully saturated colour; `hue` in [0, 6), from red by way of green and blue.
LinearColour pure_hue(float hue) {
    const auto ramp = [](float distance_from_full) { return std::clamp(2 - distance_from_full, 0.0f, 1.0f); };
    return {1 - ramp(std::abs(hue - 3)), ramp(std::abs(hue - 2)), ramp(std::abs(hue - 4))};
}

/// Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4): ids that follow each other are 0.38 of the colour
/// circle apart, and the circle fills up evenly. The brightness tells apart the ids whose hues come to be close.
LinearColour id_colour(int32_t id) {
    if (id < 0) return black;
    const uint32_t hash = static_cast<uint32_t>(id) * 2654435769u;  // 2^32 / golden ratio
    const float brightness = 1 - 0.3f * static_cast<float>(id % 3);
    LinearColour colour = pure_hue(static_cast<float>(hash >> 8) * (6.0f / (1 << 24)));
    for (float& channel : colour) channel = brightness * (0.1f + 0.9f * channel);
    return colour;
}

LinearColour normal_colour(float x, float y, float z) {
    if (!std::isfinite(x + y + z)) return black;
    return {(x + 1) / 2, (y + 1) / 2, (z + 1) / 2};
}

}  // namespace

SrgbQuantiser::SrgbQuantiser(int bits) : top_(static_cast<uint16_t>((1 << bits) - 1)) {
    step_.resize(top_ + 2u, infinity);
    step_[0] = 0;
    for (size_t code = 1; code <= top_; ++code) step_[code] = srgb_decode((static_cast<double>(code) - 0.5) / top_);

    // Four buckets a code: where the curve is steepest, 12.92, a look-up then walks past three steps or four.
    first_code_.resize(4 * (top_ + 1u));
    uint16_t code = 0;
    for (size_t bucket = 0; bucket < first_code_.size(); ++bucket) {
        const double least = static_cast<double>(bucket) / static_cast<double>(first_code_.size());
        while (least >= step_[code + 1u]) ++code;
        first_code_[bucket] = code;
    }
}

DisplayImage::DisplayImage(const Film& film, const Display& display)
    : film_(film),
      view_(display.view),
      gain_(static_cast<float>(std::exp2(display.exposure))),
      near_(infinity),
      far_(-infinity),
      quantise_(display.bits) {
    if (!has_view(film, view_)) throw Error(Blame::run, "the view to display was not rendered");
    if (view_ != View::distance) return;
    for (const double distance : film.distance) {
        if (!std::isfinite(distance)) continue;
        near_ = std::min(near_, distance);
        far_ = std::max(far_, distance);
    }
}

float DisplayImage::grey(float distance) const {
    if (!std::isfinite(distance)) return 0;
    const double depth = far_ > near_ ? (distance - near_) / (far_ - near_) : 0;
    return static_cast<float>(1 - (1 - farthest_grey) * depth);
}

LinearColour DisplayImage::colour(size_t index) const {
    switch (view_) {
        case View::radiance:
            return {gain_ * film_.radiance[0][index], gain_ * film_.radiance[1][index],
                    gain_ * film_.radiance[2][index]};
        case View::distance: {
            const float level = grey(film_.distance[index]);
            return {level, level, level};
        }
        case View::normal:
            return normal_colour(film_.normal[0][index], film_.normal[1][index], film_.normal[2][index]);
        case View::id:
            return id_colour(film_.id[index]);
    }
    return black;
}

}  // namespace gnomon
