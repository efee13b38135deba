// What hard scenes are made of.
#pragma once

#include <cmath>

#include "scene.h"

namespace gnomon::test {

constexpr double degrees_per_radian = 180 / 3.14159265358979323846;

inline Camera look_at(const Vec3& eye, const Vec3& at, double fov) {
    Camera camera;
    camera.eye = eye;
    camera.at = at;
    camera.fov = fov;
    return camera;
}

/// A sun aslant from behind the eye, and one whose shadows run across the picture.
inline std::vector<Light> two_suns() {
    return {DirectionalLight{{1, 2, -1.5}, {2, 3, 4}}, DirectionalLight{{-3, 1, -0.5}, {4, 3, 2}}};
}

/// From the origin along z, 24 x 16 pixels.
inline Scene small_picture(std::vector<Sphere> spheres, std::vector<Light> lights, double fov = 60) {
    Scene scene;
    scene.image = {24, 16};
    scene.camera.fov = fov;
    scene.spheres = std::move(spheres);
    scene.lights = std::move(lights);
    return scene;
}

/// Balls of different sizes before, behind and beside each other, and what they stand on; all within 20 of the origin.
/// Coordinates are thirds and tenths, which no binary number is.
inline Scene still_life() {
    Scene scene = small_picture({{{0, -100.1, 10}, 98.3},
                                 {{-2.1, 0.1, 9.7}, 1.7},
                                 {{1 / 3., -1.1, 7.3}, 2 / 3.},
                                 {{2.3, 0.7, 12.1}, 2.3},
                                 {{1.1, 0.9, 8.9}, 0.3},
                                 {{-0.7, 1.9, 11.3}, 0.9},
                                 {{-0.9, 0.3, 7.7}, 0.1}},
                                two_suns());
    scene.image = {36, 24};
    scene.lights.push_back(PointLight{{3.1, 4.7, 2.9}, {500, 600, 700}});
    return scene;
}

/// All of a scene `factor` times as large, and so bright that its radiance stays.
inline Scene scaled(Scene scene, double factor) {
    scene.camera.eye = scene.camera.eye * factor;
    scene.camera.at = scene.camera.at * factor;
    for (Sphere& s : scene.spheres) s = {s.center * factor, s.radius * factor, s.albedo};
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            const Rgb& p = point->power;
            *point = {point->position * factor, {p.r * factor * factor, p.g * factor * factor, p.b * factor * factor}};
        }
    return scene;
}

inline Scene moved(Scene scene, const Vec3& by) {
    scene.camera.eye = scene.camera.eye + by;
    scene.camera.at = scene.camera.at + by;
    for (Sphere& s : scene.spheres) s.center = s.center + by;
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) point->position = point->position + by;
    return scene;
}

}  // namespace gnomon::test
