#include "report_command.h"

#include <fmt/core.h>

#include <ctime>

#include "error.h"
#include "gnuplot.h"
#include "measure.h"
#include "plots.h"
#include "progress_line.h"
#include "report_html.h"
#include "report_json.h"
#include "scene_io.h"
#include "scenes.h"
#include "tables.h"
#include "temporary_file.h"

namespace gnomon {

namespace {

std::string date() {
    const std::time_t time = std::time(nullptr);
    char text[sizeof "2000-01-01T00:00:00Z"];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
    return text;
}

}  // namespace

ReportCommand::ReportCommand(CLI::App& app) {
    command_ = app.add_subcommand("report", "Measure speed and error together; write report.json and report.html.");
    command_->add_option("SCENE", scenes_, "scene files, JSON (default: the examples and a ground with 99 spheres)");
    devices_.emplace(*command_);
    command_->add_option("-o,--output", folder_, "folder for both files (default: this one)")->type_name("DIR");
    command_->add_flag("--quick", quick_, "small samples, few repetitions");
}

std::vector<report::NamedScene> ReportCommand::chosen_scenes() const {
    if (scenes_.empty()) return report::default_scenes();
    std::vector<report::NamedScene> scenes;
    for (const std::string& path : scenes_) {
        LoadedScene loaded = load_scene(path);
        for (const std::string& warning : loaded.warnings) fmt::print(stderr, "gnomon: warning: {}\n", warning);
        scenes.push_back({path, std::move(loaded.scene)});
    }
    return scenes;
}

report::Report ReportCommand::measured() const {
    const std::vector<report::NamedScene> scenes = chosen_scenes();
    const std::vector<DeviceInfo> devices = devices_->chosen();
    report::Report made{date(), quick_, {}, ""};
    if (!report::has_gnuplot())
        made.plots = "There are no plots: gnuplot is missing (Debian: apt install gnuplot-nox).";
    const report::Effort effort = quick_ ? report::quick_effort() : report::Effort{};
    say_progress("what is exact");
    const report::Exam exam = report::make_exam(effort);
    for (const DeviceInfo& device : devices) {
        made.devices.push_back(report::measure(device, exam, scenes, effort, say_progress));
        say_progress("plots");
        if (made.plots.empty()) made.devices.back().figures = report::figures(made.devices.back());
    }
    say_progress("");
    return made;
}

int ReportCommand::run() const {
    const std::string json = folder_ + "/report.json", html = folder_ + "/report.html";
    for (const std::string& path : {json, html}) check_folder(path);
    const report::Report made = measured();
    fmt::print("{}", report::to_text(made));
    if (!made.plots.empty()) fmt::print(stderr, "gnomon: warning: {}\n", made.plots);
    write_text(json, report::to_json(made).dump(2) + "\n");
    write_text(html, report::to_html(made));
    fmt::print("written: {}, {}\n", json, html);
    return 0;
}

}  // namespace gnomon
