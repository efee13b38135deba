#include "device_renderer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "certify.h"
#include "clock.h"
#include "error.h"
#include "refine.h"

namespace gnomon {

namespace {

/// PoCL compiles a kernel anew for launches of more work-items than this.
int64_t most_items(const DeviceInfo& device) { return device.is_pocl() ? 65535 : std::numeric_limits<int64_t>::max(); }

/// How often each variant's kernel was given all the hits: once a light.
int64_t lights_of(const Plan& plan, size_t variant) {
    int64_t lights = 0;
    for (const Step& step : plan.steps)
        if (static_cast<size_t>(step.variant) == variant && step.light >= 0)
            lights +=
                plan.shadows == Shadows::read ? std::max<int64_t>(static_cast<int64_t>(step.shaded.size()), 1) : 1;
    return lights;
}

int64_t shaded_lights(const Plan& plan) {
    int64_t lights = 0;
    for (const Step& step : plan.steps) lights += static_cast<int64_t>(step.shaded.size());
    return lights;
}

/// Those of so many pixels, and the shadow rays of so many hits.
int64_t rays_of(const Plan& plan, int64_t pixels, int64_t hits) {
    return pixels + (plan.shadows != Shadows::off ? shaded_lights(plan) * hits : 0);
}

void add(const Plan& plan, const std::vector<Launcher::Cost>& costs, RenderStats& stats) {
    for (const Launcher::Cost& cost : costs) {
        const auto at = std::find(plan.variants.begin(), plan.variants.end(), cost.variant) - plan.variants.begin();
        KernelStats& kernel = stats.kernels[static_cast<size_t>(at)];
        kernel.launches += cost.launches;
        kernel.seconds += cost.seconds;
        kernel.longest = std::max(kernel.longest, cost.longest);
    }
}

void add(const Plan& plan, const Measured& measured, RenderStats& stats) {
    const Measured::Share all = measured.all_shares();
    stats.pixels = all.pixels;
    stats.hits = all.hits;
    for (size_t i = 0; i < plan.variants.size(); ++i) {
        KernelStats& kernel = stats.kernels[i];
        if (measured.launches[i] == 0) continue;
        kernel.launches = measured.launches[i];
        kernel.seconds = measured.seconds[i];
        kernel.longest = measured.longest[i];
        const int64_t lights = lights_of(plan, i);
        kernel.rays = lights > 0 ? lights * stats.hits : stats.pixels;
    }
    stats.rays = rays_of(plan, stats.pixels, stats.hits);
}

/// What the device did or, where its cores are apart, each of them.
std::vector<DeviceShare> shares_of(const DeviceInfo& device, const Plan& plan, const Measured& measured,
                                   double seconds) {
    const auto share_of = [&](const DeviceInfo& who, const Measured::Share& its) {
        return DeviceShare{who, its.tiles, rays_of(plan, its.pixels, its.hits), seconds};
    };
    const auto parts = static_cast<int>(measured.shares.size());
    if (!device.cores_apart || parts == 1) return {share_of(device, measured.all_shares())};
    std::vector<DeviceShare> shares;
    for (const Measured::Share& its : measured.shares)
        shares.push_back(share_of(device.part_of(parts, static_cast<int>(shares.size())), its));
    return shares;
}

}  // namespace

RenderStats planned(const Plan& plan, const Scene& scene) {
    RenderStats stats;
    stats.accuracy = plan.accuracy;
    stats.lanes = plan.lanes;
    stats.packets = plan.packets;
    stats.tiles = static_cast<int>(plan.tiles.size());
    stats.workers = plan.workers;
    stats.tile_rays = int64_t{plan.tile_blocks} * BLOCK_RAYS;
    stats.planned_bytes = plan.memory.peak_bytes;
    stats.pixels = int64_t{plan.image.width} * plan.image.height;
    stats.spheres = plan.spheres;
    stats.lights = static_cast<int64_t>(scene.lights.size());
    return stats;
}

DeviceRenderer::DeviceRenderer(const DeviceInfo& info)
    : info_(info),
      workers_(info),
      programs_(workers_.context(), workers_.devices(), info),
      memory_(workers_.context(), info.shares_memory),
      pace_(most_items(info)),
      core_pace_(most_items(info)) {}

RenderStats DeviceRenderer::render(const Job& job, TileQueue& queue, Film& film) try {
    if (!job.options.same_spheres) still_.reset();
    const double start = now();
    RenderStats stats = planned(job.plan, job.scene);
    const std::vector<cl::Kernel> kernels = build(job, stats);
    if (const int most = group_limit(job.plan); most < job.plan.local_size) {
        const Plan plan = in_smaller_groups(job, most);
        return render({job.scene, job.survey, job.frame, plan, job.options}, queue, film);
    }
    stats.build_seconds = now() - start;
    make_room(job.plan);
    for (Pace* pace : {&pace_, &core_pace_}) pace->expect(job.options.longest_launch, job.plan.spheres);
    run(job, kernels, queue, film, stats);
    stats.peak_bytes = memory_.peak();
    stats.warnings = programs_.take_warnings();
    for (const KernelStats& kernel : stats.kernels)
        stats.longest_launch = std::max(stats.longest_launch, kernel.longest);
    if (job.plan.memory.cut) still_.reset();
    return stats;
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), info_.number() + " " + info_.name,
                "a smaller --size or --tile, or another --device, may help");
}

