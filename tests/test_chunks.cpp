// Spheres that go through the device in chunks: which chunk each is in, and that no bit depends on it.
#include <algorithm>
#include <set>

#include "chunk_rows.h"
#include "crowds.h"
#include "id_blocks.h"
#include "partition.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// All pixels see the crowd, lit by a sun and by lamps outside and inside.
Scene lit(Crowd crowd, int count) {
    Scene scene = scene_of(crowd, count);
    scene.image = {96, 64};
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60};
    scene.lights = {DirectionalLight{{1, 2, -1}, {1, 2, 3}}, PointLight{{10, 80, -100}, {1e5, 1e5, 1e5}},
                    PointLight{{0, 0, 100}, {1e5, 2e5, 1e5}}};
    Random random(9);
    for (Sphere& s : scene.spheres) s.albedo = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    return scene;
}

/// The same spheres as a table of floats or of doubles.
template <class Number>
Scene with_table(Scene scene, int columns) {
    auto rows = std::make_shared<std::vector<Number>>();
    for (const Sphere& s : scene.spheres) {
        const double numbers[] = {s.center.x, s.center.y, s.center.z, s.radius, s.albedo.r, s.albedo.g, s.albedo.b};
        for (int i = 0; i < columns; ++i) rows->push_back(static_cast<Number>(numbers[i]));
    }
    scene.tables = {{rows, rows->data(), static_cast<int64_t>(scene.spheres.size()), columns, {0.5, 0.25, 0.75}}};
    scene.spheres.clear();
    return scene;
}

/// Bytes that leave room for a small part of the scene.
constexpr uint64_t tight = 1100 << 10, roomy = 2 << 20;

RenderStats render_within(Renderer& renderer, const Scene& scene, uint64_t memory, int tile, Film& film) {
    RenderOptions options = all_outputs();
    options.memory = memory;
    options.tile = tile;
    return renderer.render(scene, options, film);
}

void check_same_in_chunks(Renderer& renderer, const Scene& scene) {
    const Film film = render(renderer, scene);
    for (const uint64_t memory : {tight, roomy}) {
        Film other;
        const RenderStats stats = render_within(renderer, scene, memory, 2048, other);
        INFO(memory << " bytes, " << stats.chunks << " chunks");
        CHECK(stats.chunks > 1);
        CHECK(same_bits(other, film));
        CHECK(stats.planned_bytes <= static_cast<int64_t>(memory));
        CHECK(stats.peak_bytes <= stats.planned_bytes);
        CHECK(stats.peak_bytes > stats.planned_bytes / 4);
    }
}

/// Rows have their sphere's numbers, and each sphere is in one chunk; returns which.
std::vector<int> check_chunks(const Scene& scene, const Survey& spheres, int64_t capacity) {
    const Frame frame = choose_frame(scene, spheres);
    const Partition cut = cut_into_chunks(scene, spheres, frame, capacity);
    std::vector<int> chunk_of(scene.spheres.size(), -1);
    SphereRows rows;
    int wrong = 0;
    for (int chunk = 0; chunk < cut.chunks(); ++chunk) {
        rows_of_chunk(scene, frame, cut, chunk, rows);
        CHECK(rows.count <= capacity);
        CHECK(rows.count == static_cast<int64_t>(rows.ids.size()));
        CHECK(std::is_sorted(rows.ids.begin(), rows.ids.end()));
        for (size_t i = 0; i < rows.ids.size(); ++i) {
            const auto id = static_cast<size_t>(rows.ids[i]);
            wrong += chunk_of[id] >= 0;
            chunk_of[id] = chunk;
            wrong += rows.rows[4 * i] != static_cast<float>(frame.place(scene.spheres[id].center).x);
            wrong += rows.rows[4 * i + 3] != static_cast<float>(scene.spheres[id].radius);
        }
    }
    CHECK(wrong == 0);
    CHECK(std::count(chunk_of.begin(), chunk_of.end(), -1) == 0);
    return chunk_of;
}

}  // namespace

TEST_CASE("chunks: each sphere is in one, coincident ones in the same, none is too large", "[chunks]") {
    for (const Crowd crowd : crowds)
        for (const int64_t capacity : {100, 1000, 100000}) {
            INFO(to_string(crowd) << ", " << capacity);
            const Scene scene = scene_of(crowd, 20000);
            const Survey spheres = survey(scene);
            if (crowd == Crowd::coincident && capacity < 20000 / 2) {  // a third is in each of three places
                CHECK(contains(refusal(1, [&] { cut_into_chunks(scene, spheres, choose_frame(scene, spheres), 5000); }),
                               "--memory"));
                continue;
            }
            const std::vector<int> chunk_of = check_chunks(scene, spheres, capacity);
            if (crowd != Crowd::coincident) continue;
            for (size_t id = 3; id < 20000; ++id) CHECK(chunk_of[id] == chunk_of[id % 3]);
        }
}

