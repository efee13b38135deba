// Which of several ways are worth their time. Pure.
#pragma once

#include <vector>

namespace gnomon::report {

/// What a way costs and how wrong it is: the less the better, both.
struct Cost {
    double time, error;
};

/// For each whether it is on the Pareto front: no other is at most as slow and at most as wrong, and better in one of
/// the two. Whatever is infinitely wrong is not.
std::vector<bool> pareto_front(const std::vector<Cost>& costs);

}  // namespace gnomon::report
