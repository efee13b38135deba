// Devices that lack something, made of those that are here by saying so: the same bits, or a clear refusal.
#include "crowds.h"
#include "damaged_kernels.h"
#include "shortcomings.h"
#include "stats_json.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// A way in which a device may be less than it is.
struct Lesser {
    const char* name;
    void (*make)(DeviceInfo&);
};
std::ostream& operator<<(std::ostream& out, const Lesser& lesser) { return out << lesser.name; }

constexpr Lesser lessers[] = {
    {"divide and sqrt are not rounded correctly", [](DeviceInfo& d) { d.correctly_rounded = false; }},
    {"no double", [](DeviceInfo& d) { d.fp64 = false; }},
    {"fma in software", [](DeviceInfo& d) { d.fast_fma = false; }},
    {"work-groups of one", [](DeviceInfo& d) { d.max_work_group = 1; }},
    {"work-groups of three", [](DeviceInfo& d) { d.max_work_group = 3; }},
    {"registers for work-groups of two", [](DeviceInfo& d) { d.max_kernel_group = 2; }},
    {"addresses of 32 bits", [](DeviceInfo& d) { d.address_bits = 32; }},
    {"no constant memory", [](DeviceInfo& d) { d.max_constant_bytes = 0; }},
    {"no out-of-order queue", [](DeviceInfo& d) { d.out_of_order = false; }},
    {"memory of its own", [](DeviceInfo& d) { d.shares_memory = false; }},
    {"no parts", [](DeviceInfo& d) { d.sub_devices = 0; }},
    {"a GPU", [](DeviceInfo& d) { d.type = DeviceType::gpu; }},
    {"a driver that likes scalars", [](DeviceInfo& d) { d.native_width_float = 1; }},
};

/// Under nodes, lit from near and far.
Scene lit_crowd() {
    Scene scene = scene_of(Crowd::strewn, 2000);
    scene.image = {72, 40};
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60};
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 2, 3}}, PointLight{{10, 80, -100}, {1e5, 1e5, 1e5}}};
    return scene;
}

Scene example(const char* name) {
    Scene scene = load_scene(std::string(GNOMON_SOURCE_DIR) + "/examples/" + name).scene;
    scene.image = {72, 40};
    return scene;
}

Film render_as(const DeviceInfo& device, const Scene& scene, Accuracy accuracy) {
    Renderer renderer(device);
    RenderOptions options = all_outputs();
    options.accuracy = accuracy;
    return render(renderer, scene, options);
}

template <class Test>
void on_each(Test test) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name)
    test(device);
}

bool says(const DeviceInfo& device, const std::string& lack) {
    const std::vector<Shortcoming> all = shortcomings(device);
    return std::any_of(all.begin(), all.end(), [&](const Shortcoming& s) { return contains(s.lack, lack); });
}

}  // namespace

TEST_CASE("lesser devices: strict pictures have the same bits", "[lesser]") {
    on_each([](const DeviceInfo& device) {
        const Scene scene = example("point.json");
        const Film film = render_as(device, scene, Accuracy::strict);
        for (const Lesser& lesser : lessers) {
            INFO(lesser);
            DeviceInfo less = device;
            lesser.make(less);
            CHECK(same_bits(render_as(less, scene, Accuracy::strict), film));
        }
    });
}

TEST_CASE("lesser devices: certified pictures have the same bits, and without double the same ids", "[lesser]") {
    on_each([](const DeviceInfo& device) {
        const Scene scene = example("point.json");
        const Film film = render_as(device, scene, Accuracy::certified);
        for (const Lesser& lesser : lessers) {
            INFO(lesser);
            DeviceInfo less = device;
            lesser.make(less);
            const Film other = render_as(less, scene, Accuracy::certified);
            if (less.fp64 == device.fp64)
                CHECK(same_bits(other, film));
            else
                CHECK(std::equal(film.id.begin(), film.id.end(), other.id.begin()));
        }
    });
}

TEST_CASE("lesser devices: quotients and roots that are 2 ulp off give the same bits", "[lesser]") {
    on_each([](const DeviceInfo& device) {
        DeviceInfo less = device;
        less.correctly_rounded = false;
        for (const Accuracy accuracy : {Accuracy::strict, Accuracy::certified}) {
            INFO(to_string(accuracy));
            const Scene scene = accuracy == Accuracy::strict ? lit_crowd() : example("point.json");
            const Film film = render_as(device, scene, accuracy);
            const DamagedKernels damaged({
                {"ieee.h", "const floatw q = a / b;", "const floatw q = as_floatw(as_intw(a / b) + 2);"},
                {"ieee.h", "wide(1.0f) / b);", "as_floatw(as_intw(wide(1.0f) / b) - 2));"},
                {"ieee.h", "const floatw s = sqrt(a);", "const floatw s = as_floatw(as_intw(sqrt(a)) - 2);"},
                {"ieee.h", "wide(0.5f) / s);", "as_floatw(as_intw(wide(0.5f) / s) + 2));"},
                // What bounds are made of, outward and inward.
                {"fat_ray.h", "scale = wide_float(1.0f) / along;", "scale = wide_float(1.0f - 0x1p-22f) / along;"},
                {"fat_ray.h", "/ sqrt(fma(at, at, (float4)(1.0f)))", "/ sqrt(fma(at, at, (float4)(1.0f + 0x1p-22f)))"},
            });
            CHECK(same_bits(render_as(less, scene, accuracy), film));
        }
    });
}

