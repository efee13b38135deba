// Places that are whole numbers: equal distances, and lines that touch spheres exactly.
#include <optional>

#include "adversaries.h"
#include "shapes.h"

namespace gnomon::test {

namespace {

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

}  // namespace

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

}  // namespace gnomon::test
