#include "certify.h"

#include "exact.h"

namespace gnomon {

namespace {

template <class T, class V>
void put(Plane<T>& plane, size_t at, V value) {
    if (!plane.empty()) plane[at] = static_cast<T>(value);
}

void put(Film& film, size_t at, const exact::Pixel& pixel, double per_unit) {
    const double normal[] = {pixel.normal.x, pixel.normal.y, pixel.normal.z};
    const double radiance[] = {pixel.radiance.r, pixel.radiance.g, pixel.radiance.b};
    for (size_t c = 0; c < 3; ++c) {
        put(film.normal[c], at, normal[c]);
        put(film.radiance[c], at, radiance[c]);
    }
    put(film.distance, at, pixel.t * per_unit);
    put(film.id, at, pixel.id);
}

}  // namespace

void decide_again(const Scene& scene, bool shadows, const std::vector<int>& pixels, double per_unit, Film& film) {
    if (pixels.empty()) return;
    const exact::Decider decider(scene, shadows);
    for (const int at : pixels)
        put(film, static_cast<size_t>(at), decider.decide(at % film.width, at / film.width), per_unit);
}

}  // namespace gnomon
