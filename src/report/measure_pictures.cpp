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

}  // namespace

Picture measure_picture(Renderer& renderer, const Scene& scene, Accuracy accuracy, const PictureEffort& effort) {
    RenderOptions options;
    options.accuracy = accuracy;
    options.outputs = {true, true, true, true};
    Picture picture{accuracy, {}, 0, {}, {}};
    Film film;
    renderer.render(scene, options, film);  // builds the kernels
    Frames frames;
    for (int i = 0; i < effort.frames; ++i) {
        const double start = now();
        const RenderStats stats = renderer.render(scene, options, film);
        frames.add(now() - start, stats);
    }
    frames.fill(picture);
    picture.error.check = check(scene, film, true, effort.pixels, effort.tests);
    const auto sample = sampled_pixels(scene, film, true, effort.pixels, effort.tests);
    picture.error.shadow_bits = shadow_bits(renderer, scene, options, film, sample);
    return picture;
}

}  // namespace gnomon::report
