#include "plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.h"
#include "hierarchy.h"
#include "pencil.h"

namespace gnomon {

namespace {

// Rays in a tile. On a CPU the buffers of the tiles under way should stay in the caches, and a launch should cost
// little beside its work: two tiles of 128 Ki rays are 12 MiB, and a launch of one takes 0.1 ms or more. A GPU wants to
// be filled.
constexpr int cpu_tile_rays = 1 << 17, gpu_tile_rays = 1 << 20;
constexpr int max_tile_rays = 1 << 24;

int choose_lanes(int asked, const DeviceLimits& limits) {
    if (asked == 0) {
        if (!limits.cpu) return 1;
        for (const int lanes : {16, 8, 4})
            if (limits.native_width_float >= lanes) return lanes;
        return 4;
    }
    for (const int lanes : {1, 4, 8, 16})
        if (asked == lanes) return lanes;
    throw Error(Blame::input, "found " + std::to_string(asked) + ", expected 1, 4, 8 or 16", "--lanes");
}

int tile_rays(int asked, const DeviceLimits& limits) {
    if (asked == 0) return limits.cpu ? cpu_tile_rays : gpu_tile_rays;
    if (asked >= BLOCK_RAYS && asked <= max_tile_rays) return asked;
    throw Error(Blame::input,
                "found " + std::to_string(asked) + ", expected rays a tile, " + std::to_string(BLOCK_RAYS) + " to " +
                    std::to_string(max_tile_rays),
                "--tile");
}

/// Whole rows of blocks where they fit a tile, parts of one row where they do not.
std::vector<Tile> cut(const ImageSize& image, int rays) {
    const int blocks_x = (image.width + BLOCK_SIDE - 1) / BLOCK_SIDE,
              blocks_y = (image.height + BLOCK_SIDE - 1) / BLOCK_SIDE;
    const int wide = std::min(blocks_x, rays / BLOCK_RAYS),
              high = std::min(blocks_y, std::max(1, rays / BLOCK_RAYS / wide));
    std::vector<Tile> tiles;
    for (int y = 0; y < blocks_y; y += high)
        for (int x = 0; x < blocks_x; x += wide) {
            const int w = std::min(wide, blocks_x - x), h = std::min(high, blocks_y - y);
            tiles.push_back({x * BLOCK_SIDE, y * BLOCK_SIDE, w, w * h});
        }
    return tiles;
}

/// Adds launches to a plan, and a kernel variant when a launch is the first to need it.
class Chain {
  public:
    explicit Chain(Plan& plan) : plan_(plan) {}

    void add(Step step, const std::vector<std::string>& defines) {
        std::vector<Variant>& variants = plan_.variants;
        const auto same = [&](const Variant& v) { return v.kernel == step.kernel && v.defines == defines; };
        const auto found = std::find_if(variants.begin(), variants.end(), same);
        step.variant = static_cast<int>(found - variants.begin());
        if (found == variants.end()) variants.push_back({step.kernel, defines});
        plan_.steps.push_back(step);
    }
    void add_lanes(Step step, std::vector<std::string> defines) {
        defines.insert(defines.begin(),
                       {"LANES=" + std::to_string(plan_.lanes), "PACKETS=" + std::to_string(plan_.packets)});
        add(step, defines);
    }
    /// For a kernel that meets the spheres.
    void add_tracing(Step step, std::vector<std::string> defines) {
        defines.push_back("WALK=" + plan_.walk());
        if (step.kernel == Kernel::shade_light) {
            defines.push_back(plan_.albedos_of_rays ? "ALBEDOS_OF_RAYS=1" : "ALBEDOS_OF_RAYS=0");
            defines.push_back(plan_.resolve_radiance ? "RESOLVES=0" : "RESOLVES=1");
            defines.push_back(stream());
        } else {
            defines.push_back(plan_.memory.cut ? "CHUNKS=1" : "CHUNKS=0");
        }
        if (step.kernel == Kernel::intersect_closest)
            defines.push_back(plan_.generate_rays ? "RAYS=RAYS_READ" : "RAYS=RAYS_GENERATED");
        add_lanes(step, defines);
    }
    void resolve(Output output) {
        Step step{Kernel::resolve, 0};
        step.output = output;
        add(step, {stream()});
    }

  private:
    std::string stream() const { return plan_.stream ? "STREAM=1" : "STREAM=0"; }

