#include "report_html.h"

#include <fmt/core.h>

#include "plots.h"
#include "tables.h"

namespace gnomon::report {

namespace {

const char* const style = R"(
body { font: 16px/1.5 Georgia, "Times New Roman", serif; color: #222; margin: 2rem auto; max-width: 68rem;
       padding: 0 1rem; }
h1, h2, h3, th, td, figcaption, .about { font-family: Helvetica, Arial, sans-serif; }
h1 { font-size: 1.7rem; margin-bottom: 0.2rem; }
h2 { font-size: 1.3rem; border-bottom: 1px solid #bbb; margin-top: 2.5rem; }
h3 { font-size: 1.05rem; margin: 1.8rem 0 0.2rem; }
p { max-width: 46rem; }
.about { color: #555; font-size: 0.9rem; margin: 0.2rem 0; max-width: none; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.8rem; margin: 0.5rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.55rem; text-align: right; white-space: nowrap; }
th { border-top: 1.5px solid #222; border-bottom: 1px solid #222; white-space: normal; vertical-align: bottom; }
tbody tr:last-child td { border-bottom: 1.5px solid #222; }
th:first-child, td:first-child { text-align: left; white-space: pre; }
figure { margin: 1.5rem 0 2.5rem; }
figure svg { width: 100%; height: auto; }
figcaption { font-size: 0.9rem; color: #444; max-width: 52rem; }
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

std::string element(const std::string& tag, const std::string& text) {
    return "<" + tag + ">" + escaped(text) + "</" + tag + ">";
}

std::string cells(const std::string& tag, const std::vector<std::string>& texts) {
    std::string row = "<tr>";
    for (const std::string& text : texts) row += element(tag, text);
    return row + "</tr>\n";
}

std::string to_html(const Table& table) {
    std::string html = element("h3", table.title) + "\n<p class=\"about\">" + escaped(table.about) + "</p>\n";
    html += "<div class=\"wide\"><table>\n<thead>" + cells("th", table.columns) + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) html += cells("td", row);
    return html + "</tbody></table></div>\n<p class=\"about\">" + escaped(table.verdict) + "</p>\n";
}

std::string to_html(const Figure& figure, const std::string& prefix) {
    return "<figure>\n" + element("h3", figure.title) + inlined(figure.svg, prefix + figure.name + "-") +
           "<figcaption>" + escaped(figure.explanation) + "</figcaption>\n</figure>\n";
}

std::string to_html(const DeviceReport& device) {
    const DeviceInfo& d = device.device;
    std::string html = element("h2", d.name) + "\n<p class=\"about\">" +
                       escaped(fmt::format("Device {}, {}, {}, driver {}, {} compute units", d.number(),
                                           d.platform_name, d.version, d.driver, d.compute_units)) +
                       "</p>\n";
    for (const std::string& note : device.notes) html += element("p", note) + "\n";
    const std::string prefix = "d" + std::to_string(d.platform) + "-" + std::to_string(d.device) + "-";
    for (const Figure& figure : device.figures) html += to_html(figure, prefix);
    html += element("h2", "Rays against spheres, formula by formula") + "\n";
    for (const RootTable& table : device.roots) html += to_html(table_of(table));
    html += to_html(worst_rays(device)) + element("h2", "Pictures") + "\n";
    for (const PictureTable& table : device.pictures) html += to_html(table_of(table));
    return html;
}

}  // namespace

std::string to_html(const Report& report) {
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    html += "<meta name=\"viewport\" content=\"width=device-width\">\n<title>gnomon: speed and error</title>\n<style>";
    html += std::string(style) + "</style>\n</head>\n<body>\n" + element("h1", "gnomon: speed and error") + "\n";
    html += "<p class=\"about\">" + escaped("gnomon " GNOMON_VERSION ", " + report.date) +
            (report.quick ? ", quick: small samples" : "") + "</p>\n" + element("p", legend) + "\n";
    if (!report.plots.empty()) html += element("p", report.plots) + "\n";
    for (const DeviceReport& device : report.devices) html += to_html(device);
    return html + "</body>\n</html>\n";
}

}  // namespace gnomon::report
