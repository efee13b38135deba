// Plans, made without a device: tiles, chains of launches, kernel variants, limits.
#include "plan.h"

#include <algorithm>
#include <set>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

Scene scene_of(int width, int height, const std::vector<Light>& lights = {}) {
    Scene scene = looking_ahead(width, height);
    scene.spheres = {{{0, 0, 10}, 2, {1, 1, 1}}};
    scene.lights = lights;
    return scene;
}

const Light sun = DirectionalLight{{0, 1, 0}, {1, 1, 1}}, lamp = PointLight{{0, 5, 0}, {1, 1, 1}};
const Light dark = PointLight{{0, 5, 0}, {0, 0, 0}};

Plan plan_of(const Scene& scene, const RenderOptions& options = all_outputs(), const DeviceLimits& limits = {}) {
    return make_plan(scene, survey(scene), options, limits);
}

DeviceLimits gpu() {
    DeviceLimits limits;
    limits.cpu = false;
    limits.native_width_float = 1;
    limits.max_work_group = 1024;
    limits.shares_memory = false;
    limits.sub_devices = 0;
    return limits;
}

/// How many tiles each pixel lies in; pixels that blocks hold beyond the image are left out.
std::vector<int> covered(const Plan& plan) {
    const int width = plan.image.width, height = plan.image.height;
    std::vector<int> tiles(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (const Tile& tile : plan.tiles)
        for (int block = 0; block < tile.blocks; ++block) {
            const int x = tile.x + block % tile.blocks_x * BLOCK_SIDE, y = tile.y + block / tile.blocks_x * BLOCK_SIDE;
            for (int j = y; j < std::min(y + BLOCK_SIDE, height); ++j)
                for (int i = x; i < std::min(x + BLOCK_SIDE, width); ++i)
                    ++tiles[static_cast<size_t>(j) * static_cast<size_t>(width) + static_cast<size_t>(i)];
        }
    return tiles;
}

/// "intersect_shadow 0" and the like.
std::vector<std::string> steps_of(const Plan& plan) {
    std::vector<std::string> steps;
    for (const Step& step : plan.steps) {
        std::string text = to_string(step.kernel);
        if (step.light >= 0) text += " " + std::to_string(step.light);
        if (step.arrival >= 0) text += " arrives";
        if (step.first) text += " sets";
        const char* const outputs[] = {" radiance", " distance", " normal", " id"};
        if (step.resolves) text += " resolves";
        if (step.kernel == Kernel::resolve) text += outputs[static_cast<int>(step.output)];
        steps.push_back(text);
    }
    return steps;
}

/// "shade_light LANES=16 ...", each variant once.
std::set<std::string> variants_of(const Plan& plan) {
    std::set<std::string> variants;
    for (const Variant& v : plan.variants) variants.insert(to_string(v.kernel) + (" " + v.options()));
    CHECK(variants.size() == plan.variants.size());
    return variants;
}

bool mentions(const Plan& plan, const std::string& text) {
    const std::set<std::string> variants = variants_of(plan);
    return std::any_of(variants.begin(), variants.end(), [&](const std::string& v) { return contains(v, text); });
}

}  // namespace

TEST_CASE("tiles cover every pixel once and are no larger than asked", "[plan]") {
    const std::pair<int, int> sizes[] = {{1, 1},    {7, 5},   {8, 8},    {9, 8},    {8, 9},      {64, 64},
                                         {123, 77}, {200, 3}, {5000, 1}, {1, 3000}, {1024, 768}, {1000, 31}};
    for (const auto& [width, height] : sizes)
        for (const int tile : {0, 64, 65, 1000, 4096, 65536, 1 << 20}) {
            RenderOptions options;
            options.tile = tile;
            INFO(width << "x" << height << ", tile " << tile);
            const Plan plan = plan_of(scene_of(width, height, {sun}), options);
            const std::vector<int> tiles = covered(plan);
            CHECK(std::count(tiles.begin(), tiles.end(), 1) == int64_t{width} * height);
            int largest = 0;
            for (const Tile& t : plan.tiles) {
                CHECK((t.x < width && t.y < height && t.blocks > 0 && t.blocks % t.blocks_x == 0));
                CHECK((t.x % BLOCK_SIDE == 0 && t.y % BLOCK_SIDE == 0));
                largest = std::max(largest, t.blocks);
            }
            CHECK(plan.tile_blocks == largest);
            if (tile > 0) CHECK(largest * BLOCK_RAYS <= tile);
        }
}

TEST_CASE("a GPU gets larger tiles than a CPU", "[plan]") {
    const Scene scene = scene_of(4096, 4096, {sun});
    CHECK(plan_of(scene, {}, gpu()).tile_blocks > plan_of(scene).tile_blocks);
}

