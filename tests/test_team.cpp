// Several devices at once: what they make together has the bits that one makes, and each tile is made once.
#include "team.h"

#include "catch.h"
#include "crowds.h"
#include "error.h"
#include "render.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene lit(int spheres) {
    Scene scene = scene_of(Crowd::strewn, spheres);
    scene.image = {500, 300};
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60};
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, PointLight{{20, 40, -90}, {9e4, 9e4, 9e4}}};
    return scene;
}

/// The first device that can be cut into two equal parts, if there is one.
std::vector<DeviceInfo> halves() {
    const std::vector<DeviceInfo> all = list_devices();
    for (const DeviceInfo& device : all)
        if (device.sub_devices > 1 && device.compute_units % 2 == 0)
            return choose_devices(all, {device.number() + "/2"});
    return {};
}

/// Both halves, which are one device if they are cores; and a device with a half of itself, which are two.
std::vector<std::vector<DeviceInfo>> teams() {
    const std::vector<DeviceInfo> parts = halves();
    if (parts.empty()) return {};  // no device here can be cut
    return {parts, {whole_of(parts[0]), parts[1]}};
}

}  // namespace

TEST_CASE("team: two devices make the same bits as one, in every accuracy", "[team]") {
    for (const std::vector<DeviceInfo>& two_devices : teams()) {
        REQUIRE(two_devices.size() == 2);
        INFO(two_devices[0].number() << ", " << two_devices[1].number());
        Renderer alone(whole_of(two_devices[0])), both(two_devices);
        for (const Accuracy accuracy : available_accuracies(two_devices.front()))
            for (const int spheres : {60, 600}) {
                if (accuracy == Accuracy::fast) continue;  // promises no bits
                INFO(to_string(accuracy) << ", " << spheres << " spheres");
                RenderOptions options;
                options.accuracy = accuracy;
                options.tile = 1 << 12;
                options.outputs = {true, true, true, true};
                Film one, two;
                const RenderStats whole = alone.render(lit(spheres), options, one),
                                  shared = both.render(lit(spheres), options, two);
                CHECK(same_bits(one, two));
                CHECK(shared.hits == whole.hits);
                CHECK(shared.rays == whole.rays);
                CHECK(shared.undecided == whole.undecided);
                REQUIRE(shared.shares.size() == 2);
                CHECK(shared.shares[0].tiles + shared.shares[1].tiles == shared.tiles);
                CHECK(shared.shares[0].rays + shared.shares[1].rays == shared.rays);
                CHECK(shared.shares[1].device.number() == two_devices[1].number());
            }
    }
}

TEST_CASE("team: each part of a device has tiles to make", "[team]") {
    const std::vector<DeviceInfo> parts = halves();
    if (parts.empty()) return;  // no device here can be cut
    Renderer both(parts);
    Scene scene = lit(600);
    scene.image = {1000, 800};
    RenderOptions options;
    options.tile = 1 << 12;
    Film film;
    both.render(scene, options, film);  // builds the kernels
    const RenderStats stats = both.render(scene, options, film);
    for (const DeviceShare& share : stats.shares) CHECK(share.tiles > 0);
}

