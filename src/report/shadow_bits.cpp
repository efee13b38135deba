#include "shadow_bits.h"

#include "reference.h"

namespace gnomon::report {

namespace {

constexpr Rgb white{1, 1, 1};

/// The same scene under one of its lights.
Scene under(const Scene& scene, const Light& light) {
    Scene alone = scene;
    alone.lights = {light};
    if (auto* point = std::get_if<PointLight>(&alone.lights[0]))
        point->power = white;
    else
        std::get<DirectionalLight>(alone.lights[0]).irradiance = white;
    return alone;
}

bool black(const Rgb& color) { return color.r == 0 && color.g == 0 && color.b == 0; }

bool bright(const Film& film, size_t pixel) {
    return film.radiance[0][pixel] > 0 || film.radiance[1][pixel] > 0 || film.radiance[2][pixel] > 0;
}

/// The reference's hits where the picture has the same; id -1 elsewhere.
std::vector<reference::Hit> right_hits(const Scene& scene, const Film& film, const std::vector<size_t>& sample) {
    std::vector<reference::Hit> hits;
    const auto width = static_cast<size_t>(film.width);
    for (const size_t p : sample) {
        const auto ray = reference::eye_ray(scene, static_cast<int>(p % width), static_cast<int>(p / width));
        hits.push_back(reference::closest_hit(scene, ray));
        if (hits.back().id != film.id[p]) hits.back().id = -1;
    }
    return hits;
}

}  // namespace

Decisions shadow_bits(Renderer& renderer, const Scene& scene, const RenderOptions& options, const Film& film,
                      const std::vector<size_t>& sample) {
    const std::vector<reference::Hit> hits = right_hits(scene, film, sample);
    RenderOptions again = options;
    again.outputs = {};
    again.same_spheres = true;
    Decisions bits;
    Film lit;
    for (const Light& light : scene.lights) {
        const Scene alone = under(scene, light);
        renderer.render(alone, again, lit);
        for (size_t i = 0; i < sample.size(); ++i) {
            const reference::Hit& hit = hits[i];
            if (hit.id < 0 || black(sphere_of(scene, hit.id).albedo)) continue;
            const bool reaches = reference::cosine(hit, light) > 0 && !reference::in_between(scene, hit, light);
            ++bits.of;
            bits.wrong += reaches != bright(lit, sample[i]);
        }
    }
    return bits;
}

}  // namespace gnomon::report