TEST_CASE("a tile's launches follow each other: eye, outputs, light after light, radiance last", "[plan]") {
    const Scene scene = scene_of(8, 8, {sun, lamp, sun});
    using Steps = std::vector<std::string>;
    // A CPU has no more launches than passes: rays are generated, shadows traced and radiance resolved on the way.
    CHECK(steps_of(plan_of(scene)) == Steps{"intersect_closest", "resolve distance", "resolve normal", "resolve id",
                                            "shade_light 0 arrives", "intersect_shadow 1 arrives",
                                            "shade_light 2 sets resolves"});
    CHECK(steps_of(plan_of(scene, all_outputs(), gpu())) ==
          Steps{"generate_rays", "intersect_closest", "resolve distance", "resolve normal", "resolve id",
                "intersect_shadow 0 arrives", "intersect_shadow 1 arrives", "intersect_shadow 2 arrives",
                "shade_light 2 sets", "resolve radiance"});
    // Where the film is not the device's, resolving is a launch of its own.
    DeviceLimits cpu;
    cpu.shares_memory = false;
    CHECK(steps_of(plan_of(scene, all_outputs(), cpu)).back() == "resolve radiance");
    RenderOptions options;  // radiance only
    options.shadows = false;
    CHECK(steps_of(plan_of(scene_of(8, 8, {lamp, sun}), options)) ==
          Steps{"intersect_closest", "shade_light 0 sets", "shade_light 1 resolves"});
    CHECK(steps_of(plan_of(scene_of(8, 8, {dark, sun}), options)) ==
          Steps{"intersect_closest", "shade_light 1 sets resolves"});
    options.outputs = {false, true, false, false};
    CHECK(steps_of(plan_of(scene_of(8, 8, {sun}), options)) == Steps{"intersect_closest", "resolve distance"});
    options.outputs = {true, false, false, true};
    CHECK(steps_of(plan_of(scene_of(8, 8), options)) == Steps{"intersect_closest", "resolve id"});
}

TEST_CASE("nothing to trace, nothing to launch", "[plan]") {
    RenderOptions options;
    CHECK(plan_of(scene_of(8, 8), options).steps.empty());  // radiance without lights
    CHECK(plan_of(scene_of(8, 8, {dark}), options).steps.empty());
    options.outputs = {false, false, false, false};
    CHECK(plan_of(scene_of(8, 8, {sun}), options).steps.empty());
    Scene empty = scene_of(8, 8, {sun});
    empty.spheres.clear();
    const Plan plan = plan_of(empty);
    CHECK(plan.steps.empty());
    CHECK(plan.variants.empty());
    CHECK(plan.tiles.size() == 1);
}

TEST_CASE("only the variants that a scene needs are built, each once", "[plan]") {
    const Plan suns = plan_of(scene_of(8, 8, {sun, sun})), lamps = plan_of(scene_of(8, 8, {lamp, lamp})),
               both = plan_of(scene_of(8, 8, {sun, lamp, sun, lamp}));
    CHECK(variants_of(suns).size() == 3);
    CHECK_FALSE(mentions(suns, "LIGHT_POINT"));
    CHECK(variants_of(lamps).size() == 3);
    CHECK_FALSE(mentions(lamps, "LIGHT_DIRECTIONAL"));
    CHECK(variants_of(both).size() == 4);  // that of the last kind serves both lights of it
    const Plan split = plan_of(scene_of(8, 8, {sun, lamp, sun, lamp}), all_outputs(), gpu());
    CHECK(variants_of(split).size() == 6);
    CHECK(mentions(split, "SHADOWS_READ"));
    CHECK_FALSE(mentions(split, "SHADOWS_TRACED"));
    RenderOptions open;
    open.shadows = false;
    const Plan unshadowed = plan_of(scene_of(8, 8, {sun}), open);
    CHECK_FALSE(mentions(unshadowed, "intersect_shadow"));
    CHECK_FALSE(mentions(unshadowed, "SHADOWS_TRACED"));
    CHECK(mentions(unshadowed, "SHADOWS_OFF"));
    CHECK(mentions(suns, "SHADOWS_TRACED"));
    for (const Plan* plan : {&suns, &lamps, &both, &unshadowed})
        for (const Step& step : plan->steps)
            CHECK(plan->variants.at(static_cast<size_t>(step.variant)).kernel == step.kernel);
    for (const Step& step : both.steps) {
        if (step.light < 0) continue;
        const std::string options = both.variants[static_cast<size_t>(step.variant)].options();
        CHECK(contains(options, step.light % 2 == 0 ? "LIGHT_DIRECTIONAL" : "LIGHT_POINT"));
    }
}
