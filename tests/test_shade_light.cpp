// shade_light alone: which light it adds, and that it adds nothing else.
#include "shadow_bounds.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Balls of all colours before a large one, which their shadows fall upon.
Scene many_colours(Random& random, int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const Vec3 at{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(10, 20)};
        scene.spheres.push_back(
            {to_double(to_float(at)), 0.5, {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)}});
    }
    scene.spheres.push_back({{0, 0, 60}, 36, {0.75, 0.5, 0.25}});
    return scene;
}

const Light lights[] = {DirectionalLight{{1, 2, -3}, {1, 2, 3}}, PointLight{{-5, 6, 2}, {300, 200, 100}}};

/// Rays that scatter: most ids of a packet are different.
Receivers scattered_hits(Random& random, const Scene& scene, int blocks) {
    Receivers hits;
    for (int i = 0; i < blocks * BLOCK_RAYS; ++i)
        hits.see(scene, to_float(normalize({random.uniform(-1, 1), random.uniform(-1, 1), 1})));
    return hits;
}

std::vector<float> radiance_before(Random& random, size_t rays) {
    std::vector<float> values;
    for (size_t i = 0; i < 3 * rays; ++i) values.push_back(static_cast<float>(random.uniform(0, 2)));
    return values;
}

double channel(const Rgb& rgb, size_t c) { return c == 0 ? rgb.r : c == 1 ? rgb.g : rgb.b; }
double channel(const Float3& v, size_t c) { return channel(Rgb{to_double(v).x, to_double(v).y, to_double(v).z}, c); }

/// How many values are not: what was there, where nothing arrives (0 if this is the first light); else that (or 0) +
/// albedo phi arrival, with the float albedo and phi that the kernel has, to one rounding of the product and one of the
/// sum.
int wrong_sums(const Scene& scene, const Receivers& hits, const Float3& phi, const ShadeSetup& shading,
               const std::vector<float>& arrived, const std::vector<float>& after) {
    int wrong = 0;
    for (size_t i = 0; i < hits.size(); ++i)
        for (size_t c = 0; c < 3; ++c) {
            const float before = shading.first ? 0 : shading.radiance[place(i, c, 3)], now = after[place(i, c, 3)];
            if (!(arrived[i] > 0)) {
                wrong += bits(now) != bits(before);
                continue;
            }
            const Rgb& albedo = scene.spheres[static_cast<size_t>(hits.ids[i])].albedo;
            const auto rho = static_cast<double>(static_cast<float>(channel(albedo, c)));
            const double term = rho * channel(phi, c) * static_cast<double>(arrived[i]);
            const double sum = static_cast<double>(before) + term;
            wrong += !(std::fabs(static_cast<double>(now) - sum) <= 1.01 * u * (term + sum));
        }
    return wrong;
}

template <class Test>
void with_each_light(Test test) {
    on_every_bench([&](Bench& bench) {
        for (const Light& light : lights) {
            Random random(31);
            const Scene scene = many_colours(random, 300);
            const Receivers hits = scattered_hits(random, scene, 12);
            test(bench, scene, hits, set_up(bench, scene, light), light, random);
        }
    });
}

}  // namespace

TEST_CASE("shade_light: shadows read are those traced, bit for bit, and lights set, then add", "[shade_light]") {
    with_each_light([](Bench& bench, const Scene& scene, const Receivers& hits, const LightSetup& setup,
                       const Light& light, Random& random) {
        const std::vector<float> arrived = arrival(bench, scene, hits, light);
        for (const bool first : {true, false}) {
            ShadeSetup read{"SHADOWS_READ", arrived, radiance_before(random, hits.size()), first};
            ShadeSetup traced{"SHADOWS_TRACED", {}, read.radiance, first};
            const std::vector<float> one = shade(bench, widths[0], scene, hits, setup, read);
            CHECK(wrong_sums(scene, hits, setup.phi, read, arrived, one) == 0);
            for (const Width& w : widths) {
                INFO(w);
                CHECK(same_bits(shade(bench, w, scene, hits, setup, read), one));
                CHECK(same_bits(shade(bench, w, scene, hits, setup, traced), one));
            }
        }
        ShadowCount count;
        compare(scene, hits, arrived, light, count);
        CHECK(count.wrong == 0);
        CHECK(count.lit > 100);
        CHECK(count.shadowed > 20);
    });
}

