#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "clock.h"
#include "trials.h"

namespace gnomon::test {

namespace {

constexpr int64_t confirm_every = 4096;

/// Pictures of one scene, with and without shadows.
struct Pictures {
    Film shadowed, facing;
    RenderStats stats;

    Pictures(Renderer& renderer, const Scene& scene, Accuracy accuracy) {
        RenderOptions options;
        options.accuracy = accuracy;
        options.outputs = {true, false, false, true};
        stats = renderer.render(scene, options, shadowed);
        options.shadows = false;
        options.outputs.id = false;
        options.same_spheres = true;
        renderer.render(scene, options, facing);
    }

    /// Light k shines in channel k.
    oracle::Decisions decisions(size_t p, size_t lights) const {
        oracle::Decisions said{shadowed.id[p], std::vector<bool>(lights), std::vector<bool>(lights)};
        for (size_t k = 0; k < lights; ++k) {
            said.facing[k] = !(facing.radiance[k][p] == 0);
            said.lit[k] = !(shadowed.radiance[k][p] == 0);
        }
        return said;
    }
};

class Trial {
  public:
    Trial(const Scene& scene, std::string name, int64_t most)
        : scene_(scene), name_(std::move(name)), most_(most), truth_(scene) {}

    void compare(const Pictures& pictures) {
        for (int j = 0; j < scene_.image.height; ++j)
            for (int i = 0; i < scene_.image.width; ++i) compare(pictures, i, j);
    }
    Tally tally;

  private:
    void compare(const Pictures& pictures, int i, int j) {
        const size_t lights = scene_.lights.size(),
                     p = static_cast<size_t>(j) * static_cast<size_t>(scene_.image.width) + static_cast<size_t>(i);
        const oracle::QuickOracle::Answer truth = truth_.decide(i, j);
        if (!truth.exactly && tally.pixels % confirm_every == 0) confirm(truth.decisions, i, j);
        count(truth, static_cast<int64_t>(lights));
        const oracle::Decisions said = pictures.decisions(p, lights);
        if (!(said == truth.decisions)) look_closer(said, truth.decisions, i, j);
    }

    void count(const oracle::QuickOracle::Answer& truth, int64_t lights) {
        const int64_t at_hit = truth.decisions.id >= 0 ? lights : 0;
        ++tally.pixels;
        ++tally.rays;
        tally.shadows += at_hit;
        tally.facings += at_hit;
        if (truth.exactly) tally.exactly += 1 + at_hit;
    }

    void confirm(const oracle::Decisions& quick, int i, int j) {
        ++tally.confirmed;
        const oracle::Decisions exact = truth_.exact().decide(i, j);
        if (exact == quick) return;
        ++tally.contradictions;
        print("THE ORACLE CONTRADICTS ITSELF", i, j, {"quickly", quick}, {"exactly", exact});
    }

    void print(const char* what, int i, int j, const Answer& a, const Answer& b) {
        if (most_-- <= 0) return;
        fmt::print("{} in {}, {}\n", what, name_, to_string(scene_, i, j, a, b));
        std::fflush(stdout);
    }

    /// What differs is wrong, unless it is just too dark for a float.
    void look_closer(const oracle::Decisions& said, const oracle::Decisions& truth, int i, int j) {
        confirm(truth, i, j);
        int64_t wrong = said.id != truth.id;
        if (wrong == 0)
            for (size_t k = 0; k < truth.lit.size(); ++k) {
                if (said.facing[k] == truth.facing[k] && said.lit[k] == truth.lit[k]) continue;
                if (is_dark(said, truth, k, i, j))
                    ++tally.too_dark;
                else
                    wrong += (said.facing[k] != truth.facing[k]) + (said.lit[k] != truth.lit[k]);
            }
        tally.wrong += wrong;
        if (wrong > 0) print("WRONG", i, j, {"the picture says", said}, {"the truth", truth});
    }

    /// Whether light k is black where it arrives, or would without shadows, and is too little for a float there.
    bool is_dark(const oracle::Decisions& said, const oracle::Decisions& truth, size_t k, int i, int j) const {
        if (said.facing[k] || said.lit[k] || !truth.facing[k]) return false;
        Scene alone = scene_;
        if (!truth.lit[k]) alone.spheres = {sphere_of(scene_, truth.id)};
        const Rgb r = oracle::Oracle(alone).look(i, j).reflected[k];
        return std::max({r.r, r.g, r.b}) < std::numeric_limits<float>::min();
    }

    const Scene& scene_;
    std::string name_;
    int64_t most_;
    oracle::QuickOracle truth_;
};

}  // namespace

Tally try_scene(Renderer& renderer, const Scene& scene, const std::string& name, Accuracy accuracy, int64_t most) {
    const double start = now();
    const Pictures pictures(renderer, scene, accuracy);
    const double rendered = now();
    Trial trial(scene, name, most);
    trial.compare(pictures);
    Tally& tally = trial.tally;
    tally.scenes = 1;
    tally.refined = pictures.stats.undecided;
    tally.decided_exactly = pictures.stats.decided_exactly;
    tally.render_seconds = rendered - start;
    tally.oracle_seconds = now() - rendered;
    return tally;
}

}  // namespace gnomon::test
