// Spheres that touch, all but touch or coincide.
#include <algorithm>

#include "adversaries.h"
#include "shapes.h"

namespace gnomon::test {

namespace {

void shuffle(Random& random, std::vector<Sphere>& spheres) {
    for (size_t i = spheres.size(); i > 1; --i) std::swap(spheres[i - 1], spheres[random.word() % i]);
}

/// Something to see around the origin: from outside, now and then from inside.
void look_around(Scene& scene, Random& random, double size) {
    add_sun(scene, random.direction());
    add_lamp(scene, random.direction() * (size * random.scale(0.1, 10)), 10 * size);
    const double far = size * (chance(random, 0.2) ? random.uniform(0.1, 0.9) : random.scale(1.5, 100));
    const Vec3 eye = random.direction() * far;
    aim(scene, random, eye, in_cube(random, 0.3 * size), far < size ? size : size * random.scale(0.03, 1.2));
}

/// From beside it, near or far, through a telescope.
void look_at_contact(Scene& scene, Random& random, const Sphere& a, const Sphere& b) {
    const Vec3 way = normalize(b.center - a.center), contact = a.center + way * a.radius;
    const Vec3 eye =
        contact + (across(random, way) + way * random.uniform(-0.3, 0.3)) * (a.radius * random.scale(0.3, 300));
    aim(scene, random, eye, contact, a.radius * zoom(random));
}

}  // namespace

/// In each other with little between them, or nothing.
Scene nested(Random& random) {
    Scene scene = picture(random);
    const double radius = random.scale(0.3, 30), gap = little(random, 1, 16);
    const Vec3 toward = random.direction() * (chance(random, 0.5) ? 0 : random.uniform(0, 1.1));
    for (int i = whole(random, 2, 6); i > 0; --i)
        scene.spheres.push_back({toward * (radius * gap * i), radius * (1 - gap * i)});
    for (int i = whole(random, 0, 2); i > 0; --i) scene.spheres.push_back(scene.spheres[0]);
    shuffle(random, scene.spheres);
    look_around(scene, random, radius);
    return scene;
}

/// Equal spheres that lie in each other but for a little.
Scene twins(Random& random) {
    Scene scene = picture(random);
    const double radius = random.scale(0.3, 30);
    for (int i = whole(random, 2, 4); i > 0; --i)
        scene.spheres.push_back({random.direction() * (radius * little(random, 1, 16)), radius});
    look_around(scene, random, radius);
    return scene;
}

/// Each touches the one before it, from outside or inside.
Scene chains(Random& random) {
    Scene scene = picture(random);
    Sphere last{{0, 0, 0}, random.scale(0.1, 1)};
    for (int i = whole(random, 3, 60); i > 0; --i) {
        scene.spheres.push_back(last);
        const double radius = random.scale(0.03, 1),
                     way = chance(random, 0.7) ? last.radius + radius : last.radius - radius;
        last = {last.center + random.direction() * way, radius};
        if (length(last.center) > 3) last.center = last.center * 0.5;
    }
    look_around(scene, random, 3);
    if (chance(random, 0.7)) look_at_contact(scene, random, scene.spheres[0], scene.spheres[1]);
    return scene;
}

/// Balls on a large ground in a low sun, from a child's height.
Scene standing_balls(Random& random) {
    Scene scene = picture(random);
    const double radius = random.scale(1e2, 1e7);
    const Vec3 center{0, -1 - radius, 0};
    scene.spheres = {{center, radius}};
    for (int i = whole(random, 3, 100); i > 0; --i) {
        const double size = random.scale(0.03, 1);
        const Vec3 up = normalize(in_cube(random, 15) + Vec3{0, 0, 17} - center);
        scene.spheres.push_back({center + up * (radius + size * (1 - little(random, 0, 16))), size});
    }
    add_sun(scene, Vec3{0, random.scale(1e-3, 1), 0} + across(random, {0, 1, 0}));
    add_lamp(scene, {random.uniform(-5, 5), random.scale(1e-3, 5) - 1, random.uniform(2, 20)}, 10);
    scene.camera = look_at({0, 0, 0}, {0, random.uniform(-0.5, 0), 1}, random.scale(10, 90));
    if (chance(random, 0.5)) look_at_contact(scene, random, scene.spheres[1], scene.spheres[0]);
    return scene;
}

}  // namespace gnomon::test
