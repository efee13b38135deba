// Lenses, vectors and images at the end of their range.
#include "hard_case.h"
#include "scene_parts.h"

namespace gnomon::test {

namespace {

Scene seen(double fov, const Vec3& at) {
    Scene scene = still_life();
    scene.camera.fov = fov;
    scene.camera.at = at;
    return scene;
}

Scene leaning(double angle) {
    Scene scene = still_life();
    scene.camera.at = {0.2, 0.1, 1};
    scene.camera.up = scene.camera.at + Vec3{-0.3, 1, 0.1} * angle;
    return scene;
}

Scene shaped(int width, int height) {
    Scene scene = still_life();
    scene.image = {width, height};
    if (height > width) scene.camera.fov = 60;
    if (width > height) scene.camera.fov = 90.0 / width;  // 90 pixels are about a radian
    return scene;
}

}  // namespace

std::vector<HardCase> cameras() {
    const Vec3 limb{-2.1 + 1.5, 0.1 + 0.6, 9.7};
    return {
        {"field of view 1e-3 degrees",
         "rays differ in their last 14 bits",
         {seen(1e-3, {-2.1, 0.1, 9.7}), seen(1e-3, limb)},
         {{0, 0, 0, 2.07, 1.03e-06}, {0, 0, 0, 2.42, 1.24e-06}}},
        {"field of view 179.99 degrees",
         "rays are parallel to the image, and pixels far apart",
         {seen(179.99, {0, 0, 1}), seen(179.99, {0.5, -1, 3})},
         {{0, 0, 0, 7.39, 6.52e-08}, {0, 0, 0, 12.2, 2.19e-07}}},
        {"up 1e-6 off the view",
         "up x z is the difference of nearly equal numbers",
         {leaning(1e-6)},
         {{0, 0, 0, 5.73, 3.13e-06}, {0, 0, 0, 273, 6.42e-06}}},
        {"up 1e-12 off the view",
         "up x z is the difference of nearly equal numbers",
         {leaning(1e-12)},
         {{0, 0, 0, 7.63, 1.79e-06}, {0, 0, 0, 49.8, 6.01e-06}}},
        {"up 1e-14 off the view",
         "up x z is nothing but what rounding left of it",
         {leaning(1e-14)},
         {{0, 0, 0, 8.23, 1.31e-06}, {0, 0, 0, 12.4, 5.16e-06}}},
        {"10000 x 1 pixels",
         "the image is ten thousand times as wide as high",
         {shaped(10000, 1)},
         {{0, 0, 0, 11.8, 6.38e-06}, {0, 0, 0, 11.8, 6.38e-06}}},
        {"1 x 10000 pixels",
         "the image is ten thousand times as high as wide",
         {shaped(1, 10000)},
         {{0, 0, 0, 3.33, 2.33e-06}, {0, 0, 0, 3.33, 2.33e-06}}},
    };
}

}  // namespace gnomon::test
