#include "report_json.h"

#include <fmt/core.h>

#include "stats_json.h"

namespace gnomon::report {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Series& s) { return {{"median", s.median}, {"least", s.least}}; }

Json to_json(const Summary& s) {
    return {{"max_lower_bound", s.max}, {"p99", s.p99}, {"rms", s.rms}, {"rays", s.count}};
}

Json to_json(const Decisions& d) {
    const std::optional<double> rate = d.per_million();
    return {{"wrong", d.wrong}, {"of", d.of}, {"per_million", rate ? Json(*rate) : Json()}};
}

Json to_json(const Histogram& h) {
    Json edges = Json::array();
    for (size_t bin = 0; bin < Histogram::bins; ++bin) edges.push_back(Histogram::edge(bin));
    return {{"upper_edges", edges}, {"counts", h.counts}};
}

std::string bits(double value) { return fmt::format("{:a}", value); }
Json bits(const Float3& v) {
    return Json::array(
        {bits(static_cast<double>(v.x)), bits(static_cast<double>(v.y)), bits(static_cast<double>(v.z))});
}

Json to_json(const WorstRay& w) {
    return {{"center", bits(w.sphere.center)},
            {"radius", bits(static_cast<double>(w.sphere.radius))},
            {"power", bits(static_cast<double>(w.sphere.power))},
            {"dir", bits(w.dir)},
            {"t", bits(static_cast<double>(w.t))},
            {"exact_t", bits(w.exact)}};
}

Json to_json(const RootError& e) {
    return {{"t_ulp", to_json(e.t)},
            {"normal_radians", to_json(e.normal)},
            {"missed", to_json(e.missed)},
            {"false_hits", to_json(e.false_hits)},
            {"ulp_histogram", to_json(e.ulps)},
            {"worst", e.worst ? to_json(*e.worst) : Json()}};
}

Json to_json(const RootRow& row) {
    return {{"formula", row.formula.name},
            {"about", row.formula.about},
            {"default", row.formula.is_default},
            {"ns_per_ray", to_json(row.ns_per_ray)},
            {"mrays_per_second", mrays_per_second(row)},
            {"on_pareto_front", row.on_front},
            {"error", to_json(row.error)}};
}

Json to_json(const PictureError& e) {
    return {{"pixels", e.check.pixels},
            {"max_radiance_lower_bound", e.check.max_radiance},
            {"rms_radiance", e.check.rms_radiance},
            {"wrong_ids", e.check.wrong_ids},
            {"wrong_pixels", e.check.wrong_pixels},
            {"wrong_shadow_bits", to_json(e.shadow_bits)}};
}

Json to_json(const PictureRow& row) {
    const Picture& p = row.picture;
    const Json error = to_json(p.error);
    Json kernels = Json::array();
    for (const KernelTime& k : p.kernels)
        kernels.push_back({{"kernel", k.kernel},
                           {"options", k.options},
                           {"rays", k.rays},
                           {"ns_per_ray", to_json(k.ns_per_ray)},
                           {"error", error}});
    return {{"accuracy", to_string(p.accuracy)},
            {"default", is_default(row)},
            {"seconds", to_json(p.seconds)},
            {"rays", p.rays},
            {"mrays_per_second", mrays_per_second(p)},
            {"on_pareto_front", row.on_front},
            {"error", error},
            {"kernels", kernels}};
}

template <class Table>
Json rows_of(const Table& table) {
    Json rows = Json::array();
    for (const auto& row : table.rows) rows.push_back(to_json(row));
    return rows;
}

Json to_json(const RootTable& table) {
    return {{"case", table.name},
            {"about", table.about},
            {"rays", table.rays},
            {"default_on_pareto_front", default_on_front(table)},
            {"formulas", rows_of(table)}};
}

Json to_json(const PictureTable& table) {
    return {{"scene", table.scene},
            {"image", {{"width", table.image.width}, {"height", table.image.height}}},
            {"spheres", table.spheres},
            {"lights", table.lights},
            {"default_on_pareto_front", default_on_front(table)},
            {"accuracies", rows_of(table)}};
}

Json grid_json(const DeviceReport& device) {
    Json maps = Json::array();
    for (const GridMap& map : device.maps) {
        Json ulps = Json::array(), wrong = Json::array();
        for (const Cell& cell : map.cells) {
            ulps.push_back(cell.max_ulps ? Json(*cell.max_ulps) : Json());
            wrong.push_back(cell.wrong.wrong);
        }
        maps.push_back({{"formula", map.formula.name}, {"max_t_ulp_lower_bound", ulps}, {"wrong_decisions", wrong}});
    }
    const Grid& g = device.grid;
    return {
        {"about", "cells row by row: columns over log10(distance / radius) from 0, rows over impact / radius from 0"},
        {"columns", g.columns},
        {"rows", g.rows},
        {"decades", g.decades},
        {"impacts", g.impacts},
        {"rays_per_cell", g.blocks * BLOCK_RAYS},
        {"formulas", maps}};
}

Json to_json(const DeviceReport& d) {
    Json json = {{"device", gnomon::to_json(d.device)},
                 {"notes", d.notes},
                 {"cases", Json::array()},
                 {"grid", grid_json(d)},
                 {"pictures", Json::array()}};
    for (const RootTable& table : d.roots) json["cases"].push_back(to_json(table));
    for (const PictureTable& table : d.pictures) json["pictures"].push_back(to_json(table));
    return json;
}

}  // namespace

Json to_json(const Report& report) {
    Json json = {{"program", "gnomon " GNOMON_VERSION},
                 {"date", report.date},
                 {"quick", report.quick},
                 {"reference",
                  "rays: the kernel's floats taken exactly, the quadratic to 60 digits; pictures: double "
                  "precision, every sphere against every ray, on sampled pixels"},
                 {"plots", report.plots.empty() ? "in report.html" : report.plots},
                 {"devices", Json::array()}};
    for (const DeviceReport& device : report.devices) json["devices"].push_back(to_json(device));
    return json;
}

}  // namespace gnomon::report