    Plan& plan_;
};

const char* define(Shadows shadows) {
    switch (shadows) {
        case Shadows::off:
            return "SHADOWS=SHADOWS_OFF";
        case Shadows::read:
            return "SHADOWS=SHADOWS_READ";
        case Shadows::traced:
            break;
    }
    return "SHADOWS=SHADOWS_TRACED";
}

bool shines(const Light& light) {
    const auto any = [](const Rgb& c) { return c.r > 0 || c.g > 0 || c.b > 0; };
    const auto* point = std::get_if<PointLight>(&light);
    return any(point ? point->power : std::get<DirectionalLight>(light).irradiance);
}

void add_lights(Chain& chain, const Scene& scene, Shadows shadows) {
    bool first = true;
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        if (!shines(scene.lights[i])) continue;
        const bool point = std::holds_alternative<PointLight>(scene.lights[i]);
        const std::string kind = point ? "LIGHT=LIGHT_POINT" : "LIGHT=LIGHT_DIRECTIONAL";
        Step step{Kernel::intersect_shadow, 0, static_cast<int>(i)};
        if (shadows == Shadows::read) chain.add_tracing(step, {kind});
        step.kernel = Kernel::shade_light;
        step.first = std::exchange(first, false);
        chain.add_tracing(step, {kind, define(shadows)});
    }
}

/// The kernels that put the spheres in order, and in each pencil's view.
void add_sphere_kernels(Plan& plan, const Scene& scene) {
    const auto add = [&](Kernel kernel, bool parallel = false) {
        const Variant variant = sphere_variant(kernel, plan.has_rests, parallel, plan.memory.cut);
        std::vector<Variant>& all = plan.variants;
        if (std::find(all.begin(), all.end(), variant) == all.end()) all.push_back(variant);
    };
    const auto add_view = [&](bool parallel) {
        add(Kernel::project_spheres, parallel);
        if (plan.flat()) return;
        add(Kernel::bound_clusters, parallel);
        add(Kernel::bound_nodes, parallel);
    };
    if (!plan.flat())
        for (const Kernel kernel :
             {Kernel::sphere_keys, Kernel::count_digits, Kernel::scan_counts, Kernel::scatter_pairs})
            add(kernel);
    add(Kernel::find_duplicates);
    add(Kernel::gather_spheres);
    add_view(false);
    if (plan.shadows == Shadows::off || !plan.uses(Kernel::shade_light)) return;
    for (const Light& light : scene.lights)
        if (shines(light)) add_view(std::holds_alternative<DirectionalLight>(light));
}

/// Only what the scene and the outputs need: without spheres, or without anything to show of them, no launch at all.
void add_steps(Plan& plan, const Scene& scene, const RenderOptions& options) {
    const Outputs& wanted = options.outputs;
    const bool shaded = wanted.radiance && std::any_of(scene.lights.begin(), scene.lights.end(), shines);
    if (plan.spheres == 0 || !(shaded || wanted.distance || wanted.normal || wanted.id)) return;
    Chain chain(plan);
    if (plan.generate_rays) chain.add_lanes({Kernel::generate_rays, 0}, {});
    chain.add_tracing({Kernel::intersect_closest, 0}, {});
    if (wanted.distance) chain.resolve(Output::distance);
    if (wanted.normal) chain.resolve(Output::normal);
    if (wanted.id) chain.resolve(Output::id);
    if (!shaded) return;
    add_lights(chain, scene, plan.shadows);
    if (plan.resolve_radiance)
        chain.resolve(Output::radiance);
    else
        plan.steps.back().resolves = true;
}

/// A block of receivers is traced as one while its depth is no more than a few times its width, 4 times the 8 pixels:
/// with 16 a block of 10^6 small spheres has half the groups, and four times the spheres to test; with 1, twice the
/// nodes.
float group_depth(const Scene& scene) {
    const double pixel = 2 * std::tan(scene.camera.fov * 3.14159265358979323846 / 360) / scene.image.height;
    return static_cast<float>(1 + 4 * BLOCK_SIDE * pixel);
}

/// The most faces that a point light keeps bounds for.
int most_faces(const Scene& scene, const Survey& survey, const Frame& frame) {
    int most = 1;
    for (const Light& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light))
            most = std::max(most, point_pencil(*point, scene.camera, survey, frame).faces);
    return most;
}

MemoryPlan share_memory(const Plan& plan, const Scene& scene, const Survey& survey, const RenderOptions& options,
                        const DeviceLimits& limits) {
    MemoryNeeds needs;
    needs.sphere = {plan.has_rests,
                    !limits.shares_memory,
                    plan.has_rests || !survey.one_albedo ? 7 : 4,
                    false,
                    options.shadows ? most_faces(scene, survey, choose_frame(scene, survey)) : 1,
                    plan.max_slices};
    needs.spheres = survey.count;
    needs.views = 1 + (options.shadows ? static_cast<int>(scene.lights.size()) : 0);
    for (const Tile& tile : plan.tiles) {
        needs.image_rays += int64_t{tile.blocks} * BLOCK_RAYS;
        needs.tile_rays = std::max(needs.tile_rays, int64_t{tile.blocks} * BLOCK_RAYS);
    }
    needs.tiles_under_way = std::min<int64_t>(tile_sets, static_cast<int64_t>(plan.tiles.size()));
    needs.asked_tile_rays = options.tile;
    needs.film_bytes_per_ray = plan.write_in_place ? 0 : 3 * 4;
    // The counts of hits, one a work-group and 4 bytes, and a value for each buffer that a scene does not use.
    constexpr int64_t unused = 1024;
    needs.other_bytes =
        4 * (needs.image_rays / (plan.rays_per_item() * plan.local_size) + static_cast<int64_t>(plan.tiles.size())) +
        unused;
    const uint64_t allowed = options.memory > 0 ? std::min(limits.global_bytes, options.memory) : limits.global_bytes;
    return plan_memory(needs, {static_cast<int64_t>(allowed), static_cast<int64_t>(limits.max_alloc_bytes)});
}

}  // namespace

