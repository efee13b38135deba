#include "measure_hard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle.h"

namespace gnomon::test {

namespace {

constexpr int64_t most_pixels = 8192;

/// One ulp of float at t. Below the normal numbers it stays what it is.
double ulp(double t) {
    const int exponent = std::max(std::ilogb(t), std::numeric_limits<float>::min_exponent - 1);
    return std::ldexp(1.0, exponent - (std::numeric_limits<float>::digits - 1));
}

double angle(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Films of one scene: the first hit, and each light alone.
struct Films {
    Film first;
    std::vector<Film> lights;

    Films(Renderer& renderer, Scene scene, RenderOptions options) : lights(scene.lights.size()) {
        options.outputs = {false, true, true, true};
        renderer.render(scene, options, first);
        options.outputs = {true, false, false, false};
        options.same_spheres = true;
        const std::vector<Light> all = scene.lights;
        for (size_t i = 0; i < all.size(); ++i) {
            scene.lights = {all[i]};
            renderer.render(scene, options, lights[i]);
        }
    }
    bool lit(size_t light, size_t p) const {
        const auto& channels = lights[light].radiance;
        return std::any_of(std::begin(channels), std::end(channels),
                           [p](const Plane<float>& c) { return !(c[p] == 0); });
    }
};

class Comparison {
  public:
    Comparison(Measured& measured, const Films& films) : measured_(measured), films_(films) {}

    void compare(const oracle::Pixel& truth, size_t p, const std::string& where) {
        ++measured_.pixels;
        Figures& figures = measured_.figures;
        const int64_t wrong_before = figures.wrong_decisions(), id = films_.first.id[p];
        figures.hits += (id >= 0) != (truth.hit.id >= 0);
        figures.ids += id >= 0 && truth.hit.id >= 0 && id != truth.hit.id;
        if (id >= 0 && id == truth.hit.id) {
            compare_hit(truth.hit, p, where);
            for (size_t light = 0; light < truth.lit.size(); ++light)
                figures.shadows += tells(truth, light) && films_.lit(light, p) != truth.lit[light];
        }
        if (figures.wrong_decisions() > wrong_before && measured_.first_wrong.empty()) measured_.first_wrong = where;
    }

  private:
    void compare_hit(const oracle::Hit& hit, size_t p, const std::string& where) {
        const Film& film = films_.first;
        const Vec3 normal{film.normal[0][p], film.normal[1][p], film.normal[2][p]};
        worse(measured_.figures.t, std::fabs(static_cast<double>(film.distance[p]) - hit.t) / ulp(hit.t),
              measured_.worst_t, where);
        worse(measured_.figures.normal, angle(normal, hit.normal), measured_.worst_normal, where);
    }
    /// A NaN is the worst of all.
    static void worse(double& most, double value, std::string& at, const std::string& where) {
        if (value <= most) return;
        most = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
        at = where;
    }
    /// What arrives may be too little for a float that is not 0: that says nothing about shadows.
    static bool tells(const oracle::Pixel& truth, size_t light) {
        const Rgb& r = truth.reflected[light];
        return !truth.lit[light] || std::max({r.r, r.g, r.b}) >= std::numeric_limits<float>::min();
    }

    Measured& measured_;
    const Films& films_;
};

void measure(Renderer& renderer, const Scene& scene, const RenderOptions& options, const std::string& name,
             Measured& measured) {
    const Films films(renderer, scene, options);
    const oracle::Oracle oracle(scene);
    Comparison comparison(measured, films);
    const int64_t pixels = int64_t{scene.image.width} * scene.image.height, count = std::min(pixels, most_pixels);
    for (int64_t k = 0; k < count; ++k) {
        const int64_t p = k * pixels / count;
        const int i = static_cast<int>(p % scene.image.width), j = static_cast<int>(p / scene.image.width);
        const std::string where = name + ", pixel (" + std::to_string(i) + ", " + std::to_string(j) + ")";
        comparison.compare(oracle.look(i, j), static_cast<size_t>(p), where);
    }
}

}  // namespace

Measured measure(Renderer& renderer, const HardCase& hard, const RenderOptions& options, int times) {
    Measured measured;
    for (size_t i = 0; i < hard.scenes.size(); ++i) {
        Scene scene = hard.scenes[i];
        if (scene.image.width <= 100 && scene.image.height <= 100) {
            scene.image.width *= times;
            scene.image.height *= times;
        }
        measure(renderer, scene, options, "scene " + std::to_string(i), measured);
    }
    return measured;
}

}  // namespace gnomon::test
