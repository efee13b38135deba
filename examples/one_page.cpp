// One page against the library: two spheres, one light, a picture and the distance in its middle.
#include <cstdio>
#include <vector>

#include "device.h"
#include "error.h"
#include "image_io.h"
#include "render.h"

int main(int argc, char** argv) try {
    gnomon::Scene scene;
    scene.image = {640, 480};
    scene.camera.eye = {0, 0.5, -5};
    scene.camera.at = {0, 0, 0};
    scene.camera.fov = 40;
    scene.spheres = {{{0, 0, 0}, 1, {0.9, 0.6, 0.2}}, {{0, -101, 0}, 100, {0.5, 0.5, 0.5}}};
    scene.lights = {gnomon::DirectionalLight{{1, 2, -2}, {3, 3, 3}}};

    const std::vector<gnomon::DeviceInfo> devices = gnomon::list_devices();
    gnomon::Renderer renderer(gnomon::choose_device(devices, ""));
    gnomon::RenderOptions options;
    options.outputs = {true, true, true, true};  // radiance, distance, normal, id
    gnomon::Film film;
    renderer.render(scene, options, film);

    std::printf("distance in the middle: %g\n", static_cast<double>(film.distance[film.pixels() / 2 + 320]));
    gnomon::write_image(film, argc > 1 ? argv[1] : "one_page.png", {}, {});
    return 0;
} catch (const gnomon::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
}
