// intersect_shadow and shade_light alone, over hits that a test makes.
#pragma once

#include "arguments.h"
#include "guarded_spheres.h"
#include "kernel_harness.h"
#include "reference.h"

namespace gnomon::test {

/// Hits, as intersect_closest leaves them: at t dir from the eye.
struct Receivers {
    std::vector<Float3> dirs, normals;
    std::vector<float> ts;
    std::vector<int> ids;

    void add(Float3 dir, float t, Float3 normal, int id) {
        dirs.push_back(dir);
        ts.push_back(t);
        normals.push_back(normal);
        ids.push_back(id);
    }
    void add_miss(Float3 dir = {NAN, NAN, NAN}) { add(dir, INFINITY, {INFINITY, INFINITY, INFINITY}, -1); }
    /// What the reference sees from the eye, rounded.
    void see(const Scene& scene, Float3 dir) {
        const reference::Hit hit = reference::closest_hit(scene, {scene.camera.eye, to_double(dir)});
        add(dir, static_cast<float>(hit.t), to_float(hit.normal), hit.id);
    }
    /// From the eye, as intersect_closest rounds them.
    std::vector<Float3> positions() const {
        std::vector<Float3> all;
        for (size_t i = 0; i < size(); ++i) all.push_back({ts[i] * dirs[i].x, ts[i] * dirs[i].y, ts[i] * dirs[i].z});
        return all;
    }
    size_t size() const { return ids.size(); }
    /// Whole blocks: misses behind the last one.
    Receivers padded() const {
        Receivers all = *this;
        while (all.size() % BLOCK_RAYS != 0) all.add_miss();
        return all;
    }
    /// The hit that the kernels read, in double.
    reference::Hit hit(size_t i) const {
        const double t = static_cast<double>(ts[i]);
        return {t, ids[i], to_double(dirs[i]) * t, to_double(normals[i])};
    }
};

/// A light as the kernels are given it.
struct LightSetup {
    std::variant<ParallelPencil, PointPencil> pencil;
    PencilSpheres spheres;
    float group_depth;  ///< receivers that are traced together
    Float3 phi;
    std::string define;
};
inline LightSetup set_up(Bench& bench, const Scene& scene, const Light& light) {
    constexpr float group_depth = 1.1f;
    DeviceSpheres spheres(bench, scene);
    const auto seen = [&](const auto& pencil) { return spheres.seen(view_of(pencil, scene.camera, spheres.frame)); };
    if (const auto* lamp = std::get_if<PointLight>(&light)) {
        const PointPencil pencil = point_pencil(*lamp, scene.camera, spheres.survey, spheres.frame);
        return {pencil, seen(pencil), group_depth, lambert_factor(*lamp, 1), "LIGHT=LIGHT_POINT"};
    }
    const auto& sun = std::get<DirectionalLight>(light);
    const ParallelPencil pencil = parallel_pencil(sun);
    return {pencil, seen(pencil), group_depth, lambert_factor(sun, 1), "LIGHT=LIGHT_DIRECTIONAL"};
}
/// The same by brute force, all receivers of a work-item together.
inline LightSetup brute(LightSetup light) {
    light.spheres = brute(light.spheres);
    light.group_depth = INFINITY;
    return light;
}

/// The inputs of both kernels on the device.
struct HitBuffers {
    GuardedBuffer<float> positions, normals;
    GuardedBuffer<int> ids;
    GuardedBuffer<HitsBox> boxes;
    GuardedSpheres<float> spheres;

