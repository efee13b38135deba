// gnomon_bench: seconds a frame with the kernels warm, each kernel's share, a peer in turn with it, and beside every
// time the error of the picture it made, against the double-precision reference.
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "../run_program.h"
#include "clock.h"
#include "device.h"
#include "error.h"
#include "measure.h"
#include "peer.h"
#include "report.h"
#include "scene_io.h"
#include "scenes.h"
#include "spawn.h"
#include "table.h"
#include "temporary_file.h"

namespace {

using namespace gnomon;
using Json = nlohmann::ordered_json;

struct Options {
    std::string device, json, accuracy = "strict";
    std::vector<std::string> scenes, files;
    std::vector<int> cores;
    int pinned = 0;  ///< as a child that runs on so many cores
    int64_t count = 1'000'000;
    bool adversaries = false, no_peer = false, process = false;
    bench::Measure measure;
};

void add_scene_options(CLI::App& app, Options& o) {
    app.add_option("--scene", o.scenes, "these scenes, or adversaries, by name")->delimiter(',')->type_name("NAME,...");
    app.add_option("--file", o.files, "these scene files")->type_name("SCENE.json")->expected(1, -1);
    app.add_flag("--adversaries", o.adversaries, "scenes made to be slow, beside a benign one of as many spheres");
    app.add_option("--count", o.count, "spheres of an adversary")->check(CLI::Range(int64_t{1000}, int64_t{1} << 30));
    app.add_flag("--process", o.process, "the whole program on an example, S4 and S100");
}

void add_options(CLI::App& app, Options& o) {
    app.get_formatter()->column_width(24);
    app.add_option("--device", o.device, "as gnomon's --device")->envname("GNOMON_DEVICE");
    add_scene_options(app, o);
    app.add_option("--cores", o.cores, "once on so many cores each")->delimiter(',')->type_name("N,...");
    app.add_option("--runs", o.measure.runs, "timed frames a scene at most")->check(CLI::PositiveNumber);
    app.add_option("--limit", o.measure.limit, "seconds: fewer frames, or no peer, when they would take longer")
        ->check(CLI::PositiveNumber);
    app.add_option("--accuracy", o.accuracy, "as gnomon's --accuracy");
    app.add_option("--lanes", o.measure.options.lanes, "as gnomon's --lanes");
    app.add_option("--tile", o.measure.options.tile, "as gnomon's --tile");
    app.add_option("--memory", o.measure.options.memory, "as gnomon's --memory")
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
    app.add_flag("--no-embree", o.no_peer, "gnomon alone");
    app.add_option("--json", o.json, "write all that was measured")
        ->type_name("FILE")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--pinned", o.pinned)->group("");  // how --cores calls this program again; not shown
}

/// The scenes that the options name; of the benign scene and the adversaries all, when they are asked for.
std::vector<bench::NamedScene> chosen(const Options& o) {
    std::vector<bench::NamedScene> all = bench::scenes(), result;
    const std::vector<bench::NamedScene> slow = bench::adversaries(o.count);
    const bool usual = o.scenes.empty() && o.files.empty() && !o.adversaries && !o.process;
    std::copy_if(all.begin(), all.end(), std::back_inserter(result), [&](const auto& s) { return usual && s.usual; });
    if (o.adversaries) result = slow;
    all.insert(all.end(), slow.begin(), slow.end());
    for (const std::string& name : o.scenes) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
        if (found == all.end()) throw Error(Blame::input, "there is no scene " + name, "--scene");
        result.push_back(*found);
    }
    return result;
}

/// One process's measurements: on one device, and as many cores as the process has.
class Bench {
  public:
    Bench(const std::vector<DeviceInfo>& devices, Options& options)
        : device_(devices.front()), options_(options), renderer_(devices) {
        const DeviceInfo& device = device_;
        const cpu_set_t cpus = bench::own_cpus();
        options_.measure.threads = CPU_COUNT(&cpus);
        options_.measure.with_peer = !options.no_peer;
        peer_ = options.no_peer ? "none" : bench::peer_name();
        report_ = bench::circumstances(device, options_.measure.threads, peer_);
        report_["runs"] = options_.measure.runs;
        report_["limit_seconds"] = options_.measure.limit;
        report_["longest_launch_bound_seconds"] = options_.measure.options.longest_launch;
        report_["scenes"] = Json::array();
        fmt::print("{}, {}, {} cores; device {} {} ({}, {}); peer: {}\n", bench::date(), bench::cpu_name(),
                   options_.measure.threads, device.number(), device.name, device.platform_name, device.driver, peer_);
    }

