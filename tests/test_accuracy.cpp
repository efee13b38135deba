// --accuracy fast and double: whole pictures against the reference, and devices that have no double.
#include <cmath>

#include "catch.h"
#include "check.h"
#include "reference.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

RenderOptions with(Accuracy accuracy) {
    RenderOptions options = all_outputs();
    options.accuracy = accuracy;
    return options;
}

template <class Test>
void on_every_double_device(Test test) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            if (!device.fp64) continue;
            Renderer renderer(device);
            test(renderer);
        }
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{example("directional.json"), example("point.json"), mixed(201, 131),
                                        scattered(16, 90, 70), scattered(300, 90, 70)};
    return all;
}

bool is_miss(const Film& film, size_t p) {
    bool miss = film.id[p] == -1 && film.distance[p] == INFINITY;
    for (int c = 0; c < 3; ++c) miss = miss && film.normal[c][p] == INFINITY && film.radiance[c][p] == 0;
    return miss;
}

/// Pixels of a film of doubles that are not the reference's, rounded.
struct Wrong {
    int64_t ids = 0, misses = 0, distances = 0, normals = 0, radiances = 0;
};

/// `little` covers the reference and the kernels, both in double: 2^-53, amplified by at most (|f| / r)^2 < 10^5 in
/// these scenes, some dozen times: below 1e-9, and 2^-24 is 6e-8. In the radiance the albedo, which is a float, is
/// rounded before.
void compare(const Film& film, size_t p, const reference::Hit& hit, const Rgb& radiance, double brightest,
             Wrong& wrong) {
    constexpr double little = 1e-9;
    const double normal[] = {hit.normal.x, hit.normal.y, hit.normal.z}, light[] = {radiance.r, radiance.g, radiance.b};
    wrong.distances += !(std::fabs(film.distance[p] - hit.t) <= (u + little) * hit.t);
    bool normal_is_off = false, radiance_is_off = false;
    for (int c = 0; c < 3; ++c) {
        normal_is_off |= !(std::fabs(film.normal[c][p] - normal[c]) <= u * std::fabs(normal[c]) + little);
        radiance_is_off |= !(std::fabs(film.radiance[c][p] - light[c]) <= 2 * u * light[c] + little * brightest);
    }
    wrong.normals += normal_is_off;
    wrong.radiances += radiance_is_off;
}

Wrong compare(const Film& film, const Scene& scene) {
    double brightest = 0;
    for (const auto& plane : film.radiance)
        brightest = std::max(brightest, static_cast<double>(*std::max_element(plane.begin(), plane.end())));
    Wrong wrong;
    for (int j = 0; j < film.height; ++j)
        for (int i = 0; i < film.width; ++i) {
            const size_t p = pixel(film, i, j);
            const reference::Hit hit = reference::closest_hit(scene, reference::eye_ray(scene, i, j));
            wrong.ids += film.id[p] != hit.id;
            if (hit.id < 0)
                wrong.misses += !is_miss(film, p);
            else
                compare(film, p, hit, reference::radiance(scene, hit, true), brightest, wrong);
        }
    return wrong;
}

}  // namespace

TEST_CASE("accuracy: pictures in double are the reference's, rounded", "[accuracy][double]") {
    on_every_double_device([](Renderer& renderer) {
        for (const Scene& scene : scenes()) {
            INFO(scene.spheres.size() << " spheres, " << scene.image.width << "x" << scene.image.height);
            const Wrong wrong = compare(render(renderer, scene, with(Accuracy::full)), scene);
            CHECK(wrong.ids == 0);
            CHECK(wrong.misses == 0);
            CHECK(wrong.distances == 0);
            CHECK(wrong.normals == 0);
            CHECK(wrong.radiances == 0);
        }
    });
}

TEST_CASE("accuracy: in double the bits depend neither on tiles, lanes nor memory", "[accuracy][double]") {
    on_every_double_device([](Renderer& renderer) {
        for (const ImageSize& size : {ImageSize{7, 5}, {123, 77}}) {
            const Scene scene = mixed(size.width, size.height);
            const Film first = render(renderer, scene, with(Accuracy::full));
            CHECK_FALSE(same_bits(render(renderer, scene), first));
            for (const int lanes : {1, 4, 8, 16})
                for (const int tile : {64, 1000, 65536}) {
                    RenderOptions options = with(Accuracy::full);
                    options.lanes = lanes;
                    options.tile = tile;
                    INFO(size.width << "x" << size.height << ", lanes " << lanes << ", tile " << tile);
                    CHECK(same_bits(render(renderer, scene, options), first));
                }
        }
        Scene many = scattered(20000, 96, 64);
        const Film whole = render(renderer, many, with(Accuracy::full));
        RenderOptions options = with(Accuracy::full);
        options.memory = 1400 << 10;
        options.tile = 2048;
        Film film;
        const RenderStats stats = renderer.render(many, options, film);
        CHECK(stats.chunks > 1);
        CHECK(stats.planned_bytes <= static_cast<int64_t>(options.memory));
        CHECK(stats.peak_bytes <= stats.planned_bytes);
        CHECK(stats.peak_bytes > stats.planned_bytes / 4);
        CHECK(same_bits(film, whole));
    });
}

