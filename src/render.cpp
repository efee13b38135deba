#include "render.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "certify.h"
#include "clock.h"
#include "error.h"
#include "program.h"
#include "refine.h"
#include "scheduler.h"

namespace gnomon {

namespace {

template <class T>
void fill(Plane<T>& plane, T value) {
    std::fill(plane.begin(), plane.end(), value);
}

/// The planes that no step resolves: nothing was hit, or no light shines.
void fill_untouched(Film& film, const Plan& plan) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (!plan.uses(Kernel::shade_light))
        for (auto& plane : film.radiance) fill(plane, 0.0f);
    if (!plan.steps.empty()) return;
    fill(film.distance, infinity);
    for (auto& plane : film.normal) fill(plane, infinity);
    fill(film.id, -1);
}

bool fits(const Film& film, const ImageSize& image, const Outputs& outputs) {
    return film.width == image.width && film.height == image.height && !film.radiance[0].empty() == outputs.radiance &&
           !film.distance.empty() == outputs.distance && !film.normal[0].empty() == outputs.normal &&
           !film.id.empty() == outputs.id;
}

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

/// How often each variant's kernel was given all the hits: once a light.
int64_t lights_of(const Plan& plan, size_t variant) {
    return std::count_if(plan.steps.begin(), plan.steps.end(), [&](const Step& step) {
        return static_cast<size_t>(step.variant) == variant && step.light >= 0;
    });
}

/// One launch of shade_light for each light that shines.
int64_t shaded_lights(const Plan& plan) {
    return std::count_if(plan.steps.begin(), plan.steps.end(),
                         [](const Step& step) { return step.kernel == Kernel::shade_light; });
}

}  // namespace

namespace {

/// What is to be rendered.
struct Job {
    const Scene& scene;
    const Survey& survey;
    const Frame& frame;
    const Plan& plan;
    const RenderOptions& options;
};

/// The spheres' rows on the device, and what they lie in.
struct Rows {
    SphereRows rows;
    RowBuffers buffers;
    AlbedoBuffer albedos;
};

/// The spheres on the device.
struct Still {
    Survey survey;
    Frame frame;
    Rows rows;
    ClusterBuffers clusters;  // unless the scene is cut
};

}  // namespace

struct Renderer::State {
    DeviceInfo info;
    Workers workers;
    Programs programs;
    DeviceMemory memory;
    TilePool tiles, refined_tiles;
    std::optional<Still> still;  // of the last picture

    explicit State(const DeviceInfo& i)
        : info(i),
          workers(i),
          programs(workers.context(), workers.devices(), i),
          memory(workers.context(), i.shares_memory),
          tiles(),
          refined_tiles() {}

    std::vector<cl::Kernel> build(const Plan& plan, RenderStats& stats) {
        std::vector<cl::Kernel> kernels;
        for (const Variant& variant : plan.variants) {
            const bool known = programs.has(variant);
            const BuiltKernel& built = programs.get(variant);
            kernels.push_back(built.kernel);
            stats.kernels.push_back(
                {to_string(variant.kernel), built.options, known ? 0 : built.build_seconds, built.from_cache, 0, 0, 0});
        }
        return kernels;
    }

    /// The spheres' rows, or just one, for the albedo if all have the same, where the scene is cut.
    Rows upload_rows(const Job& job) {
        Rows rows{sphere_rows(job.scene, job.frame, 0, job.plan.memory.cut ? 1 : job.survey.count), {}, {}};
        rows.buffers = upload(memory, rows.rows);
        rows.albedos = albedos_of(memory, rows.rows, rows.buffers);
        if (job.plan.memory.cut) rows.albedos.stride = 0;
        return rows;
    }

    /// What is the same for all pencils, and for frames in which the spheres stay.
    const Still& still_spheres(const Job& job, SphereKernels& kernels) {
        if (still && still->frame == job.frame) return *still;
        still.reset();
        Still made{job.survey, job.frame, upload_rows(job), {}};
        if (!job.plan.memory.cut) made.clusters = kernels.gather(made.rows.buffers, job.survey, job.frame);
        return still.emplace(std::move(made));
    }

    static void add(const Plan& plan, const std::vector<Launcher::Launched>& launched, RenderStats& stats) {
        for (const Launcher::Launched& l : launched) {
            const auto at = std::find(plan.variants.begin(), plan.variants.end(), l.variant) - plan.variants.begin();
            KernelStats& kernel = stats.kernels[static_cast<size_t>(at)];
            kernel.launches += 1;
            kernel.seconds += seconds_of(l.event);
        }
    }

