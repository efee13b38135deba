#include "picture.h"

#include <fmt/core.h>

namespace gnomon::verify {

std::string to_string(const Mode& mode) {
    const std::string name = gnomon::to_string(mode.accuracy);
    return mode.accuracy == Accuracy::certified && !mode.fp64 ? name + " without fp64" : name;
}

std::vector<Mode> modes(const DeviceInfo& device) {
    std::vector<Mode> able;
    for (const Accuracy accuracy : available_accuracies(device))
        if (accuracy != Accuracy::fast) able.push_back({accuracy, device.fp64});
    return able;
}

std::vector<Mode> recorded_modes() {
    return {
        {Accuracy::strict, true}, {Accuracy::certified, true}, {Accuracy::certified, false}, {Accuracy::full, true}};
}

std::string picture_name(const Case& of, const Mode& mode) {
    return fmt::format("{} {}x{} {}", of.name, of.scene.image.width, of.scene.image.height, to_string(mode));
}

RenderStats render(Renderer& renderer, const Case& of, const Mode& mode, Film& film) {
    RenderOptions options;
    options.outputs = {true, true, true, true};
    options.accuracy = mode.accuracy;
    options.memory = of.memory;
    return renderer.render(of.scene, options, film);
}

RenderStats render_light(Renderer& renderer, const Case& of, const Mode& mode, size_t light, bool shadows, Film& film) {
    RenderOptions options;
    options.accuracy = mode.accuracy;
    options.memory = of.memory;
    options.shadows = shadows;
    options.same_spheres = true;
    Scene alone = of.scene;
    alone.lights = {of.scene.lights.at(light)};
    return renderer.render(alone, options, film);
}

}  // namespace gnomon::verify
