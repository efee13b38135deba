#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <optional>

#include "clock.h"
#include "commands.h"
#include "error.h"
#include "interrupt.h"
#include "scene_io.h"
#include "stats_json.h"
#include "temporary_file.h"

namespace gnomon {

namespace {

View view_named(const std::string& name) {
    if (name == "distance") return View::distance;
    if (name == "normal") return View::normal;
    return name == "id" ? View::id : View::radiance;
}

Outputs either(const Outputs& a, const Outputs& b) {
    return {a.radiance || b.radiance, a.distance || b.distance, a.normal || b.normal, a.id || b.id};
}

/// What all the files together show; without a file, the radiance is still computed, for its summary.
Outputs outputs_for_all(const std::vector<std::string>& paths, const Display& display) {
    if (paths.empty()) return {};
    Outputs all{false, false, false, false};
    for (const std::string& path : paths) all = either(all, outputs_for(path, display));
    return all;
}

/// One line that is written over, on a terminal, once the work has taken a second.
class Progress {
  public:
    explicit Progress(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) != 0), start_(now()) {}
    ~Progress() {
        if (shown_) fmt::print(stderr, "\r\033[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void operator()(double done) {
        const double time = now();
        if (!wanted_ || time - start_ < 1 || time - last_ < 0.1) return;
        fmt::print(stderr, "\r{:3.0f} %, {:.0f} s left ", 100 * done, (time - start_) * (1 - done) / done);
        std::fflush(stderr);
        last_ = time;
        shown_ = true;
    }

  private:
    bool wanted_, shown_ = false;
    double start_, last_ = 0;
};

std::string camera_text(const Camera& c) {
    return fmt::format("eye {} {} {} at {} {} {} up {} {} {} fov {}", c.eye.x, c.eye.y, c.eye.z, c.at.x, c.at.y, c.at.z,
                       c.up.x, c.up.y, c.up.z, c.fov);
}

/// Nothing here changes from run to run: the same scene on the same device writes the same bytes.
Metadata metadata_of(const Scene& scene, const std::vector<DeviceInfo>& devices, const RenderStats& stats,
                     bool shadows) {
    std::string options, names, drivers;
    for (const KernelStats& kernel : stats.kernels)
        options += (devices.size() > 1 ? kernel.device + " " : "") + kernel.kernel + ": " + kernel.options + "\n";
    for (const DeviceInfo& device : devices) {
        const std::string comma = names.empty() ? "" : "; ";
        names += comma + device.name + " (" + device.platform_name + ", " + device.version + ")";
        drivers += comma + device.driver;
    }
    return {{"Software", "gnomon " GNOMON_VERSION},
            {"gnomon:device", names},
            {"gnomon:driver", drivers},
            {"gnomon:options", options},
            {"gnomon:scene", scene.sha1},
            {"gnomon:camera", camera_text(scene.camera)},
            {"gnomon:shadows", shadows ? "on" : "off"},
            {"gnomon:accuracy", to_string(stats.accuracy)}};
}

/// Runs `work` and returns its seconds.
template <class Work>
double timed(const Work& work) {
    const double start = now();
    work();
    return now() - start;
}

}  // namespace

RenderCommand::RenderCommand(CLI::App& app) {
    command_ = app.add_subcommand("render", "Render a scene file.");
    command_->add_option("SCENE", scene_path_, "scene file, JSON")->required();
    command_
        ->add_option("-o,--output", outputs_,
                     "image to write (.exr: all results as numbers; .png and others: one view)")
        ->type_name("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command_
        ->add_option(
            "--device", devices_,
            "P:D as clinfo -l numbers them, cpu, gpu, accel, or part of a name; with /N as N equal parts; all; "
            "again for several at once")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->envname("GNOMON_DEVICE");
    command_->add_option("--size", size_, "instead of the scene's image size")->type_name("WxH");
    command_->add_option("--view", view_, "what a display image shows: radiance, distance, normal or id")
        ->check(CLI::IsMember({"radiance", "distance", "normal", "id"}));
    command_->add_flag("--no-shadows", no_shadows_, "let every light through");
    command_->add_option("--accuracy", accuracy_, "how kernels compute: fast, strict (default), certified or double");
    command_->add_option("--lanes", options_.lanes, "rays a vector: 1, 4, 8 or 16 (default: what the device likes)");
    command_->add_option("--tile", options_.tile, "rays a tile (default: what the device likes)");
    command_
        ->add_option("--memory", options_.memory,
                     "bytes of the device to use at most, such as 512MiB or 2G (default: all that it offers)")
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
    command_->add_option("--exposure", display_.exposure, "brighten a display image by this many stops")
        ->check(CLI::Range(-100.0, 100.0));
    command_->add_option("--bits", display_.bits, "bits a channel of a display image: 8 or 16")
        ->check(CLI::IsMember({8, 16}));
    command_->add_option("--stats", stats_path_, "write what was measured, as JSON")->type_name("FILE");
    command_->add_flag("--quiet", quiet_, "print nothing but warnings and errors");
}

void RenderCommand::say(const std::string& line) const {
    if (!quiet_) fmt::print("{}\n", line);
    std::fflush(stdout);
}

int RenderCommand::run() {
    display_.view = view_named(view_);
    options_.accuracy = parse_accuracy(accuracy_);
    for (const std::string& path : outputs_) check_writable(path, display_);
    if (!stats_path_.empty()) check_folder(stats_path_);
    RunStats stats;
    stats.scene_path = scene_path_;
    LoadedScene loaded;
    stats.load_seconds = timed([&] { loaded = load_scene(scene_path_); });
    for (const std::string& warning : loaded.warnings) fmt::print(stderr, "gnomon: warning: {}\n", warning);
    Scene& scene = loaded.scene;
    if (!size_.empty()) scene.image = parse_size(size_);

    const double start = now();
    const std::vector<DeviceInfo> devices = choose_devices(list_devices(), devices_);
    for (const DeviceInfo& device : devices)
        say("device " + device.number() + ": " + device.name + " (" + device.platform_name + ")");
    std::optional<Renderer> renderer(std::in_place, devices);
    stats.device_seconds = now() - start;

    options_.shadows = !no_shadows_;
    options_.outputs = outputs_for_all(outputs_, display_);
    Film film;
    {
        Progress progress(!quiet_);
        const Stoppable stoppable;
        options_.progress = std::ref(progress);
        options_.stop = stoppable.stop();
        stats.render = renderer->render(scene, options_, film);
    }
    for (const std::string& warning : stats.render.warnings) fmt::print(stderr, "gnomon: warning: {}\n", warning);
    options_.stop = nullptr;
    renderer.reset();  // and what it holds of the device's memory
    const Metadata metadata = metadata_of(scene, devices, stats.render, options_.shadows);
    stats.write_seconds = timed([&] {
        for (const std::string& path : outputs_) write_image(film, path, display_, metadata);
    });
    if (quiet_ && stats_path_.empty()) return 0;
    stats.check_seconds = timed([&] { stats.check = check(scene, film, options_.shadows); });
    if (!stats_path_.empty()) write_text(stats_path_, to_json(stats, scene, devices).dump(2) + "\n");
    say(summary(stats, devices, scene.image));
    if (devices.size() > 1) say(shares(stats.render));
    if (options_.accuracy == Accuracy::certified)
        say(fmt::format(
            "certified: float left {} pixels open, double {} of them, which were decided exactly; {:.1f} ms",
            stats.render.undecided, stats.render.decided_exactly, 1e3 * stats.render.decide_seconds));
    return 0;
}

}  // namespace gnomon
