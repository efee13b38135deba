#include "tables.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>

#include "report/tables.h"
#include "stats_json.h"

namespace gnomon::verify {

namespace {

using Json = nlohmann::ordered_json;

std::string word(const Verdict& v) {
    if (!v.error.empty()) return "failed";
    return v.same() ? "same" : "different";
}

std::vector<std::string> row(const Verdict& v) {
    const bool none = v.differences.empty();
    return {fmt::format("{}  {}", v.device.number(), v.device.name),
            v.device.driver,
            v.device.version,
            word(v),
            fmt::format("{} of {}", static_cast<size_t>(v.pictures) - v.differences.size(), v.pictures),
            none ? "" : v.differences.front().place(),
            none ? "" : v.differences.front().suspect,
            fmt::format("{:.1f}", v.seconds)};
}

std::string line(const Difference& d) {
    std::string text =
        fmt::format("{}: another {}; first {}; {}", d.picture, fmt::join(d.results, ", "), d.place(), d.suspect);
    if (d.pixel)
        text += fmt::format("; {} is {:.9g}, on {} {:.9g}", d.pixel->channel, d.pixel->value, d.pixel->device,
                            d.pixel->expected);
    return text;
}

Json to_json(const Pixel& p) {
    // As text: JSON has no infinities and no NaN.
    return {{"x", p.x},
            {"y", p.y},
            {"channel", p.channel},
            {"value", fmt::format("{:.9g}", p.value)},
            {"expected", fmt::format("{:.9g}", p.expected)},
            {"expected_from", p.device}};
}

Json to_json(const Difference& d) {
    Json places = Json::array();
    for (const Place& place : d.places) places.push_back({place.x, place.y});
    return {{"picture", d.picture},
            {"results", d.results},
            {"kernel", d.suspect},
            {"first_pixel_one_of", places},
            {"first_pixel", d.pixel ? to_json(*d.pixel) : Json()}};
}

Json to_json(const Verdict& v) {
    Json differences = Json::array();
    for (const Difference& d : v.differences) differences.push_back(to_json(d));
    return {{"device", gnomon::to_json(v.device)},
            {"same", v.same()},
            {"pictures", v.pictures},
            {"differences", differences},
            {"notes", v.notes},
            {"error", v.error.empty() ? Json() : Json(v.error)},
            {"seconds", v.seconds}};
}

}  // namespace

std::string to_text(const std::vector<Verdict>& verdicts) {
    report::Table table{"Bits against the record",
                        "pictures of hard and easy scenes, every result",
                        {"device", "driver", "OpenCL", "bits", "same", "first difference", "kernel", "seconds"},
                        {},
                        ""};
    for (const Verdict& v : verdicts) table.rows.push_back(row(v));
    std::string text = report::to_text(table);
    for (const Verdict& v : verdicts) {
        for (const std::string& note : v.notes) text += v.device.number() + ": " + note + "\n";
        for (const Difference& d : v.differences) text += v.device.number() + ": " + line(d) + "\n";
        if (!v.error.empty()) text += v.device.number() + ": failed at " + v.error + "\n";
    }
    return text;
}

Json to_json(const std::vector<Verdict>& verdicts) {
    Json devices = Json::array();
    for (const Verdict& v : verdicts) devices.push_back(to_json(v));
    const bool same = std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.same(); });
    return {{"program", "gnomon " GNOMON_VERSION}, {"same", same}, {"devices", devices}};
}

}  // namespace gnomon::verify
