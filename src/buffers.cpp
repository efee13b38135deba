#include "buffers.h"

namespace gnomon {

namespace {

template <class T>
cl::Buffer constant(const cl::Context& context, std::vector<T> values) {
    return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(T), values.data());
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
    const std::vector<int>& ids;
    bool shadows;

    LightBuffers operator()(const DirectionalLight& light) const {
        const ParallelPencil pencil = parallel_pencil(light);
        LightBuffers buffers{pencil, lambert_factor(light), {}};
        if (shadows) buffers.spheres = constant(context, spheres_along(pencil, scene, ids));
        return buffers;
    }
    LightBuffers operator()(const PointLight& light) const {
        const PointPencil pencil = point_pencil(light, scene.camera);
        LightBuffers buffers{pencil, lambert_factor(light), {}};
        if (shadows) buffers.spheres = constant(context, spheres_from_point(pencil, scene, ids));
        return buffers;
    }
};

}  // namespace

SceneBuffers upload(const cl::Context& context, const Scene& scene, const std::vector<int>& ids, const Plan& plan) {
    SceneBuffers buffers;
    buffers.eye = eye_pencil(scene.camera, scene.image);
    buffers.sphere_count = static_cast<int>(ids.size());
    buffers.spheres = constant(context, spheres_from_eye(scene, ids));
    if (!plan.uses(Kernel::shade_light)) return buffers;
    buffers.albedos = constant(context, albedos_of(scene.spheres));
    for (const Light& light : scene.lights)
        buffers.lights.push_back(
            std::visit(LightUpload{context, scene, ids, plan.uses(Kernel::intersect_shadow)}, light));
    return buffers;
}

TileBuffers allocate_tile(const cl::Context& context, const Plan& plan) {
    const size_t rays = static_cast<size_t>(plan.tile_blocks) * BLOCK_RAYS;
    const auto values = [&](size_t count) { return cl::Buffer(context, CL_MEM_READ_WRITE, count * sizeof(float)); };
    TileBuffers tile;
    tile.dirs = values(3 * rays);
    tile.ts = values(rays);
    tile.normals = values(3 * rays);
    tile.ids = values(rays);
    tile.hit_counts = values(rays / static_cast<size_t>(plan.rays_per_item()));
    // Kernel arguments that a scene does not use still have to name a buffer.
    tile.lit = values(plan.uses(Kernel::intersect_shadow) ? rays : 1);
    tile.radiance = values(plan.uses(Kernel::shade_light) ? 3 * rays : 1);
    if (!plan.write_in_place)
        for (cl::Buffer& plane : tile.planes) plane = values(rays);
    return tile;
}

}  // namespace gnomon
