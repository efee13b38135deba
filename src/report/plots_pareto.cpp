#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "label_places.h"
#include "plot_style.h"
#include "plots.h"

namespace gnomon::report {

namespace {

/// A way of doing it: what it costs, and how wrong it is.
struct Way {
    std::string name;
    double time, error;
    bool on_front, is_default;
};
struct ParetoPanel {
    std::string title;
    std::vector<Way> ways;
};

/// Logarithmic, with room around what it shows.
struct Axis {
    double low, high;  // decimal logarithms

    Axis(const std::vector<ParetoPanel>& panels, double Way::*value, double below, double above) {
        double least = INFINITY, most = 0;
        for (const ParetoPanel& panel : panels)
            for (const Way& way : panel.ways) {
                if (way.*value > 0) least = std::min(least, way.*value);
                if (std::isfinite(way.*value)) most = std::max(most, way.*value);
            }
        low = std::log10(least) - below;
        high = std::log10(std::max(most, least)) + above;
    }
    /// 0 to 1; what cannot be shown lies on the edge.
    double place(double value) const { return std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0); }
    /// 1, 2, 5, 10, ... as far as the axis goes; on a long one powers of ten alone.
    std::string ticks() const {
        std::string text;
        for (double power = std::floor(low); power <= high; ++power)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double tick = digit * std::pow(10, power);
                const bool shown =
                    std::log10(tick) >= low && std::log10(tick) <= high && (high - low < 3 || digit == 1);
                if (shown) text += fmt::format("{}{:.6g}", text.empty() ? "" : ",", tick);
            }
        return "(" + text + ")";
    }
    std::string range() const { return fmt::format("[{}:{}]", std::pow(10, low), std::pow(10, high)); }
};

/// What is on the front, from the quickest to the most exact.
std::vector<Way> front_of(const ParetoPanel& panel) {
    std::vector<Way> front;
    std::copy_if(panel.ways.begin(), panel.ways.end(), std::back_inserter(front),
                 [](const Way& w) { return w.on_front; });
    std::sort(front.begin(), front.end(), [](const Way& a, const Way& b) { return a.time < b.time; });
    return front;
}

/// Names beside their points, clear of the steps along the front: down first, then to the right.
std::vector<LabelPlace> places(const Layout& l, const ParetoPanel& panel, const Axis& x, const Axis& y) {
    constexpr double thick = 2;  // pixels to each side
    const auto at = [&](const Way& way) {
        return Point{x.place(way.time) * l.width, y.place(way.error) * l.height, way.name};
    };
    std::vector<Point> points;
    for (const Way& way : panel.ways) points.push_back(at(way));
    std::vector<Box> steps;
    const std::vector<Way> front = front_of(panel);
    for (size_t i = 1; i < front.size(); ++i) {
        const Point a = at(front[i - 1]), b = at(front[i]);
        steps.push_back({a.x - thick, a.x + thick, b.y, a.y});
        steps.push_back({a.x, b.x, b.y - thick, b.y + thick});
    }
    return label_places({l.width, l.height}, points, steps);
}

std::string front_line(const ParetoPanel& panel) {
    std::string text;
    for (const Way& way : front_of(panel)) text += fmt::format("{} {}\n", way.time, way.error);
    return text;
}

std::string point(const Axis& x, const Axis& y, const Way& way, int shape, double size, const std::string& color) {
    return fmt::format("set label '' at graph {},{} point pt {} ps {} lc rgb '{}' lw 1.6 front\n", x.place(way.time),
                       y.place(way.error), shape, size, color);
}

std::string draw_panel(const Layout& l, const ParetoPanel& panel, const Axis& x, const Axis& y) {
    std::string text = "unset label\n";
    const std::vector<LabelPlace> names = places(l, panel, x, y);
    for (size_t i = 0; i < panel.ways.size(); ++i) {
        const Way& way = panel.ways[i];
        const Mark mark = mark_of(way.name);
        if (way.is_default) text += point(x, y, way, 6, 1.5, "#000000");
        // gnuplot's open shape is the one before the filled.
        text += point(x, y, way, way.on_front ? mark.shape : mark.shape - 1, 0.8, mark.color);
        text += fmt::format("set label {} at graph {},{} left front noenhanced textcolor rgb '{}'\n", quoted(way.name),
                            names[i].x / l.width, names[i].y / l.height, mark.color);
    }
    return text + "$front << EOD\n" + front_line(panel) +
           "EOD\nplot $front using 1:2 with fsteps lc rgb '#777777' lw 1.2 dt 2\n";
}

std::string pareto(const std::vector<ParetoPanel>& panels, const std::string& x_title, const std::string& y_title) {
    Layout layout = layout_for(panels.size());
    layout.above = 6;
    const Axis x(panels, &Way::time, 0.4, 0.6), y(panels, &Way::error, 0.7, 0.7);
    std::string script = head(layout) + "set logscale xy\nset xrange " + x.range() + "\nset yrange " + y.range() +
                         "\nset format y '10^{%T}'\nset format x '%g'\nset xtics " + x.ticks() + "\n";
    for (size_t i = 0; i < panels.size(); ++i)
        script += begin_panel(layout, i, panels[i].title, x_title, y_title) + draw_panel(layout, panels[i], x, y);
    return script + "unset multiplot\n";
}

}  // namespace

std::string pareto_of_roots(const DeviceReport& device) {
    std::vector<ParetoPanel> panels;
    for (const RootTable& table : device.roots) {
        panels.push_back({table.name, {}});
        for (const RootRow& row : table.rows)
            panels.back().ways.push_back(
                {row.formula.name, row.ns_per_ray.median, row.error.t.max, row.on_front, is_default(row)});
    }
    return pareto(panels, "time, ns a ray", "largest error of t, ulp");
}

std::string pareto_of_pictures(const DeviceReport& device) {
    std::vector<ParetoPanel> panels;
    for (const PictureTable& table : device.pictures) {
        panels.push_back({table.scene, {}});
        for (const PictureRow& row : table.rows)
            panels.back().ways.push_back({to_string(row.picture.accuracy), 1e3 * row.picture.seconds.median,
                                          row.picture.error.check.max_radiance, row.on_front, is_default(row)});
    }
    return pareto(panels, "time, ms a picture", "largest error of radiance / brightest");
}

}  // namespace gnomon::report
