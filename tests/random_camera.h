// Cameras anywhere, looking anywhere, and a tile that holds all they see.
#pragma once

#include "kernel_harness.h"
#include "scene.h"

namespace gnomon::test {

inline Scene random_camera(Random& random, double fov, int width, int height) {
    Scene scene;
    scene.image = {width, height};
    scene.camera.eye = random.direction() * random.scale(0.01, 1e4);
    const Vec3 ahead = random.direction();
    scene.camera.at = scene.camera.eye + ahead * random.scale(0.1, 100);
    scene.camera.up = random.direction();
    while (length(cross(scene.camera.up, ahead)) < 0.1) scene.camera.up = random.direction();
    scene.camera.fov = fov;
    return scene;
}

/// A tile that holds the whole image.
inline Tile whole(const ImageSize& image) {
    const int x = (image.width + BLOCK_SIDE - 1) / BLOCK_SIDE, y = (image.height + BLOCK_SIDE - 1) / BLOCK_SIDE;
    return {0, 0, x, x * y};
}

}  // namespace gnomon::test
