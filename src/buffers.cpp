#include "buffers.h"

#include <algorithm>

namespace gnomon {

namespace {

/// What one light needs, whichever kind it is.
template <class real>
struct PrepareLight {
    SphereKernels& kernels;
    const Scene& scene;
    const Survey& survey;
    const Frame& frame;
    const ClusterBuffers* spheres;
    bool shadows;

    LightBuffers operator()(const DirectionalLight& light) const {
        return with_spheres(parallel_pencil<real>(light), lambert_factor<real>(light, frame.unit));
    }
    LightBuffers operator()(const PointLight& light) const {
        return with_spheres(point_pencil<real>(light, scene.camera, survey, frame),
                            lambert_factor<real>(light, frame.unit));
    }

  private:
    template <class Pencil>
    LightBuffers with_spheres(const Pencil& pencil, const Real3Of<real>& phi) const {
        LightBuffers buffers{pencil, phi, {}};
        if (shadows && spheres) buffers.spheres = kernels.project(*spheres, view_of(pencil, scene.camera, frame));
        return buffers;
    }
};

template <class real>
SceneBuffers prepare_in(SphereKernels& kernels, const Scene& scene, const Survey& survey, const Frame& frame,
                        const ClusterBuffers* spheres, const Plan& plan) {
    SceneBuffers buffers;
    buffers.eye = eye_pencil<real>(scene.camera, scene.image);
    buffers.eye_basis = eye_basis(scene.camera);
    buffers.base_doubt = base_doubt(scene, survey, frame);
    if (spheres) buffers.spheres = kernels.project(*spheres, view_of_eye<real>(scene.camera, frame));
    if (!plan.uses(Kernel::shade_light)) return buffers;
    const PrepareLight<real> prepared{kernels, scene, survey, frame, spheres, plan.shadows != Shadows::off};
    for (const Light& light : scene.lights) buffers.lights.push_back(std::visit(prepared, light));
    return buffers;
}

TileBuffers allocate_tile(const DeviceMemory& memory, const Plan& plan) {
    const int64_t rays = int64_t{plan.tile_blocks} * BLOCK_RAYS;
    const auto reals = [&](int64_t count) {
        return with_real(plan.accuracy, [&](auto real) { return memory.room<decltype(real)>(count); });
    };
    TileBuffers tile;
    if (plan.generate_rays) tile.dirs = reals(3 * rays);
    tile.positions = reals(3 * rays);
    tile.normals = reals(3 * rays);
    tile.ids = memory.room<int>(rays);
    if (plan.all_hits) tile.ts = reals(rays);
    if (plan.boxes) tile.boxes = memory.room<HitsBox>(plan.tile_blocks);
    if (const int arrivals = plan.arrivals(); arrivals > 0) tile.arrivals = reals(arrivals * rays);
    if (plan.uses(Kernel::shade_light)) tile.radiance = reals(3 * rays);
    if (plan.albedos_of_rays) tile.albedos = memory.room<float>(3 * rays);
    if (!plan.write_in_place)
        for (cl::Buffer& plane : tile.planes) plane = memory.room<float>(rays);
    return tile;
}

}  // namespace

AlbedoBuffer albedos_of(const DeviceMemory& memory, const SphereRows& rows, const RowBuffers& buffers) {
    if (rows.columns == 7) return {buffers.rows, 4, 7};
    const float albedo[] = {static_cast<float>(rows.albedo.r), static_cast<float>(rows.albedo.g),
                            static_cast<float>(rows.albedo.b)};
    return {memory.copy(albedo, 3), 0, 0};
}

SceneBuffers prepare(SphereKernels& kernels, const Scene& scene, const Survey& survey, const Frame& frame,
                     const ClusterBuffers* spheres, const Plan& plan) {
    return with_real(plan.accuracy, [&](auto real) {
        return prepare_in<decltype(real)>(kernels, scene, survey, frame, spheres, plan);
    });
}

TilePool::Shape TilePool::shape_of(const Plan& plan) {
    return {static_cast<size_t>(plan.tile_sets),
            static_cast<size_t>(plan.tile_blocks),
            static_cast<size_t>(plan.arrivals()),
            size_t{plan.generate_rays},
            size_t{plan.all_hits},
            size_t{plan.boxes},
            size_t{plan.uses(Kernel::shade_light)},
            size_t{plan.write_in_place},
            size_t{plan.albedos_of_rays},
            static_cast<size_t>(real_bytes(plan.accuracy))};
}

void TilePool::clear() {
    shape_ = {};  // of no plan
    tiles_.clear();
}

void TilePool::keep_for(const Plan& plan) {
    if (shape_of(plan) != shape_) clear();
}

std::vector<TileBuffers>& TilePool::get(const DeviceMemory& memory, const Plan& plan) {
    keep_for(plan);
    if (!tiles_.empty()) return tiles_;
    for (int i = 0; i < plan.tile_sets; ++i) tiles_.push_back(allocate_tile(memory, plan));
    shape_ = shape_of(plan);
    return tiles_;
}

}  // namespace gnomon
