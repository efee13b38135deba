#include "pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gnomon::report {

/// In the order of time, the quicker first, a way is on the front if it is more exact than all that are quicker; of
/// those that are equally quick only the most exact can be.
std::vector<bool> pareto_front(const std::vector<Cost>& costs) {
    std::vector<size_t> order(costs.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return costs[a].time != costs[b].time ? costs[a].time < costs[b].time : costs[a].error < costs[b].error;
    });
    std::vector<bool> front(costs.size());
    double quicker = std::numeric_limits<double>::infinity();  // the least error of all that are quicker
    for (size_t i = 0; i < order.size();) {
        const double time = costs[order[i]].time, least = costs[order[i]].error;
        for (; i < order.size() && costs[order[i]].time == time; ++i)
            front[order[i]] = costs[order[i]].error == least && least < quicker;
        quicker = std::min(quicker, least);
    }
    return front;
}

}  // namespace gnomon::report
