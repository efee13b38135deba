#include "verify_command.h"

#include <fmt/core.h>

#include <algorithm>

#include "error.h"
#include "progress_line.h"
#include "tables.h"
#include "temporary_file.h"

namespace gnomon {

VerifyCommand::VerifyCommand(CLI::App& app) {
    command_ =
        app.add_subcommand("verify", "Compare devices' pictures with the recorded bits: first on a new machine.");
    devices_.emplace(*command_);
    command_->add_flag("--quick", quick_, "fewer scenes, 40 x 30 pixels: for slow or simulated devices");
    CLI::Option* json = command_->add_option("--json", json_path_, "all that was found")->type_name("FILE");
    command_->add_option("--record", record_path_, "record the bits of one device anew: see CONTRIBUTING.md")
        ->type_name("FILE")
        ->excludes(json);
}

int VerifyCommand::record() const {
    const std::vector<DeviceInfo> devices = devices_->chosen();
    if (devices.size() != 1) throw Error(Blame::input, "found several devices, expected one to record", "--device");
    const verify::Record made = verify::record(devices.front(), say_progress);
    say_progress("");
    write_text(record_path_, verify::to_text(made));
    fmt::print("written: {}, {} pictures of {}\n", record_path_, made.size(), devices.front().name);
    return 0;
}

int VerifyCommand::compare() const {
    const std::vector<verify::Case> cases = verify::cases(quick_);
    std::vector<verify::Verdict> verdicts;
    for (const DeviceInfo& device : devices_->chosen())
        verdicts.push_back(verify::verify_device(device, cases, verify::recorded(), say_progress));
    verify::find_pixels(verdicts, cases, say_progress);
    say_progress("");
    fmt::print("{}", verify::to_text(verdicts));
    if (!json_path_.empty()) write_text(json_path_, verify::to_json(verdicts).dump(2) + "\n");
    return std::all_of(verdicts.begin(), verdicts.end(), [](const verify::Verdict& v) { return v.same(); }) ? 0 : 1;
}

int VerifyCommand::run() const {
    for (const std::string& path : {json_path_, record_path_})
        if (!path.empty()) check_folder(path);
    return record_path_.empty() ? compare() : record();
}

}  // namespace gnomon
