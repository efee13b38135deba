// gnomon verify: devices that have the recorded bits, and kernels that are made not to.
#include "verify/verify.h"

#include <fmt/core.h>

#include "../cl/types.h"
#include "damaged_kernels.h"
#include "scenes.h"
#include "verify/tables.h"

using namespace gnomon;
using namespace gnomon::test;
using namespace gnomon::verify;

namespace {

void nothing(const std::string&) {}

Case quick_case(const std::string& name) {
    for (const Case& of : cases(true))
        if (of.name == name) return of;
    FAIL("no such case: " << name);
    throw;
}

/// What the first picture that differs is said to have, of a device whose kernels are damaged.
Difference found(const DeviceInfo& device, const std::string& scene, const DamagedKernels&) {
    const Verdict verdict = verify_device(device, {quick_case(scene)}, recorded(), nothing);
    INFO(to_text({verdict}));
    REQUIRE(verdict.error.empty());
    REQUIRE_FALSE(verdict.differences.empty());
    return verdict.differences.front();
}

template <class Test>
void on_each(Test test) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name)
    test(device);
}

/// A hit that is lit, somewhere in the middle of directional's quick picture, by its place in block order: a wrong id
/// there changes the radiance too.
struct LitRay {
    std::string ray, pixel;
};

LitRay lit_ray() {
    Renderer renderer(list_devices().front());
    Film film;
    render(renderer, quick_case("directional"), {Accuracy::strict}, film);
    const int blocks_x = (film.width + BLOCK_SIDE - 1) / BLOCK_SIDE;
    for (int j = film.height / 3; j < film.height; ++j)
        for (int i = 0; i < film.width; ++i) {
            if (!(film.radiance[0][pixel(film, i, j)] > 0)) continue;
            const int block = j / BLOCK_SIDE * blocks_x + i / BLOCK_SIDE;
            return {std::to_string(block * BLOCK_RAYS + j % BLOCK_SIDE * BLOCK_SIDE + i % BLOCK_SIDE),
                    fmt::format("pixel ({}, {})", i, j)};
        }
    FAIL("nothing is lit");
    throw;
}

/// At the end of intersect_closest that ray hits the next sphere of the three.
Damage wrong_hit(const LitRay& at) {
    const std::string end = "count_hits(hit_counts + pass.first_block, item, REDUCE";
    return {"intersect_closest.cl", end,
            fmt::format("if (item == {0} / (LANES * PACKETS)) ids[{0}] = (ids[{0}] + 1) % 3;\n", at.ray) + end};
}

}  // namespace

TEST_CASE("verify: the devices here have the recorded bits", "[verify][portable]") {
    on_each([](const DeviceInfo& device) {
        const Verdict verdict = verify_device(device, cases(true), recorded(), nothing);
        INFO(to_text({verdict}));
        CHECK(verdict.same());
        int64_t suiting = 0;
        for (const Case& of : cases(true)) suiting += of.suits(device);
        CHECK(suiting >= 2);  // the examples
        CHECK(verdict.pictures == suiting * static_cast<int64_t>(modes(device).size()));
    });
}

TEST_CASE("verify: a wrong hit is found, with its pixel and its kernel", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const LitRay at = lit_ray();
        const Difference d = found(device, "directional", DamagedKernels({wrong_hit(at)}));
        CHECK(d.place() == at.pixel);
        CHECK(d.results.front() == "id");
        CHECK(contains(d.suspect, "intersect_closest"));
        CHECK_FALSE(contains(d.suspect, "resolve"));
    });
}

TEST_CASE("verify: a wrong share of one light is found, with its light and its kernel", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const std::string before = "if (pass->arrival >= 0) {",
                          wrong = "if (LIGHT == LIGHT_POINT) FOR_PACKETS(k) share[k] *= 1 + 0x1p-22f;\n";
        const Difference d = found(device, "point", DamagedKernels({{"shade_light.cl", before, wrong + before}}));
        CHECK(d.results == std::vector<std::string>{"radiance"});
        CHECK(contains(d.suspect, "shade_light, light "));
    });
}

TEST_CASE("verify: a missing shadow is told from wrong shading", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const Difference d = found(device, "directional",
                                   DamagedKernels({{"shadow.h", "group[k] = share[k] > 0.0f;", "group[k] = 0;"}}));
        CHECK(d.results == std::vector<std::string>{"radiance"});
        CHECK((contains(d.suspect, "shadow rays, light ") || contains(d.suspect, "intersect_shadow, light ")));
    });
}

TEST_CASE("verify: what is resolved wrongly is told from what is computed wrongly", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const std::string end = "plane2);\n}", wrong = "plane2);\n    if (item == 0) plane0[5] ^= 1;\n}";
        const Difference d = found(device, "directional", DamagedKernels({{"resolve.cl", end, wrong}}));
        CHECK(d.place() == "pixel (5, 0)");
        CHECK(d.suspect.rfind("resolve", 0) == 0);
    });
}

TEST_CASE("verify: what is passed over by the hierarchy is found", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const Difference d =
            found(device, "crowd", DamagedKernels({{"bound_nodes.cl", "vload16(0, n->x1)", "vload16(0, n->x0)"}}));
        CHECK(d.results.front() == "id");
        CHECK(contains(d.suspect, "bound_nodes"));
    });
}

TEST_CASE("verify: a kernel that cannot be built is the verdict, with its log", "[verify]") {
    on_each([](const DeviceInfo& device) {
        const DamagedKernels damaged({{"types.h", "#define BLOCK_SIDE 8", "#error \"not on this device\""}});
        const Verdict verdict = verify_device(device, {quick_case("directional")}, recorded(), nothing);
        CHECK_FALSE(verdict.same());
        CHECK(contains(verdict.error, "directional 40x30 strict"));
        CHECK(contains(verdict.error, "types.h"));
    });
}

TEST_CASE("verify: exit code 1, the pixel and the kernel on the command line, and as JSON", "[verify]") {
    const LitRay at = lit_ray();
    const DamagedKernels damaged({wrong_hit(at)});
    const TempFolder folder;
    const Ran ran = run_program("verify --quick --json " + quoted(folder / "v.json"), damaged.environment());
    CHECK(ran.code == 1);
    CHECK(contains(ran.out, "different"));
    CHECK(contains(ran.out, "first " + at.pixel + "; "));
    CHECK(contains(ran.out, "intersect_closest"));
    const auto json = nlohmann::json::parse(read_file(folder / "v.json"));
    CHECK(json.at("same") == false);
    CHECK(json.at("devices").at(0).at("differences").at(0).at("first_pixel_one_of").size() == 1);
}
