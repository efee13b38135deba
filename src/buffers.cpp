#include "buffers.h"

#include <algorithm>

namespace gnomon {

namespace {

/// What one light needs, whichever kind it is.
struct PrepareLight {
    SphereKernels& kernels;
    const Scene& scene;
    const Survey& survey;
    const Frame& frame;
    const ClusterBuffers* spheres;
    bool shadows;

    LightBuffers operator()(const DirectionalLight& light) const {
        return with_spheres(parallel_pencil(light), lambert_factor(light, frame.unit));
    }
    LightBuffers operator()(const PointLight& light) const {
        return with_spheres(point_pencil(light, scene.camera, survey, frame), lambert_factor(light, frame.unit));
    }

  private:
    template <class Pencil>
    LightBuffers with_spheres(const Pencil& pencil, const Float3& phi) const {
        LightBuffers buffers{pencil, phi, {}};
        if (shadows && spheres) buffers.spheres = kernels.project(*spheres, view_of(pencil, scene.camera, frame));
        return buffers;
    }
};

TileBuffers allocate_tile(const DeviceMemory& memory, const Plan& plan) {
    const int64_t rays = int64_t{plan.tile_blocks} * BLOCK_RAYS;
    const auto values = [&](int64_t count) { return memory.room<float>(count); };
    TileBuffers tile;
    tile.dirs = values(3 * rays);
    tile.ts = values(rays);
    tile.normals = values(3 * rays);
    tile.ids = values(rays);
    // Kernel arguments that a scene does not use still have to name a buffer.
    tile.arrival = values(plan.uses(Kernel::intersect_shadow) ? rays : 1);
    tile.radiance = values(plan.uses(Kernel::shade_light) ? 3 * rays : 1);
    tile.doubts = values(plan.certified ? 2 * rays : 1);
    tile.albedos = values(plan.albedos_of_rays ? 3 * rays : 1);
    if (!plan.write_in_place)
        for (cl::Buffer& plane : tile.planes) plane = values(rays);
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
    SceneBuffers buffers;
    buffers.eye = eye_pencil(scene.camera, scene.image);
    buffers.eye_basis = eye_basis(scene.camera);
    buffers.base_doubt = base_doubt(scene, survey, frame);
    if (spheres) buffers.spheres = kernels.project(*spheres, view_of_eye(scene.camera, frame));
    if (!plan.uses(Kernel::shade_light)) return buffers;
    const PrepareLight prepared{kernels, scene, survey, frame, spheres, plan.shadows != Shadows::off};
    for (const Light& light : scene.lights) buffers.lights.push_back(std::visit(prepared, light));
    return buffers;
}

std::vector<TileBuffers>& TilePool::get(const DeviceMemory& memory, const Plan& plan) {
    const size_t count = std::min<size_t>(plan.memory.by_view ? 1 : tile_sets, plan.tiles.size()),
                 rays = static_cast<size_t>(plan.tile_blocks);
    const std::array<size_t, 6> shape{count, rays,
                                      plan.uses(Kernel::intersect_shadow) + size_t{2} * plan.uses(Kernel::shade_light),
                                      size_t{plan.write_in_place}, size_t{plan.albedos_of_rays}, size_t{plan.certified}};
    if (shape == shape_) return tiles_;
    shape_ = {};  // of no plan, in case an allocation throws
    tiles_.clear();
    for (size_t i = 0; i < count; ++i) tiles_.push_back(allocate_tile(memory, plan));
    shape_ = shape;
    return tiles_;
}

}  // namespace gnomon
