// Only the work that a scene and the wanted outputs need, and the right planes all the same.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

template <class T>
bool all(const Plane<T>& plane, T value) {
    return !plane.empty() && std::all_of(plane.begin(), plane.end(), [=](T v) { return v == value; });
}

void check_all_miss(const Film& film) {
    CHECK(black(film));
    CHECK(all(film.distance, INFINITY));
    for (const auto& plane : film.normal) CHECK(all(plane, INFINITY));
    CHECK(all(film.id, -1));
}

/// By the kernel made for it, or by the one that shades.
bool traced_shadows(const RenderStats& stats) {
    return ran(stats, "intersect_shadow") || built_with(stats, "SHADOWS_TRACED");
}

}  // namespace

TEST_CASE("a film is used again, and nothing stays in it", "[outputs]") {
    on_every_device([](Renderer& renderer) {
        Film film;
        Scene scene = mixed(40, 30);
        const RenderOptions options = all_outputs();
        renderer.render(scene, options, film);
        const float* memory = film.distance.data();
        CHECK_FALSE(black(film));
        scene.lights.clear();
        renderer.render(scene, options, film);
        CHECK(film.distance.data() == memory);
        CHECK(black(film));
        scene.spheres.clear();
        renderer.render(scene, options, film);
        CHECK(film.distance.data() == memory);
        check_all_miss(film);
        scene = mixed(20, 10);
        renderer.render(scene, options, film);
        CHECK(film.width == 20);
        CHECK(film.distance.size() == 200);
        CHECK(same_bits(film, render(renderer, scene)));
    });
}

TEST_CASE("without spheres nothing runs and all is missed", "[outputs]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = mixed(13, 9);
        scene.spheres.clear();
        Film film;
        const RenderStats stats = renderer.render(scene, all_outputs(), film);
        CHECK(stats.kernels.empty());
        CHECK(stats.hits == 0);
        CHECK(film.id.size() == 13 * 9);
        check_all_miss(film);
    });
}

TEST_CASE("without lights all is black and no light kernel runs", "[outputs]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = mixed(13, 9);
        scene.lights.clear();
        Film film;
        RenderOptions options = all_outputs();
        const RenderStats stats = renderer.render(scene, options, film);
        CHECK(black(film));
        CHECK(film.radiance[2].size() == 13 * 9);
        CHECK(stats.hits > 0);
        CHECK(same_bits(film.id, render(renderer, mixed(13, 9)).id));
        CHECK(ran(stats, "intersect_closest"));
        CHECK_FALSE(traced_shadows(stats));
        CHECK_FALSE(ran(stats, "shade_light"));
        options.outputs = {true, false, false, false};
        CHECK(renderer.render(scene, options, film).kernels.empty());
        CHECK(black(film));
        CHECK(film.radiance[0].size() == 13 * 9);
    });
}

TEST_CASE("only the kernels that a scene needs are built", "[outputs]") {
    on_every_device([](Renderer& renderer) {
        Film film;
        RenderOptions options = all_outputs();
        Scene suns = example("directional.json"), lamps = example("point.json");
        suns.image = lamps.image = {16, 16};
        RenderStats stats = renderer.render(suns, options, film);
        CHECK(traced_shadows(stats));
        CHECK(built_with(stats, "LIGHT_DIRECTIONAL"));
        CHECK_FALSE(built_with(stats, "LIGHT_POINT"));
        stats = renderer.render(lamps, options, film);
        CHECK(built_with(stats, "LIGHT_POINT"));
        CHECK_FALSE(built_with(stats, "LIGHT_DIRECTIONAL"));
        options.shadows = false;
        stats = renderer.render(mixed(16, 16), options, film);
        CHECK(ran(stats, "shade_light"));
        CHECK(built_with(stats, "LIGHT_POINT"));
        CHECK_FALSE(traced_shadows(stats));
        CHECK(std::all_of(stats.kernels.begin(), stats.kernels.end(), [](const auto& k) { return k.launches > 0; }));
    });
}

TEST_CASE("an output that is not asked for is neither computed nor stored", "[outputs]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = mixed(123, 77);
        const Film whole = render(renderer, scene);
        for (int wanted = 0; wanted < 4; ++wanted) {
            RenderOptions options;
            options.outputs = {wanted == 0, wanted == 1, wanted == 2, wanted == 3};
            Film film;
            const RenderStats stats = renderer.render(scene, options, film);
            INFO("output " << wanted);
            CHECK(ran(stats, "shade_light") == (wanted == 0));
            CHECK(traced_shadows(stats) == (wanted == 0));
            CHECK(film.distance.size() == (wanted == 1 ? film.pixels() : 0));
            CHECK(film.id.size() == (wanted == 3 ? film.pixels() : 0));
            for (const auto& plane : film.radiance) CHECK(plane.size() == (wanted == 0 ? film.pixels() : 0));
            for (const auto& plane : film.normal) CHECK(plane.size() == (wanted == 2 ? film.pixels() : 0));
            const auto& found = wanted == 0 ? film.radiance[1] : wanted == 1 ? film.distance : film.normal[1];
            const auto& expected = wanted == 0 ? whole.radiance[1] : wanted == 1 ? whole.distance : whole.normal[1];
            CHECK((wanted == 3 ? same_bits(film.id, whole.id) : same_bits(found, expected)));
        }
        RenderOptions nothing;
        nothing.outputs = {false, false, false, false};
        Film film;
        CHECK(renderer.render(scene, nothing, film).kernels.empty());
    });
}
