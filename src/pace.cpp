#include "pace.h"

#include <algorithm>

namespace gnomon {

namespace {

// What is aimed at, as a share of the bound: the next part of a picture may take so many times as long as the last.
// One pass of the sort of 10^7 spheres takes four times as long as another, and a launch that is the first to touch
// memory up to eight times as long as the next.
constexpr double aim = 0.1;
// How much of the slowest pace is still heeded a launch later: some launches after what is hard a kernel is launched
// whole again.
constexpr double memory = 0.7;
// Seconds within which what it costs to launch at all may be most of it: then few work-items tell little about many.
constexpr double short_launch = 1e-3;

}  // namespace

void KernelPace::measured(int64_t items, double seconds) {
    if (seconds < short_launch && growth * items < most_) return;
    slow_ = std::max(seconds / static_cast<double>(items), memory * slow_);
    most_ = std::max(most_, items);
}

int64_t KernelPace::part(int64_t left, int64_t least, double bound) const {
    if (left <= least) return left;
    if (most_ == 0) return least;
    const int64_t grown = std::min(left, std::max(growth * most_, least));
    const double in_time = slow_ > 0 ? aim * bound / slow_ : static_cast<double>(grown);
    const auto items = static_cast<int64_t>(std::min(in_time, static_cast<double>(grown)));
    return items >= left ? left : std::max(items / least, int64_t{1}) * least;
}

void Pace::expect(double bound, int64_t spheres) {
    bound_ = bound;
    if (spheres > spheres_)
        for (auto& [name, kernel] : kernels_) kernel.forget();
    spheres_ = spheres;
}

}  // namespace gnomon