TEST_CASE("team: where the spheres go through the devices in chunks the bits stay the same", "[team]") {
    for (const std::vector<DeviceInfo>& two_devices : teams()) {
        Renderer both(two_devices), alone(two_devices.front());
        const Scene scene = lit(20'000);
        RenderOptions options;
        options.tile = 1 << 12;
        Film whole, cut;
        alone.render(scene, options, whole);
        options.memory = uint64_t{1} << 20;
        CHECK(both.render(scene, options, cut).chunks > 1);
        CHECK(same_bits(whole, cut));
    }
}

TEST_CASE("team: all cores of a device are one, but each has tiles of its own", "[team][device]") {
    const std::vector<DeviceInfo> all = list_devices();
    CHECK(with_cores_joined(all).size() == all.size());
    for (const DeviceInfo& device : all) {
        if (device.sub_devices == 0) continue;
        const std::vector<DeviceInfo> cores =
            choose_devices(all, {device.number() + "/" + std::to_string(device.sub_devices)});
        const std::vector<DeviceInfo> joined = with_cores_joined(cores);
        REQUIRE(joined.size() == 1);
        CHECK((joined[0].number() == device.number() && joined[0].cores_apart));
        CHECK(joined[0].global_bytes == device.global_bytes);
        const std::vector<DeviceInfo> most(cores.begin() + 1, cores.end());
        CHECK(with_cores_joined(most).size() == most.size());
        // One tile is all cores' work.
        Scene scene = lit(60);
        scene.image = {16, 16};
        Film film;
        const std::vector<DeviceShare> shares = Renderer(cores).render(scene, {}, film).shares;
        CHECK((shares.size() == 1 && shares[0].device.number() == device.number()));
    }
}

TEST_CASE("team: tiles for several workers cover the image, fit, and become smaller", "[team][tiling]") {
    std::vector<DeviceInfo> devices = list_devices();
    const DeviceInfo device = devices.front();
    DeviceInfo twin = device;  // as if there were another of its kind; plans alone are made here
    const Scene scene = lit(60);
    const Team team({device, twin});
    const std::vector<Plan> plans = team.make_plans(scene, survey(scene), {});
    REQUIRE(plans.size() == 2);
    int64_t blocks = 0;
    for (size_t i = 0; i < plans[0].tiles.size(); ++i) {
        const Tile &a = plans[0].tiles[i], &b = plans[1].tiles[i];
        CHECK((a.x == b.x && a.y == b.y && a.blocks == b.blocks && a.blocks_x == b.blocks_x));
        CHECK(a.blocks <= plans[0].tile_blocks);
        blocks += a.blocks;
    }
    CHECK(plans[0].tiles.size() == plans[1].tiles.size());
    CHECK(blocks == (500 + 7) / 8 * ((300 + 7) / 8));
    CHECK(plans[0].tiles.back().blocks <= plans[0].tiles.front().blocks);
}

TEST_CASE("team: requests name several devices, and each is there once", "[team][device]") {
    const std::vector<DeviceInfo> all = list_devices();
    CHECK(choose_devices(all, {}).size() == 1);
    CHECK(choose_devices(all, {"all"}).size() == all.size());
    const std::string first = all.front().number();
    CHECK(choose_devices(all, {first + "/1"}).front().number() == first);
    const auto refusal = [&](const std::vector<std::string>& requests) {
        try {
            choose_devices(all, requests);
        } catch (const Error& error) {
            CHECK(error.exit_code() == 2);
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(contains(refusal({first, first}), "device " + first + " is asked for twice"));
    CHECK(contains(refusal({first, "all"}), "asked for twice"));
    CHECK(contains(refusal({first + "/0"}), "expected a number of parts"));
    CHECK(contains(refusal({first + "/x"}), "expected a number of parts"));
    CHECK(contains(refusal({first + "/99999"}), "cannot be cut"));
    const std::vector<DeviceInfo> parts = halves();
    if (parts.empty()) return;
    const std::string whole = whole_of(parts[0]).number();
    CHECK(parts[1].number() == whole + "/2.1");
    CHECK(parts[0].compute_units == parts[1].compute_units);
    CHECK(contains(refusal({whole, whole + "/2"}), "asked for twice"));
}

TEST_CASE("team: the program says who did what, and an error which device it is of", "[team][cli]") {
    const std::vector<DeviceInfo> parts = halves();
    if (parts.empty()) return;  // no device here can be cut
    const std::string whole = whole_of(parts[0]).number();
    const TempFolder folder;
    const std::string one = folder / "one.png", two = folder / "two.png", json = folder / "stats.json";
    REQUIRE(render_small("--device " + whole + " -o " + quoted(one)).code == 0);
    const Ran ran = render_small("--tile 128 --device " + whole + "/2 -o " + quoted(two) + " --stats " + quoted(json));
    CHECK(ran.code == 0);
    CHECK(contains(ran.out, whole + "/2.0: "));
    CHECK(contains(ran.out, whole + "/2.1: "));
    CHECK(contains(read_file(json), "\"number\": \"" + whole + "/2.1\""));
    const Ran twice = render_small("--device " + whole + " --device " + whole);
    CHECK(twice.code == 2);
    CHECK(contains(twice.err, "asked for twice"));
    Renderer both(parts);
    Scene scene = lit(600);
    RenderOptions tight;
    tight.memory = 1 << 10;
    Film film;
    CHECK_THROWS_AS(both.render(scene, tight, film), Error);
}
