// The same bits whatever the tiles, lanes, device and place.
#include <algorithm>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const ImageSize sizes[] = {{1, 1}, {7, 5}, {123, 77}, {5000, 1}, {1, 3000}};

/// The scene moved as a whole. Its coordinates and the way are such that double sums are exact.
Scene moved(Scene scene, const Vec3& way) {
    scene.camera.eye = scene.camera.eye + way;
    scene.camera.at = scene.camera.at + way;
    for (Sphere& sphere : scene.spheres) sphere.center = sphere.center + way;
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) point->position = point->position + way;
    return scene;
}

/// The scene in another unit of length, a power of two: the same picture, but for its distances.
Scene scaled(Scene scene, double factor) {
    scene.camera.eye = scene.camera.eye * factor;
    scene.camera.at = scene.camera.at * factor;
    for (Sphere& sphere : scene.spheres) {
        sphere.center = sphere.center * factor;
        sphere.radius *= factor;
    }
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) {
            point->position = point->position * factor;
            Rgb& power = point->power;
            power = {power.r * factor * factor, power.g * factor * factor, power.b * factor * factor};
        }
    return scene;
}

/// The device as if its driver described it otherwise.
std::vector<DeviceInfo> otherwise(const DeviceInfo& device) {
    std::vector<DeviceInfo> result(6, device);
    result[0].shares_memory = false;      // planes are read back
    result[1].out_of_order = false;       // one launch after the other
    result[2].correctly_rounded = false;  // divide and sqrt are corrected
    result[3].type = device.type == DeviceType::cpu ? DeviceType::gpu : DeviceType::cpu;  // other lanes and groups
    result[3].sub_devices = 0;
    result[4].max_work_group = 1;
    result[5].sub_devices = 0;  // all cores share each tile
    return result;
}

}  // namespace

TEST_CASE("the bits depend neither on tiles nor on lanes", "[determinism]") {
    on_every_device([](Renderer& renderer) {
        for (const ImageSize& size : sizes) {
            const Scene scene = mixed(size.width, size.height);
            const Film first = render(renderer, scene);
            CHECK(same_bits(render(renderer, scene), first));
            for (const int lanes : {1, 4, 8, 16})
                for (const int tile : {64, 1000, 65536, 1 << 20}) {
                    RenderOptions options = all_outputs();
                    options.lanes = lanes;
                    options.tile = tile;
                    INFO(size.width << "x" << size.height << ", lanes " << lanes << ", tile " << tile);
                    CHECK(same_bits(render(renderer, scene, options), first));
                }
        }
        // So that equal bits mean something: the largest of these pictures shows all there is.
        const Film film = render(renderer, mixed(123, 77));
        for (const int id : {-1, 0, 1, 2, 3, 5}) CHECK(std::count(film.id.begin(), film.id.end(), id) > 0);
        CHECK(std::count(film.id.begin(), film.id.end(), 4) == 0);  // coincides with 0
        CHECK_FALSE(black(film));
    });
}

TEST_CASE("the bits do not depend on what a device can do", "[determinism]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            Renderer plain(device);
            const std::vector<DeviceInfo> others = otherwise(device);
            for (size_t i = 0; i < others.size(); ++i) {
                Renderer renderer(others[i]);
                for (const ImageSize& size : sizes) {
                    INFO(size.width << "x" << size.height << ", case " << i);
                    RenderOptions options = all_outputs();
                    const Film film = render(plain, mixed(size.width, size.height), options);
                    CHECK(same_bits(render(renderer, mixed(size.width, size.height), options), film));
                    options.tile = 64;
                    CHECK(same_bits(render(renderer, mixed(size.width, size.height), options), film));
                }
            }
        }
}

TEST_CASE("all devices give the same bits", "[determinism]") {
    const std::vector<DeviceInfo> devices = list_devices();
    Renderer first(devices.front());
    const Film film = render(first, mixed(123, 77));
    for (const DeviceInfo& device : devices) {
        INFO(device.number() << " " << device.name);
        Renderer renderer(device);
        CHECK(same_bits(render(renderer, mixed(123, 77)), film));
    }
}

TEST_CASE("far from the origin a scene looks the same", "[determinism]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = mixed(123, 77);
        const Film film = render(renderer, scene);
        CHECK(same_bits(render(renderer, moved(scene, {0x1p20, -0x1p20, 0x1p19})), film));
    });
}

TEST_CASE("in metres or in parsecs a scene looks the same", "[determinism]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = mixed(123, 77);
        const Film film = render(renderer, scene);
        // 2^60 cubed is beyond float, 2^-60 cubed below it; distances stay within.
        for (const double factor : {0x1p-60, 0x1p-19, 0x1p-3, 0x1p30, 0x1p60}) {
            INFO("factor " << factor);
            Film other = render(renderer, scaled(scene, factor));
            for (float& distance : other.distance) distance = static_cast<float>(distance / factor);
            CHECK(same_bits(other, film));
        }
    });
}
