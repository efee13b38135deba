// Lamps and eyes at, or all but at, surfaces.
#include "adversaries.h"
#include "shapes.h"

namespace gnomon::test {

/// A lamp or two at, or all but at, the surface of balls.
Scene lamps_at_surfaces(Random& random) {
    Scene scene = picture(random);
    for (int i = whole(random, 2, 20); i > 0; --i) scene.spheres.push_back({in_cube(random, 2), random.scale(0.1, 2)});
    for (int i = whole(random, 1, 3); i > 0; --i) {
        const Sphere s = scene.spheres[random.word() % scene.spheres.size()];
        add_lamp(scene, s.center + random.direction() * (s.radius * (1 + sign(random) * little(random, 1, 16))), 3);
    }
    aim(scene, random, random.direction() * random.scale(3, 30), in_cube(random, 1), random.uniform(0.3, 3));
    return scene;
}

/// An eye at, or all but at, the surface of a ball of any size.
Scene eyes_at_surfaces(Random& random) {
    Scene scene = picture(random);
    const Sphere s{in_cube(random, 1), random.scale(0.1, chance(random, 0.3) ? 1e6 : 10)};
    const Vec3 n = random.direction(), eye = s.center + n * (s.radius * (1 + sign(random) * little(random, 1, 16)));
    scene.spheres = {s};
    for (int i = whole(random, 2, 20); i > 0; --i)
        scene.spheres.push_back({eye + facing(random, n) * random.scale(0.1, 10), random.scale(0.01, 1)});
    add_sun(scene, facing(random, n));
    add_lamp(scene, eye + facing(random, n) * random.scale(0.1, 10), 10);
    const Vec3 way =
        chance(random, 0.7) ? normalize(across(random, n) + n * random.uniform(-0.3, 0.3)) : random.direction();
    scene.camera = look_at(eye, eye + way, random.scale(10, 120));
    scene.camera.up = across(random, way);
    return scene;
}

}  // namespace gnomon::test
