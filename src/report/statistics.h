// Sums over many errors. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gnomon::report {

/// Of a sample of errors >= 0. The maximum of a sample is a lower bound of the true one. All 0 when there are none.
struct Summary {
    int64_t count = 0;
    double max = 0, p99 = 0, rms = 0;  ///< p99: the least value that 99 % of the sample do not exceed
    size_t worst = 0;                  ///< which one is the maximum, the first of equals
};
Summary summarize(const std::vector<double>& errors);

/// The middle of a series, of an even number the upper one; and its least.
struct Series {
    double median = 0, least = 0;
};
Series series(std::vector<double> values);

/// How many errors lie in (edge / 2, edge], for edges 0.5, 1, 2, 4, ... ulp; the first bin starts at 0, and the last
/// has all that are larger.
struct Histogram {
    static constexpr size_t bins = 32;
    std::array<int64_t, bins> counts{};

    static double edge(size_t bin);  ///< the upper one
    void add(double error);
};

/// |value - exact| in units of the last place that a float near `exact` has.
double ulps(float value, double exact);

}  // namespace gnomon::report
