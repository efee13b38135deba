#include "tables.h"

#include <fmt/core.h>

#include <algorithm>

namespace gnomon::report {

namespace {

std::string rate(const Decisions& d) {
    const std::optional<double> per_million = d.per_million();
    return per_million ? fmt::format("{:.0f} (n {})", *per_million, d.of) : "- (n 0)";
}

std::string name_of(const RootRow& row) { return row.formula.name; }
std::string name_of(const PictureRow& row) { return to_string(row.picture.accuracy); }

int64_t wrong_decisions(const RootRow& row) { return row.error.missed.wrong + row.error.false_hits.wrong; }
int64_t wrong_decisions(const PictureRow& row) { return row.picture.error.check.wrong_pixels; }

std::string front(bool on) { return on ? "yes" : ""; }

template <class Of>
std::string verdict(const Of& table) {
    std::string names, which;
    for (const auto& row : table.rows) {
        if (row.on_front) names += (names.empty() ? "" : ", ") + name_of(row);
        if (row.on_front && wrong_decisions(row) > 0)
            names += fmt::format(" ({} decided wrongly)", wrong_decisions(row));
        if (is_default(row)) which = name_of(row);
    }
    return fmt::format("Pareto front: {}; the default, {}, is {}on it.", names, which,
                       default_on_front(table) ? "" : "not ");
}

std::string exactly(const Float3& v) { return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z); }

std::vector<std::string> errors(const PictureError& e) {
    return {fmt::format("{:.1e}", e.check.max_radiance), fmt::format("{:.1e}", e.check.rms_radiance),
            fmt::format("{}", e.check.wrong_ids),        fmt::format("{}", e.check.wrong_pixels),
            fmt::format("{}", e.check.pixels),           rate(e.shadow_bits)};
}

/// A line of the pictures' table: what took how long, and the error of the picture.
std::vector<std::string> picture_line(std::vector<std::string> cells, const PictureError& error,
                                      const std::string& last) {
    for (const std::string& cell : errors(error)) cells.push_back(cell);
    cells.push_back(last);
    return cells;
}

}  // namespace

const char* const legend =
    "Times are medians [least]. The error of t is in units of the last place that a float has at the exact value, that "
    "of the normal is an angle in radians; both are of rays that hit and were found to. Errors are of samples: a "
    "maximum is a lower bound of the true one (>=). Missed: of a million rays that hit; false hits: of a million that "
    "do not; n is the size of the sample. Pictures: the radiance's error is relative to the brightest sampled "
    "pixel, wrong pixels left out, which have another hit or other lights; shadow bits say whether a light reaches a "
    "hit. A row is on the Pareto front if no other is as quick and as exact (largest error), and better in one of the "
    "two.";

Table table_of(const RootTable& of) {
    Table table{of.name,
                fmt::format("{}; {} rays", of.about, of.rays),
                {"formula", "ns a ray", "Mrays/s", "t max >= ulp", "t p99", "t RMS", "normal max >= rad", "p99", "RMS",
                 "missed per 10^6", "false hits per 10^6", "front"},
                {},
                verdict(of)};
    for (const RootRow& row : of.rows) {
        const RootError& e = row.error;
        table.rows.push_back(
            {row.formula.name, fmt::format("{:.2f} [{:.2f}]", row.ns_per_ray.median, row.ns_per_ray.least),
             fmt::format("{:.0f}", mrays_per_second(row)), fmt::format("{:.3g}", e.t.max),
             fmt::format("{:.3g}", e.t.p99), fmt::format("{:.3g}", e.t.rms), fmt::format("{:.1e}", e.normal.max),
             fmt::format("{:.1e}", e.normal.p99), fmt::format("{:.1e}", e.normal.rms), rate(e.missed),
             rate(e.false_hits), front(row.on_front)});
    }
    return table;
}

Table table_of(const PictureTable& of) {
    Table table{of.scene,
                fmt::format("{}x{}, {} spheres, {} lights", of.image.width, of.image.height, of.spheres, of.lights),
                {"accuracy, kernel", "ms a picture", "ns a ray", "Mrays/s", "radiance max >=", "RMS", "wrong ids",
                 "wrong pixels", "of pixels", "wrong shadow bits per 10^6", "front"},
                {},
                verdict(of)};
    for (const PictureRow& row : of.rows) {
        const Picture& p = row.picture;
        const double ns = 1e3 / mrays_per_second(p);
        table.rows.push_back(picture_line(
            {to_string(p.accuracy), fmt::format("{:.2f} [{:.2f}]", 1e3 * p.seconds.median, 1e3 * p.seconds.least),
             fmt::format("{:.2f}", ns), fmt::format("{:.0f}", mrays_per_second(p))},
            p.error, front(row.on_front)));
        for (const KernelTime& k : p.kernels)
            table.rows.push_back(picture_line(
                {"  " + k.kernel, "", fmt::format("{:.2f} [{:.2f}]", k.ns_per_ray.median, k.ns_per_ray.least),
                 fmt::format("{:.0f}", 1e3 / k.ns_per_ray.median)},
                p.error, ""));
    }
    return table;
}

Table worst_rays(const DeviceReport& device) {
    Table table{"Worst rays",
                "where each formula's t is farthest off in all cases, to all bits",
                {"formula", "case", "t off by ulp", "center", "radius", "power", "dir", "t", "exact t"},
                {},
                ""};
    for (const Formula& formula : formulas()) {
        const RootTable* at = nullptr;
        const RootRow* worst = nullptr;
        for (const RootTable& of : device.roots)
            for (const RootRow& row : of.rows)
                if (row.formula.name == formula.name && row.error.worst &&
                    (!worst || row.error.t.max > worst->error.t.max))
                    at = &of, worst = &row;
        if (!worst) continue;
        const WorstRay& w = *worst->error.worst;
        table.rows.push_back({formula.name, at->name, fmt::format("{:.3g}", worst->error.t.max),
                              exactly(w.sphere.center), fmt::format("{:.9g}", w.sphere.radius),
                              fmt::format("{:.9g}", w.sphere.power), exactly(w.dir), fmt::format("{:.9g}", w.t),
                              fmt::format("{:.17g}", w.exact)});
    }
    return table;
}

std::string to_text(const Table& table) {
    std::vector<size_t> widths;
    for (size_t c = 0; c < table.columns.size(); ++c) {
        widths.push_back(table.columns[c].size());
        for (const auto& row : table.rows) widths[c] = std::max(widths[c], row[c].size());
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text = fmt::format("  {:<{}}", cells[0], widths[0]);
        for (size_t c = 1; c < cells.size(); ++c) text += fmt::format("  {:>{}}", cells[c], widths[c]);
        return text + "\n";
    };
    std::string text = table.title + ": " + table.about + "\n" + line(table.columns);
    for (const auto& row : table.rows) text += line(row);
    return text + (table.verdict.empty() ? "" : "  " + table.verdict + "\n") + "\n";
}

std::string to_text(const Report& report) {
    std::string text = std::string(legend) + "\n\n";
    for (const DeviceReport& device : report.devices) {
        text += fmt::format("device {}: {} ({}), driver {}\n", device.device.number(), device.device.name,
                            device.device.platform_name, device.device.driver);
        for (const std::string& note : device.notes) text += "  " + note + "\n";
        text += "\n";
        for (const RootTable& table : device.roots) text += to_text(table_of(table));
        text += to_text(worst_rays(device));
        for (const PictureTable& table : device.pictures) text += to_text(table_of(table));
    }
    return text;
}

}  // namespace gnomon::report
