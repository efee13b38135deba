#include "launcher.h"

#include <algorithm>
#include <utility>

namespace gnomon {

Launcher::Launcher(const cl::CommandQueue& queue, Programs& programs, Pace& pace, int units, const Stop* stop,
                   int parts)
    : queue_(queue),
      programs_(programs),
      pace_(pace),
      units_(units),
      parts_(parts),
      launches_(pace, stop, [this](int tag, int64_t, double seconds) {
          Cost& cost = costs_[static_cast<size_t>(tag)];
          cost.launches += 1;
          cost.seconds += seconds;
          cost.longest = std::max(cost.longest, seconds);
      }) {}

Launcher::~Launcher() { clFinish(queue_()); }

void Launcher::launch(const Variant& variant, const cl::Kernel& kernel, int items, int local) {
    const auto known =
        std::find_if(costs_.begin(), costs_.end(), [&](const Cost& cost) { return cost.variant == variant; });
    const auto tag = static_cast<int>(known - costs_.begin());
    if (known == costs_.end()) costs_.push_back({variant});
    launches_.launch(queue_, {kernel, &pace_.of(variant.name()), tag, items, local, units_, parts_}, last_);
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
    launches_.await_all();
    last_.clear();
    root_.reset();
    ends_.clear();
}

std::vector<Launcher::Cost> Launcher::take_costs() {
    launches_.await_all();
    return std::exchange(costs_, {});
}

}  // namespace gnomon
