#include "device_options.h"

#include <algorithm>
#include <cstdlib>

namespace gnomon {

DeviceOptions::DeviceOptions(CLI::App& command) {
    CLI::Option* device =
        command
            .add_option("--device", requests_,
                        "P:D as clinfo -l numbers them, cpu, gpu, accel, or part of a name (Env:GNOMON_DEVICE)")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_flag("--all-devices", all_, "every device that there is")->excludes(device);
}

std::vector<DeviceInfo> DeviceOptions::chosen() const {
    const std::vector<DeviceInfo> all = list_devices();
    if (all_) return all;
    if (requests_.empty()) {  // asked for here, since --all-devices goes with the variable but not with --device
        const char* preset = std::getenv("GNOMON_DEVICE");
        return {choose_device(all, preset ? preset : "")};
    }
    std::vector<DeviceInfo> chosen;
    for (const std::string& request : requests_) {
        const DeviceInfo& device = choose_device(all, request);
        const auto same = [&](const DeviceInfo& d) { return d.number() == device.number(); };
        if (std::none_of(chosen.begin(), chosen.end(), same)) chosen.push_back(device);
    }
    return chosen;
}

}  // namespace gnomon
