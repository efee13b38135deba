// Small spheres far away, from as near as they can be to a billion radii.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

/// One sphere of radius 0.1 whose centre is at a distance of 0.1 / ratio; it fills two thirds of the picture's height.
Scene alone(double ratio) {
    const Vec3 ahead = normalize({0.3, 0.2, 0.93});
    Scene scene = small_picture({{ahead * (0.1 / ratio), 0.1}}, two_suns());
    scene.camera = look_at({}, ahead, 3 * std::asin(ratio) * degrees_per_radian);
    return scene;
}

/// At the centre of each pixel a sphere that looks a ten-millionth of a pixel large, or less.
Scene at_pixel_centres(double distance, double radius) {
    Scene scene = small_picture({}, two_suns(), 90);
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 24; ++i)
            scene.spheres.push_back({Vec3{(2 * i - 23) / 16., (15 - 2 * j) / 16., 1} * distance, radius});
    return scene;
}

}  // namespace

std::vector<HardCase> distances() {
    const std::string why = "the squared distance hides the squared radius: their difference loses (d / r)^2 ulp";
    const std::string narrow = why + "; and rays differ by less than float's directions can";
    return {
        {"r / d = 0.5", why, {alone(0.5)}, {{0, 0, 0, 3.4, 4.42e-07}, {0, 0, 0, 6.43, 9.06e-07}}},
        {"r / d = 0.1", why, {alone(0.1)}, {{0, 0, 0, 2.81, 1.74e-06}, {0, 0, 0, 8.01, 4.11e-06}}},
        {"r / d = 1e-2", why, {alone(1e-2)}, {{0, 0, 0, 2.31, 1.96e-05}, {0, 0, 0, 6.68, 5.34e-05}}},
        {"r / d = 1e-3", why, {alone(1e-3)}, {{0, 0, 0, 2.25, 0.000136}, {0, 0, 0, 7.25, 0.0005}}},
        {"r / d = 1e-4", why, {alone(1e-4)}, {{0, 0, 0, 3.55, 0.00122}, {0, 0, 0, 8.5, 0.00428}}},
        {"r / d = 1e-5", why, {alone(1e-5)}, {{0, 0, 0, 2.23, 0.0256}, {1, 0, 2, 5.16, 0.045}}},
        {"r / d = 1e-6", narrow, {alone(1e-6)}, {{1, 0, 0, 2.15, 0.105}, {24, 0, 17, 2.5, 0.236}}},
        {"r / d = 1e-7", narrow, {alone(1e-7)}, {{34, 0, 21, 1.4, 0.677}, {294, 0, 189, 1.69, 0.871}}},
        {"r / d = 1e-8", narrow, {alone(1e-8)}, {{88, 0, 0, 0, 0}, {812, 0, 0, 0, 0}}},
        {"r / d = 1e-9", narrow, {alone(1e-9)}, {{88, 0, 0, 0, 0}, {812, 0, 0, 0, 0}}},
        {"r = 0.1 at 1e7, at pixel centres",
         "only the exact direction meets it",
         {at_pixel_centres(1e7, 0.1)},
         {{376, 0, 16, 0.194, 3.14}, {376, 0, 16, 0.194, 3.14}}},
        {"r = 10 at 1e7, at pixel centres",
         "a direction must be right to 1e-6",
         {at_pixel_centres(1e7, 10)},
         {{0, 0, 6, 2.12, 0.0477}, {0, 0, 6, 2.12, 0.0477}}},
    };
}

}  // namespace gnomon::test
