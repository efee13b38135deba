// Films to pictures for the eye: one view, sRGB encoded, as whole numbers of 8 or 16 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "film.h"
#include "image_io.h"
#include "srgb.h"

namespace gnomon {

/// Linear red, green, blue of a picture's pixel; what lies outside [0, 1] is clipped.
using LinearColour = std::array<float, 3>;

/// Linear light to sRGB codes 0 .. 2^bits - 1: clipped to [0, 1], encoded, rounded half up; a NaN becomes 0.
/// A code is looked up among the exact linear values at which the rounded code steps, since a power per channel and
/// pixel would take longer than compressing the picture.
class SrgbQuantiser {
  public:
    /// `bits` is 8 or 16.
    explicit SrgbQuantiser(int bits);

    uint16_t operator()(float linear) const {
        if (!(linear > 0)) return 0;
        if (linear >= 1) return top_;
        uint16_t code = first_code_[static_cast<size_t>(linear * static_cast<float>(first_code_.size()))];
        while (linear >= step_[code + 1u]) ++code;
        return code;
    }

  private:
    uint16_t top_;
    std::vector<double> step_;          ///< [code]: the least linear value that gets it; one past the top is +inf
    std::vector<uint16_t> first_code_;  ///< [bucket]: the code of the least value in it; equal parts of [0, 1)
};

/// A film as one of its views. It refers to the film, which has to outlive it.
/// Radiance: times 2^exposure. Distance: grey, the nearest hit white, the farthest dark. Normal: (n + 1) / 2. Id: each
/// its own colour, the same in every picture. Misses are black. All views are linear light, encoded by `row`.
class DisplayImage {
  public:
    /// Throws Error(Blame::run) when the film lacks the view's planes.
    DisplayImage(const Film& film, const Display& display);

    /// The colour of the pixel at `index`, before the sRGB curve.
    LinearColour colour(size_t index) const;

    /// Writes row `y`, 3 x width codes. `Code` is uint8_t or uint16_t, wide enough for the display's bits.
    template <class Code>
    void row(int y, Code* rgb) const {
        const auto width = static_cast<size_t>(film_.width);
        for (size_t i = width * static_cast<size_t>(y), end = i + width; i < end; ++i)
            for (float channel : colour(i)) *rgb++ = static_cast<Code>(quantise_(channel));
    }

  private:
    float grey(float distance) const;

    const Film& film_;
    View view_;
    float gain_;
    double near_, far_;  ///< of the finite distances
    SrgbQuantiser quantise_;
};

}  // namespace gnomon
