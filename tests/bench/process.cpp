#include "process.h"

#include <fstream>

#include "../run_program.h"
#include "../scene_json.h"
#include "clock.h"
#include "error.h"
#include "spawn.h"

namespace bench {

using namespace gnomon;
using Json = nlohmann::ordered_json;

namespace {

double wall_seconds(const std::vector<std::string>& arguments, const std::string& caches) {
    const double start = now();
    const int code = run_program({arguments, {{"POCL_CACHE_DIR", caches}, {"XDG_CACHE_HOME", caches}}, nullptr, true});
    const double seconds = now() - start;
    if (code != 0) throw Error(Blame::run, "exit code " + std::to_string(code), arguments.front());
    return seconds;
}

}  // namespace

ProcessTimes time_process(const std::string& name, const Scene& scene, const std::string& device, int runs) {
    const test::TempFolder folder;
    test::write_file(folder / "scene.json", test::to_json(scene).dump());
    const std::vector<std::string> command = {
        GNOMON_PROGRAM, "render", folder / "scene.json", "-o", folder / "picture.png", "--device", device};
    std::vector<std::string> with_stats = command;
    with_stats.insert(with_stats.end(), {"--stats", folder / "stats.json"});
    ProcessTimes times{name, {}, {}, {}};
    for (int i = 0; i < runs; ++i) {
        const test::TempFolder caches;
        times.first.seconds.push_back(wall_seconds(command, caches.path()));
        times.wall.seconds.push_back(wall_seconds(command, caches.path()));
        if (i > 0) continue;
        wall_seconds(with_stats, caches.path());
        times.stats = Json::parse(test::read_file(folder / "stats.json"));
    }
    return times;
}

}  // namespace bench
