#include "launches.h"

#include <algorithm>

namespace gnomon {

namespace {

// As a share of the bound, the seconds of work that the host is ahead of the device: the more, the later a change of
// pace is noticed. A host that wakes up takes a core from a device that is the CPU.
constexpr double ahead = 0.5;
// Work-groups of which a launch is not cut just to have parts: of blocks of rays, or each a slice of a sort, that take
// 10 us or more, as a launch does. With fewer slices a launch, sorting 10^8 spheres takes longer.
constexpr int64_t few_groups = 4;
// So that memory for events stays bounded.
constexpr size_t most_under_way = 1024;

}  // namespace

int64_t Work::most() const {
    const int64_t few = std::max<int64_t>(items / parts, few_groups * local);
    return parts == 1 ? items : (few + least() - 1) / least() * least();
}

double seconds_of(const cl::Event& event) {
    return 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                      event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

double seconds_since_asked(const cl::Event& event) {
    return 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                      event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>());
}

/// In this launch no work-item has anything to do. It has as many of them as any may have: PoCL keeps a kernel's code
/// with the size of the launch that loaded it, loads it once more for a larger one and, when two launches of the kernel
/// are then under way, gives back one's code for the other's, until "ref_count > 0" fails (3.1,
/// pocl_release_dlhandle_cache).
void Launches::load(const cl::CommandQueue& queue, const Work& work) const {
    if (work.pace->is_loaded()) return;
    queue.finish();  // what is under way would wait for the compiler, and be measured with that
    cl::Kernel kernel = work.kernel;
    kernel.setArg(kernel.getInfo<CL_KERNEL_NUM_ARGS>() - 1, static_cast<cl_int>(work.items));
    const int64_t most = pace_.is_bounded() ? pace_.most() / work.local : 1;
    const auto local = static_cast<size_t>(work.local);
    cl::Event done;
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, static_cast<size_t>(most) * local, local, nullptr, &done);
    done.wait();
    work.pace->set_loaded();
}

void Launches::launch(const cl::CommandQueue& queue, const Work& work, std::vector<cl::Event>& busy) {
    load(queue, work);
    for (int64_t first = 0; first < work.items;) {
        if (stop_ && stop_->is_asked()) await_all();
        check(stop_);
        const int64_t items = part_in_time(queue, work, work.items - first);
        enqueue(queue, work, first, items, busy);
        first += items;
    }
}

int64_t Launches::launch_part(const cl::CommandQueue& queue, const Work& work, int64_t first,
                              std::vector<cl::Event>& busy) {
    check(stop_);
    const int64_t items = part(work, work.items - first);
    enqueue(queue, work, first, items, busy);
    return items;
}

int64_t Launches::part(const Work& work, int64_t left) const {
    const int64_t most = std::max(pace_.most() / work.least(), int64_t{1}) * work.least();
    return work.pace->part(std::min({left, most, work.most()}), work.least(), pace_.bound());
}

int64_t Launches::part_in_time(const cl::CommandQueue& queue, const Work& work, int64_t left) {
    for (;;) {
        const int64_t items = part(work, left);
        if (!must_wait(work, std::min({left, pace_.most(), work.most()}), items)) return items;
        queue.flush();
        await_oldest();
    }
}

bool Launches::must_wait(const Work& work, int64_t left, int64_t part) const {
    const auto same = [&](const Launch& launch) { return launch.pace == work.pace; };
    if (part < left && work.pace->is_growing(left) && std::any_of(under_way_.begin(), under_way_.end(), same))
        return true;
    const bool enough = expected_ + work.pace->expected(part) > ahead * pace_.bound();
    return under_way_.size() >= most_under_way || (enough && under_way_.size() >= 2);
}

void Launches::enqueue(const cl::CommandQueue& queue, const Work& work, int64_t first, int64_t items,
                       std::vector<cl::Event>& busy) {
    const auto local = static_cast<size_t>(work.local), groups = (static_cast<size_t>(items) + local - 1) / local;
    // Not as the launch's offset: PoCL compiles a kernel anew for any that is not 0.
    cl::Kernel kernel = work.kernel;
    kernel.setArg(kernel.getInfo<CL_KERNEL_NUM_ARGS>() - 1, static_cast<cl_int>(first));
    cl::Event done;
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, groups * local, local, &busy, &done);
    busy = {done};
    const double expected = work.pace->expected(items);
    under_way_.push_back({work.pace, work.tag, done, items, expected});
    expected_ += expected;
}

void Launches::await_oldest() {
    under_way_.front().event.wait();
    measure_oldest();
}

void Launches::await_all() {
    while (!empty()) await_oldest();
}

void Launches::measure_all() {
    while (!empty()) measure_oldest();
}

void Launches::measure_oldest() {
    const Launch launch = under_way_.front();
    under_way_.pop_front();
    expected_ = empty() ? 0 : expected_ - launch.expected;  // 0 rounds nothing off
    const double seconds = seconds_of(launch.event);
    launch.pace->measured(launch.items, seconds);
    ended_(launch.tag, launch.items, seconds);
}

}  // namespace gnomon
