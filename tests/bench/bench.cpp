// gnomon_bench: seconds a frame with the kernels warm, each kernel's share, and beside every time the error of the
// picture it made, against the double-precision reference.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "check.h"
#include "clock.h"
#include "error.h"
#include "render.h"
#include "scenes.h"

namespace {

using namespace gnomon;

struct Timing {
    double median, least, most;
};

Timing summary(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    return {seconds[seconds.size() / 2], seconds.front(), seconds.back()};
}

void run(Renderer& renderer, const bench::NamedScene& named, RenderOptions options, int runs) {
    const Scene scene = named.make();
    Film film;
    RenderStats stats = renderer.render(scene, options, film);
    std::vector<double> frames, traces, prepares;
    std::vector<std::vector<double>> kernels(stats.kernels.size());
    for (int i = 0; i < runs; ++i) {
        const double start = now();
        stats = renderer.render(scene, options, film);
        frames.push_back(now() - start);
        traces.push_back(stats.trace_seconds);
        prepares.push_back(stats.prepare_seconds);
        for (size_t k = 0; k < kernels.size(); ++k) kernels[k].push_back(stats.kernels[k].seconds);
    }
    const Timing frame = summary(frames);
    options.outputs = {true, true, true, true};
    Film all;
    renderer.render(scene, options, all);
    const Check error = check(scene, all, true, 1 << 13, int64_t{1} << 29);
    fmt::print(
        "{:5} {}x{} W={} tile {} rays: {:.2f} ms [{:.2f}-{:.2f}], {:.0f} Mrays/s | of {} pixels: {} wrong ids, "
        "{} flips, else radiance within {:.1e}, distance within {:.1e}\n",
        named.name, film.width, film.height, stats.lanes, stats.tile_rays, 1e3 * frame.median, 1e3 * frame.least,
        1e3 * frame.most, 1e-6 * static_cast<double>(stats.rays) / frame.median, error.pixels, error.wrong_ids,
        error.flips, error.max_radiance, error.max_distance);
    fmt::print("      of it prepare {:.2f} ms, trace {:.2f} ms\n", 1e3 * summary(prepares).median,
               1e3 * summary(traces).median);
    for (size_t k = 0; k < kernels.size(); ++k)
        fmt::print("      {:18} {:60.60} {:7.2f} ms\n", stats.kernels[k].kernel, stats.kernels[k].options,
                   1e3 * summary(kernels[k]).median);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{"Times warm frames, and measures the error of what they show."};
    std::string device, only;
    int runs = 21, lanes = 0, tile = 0;
    app.add_option("--device", device, "as gnomon's --device")->envname("GNOMON_DEVICE");
    app.add_option("--scene", only, "this scene alone");
    app.add_option("--runs", runs, "timed frames a scene");
    app.add_option("--lanes", lanes, "as gnomon's --lanes");
    app.add_option("--tile", tile, "as gnomon's --tile");
    CLI11_PARSE(app, argc, argv);
    const std::vector<DeviceInfo> devices = list_devices();
    const DeviceInfo& info = choose_device(devices, device);
    fmt::print("device {} {} ({}, {})\n", info.number(), info.name, info.platform_name, info.driver);
    Renderer renderer(info);
    RenderOptions options;
    options.lanes = lanes;
    options.tile = tile;
    for (const bench::NamedScene& named : bench::scenes())
        if (only.empty() || only == named.name) run(renderer, named, options, runs);
    return 0;
} catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
