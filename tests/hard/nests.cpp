// Spheres that touch, overlap, lie in each other and coincide.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

std::vector<Light> lamp_and_suns() {
    std::vector<Light> lights = two_suns();
    lights.push_back(PointLight{{1.7, 2.3, 3.1}, {100, 200, 300}});
    return lights;
}

/// In each other around one centre, `gap` apart; the largest has the highest id.
Scene concentric(double radius, double gap, int count) {
    Scene scene = small_picture({}, lamp_and_suns(), 40);
    for (int i = count - 1; i >= 0; --i) scene.spheres.push_back({{0, 0, 10}, radius - i * gap});
    return scene;
}

/// In each other and touching at the top, where `toward` points.
Scene touching_inside(const Vec3& toward) {
    Scene scene = small_picture({}, lamp_and_suns(), 40);
    for (int i = 1; i <= 4; ++i) scene.spheres.push_back({Vec3{0, 0, 10} + toward * (4.0 - i), 1.0 * i});
    return scene;
}

/// Like beads on a string, each of which touches the next.
Scene touching_outside() {
    Scene scene = small_picture({}, lamp_and_suns(), 40);
    for (int i = -3; i <= 3; ++i) scene.spheres.push_back({{2. * i * 3 / 5, 0, 12 + 2. * i * 4 / 5}, 1});
    return scene;
}

/// Two of equal size that overlap almost wholly: their surfaces cross in a great circle.
Scene apart(const Vec3& by) { return small_picture({{{0, 0, 10}, 3}, {Vec3{0, 0, 10} + by, 3}}, lamp_and_suns(), 40); }

/// Eye and still life inside a sphere, and lamps outside: near its surface, and so far that it looks small.
Scene inside(double distance) {
    Scene scene = still_life();
    const Vec3 center{0, 0, 10};
    scene.spheres.erase(scene.spheres.begin());
    scene.spheres.push_back({center, 30});
    scene.lights = {PointLight{center + Vec3{2, 3, -6} * (distance / 7), {1e4, 1e4, 1e4}},
                    PointLight{center + Vec3{-6, 2, 3} * (distance / 7), {1e4, 1e4, 1e4}}};
    return scene;
}

}  // namespace

std::vector<HardCase> nests() {
    const std::string order = "the order of hits that are all but equally far",
                      shadow = "; and each is in the outer ones' shadow";
    const double ulp = 0x1p-49;  // of 10, in double
    return {
        {"nested 4e-5 apart",
         order + shadow,
         {concentric(3, 4e-5, 4)},
         {{0, 0, 0, 1.98, 3.72e-07}, {0, 0, 0, 2.8, 6.74e-07}}},
        {"nested 1e-7 apart",
         order + shadow,
         {concentric(3, 1e-7, 4)},
         {{0, 108, 3, 1.78, 3.72e-07}, {0, 964, 135, 2.78, 6.74e-07}}},
        {"nested 1e-13 apart", order + shadow, {concentric(3, 1e-13, 4)}, {{0, 148, 0, 0, 0}, {0, 1356, 0, 0, 0}}},
        {"concentric, half as large",
         "the outer hides all, and the inner casts no shadow",
         {concentric(3, 0.5, 6)},
         {{0, 0, 0, 1.98, 3.72e-07}, {0, 0, 0, 2.8, 6.74e-07}}},
        {"touching inside",
         order + " around a point",
         {touching_inside({0, 1, 0}), touching_inside({0, 0, -1})},
         {{0, 0, 0, 2.39, 3.16e-07}, {0, 0, 0, 2.82, 5.81e-07}}},
        {"touching outside",
         "shadows that end in a point, where light enters between two",
         {touching_outside()},
         {{0, 0, 0, 1.9, 2.66e-06}, {0, 0, 0, 3.41, 2.67e-06}}},
        {"apart by 1e-3, 1e-7",
         order + " along a circle",
         {apart({1e-3, 0, 0}), apart({0, 1e-7, 0})},
         {{0, 68, 76, 3.29, 8.01e-07}, {0, 630, 670, 2.8, 7.22e-07}}},
        {"apart by an ulp of double",
         order,
         {apart({0, 0, ulp}), apart({0, 0, -ulp}), apart({ulp / 1024, 0, 0})},
         {{0, 222, 269, 1.98, 3.72e-07}, {0, 2034, 2368, 2.8, 6.74e-07}}},
        {"inside a sphere, lamps outside",
         "shadowed by what no ray from the eye meets first",
         {inside(30.001), inside(35), inside(700)},
         {{0, 0, 0, 2.72, 3.67e-06}, {0, 0, 0, 6.08, 3.68e-06}}},
        {"coincident",
         "they count as one, without a shadow on themselves",
         {apart({}), concentric(3, 0, 20)},
         {{0, 0, 0, 1.98, 3.72e-07}, {0, 0, 0, 2.8, 6.74e-07}}},
    };
}

}  // namespace gnomon::test
