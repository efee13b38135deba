// Point lights where they are hard to tell from what they light or what hides them.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

// What is lit: a sphere below, a sphere beside, and a wall behind.
Scene room(const Vec3& light, std::vector<Sphere> more) {
    Scene scene = small_picture({{{0, -103, 10}, 100}, {{-3.5, 0, 10}, 2}, {{0, 0, 1020}, 1000}},
                                {PointLight{light, {1000, 1000, 1000}}}, 70);
    scene.image = {36, 24};
    scene.spheres.insert(scene.spheres.end(), more.begin(), more.end());
    return scene;
}

/// The light `off` above the top of a sphere.
Scene over(double off) { return room({0, 2 + off, 10}, {{{0, 0, 10}, 2}}); }

/// The centre pixel sees (0, 0, 8) of a sphere; the way from there to the light, through (0, 4, 4), enters another
/// sphere at (0, 4, 4), where the light is but for a share of the way.
Scene at_occluder(double beyond) {
    Scene scene = small_picture({{{0, 0, 10}, 2}, {{0, 8, 1}, 5}},
                                {PointLight{{0, 4 + 4 * beyond, 4 - 4 * beyond}, {100, 100, 100}}}, 1e-2);
    scene.image = {17, 17};
    return scene;
}

/// The light at a point that the centre pixel sees, or so far before it.
Scene at_hit(double before) {
    Scene scene = small_picture({{{0, 0, 10}, 2}}, {PointLight{{0, 0, 8 - before}, {1, 1, 1}}}, 1e-2);
    scene.image = {17, 17};
    return scene;
}

/// The way from (0, 0, 8) to the light touches the sphere, or passes through or by so little.
Scene grazing(double change) {
    Scene scene =
        small_picture({{{0, 0, 10}, 2}, {{5, 4, 4}, 5 * (1 + change)}}, {PointLight{{0, 8, 0}, {100, 100, 100}}}, 1e-4);
    scene.image = {17, 17};
    return scene;
}

}  // namespace

std::vector<HardCase> point_lights() {
    const std::string own = "the sphere that the light is on hides half the room", centre = " in the middle pixel";
    return {
        {"lamp on a surface", own, {over(0)}, {{0, 0, 0, 3.19, 4.82e-07}, {0, 0, 0, 9.49, 1.14e-06}}},
        {"lamp 1e-6 over a surface", own, {over(1e-6)}, {{0, 0, 0, 3.19, 4.82e-07}, {0, 0, 0, 9.49, 1.14e-06}}},
        {"lamp 1e-6 under a surface",
         "it lights nothing",
         {over(-1e-6)},
         {{0, 0, 0, 3.19, 4.82e-07}, {0, 0, 0, 9.49, 1.14e-06}}},
        {"lamp 1e-13 over and under a surface",
         own + " or all of it",
         {over(1e-13), over(-1e-13)},
         {{0, 0, 351, 3.19, 4.82e-07}, {0, 0, 3206, 9.49, 1.14e-06}}},
        {"lamp inside a sphere",
         "it lights nothing",
         {over(-2), over(-1), over(-1.99)},
         {{0, 0, 0, 3.19, 4.82e-07}, {0, 0, 0, 9.49, 1.14e-06}}},
        {"lamp at the occluder's distance",
         "the segment ends on it" + centre,
         {at_occluder(0)},
         {{0, 0, 0, 0.283, 5.05e-11}, {0, 0, 0, 0.307, 7.7e-11}}},
        {"lamp beyond the occluder by 1e-6, 1e-9",
         "the segment ends behind it" + centre,
         {at_occluder(1e-6), at_occluder(1e-9)},
         {{0, 0, 289, 0.283, 5.05e-11}, {0, 0, 2601, 0.307, 7.7e-11}}},
        {"lamp before the occluder by 1e-6, 1e-9",
         "the segment ends before it" + centre,
         {at_occluder(-1e-6), at_occluder(-1e-9)},
         {{0, 0, 0, 0.283, 5.05e-11}, {0, 0, 0, 0.307, 7.7e-11}}},
        {"lamp at distance 0",
         "no direction" + centre,
         {at_hit(0)},
         {{0, 0, 0, 0.283, 5.05e-11}, {0, 0, 0, 0.307, 7.7e-11}}},
        {"lamp at distance 1e-6, 1e-13",
         "direction and distance are roundings" + centre,
         {at_hit(1e-6), at_hit(1e-13)},
         {{0, 0, 1, 0.283, 5.05e-11}, {0, 0, 1, 0.307, 7.7e-11}}},
        {"ways to a lamp that graze",
         "touched exactly" + centre,
         {grazing(0), grazing(1e-9), grazing(-1e-9)},
         {{0, 0, 33, 2.83e-05, 1.24e-13}, {0, 0, 254, 3.07e-05, 3.16e-13}}},
    };
}

}  // namespace gnomon::test
