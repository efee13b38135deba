#include "plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "chain.h"
#include "error.h"
#include "hierarchy.h"
#include "pencil.h"
#include "tiling.h"

namespace gnomon {

namespace {

int choose_lanes(int asked, const DeviceLimits& limits) {
    if (asked == 0) {
        // A CPU whose driver likes scalars makes vectors of work-items itself (Mesa's llvmpipe): with lanes of 4 it
        // takes 80 s to compile the kernels of directional.json, with lanes of 1 it takes 10.
        if (!limits.cpu || limits.native_width_float <= 1) return 1;
        for (const int lanes : {16, 8, 4})
            if (limits.native_width_float >= lanes) return lanes;
        return 4;
    }
    for (const int lanes : {1, 4, 8, 16})
        if (asked == lanes) return lanes;
    throw Error(Blame::input, "found " + std::to_string(asked) + ", expected 1, 4, 8 or 16", "--lanes");
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
            most = std::max(most, point_pencil<float>(*point, scene.camera, survey, frame).faces);
    return most;
}

/// A bit for each ray, doubts for each block and, while undecided ones are computed again, rays and views of doubles.
int64_t certifying_bytes(const MemoryNeeds& needs) {
    SphereFootprint doubles = needs.sphere;
    doubles.real_bytes = 8;
    constexpr int64_t bit = 1, place = 4;
    const auto alone = [&](int real) {
        return int64_t{refinement_batch} *
               (bytes_per_ray(real, needs.arrivals) + bytes_per_vector(real) + 2 * real + bit + place);
    };
    const int64_t doubts = needs.image_rays / BLOCK_RAYS * 2 * 4;
    return needs.image_rays / 8 + doubts + alone(8) + alone(4) + needs.views * doubles.view(needs.spheres);
}

void use(Tiling tiling, Plan& plan) {
    plan.workers = tiling.workers;
    plan.tile_sets = tiling.sets;
    plan.tile_blocks = tiling.largest();
    plan.tiles = std::move(tiling.tiles);
}

MemoryPlan share_memory(const Plan& plan, const Scene& scene, const Survey& survey, const RenderOptions& options,
                        const DeviceLimits& limits) {
    MemoryNeeds needs;
    needs.sphere = {plan.has_rests,
                    !limits.shares_memory,
                    plan.has_rests || !survey.one_albedo ? 7 : 4,
                    false,
                    options.shadows ? most_faces(scene, survey, choose_frame(scene, survey)) : 1,
                    plan.max_slices,
                    real_bytes(plan.accuracy)};
    needs.spheres = survey.count;
    needs.views = 1 + (options.shadows ? static_cast<int>(scene.lights.size()) : 0);
    for (const Tile& tile : plan.tiles) needs.image_rays += int64_t{tile.blocks} * BLOCK_RAYS;
    needs.tile_rays = int64_t{plan.tile_blocks} * BLOCK_RAYS;
    needs.tiles_under_way = plan.tile_sets;
    needs.asked_tile_rays = options.tile;
    needs.arrivals = options.shadows ? std::min<int64_t>(static_cast<int64_t>(scene.lights.size()), MOST_SHADED) : 0;
    needs.generate_rays = !limits.cpu;
    needs.film_bytes_per_ray = plan.write_in_place ? 0 : 3 * 4;
    needs.all_views = options.accuracy == Accuracy::certified;
    // The counts of hits, one a block and 4 bytes, and a value for each buffer that a scene does not use.
    constexpr int64_t unused = 1024;
    needs.other_bytes = (options.accuracy == Accuracy::certified ? certifying_bytes(needs) : 0) +
                        4 * needs.image_rays / BLOCK_RAYS + unused;
    const uint64_t allowed = options.memory > 0 ? std::min(limits.global_bytes, options.memory) : limits.global_bytes;
    return plan_memory(needs, {static_cast<int64_t>(allowed), static_cast<int64_t>(limits.max_alloc_bytes)});
}

}  // namespace

/// By addresses of 32 bits.
constexpr uint64_t most_addressed = std::numeric_limits<uint32_t>::max();

DeviceLimits::DeviceLimits(const DeviceInfo& info)
    : cpu(info.type == DeviceType::cpu),
      native_width_float(info.native_width_float),
      max_work_group(info.max_work_group),
      global_bytes(info.global_bytes),
      max_alloc_bytes(info.max_alloc_bytes),
      compute_units(info.compute_units),
      sub_devices(info.sub_devices),
      cores_apart(info.cores_apart),
      core_cache_bytes(info.core_cache_bytes),
      shares_memory(info.shares_memory) {
    if (info.address_bits >= 64) return;
    global_bytes = std::min(global_bytes, most_addressed);
    max_alloc_bytes = std::min(max_alloc_bytes, most_addressed);
}

int preferred_local_size(bool cpu) { return cpu ? 16 : 64; }

const char* to_string(Kernel kernel) {
    static constexpr const char* names[] = {
        "sphere_keys",     "count_digits",   "scan_counts", "scatter_pairs", "find_duplicates",   "gather_spheres",
        "project_spheres", "bound_clusters", "bound_nodes", "generate_rays", "intersect_closest", "intersect_shadow",
        "shade_light",     "resolve",        "refine_rays", "measure_roots"};
    return names[static_cast<int>(kernel)];
}

std::string Variant::options() const {
    std::string text;
    for (const std::string& define : defines) text += (text.empty() ? "-D " : " -D ") + define;
    return text + build_options(accuracy);
}

std::string Variant::name() const { return std::string(to_string(kernel)) + " " + options(); }

Variant sphere_variant(Kernel kernel, Accuracy accuracy, bool has_rests, bool is_parallel, bool has_ids) {
    // Spheres are seen as exactly as the type allows, however fast rays are traced.
    const Accuracy seen = computes_in_double(accuracy) ? accuracy : Accuracy::strict;
    const std::string rests = has_rests ? "RESTS=1" : "RESTS=0", parallel = is_parallel ? "PARALLEL=1" : "PARALLEL=0";
    switch (kernel) {
        case Kernel::project_spheres:
            return {kernel, {rests}, seen};
        case Kernel::bound_clusters:
            return {kernel, {"LANES=16", "PACKETS=1", parallel}, seen};
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
    const int pairs = (tile.blocks_x + 1) / 2 * (tile.blocks / tile.blocks_x);
    if (kernel == Kernel::resolve) return pairs * BLOCK_SIDE;
    if (kernel == Kernel::shade_light && !resolve_radiance) return pairs;
    return tile.blocks * BLOCK_RAYS / rays_per_item();
}

bool Plan::flat() const { return spheres <= flat_spheres && !memory.cut; }

/// By several work-items or, where spheres come in chunks, by several launches; and never set where another device is
/// the block's.
bool Plan::adds_to_blocks() const { return rays_per_item() < BLOCK_RAYS || memory.cut || shares_tiles; }

std::string Plan::walk() const {
    if (!flat()) return "WALK_NODES";
    return spheres > few_spheres ? "WALK_CLUSTERS" : "WALK_SPHERES";
}

int Plan::slices(int64_t pairs) const {
    constexpr int64_t least = DIGITS;  // fewer than its counts are not worth a slice
    return static_cast<int>(std::clamp<int64_t>(pairs / least, 1, max_slices));
}

bool Plan::uses(Kernel kernel) const {
    return std::any_of(steps.begin(), steps.end(), [=](const Step& s) { return s.kernel == kernel; });
}

int Plan::arrivals() const {
    int most = 0;
    for (const Step& s : steps) most = std::max(most, s.arrival + 1);
    return most;
}

Plan make_plan(const Scene& scene, const Survey& survey, const RenderOptions& options, const DeviceLimits& limits) {
    Plan plan;
    plan.image = scene.image;
    plan.accuracy = options.accuracy;
    plan.lanes = choose_lanes(options.lanes, limits);
    // A block, whose rays are culled as one and share the load of a sphere: S100 takes 1.2 times as long where vectors
    // of 8 are 4 a work-item, half a block, and 1.45 times where vectors of 4 are.
    plan.packets = plan.lanes == 1 ? 1 : BLOCK_RAYS / plan.lanes;
    plan.local_size =
        static_cast<int>(std::min(static_cast<uint64_t>(preferred_local_size(limits.cpu)), limits.max_work_group));
    plan.slice_local_size = limits.cpu ? 1 : plan.local_size;
    plan.max_slices = limits.compute_units * (limits.cpu ? 16 : 64);
    plan.spheres = survey.count;
    plan.certified = options.accuracy == Accuracy::certified;
    // A hierarchy's rays differ: all that is hard may lie in one tile.
    use(choose_tiling(scene.image, options.tile, plan.flat(), real_bytes(plan.accuracy), limits), plan);
    plan.has_rests = !choose_frame(scene, survey).floats;
    plan.group_depth = group_depth(scene);
    const uint64_t plane_bytes =
        static_cast<uint64_t>(scene.image.width) * static_cast<uint64_t>(scene.image.height) * 4;
    plan.write_in_place = limits.shares_memory && plane_bytes <= limits.max_alloc_bytes;
    plan.stream = plan.write_in_place && limits.cpu;
    if (survey.count > 0) plan.memory = share_memory(plan, scene, survey, options, limits);
    if (plan.memory.by_view) use(one_by_one(scene.image, static_cast<int>(plan.memory.tile_rays)), plan);
    plan.albedos_of_rays = plan.memory.cut && !survey.one_albedo;
    if (plan.certified && plan.memory.by_view)
        throw Error(Blame::input, "a certified picture needs all spheres on the device at once", "--accuracy certified",
                    "allow more --memory, or render with --accuracy strict");
    // A launch costs a CPU more than it does a GPU, and what is read again costs more than what is still at hand.
    const bool few_launches = limits.cpu && !plan.memory.cut;
    if (options.shadows) plan.shadows = few_launches || plan.certified ? Shadows::traced : Shadows::read;
    plan.generate_rays = !few_launches;
    plan.all_hits = options.outputs.distance || options.outputs.normal || plan.memory.cut;
    plan.resolve_radiance = !few_launches || !plan.write_in_place;
    add_steps(plan, scene, options);
    if (!plan.steps.empty()) add_sphere_kernels(plan, scene);
    return plan;
}

Plan make_refinement_plan(const Plan& plan, const Scene& scene, Accuracy accuracy) {
    Plan refined = plan;
    refined.accuracy = accuracy;
    refined.lanes = 1;
    refined.packets = 1;
    refined.doubt_rays = 1;
    refined.generate_rays = refined.all_hits = refined.resolve_radiance = true;
    refined.write_in_place = refined.stream = refined.boxes = false;
    const int blocks = refinement_batch / BLOCK_RAYS;
    use({{{0, 0, blocks, blocks}}, 1, 1}, refined);
    refined.steps.clear();
    refined.variants.clear();
    add_refinement_steps(refined, scene, plan.uses(Kernel::shade_light));
    add_sphere_kernels(refined, scene);
    return refined;
}

}  // namespace gnomon
