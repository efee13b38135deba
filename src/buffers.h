// What lies on the device: the scene, once a picture; the rays and hits of a tile, once for each tile under way.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "opencl.h"
#include "pencil_spheres.h"
#include "plan.h"

namespace gnomon {

/// The spheres as one pencil sees them: cl/hierarchy.h.
struct SphereBuffers {
    cl::Buffer clusters, nodes;
    int levels = 0, last = 0;
};

/// One light: its pencil and factor, passed by value, and the spheres as its rays see them (when shadows are on).
struct LightBuffers {
    std::variant<ParallelPencil, PointPencil> pencil;
    Float3 phi{};
    SphereBuffers spheres;
};

struct SceneBuffers {
    EyePencil eye{};
    SphereBuffers spheres;  ///< as the eye sees them
    cl::Buffer albedos;     ///< Float3 for each id
    std::vector<LightBuffers> lights;
};

/// The scene as the plan's steps need it.
SceneBuffers upload(const cl::Context& context, const Scene& scene, const Hierarchy& hierarchy, const Plan& plan);

/// Rays and hits of one tile, in block order; planes receives the film's part where it is not written in place.
struct TileBuffers {
    cl::Buffer dirs, ts, normals, ids, arrival, radiance, planes[3];
};

/// The tiles under way, allocated on first use and kept as long as plans have the same shape.
class TilePool {
  public:
    std::vector<TileBuffers>& get(const cl::Context& context, const Plan& plan);

  private:
    std::vector<TileBuffers> tiles_;
    std::array<size_t, 4> shape_{};
};

}  // namespace gnomon
