#include "table.h"

#include <fmt/core.h>

#include <cstdio>

namespace bench {

using namespace gnomon;

namespace {

std::string milliseconds(const Series& s) {
    return fmt::format("{:.2f} [{:.2f}-{:.2f}]", 1e3 * s.median(), 1e3 * s.least(), 1e3 * s.most());
}

std::string error(const Check& c) {
    return fmt::format("{:>6} {:>5} {:>5} {:>8.1e}", c.pixels, c.wrong_ids, c.flips, c.max_radiance);
}

std::string share(double seconds, double of) { return fmt::format("{:.2f}", seconds / of); }

/// One line of the table; every one has the same columns.
void line(const std::string& scene, const std::string& program, const std::string& total, const std::string& build,
          const std::string& trace, const std::string& over_own, const std::string& over_benign,
          const std::string& errors, const std::string& differences) {
    fmt::print("{:13.13} {:31.31} {:>28} {:>10} {:>10} {:>8} {:>8} {:>27} {:>15}\n", scene, program, total, build,
               trace, over_own, over_benign, errors, differences);
}

void print_kernels(const OwnTimes& own) {
    for (size_t k = 0; k < own.kernels.size(); ++k)
        fmt::print("  {:18} {:9.2f} ms  {}\n", own.stats.kernels[k].kernel, 1e3 * own.kernels[k].median(),
                   own.stats.kernels[k].options);
}

void print_peer(const SceneTimes& times, const SceneTimes* benign, const std::string& name, double limit) {
    const PeerTimes& peer = *times.peer;
    if (peer.late) {
        line("", name, fmt::format("over {:.0f}", 1e3 * limit), "", "", "", "", "given up", "");
        return;
    }
    const bool has_benign = benign && benign->peer && !benign->peer->late;
    line("", name + " " + peer.mode, milliseconds(peer.total), fmt::format("{:.2f}", 1e3 * peer.build.median()),
         fmt::format("{:.2f}", 1e3 * peer.frame.median()), share(peer.total.median(), times.own.frame.median()),
         has_benign ? share(peer.total.median(), benign->peer->total.median()) : "", error(peer.check),
         fmt::format("{} / {}", peer.difference.other_id, peer.difference.other_lights));
}

}  // namespace

void print_head() {
    fmt::print(
        "Milliseconds a frame, hierarchy built anew: median [least-most]; of it build and trace, medians. x own: over\n"
        "gnomon's frame. x benign: over the same renderer's frame of the benign scene. Errors: of so many pixels, "
        "wrong\n"
        "ids, flips (another shadow or hit decided) and else the largest error of the radiance over the brightest, "
        "all\n"
        "against double precision. Otherwise: pixels of all where gnomon and the peer found another id / other "
        "lights.\n"
        "\n");
    line("scene", "program", "frame", "build", "trace", "x own", "x benign", "pixels  ids  flips radiance",
         "otherwise");
}

void print_scene(const SceneTimes& times, const SceneTimes* benign, const std::string& peer, const Measure& how) {
    const OwnTimes& own = times.own;
    line(times.name, "gnomon", milliseconds(own.frame), fmt::format("{:.2f}", 1e3 * own.prepare.median()),
         fmt::format("{:.2f}", 1e3 * own.trace.median()), "1",
         benign ? share(own.frame.median(), benign->own.frame.median()) : "", error(own.check), "");
    if (times.peer) print_peer(times, benign, peer, how.limit);
    fmt::print("  {}: {} spheres, {} lights, {}x{}, {} frames, {:.1f} Mrays/s, {}, {} lanes, tiles of {} rays\n",
               times.about, own.stats.spheres, own.stats.lights, times.image.width, times.image.height,
               own.frame.seconds.size(), 1e-6 * static_cast<double>(own.stats.rays) / own.frame.median(),
               to_string(own.stats.accuracy), own.stats.lanes, own.stats.tile_rays);
    fmt::print("  longest launch {:.2f} ms of the {:.0f} that one may take\n", 1e3 * own.longest_launch,
               1e3 * how.options.longest_launch);
    if (times.load_seconds) fmt::print("  loaded in {:.3f} s\n", *times.load_seconds);
    print_kernels(own);
    std::fflush(stdout);
}

void print_process(const ProcessTimes& times) {
    const auto& e = times.stats["error"];
    fmt::print(
        "{:13.13} whole process: first picture {} ms, later ones {} ms; of {} pixels {} wrong ids, {} flips, else "
        "radiance within {:.1e}\n",
        times.name, milliseconds(times.first), milliseconds(times.wall), e["pixels"].get<int64_t>(),
        e["wrong_ids"].get<int64_t>(), e["flips"].get<int64_t>(), e["max_radiance_error"].get<double>());
    std::fflush(stdout);
}

}  // namespace bench