    /// From the spheres to the film.
    void run(const Job& job, const std::vector<cl::Kernel>& kernels, Film& film, RenderStats& stats) {
        const double start = now();
        Launcher launcher(workers.whole(), programs);
        SphereKernels sphere_kernels(memory, launcher, job.plan);
        const Still& spheres = still_spheres(job, sphere_kernels);
        std::optional<ChunkedSpheres> chunks;
        if (job.plan.memory.by_view)
            chunks.emplace(memory, sphere_kernels, launcher, job.scene, job.survey, job.frame, job.plan,
                           &spheres.clusters);
        SceneBuffers buffers =
            prepare(sphere_kernels, job.scene, job.survey, job.frame, chunks ? nullptr : &spheres.clusters, job.plan);
        buffers.albedos = spheres.rows.albedos;
        if (chunks) launcher.finish();
        const std::vector<cl::Event> ready = launcher.last();
        const double asked_at = now();
        Scheduler scheduler(workers, memory, job.plan, buffers, tiles.get(memory, job.plan), kernels, film);
        if (chunks) scheduler.take_spheres_from(*chunks);
        const Measured run = scheduler.run(ready, job.options.progress);
        measured(job.plan, run, stats);
        double prepared_at = asked_at;
        for (const cl::Event& end : ready) prepared_at = std::max(prepared_at, asked_at + seconds_since_asked(end));
        add(job.plan, launcher.take_launched(), stats);
        stats.chunks = chunks ? chunks->chunks() : 1;
        stats.prepare_seconds += prepared_at - start;
        if (!run.undecided.empty()) decide_again(job, spheres, run.undecided, film, stats);
        stats.trace_seconds = now() - prepared_at;
    }

    /// In double where the device has it, and exactly what is left.
    void decide_again(const Job& job, const Still& spheres, const std::vector<int>& pixels, Film& film,
                      RenderStats& stats) {
        stats.undecided = static_cast<int64_t>(pixels.size());
        const double start = now();
        std::vector<int> left = pixels;
        if (info.fp64) {
            const Plan plan = make_refinement_plan(job.plan, job.scene);
            Launcher launcher(workers.whole(), programs);
            SphereKernels kernels(memory, launcher, plan);
            SceneBuffers buffers = prepare(kernels, job.scene, job.survey, job.frame, &spheres.clusters, plan);
            buffers.albedos = spheres.rows.albedos;
            Refinement refinement(workers.context(), workers.whole(), memory, programs, plan, buffers,
                                  refined_tiles.get(memory, plan).front(), film);
            left = refinement.refine(pixels, launcher.last());
        }
        stats.decided_exactly = static_cast<int64_t>(left.size());
        decide_exactly(job.scene, job.options.shadows, left, job.frame.unit, film);
        stats.decide_seconds = now() - start;
    }

    static void measured(const Plan& plan, const Measured& measured, RenderStats& stats) {
        stats.hits = measured.hits;
        for (size_t i = 0; i < plan.variants.size(); ++i) {
            KernelStats& kernel = stats.kernels[i];
            if (measured.launches[i] == 0) continue;
            kernel.launches = measured.launches[i];
            kernel.seconds = measured.seconds[i];
            const int64_t lights = lights_of(plan, i);
            kernel.rays = lights > 0 ? lights * measured.hits : stats.pixels;
        }
        stats.rays = stats.pixels + (plan.shadows != Shadows::off ? shaded_lights(plan) * stats.hits : 0);
    }
};

Renderer::Renderer(const DeviceInfo& device) try : state_(std::make_unique<State>(device)) {
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), device.name);
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

RenderStats Renderer::render(const Scene& scene, const RenderOptions& options, Film& film) try {
    check_accuracy(options.accuracy, state_->info);
    const double start = now();
    std::optional<Still>& still = state_->still;
    if (!options.same_spheres) still.reset();
    const Survey spheres = still ? still->survey : survey(scene);
    const Frame frame = choose_frame(scene, spheres);
    const Plan plan = make_plan(scene, spheres, options, DeviceLimits(state_->info));
    RenderStats stats = planned(plan, scene);
    if (!fits(film, scene.image, options.outputs)) film = Film(scene.image.width, scene.image.height, options.outputs);
    fill_untouched(film, plan);
    if (plan.steps.empty()) return stats;
    stats.prepare_seconds = now() - start;
    const double planned_at = now();
    const std::vector<cl::Kernel> kernels = state_->build(plan, stats);
    stats.build_seconds = now() - planned_at;
    state_->memory.expect(plan.memory.peak_bytes, plan.memory.cut);
    state_->run({scene, spheres, frame, plan, options}, kernels, film, stats);
    stats.peak_bytes = state_->memory.peak();
    stats.warnings = state_->programs.take_warnings();
    if (plan.memory.cut) still.reset();
    if (frame.unit != 1)
        for (float& distance : film.distance) distance = static_cast<float>(distance * frame.unit);
    return stats;
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), state_->info.name,
                "a smaller --size or --tile, or another --device, may help");
} catch (const std::bad_alloc&) {
    throw Error(Blame::run, "out of memory", "", "render a smaller --size");
}

}  // namespace gnomon
