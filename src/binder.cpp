#include "binder.h"

#include <algorithm>

#include "film_planes.h"

namespace gnomon {

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

std::vector<cl::Buffer> Binder::planes() const {
    std::vector<cl::Buffer> all;
    for (const std::vector<cl::Buffer>& of_one : planes_) all.insert(all.end(), of_one.begin(), of_one.end());
    return all;
}

void Binder::bind(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    switch (launch.step.kernel) {
        case Kernel::generate_rays:
            Arguments(kernel).add(scene_.eye, launch.tile, plan_.items(launch.step.kernel, launch.tile), b.dirs);
            break;
        case Kernel::intersect_closest:
            Arguments(kernel)
                .add_if(plan_.generate_rays, b.dirs)
                .add(launch.spheres->clusters, launch.spheres->nodes, b.positions, b.normals, b.ids)
                .add_if(plan_.all_hits, b.ts)
                .add_if(plan_.boxes, b.boxes)
                .add(hit_counts_)
                .add_if(plan_.certified, undecided_.doubts(), undecided_.words())
                .add(scene_.eye, scene_.eye_basis, pass(launch));
            break;
        case Kernel::intersect_shadow:
            hits(kernel, launch)
                .add(launch.spheres->clusters, launch.spheres->nodes, b.arrivals, light(launch).pencil, pass(launch));
            break;
        case Kernel::shade_light:
            bind_shade_light(kernel, launch);
            break;
        case Kernel::resolve:
            bind_resolve(kernel, launch);
            break;
        default:  // the kernels before the tiles are no steps
            break;
    }
}

void Binder::bind_shade_light(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    Arguments arguments = hits(kernel, launch);
    arguments.add_if(plan_.shadows != Shadows::off, b.arrivals)
        .add(launch.spheres->clusters, launch.spheres->nodes)
        .add(albedos(launch).values, b.radiance);
    if (!plan_.resolve_radiance) arguments.add(plane(launch, 0), plane(launch, 1), plane(launch, 2));
    arguments.add(light(launch).pencil, pass(launch), shading(launch));
}

/// What intersect_closest wrote, which kernels take first (HITS_GIVEN in cl/receivers.h).
Arguments Binder::hits(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    Arguments arguments(kernel);
    arguments.add(b.positions, b.normals, b.ids)
        .add_if(plan_.boxes, b.boxes)
        .add_if(plan_.certified, undecided_.doubts(), undecided_.words());
    return arguments;
}

void Binder::bind_resolve(cl::Kernel& kernel, const TileLaunch& launch) const {
    const TileBuffers& b = launch.buffers;
    const Output output = launch.step.output;
    const cl::Buffer* const sources[] = {&b.radiance, &b.ts, &b.normals, &b.ids};
    const int components = output == Output::radiance || output == Output::normal ? 3 : 1;
    Arguments(kernel).add(*sources[static_cast<size_t>(output)], components, launch.tile, shape_of_planes(launch.tile),
                          plan_.items(Kernel::resolve, launch.tile), plane(launch, 0), plane(launch, 1),
                          plane(launch, 2));
}

const LightBuffers& Binder::light(const TileLaunch& launch) const {
    return scene_.lights[static_cast<size_t>(launch.step.light)];
}

AlbedoBuffer Binder::albedos(const TileLaunch& launch) const {
    return plan_.albedos_of_rays ? AlbedoBuffer{launch.buffers.albedos, 0, 0} : scene_.albedos;
}

Pass Binder::pass(const TileLaunch& launch) const {
    return {launch.tile,          plan_.items(launch.step.kernel, launch.tile),
            launch.first_block,   launch.spheres->levels,
            launch.spheres->last, launch.first_chunk ? 1 : 0,
            launch.step.arrival,  plan_.group_depth,
            scene_.base_doubt};
}

Either<ShadingOf> Binder::shading(const TileLaunch& launch) const {
    const Step& step = launch.step;
    const AlbedoBuffer its = albedos(launch);
    return with_real(plan_.accuracy, [&](auto real) -> Either<ShadingOf> {
        ShadingOf<decltype(real)> shading{};
        for (size_t i = 0; i < step.shaded.size(); ++i)
            shading.phi[i] = std::get<Real3Of<decltype(real)>>(scene_.lights[static_cast<size_t>(step.shaded[i])].phi);
        shading.first_albedo = its.first;
        shading.albedo_stride = its.stride;
        shading.first = step.first ? 1 : 0;
        shading.last = step.resolves ? 1 : 0;
        shading.planes = shape_of_planes(launch.tile);
        return shading;
    });
}

Planes Binder::shape_of_planes(const Tile& tile) const {
    if (plan_.write_in_place) return {film_.width, film_.height, 0, 0, film_.width};
    return {film_.width, film_.height, tile.x, tile.y, tile.blocks_x * BLOCK_SIDE};
}

const cl::Buffer& Binder::plane(const TileLaunch& launch, size_t c) const {
    if (!plan_.write_in_place) return launch.buffers.planes[c];
    const std::vector<cl::Buffer>& all = planes_[static_cast<size_t>(launch.step.output)];
    return all[std::min(c, all.size() - 1)];
}

}  // namespace gnomon