TEST_CASE("chunks: blocks of ids, the last one not full", "[chunks]") {
    for (const Crowd crowd : {Crowd::strewn, Crowd::teapot_in_a_stadium}) {
        const Scene scene = scene_of(crowd, 4 * id_block + 100);
        const Survey spheres = survey(scene);
        check_chunks(scene, spheres, 20000);
        check_chunks(scene, spheres, 3000);  // of a teapot's cells, some are cut
    }
}

TEST_CASE("chunks: no bit depends on them", "[chunks]") {
    on_every_device([](Renderer& renderer) {
        for (const Crowd crowd : crowds) {
            if (crowd == Crowd::coincident) continue;
            INFO(to_string(crowd));
            const Scene scene = lit(crowd, 60000);
            check_same_in_chunks(renderer, scene);
            if (crowd != Crowd::shells) CHECK_FALSE(black(render(renderer, scene)));  // which hide all light
        }
    });
}

TEST_CASE("chunks: coincident spheres among others count as one", "[chunks]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = lit(Crowd::strewn, 40000);
        const std::vector<Sphere> twins(scene.spheres.begin(), scene.spheres.begin() + 20000);
        scene.spheres.insert(scene.spheres.end(), twins.begin(), twins.end());
        check_same_in_chunks(renderer, scene);
        const Film film = render(renderer, scene);
        CHECK(*std::max_element(film.id.begin(), film.id.end()) < 40000);
    });
}

TEST_CASE("chunks: tables of all kinds, whole and cut", "[chunks]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = lit(Crowd::strewn, 60000);
        check_same_in_chunks(renderer, with_table<float>(scene, 7));
        check_same_in_chunks(renderer, with_table<float>(scene, 4));
        check_same_in_chunks(renderer, with_table<double>(scene, 7));
        check_same_in_chunks(renderer, with_table<double>(scene, 4));
        // The same numbers, wherever they are kept.
        CHECK(same_bits(render(renderer, with_table<double>(scene, 7)), render(renderer, scene)));
        Scene halves = with_table<double>(scene, 7);
        halves.spheres.assign(scene.spheres.begin(), scene.spheres.begin() + 1000);
        SphereTable& table = halves.tables.front();
        table.rows = std::get<const double*>(table.rows) + 7000;
        table.count -= 1000;
        CHECK(same_bits(render(renderer, halves), render(renderer, scene)));
    });
}

TEST_CASE("chunks: what an earlier picture left takes no room", "[chunks]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = lit(Crowd::strewn, 60000);
        RenderOptions before = all_outputs();
        // Tiles of doubles for what is undecided; large tiles and all pencils' views.
        for (const Accuracy accuracy : {Accuracy::certified, Accuracy::strict}) {
            before.accuracy = accuracy;
            Film film, cut;
            renderer.render(scene, before, film);
            const RenderStats stats = render_within(renderer, scene, tight, 2048, cut);
            CHECK(stats.chunks > 1);
            CHECK(stats.peak_bytes <= stats.planned_bytes);
        }
    });
}

TEST_CASE("frames in which the spheres stay use what was built over them", "[chunks]") {
    on_every_device([](Renderer& renderer) {
        const auto gathered = [](const RenderStats& stats) {
            return std::any_of(stats.kernels.begin(), stats.kernels.end(),
                               [](const KernelStats& k) { return k.kernel == "gather_spheres" && k.launches > 0; });
        };
        Scene scene = with_table<float>(lit(Crowd::strewn, 20000), 7);
        RenderOptions first = all_outputs(), later = first;
        later.same_spheres = true;
        Film film;
        CHECK(gathered(renderer.render(scene, later, film)));  // the first time there is nothing yet
        for (int frame = 1; frame < 4; ++frame) {
            scene.camera.eye.x += 3;
            scene.lights.pop_back();
            CHECK_FALSE(gathered(renderer.render(scene, later, film)));
            CHECK(same_bits(film, render(renderer, scene)));
            CHECK(gathered(renderer.render(scene, first, film)));
        }
        scene.camera.eye = {0, 0, -0x1p50};  // another unit of length
        CHECK(gathered(renderer.render(scene, later, film)));
        CHECK(same_bits(film, render(renderer, scene)));
    });
}
