#include "statistics.h"

#include <algorithm>
#include <cmath>

namespace gnomon::report {

Summary summarize(const std::vector<double>& errors) {
    Summary s;
    if (errors.empty()) return s;
    s.count = static_cast<int64_t>(errors.size());
    s.worst = static_cast<size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
    s.max = errors[s.worst];
    double squares = 0;
    for (const double error : errors) squares += error * error;
    s.rms = std::sqrt(squares / static_cast<double>(s.count));
    std::vector<double> sorted = errors;
    const int64_t rank = (99 * s.count + 99) / 100 - 1;  // ceil(0.99 n), from 0
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    s.p99 = sorted[static_cast<size_t>(rank)];
    return s;
}

Series series(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front()};
}

double Histogram::edge(size_t bin) { return std::ldexp(0.5, static_cast<int>(bin)); }

void Histogram::add(double error) {
    size_t bin = 0;
    while (bin + 1 < bins && error > edge(bin)) ++bin;
    ++counts[bin];
}

double ulps(float value, double exact) {
    constexpr int digits = 24, lowest = -149;  // IEEE 754 binary32; 2^-149 is its least subnormal
    return std::ldexp(std::fabs(static_cast<double>(value) - exact), -std::max(std::ilogb(exact) - digits + 1, lowest));
}

}  // namespace gnomon::report