TEST_CASE("accuracy: devices that seem otherwise give the same bits in double", "[accuracy][double]") {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            if (!device.fp64) continue;
            Renderer plain(device);
            const Scene scene = mixed(123, 77);
            const Film film = render(plain, scene, with(Accuracy::full));
            DeviceInfo apart = device, other = device, unrounded = device;
            apart.shares_memory = false;                                                      // planes are read back
            other.type = device.type == DeviceType::cpu ? DeviceType::gpu : DeviceType::cpu;  // other lanes, launches
            unrounded.correctly_rounded = false;
            for (const DeviceInfo& seeming : {apart, other, unrounded}) {
                Renderer renderer(seeming);
                CHECK(same_bits(render(renderer, scene, with(Accuracy::full)), film));
            }
        }
}

TEST_CASE("accuracy: what was planned for double is what it takes", "[accuracy][double][memory]") {
    on_every_double_device([](Renderer& renderer) {
        const Scene scene = scattered(3000, 300, 200);
        Film film;
        const RenderStats floats = renderer.render(scene, with(Accuracy::strict), film);
        const RenderStats doubles = renderer.render(scene, with(Accuracy::full), film);
        CHECK(doubles.accuracy == Accuracy::full);
        CHECK(doubles.planned_bytes > floats.planned_bytes);
        CHECK(doubles.peak_bytes <= doubles.planned_bytes);
        CHECK(doubles.peak_bytes > floats.planned_bytes);
    });
}

TEST_CASE("accuracy: fast pictures are close to the reference, and misses are infinite", "[accuracy][fast]") {
    on_every_device([](Renderer& renderer) {
        for (const Scene& scene : scenes()) {
            INFO(scene.spheres.size() << " spheres, " << scene.image.width << "x" << scene.image.height);
            const Film film = render(renderer, scene, with(Accuracy::fast));
            CHECK(film.pixels() == static_cast<size_t>(scene.image.width * scene.image.height));
            // Each operation rounds once or, of a quotient or root, by at most 3 ulp (OpenCL C 1.2, table 7.1): up to 6
            // times what strict loses, which is below 64 u / c for the distance (test_pictures.cpp). Where c, the
            // cosine between ray and normal, is not tiny, that is far below the 1e-3 from which Check counts a flip. At
            // edges, of spheres and of shadows, 400 u are less than 1/60 of a pixel's width, and fewer than 1/16 of the
            // pixels have an edge: about 1/1000 may be decided otherwise.
            const Check checked = check(scene, film, true, 1 << 14, int64_t{1} << 26);
            CHECK(checked.pixels > 5000);
            CHECK(checked.wrong_ids * 1000 <= checked.pixels);
            CHECK(checked.flips * 1000 <= checked.pixels);
            int64_t wrong = 0, misses = 0;
            for (size_t p = 0; p < film.pixels(); ++p) {
                misses += film.id[p] < 0;
                wrong += film.id[p] < 0 ? !is_miss(film, p) : !std::isfinite(film.distance[p]);
                for (int c = 0; c < 3; ++c) wrong += !std::isfinite(film.radiance[c][p]);
            }
            CHECK(misses > 0);
            CHECK(wrong == 0);
        }
        RenderOptions options = with(Accuracy::fast);
        Film film;
        CHECK(built_with(renderer.render(mixed(7, 5), options, film), "FAST=1"));
    });
}

TEST_CASE("accuracy: a device without double says what it has, and decides exactly instead", "[accuracy]") {
    DeviceInfo device = list_devices().front();
    device.fp64 = false;
    Renderer renderer(device);
    const Scene scene = mixed(7, 5);
    Film film;
    const std::string message = refusal(2, [&] { renderer.render(scene, with(Accuracy::full), film); });
    CHECK(contains(message, "cl_khr_fp64"));
    CHECK(contains(message, "strict"));
    CHECK(film.pixels() == 0);
    const RenderStats stats = renderer.render(scene, with(Accuracy::certified), film);
    CHECK(stats.decided_exactly == stats.undecided);
    CHECK_FALSE(built_with(renderer.render(scene, with(Accuracy::strict), film), "DOUBLE"));
    for (const char* name : {"certain", "full", "Strict", ""})
        CHECK(contains(refusal(2, [&] { parse_accuracy(name); }), "expected fast, strict, certified or double"));
    for (const Accuracy a : {Accuracy::fast, Accuracy::strict, Accuracy::full})
        CHECK(parse_accuracy(to_string(a)) == a);
}