/// The most work-items that a group of any kernel of the tiles' may have.
int DeviceRenderer::group_limit(const Plan& plan) {
    int most = plan.local_size;
    for (const Step& step : plan.steps)
        most = std::min(most, programs_.get(plan.variants[static_cast<size_t>(step.variant)]).group_limit);
    return most;
}

/// The plan for groups of `most` work-items at most, and the same tiles.
Plan DeviceRenderer::in_smaller_groups(const Job& job, int most) const {
    DeviceLimits limits(info_);
    limits.max_work_group = static_cast<uint64_t>(most);
    limits.shares_memory = limits.shares_memory && job.plan.write_in_place;
    Plan plan = make_plan(job.scene, job.survey, job.options, limits);
    plan.tiles = job.plan.tiles;
    plan.tile_blocks = job.plan.tile_blocks;
    plan.shares_tiles = job.plan.shares_tiles;
    return plan;
}

/// What earlier pictures left and this one does not use would stand in its way.
void DeviceRenderer::make_room(const Plan& plan) {
    tiles_.keep_for(plan);
    if (!plan.certified)
        for (TilePool* pool : {&single_tiles_, &refined_tiles_}) pool->clear();
    memory_.expect(plan.memory.peak_bytes, plan.memory.cut);
}

std::vector<cl::Kernel> DeviceRenderer::build(const Job& job, RenderStats& stats) {
    const std::vector<Variant>& variants = job.plan.variants;
    std::vector<bool> known;
    for (const Variant& variant : variants) known.push_back(programs_.has(variant));
    programs_.build(variants, job.options.stop);
    std::vector<cl::Kernel> kernels;
    for (size_t i = 0; i < variants.size(); ++i) {
        const BuiltKernel& built = programs_.get(variants[i]);
        kernels.push_back(built.kernel);
        stats.kernels.push_back({info_.number(), to_string(variants[i].kernel), built.options,
                                 known[i] ? 0 : built.build_seconds, built.from_cache, 0, 0, 0, 0});
    }
    return kernels;
}

/// The spheres' rows, or just one, for the albedo if all have the same, where the scene is cut.
DeviceRenderer::Rows DeviceRenderer::upload_rows(const Job& job) {
    Rows rows{sphere_rows(job.scene, job.frame, 0, job.plan.memory.cut ? 1 : job.survey.count), {}, {}};
    rows.buffers = upload(memory_, rows.rows);
    rows.albedos = albedos_of(memory_, rows.rows, rows.buffers);
    if (job.plan.memory.cut) rows.albedos.stride = 0;
    return rows;
}

/// What is the same for all pencils, and for frames in which the spheres stay.
const DeviceRenderer::Still& DeviceRenderer::still_spheres(const Job& job, SphereKernels& kernels) {
    if (still_ && still_->frame == job.frame) return *still_;
    still_.reset();
    Still made{job.survey, job.frame, upload_rows(job), {}};
    if (job.plan.flat())
        made.clusters = few_clusters(made.rows.rows);
    else if (!job.plan.memory.cut)
        made.clusters = kernels.gather(made.rows.buffers, job.survey, job.frame);
    return still_.emplace(std::move(made));
}

