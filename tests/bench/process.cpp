#include "process.h"

#include <array>
#include <fstream>

#include "../run_program.h"
#include "clock.h"
#include "error.h"
#include "spawn.h"

namespace bench {

using namespace gnomon;
using Json = nlohmann::ordered_json;

namespace {

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

/// As scene files have it.
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

double wall_seconds(const std::vector<std::string>& arguments) {
    const double start = now();
    const int code = run_program({arguments, {}, nullptr, true});
    const double seconds = now() - start;
    if (code != 0) throw Error(Blame::run, "exit code " + std::to_string(code), arguments.front());
    return seconds;
}

}  // namespace

ProcessTimes time_process(const std::string& name, const Scene& scene, const std::string& device, int runs) {
    const test::TempFolder folder;
    test::write_file(folder / "scene.json", to_json(scene).dump());
    const std::vector<std::string> command = {
        GNOMON_PROGRAM, "render", folder / "scene.json", "-o", folder / "picture.png", "--device", device};
    std::vector<std::string> with_stats = command;
    with_stats.insert(with_stats.end(), {"--stats", folder / "stats.json"});
    wall_seconds(with_stats);
    ProcessTimes times{name, {}, Json::parse(test::read_file(folder / "stats.json"))};
    for (int i = 0; i < runs; ++i) times.wall.seconds.push_back(wall_seconds(command));
    return times;
}

}  // namespace bench
