#include "compare.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference.h"

namespace bench {

using namespace gnomon;

namespace {

// gnomon says what arrives in all, not from which light. So their lights' sum is computed in double at the hit that
// both found, which leaves no rounding but ours: off by more than this share of the brightest value is another
// decision. It is what the check against the reference calls a flip. A light whose share is smaller goes unseen, in
// either picture.
constexpr double flip = 1e-3;

bool same_sphere(const Scene& scene, int32_t a, int32_t b) {
    if (a == b) return true;
    if (a < 0 || b < 0) return false;
    const Sphere one = sphere_of(scene, a), other = sphere_of(scene, b);
    return length(one.center - other.center) == 0 && one.radius == other.radius;
}

/// Where this pixel's ray meets the sphere; id -1 where in double it does not.
reference::Hit meet(const Scene& scene, const Film& film, size_t pixel) {
    const auto width = static_cast<size_t>(film.width);
    const auto ray = reference::eye_ray(scene, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
    const Sphere sphere = sphere_of(scene, film.id[pixel]);
    const reference::Roots roots = reference::intersect(ray, sphere);
    const double t = roots.near > 0 ? roots.near : roots.far;
    if (!roots.real || !(t > 0)) return {t, -1, {}, {}};
    const Vec3 position = ray.origin + ray.dir * t;
    return {t, film.id[pixel], position, normalize(position - sphere.center)};
}

Rgb sum_of_arrivals(const Scene& scene, const reference::Hit& hit, const Arrivals& arrivals, size_t pixel) {
    Rgb sum;
    for (size_t light = 0; light < scene.lights.size(); ++light) {
        if (!arrivals.at(pixel, light)) continue;
        const Rgb term = reference::lambert(scene, hit, scene.lights[light]);
        sum = {sum.r + term.r, sum.g + term.g, sum.b + term.b};
    }
    return sum;
}

double distance(const Film& film, size_t pixel, const Rgb& radiance) {
    const double wanted[] = {radiance.r, radiance.g, radiance.b};
    double most = 0;
    for (size_t c = 0; c < 3; ++c)
        most = std::max(most, std::fabs(static_cast<double>(film.radiance[c][pixel]) - wanted[c]));
    return most;
}

double brightest(const Film& film) {
    float most = 0;
    for (const auto& plane : film.radiance) most = std::max(most, *std::max_element(plane.begin(), plane.end()));
    return static_cast<double>(most);
}

}  // namespace

Difference compare(const Scene& scene, const Film& ours, const Film& theirs, const Arrivals& arrivals) {
    Difference result;
    result.pixels = static_cast<int64_t>(ours.pixels());
    const double tolerance = flip * brightest(ours);
    for (size_t pixel = 0; pixel < ours.pixels(); ++pixel) {
        if (!same_sphere(scene, ours.id[pixel], theirs.id[pixel])) {
            ++result.other_id;
        } else if (ours.id[pixel] >= 0) {
            const reference::Hit hit = meet(scene, ours, pixel);
            if (hit.id < 0) continue;
            const Rgb sum = sum_of_arrivals(scene, hit, arrivals, pixel);
            result.other_lights += distance(ours, pixel, sum) > tolerance;
        }
    }
    return result;
}

}  // namespace bench