TEST_CASE("shade_light: a pass that ends with what arrives is intersect_shadow's, and shades nothing",
          "[shade_light]") {
    with_each_light([](Bench& bench, const Scene& scene, const Receivers& hits, const LightSetup& setup,
                       const Light& light, Random& random) {
        const ShadeSetup traced{"SHADOWS_TRACED", std::vector<float>(hits.size()),
                                radiance_before(random, hits.size())};
        const std::vector<float> expected = arrival(bench, scene, hits, light);
        for (const Width& w : widths) {
            INFO(w);
            std::vector<float> arrived;
            CHECK(same_bits(shade(bench, w, scene, hits, setup, traced, nullptr, &arrived), traced.radiance));
            CHECK(same_bits(arrived, expected));
        }
    });
}

TEST_CASE("shade_light: lights added at once are those added one after the other, bit for bit", "[shade_light]") {
    with_each_light([](Bench& bench, const Scene& scene, const Receivers& hits, const LightSetup& setup,
                       const Light& light, Random& random) {
        std::vector<float> arrivals;
        ShadeSetup at_once{"SHADOWS_TRACED", {}, radiance_before(random, hits.size())};
        std::vector<float> one_by_one = at_once.radiance;
        const auto add = [&](const Light& next) {
            const LightSetup its = set_up(bench, scene, next);
            const std::vector<float> arrived = arrival(bench, scene, hits, next);
            one_by_one = shade(bench, widths[0], scene, hits, its, {"SHADOWS_READ", arrived, one_by_one});
            arrivals.insert(arrivals.end(), arrived.begin(), arrived.end());
            return its.phi;
        };
        for (const Light& before : {lights[1], lights[0], lights[1]}) at_once.phis_before.push_back(add(before));
        at_once.arrivals = arrivals;
        add(light);
        ShadeSetup read = at_once;
        read.shadows = "SHADOWS_READ";
        read.arrivals = arrivals;
        for (const Width& w : widths) {
            INFO(w);
            CHECK(same_bits(shade(bench, w, scene, hits, setup, at_once), one_by_one));
            CHECK(same_bits(shade(bench, w, scene, hits, setup, read), one_by_one));
        }
    });
}

TEST_CASE("shade_light: without shadows all that faces the light is lit", "[shade_light]") {
    with_each_light([](Bench& bench, const Scene& scene, const Receivers& hits, const LightSetup& setup,
                       const Light& light, Random& random) {
        Scene empty;  // without spheres nothing is in the way
        empty.spheres = {scene.spheres[0]};
        Receivers nothing_between = hits;
        for (int& id : nothing_between.ids) id = id < 0 ? -1 : 0;
        const std::vector<float> arrived = arrival(bench, empty, nothing_between, light);
        for (const bool first : {true, false}) {
            const ShadeSetup off{"SHADOWS_OFF", {}, radiance_before(random, hits.size()), first};
            const std::vector<float> one = shade(bench, widths[0], scene, hits, setup, off);
            CHECK(wrong_sums(scene, hits, setup.phi, off, arrived, one) == 0);
            for (const Width& w : widths) {
                INFO(w);
                CHECK(same_bits(shade(bench, w, scene, hits, setup, off), one));
            }
        }
        int wrong = 0;
        for (size_t i = 0; i < hits.size(); ++i) {
            if (hits.ids[i] < 0) continue;
            const double expected = share(hits.hit(i), light), bound = share_bound(hits.hit(i), light);
            wrong += !(std::fabs(static_cast<double>(arrived[i]) - std::max(0.0, expected)) <= bound);
        }
        CHECK(wrong == 0);
    });
}

