#include "shortcomings.h"

#include <limits>

#include "error.h"
#include "hierarchy.h"
#include "plan.h"

namespace gnomon {

namespace {

/// Bytes of the arguments of the kernel that has most of them, shade_light: its structs, 11 buffers and 2 of the film
/// more, 12 numbers, each of 8 bytes at most.
constexpr uint64_t parameter_bytes =
    sizeof(PointPencilOf<double>) + sizeof(Real3Of<double>) + sizeof(Tile) + sizeof(Planes) + 28 * 8;

/// Those with which nothing can be rendered, or nothing right.
void add_unusable(const DeviceInfo& d, std::vector<Shortcoming>& found) {
    const auto add = [&](const std::string& lack, const std::string& answer) {
        found.push_back({lack, answer, false});
    };
    if (d.opencl_major < 1 || (d.opencl_major == 1 && d.opencl_minor < 2))
        add("no OpenCL 1.2 (" + d.version + ")", "commands that fill buffers are needed");
    if (!d.has_compiler) add("no compiler", "kernels are compiled when they are needed");
    if (!d.ieee) add("no IEEE floats", "rounding to nearest, infinities and NaN are needed for right decisions");
    if (!d.little_endian) add("not little-endian", "what crosses between host and device would be misread");
    if (d.max_parameter_bytes < parameter_bytes)
        add("kernel arguments of " + std::to_string(d.max_parameter_bytes) + " bytes at most",
            std::to_string(parameter_bytes) + " are needed");
}

bool crashes_on_walks(const DeviceInfo& d) { return d.platform_name == "rusticl" && d.driver.rfind("22.", 0) == 0; }

std::string bytes_of_addresses(const DeviceInfo& d) { return std::to_string(d.address_bits) + "-bit addresses"; }

}  // namespace

std::vector<Shortcoming> shortcomings(const DeviceInfo& d) {
    std::vector<Shortcoming> found;
    add_unusable(d, found);
    const auto add = [&](const std::string& lack, const std::string& answer) { found.push_back({lack, answer}); };
    const int group = preferred_local_size(d.type == DeviceType::cpu);
    if (!d.correctly_rounded) add("no correctly rounded divide and sqrt", "corrected by fma; the same bits, more work");
    if (!d.fp64)
        add("no double",
            "--accuracy double is refused; certified decides exactly on the host what float leaves open, "
            "which is slow where that is much");
    if (!d.fast_fma) add("no fma in hardware", "the same bits, slower: each is computed in software");
    if (!d.subnormals) add("no subnormal numbers", "values below 1.2e-38 become 0: a picture that has such may differ");
    if (d.max_work_group < static_cast<uint64_t>(group))
        add("work-groups of " + std::to_string(d.max_work_group) + " at most", "groups are that small; the same bits");
    if (d.address_bits < 64) add(bytes_of_addresses(d), "4 GiB at most are used; larger scenes go through in chunks");
    if (crashes_on_walks(d))
        add("a compiler that crashes on kernels that walk through clusters",
            "scenes of more than " + std::to_string(few_spheres) + " spheres are refused; Mesa 25.0 compiles them");
    if (!d.out_of_order) add("no out-of-order queue", "a tile is not read back while the next is computed");
    return found;
}

int64_t most_spheres(const DeviceInfo& device) {
    return crashes_on_walks(device) ? few_spheres : std::numeric_limits<int64_t>::max();
}

void check_spheres(int64_t count, const DeviceInfo& device) {
    if (count <= most_spheres(device)) return;
    throw Error(Blame::run,
                "found " + std::to_string(count) + " spheres, of which this driver's compiler bears " +
                    std::to_string(most_spheres(device)),
                device.name, "use a newer driver, or another --device: `gnomon devices` says why");
}

void check_usable(const DeviceInfo& device) {
    for (const Shortcoming& s : shortcomings(device))
        if (!s.usable)
            throw Error(Blame::run, "the device cannot be used, it has " + s.lack + ": " + s.answer, device.name,
                        "choose another --device: `gnomon devices` lists them");
}

}  // namespace gnomon
