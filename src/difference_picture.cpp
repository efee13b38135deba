#include "difference_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace gnomon {

namespace {

using Colour = std::array<float, 3>;

float difference(float a, float b) {
    if (equal_values(a, b)) return 0;
    const float result = std::fabs(a - b);
    return std::isnan(result) ? INFINITY : result;
}

Colour colour_of(uint8_t mark) {
    if (mark & different_mark) return mark & silhouette_mark ? Colour{0.1f, 0.2f, 1} : Colour{1, 0, 0};
    return mark & unequal_mark ? Colour{0.2f, 0.2f, 0.2f} : Colour{0, 0, 0};
}

}  // namespace

Film difference_film(const Film& a, const Film& b) {
    Film film;
    film.width = a.width;
    film.height = a.height;
    for (size_t c = 0; c < float_channels.size(); ++c) {
        const Plane<float>&from_a = plane_of(a, c), &from_b = plane_of(b, c);
        if (from_a.empty() || from_b.empty()) continue;
        Plane<float>& plane = plane_of(film, c) = Plane<float>(film.pixels());
        std::transform(from_a.begin(), from_a.end(), from_b.begin(), plane.begin(), difference);
    }
    if (a.id.empty() || b.id.empty()) return film;
    film.id = Plane<int32_t>(film.pixels());
    std::transform(a.id.begin(), a.id.end(), b.id.begin(), film.id.begin(), std::not_equal_to<int32_t>());
    return film;
}

Film difference_map(const PictureDiff& diff) {
    Film film(diff.width, diff.height, {true, false, false, false});
    for (size_t i = 0; i < diff.marks.size(); ++i) {
        const Colour colour = colour_of(diff.marks[i]);
        for (size_t c = 0; c < colour.size(); ++c) film.radiance[c][i] = colour[c];
    }
    return film;
}

}  // namespace gnomon
