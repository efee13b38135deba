#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plot_style.h"
#include "plots.h"

namespace gnomon::report {

namespace {

/// What a heat map shows of a cell; nothing where there is nothing to show.
struct Heat {
    std::string title, range, ticks, palette;
    std::optional<double> (*value)(const Cell&);
};

// Viridis at ninths: lightness rises evenly, to the colour-blind as well, and in print (Smith and van der Walt, 2015).
const char* const viridis =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', "
    "7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";
const char* const white_to_red =
    "set palette defined (0 '#ffffff', 0.001 '#fee5d9', 0.25 '#fcae91', 0.5 '#fb6a4a', 0.75 '#de2d26', 1 '#7f0010')\n";

/// x, y and value, row by row.
std::string data(const Grid& grid, const GridMap& map, const Heat& heat) {
    std::string text;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const auto value = heat.value(map.cells[static_cast<size_t>(row * grid.columns + column)]);
            text += fmt::format("{:.4g} {:.4g} {}\n", (column + 0.5) * grid.decades / grid.columns,
                                (row + 0.5) * grid.impacts / grid.rows, value ? fmt::format("{:.3g}", *value) : "NaN");
        }
        text += "\n";
    }
    return text;
}

std::string heat_maps(const DeviceReport& device, const Heat& heat) {
    const Grid& grid = device.grid;
    Layout layout = layout_for(device.maps.size());
    layout.above = 6;
    layout.beside = 84;  // the scale
    std::string script = head(layout) + heat.palette +
                         fmt::format("set xrange [0:{}]\nset yrange [0:{}]\nset cbrange {}\nset cbtics {}\n",
                                     grid.decades, grid.impacts, heat.range, heat.ticks) +
                         "set xtics 1 format '10^{%.0f}'\nset ytics 0.25\nunset grid\nset border 15\nset cblabel " +
                         quoted(heat.title) + " noenhanced offset 0.5,0\n";
    const double scale_left = (layout.whole_width() - layout.beside + 4) / layout.whole_width();
    for (size_t i = 0; i < device.maps.size(); ++i) {
        script += i == 0 ? fmt::format("set colorbox user origin {},0.25 size {},0.5\n", scale_left,
                                       14 / layout.whole_width())
                         : "unset colorbox\n";
        script += begin_panel(layout, i, device.maps[i].formula.name, "distance / radius", "impact / radius") +
                  "$cells << EOD\n" + data(grid, device.maps[i], heat) +
                  "EOD\nplot $cells using 1:2:3 with image pixels\n";
    }
    return script + "unset multiplot\n";
}

}  // namespace

std::string heat_of_t(const DeviceReport& device) {
    double most = 1;
    for (const GridMap& map : device.maps)
        for (const Cell& cell : map.cells) most = std::max(most, cell.max_ulps.value_or(0));
    return heat_maps(device, {"largest error of t, ulp", fmt::format("[-1:{}]", std::ceil(std::log10(most))),
                              "1 format '10^{%.0f}'", viridis, [](const Cell& cell) -> std::optional<double> {
                                  if (!cell.max_ulps) return {};
                                  return std::log10(std::max(*cell.max_ulps, 0.1));
                              }});
}

std::string heat_of_decisions(const DeviceReport& device) {
    return heat_maps(device, {"wrong decisions, %", "[0:50]", "10 format '%.0f'", white_to_red,
                              [](const Cell& cell) -> std::optional<double> {
                                  if (cell.wrong.wrong == 0) return {};  // white, like the ground
                                  return 1e-4 * *cell.wrong.per_million();
                              }});
}

}  // namespace gnomon::report
