// What lies on the device: the scene, once a picture; the rays and hits of a tile, once for each tile under way.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "device_memory.h"
#include "plan.h"
#include "sphere_clusters.h"

namespace gnomon {

/// One light: its pencil and factor, passed by value, and the spheres as its rays see them (when shadows are on).
struct LightBuffers {
    std::variant<ParallelPencil, PointPencil, ParallelPencilOf<double>, PointPencilOf<double>> pencil;
    Either<Real3Of> phi;
    SphereBuffers spheres;
};

/// The albedo of each id: `stride` floats apart from `first` on; the same for all when stride is 0.
struct AlbedoBuffer {
    cl::Buffer values;
    int first = 0, stride = 0;
};

struct SceneBuffers {
    Either<EyePencilOf> eye;
    Basis eye_basis{};
    SphereBuffers spheres;  ///< as the eye sees them
    AlbedoBuffer albedos;
    std::vector<LightBuffers> lights;
    /// The spheres as a light's rays see them, or for light -1 as the eye does.
    const SphereBuffers& seen_by(int light) const {
        return light < 0 ? spheres : lights[static_cast<size_t>(light)].spheres;
    }
    float base_doubt = 0;  ///< how far the spheres, as they are on the device, may be off (cl/certify.h)
};

/// The spheres' albedos lie in their rows; rows without are all of one albedo.
AlbedoBuffer albedos_of(const DeviceMemory& memory, const SphereRows& rows, const RowBuffers& buffers);

/// The scene as the plan's steps need it, its spheres as all its pencils see them; without `spheres`, which are then
/// elsewhere, all but them.
SceneBuffers prepare(SphereKernels& kernels, const Scene& scene, const Survey& survey, const Frame& frame,
                     const ClusterBuffers* spheres, const Plan& plan);

/// Rays and hits of one tile, in block order; planes receives the film's part where it is not written in place.
struct TileBuffers {
    cl::Buffer dirs, positions, normals, ids, ts, boxes, arrivals, radiance, albedos, planes[3];
};

/// The tiles under way, allocated on first use and kept as long as plans have the same shape.
class TilePool {
  public:
    std::vector<TileBuffers>& get(const DeviceMemory& memory, const Plan& plan);
    /// Lets go of them unless they are what this plan would get.
    void keep_for(const Plan& plan);
    void clear();

  private:
    using Shape = std::array<size_t, 10>;
    static Shape shape_of(const Plan& plan);

    std::vector<TileBuffers> tiles_;
    Shape shape_{};
};

}  // namespace gnomon
