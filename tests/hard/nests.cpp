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

}  // namespace

std::vector<HardCase> nests() {
    const std::string order = "the order of hits that are all but equally far",
                      shadow = "; and each is in the outer ones' shadow";
    const double ulp = 0x1p-49;  // of 10, in double
    return {
        {"nested 4e-5 apart", order + shadow, {concentric(3, 4e-5, 4)}, {}},
        {"nested 1e-7 apart", order + shadow, {concentric(3, 1e-7, 4)}, {}},
        {"nested 1e-13 apart", order + shadow, {concentric(3, 1e-13, 4)}, {}},
        {"concentric, half as large",
         "the outer hides all, and the inner casts no shadow",
         {concentric(3, 0.5, 6)},
         {}},
        {"touching inside", order + " around a point", {touching_inside({0, 1, 0}), touching_inside({0, 0, -1})}, {}},
        {"touching outside", "shadows that end in a point, where light enters between two", {touching_outside()}, {}},
        {"apart by 1e-3, 1e-7", order + " along a circle", {apart({1e-3, 0, 0}), apart({0, 1e-7, 0})}, {}},
        {"apart by an ulp of double", order, {apart({0, 0, ulp}), apart({0, 0, -ulp}), apart({ulp / 1024, 0, 0})}, {}},
        {"coincident", "they count as one, without a shadow on themselves", {apart({}), concentric(3, 0, 20)}, {}},
    };
}

}  // namespace gnomon::test
