#include "film.h"

namespace gnomon {

Film::Film(int w, int h, const Outputs& outputs) : width(w), height(h) {
    for (auto& plane : radiance)
        if (outputs.radiance) plane = Plane<float>(pixels());
    if (outputs.distance) distance = Plane<float>(pixels());
    for (auto& plane : normal)
        if (outputs.normal) plane = Plane<float>(pixels());
    if (outputs.id) id = Plane<int32_t>(pixels());
}

}  // namespace gnomon
