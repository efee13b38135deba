// What a light reaches: one receiver that faces it, and what may or may not stand in between.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const double pi = std::acos(-1.0);

/// The centre pixel sees (0, 0, 8) of a sphere of radius 2, with the normal (0, 0, -1).
Scene receiver(const Light& light) {
    Scene scene = looking_ahead(9, 9);
    scene.spheres = {{{0, 0, 10}, 2, {0.5, 0.25, 0.125}}};
    scene.lights = {light};
    return scene;
}

void check_radiance(const Film& film, size_t p, Rgb expected) {
    // Exact but for four roundings: albedo, phi and two products.
    CHECK(std::fabs(film.radiance[0][p] - expected.r) <= 4 * u * expected.r);
    CHECK(std::fabs(film.radiance[1][p] - expected.g) <= 4 * u * expected.g);
    CHECK(std::fabs(film.radiance[2][p] - expected.b) <= 4 * u * expected.b);
}

/// A sphere beside the receiver, and whether it stands between the receiver's centre pixel and the lights.
struct Occluder {
    const char* what;
    Sphere sphere;
    bool sun, lamp;  // in shadow of the sun / of the lamp
};

// The sun shines along (1, 0, -1), the lamp from (3, 0, 5), in the same direction from (0, 0, 8).
const DirectionalLight sun{{1, 0, -1}, {2, 3, 4}};
const PointLight lamp{{3, 0, 5}, {100, 200, 300}};
const double far = 1000 / std::sqrt(2.0);
const Occluder occluders[] = {
    {"before the lamp", {{1.5, 0, 6.5}, 0.5, {1, 1, 1}}, true, true},
    {"before the lamp, looks large from there", {{2, 0, 6}, 1.2, {1, 1, 1}}, true, true},
    {"around the lamp", {{3, 0, 5}, 1, {1, 1, 1}}, true, true},
    {"beyond the lamp", {{6, 0, 2}, 0.5, {1, 1, 1}}, true, false},
    {"beyond the lamp, looks large", {{far, 0, 8 - far}, 990, {1, 1, 1}}, true, false},
    {"behind the receiver", {{-3, 0, 11}, 0.5, {1, 1, 1}}, false, false},
    {"behind the receiver, looks large", {{-far, 0, 8 + far}, 990, {1, 1, 1}}, false, false},
    {"beside the way", {{1.5, 3, 6.5}, 0.5, {1, 1, 1}}, false, false},
};

}  // namespace

TEST_CASE("a facing surface reflects albedo E / pi, or albedo P / (4 pi^2 d^2)", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        Film film = render(renderer, receiver(DirectionalLight{{0, 0, -3}, {2, 4, 8}}));
        check_radiance(film, centre(film), {1 / pi, 1 / pi, 1 / pi});
        film = render(renderer, receiver(PointLight{{0, 0, 4}, {32, 64, 128}}));
        check_radiance(film, centre(film), {1 / (4 * pi * pi), 1 / (4 * pi * pi), 1 / (4 * pi * pi)});
        film = render(renderer, receiver(PointLight{{0, 0, 0}, {128, 256, 512}}));  // in the eye
        check_radiance(film, centre(film), {1 / (4 * pi * pi), 1 / (4 * pi * pi), 1 / (4 * pi * pi)});
    });
}

TEST_CASE("lights add up", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = receiver(DirectionalLight{{0, 0, -1}, {2, 4, 8}});
        scene.lights.push_back(DirectionalLight{{0, 0, -1}, {2, 4, 8}});
        scene.lights.push_back(DirectionalLight{{0, 0, 1}, {2, 4, 8}});
        const Film film = render(renderer, scene);
        check_radiance(film, centre(film), {2 / pi, 2 / pi, 2 / pi});  // doubling is exact
    });
}

TEST_CASE("light from below the horizon or along it gives exactly 0", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        // Of a sphere straight ahead, all that is seen faces backward.
        CHECK(black(render(renderer, receiver(DirectionalLight{{0, 0, 1}, {2, 3, 4}}))));
        CHECK(black(render(renderer, receiver(PointLight{{0, 0, 50}, {2, 3, 4}}))));
        const Film grazed = render(renderer, receiver(DirectionalLight{{1, 0, 0}, {2, 3, 4}}));
        CHECK(grazed.radiance[0][centre(grazed)] == 0);
        const Film level = render(renderer, receiver(PointLight{{4, 0, 8}, {2, 3, 4}}));
        CHECK(level.radiance[0][centre(level)] == 0);
    });
}