TEST_CASE("lesser devices: what a driver's compiler crashes on is refused before", "[lesser]") {
    on_each([](const DeviceInfo& device) {
        DeviceInfo less = device;
        less.platform_name = "rusticl";
        less.driver = "22.3.6";
        CHECK(says(less, "crashes"));
        CHECK(contains(refusal(1, [&] { render_as(less, lit_crowd(), Accuracy::strict); }), "2000 spheres"));
        const Scene few = example("directional.json");
        CHECK(same_bits(render_as(less, few, Accuracy::strict), render_as(device, few, Accuracy::strict)));
        less.driver = "25.0.7-2+deb13u1";
        CHECK_FALSE(says(less, "crashes"));
    });
}

TEST_CASE("lesser devices: double is refused where there is none", "[lesser]") {
    on_each([](const DeviceInfo& device) {
        DeviceInfo less = device;
        less.fp64 = false;
        CHECK(contains(refusal(2, [&] { render_as(less, lit_crowd(), Accuracy::full); }), "cl_khr_fp64"));
    });
}

TEST_CASE("lesser devices: 32-bit addresses reach 4 GiB", "[lesser]") {
    DeviceInfo device;
    device.global_bytes = device.max_alloc_bytes = uint64_t{1} << 40;
    CHECK(DeviceLimits(device).global_bytes == uint64_t{1} << 40);
    device.address_bits = 32;
    CHECK(DeviceLimits(device).global_bytes == 0xffffffff);
    CHECK(DeviceLimits(device).max_alloc_bytes == 0xffffffff);
}

TEST_CASE("lesser devices: those on which pictures would be wrong are refused", "[lesser]") {
    constexpr Lesser unusable[] = {
        {"no compiler", [](DeviceInfo& d) { d.has_compiler = false; }},
        {"no IEEE floats", [](DeviceInfo& d) { d.ieee = false; }},
        {"not little-endian", [](DeviceInfo& d) { d.little_endian = false; }},
        {"no OpenCL 1.2", [](DeviceInfo& d) { d.opencl_minor = 1, d.opencl_major = 1; }},
        {"kernel arguments of 256 bytes", [](DeviceInfo& d) { d.max_parameter_bytes = 256; }},
    };
    for (const DeviceInfo& device : list_devices()) {
        check_usable(device);
        for (const Lesser& lesser : unusable) {
            DeviceInfo less = device;
            lesser.make(less);
            const std::string message = refusal(1, [&] { Renderer renderer(less); });
            CHECK(contains(message, lesser.name));
            CHECK(contains(message, device.name));
            CHECK(contains(message, "--device"));
            CHECK(says(less, lesser.name));
        }
    }
}

TEST_CASE("lesser devices: what they lack is said, and in JSON", "[lesser]") {
    DeviceInfo device;
    device.max_work_group = 8;
    device.address_bits = 32;
    device.fast_fma = device.subnormals = false;
    for (const char* lack :
         {"correctly rounded", "double", "fma", "subnormal", "groups of 8", "32-bit", "out-of-order"})
        CHECK(says(device, lack));
    const auto json = to_json(device);
    CHECK(json.at("lacks").size() == shortcomings(device).size());
    CHECK(json.at("lacks").at(0).contains("answer"));
    DeviceInfo whole;
    whole.correctly_rounded = whole.fp64 = whole.out_of_order = true;
    whole.max_work_group = whole.max_parameter_bytes = 1024;
    CHECK(shortcomings(whole).empty());
}

TEST_CASE("lesser devices: no kernel uses constant memory, of which there may be none", "[lesser]") {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GNOMON_SOURCE_DIR) + "/cl")) {
        if (entry.path().filename() == "builtins.h") continue;  // declares what there is, of which little is called
        std::istringstream lines(read_file(entry.path().string()));
        for (std::string line; std::getline(lines, line);) {
            INFO(entry.path() << ": " << line);
            const std::string code = line.substr(0, line.find("//"));
            CHECK_FALSE(contains(code, "constant "));
            CHECK_FALSE(contains(code, "local "));
        }
    }
}