void DeviceRenderer::run(const Job& job, const std::vector<cl::Kernel>& kernels, TileQueue& queue, Film& film,
                         RenderStats& stats) {
    const double start = now();
    // So many spheres that they come in chunks make a launch that is the first to touch memory ten times as long.
    constexpr int parts_of_chunks = 16;
    Launcher launcher(workers_.whole(), programs_, pace_, workers_.units(1), job.options.stop,
                      job.plan.memory.cut ? parts_of_chunks : 1);
    SphereKernels sphere_kernels(memory_, launcher, job.plan);
    const Still& spheres = still_spheres(job, sphere_kernels);
    std::optional<ChunkedSpheres> chunks;
    if (job.plan.memory.by_view)
        chunks.emplace(memory_, sphere_kernels, launcher, job.scene, job.survey, job.frame, job.plan,
                       &spheres.clusters);
    SceneBuffers buffers =
        prepare(sphere_kernels, job.scene, job.survey, job.frame, chunks ? nullptr : &spheres.clusters, job.plan);
    buffers.albedos = spheres.rows.albedos;
    if (chunks) launcher.finish();
    const std::vector<cl::Event> ready = launcher.last();
    const double asked_at = now();
    Scheduler scheduler(workers_, memory_, job.plan, buffers, tiles_.get(memory_, job.plan), kernels,
                        job.plan.workers > 1 ? core_pace_ : pace_, job.options.stop, film);
    if (chunks) scheduler.take_spheres_from(*chunks);
    const Measured run = scheduler.run(queue, ready, job.options.progress);
    add(job.plan, run, stats);
    double prepared_at = asked_at;
    for (const cl::Event& end : ready) prepared_at = std::max(prepared_at, asked_at + seconds_since_asked(end));
    add(job.plan, launcher.take_costs(), stats);
    stats.chunks = chunks ? chunks->chunks() : 1;
    stats.prepare_seconds = prepared_at - start;
    if (!run.undecided.empty()) decide_again(job, spheres, buffers, run.undecided, film, stats);
    stats.trace_seconds = now() - prepared_at;
    stats.shares = shares_of(info_, job.plan, run, stats.trace_seconds);
}

/// In float once more, where a hierarchy was walked down: how far work-items got, whose size is the device's, has a say
/// in what they left open. A ray alone leaves fewer open, the same ones on every device.
std::vector<int> DeviceRenderer::open_alone(const Job& job, const SceneBuffers& buffers, const std::vector<int>& pixels,
                                            Film& film, RenderStats& stats) {
    if (job.plan.flat()) return pixels;
    const Plan plan = make_refinement_plan(job.plan, job.scene, Accuracy::certified);
    Refinement alone(workers_, memory_, programs_, pace_, job.options.stop, plan, buffers,
                     single_tiles_.get(memory_, plan).front(), film);
    const std::vector<int> left = alone.refine(pixels, {});
    stats.longest_launch = std::max(stats.longest_launch, alone.longest_launch());
    return left;
}

/// In double; returns those that even that leaves open.
std::vector<int> DeviceRenderer::refine(const Job& job, const Still& spheres, const std::vector<int>& pixels,
                                        Film& film, RenderStats& stats) {
    const Plan plan = make_refinement_plan(job.plan, job.scene, Accuracy::full);
    Launcher launcher(workers_.whole(), programs_, pace_, workers_.units(1), job.options.stop);
    SphereKernels kernels(memory_, launcher, plan);
    SceneBuffers buffers = prepare(kernels, job.scene, job.survey, job.frame, &spheres.clusters, plan);
    buffers.albedos = spheres.rows.albedos;
    Refinement refinement(workers_, memory_, programs_, pace_, job.options.stop, plan, buffers,
                          refined_tiles_.get(memory_, plan).front(), film);
    const std::vector<int> left = refinement.refine(pixels, launcher.last());
    stats.longest_launch = std::max(stats.longest_launch, refinement.longest_launch());
    for (const Launcher::Cost& cost : launcher.take_costs())
        stats.longest_launch = std::max(stats.longest_launch, cost.longest);
    return left;
}

/// In double where the device has it, and exactly what is left.
void DeviceRenderer::decide_again(const Job& job, const Still& spheres, const SceneBuffers& buffers,
                                  const std::vector<int>& pixels, Film& film, RenderStats& stats) {
    const double start = now();
    std::vector<int> left = open_alone(job, buffers, pixels, film, stats);
    stats.undecided = static_cast<int64_t>(left.size());
    if (info_.fp64 && !left.empty()) left = refine(job, spheres, left, film, stats);
    stats.decided_exactly = static_cast<int64_t>(left.size());
    decide_exactly(job.scene, job.options.shadows, left, job.frame.unit, film, job.options.stop);
    stats.decide_seconds = now() - start;
}

}  // namespace gnomon