    Json run(const std::vector<bench::NamedScene>& scenes) {
        bench::print_head();
        for (const bench::NamedScene& named : scenes) show(named.name, named.about, named.make(), {});
        for (const std::string& path : options_.files) {
            const double start = now();
            const Scene scene = load_scene(path).scene;
            show(path.substr(path.rfind('/') + 1), path, scene, now() - start);
        }
        if (options_.process) run_processes();
        return report_;
    }

  private:
    void show(const std::string& name, const std::string& about, const Scene& scene, std::optional<double> load) {
        bench::SceneTimes times = bench::measure(renderer_, scene, options_.measure);
        times.name = name;
        times.about = about;
        times.load_seconds = load;
        if (name == "benign") benign_ = times;
        bench::print_scene(times, benign_ ? &*benign_ : nullptr, peer_, options_.measure);
        report_["scenes"].push_back(bench::to_json(times));
        if (benign_) {
            Json& entry = report_["scenes"].back();
            entry["gnomon"]["over_benign"] = times.own.frame.median() / benign_->own.frame.median();
        }
    }

    void run_processes() {
        report_["processes"] = Json::array();
        run_process("directional", load_scene(GNOMON_SOURCE_DIR "/examples/directional.json").scene);
        for (const bench::NamedScene& named : bench::scenes())
            if (named.name == "S4" || named.name == "S100") run_process(named.name, named.make());
    }

    void run_process(const std::string& name, const Scene& scene) {
        const auto times = bench::time_process(name, scene, device_.number(), options_.measure.runs);
        bench::print_process(times);
        report_["processes"].push_back(bench::to_json(times));
    }

    const DeviceInfo& device_;
    Options& options_;
    Renderer renderer_;
    std::string peer_;
    Json report_;
    std::optional<bench::SceneTimes> benign_;
};

Json run_here(Options& options) {
    const std::vector<bench::NamedScene> scenes = chosen(options);
    std::vector<std::string> requests;
    if (!options.device.empty()) requests.push_back(options.device);
    const std::vector<DeviceInfo> devices = choose_devices(list_devices(), requests);
    return Bench(devices, options).run(scenes);
}

/// This program again, on so many cores: threads are made once in a process's life, so it must begin there. PoCL goes
/// by its own variable, whose name changed with version 5.
Json run_on(int cores, const std::vector<std::string>& arguments) {
    const cpu_set_t cpus = bench::first_cpus(cores);
    const test::TempFolder folder;
    const std::string count = std::to_string(cores), report = folder / "report.json";
    bench::Spawn spawn{arguments, {{"POCL_MAX_PTHREAD_COUNT", count}, {"POCL_CPU_MAX_CU_COUNT", count}}, &cpus};
    spawn.arguments.front() = std::filesystem::read_symlink("/proc/self/exe").string();
    spawn.arguments.insert(spawn.arguments.end(), {"--pinned", count, "--json", report});
    if (bench::run_program(spawn) != 0) throw Error(Blame::run, "failed on " + count + " cores");
    return Json::parse(test::read_file(report)).at(0);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{"Times warm frames, and measures the error of what they show."};
    Options options;
    add_options(app, options);
    pin_device_threads();
    CLI11_PARSE(app, argc, argv);
    options.measure.options.accuracy = parse_accuracy(options.accuracy);
    if (!options.json.empty()) check_folder(options.json);
    Json reports = Json::array();
    if (options.cores.empty() || options.pinned > 0) {
        reports.push_back(run_here(options));
    } else {
        for (const int cores : options.cores) reports.push_back(run_on(cores, {argv, argv + argc}));
    }
    if (!options.json.empty()) write_text(options.json, reports.dump(2) + "\n");
    return 0;
} catch (const gnomon::Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