    HitBuffers(Bench& bench, const Receivers& hits, const LightSetup& light)
        : positions(bench, packed(hits.positions())),
          normals(bench, packed(hits.normals)),
          ids(bench, hits.ids),
          boxes(bench, boxes_around(packed(hits.positions()), hits.ids)),
          spheres(bench, light.spheres) {}
    /// The first arguments of a kernel that reads hits.
    Arguments given(cl::Kernel& kernel, bool with_boxes) const {
        Arguments arguments(kernel);
        arguments.add(positions.buffer(), normals.buffer(), ids.buffer()).add_if(with_boxes, boxes.buffer());
        return arguments;
    }
    void check_unchanged() const {
        positions.check_unchanged();
        normals.check_unchanged();
        ids.check_unchanged();
        boxes.check_unchanged();
        spheres.check_unchanged();
    }
};

/// Launches intersect_shadow over whole blocks of hits; checks guards and inputs.
inline std::vector<float> arrival(Bench& bench, Width w, const Receivers& hits, const LightSetup& light) {
    INFO(w);
    const HitBuffers in(bench, hits, light);
    const GuardedBuffer<float> result(bench, hits.size());
    const int items = static_cast<int>(hits.size()) / w.rays();
    const bool boxes = has_boxes(w, light.spheres.walk);
    const Variant variant{Kernel::intersect_shadow,
                          w.defines({light.define, "WALK=" + light.spheres.walk, "CHUNKS=0", define_boxes(boxes)})};
    cl::Kernel kernel = bench.programs.get(variant).kernel;
    in.given(kernel, boxes)
        .add(in.spheres.clusters.buffer(), in.spheres.nodes.buffer(), result.buffer())
        .add(light.pencil, Pass{{}, items, 0, light.spheres.levels, light.spheres.last, 1, 0, light.group_depth, 0},
             cl_int(0));
    bench.launch_bound(kernel, items);
    in.check_unchanged();
    return result.read();
}

/// By brute force, after checking that the hierarchy gives the same bits in all widths.
inline std::vector<float> arrival(Bench& bench, const Scene& scene, const Receivers& receivers, const Light& light) {
    const Receivers hits = receivers.padded();
    const LightSetup setup = set_up(bench, scene, light);
    const std::vector<float> result = arrival(bench, widths[0], hits, brute(setup));
    for (const Width& w : widths) {
        INFO(w);
        CHECK(same_bits(arrival(bench, w, hits, setup), result));
    }
    return result;
}

/// What shade_light is given besides.
struct ShadeSetup {
    std::string shadows = "SHADOWS_OFF";
    std::vector<float> arrivals;  ///< of the lights before this one and, for SHADOWS_READ, of this
    std::vector<float> radiance;  ///< before the launch
    bool first = false;
    Tile tile{};                        ///< of the hits, if planes follow
    ImageSize image{0, 0};              ///< which the launch is to resolve the radiance to, if it has a width
    std::vector<Float3> phis_before{};  ///< of lights that are added before this one
};

inline gnomon::Shading shading_of(const ShadeSetup& setup, const LightSetup& light) {
    gnomon::Shading shading{};
    std::copy(setup.phis_before.begin(), setup.phis_before.end(), shading.phi);
    shading.phi[setup.phis_before.size()] = light.phi;
    shading.albedo_stride = 3;
    shading.first = setup.first ? 1 : 0;
    shading.last = setup.image.width > 0 ? 1 : 0;
    shading.planes = {setup.image.width, setup.image.height, 0, 0, setup.image.width};
    return shading;
}

/// Launches shade_light over whole blocks of hits and returns the radiance; checks guards and inputs. With `arrived`
/// the pass ends with what arrives, in place of the first of the arrivals.
inline std::vector<float> shade(Bench& bench, Width w, const Scene& scene, const Receivers& hits,
                                const LightSetup& light, const ShadeSetup& shading,
                                std::vector<float>* resolved = nullptr, std::vector<float>* arrived = nullptr) {
    INFO(w << ", " << shading.shadows);
    std::vector<Float3> rho;
    for (const Sphere& s : scene.spheres) rho.push_back(to_float({s.albedo.r, s.albedo.g, s.albedo.b}));
    const HitBuffers in(bench, hits, light);
    const GuardedBuffer<Float3> albedos(bench, rho);
    const GuardedBuffer<float> arriving(bench, shading.arrivals.empty() ? sentinels<float>(1) : shading.arrivals);
    const GuardedBuffer<float> radiance(bench, shading.radiance);
    const Tile& tile = shading.tile;
    const int pairs = resolved ? (tile.blocks_x + 1) / 2 * (tile.blocks / tile.blocks_x) : 0;
    const int items = resolved ? pairs : static_cast<int>(hits.size()) / w.rays();
    const size_t pixels = std::max<size_t>(1, static_cast<size_t>(shading.image.width * shading.image.height));
    const GuardedBuffer<float> planes[] = {{bench, pixels}, {bench, pixels}, {bench, pixels}};
    const auto blocks = static_cast<int>(hits.size() / BLOCK_RAYS);
    const bool boxes = shading.shadows == "SHADOWS_TRACED" && has_boxes(w, light.spheres.walk);
    const Variant variant{
        Kernel::shade_light,
        w.defines({light.define, "SHADOWS=" + shading.shadows,
                   "LIGHTS=" + std::to_string(shading.phis_before.size() + 1), "WALK=" + light.spheres.walk,
                   "ALBEDOS_OF_RAYS=0", define_boxes(boxes), resolved ? "RESOLVES=1" : "RESOLVES=0", "STREAM=1"})};
    const Pass pass{tile.blocks > 0 ? tile : Tile{0, 0, blocks, blocks},
                    items,
                    0,
                    light.spheres.levels,
                    light.spheres.last,
                    1,
                    arrived ? 0 : -1,
                    light.group_depth,
                    0};
    cl::Kernel kernel = bench.programs.get(variant).kernel;
    in.given(kernel, boxes)
        .add_if(shading.shadows != "SHADOWS_OFF", arriving.buffer())
        .add(in.spheres.clusters.buffer(), in.spheres.nodes.buffer(), albedos.buffer(), radiance.buffer())
        .add_if(resolved != nullptr, planes[0].buffer(), planes[1].buffer(), planes[2].buffer())
        .add(light.pencil, pass, shading_of(shading, light), cl_int(0));
    bench.launch_bound(kernel, items);
    in.check_unchanged();
    albedos.check_unchanged();
    if (arrived)
        *arrived = arriving.read();
    else
        arriving.check_unchanged();
    for (const GuardedBuffer<float>& plane : planes) {
        const std::vector<float> values = plane.read();
        if (resolved) resolved->insert(resolved->end(), values.begin(), values.end());
    }
    return radiance.read();
}

}  // namespace gnomon::test
