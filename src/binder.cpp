#include "binder.h"

#include <algorithm>

namespace gnomon {

std::vector<std::pair<void*, size_t>> planes_of(Film& film, Output output) {
    std::vector<std::pair<void*, size_t>> planes;
    const auto add = [&](auto& plane) { planes.emplace_back(plane.data(), plane.bytes()); };
    switch (output) {
        case Output::radiance:
            std::for_each(std::begin(film.radiance), std::end(film.radiance), add);
            break;
        case Output::distance:
            add(film.distance);
            break;
        case Output::normal:
            std::for_each(std::begin(film.normal), std::end(film.normal), add);
            break;
        case Output::id:
            add(film.id);
            break;
    }
    return planes;
}

Binder::Binder(const cl::Context& context, const Plan& plan, const SceneBuffers& scene, Film& film,
               const cl::Buffer& hit_counts, const UndecidedRays& undecided)
    : plan_(plan), scene_(scene), film_(film), hit_counts_(hit_counts), undecided_(undecided) {
    if (!plan.write_in_place) return;
    for (const Step& step : plan.steps)
        if (step.kernel == Kernel::resolve || step.resolves)
            for (const auto& [data, bytes] : planes_of(film, step.output))
                planes_[static_cast<size_t>(step.output)].emplace_back(context, CL_MEM_WRITE_ONLY | CL_MEM_USE_HOST_PTR,
                                                                       bytes, data);
}

void Binder::bind(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    const int items = plan_.items(launch.step.kernel, launch.tile);
    switch (launch.step.kernel) {
        case Kernel::generate_rays:
            return set_arguments(kernel, scene_.eye, launch.tile, items, b.dirs);
        case Kernel::intersect_closest:
            return set_arguments(kernel, b.dirs, scene_.eye, launch.tile, scene_.eye_basis, launch.spheres->clusters,
                                 launch.spheres->nodes, launch.spheres->levels, launch.spheres->last,
                                 launch.first_chunk ? 1 : 0, items, b.ts, b.normals, b.ids, launch.first_block,
                                 hit_counts_, base_doubt(), undecided_.doubts(), undecided_.words(),
                                 UndecidedRays::first_word(launch.first_block));
        case Kernel::intersect_shadow:
        case Kernel::shade_light:
            return bind_light(kernel, launch, items);
        case Kernel::resolve:
            return bind_resolve(kernel, launch);
        default:  // the kernels before the tiles are no steps
            break;
    }
}

void Binder::bind_light(cl::Kernel& kernel, const TileLaunch& launch, int items) const {
    const TileBuffers& b = launch.buffers;
    const LightBuffers& light = scene_.lights[static_cast<size_t>(launch.step.light)];
    const SphereBuffers& s = *launch.spheres;
    const AlbedoBuffer of_rays{b.albedos, 0, 0};
    const AlbedoBuffer& albedos = plan_.albedos_of_rays ? of_rays : scene_.albedos;
    const auto with = [&](const auto& pencil) {
        if (launch.step.kernel == Kernel::intersect_shadow)
            set_arguments(kernel, b.dirs, b.ts, b.normals, b.ids, s.clusters, s.nodes, s.levels, s.last,
                          launch.first_chunk ? 1 : 0, plan_.group_depth, pencil, items, b.arrival);
        else
            set_arguments(kernel, b.dirs, b.ts, b.normals, b.ids, b.arrival, s.clusters, s.nodes, s.levels, s.last,
                          plan_.group_depth, albedos.values, albedos.first, albedos.stride, pencil, light.phi,
                          launch.step.first ? 1 : 0, items, b.radiance, launch.step.resolves ? 1 : 0, launch.tile,
                          shape_of_planes(launch.tile), plane(launch, 0), plane(launch, 1), plane(launch, 2),
                          base_doubt(), undecided_.doubts(), undecided_.words(),
                          UndecidedRays::first_word(launch.first_block));
    };
    std::visit(with, light.pencil);
}

void Binder::bind_resolve(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    const Output output = launch.step.output;
    const cl::Buffer* const sources[] = {&b.radiance, &b.ts, &b.normals, &b.ids};
    const int components = output == Output::radiance || output == Output::normal ? 3 : 1;
    set_arguments(kernel, *sources[static_cast<size_t>(output)], components, launch.tile, shape_of_planes(launch.tile),
                  plan_.items(Kernel::resolve, launch.tile), plane(launch, 0), plane(launch, 1), plane(launch, 2));
}

std::variant<float, double> Binder::base_doubt() const {
    if (computes_in_double(plan_.accuracy)) return static_cast<double>(scene_.base_doubt);
    return scene_.base_doubt;
}

Planes Binder::shape_of_planes(const Tile& tile) const {
    if (plan_.write_in_place) return {film_.width, film_.height, 0, 0, film_.width};
    return {film_.width, film_.height, tile.x, tile.y, tile.blocks_x * BLOCK_SIDE};
}

const cl::Buffer& Binder::plane(const TileLaunch& launch, size_t c) const {
    if (!plan_.write_in_place) return launch.buffers.planes[c];
    const std::vector<cl::Buffer>& all = planes(launch.step.output);
    return all.empty() ? launch.buffers.ids : all[std::min(c, all.size() - 1)];
}

}  // namespace gnomon
