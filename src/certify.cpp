#include "certify.h"

#include "exact.h"

namespace gnomon {

namespace {

template <class T, class V>
void put(Plane<T>& plane, size_t at, V value) {
    if (!plane.empty()) plane[at] = static_cast<T>(value);
}

}  // namespace

void put(Film& film, size_t at, const Pixel& pixel) {
    const double normal[] = {pixel.normal.x, pixel.normal.y, pixel.normal.z};
    const double radiance[] = {pixel.radiance.r, pixel.radiance.g, pixel.radiance.b};
    for (size_t c = 0; c < 3; ++c) {
        put(film.normal[c], at, normal[c]);
        put(film.radiance[c], at, radiance[c]);
    }
    put(film.distance, at, pixel.t);
    put(film.id, at, pixel.id);
}

void decide_exactly(const Scene& scene, bool shadows, const std::vector<int>& pixels, double unit, Film& film,
                    const Stop* stop) {
    if (pixels.empty()) return;
    exact::Decider decider(scene, shadows);
    for (const int at : pixels) {
        check(stop);
        const exact::Pixel pixel = decider.decide(at % film.width, at / film.width);
        put(film, static_cast<size_t>(at), {pixel.id, pixel.t / unit, pixel.normal, pixel.radiance});
    }
}

}  // namespace gnomon
