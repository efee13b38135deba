// Telescopes pointed at an edge: the whole picture lies within a small part of a radius of it.
#include "adversaries.h"

#include "shapes.h"

namespace gnomon::test {

namespace {

/// Around, but mostly not before, what is looked at.
void add_bystanders(Scene& scene, Random& random, double size, int most) {
    const int count = whole(random, 0, most);
    for (int i = 0; i < count; ++i) scene.spheres.push_back({in_cube(random, 10 * size), size * random.scale(0.01, 2)});
}

void add_lights(Scene& scene, Random& random, double size) {
    add_sun(scene, random.direction());
    add_lamp(scene, random.direction() * (size * random.scale(2, 20)), 20 * size);
}

/// Towards a point where a line from the eye touches the sphere.
Vec3 limb(Random& random, const Vec3& eye, const Sphere& s) {
    const Vec3 f = s.center - eye;
    const double along = std::sqrt(dot(f, f) - s.radius * s.radius), sine = s.radius / length(f);
    return eye + (normalize(f) * std::sqrt(1 - sine * sine) + across(random, f) * sine) * along;
}

}  // namespace

Scene limbs(Random& random) {
    Scene scene = picture(random);
    const Sphere s{in_cube(random, 3), random.scale(0.1, 3)};
    scene.spheres = {s};
    add_bystanders(scene, random, 1, 20);
    add_lights(scene, random, 3);
    const Vec3 eye = s.center + random.direction() * (s.radius * (1 + random.scale(1e-3, 1e4)));
    aim(scene, random, eye, limb(random, eye, s), s.radius * zoom(random));
    return scene;
}

/// Hundreds of spheres along one way, which all but touches each of them.
Scene gauntlets(Random& random) {
    Scene scene = picture(random);
    const Vec3 eye = in_cube(random, 3), dir = random.direction();
    const double off = zoom(random), far = random.scale(1, 1e3);
    for (int i = static_cast<int>(random.scale(3, 300)); i > 0; --i) {
        const double ahead = random.scale(0.01, 1) * far, radius = ahead * random.scale(1e-3, 1);
        const Vec3 foot = eye + dir * ahead;
        scene.spheres.push_back({foot + across(random, dir) * (radius * (1 + random.uniform(-off, off))), radius});
    }
    add_lights(scene, random, far);
    aim(scene, random, eye, eye + dir * far, far * off);
    return scene;
}

/// The horizon of a large ground, on which balls stand near and far.
Scene horizons(Random& random) {
    Scene scene = picture(random);
    const double radius = random.scale(1e2, 1e8), height = random.scale(1e-2, 10);
    const Sphere ground{{0, -radius - height, 0}, radius};
    scene.spheres = {ground};
    const Vec3 target = limb(random, {0, 0, 0}, ground);
    for (int i = whole(random, 0, 12); i > 0; --i) {
        const double size = random.scale(0.1, 3) * height;
        const Vec3 up = normalize(target * random.uniform(0.1, 1.5) + in_cube(random, 5 * height) - ground.center);
        scene.spheres.push_back({ground.center + up * (radius + size), size});
    }
    add_sun(scene, Vec3{0, random.scale(1e-4, 1), 0} + across(random, {0, 1, 0}));
    add_lamp(scene, target * random.uniform(0, 1) + Vec3{0, 3 * height, 0}, length(target));
    aim(scene, random, {0, 0, 0}, target, length(target) * height / length(target) * zoom(random));
    return scene;
}

/// Spheres whose surfaces all go through one point.
Scene crossings(Random& random) {
    Scene scene = picture(random);
    const Vec3 point = in_cube(random, 3), ahead = random.direction();
    for (int i = whole(random, 2, 5); i > 0; --i) {
        const double radius = random.scale(0.1, 30);
        scene.spheres.push_back({point - facing(random, ahead) * radius, radius});
    }
    add_bystanders(scene, random, 1, 10);
    add_sun(scene, facing(random, ahead));
    add_lamp(scene, point + facing(random, ahead) * random.scale(0.01, 10), 10);
    aim(scene, random, point + ahead * random.scale(0.01, 100), point, 0.1 * zoom(random));
    return scene;
}

/// A sun and a lamp in the plane that touches a sphere where the eye looks.
Scene day_and_night(Random& random) {
    Scene scene = picture(random);
    const Sphere s{in_cube(random, 3), random.scale(0.1, chance(random, 0.3) ? 1e6 : 10)};
    const Vec3 n = random.direction(), place = s.center + n * s.radius;
    scene.spheres = {s};
    if (chance(random, 0.5)) add_bystanders(scene, random, 0.3, 10);
    add_sun(scene, across(random, n) * random.scale(0.1, 10));
    add_lamp(scene, place + across(random, n) * (s.radius * random.scale(1e-2, 1e2)), s.radius);
    const Vec3 eye =
        place + normalize(n + across(random, n) * random.uniform(0, 2)) * (s.radius * random.scale(1e-2, 10));
    aim(scene, random, eye, place, s.radius * zoom(random));
    return scene;
}

/// On some ground, where the shadows of spheres end: of some in the sun, of one in a lamp's light.
Scene shadow_edges(Random& random) {
    Scene scene = picture(random);
    const Sphere ground{in_cube(random, 3), random.scale(1, chance(random, 0.3) ? 1e7 : 30)};
    const Vec3 n = random.direction(), place = ground.center + n * ground.radius;
    scene.spheres = {ground};
    const auto hide = [&](const Vec3& l, double ahead) {
        const double radius = random.scale(0.01, 3);
        scene.spheres.push_back({place + l * ahead + across(random, l) * radius, radius});
    };
    const Vec3 sun = facing(random, n), lamp = facing(random, n);
    const double far = random.scale(0.1, 30);
    for (auto i = static_cast<int>(random.scale(1, 100)); i > 0; --i) hide(sun, random.scale(0.01, 30));
    hide(lamp, chance(random, 0.3) ? far * (1 + sign(random) * little(random, 1, 12)) : far * random.uniform(0, 1));
    add_bystanders(scene, random, 0.1, 10);
    add_sun(scene, sun);
    add_lamp(scene, place + lamp * far, far);
    aim(scene, random, place + facing(random, n) * random.scale(0.01, 10), place, zoom(random));
    return scene;
}

/// Unit spheres that fill the picture from very far.
Scene specks(Random& random) {
    Scene scene = picture(random);
    const double far = std::pow(10, random.uniform(3, 8));
    for (int i = whole(random, 5, 60); i > 0; --i) scene.spheres.push_back({in_cube(random, 8), random.scale(0.1, 2)});
    add_lights(scene, random, 8);
    aim(scene, random, random.direction() * far, in_cube(random, 2), random.scale(0.3, 8));
    return scene;
}

}  // namespace gnomon::test
