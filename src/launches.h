// Launches under way on one device: cut so that none takes too long, and measured when they have ended.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "opencl.h"
#include "pace.h"
#include "stop.h"

namespace gnomon {

/// The device's own time of a command that has ended.
double seconds_of(const cl::Event& event);
/// From when the host asked for it to its end.
double seconds_since_asked(const cl::Event& event);

/// A kernel with its arguments but the last, which is the first work-item of a launch; over so many work-items: a
/// multiple of `local` of them is launched.
struct Work {
    cl::Kernel kernel;
    KernelPace* pace = nullptr;
    int tag = 0;  ///< for whoever is told of its end
    int64_t items = 0;
    int local = 1;
    int units = 1;  ///< compute units of the queue's device: fewer groups in a launch would leave some idle
    /// At least so many launches, where work-groups are not few: for those of which some take many times as long as
    /// others.
    int parts = 1;

    int64_t least() const { return int64_t{local} * units; }
    int64_t most() const;  ///< work-items that one launch may have
};

class Launches {
  public:
    using Ended = std::function<void(int tag, int64_t items, double seconds)>;

    /// `ended` is told of each launch, once it has been measured. Nothing is launched when a `stop` is asked for.
    Launches(const Pace& pace, const Stop* stop, Ended ended) : pace_(pace), stop_(stop), ended_(std::move(ended)) {}

    /// Has the driver compile and load the kernel, unless that has been done; waits for it. Not to be called by whom
    /// the driver calls back.
    void load(const cl::CommandQueue& queue, const Work& work) const;
    /// All of it, in as many parts as its pace demands, one after the other and after `busy`, which then holds the end
    /// of the last. Waits for launches that must be measured first, for the oldest when too much is under way, and for
    /// all before it throws Stopped.
    void launch(const cl::CommandQueue& queue, const Work& work, std::vector<cl::Event>& busy);
    /// The part from work-item `first` on of what is loaded, without waiting for anything, even when it throws; returns
    /// how many work-items it has.
    int64_t launch_part(const cl::CommandQueue& queue, const Work& work, int64_t first, std::vector<cl::Event>& busy);

    bool empty() const { return under_way_.empty(); }
    /// Seconds that those under way should take.
    double expected() const { return expected_; }
    /// Waits for the oldest one, and measures it.
    void await_oldest();
    void await_all();
    /// Measures all, which must have ended.
    void measure_all();

  private:
    struct Launch {
        KernelPace* pace;
        int tag;
        cl::Event event;
        int64_t items;
        double expected;  // seconds
    };

    int64_t part(const Work& work, int64_t left) const;
    int64_t part_in_time(const cl::CommandQueue& queue, const Work& work, int64_t left);
    bool must_wait(const Work& work, int64_t left, int64_t part) const;
    void enqueue(const cl::CommandQueue& queue, const Work& work, int64_t first, int64_t items,
                 std::vector<cl::Event>& busy);
    void measure_oldest();

    const Pace& pace_;
    const Stop* stop_;
    Ended ended_;
    std::deque<Launch> under_way_;
    double expected_ = 0;  // of all under way
};

}  // namespace gnomon