TEST_CASE("what stands between receiver and light shadows, what does not does not", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        const float from_sun = [&] {
            const Film film = render(renderer, receiver(sun));
            return film.radiance[0][centre(film)];
        }();
        const float from_lamp = [&] {
            const Film film = render(renderer, receiver(lamp));
            return film.radiance[0][centre(film)];
        }();
        REQUIRE(from_sun > 0);
        REQUIRE(from_lamp > 0);
        for (const Occluder& occluder : occluders) {
            INFO(occluder.what);
            Scene scene = receiver(sun);
            scene.spheres.push_back(occluder.sphere);
            Film film = render(renderer, scene);
            CHECK(film.id[centre(film)] == 0);
            CHECK(film.radiance[0][centre(film)] == (occluder.sun ? 0 : from_sun));
            scene.lights = {lamp};
            film = render(renderer, scene);
            CHECK(film.radiance[0][centre(film)] == (occluder.lamp ? 0 : from_lamp));
            RenderOptions options = all_outputs();
            options.shadows = false;
            film = render(renderer, scene, options);
            CHECK(film.radiance[0][centre(film)] == from_lamp);
        }
    });
}

TEST_CASE("a receiver inside another sphere is in shadow for lights outside", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = receiver(DirectionalLight{{1, 0, -1}, {2, 3, 4}});
        scene.spheres.push_back({{0, 0, 4}, 6, {1, 1, 1}});  // around the eye and (0, 0, 8)
        Film film = render(renderer, scene);
        CHECK(film.id[centre(film)] == 0);
        CHECK(film.radiance[0][centre(film)] == 0);
        scene.lights = {PointLight{{0, 0, -4}, {32, 64, 128}}};
        film = render(renderer, scene);
        CHECK(film.radiance[0][centre(film)] == 0);
        scene.lights = {PointLight{{0, 0, 4}, {32, 64, 128}}};  // inside too
        film = render(renderer, scene);
        check_radiance(film, centre(film), {1 / (4 * pi * pi), 1 / (4 * pi * pi), 1 / (4 * pi * pi)});
        // The centre behind the receiver; the lamps see the sphere large and small.
        scene.spheres[1] = {{-3, 0, 9}, 10, {1, 1, 1}};
        for (const Light& light :
             {Light{sun}, Light{PointLight{{6, 0, 2}, {1, 1, 1}}}, Light{PointLight{{40, 0, -32}, {1, 1, 1}}}}) {
            scene.lights = {light};
            film = render(renderer, scene);
            CHECK(film.id[centre(film)] == 0);
            CHECK(film.radiance[0][centre(film)] == 0);
        }
    });
}

TEST_CASE("a point light inside a sphere lights nothing outside", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        for (const Vec3& place : {Vec3{0, 0, 10}, Vec3{0.5, 0, 9}, Vec3{0, 1.75, 10}}) {
            Scene scene = receiver(PointLight{place, {1e6, 1e6, 1e6}});
            scene.spheres.push_back({{5, 0, 10}, 2, {1, 1, 1}});
            scene.spheres.push_back({{0, -50, 10}, 46, {1, 1, 1}});
            const Film film = render(renderer, scene);
            CHECK(std::count(film.id.begin(), film.id.end(), 1) > 0);
            CHECK(std::count(film.id.begin(), film.id.end(), 2) > 0);
            CHECK(black(film));
        }
        Scene around = looking_ahead(9, 9);  // eye and light inside: the outer side of the far wall faces away
        around.spheres = {{{0, 0, 1}, 3, {1, 1, 1}}};
        around.lights = {PointLight{{0, 0, 0}, {1e6, 1e6, 1e6}}, PointLight{{0, 0.5, 1}, {1e6, 1e6, 1e6}}};
        CHECK(black(render(renderer, around)));
    });
}

TEST_CASE("a point light on a surface lights what lies outside, not its own sphere, and gives no NaN", "[shadows]") {
    on_every_device([](Renderer& renderer) {
        CHECK(black(render(renderer, receiver(PointLight{{0, 0, 8}, {1e6, 1e6, 1e6}}))));  // at distance 0 of a hit
        Scene scene = looking_ahead(33, 33);
        scene.lights = {PointLight{{0, 2, 10}, {100, 100, 100}}};
        scene.spheres = {{{0, 8, 10}, 4, {1, 1, 1}}, {{0, -8, 10}, 4, {1, 1, 1}}};  // above the light, and below
        const Film alone = render(renderer, scene);
        scene.spheres.push_back({{0, 0, 10}, 2, {1, 1, 1}});  // the light is its highest point
        const Film film = render(renderer, scene);
        float above = 0;
        for (size_t p = 0; p < film.pixels(); ++p) {
            CHECK(film.radiance[0][p] == (film.id[p] == 0 ? alone.radiance[0][p] : 0));
            if (film.id[p] == 0) above = std::max(above, film.radiance[0][p]);
        }
        CHECK(above > 0);
        const float below = *std::max_element(alone.radiance[0].end() - 33 * 16, alone.radiance[0].end());
        CHECK(below > 0);  // without the sphere the lower one is lit
    });
}
