#include "measure.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "clock.h"
#include "peer.h"

namespace bench {

using namespace gnomon;

namespace {

// The check's own limits: so many pixels, and so many ray-sphere tests of the reference, 1 to 10 ns each.
constexpr int64_t check_pixels = 1 << 13, check_tests = int64_t{1} << 29;
constexpr double long_try_seconds = 2;  // a try of one of the peer's modes

template <class Work>
double timed(const Work& work) {
    const double start = now();
    work();
    return now() - start;
}

double sorted_at(std::vector<double> seconds, size_t i) {
    std::sort(seconds.begin(), seconds.end());
    return seconds.at(i);
}

/// A scene with its renderers, ready for one round of timing after another.
class Race {
  public:
    Race(Renderer& renderer, const Scene& scene, const Measure& how)
        : renderer_(renderer), scene_(scene), how_(how), peer_film_(scene.image.width, scene.image.height, {}) {
        if (how.with_peer) peer_ = make_peer(scene, how.threads);
    }

    /// Renders once unmeasured, chooses the peer's mode, then times; returns what both needed.
    void run() {
        result.image = scene_.image;
        render();
        const double own_seconds = timed([&] { render(); });
        const double seconds = own_seconds + (peer_ ? choose_mode() : 0);
        const int runs = std::clamp(static_cast<int>(how_.limit / seconds), 1, how_.runs);
        result.own.kernels.resize(result.own.stats.kernels.size());
        for (int i = 0; i < runs; ++i) {
            time_own();
            if (peer_ && !result.peer->late) time_peer();
        }
        examine();
    }

    SceneTimes result;

  private:
    /// Seconds of the fastest mode. Each has its turn twice, or once when that takes long.
    double choose_mode() {
        result.peer.emplace();
        result.peer->late = true;
        peer_->build(peer_->modes().front());  // its threads start
        double best = std::numeric_limits<double>::infinity();
        for (int round = 0; round < 2 && (round == 0 || best < long_try_seconds); ++round)
            for (const std::string& mode : peer_->modes()) {
                const double seconds = try_mode(mode);
                if (seconds >= best) continue;
                best = seconds;
                result.peer->mode = mode;
                result.peer->late = false;
            }
        return result.peer->late ? 0 : best;
    }

    /// Infinity when the frame was given up.
    double try_mode(const std::string& mode) {
        bool whole = true;
        const double seconds = timed([&] {
            peer_->build(mode);
            whole = peer_->frame(peer_film_, how_.limit);
        });
        return whole ? seconds : std::numeric_limits<double>::infinity();
    }

    void render() {
        OwnTimes& own = result.own;
        own.stats = renderer_.render(scene_, how_.options, film_);
        own.longest_launch = std::max(own.longest_launch, own.stats.longest_launch);
    }

    void time_own() {
        OwnTimes& own = result.own;
        own.frame.seconds.push_back(timed([&] { render(); }));
        own.prepare.seconds.push_back(own.stats.prepare_seconds);
        own.trace.seconds.push_back(own.stats.trace_seconds);
        for (size_t k = 0; k < own.kernels.size(); ++k) own.kernels[k].seconds.push_back(own.stats.kernels[k].seconds);
    }

    void time_peer() {
        PeerTimes& peer = *result.peer;
        const double build = timed([&] { peer_->build(peer.mode); });
        const double frame = timed([&] { peer.late = !peer_->frame(peer_film_, how_.limit); });
        peer.build.seconds.push_back(build);
        peer.frame.seconds.push_back(frame);
        peer.total.seconds.push_back(build + frame);
    }

    /// Both pictures against the reference, and against each other.
    void examine() {
        RenderOptions options = how_.options;
        options.outputs = {true, true, true, true};
        Film whole;
        renderer_.render(scene_, options, whole);
        result.own.check = check(scene_, whole, true, check_pixels, check_tests);
        if (!peer_ || result.peer->late) return;
        Outputs outputs;
        outputs.id = true;
        Film theirs(scene_.image.width, scene_.image.height, outputs);
        Arrivals arrivals;
        result.peer->late = !peer_->picture(theirs, arrivals, 2 * how_.limit);
        if (result.peer->late) return;
        result.peer->check = check(scene_, theirs, true, check_pixels, check_tests);
        result.peer->difference = compare(scene_, whole, theirs, arrivals);
    }

    Renderer& renderer_;
    const Scene& scene_;
    const Measure& how_;
    std::unique_ptr<Peer> peer_;
    Film film_, peer_film_;
};

}  // namespace

double Series::median() const { return sorted_at(seconds, seconds.size() / 2); }
double Series::least() const { return sorted_at(seconds, 0); }
double Series::most() const { return sorted_at(seconds, seconds.size() - 1); }

SceneTimes measure(Renderer& renderer, const Scene& scene, const Measure& how) {
    Race race(renderer, scene, how);
    race.run();
    return std::move(race.result);
}

}  // namespace bench
