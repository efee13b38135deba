#include "unit.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

namespace {

double reach(const Scene& scene) {
    double farthest = 0;
    for (const Sphere& s : scene.spheres) farthest = std::max(farthest, length(s.center - scene.camera.eye) + s.radius);
    return farthest;
}

/// Divides a light's lengths by the unit.
struct InUnit {
    Vec3 eye;
    double unit;

    Light operator()(const DirectionalLight& light) const { return light; }
    Light operator()(const PointLight& light) const {
        const Rgb& p = light.power;
        // Taken twice: the square of an extreme unit may be out of range where the scaled power is not.
        const double share = 1 / unit;
        return PointLight{(light.position - eye) * share,
                          {p.r * share * share, p.g * share * share, p.b * share * share}};
    }
};

}  // namespace

double choose_unit(const Scene& scene) {
    const double farthest = reach(scene);
    if (farthest == 0 || (farthest >= 0x1p-20 && farthest <= 0x1p40)) return 1;
    return std::ldexp(1.0, std::ilogb(farthest));
}

Scene in_unit(Scene scene, double unit) {
    Camera& camera = scene.camera;
    const Vec3 eye = camera.eye;
    camera.at = camera.at - eye;  // a direction: it has no unit
    camera.eye = {};
    for (Sphere& s : scene.spheres) {
        s.center = (s.center - eye) * (1 / unit);
        s.radius /= unit;
    }
    for (Light& light : scene.lights) light = std::visit(InUnit{eye, unit}, light);
    return scene;
}

}  // namespace gnomon
