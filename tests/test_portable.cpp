// For devices that are slow, or slow to compile: few kernels, small sizes. With verify's quick pictures
// (test_verify.cpp) these are the tests of the presets rusticl and oclgrind.
#include "check.h"
#include "ieee_operands.h"
#include "kernel_source.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene small_example(const std::string& name) {
    Scene scene = load_scene(std::string(GNOMON_SOURCE_DIR) + "/examples/" + name).scene;
    scene.image = {40, 30};
    return scene;
}

/// Two work-items, in one group or in two.
void launch_two(Bench& bench, const std::string& source, size_t local) {
    cl::Program program(bench.context, source);
    program.build({bench.device}, "");
    cl::Kernel kernel(program, "test");
    const cl::Buffer to(bench.context, CL_MEM_READ_WRITE, 2 * sizeof(int));
    kernel.setArg(0, to);
    bench.queue.enqueueNDRangeKernel(kernel, cl::NullRange, 2, local);
    bench.queue.finish();
}

}  // namespace

TEST_CASE("portable: quotients and roots are rounded correctly", "[portable]") {
    on_every_bench([](Bench& bench) {
        const Operands o = operands(1024, 30);
        const std::string rounding =
            bench.info.correctly_rounded ? " -D CORRECTLY_ROUNDED -cl-fp32-correctly-rounded-divide-sqrt" : "";
        cl::Program program(bench.context, kernel_source("generate_rays") + ieee_kernels);
        program.build({bench.device}, ("-D PACKETS=1 -D LANES=1" + rounding).c_str());
        const auto run = [&](const char* name, const auto&... inputs) {
            const GuardedBuffer<float> result(bench, o.a.size());
            const int items = static_cast<int>(o.a.size());
            bench.launch(cl::Kernel(program, name), items, GuardedBuffer<float>(bench, inputs).buffer()..., items,
                         result.buffer());
            return result.read();
        };
        CHECK(same_bits(run("test_divide", o.a, o.b), o.quotient));
        CHECK(same_bits(run("test_root", magnitudes(o.a), o.b), o.root));
    });
}

TEST_CASE("portable: pictures against the reference", "[portable]") {
    on_every_device([](Renderer& renderer) {
        for (const char* name : {"directional.json", "point.json"}) {
            INFO(name);
            const Scene scene = small_example(name);
            const Check found = check(scene, render(renderer, scene), true, 40 * 30);
            CHECK(found.pixels == 40 * 30);
            CHECK(found.wrong_pixels == 0);
        }
    });
}

/// For Oclgrind: two work-groups write one value.
TEST_CASE("a kernel with a race", "[.race]") {
    on_every_bench([](Bench& bench) {
        launch_two(bench, "kernel void test(global int* to) { to[0] = (int)get_global_id(0); }", 1);
    });
}

/// For Oclgrind: the last work-item writes beyond its buffer.
TEST_CASE("a kernel that writes beyond a buffer", "[.beyond]") {
    on_every_bench([](Bench& bench) {
        launch_two(bench, "kernel void test(global int* to) { to[get_global_id(0) + 1] = 7; }", 2);
    });
}
