// Which devices requests mean: pure, but for cutting a device into parts.
#include <algorithm>
#include <cctype>

#include "device.h"
#include "error.h"
#include "opencl.h"

namespace gnomon {

namespace {

std::string lower(std::string s) {
    std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
}

/// `request` in lower case: a number or a type means just that, anything else is part of a name.
bool matches(const DeviceInfo& info, const std::string& request) {
    const bool number = request.find(':') != std::string::npos;
    if (number && request.find_first_not_of("0123456789:") == std::string::npos) return request == info.number();
    for (const DeviceType type : {DeviceType::cpu, DeviceType::gpu, DeviceType::accel})
        if (request == to_string(type)) return info.type == type;
    return lower(info.name).find(request) != std::string::npos ||
           lower(info.platform_name).find(request) != std::string::npos;
}

std::string listed(const std::vector<DeviceInfo>& devices) {
    std::string list = "devices here:";
    for (const DeviceInfo& d : devices)
        list += "\n    " + d.number() + "  " + to_string(d.type) + "  " + d.name + " (" + d.platform_name + ")";
    return list;
}

const DeviceInfo& preferred(const std::vector<DeviceInfo>& devices) {
    for (const DeviceType type : {DeviceType::gpu, DeviceType::cpu})
        for (const DeviceInfo& d : devices)
            if (d.type == type) return d;
    return devices.front();
}

}  // namespace

const DeviceInfo& choose_device(const std::vector<DeviceInfo>& devices, const std::string& request) {
    if (devices.empty()) throw Error(Blame::run, "no OpenCL device to choose from");
    if (request.empty()) return preferred(devices);
    std::vector<const DeviceInfo*> found;
    for (const DeviceInfo& d : devices)
        if (matches(d, lower(request))) found.push_back(&d);
    if (found.size() == 1) return *found.front();
    throw Error(Blame::input, found.empty() ? "no such device" : "several devices match", "--device " + request,
                "give P:D, cpu, gpu, accel or part of a name that only one device has; " + listed(devices));
}

namespace {

std::vector<DeviceInfo> cut(const DeviceInfo& whole, const std::string& number, const std::string& request) try {
    const auto refuse = [&](const std::string& what) {
        throw Error(Blame::input, what, "--device " + request,
                    whole.name + " has " + std::to_string(whole.compute_units) +
                        " compute units, which N must divide; each part has as many");
    };
    const bool is_number =
        !number.empty() && number.size() < 6 && number.find_first_not_of("0123456789") == std::string::npos;
    const int parts = is_number ? std::stoi(number) : 0;
    if (parts < 1) refuse("found " + number + ", expected a number of parts");
    if (whole.sub_devices == 0 && parts > 1) refuse("the device cannot be cut into parts");
    if (whole.compute_units % parts != 0) refuse("the device cannot be cut into " + number + " equal parts");
    if (parts == 1) return {whole};
    return parts_of(whole, parts);
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), "--device " + request);
}

std::vector<DeviceInfo> meant_by(const std::vector<DeviceInfo>& devices, const std::string& request) {
    if (lower(request) == "all") return devices;
    const size_t slash = request.rfind('/');
    if (slash == std::string::npos) return {choose_device(devices, request)};
    return cut(choose_device(devices, request.substr(0, slash)), request.substr(slash + 1), request);
}

}  // namespace

std::vector<DeviceInfo> choose_devices(const std::vector<DeviceInfo>& devices,
                                       const std::vector<std::string>& requests) {
    if (requests.empty()) return {choose_device(devices, "")};
    std::vector<DeviceInfo> chosen;
    for (const std::string& request : requests) {
        for (const DeviceInfo& device : meant_by(devices, request)) {
            const auto same = [&](const DeviceInfo& d) {
                return d.platform == device.platform && d.device == device.device &&
                       (d.parts != device.parts || d.part == device.part);
            };
            if (std::any_of(chosen.begin(), chosen.end(), same))
                throw Error(Blame::input, "device " + device.number() + " is asked for twice", "--device " + request,
                            "a device renders no faster for that; for its parts, give P:D/N once");
            chosen.push_back(device);
        }
    }
    return chosen;
}

std::vector<DeviceInfo> with_cores_joined(const std::vector<DeviceInfo>& devices) try {
    std::vector<DeviceInfo> joined;
    for (const DeviceInfo& device : devices) {
        const auto beside = [&](const DeviceInfo& d) {
            return d.platform == device.platform && d.device == device.device && d.parts == device.parts;
        };
        const bool is_core = device.parts > 0 && device.compute_units == 1;
        if (!is_core || std::count_if(devices.begin(), devices.end(), beside) != device.parts) {
            joined.push_back(device);
        } else if (device.part == 0) {
            joined.push_back(whole_of(device));
            joined.back().cores_apart = true;
        }
    }
    return joined;
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), "listing OpenCL devices", "`clinfo` shows what the drivers say");
}

}  // namespace gnomon
