// Which device a request means, among devices that need not exist.
#include "device.h"

#include <sched.h>
#include <unistd.h>

#include <cstdlib>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

DeviceInfo device(int platform, int number, DeviceType type, const std::string& name, const std::string& of) {
    DeviceInfo info;
    info.platform = platform;
    info.device = number;
    info.type = type;
    info.name = name;
    info.platform_name = of;
    return info;
}

const std::vector<DeviceInfo> one_each = {
    device(0, 0, DeviceType::cpu, "pthread-AMD EPYC", "Portable Computing Language"),
    device(1, 0, DeviceType::gpu, "GeForce GT 710", "NVIDIA CUDA"),
    device(2, 0, DeviceType::accel, "PAC Arria 10", "Intel FPGA SDK"),
};

std::string chosen(const std::vector<DeviceInfo>& devices, const std::string& request) {
    return choose_device(devices, request).number();
}

std::string refused(const std::vector<DeviceInfo>& devices, const std::string& request) {
    const std::string message = refusal(2, [&] { choose_device(devices, request); });
    CHECK(contains(message, request));
    for (const DeviceInfo& d : devices) {
        CHECK(contains(message, d.number()));
        CHECK(contains(message, d.name));
    }
    return message;
}

}  // namespace

TEST_CASE("a device is chosen by its number", "[device]") {
    CHECK(chosen(one_each, "0:0") == "0:0");
    CHECK(chosen(one_each, "1:0") == "1:0");
    CHECK(chosen(one_each, "2:0") == "2:0");
    refused(one_each, "0:1");
    refused(one_each, "3:0");
    refused(one_each, "00:0");
}

TEST_CASE("a number is not part of another", "[device]") {
    const std::vector<DeviceInfo> devices = {device(10, 0, DeviceType::cpu, "ten", "P"),
                                             device(1, 0, DeviceType::cpu, "one", "P"),
                                             device(1, 10, DeviceType::cpu, "one, ten", "P")};
    CHECK(chosen(devices, "1:0") == "1:0");
    CHECK(chosen(devices, "10:0") == "10:0");
    CHECK(chosen(devices, "1:10") == "1:10");
    refused(devices, "0:0");
    refused(devices, "1:1");
}

TEST_CASE("a device is chosen by its type", "[device]") {
    CHECK(chosen(one_each, "cpu") == "0:0");
    CHECK(chosen(one_each, "gpu") == "1:0");
    CHECK(chosen(one_each, "accel") == "2:0");
    CHECK(chosen(one_each, "GPU") == "1:0");
}

TEST_CASE("a type is not part of a name", "[device]") {
    const std::vector<DeviceInfo> devices = {device(0, 0, DeviceType::gpu, "cpu-like thing", "gpu and CPU platform"),
                                             device(0, 1, DeviceType::cpu, "accel gpu", "gpu and CPU platform")};
    CHECK(chosen(devices, "cpu") == "0:1");
    CHECK(chosen(devices, "gpu") == "0:0");
    refused(devices, "accel");
    refused({devices[0]}, "cpu");
}

TEST_CASE("a device is chosen by part of its name or its platform's, in any case", "[device]") {
    CHECK(chosen(one_each, "epyc") == "0:0");
    CHECK(chosen(one_each, "EPYC") == "0:0");
    CHECK(chosen(one_each, "geforce gt") == "1:0");
    CHECK(chosen(one_each, "nvidia") == "1:0");
    CHECK(chosen(one_each, "PORTABLE") == "0:0");
    CHECK(chosen(one_each, "Arria 10") == "2:0");
    CHECK(chosen(one_each, "fpga") == "2:0");
    CHECK(contains(refused(one_each, "radeon"), "no such device"));
}

TEST_CASE("a request that means several devices is refused", "[device]") {
    const std::vector<DeviceInfo> twins = {device(0, 0, DeviceType::gpu, "A100", "NVIDIA CUDA"),
                                           device(0, 1, DeviceType::gpu, "A100", "NVIDIA CUDA")};
    for (const char* request : {"gpu", "a100", "cuda"}) CHECK(contains(refused(twins, request), "several"));
    CHECK(chosen(twins, "0:1") == "0:1");
}

TEST_CASE("without a request the first GPU is taken, else the first CPU, else the first", "[device]") {
    const DeviceInfo accel = device(0, 0, DeviceType::accel, "accel", "P"),
                     other = device(0, 1, DeviceType::other, "o", "P"), cpu = device(1, 0, DeviceType::cpu, "cpu", "P"),
                     cpu2 = device(1, 1, DeviceType::cpu, "cpu", "P"), gpu = device(2, 0, DeviceType::gpu, "gpu", "P"),
                     gpu2 = device(2, 1, DeviceType::gpu, "gpu", "P");
    CHECK(chosen({accel, cpu, cpu2, gpu, gpu2}, "") == "2:0");
    CHECK(chosen({accel, other, cpu, cpu2}, "") == "1:0");
    CHECK(chosen({other, accel}, "") == "0:1");
    CHECK(refusal(1, [] { choose_device({}, ""); }) != "");
}

TEST_CASE("the devices here describe themselves plausibly", "[device]") {
    const std::vector<DeviceInfo> devices = list_devices();
    REQUIRE_FALSE(devices.empty());
    for (const DeviceInfo& d : devices) {
        INFO(d.number() << " " << d.name);
        CHECK_FALSE(d.name.empty());
        CHECK_FALSE(d.platform_name.empty());
        CHECK(d.version.rfind("OpenCL ", 0) == 0);  // OpenCL 1.2, table 4.3: CL_DEVICE_VERSION
        CHECK(d.name.find('\0') == std::string::npos);
        CHECK(d.compute_units > 0);
        CHECK((d.sub_devices == 0 || (d.sub_devices == d.compute_units && d.sub_devices > 1)));
        CHECK(d.max_work_group >= 1);
        CHECK(d.max_alloc_bytes >= 1 << 20);
        CHECK(d.global_bytes >= d.max_alloc_bytes);
        CHECK(chosen(devices, d.number()) == d.number());
    }
}

TEST_CASE("PoCL's threads are pinned where all cores may be used, and nobody said otherwise", "[device]") {
    const char* const name = "POCL_AFFINITY";
    const char* const before = std::getenv(name);
    const std::string kept = before ? before : "";
    cpu_set_t all, one;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    setenv(name, "0", 1);
    pin_device_threads();
    CHECK(std::getenv(name) == std::string("0"));
    unsetenv(name);
    if (CPU_COUNT(&all) > 1) {
        CPU_ZERO(&one);
        for (size_t cpu = 0; CPU_COUNT(&one) == 0; ++cpu)
            if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
        REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
        pin_device_threads();
        CHECK(std::getenv(name) == nullptr);
        REQUIRE(sched_setaffinity(0, sizeof all, &all) == 0);
    }
    pin_device_threads();
    const char* const now = std::getenv(name);
    if (CPU_COUNT(&all) == sysconf(_SC_NPROCESSORS_ONLN))
        CHECK((now && now == std::string("1")));
    else
        CHECK(now == nullptr);
    before ? setenv(name, kept.c_str(), 1) : unsetenv(name);
}