DeviceLimits::DeviceLimits(const DeviceInfo& info)
    : cpu(info.type == DeviceType::cpu),
      native_width_float(info.native_width_float),
      max_work_group(info.max_work_group),
      global_bytes(info.global_bytes),
      max_alloc_bytes(info.max_alloc_bytes),
      compute_units(info.compute_units),
      shares_memory(info.shares_memory) {}

const char* to_string(Kernel kernel) {
    static constexpr const char* names[] = {
        "sphere_keys",       "count_digits",     "scan_counts",    "scatter_pairs", "find_duplicates",
        "gather_spheres",    "project_spheres",  "bound_clusters", "bound_nodes",   "generate_rays",
        "intersect_closest", "intersect_shadow", "shade_light",    "resolve",       "measure_roots"};
    return names[static_cast<int>(kernel)];
}

std::string Variant::options() const {
    std::string text;
    for (const std::string& define : defines) text += (text.empty() ? "-D " : " -D ") + define;
    return text;
}

Variant sphere_variant(Kernel kernel, bool has_rests, bool is_parallel, bool has_ids) {
    const std::string rests = has_rests ? "RESTS=1" : "RESTS=0", parallel = is_parallel ? "PARALLEL=1" : "PARALLEL=0";
    switch (kernel) {
        case Kernel::project_spheres:
            return {kernel, {rests, parallel}};
        case Kernel::bound_clusters:
        case Kernel::bound_nodes:
            return {kernel, {"LANES=16", "PACKETS=1", parallel}};
        case Kernel::gather_spheres:
            return {kernel, {rests, has_ids ? "IDS=1" : "IDS=0"}};
        case Kernel::sphere_keys:
        case Kernel::find_duplicates:
            return {kernel, {rests}};
        default:
            return {kernel, {}};
    }
}

int Plan::items(Kernel kernel, const Tile& tile) const {
    if (kernel != Kernel::resolve) return tile.blocks * BLOCK_RAYS / rays_per_item();
    return (tile.blocks_x + 1) / 2 * (tile.blocks / tile.blocks_x) * BLOCK_SIDE;
}

bool Plan::flat() const { return spheres <= flat_spheres && !memory.cut; }

std::string Plan::walk() const {
    if (!flat()) return "WALK_NODES";
    return spheres > few_spheres ? "WALK_CLUSTERS" : "WALK_SPHERES";
}

int Plan::slices(int64_t pairs) const {
    constexpr int64_t least = 4 * DIGITS;  // fewer than its counts are not worth a slice
    return static_cast<int>(std::clamp<int64_t>(pairs / least, 1, max_slices));
}

bool Plan::uses(Kernel kernel) const {
    return std::any_of(steps.begin(), steps.end(), [=](const Step& s) { return s.kernel == kernel; });
}

Plan make_plan(const Scene& scene, const Survey& survey, const RenderOptions& options, const DeviceLimits& limits) {
    Plan plan;
    plan.image = scene.image;
    plan.lanes = choose_lanes(options.lanes, limits);
    plan.packets = plan.lanes == 1 ? 1 : 4;  // 4 vectors share the load of a sphere; more would spill
    plan.local_size = static_cast<int>(std::min<uint64_t>(limits.cpu ? 16 : 64, limits.max_work_group));
    plan.slice_local_size = limits.cpu ? 1 : plan.local_size;
    plan.max_slices = limits.compute_units * (limits.cpu ? 16 : 64);
    plan.tiles = cut(scene.image, tile_rays(options.tile, limits));
    plan.spheres = survey.count;
    plan.has_rests = !choose_frame(scene, survey).floats;
    plan.group_depth = group_depth(scene);
    const uint64_t plane_bytes =
        static_cast<uint64_t>(scene.image.width) * static_cast<uint64_t>(scene.image.height) * 4;
    plan.write_in_place = limits.shares_memory && plane_bytes <= limits.max_alloc_bytes;
    plan.stream = plan.write_in_place && limits.cpu;
    if (survey.count > 0) plan.memory = share_memory(plan, scene, survey, options, limits);
    if (plan.memory.by_view) plan.tiles = cut(scene.image, static_cast<int>(plan.memory.tile_rays));
    plan.albedos_of_rays = plan.memory.cut && !survey.one_albedo;
    // A launch costs a CPU more than it does a GPU, and what is read again costs more than what is still at hand.
    const bool few_launches = limits.cpu && !plan.memory.cut;
    if (options.shadows) plan.shadows = few_launches ? Shadows::traced : Shadows::read;
    plan.generate_rays = !few_launches;
    plan.resolve_radiance =
        !few_launches || !plan.write_in_place || plan.rays_per_item() * plan.local_size % BLOCK_RAYS != 0;
    add_steps(plan, scene, options);
    if (!plan.steps.empty()) add_sphere_kernels(plan, scene);
    for (const Tile& tile : plan.tiles) plan.tile_blocks = std::max(plan.tile_blocks, tile.blocks);
    return plan;
}

}  // namespace gnomon
