// gnomon_bench: seconds a frame with the kernels warm, each kernel's share, and beside every time the error of the
// picture it made, against the double-precision reference.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "clock.h"
#include "error.h"
#include "reference.h"
#include "render.h"
#include "scenes.h"

namespace {

using namespace gnomon;

struct Errors {
    long pixels = 0, wrong_ids = 0;
    double max_distance = 0, max_radiance = 0;  // relative; radiance relative to the picture's largest
    long wrong_radiance = 0;                    // pixels off by more than 1e-4 of the largest: shadow or id flips
};

/// Every `stride`-th pixel in both directions against the reference.
Errors check(const Scene& scene, const Film& film, int stride) {
    Errors e;
    const float brightest = *std::max_element(film.radiance[0].begin(), film.radiance[0].end());
    for (int j = 0; j < film.height; j += stride)
        for (int i = 0; i < film.width; i += stride) {
            const size_t p = static_cast<size_t>(j) * static_cast<size_t>(film.width) + static_cast<size_t>(i);
            const reference::Hit hit = reference::closest_hit(scene.spheres, reference::eye_ray(scene, i, j));
            const Rgb expected = reference::radiance(scene, hit, true);
            const double off = std::fabs(film.radiance[0][p] - expected.r) / brightest;
            ++e.pixels;
            e.wrong_ids += film.id[p] != hit.id;
            if (film.id[p] == hit.id && hit.id >= 0)
                e.max_distance = std::max(e.max_distance, std::fabs(film.distance[p] - hit.t) / hit.t);
            e.wrong_radiance += off > 1e-4;
            if (off <= 1e-4) e.max_radiance = std::max(e.max_radiance, off);
        }
    return e;
}

struct Timing {
    double median, least, most;
};

Timing summary(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    return {seconds[seconds.size() / 2], seconds.front(), seconds.back()};
}

void run(Renderer& renderer, const bench::NamedScene& named, RenderOptions options, int runs, int stride) {
    Film film;
    RenderStats stats = renderer.render(named.scene, options, film);
    std::vector<double> frames;
    std::vector<std::vector<double>> kernels(stats.kernels.size());
    for (int i = 0; i < runs; ++i) {
        const double start = now();
        stats = renderer.render(named.scene, options, film);
        frames.push_back(now() - start);
        for (size_t k = 0; k < kernels.size(); ++k) kernels[k].push_back(stats.kernels[k].seconds);
    }
    const Timing frame = summary(frames);
    options.outputs = {true, true, true, true};
    Film all;
    renderer.render(named.scene, options, all);
    const Errors e = check(named.scene, all, stride);
    fmt::print(
        "{:5} {}x{} W={} tile {} rays: {:.2f} ms [{:.2f}-{:.2f}], {:.0f} Mrays/s | of {} pixels: {} wrong ids, {} "
        "wrong "
        "radiances, else radiance within {:.1e}, distance within {:.1e}\n",
        named.name, film.width, film.height, stats.lanes, stats.tile_rays, 1e3 * frame.median, 1e3 * frame.least,
        1e3 * frame.most, 1e-6 * static_cast<double>(stats.rays) / frame.median, e.pixels, e.wrong_ids,
        e.wrong_radiance, e.max_radiance, e.max_distance);
    for (size_t k = 0; k < kernels.size(); ++k)
        fmt::print("      {:18} {:60.60} {:7.2f} ms\n", stats.kernels[k].kernel, stats.kernels[k].options,
                   1e3 * summary(kernels[k]).median);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{"Times warm frames, and measures the error of what they show."};
    std::string device, only;
    int runs = 21, stride = 16, lanes = 0, tile = 0;
    app.add_option("--device", device, "as gnomon's --device")->envname("GNOMON_DEVICE");
    app.add_option("--scene", only, "this scene alone");
    app.add_option("--runs", runs, "timed frames a scene");
    app.add_option("--stride", stride, "check every n-th pixel in both directions");
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
        if (only.empty() || only == named.name) run(renderer, named, options, runs, stride);
    return 0;
} catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
