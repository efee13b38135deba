#include "cases.h"

#include <algorithm>

#include "embedded_files.h"
#include "report/draws.h"
#include "report/embedded_scenes.h"
#include "scene_io.h"
#include "shortcomings.h"
#include "survey.h"
#include "table_rows.h"

namespace gnomon::verify {

namespace {

constexpr ImageSize full_size{320, 240}, quick_size{40, 30};
// Sorted by Hilbert's curve in several slices, and under nodes in levels: 10^5 / 16 clusters are 6250, over which stand
// 391, 25 and 2 nodes. 2000 still have nodes.
constexpr int64_t full_crowd = 100000, quick_crowd = 2000;
constexpr uint64_t chunk_memory = 4 << 20;  // for a hierarchy of 30 bytes a sphere and a tile: some chunks

/// The largest odd multiple that fits: pixels then have their centres where the small picture had them, which is what
/// makes lines touch spheres exactly.
Scene enlarged(Scene scene) {
    const int times = std::min(full_size.width / scene.image.width, full_size.height / scene.image.height);
    const int odd = std::max(1, times - 1 + times % 2);
    scene.image = {scene.image.width * odd, scene.image.height * odd};
    return scene;
}

void add_examples(std::vector<Case>& cases, const ImageSize& size) {
    for (const auto& [file, text] : embedded_scenes()) {
        cases.push_back({file.substr(0, file.rfind('.')), parse_scene(text, file).scene, 0});
        cases.back().scene.image = size;
    }
}

/// In their files they are as large as quick pictures may be.
void add_hard_scenes(std::vector<Case>& cases, bool quick) {
    for (const auto& [file, text] : embedded_verify_files()) {
        if (file == "recorded.json") continue;
        const std::string name = file.substr(0, file.rfind('.'));
        const Scene scene = parse_scene(text, file).scene;
        if (!quick)
            cases.push_back({name, enlarged(scene), 0});
        else if (name == "touched_exactly" || name == "touching_outside" || name == "horizon_1e5")
            cases.push_back({name, scene, 0});
    }
}

}  // namespace

Scene crowd(int64_t count) {
    report::Draws draws(static_cast<uint64_t>(count));
    std::vector<float> rows;
    for (int64_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) rows.push_back(static_cast<float>(draws.uniform(-10, 10)));
        rows.push_back(static_cast<float>(draws.uniform(0.03, 0.15)));
        for (int channel = 0; channel < 3; ++channel) rows.push_back(static_cast<float>(draws.uniform(0.1, 0.9)));
    }
    Scene scene;
    scene.camera = {{4, 6, -24}, {0, 0, 0}, {0, 1, 0}, 50};
    scene.tables = {table_of(std::move(rows), columns_with_albedo, {})};
    scene.lights = {DirectionalLight{{1, 2, -1.5}, {2, 3, 4}}, PointLight{{-9, 12, -15}, {4000, 3000, 2000}}};
    return scene;
}

bool Case::suits(const DeviceInfo& device) const { return survey(scene).count <= most_spheres(device); }

std::vector<Case> cases(bool quick) {
    const ImageSize& size = quick ? quick_size : full_size;
    std::vector<Case> cases;
    add_examples(cases, size);
    add_hard_scenes(cases, quick);
    cases.push_back({"crowd", crowd(quick ? quick_crowd : full_crowd), 0});
    cases.back().scene.image = size;
    if (quick) return cases;
    cases.push_back(cases.back());
    cases.back().name = "crowd_in_chunks";
    cases.back().memory = chunk_memory;
    return cases;
}

}  // namespace gnomon::verify
