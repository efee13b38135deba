// Launches kernels one after the other, each when the one before has ended, in branches that do not wait for each
// other.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "arguments.h"
#include "launches.h"
#include "opencl.h"
#include "program.h"

namespace gnomon {

class Launcher {
  public:
    /// What the launches of one variant took that have ended.
    struct Cost {
        Variant variant;
        int launches = 0;
        double seconds = 0, longest = 0;
    };

    /// `pace` is that of the queue's device, which has so many compute `units`. What is launched is cut into so many
    /// `parts` at least.
    Launcher(const cl::CommandQueue& queue, Programs& programs, Pace& pace, int units, const Stop* stop = nullptr,
             int parts = 1);
    /// Waits for all: what the launches read may not outlive this.
    ~Launcher();
    Launcher(const Launcher&) = delete;
    Launcher& operator=(const Launcher&) = delete;

    /// One launch, or more if that would take too long, over at least `items` work-items in groups of `local`, or of
    /// fewer if the kernel allows no more.
    template <class... Values>
    void launch(const Variant& variant, int items, int local, const Values&... values) {
        const BuiltKernel& built = programs_.get(variant);
        cl::Kernel kernel = built.kernel;
        Arguments(kernel).add(values...);
        launch(variant, kernel, items, std::min(local, built.group_limit));
    }
    /// What follows, up to the next branch, waits only for what was launched before the first one.
    void branch();
    void fill_with_zeros(const cl::Buffer& buffer);
    /// Waits for all of it, and reads one value.
    int read_int(const cl::Buffer& buffer);
    void finish();
    /// What must have ended before anything else may read what the launches write; empty after finish().
    std::vector<cl::Event> last() const;

    /// What was launched since the last time this was asked. Waits for all of it.
    std::vector<Cost> take_costs();

  private:
    void launch(const Variant& variant, const cl::Kernel& kernel, int items, int local);

    cl::CommandQueue queue_;
    Programs& programs_;
    Pace& pace_;
    int units_, parts_;
    Launches launches_;
    std::vector<cl::Event> last_;                 // of the branch that is being launched
    std::optional<std::vector<cl::Event>> root_;  // where branches start, if there are any
    std::vector<cl::Event> ends_;                 // of the other branches
    std::vector<Cost> costs_;                     // a launch's tag is its place here
};

}  // namespace gnomon
