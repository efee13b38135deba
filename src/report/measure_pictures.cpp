#include "measure_pictures.h"

#include "clock.h"
#include "shadow_bits.h"

namespace gnomon::report {

namespace {

/// Seconds and kernels of one frame after the other.
class Frames {
  public:
    void add(double seconds, const RenderStats& stats) {
        seconds_.push_back(seconds);
        kernels_.resize(stats.kernels.size());
        for (size_t k = 0; k < kernels_.size(); ++k) kernels_[k].push_back(stats.kernels[k].seconds);
        last_ = stats;
    }
    void fill(Picture& picture) const {
        picture.seconds = series(seconds_);
        picture.rays = last_.rays;
        for (size_t k = 0; k < kernels_.size(); ++k)
            if (last_.kernels[k].rays > 0) picture.kernels.push_back(kernel(k));  // not what is done once a sphere
    }

  private:
    KernelTime kernel(size_t k) const {
        const KernelStats& stats = last_.kernels[k];
        std::vector<double> times;
        for (const double seconds : kernels_[k]) times.push_back(1e9 * seconds / static_cast<double>(stats.rays));
        return {stats.kernel, stats.options, series(times), stats.rays};
    }

    std::vector<double> seconds_;
    std::vector<std::vector<double>> kernels_;
    RenderStats last_;
};

RenderOptions options_of(Accuracy accuracy) {
    RenderOptions options;
    options.accuracy = accuracy;
    options.outputs = {true, true, true, true};
    return options;
}

PictureError error_of(Renderer& renderer, const Scene& scene, Accuracy accuracy, const Film& film,
                      const PictureEffort& effort) {
    const auto sample = sampled_pixels(scene, film, true, effort.pixels, effort.tests);
    return {check(scene, film, true, effort.pixels, effort.tests),
            shadow_bits(renderer, scene, options_of(accuracy), film, sample)};
}

}  // namespace

std::vector<Picture> measure_pictures(Renderer& renderer, const Scene& scene, const std::vector<Accuracy>& accuracies,
                                      const PictureEffort& effort) {
    std::vector<Film> films(accuracies.size());
    std::vector<Frames> frames(accuracies.size());
    for (size_t i = 0; i < accuracies.size(); ++i)
        renderer.render(scene, options_of(accuracies[i]), films[i]);  // builds the kernels
    for (int round = 0; round < effort.frames; ++round)
        for (size_t i = 0; i < accuracies.size(); ++i) {
            const double start = now();
            const RenderStats stats = renderer.render(scene, options_of(accuracies[i]), films[i]);
            frames[i].add(now() - start, stats);
        }
    std::vector<Picture> pictures;
    for (size_t i = 0; i < accuracies.size(); ++i) {
        pictures.push_back({accuracies[i], {}, 0, {}, error_of(renderer, scene, accuracies[i], films[i], effort)});
        frames[i].fill(pictures.back());
    }
    return pictures;
}

}  // namespace gnomon::report
