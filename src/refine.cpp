#include "refine.h"

#include <algorithm>

#include "arguments.h"
#include "certify.h"

namespace gnomon {

namespace {

/// What kernels wrote for a batch of rays, in block order, of the planes that the film has.
template <class real>
struct Traced {
    std::vector<real> ts, normals, radiance;
    std::vector<int> ids;
};

int blocks_of(int rays) { return (rays + BLOCK_RAYS - 1) / BLOCK_RAYS; }

/// Component c of n of ray k.
size_t at(int k, size_t c, size_t n) {
    const auto ray = static_cast<size_t>(k);
    return (ray / BLOCK_RAYS * n + c) * BLOCK_RAYS + ray % BLOCK_RAYS;
}

/// Of ray k; 0 where nothing was read.
template <class T>
T one(const std::vector<T>& values, int k) {
    return values.empty() ? T{0} : values[at(k, 0, 1)];
}
template <class real>
Vec3 three(const std::vector<real>& values, int k) {
    if (values.empty()) return {0, 0, 0};
    return {values[at(k, 0, 3)], values[at(k, 1, 3)], values[at(k, 2, 3)]};
}

template <class T>
void read(const cl::CommandQueue& queue, const std::vector<cl::Event>& after, const cl::Buffer& buffer, size_t count,
          std::vector<T>& values) {
    values.resize(count);
    queue.enqueueReadBuffer(buffer, CL_FALSE, 0, count * sizeof(T), values.data(), &after);
}

}  // namespace

Refinement::Refinement(const Workers& workers, const DeviceMemory& memory, Programs& programs, Pace& pace,
                       const Stop* stop, const Plan& plan, const SceneBuffers& scene, const TileBuffers& tile,
                       Film& film)
    : queue_(workers.whole()),
      units_(workers.units(1)),
      programs_(programs),
      pace_(pace),
      plan_(plan),
      scene_(scene),
      tile_(tile),
      film_(film),
      memory_(memory),
      hit_counts_(memory.room<int>(refinement_batch / BLOCK_RAYS)),
      undecided_(memory, plan, refinement_batch / BLOCK_RAYS),
      binder_(workers.context(), plan, scene, film, hit_counts_, undecided_),
      launches_(pace, stop, [this](int, int64_t, double seconds) { longest_ = std::max(longest_, seconds); }) {}

std::vector<int> Refinement::refine(const std::vector<int>& pixels, const std::vector<cl::Event>& after) {
    last_ = after;
    const auto all = static_cast<int>(pixels.size());
    const cl::Buffer places = memory_.copy(pixels.data(), all);
    std::vector<int> undecided;
    for (int first = 0; first < all; first += refinement_batch) {
        const int count = std::min(refinement_batch, all - first);
        trace(places, first, count);
        with_real(plan_.accuracy, [&](auto real) { write<decltype(real)>(pixels.data() + first, count, undecided); });
    }
    return undecided;
}

void Refinement::launch(const Step& step, const BuiltKernel& built, const cl::Kernel& kernel, int items) {
    KernelPace& pace = pace_.of(plan_.variants[static_cast<size_t>(step.variant)].name());
    const int local = std::min(plan_.local_size, built.group_limit);
    launches_.launch(queue_, {kernel, &pace, 0, items, local, units_}, last_);
}

void Refinement::trace(const cl::Buffer& places, int first, int count) {
    const int blocks = blocks_of(count);
    const Tile tile{0, 0, blocks, blocks};
    for (const Step& step : plan_.steps) {
        const BuiltKernel& built = programs_.get(plan_.variants[static_cast<size_t>(step.variant)]);
        cl::Kernel kernel = built.kernel;
        if (step.kernel == Kernel::refine_rays) {
            Arguments(kernel).add(scene_.eye, places, first, count, blocks * BLOCK_RAYS, tile_.dirs,
                                  undecided_.words());
            launch(step, built, kernel, blocks * BLOCK_RAYS);
            continue;
        }
        binder_.bind(kernel, {step, tile, tile_, 0, &scene_.seen_by(step.light)});
        launch(step, built, kernel, plan_.items(step.kernel, tile));
    }
}

template <class real>
void Refinement::write(const int* pixels, int count, std::vector<int>& undecided) {
    const int blocks = blocks_of(count);
    const auto rays = static_cast<size_t>(blocks) * BLOCK_RAYS;
    const bool shaded = plan_.uses(Kernel::shade_light);
    Traced<real> traced;
    if (!film_.distance.empty()) read(queue_, last_, tile_.ts, rays, traced.ts);
    if (!film_.normal[0].empty()) read(queue_, last_, tile_.normals, 3 * rays, traced.normals);
    if (!film_.id.empty()) read(queue_, last_, tile_.ids, rays, traced.ids);
    if (shaded && !film_.radiance[0].empty()) read(queue_, last_, tile_.radiance, 3 * rays, traced.radiance);
    for (const int ray : undecided_.read(queue_, last_, blocks)) undecided.push_back(pixels[ray]);
    queue_.finish();
    last_.clear();
    launches_.measure_all();
    for (int k = 0; k < count; ++k) {
        const Vec3 radiance = three(traced.radiance, k);
        put(film_, static_cast<size_t>(pixels[k]),
            {one(traced.ids, k), one(traced.ts, k), three(traced.normals, k), {radiance.x, radiance.y, radiance.z}});
    }
}

}  // namespace gnomon
