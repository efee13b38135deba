#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plot_style.h"
#include "plots.h"

namespace gnomon::report {

namespace {

constexpr double least_share = 1e-4;  // per cent: the axis's lower end

/// Edge against share of the rays, in per cent; where a bin is empty the line is broken.
std::string data(const RootRow& row) {
    std::string text;
    const auto all = static_cast<double>(std::max<int64_t>(1, row.error.t.count));
    for (size_t bin = 0; bin < Histogram::bins; ++bin) {
        const auto count = static_cast<double>(row.error.ulps.counts[bin]);
        text += count > 0 ? fmt::format("{} {}\n", Histogram::edge(bin), 100 * count / all) : "\n";
    }
    return text;
}

/// The last edge that anything lies below.
double last_edge(const DeviceReport& device) {
    size_t last = 0;
    for (const RootTable& table : device.roots)
        for (const RootRow& row : table.rows)
            for (size_t bin = last; bin < Histogram::bins; ++bin)
                if (row.error.ulps.counts[bin] > 0) last = bin;
    return Histogram::edge(last);
}

std::string draw_panel(const RootTable& table) {
    std::string blocks, plots;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const Mark mark = mark_of(table.rows[i].formula.name);
        blocks += fmt::format("$rows{} << EOD\n{}EOD\n", i, data(table.rows[i]));
        plots += fmt::format("{}$rows{} using 1:2 with linespoints lc rgb '{}' lw 1.4 pt {} ps 0.45",
                             i == 0 ? "plot " : ", ", i, mark.color, mark.shape);
    }
    return blocks + plots + "\nunset label\n";
}

}  // namespace

std::string histograms(const DeviceReport& device) {
    const Layout layout = layout_for(device.roots.size());
    std::vector<std::string> names;
    for (const RootRow& row : device.roots.front().rows) names.push_back(row.formula.name);
    std::string script = head(layout) + key(layout, names) +
                         fmt::format("set logscale x 2\nset logscale y\nset xrange [0.35:{}]\nset yrange [{}:200]\n",
                                     last_edge(device) * 1.6, least_share) +
                         "set format x '2^{%L}'\nset xtics 16\nset format y '10^{%T}'\n";
    for (size_t i = 0; i < device.roots.size(); ++i)
        script += begin_panel(layout, i, device.roots[i].name, "error of t up to, ulp", "share of rays, %") +
                  draw_panel(device.roots[i]);
    return script + "unset multiplot\n";
}

}  // namespace gnomon::report