TEST_CASE("shade_light: the last light's launch resolves what it leaves", "[shade_light]") {
    with_each_light([](Bench& bench, const Scene& scene, const Receivers& hits, const LightSetup& setup, const Light&,
                       Random& random) {
        // 12 blocks in rows of odd and even length, cut at the image's edges and not.
        for (const auto& [tile, image] : {std::pair{Tile{0, 0, 4, 12}, ImageSize{32, 24}},
                                          {{0, 0, 3, 12}, {21, 30}},
                                          {{0, 0, 12, 12}, {96, 5}},
                                          {{8, 16, 6, 12}, {55, 32}},
                                          {{0, 0, 1, 12}, {8, 96}}}) {
            INFO(image.width << " x " << image.height << ", " << tile.blocks_x << " blocks in a row");
            ShadeSetup kept{"SHADOWS_TRACED", {}, radiance_before(random, hits.size()), false};
            const std::vector<float> blocks = shade(bench, widths[0], scene, hits, setup, kept);
            const auto pixels = static_cast<size_t>(image.width * image.height);
            std::vector<float> expected = sentinels<float>(3 * pixels);
            for (size_t ray = 0; ray < hits.size(); ++ray) {
                const auto [x, y] = pixel_of(tile, ray);
                if (x >= image.width || y >= image.height) continue;
                for (size_t c = 0; c < 3; ++c)
                    expected[c * pixels + static_cast<size_t>(y * image.width + x)] = blocks[place(ray, c, 3)];
            }
            kept.tile = tile;
            kept.image = image;
            for (const Width& w : widths) {
                std::vector<float> resolved;
                CHECK(same_bits(shade(bench, w, scene, hits, setup, kept, &resolved), kept.radiance));
                CHECK(same_bits(resolved, expected));
                ShadeSetup not_last = kept;
                not_last.image = {0, 0};
                resolved.clear();
                CHECK(same_bits(shade(bench, w, scene, hits, setup, not_last, &resolved), blocks));
                CHECK(same_bits(resolved, sentinels<float>(resolved.size())));
            }
        }
    });
}

TEST_CASE("shade_light: the colour is that of each hit's own id", "[shade_light]") {
    on_every_bench([](Bench& bench) {
        // Every ray of a packet has another id, 0 and the last among them; exact numbers.
        Scene scene;
        for (int id = 0; id < 100000; ++id)
            scene.spheres.push_back({{0, 0, 9e3}, 1, {id * 0x1p-17, (99999 - id) * 0x1p-17, 0.5}});
        Receivers hits;
        std::vector<float> arrived;
        for (int i = 0; i < 3 * BLOCK_RAYS; ++i) {
            hits.add({0, 0, 1}, 8, {0, 0, -1}, i % 5 == 4 ? -1 : i == 0 ? 0 : 99999 - i * 520 % 99999);
            arrived.push_back(i % 5 == 4 || i % 7 == 6 ? 0.0f : 0.25f);
        }
        Scene one;
        one.spheres = {scene.spheres[0]};
        LightSetup setup = set_up(bench, one, lights[0]);
        setup.phi = {2, 4, 8};
        const ShadeSetup shading{"SHADOWS_READ", arrived, std::vector<float>(3 * hits.size(), 1), false};
        for (const Width& w : widths) {
            INFO(w);
            const std::vector<float> after = shade(bench, w, scene, hits, setup, shading);
            int wrong = 0;
            for (size_t i = 0; i < hits.size(); ++i) {
                Float3 expected{1, 1, 1};
                if (arrived[i] > 0) {
                    const float id = static_cast<float>(hits.ids[i]);
                    expected = {1 + id * 0x1p-18f, 1 + (99999 - id) * 0x1p-17f, 2};
                }
                const Float3 now = unpacked(after, i);
                wrong += !(now.x == expected.x && now.y == expected.y && now.z == expected.z);
            }
            CHECK(wrong == 0);
        }
    });
}
