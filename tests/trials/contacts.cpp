// Spheres, lamps and eyes that touch, all but touch or coincide, and lines that touch spheres exactly.
#include <algorithm>
#include <optional>

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

/// In each other with little between them, or nothing.
Scene nests_of(Random& random) {
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

/// On whole numbers, where equal distances abound: touching balls, and an eye, a sun and a lamp in places like theirs.
Scene lattices(Random& random) {
    Scene scene = picture(random);
    const auto somewhere = [&](int most) {
        const int x = whole(random, -most, most), y = whole(random, -most, most);
        return Vec3{1. * x, 1. * y, 1. * whole(random, -most, most)};
    };
    for (int i = whole(random, 5, 40); i > 0; --i)
        scene.spheres.push_back({somewhere(3) * 2, chance(random, 0.9) ? 1. : 2.});
    add_sun(scene, somewhere(2) + Vec3{0, 0.5, 0});
    add_lamp(scene, somewhere(8), 8);
    const Vec3 ahead[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}, {0, 1, -1}};
    const Vec3 dir = ahead[whole(random, 0, 5)];
    scene.camera = look_at(dir * -14, {0, 0, 0}, 50);
    scene.camera.up = dir.x == 0 ? Vec3{1, 0, 0} : Vec3{-dir.y, dir.x, 1};
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

/// A vector across (a, b, c) of whole numbers and whole length, if one is found.
std::optional<Vec3> whole_across(Random& random, int a, int b, int c) {
    for (int attempt = 0; attempt < 20000; ++attempt) {
        const int x = whole(random, -40, 40), y = whole(random, -40, 40);
        if ((a * x + b * y) % c != 0) continue;
        const int z = -(a * x + b * y) / c, squared = x * x + y * y + z * z;
        const auto root = static_cast<int>(std::lround(std::sqrt(squared)));
        if (squared > 0 && root * root == squared) return Vec3{1. * x, 1. * y, 1. * z};
    }
    return {};
}

/// Rays through whole numbers (odd, odd, 8), and spheres that some of them touch exactly, or miss or meet by little.
Scene touches(Random& random) {
    Scene scene;
    const int times = 2 * whole(random, 1, 4) + 1;  // odd: pixels have their centres where 8 x 8 have them
    scene.image = {8 * times, 8 * times};
    scene.camera.fov = 90;
    while (scene.spheres.size() < 6) {
        const int a = 2 * whole(random, -4, 3) + 1, b = 2 * whole(random, -4, 3) + 1;
        const auto p = whole_across(random, a, b, 8);
        if (!p) continue;
        const double change = chance(random, 0.5) ? 0 : sign(random) * little(random, 5, 16);
        const Vec3 foot = Vec3{1. * a, 1. * b, 8.} * whole(random, 1, 100);
        scene.spheres.push_back({foot + *p, length(*p) * (1 + change)});
    }
    add_sun(scene, {1, 2, -1.5});
    add_lamp(scene, in_cube(random, 20) + Vec3{0, 0, 100}, 300);
    return scene;
}

}  // namespace

const std::vector<Maker>& contacts() {
    static const std::vector<Maker> all = {{"nests", nests_of},
                                           {"twins", twins},
                                           {"chains", chains},
                                           {"lattices", lattices},
                                           {"standing balls", standing_balls},
                                           {"lamps at surfaces", lamps_at_surfaces},
                                           {"eyes at surfaces", eyes_at_surfaces},
                                           {"touches", touches}};
    return all;
}

}  // namespace gnomon::test
