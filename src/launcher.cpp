#include "launcher.h"

#include <utility>

namespace gnomon {

double seconds_of(const cl::Event& event) {
    return 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                      event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

double seconds_since_asked(const cl::Event& event) {
    return 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                      event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>());
}

void Launcher::enqueue(const Variant& variant, const cl::Kernel& kernel, int items, int local) {
    const auto group = static_cast<size_t>(local), groups = (static_cast<size_t>(items) + group - 1) / group;
    cl::Event done;
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, groups * group, group, &last_, &done);
    last_ = {done};
    launched_.push_back({variant, done});
}

void Launcher::fill_with_zeros(const cl::Buffer& buffer) {
    cl::Event done;
    queue_.enqueueFillBuffer(buffer, 0, 0, buffer.getInfo<CL_MEM_SIZE>(), &last_, &done);
    last_ = {done};
}

int Launcher::read_int(const cl::Buffer& buffer) {
    int value = 0;
    const std::vector<cl::Event> all = last();
    queue_.enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof value, &value, &all);
    return value;
}

void Launcher::branch() {
    if (root_)
        ends_.insert(ends_.end(), last_.begin(), last_.end());
    else
        root_ = last_;
    last_ = *root_;
}

std::vector<cl::Event> Launcher::last() const {
    std::vector<cl::Event> all = ends_;
    all.insert(all.end(), last_.begin(), last_.end());
    return all;
}

void Launcher::finish() {
    queue_.finish();
    last_.clear();
    root_.reset();
    ends_.clear();
}

std::vector<Launcher::Launched> Launcher::take_launched() { return std::exchange(launched_, {}); }

}  // namespace gnomon
