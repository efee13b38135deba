#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "shortcomings.h"
#include "stats_json.h"

namespace gnomon {

namespace {

const char* yes(bool b) { return b ? "yes" : "no"; }

void print(const DeviceInfo& d) {
    fmt::print("{}  {}  {}\n", d.number(), to_string(d.type), d.name);
    fmt::print("     platform {}, {}, driver {}\n", d.platform_name, d.version, d.driver);
    fmt::print("     {} compute units, {} MiB, {} MiB in one buffer, native float vectors of {}\n", d.compute_units,
               d.global_bytes >> 20, d.max_alloc_bytes >> 20, d.native_width_float);
    if (d.sub_devices > 0)
        fmt::print("     can be split into {} cores, {} KiB of cache each\n", d.sub_devices, d.core_cache_bytes >> 10);
    else
        fmt::print("     cannot be split into cores\n");
    fmt::print("     {}-bit addresses, groups of {} work-items, {} KiB of constant memory, {} bytes of arguments\n",
               d.address_bits, d.max_work_group, d.max_constant_bytes >> 10, d.max_parameter_bytes);
    fmt::print("     correctly rounded divide and sqrt: {}, double: {}, fast fma: {}, subnormal numbers: {}\n",
               yes(d.correctly_rounded), yes(d.fp64), yes(d.fast_fma), yes(d.subnormals));
    fmt::print("     out-of-order queue: {}, shares memory: {}\n", yes(d.out_of_order), yes(d.shares_memory));
    for (const Shortcoming& s : shortcomings(d))
        fmt::print("     {}{}: {}\n", s.usable ? "" : "cannot be used: ", s.lack, s.answer);
}

}  // namespace

DevicesCommand::DevicesCommand(CLI::App& app) {
    command_ = app.add_subcommand("devices", "List the OpenCL devices, numbered as clinfo -l does.");
    command_->add_flag("--json", json_, "as JSON");
}

int DevicesCommand::run() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const DeviceInfo& device : list_devices()) {
        if (json_)
            list.push_back(to_json(device));
        else
            print(device);
    }
    if (json_) fmt::print("{}\n", list.dump(2));
    return 0;
}

}  // namespace gnomon
