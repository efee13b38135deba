// The pixels that rounding may have decided, computed again with the same kernels, each by itself.
#pragma once

#include <vector>

#include "binder.h"
#include "film.h"
#include "program.h"
#include "workers.h"

namespace gnomon {

/// Writes pixels of which the plan's arithmetic decides everything into the planes that the film has. `pixels` are
/// places in the image, row by row; returns those of which it does not, which are written too. `plan` is a refinement
/// plan, `scene` and `tile` are its buffers.
class Refinement {
  public:
    Refinement(const Workers& workers, const DeviceMemory& memory, Programs& programs, Pace& pace, const Stop* stop,
               const Plan& plan, const SceneBuffers& scene, const TileBuffers& tile, Film& film);

    std::vector<int> refine(const std::vector<int>& pixels, const std::vector<cl::Event>& after);
    double longest_launch() const { return longest_; }

  private:
    void launch(const Step& step, const BuiltKernel& built, const cl::Kernel& kernel, int items);
    void trace(const cl::Buffer& places, int first, int count);
    template <class real>
    void write(const int* pixels, int count, std::vector<int>& undecided);

    cl::CommandQueue queue_;
    int units_;
    Programs& programs_;
    Pace& pace_;
    const Plan& plan_;
    const SceneBuffers& scene_;
    const TileBuffers& tile_;
    Film& film_;
    const DeviceMemory& memory_;
    cl::Buffer hit_counts_;
    UndecidedRays undecided_;
    Binder binder_;
    std::vector<cl::Event> last_;
    double longest_ = 0;
    Launches launches_;
};

}  // namespace gnomon
