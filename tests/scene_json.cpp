#include "scene_json.h"

#include <array>

namespace gnomon::test {

namespace {

using Json = nlohmann::ordered_json;

std::array<double, 3> list(const Vec3& v) { return {v.x, v.y, v.z}; }
std::array<double, 3> list(const Rgb& c) { return {c.r, c.g, c.b}; }

Json to_json(const Light& light) {
    if (const auto* lamp = std::get_if<PointLight>(&light))
        return {{"type", "point"}, {"position", list(lamp->position)}, {"power", list(lamp->power)}};
    const auto& sun = std::get<DirectionalLight>(light);
    return {{"type", "directional"},
            {"direction_to_light", list(sun.direction_to_light)},
            {"irradiance", list(sun.irradiance)}};
}

}  // namespace

Json to_json(const Scene& scene) {
    const Camera& camera = scene.camera;
    Json json;
    json["image"] = {{"width", scene.image.width}, {"height", scene.image.height}};
    json["camera"] = {{"eye", list(camera.eye)}, {"at", list(camera.at)}, {"up", list(camera.up)}, {"fov", camera.fov}};
    json["spheres"] = Json::array();
    for_each_sphere(scene, [&](int64_t, const Sphere& s) {
        json["spheres"].push_back({{"center", list(s.center)}, {"radius", s.radius}, {"albedo", list(s.albedo)}});
    });
    json["lights"] = Json::array();
    for (const Light& light : scene.lights) json["lights"].push_back(to_json(light));
    return json;
}

}  // namespace gnomon::test
