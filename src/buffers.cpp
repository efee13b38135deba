#include "buffers.h"

#include <algorithm>

namespace gnomon {

namespace {

template <class T>
cl::Buffer constant(const cl::Context& context, const std::vector<T>& values) {
    // The binding takes what it copies from as not const.
    return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(T),
                      const_cast<T*>(values.data()));
}

SphereBuffers spheres_of(const cl::Context& context, const PencilSpheres& spheres) {
    SphereBuffers buffers{constant(context, spheres.clusters), {}, spheres.levels, spheres.last()};
    if (spheres.levels > 0) buffers.nodes = constant(context, spheres.nodes);
    return buffers;
}

std::vector<Float3> albedos_of(const std::vector<Sphere>& spheres) {
    std::vector<Float3> albedos;
    albedos.reserve(spheres.size());
    for (const Sphere& s : spheres)
        albedos.push_back(
            {static_cast<float>(s.albedo.r), static_cast<float>(s.albedo.g), static_cast<float>(s.albedo.b)});
    return albedos;
}

/// Fills one light's buffers, whichever kind it is.
struct LightUpload {
    const cl::Context& context;
    const Scene& scene;
    const Hierarchy& hierarchy;
    bool shadows;

    LightBuffers operator()(const DirectionalLight& light) const {
        const ParallelPencil pencil = parallel_pencil(light);
        LightBuffers buffers{pencil, lambert_factor(light), {}};
        if (shadows) buffers.spheres = spheres_of(context, seen_along(pencil, scene.camera, hierarchy));
        return buffers;
    }
    LightBuffers operator()(const PointLight& light) const {
        const PointPencil pencil = point_pencil(light, scene.camera);
        LightBuffers buffers{pencil, lambert_factor(light), {}};
        if (shadows) buffers.spheres = spheres_of(context, seen_from_point(pencil, scene.camera, hierarchy));
        return buffers;
    }
};

TileBuffers allocate_tile(const cl::Context& context, const Plan& plan) {
    const size_t rays = static_cast<size_t>(plan.tile_blocks) * BLOCK_RAYS;
    const auto values = [&](size_t count) { return cl::Buffer(context, CL_MEM_READ_WRITE, count * sizeof(float)); };
    TileBuffers tile;
    tile.dirs = values(3 * rays);
    tile.ts = values(rays);
    tile.normals = values(3 * rays);
    tile.ids = values(rays);
    // Kernel arguments that a scene does not use still have to name a buffer.
    tile.arrival = values(plan.uses(Kernel::intersect_shadow) ? rays : 1);
    tile.radiance = values(plan.uses(Kernel::shade_light) ? 3 * rays : 1);
    if (!plan.write_in_place)
        for (cl::Buffer& plane : tile.planes) plane = values(rays);
    return tile;
}

}  // namespace

SceneBuffers upload(const cl::Context& context, const Scene& scene, const Hierarchy& hierarchy, const Plan& plan) {
    SceneBuffers buffers;
    buffers.eye = eye_pencil(scene.camera, scene.image);
    buffers.spheres = spheres_of(context, seen_from_eye(scene.camera, hierarchy));
    if (!plan.uses(Kernel::shade_light)) return buffers;
    buffers.albedos = constant(context, albedos_of(scene.spheres));
    for (const Light& light : scene.lights)
        buffers.lights.push_back(
            std::visit(LightUpload{context, scene, hierarchy, plan.shadows != Shadows::off}, light));
    return buffers;
}

std::vector<TileBuffers>& TilePool::get(const cl::Context& context, const Plan& plan) {
    const size_t count = std::min<size_t>(tile_sets, plan.tiles.size()), rays = static_cast<size_t>(plan.tile_blocks);
    const std::array<size_t, 4> shape{count, rays,
                                      plan.uses(Kernel::intersect_shadow) + size_t{2} * plan.uses(Kernel::shade_light),
                                      size_t{plan.write_in_place}};
    if (shape == shape_) return tiles_;
    shape_ = {};  // of no plan, in case an allocation throws
    tiles_.clear();
    for (size_t i = 0; i < count; ++i) tiles_.push_back(allocate_tile(context, plan));
    shape_ = shape;
    return tiles_;
}

}  // namespace gnomon
