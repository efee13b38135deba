#include "scenes.h"

#include <cmath>
#include <cstdint>

namespace bench {

namespace {

using namespace gnomon;

/// splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014); 24 bits a draw.
class Random {
  public:
    explicit Random(uint64_t seed) : state_(seed) {}
    double in(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 40) / 16777216.0; }

    Sphere sphere(const Vec3& low, const Vec3& high, double r_low, double r_high) {
        Sphere s;
        s.center.x = in(low.x, high.x);
        s.center.y = in(low.y, high.y);
        s.center.z = in(low.z, high.z);
        s.radius = in(r_low, r_high);
        s.albedo.r = in(0.2, 0.9);
        s.albedo.g = in(0.2, 0.9);
        s.albedo.b = in(0.2, 0.9);
        return s;
    }

  private:
    uint64_t next() {
        uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    uint64_t state_;
};

Light directional(Vec3 direction, double e) { return DirectionalLight{direction, {e, e, e}}; }
Light point(Vec3 position, double p) { return PointLight{position, {p, p, p}}; }

const Sphere ground{{0, -1000, 0}, 1000, {0.5, 0.5, 0.5}};

Scene four() {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{0, 2.5, -9}, {0, 1, 0}, {0, 1, 0}, 40};
    scene.spheres = {ground,
                     {{-2.2, 1, 0.5}, 1, {0.9, 0.2, 0.2}},
                     {{0, 1.2, 0}, 1.2, {0.2, 0.9, 0.2}},
                     {{2, 0.8, -1}, 0.8, {0.2, 0.3, 0.9}}};
    scene.lights = {directional({1, 2, -1.5}, 1.5), point({-4, 5, -4}, 500)};
    return scene;
}

Scene hundred() {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{0, 4, -20}, {0, 2, 0}, {0, 1, 0}, 40};
    scene.spheres = {ground};
    Random random(100);
    while (scene.spheres.size() < 100) scene.spheres.push_back(random.sphere({-8, 0.3, -8}, {8, 5, 8}, 0.2, 0.7));
    scene.lights = {directional({1, 2, -1.5}, 1), directional({-2, 1.5, 0.5}, 0.6), point({0, 9, -6}, 1200)};
    return scene;
}

/// `count` spheres in the cube [-50, 50)^3 whose volumes add up to 5 % of it.
Scene cube(int count) {
    Scene scene;
    scene.image = {1920, 1080};
    scene.camera = {{50, 45, -115}, {0, 0, 0}, {0, 1, 0}, 40};
    // The mean of r^3, uniform from 0.5 to 1.5 r0, is 1.25 r0^3.
    const double r0 = std::cbrt(0.05 * 1e6 / (count * 1.25 * 4 / 3 * 3.14159265358979323846));
    Random random(static_cast<uint64_t>(count));
    for (int i = 0; i < count; ++i)
        scene.spheres.push_back(random.sphere({-50, -50, -50}, {50, 50, 50}, 0.5 * r0, 1.5 * r0));
    scene.lights = {directional({1, 2, -1.5}, 1.5), point({0, 100, -120}, 400000)};
    return scene;
}

}  // namespace

std::vector<NamedScene> scenes() {
    return {
        {"S4", four}, {"S100", hundred}, {"S1e4", [] { return cube(10000); }}, {"S1e6", [] { return cube(1000000); }}};
}

}  // namespace bench
