// Kernels built together: each is there as if it had been built alone, and one that cannot be built is named.
#include "catch.h"
#include "error.h"
#include "kernel_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const Variant rays{Kernel::generate_rays, Width{1, 1}.defines()};
const Variant wide_rays{Kernel::generate_rays, Width{4, 4}.defines()};
const Variant counts = sphere_variant(Kernel::count_digits, Accuracy::strict);
const Variant broken{Kernel::scan_counts, {"place=("}};

std::string message_of(Bench& bench, const std::vector<Variant>& variants) {
    try {
        bench.programs.build(variants, nullptr);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("kernels built together are those built alone", "[program]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.name) {
            Bench alone(device), together(device);
            const std::vector<Variant> all{rays, counts, wide_rays, counts};
            alone.programs.get(counts);
            alone.programs.build({}, nullptr);
            CHECK_FALSE(alone.programs.has(rays));
            together.programs.build(all, nullptr);
            for (const Variant& variant : all) {
                REQUIRE(together.programs.has(variant));
                const BuiltKernel &one = alone.programs.get(variant), &other = together.programs.get(variant);
                CHECK(other.options == one.options);
                CHECK(other.group_limit == one.group_limit);
                CHECK(other.kernel.getInfo<CL_KERNEL_FUNCTION_NAME>() == to_string(variant.kernel));
                CHECK(other.kernel.getInfo<CL_KERNEL_NUM_ARGS>() == one.kernel.getInfo<CL_KERNEL_NUM_ARGS>());
            }
        }
}

TEST_CASE("the kernel that cannot be built is named, and the others still can be", "[program]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.name) {
            Bench bench(device);
            const std::string message = message_of(bench, {rays, broken, counts});
            CHECK(contains(message, "cannot build kernel scan_counts"));
            CHECK_FALSE(bench.programs.has(broken));
            CHECK(message_of(bench, {rays, counts}).empty());
            CHECK(bench.programs.has(counts));
        }
}

TEST_CASE("building ends when it is asked to", "[program]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.name) {
            Bench bench(device);
            Stop stop;
            stop.ask();
            CHECK_THROWS_AS(bench.programs.build({rays, counts}, &stop), Stopped);
            CHECK_FALSE(bench.programs.has(rays));
        }
}
