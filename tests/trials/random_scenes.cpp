#include "rounding.h"
#include "shapes.h"
#include "trials.h"

namespace gnomon::test {

namespace {

void add_spheres(Scene& scene, Random& random) {
    const auto count = static_cast<int>(random.scale(3, 300));
    const double largest = random.scale(0.03, 0.8), smallest = largest * random.scale(1e-6, 1);
    for (int i = 0; i < count; ++i) scene.spheres.push_back({in_cube(random, 1), random.scale(smallest, largest)});
    if (!chance(random, 0.3)) return;
    const double ground = random.scale(3, 1e5);
    scene.spheres.insert(scene.spheres.begin() + whole(random, 0, count), {{0, -1 - ground, 0}, ground});
}

void add_lights(Scene& scene, Random& random) {
    const int count = whole(random, 1, 3);
    for (int i = 0; i < count; ++i)
        if (chance(random, 0.5))
            add_sun(scene, random.direction() * random.scale(0.1, 10));
        else
            add_lamp(scene, random.direction() * random.scale(0.1, 30), 30);
}

void round(double& v) { v = static_cast<double>(round_to_float(v)); }
void round(Vec3& v) {
    for (double* component : {&v.x, &v.y, &v.z}) round(*component);
}
/// All places and radii are floats.
Scene rounded(Scene scene) {
    for (Vec3* v : {&scene.camera.eye, &scene.camera.at, &scene.camera.up}) round(*v);
    for (Sphere& s : scene.spheres) {
        round(s.center);
        round(s.radius);
    }
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light))
            round(point->position);
        else
            round(std::get<DirectionalLight>(light).direction_to_light);
    return scene;
}

/// An eye among the spheres or up to three times as far away as they reach.
Scene make(Random& random) {
    Scene scene;
    scene.image = {whole(random, 64, 128), whole(random, 64, 128)};
    add_spheres(scene, random);
    add_lights(scene, random);
    const Vec3 eye = random.direction() * random.uniform(0, 3), at = in_cube(random, 0.5);
    scene.camera = look_at(eye, at, random.scale(3, 120));
    scene.camera.up = random.direction();
    const double size = chance(random, 0.1) ? random.scale(1e-25, 1e25) : random.scale(1e-3, 1e4);
    scene = scaled(scene, size);
    if (chance(random, 0.5)) scene = moved(scene, random.direction() * (size * random.scale(1, 1e5)));
    return chance(random, 0.5) ? rounded(scene) : scene;
}

}  // namespace

const Maker random_scenes{"random", make};

}  // namespace gnomon::test
