// The arguments of the kernels that a tile goes through.
#pragma once

#include <variant>
#include <vector>

#include "arguments.h"
#include "buffers.h"
#include "film.h"
#include "plan.h"
#include "undecided.h"

namespace gnomon {

/// What one launch works on.
struct TileLaunch {
    const Step& step;
    const Tile& tile;
    const TileBuffers& buffers;
    int first_block = 0;                     ///< of the tile's blocks, in all tiles'
    const SphereBuffers* spheres = nullptr;  ///< for the kernels that meet them
    bool first_chunk = true;                 ///< of these
};

class Binder {
  public:
    /// The film's planes become buffers where the plan writes them in place.
    Binder(const cl::Context& context, const Plan& plan, const SceneBuffers& scene, Film& film,
           const cl::Buffer& hit_counts, const UndecidedRays& undecided);

    /// Sets all arguments of the kernel that the step launches.
    void bind(cl::Kernel& kernel, const TileLaunch& launch) const;

    /// Buffers over all of the film's planes that are written in place.
    std::vector<cl::Buffer> planes() const;

  private:
    void bind_shade_light(cl::Kernel& kernel, const TileLaunch& launch) const;
    void bind_resolve(cl::Kernel& kernel, const TileLaunch& launch) const;
    Arguments hits(cl::Kernel& kernel, const TileLaunch& launch) const;
    const LightBuffers& light(const TileLaunch& launch) const;
    AlbedoBuffer albedos(const TileLaunch& launch) const;
    Pass pass(const TileLaunch& launch) const;
    Either<ShadingOf> shading(const TileLaunch& launch) const;
    Planes shape_of_planes(const Tile& tile) const;
    /// Plane c of a step's output, or its last.
    const cl::Buffer& plane(const TileLaunch& launch, size_t c) const;

    const Plan& plan_;
    const SceneBuffers& scene_;
    const Film& film_;
    cl::Buffer hit_counts_;
    UndecidedRays undecided_;
    std::vector<cl::Buffer> planes_[4];
};

}  // namespace gnomon
