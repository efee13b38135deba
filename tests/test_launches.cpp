// Pictures whose launches are cut into as many parts as can be.
#include "catch.h"
#include "crowds.h"
#include "render.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Few spheres, whose tiles cores share where there are several, or a hierarchy.
Scene crowd(int count, int width, int height) {
    Scene scene = scene_of(Crowd::strewn, count);
    scene.image = {width, height};
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60};
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, PointLight{{20, 40, -90}, {9e4, 9e4, 9e4}}};
    return scene;
}

int launches_of(const RenderStats& stats, const std::string& kernel) {
    int launches = 0;
    for (const KernelStats& k : stats.kernels)
        if (k.kernel == kernel) launches += k.launches;
    return launches;
}

/// The same with launches that may take no time at all: each has as few work-items as can be.
void check_in_parts(Renderer& renderer, const Scene& scene, RenderOptions options) {
    options.outputs = {true, true, true, true};
    Film whole, parts;
    renderer.render(scene, options, whole);
    const RenderStats once = renderer.render(scene, options, whole);
    options.longest_launch = 1e-12;
    const RenderStats often = renderer.render(scene, options, parts);
    CHECK(launches_of(often, "intersect_closest") > launches_of(once, "intersect_closest"));
    CHECK(launches_of(often, "shade_light") > launches_of(once, "shade_light"));
    CHECK(often.hits == once.hits);
    CHECK(often.undecided == once.undecided);
    CHECK(same_bits(whole, parts));
}

}  // namespace

TEST_CASE("launches: pictures in many small parts have the same bits, in every accuracy", "[launches]") {
    for (const DeviceInfo& device : list_devices()) {
        INFO(device.name);
        Renderer renderer(device);
        for (const Accuracy accuracy : available_accuracies(device))
            for (const int spheres : {60, 600}) {
                INFO(to_string(accuracy) << ", " << spheres << " spheres");
                RenderOptions options;
                options.accuracy = accuracy;
                check_in_parts(renderer, crowd(spheres, 500, 300), options);
            }
    }
}

TEST_CASE("launches: where the scene is cut, and where tiles are small, parts have the same bits", "[launches]") {
    for (const DeviceInfo& device : list_devices()) {
        INFO(device.name);
        Renderer renderer(device);
        RenderOptions small;
        small.tile = 1 << 14;
        check_in_parts(renderer, crowd(60, 500, 300), small);
        RenderOptions cut;
        cut.memory = uint64_t{1} << 20;
        cut.tile = 1 << 12;
        const Scene many = crowd(20'000, 200, 120);
        Film film;
        REQUIRE(renderer.render(many, cut, film).chunks > 1);
        check_in_parts(renderer, many, cut);
    }
}

TEST_CASE("launches: the longest is among those of the kernels", "[launches]") {
    Renderer renderer(choose_device(list_devices(), ""));
    Film film;
    const RenderStats stats = renderer.render(crowd(60, 200, 120), {}, film);
    double longest = 0;
    for (const KernelStats& kernel : stats.kernels) {
        CHECK(kernel.longest <= kernel.seconds);
        CHECK(kernel.longest * kernel.launches >= kernel.seconds * (1 - 1e-9));
        longest = std::max(longest, kernel.longest);
    }
    CHECK(stats.longest_launch == longest);
    CHECK(longest > 0);
}
