// Certified pictures against the exact oracle: no decision is wrong, and the pixels that are left open are few.
#include "catch.h"
#include "crowds.h"
#include "oracle.h"
#include "render.h"
#include "scene_io.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

struct Wrong {
    int64_t pixels = 0, ids = 0, shadows = 0;
};

/// One light at a time, so that each shadow shows: a certified radiance is 0 where nothing of the light arrives, and
/// above 0 where something does, as long as float can hold it.
void compare(const Scene& scene, const Film& film, Wrong& wrong, int step) {
    const oracle::Oracle truth(scene);
    for (size_t p = 0; p < film.pixels(); p += static_cast<size_t>(step)) {
        const int i = static_cast<int>(p) % film.width, j = static_cast<int>(p) / film.width;
        const oracle::Pixel pixel = truth.look(i, j);
        ++wrong.pixels;
        wrong.ids += film.id[p] != pixel.hit.id;
        const bool lit = film.radiance[0][p] > 0 || film.radiance[1][p] > 0 || film.radiance[2][p] > 0;
        wrong.shadows += lit != pixel.lit.at(0);
    }
}

RenderStats render_all(Renderer& renderer, const Scene& scene, Accuracy accuracy, Film& film, int lanes = 0) {
    RenderOptions options;
    options.outputs = {true, true, true, true};
    options.accuracy = accuracy;
    options.lanes = lanes;
    return renderer.render(scene, options, film);
}
RenderStats render_certified(Renderer& renderer, const Scene& scene, Film& film, int lanes = 0) {
    return render_all(renderer, scene, Accuracy::certified, film, lanes);
}

bool differ(const Film& a, const Film& b, size_t p) {
    bool same = a.id[p] == b.id[p] && a.distance[p] == b.distance[p];
    for (size_t c = 0; c < 3; ++c)
        same = same && a.normal[c][p] == b.normal[c][p] && a.radiance[c][p] == b.radiance[c][p];
    return !same;
}

/// All lights of a scene in turn.
Wrong certified_wrong(Renderer& renderer, Scene scene, int step) {
    Wrong wrong;
    const std::vector<Light> lights = scene.lights;
    for (const Light& light : lights) {
        scene.lights = {light};
        Film film;
        render_certified(renderer, scene, film);
        compare(scene, film, wrong, step);
    }
    return wrong;
}

/// Random spheres, some nested, some touching, some of equal size side by side.
Scene tangle(uint64_t seed) {
    Random random(seed);
    Scene scene;
    scene.image = {64, 48};
    scene.camera = {{0, 2, -9}, {0, 1, 0}, {0, 1, 0}, 50};
    scene.spheres.push_back({{0, -1000, 0}, 1000, {0.5, 0.5, 0.5}});
    for (int i = 0; i < 12; ++i) {
        const double r = random.uniform(0.2, 1.2);
        scene.spheres.push_back({{random.uniform(-4, 4), r, random.uniform(-3, 3)}, r, {0.6, 0.5, 0.4}});
    }
    for (int i = 0; i < 4; ++i) {
        const Sphere s = scene.spheres[static_cast<size_t>(1 + i)];
        scene.spheres.push_back({s.center + Vec3{2 * s.radius, 0, 0}, s.radius, {0.2, 0.9, 0.3}});  // touches it
        scene.spheres.push_back({s.center, s.radius * (1 - 1e-7), {0.9, 0.9, 0.3}});
    }
    scene.lights = {DirectionalLight{{1, 2, -1.5}, {1, 1, 1}}, PointLight{{-3, 6, -4}, {300, 300, 300}}};
    return scene;
}

/// A crowd's picture.
Scene lit(Scene scene) {
    scene.image = {64, 48};
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 50};
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 1, 1}}, PointLight{{20, 40, -10}, {9e4, 9e4, 9e4}}};
    return scene;
}

}  // namespace

TEST_CASE("certified: no decision is wrong where spheres touch, nest and stand on a ground", "[certified]") {
    for (const DeviceInfo& device : list_devices()) {
        INFO(device.name);
        Renderer renderer(device);
        for (uint64_t seed = 1; seed <= 4; ++seed) {
            const Wrong wrong = certified_wrong(renderer, tangle(seed), 1);
            INFO("seed " << seed);
            CHECK(wrong.pixels == 2 * 64 * 48);
            CHECK(wrong.ids == 0);
            CHECK(wrong.shadows == 0);
        }
    }
}

TEST_CASE("certified: no decision is wrong in crowds", "[certified]") {
    for (const DeviceInfo& device : list_devices()) {
        INFO(device.name);
        Renderer renderer(device);
        for (const Crowd crowd : crowds) {
            INFO(to_string(crowd));
            const Wrong wrong = certified_wrong(renderer, lit(scene_of(crowd, 900)), 5);
            CHECK(wrong.ids == 0);
            CHECK(wrong.shadows == 0);
        }
    }
}

TEST_CASE("certified: the examples, and few of their pixels are left open by float", "[certified]") {
    Renderer renderer(choose_device(list_devices(), ""));
    for (const char* name : {"directional", "point"}) {
        INFO(name);
        Scene scene = load_scene(std::string(GNOMON_SOURCE_DIR "/examples/") + name + ".json").scene;
        Film film;
        const RenderStats stats = render_certified(renderer, scene, film);
        CHECK(stats.undecided > 0);  // or nothing was certified
        CHECK(stats.undecided < stats.pixels / 500);
        CHECK(stats.decided_exactly <= stats.undecided);
        const Wrong wrong = certified_wrong(renderer, scene, 97);
        CHECK(wrong.ids == 0);
        CHECK(wrong.shadows == 0);
    }
}

TEST_CASE("certified: what float settles is what strict has, to the bit", "[certified]") {
    Renderer renderer(choose_device(list_devices(), ""));
    std::vector<Scene> scenes{tangle(7), lit(scene_of(Crowd::strewn, 900)), lit(scene_of(Crowd::ground, 40))};
    for (const char* name : {"directional", "point"})
        scenes.push_back(load_scene(std::string(GNOMON_SOURCE_DIR "/examples/") + name + ".json").scene);
    for (const Scene& scene : scenes) {
        INFO(scene.spheres.size() << " spheres, " << scene.image.width << " pixels wide");
        Film film, strict;
        const RenderStats stats = render_certified(renderer, scene, film);
        render_all(renderer, scene, Accuracy::strict, strict);
        int64_t different = 0;
        for (size_t p = 0; p < film.pixels(); ++p) different += differ(film, strict, p);
        CHECK(different > 0);  // doubles round otherwise
        CHECK(different <= stats.undecided);
    }
}

TEST_CASE("certified: the same bits for every vector width", "[certified]") {
    Renderer renderer(choose_device(list_devices(), ""));
    std::vector<Scene> scenes{tangle(7), tangle(8)};
    for (const Crowd crowd : {Crowd::strewn, Crowd::sizes, Crowd::diagonal, Crowd::ground})
        for (const int count : {40, 200, 900}) scenes.push_back(lit(scene_of(crowd, count)));
    for (const Scene& scene : scenes) {
        Film film;
        const RenderStats stats = render_certified(renderer, scene, film);
        for (const int lanes : {1, 4, 8, 16}) {
            INFO(scene.spheres.size() << " spheres, " << lanes << " lanes");
            Film other;
            CHECK(render_certified(renderer, scene, other, lanes).undecided == stats.undecided);
            CHECK(same_bits(film, other));
        }
    }
}
