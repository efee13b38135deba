#include "chunked_spheres.h"

#include "chunk_rows.h"

namespace gnomon {

namespace {

/// From where a light sees spheres.
template <class real>
struct ViewOfLight {
    const Scene& scene;
    const Survey& survey;
    const Frame& frame;

    PencilView operator()(const DirectionalLight& light) const {
        return view_of(parallel_pencil<real>(light), scene.camera, frame);
    }
    PencilView operator()(const PointLight& light) const {
        return view_of(point_pencil<real>(light, scene.camera, survey, frame), scene.camera, frame);
    }
};

}  // namespace

ChunkedSpheres::ChunkedSpheres(const DeviceMemory& memory, SphereKernels& kernels, Launcher& launcher,
                               const Scene& scene, const Survey& survey, const Frame& frame, const Plan& plan,
                               const ClusterBuffers* all)
    : memory_(memory),
      kernels_(kernels),
      launcher_(launcher),
      scene_(scene),
      survey_(survey),
      frame_(frame),
      accuracy_(plan.accuracy),
      resident_(plan.memory.resident) {
    if (plan.memory.cut) {
        partition_ = cut_into_chunks(scene, survey, frame, plan.memory.chunk_spheres);
        gathered_.resize(partition_.sizes.size());
    } else {
        gathered_.push_back(*all);
    }
}

ClusterBuffers ChunkedSpheres::gather(int chunk) {
    ClusterBuffers& known = gathered_[static_cast<size_t>(chunk)];
    if (known.shape.spheres > 0) return known;
    rows_of_chunk(scene_, frame_, partition_, chunk, chunk_rows_);
    const ClusterBuffers made = kernels_.gather(upload(memory_, chunk_rows_), survey_, frame_);
    launcher_.finish();  // the rows are read until then
    if (resident_) known = made;
    if (resident_ && chunk + 1 == chunks()) chunk_rows_ = {};  // that was the last
    return made;
}

PencilView ChunkedSpheres::view(int light) const {
    return with_real(accuracy_, [&](auto real) {
        if (light < 0) return view_of_eye<decltype(real)>(scene_.camera, frame_);
        const ViewOfLight<decltype(real)> seen{scene_, survey_, frame_};
        return std::visit(seen, scene_.lights[static_cast<size_t>(light)]);
    });
}

SphereBuffers ChunkedSpheres::seen(int light, int chunk) {
    const SphereBuffers result = kernels_.project(gather(chunk), view(light));
    launcher_.finish();
    return result;
}

std::vector<float> ChunkedSpheres::albedos_of(const std::vector<int>& ids) const {
    std::vector<float> albedos(3 * ids.size());
    for (size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] < 0) continue;
        const Rgb albedo = sphere_of(scene_, ids[i]).albedo;
        float* to = albedos.data() + i / BLOCK_RAYS * BLOCK_RAYS * 3 + i % BLOCK_RAYS;
        to[0] = static_cast<float>(albedo.r);
        to[BLOCK_RAYS] = static_cast<float>(albedo.g);
        to[2 * BLOCK_RAYS] = static_cast<float>(albedo.b);
    }
    return albedos;
}

}  // namespace gnomon
