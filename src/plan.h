// Scene, options and device limits in; kernel variants, tiles and the chain of launches out. Pure C++: no OpenCL here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../cl/types.h"
#include "memory_plan.h"
#include "render.h"
#include "survey.h"

namespace gnomon {

/// What a plan must know of a device.
struct DeviceLimits {
    bool cpu = true;
    int native_width_float = 16;
    uint64_t max_work_group = 4096, global_bytes = uint64_t{4} << 30, max_alloc_bytes = uint64_t{1} << 30;
    int compute_units = 2;
    int sub_devices = 2;                  ///< of a unit each, on which tiles can run; 0: none
    bool cores_apart = false;             ///< tiles do run on these, whatever the scene
    uint64_t core_cache_bytes = 1 << 20;  ///< of a CPU's core; 0: unknown
    bool shares_memory = true;            ///< with the host: the film is written in place

    DeviceLimits() = default;
    explicit DeviceLimits(const DeviceInfo& info);
};

enum class Kernel {
    sphere_keys,
    count_digits,
    scan_counts,
    scatter_pairs,
    find_duplicates,
    gather_spheres,  // once a scene
    project_spheres,
    bound_clusters,
    bound_nodes,  // once a pencil
    generate_rays,
    intersect_closest,
    intersect_shadow,
    shade_light,
    resolve,       // once a tile
    refine_rays,   // once a batch of undecided pixels
    measure_roots  // for the report alone, in no plan
};
const char* to_string(Kernel kernel);

/// One of the film's outputs, for resolve.
enum class Output { radiance, distance, normal, id };

/// Where shade_light has its shadows from: nowhere; intersect_shadow, a launch before; its own launch.
enum class Shadows { off, read, traced };

/// One way to build one kernel: what -D sets ("LANES=16").
struct Variant {
    Kernel kernel;
    std::vector<std::string> defines;
    Accuracy accuracy = Accuracy::strict;

    std::string options() const;  ///< "-D LANES=16 ..."
    std::string name() const;     ///< the kernel's, and the options
    bool operator==(const Variant& other) const {
        return kernel == other.kernel && defines == other.defines && accuracy == other.accuracy;
    }
};

/// A kernel of those before the tiles: whether spheres have rests and ids (sphere_rows.h), whether the pencil is
/// parallel, how rays are computed; what does not matter to it is left out.
Variant sphere_variant(Kernel kernel, Accuracy accuracy, bool has_rests = false, bool is_parallel = false,
                       bool has_ids = false);

/// One launch of every tile's chain; each waits for the one before it.
struct Step {
    Kernel kernel;
    int variant;                       ///< index into Plan::variants
    int light = -1;                    ///< index into Scene::lights, for the lights' kernels
    int arrival = -1;                  ///< which of the arrivals a shadow pass writes, if any
    std::vector<int> shaded = {};      ///< shade_light: the lights that it adds, the last of them `light`
    bool first = false;                ///< shade_light: the first launch sets the radiance, the others add
    bool resolves = false;             ///< shade_light: the last launch resolves the radiance too
    Output output = Output::radiance;  ///< resolve: what it resolves
};

struct Plan {
    ImageSize image;
    Accuracy accuracy = Accuracy::strict;
    int lanes = 1, packets = 1;  ///< rays a vector, vectors a work-item
    int local_size = 1;          ///< work-items a group, the same for all launches but
    int slice_local_size = 1;    ///< those over the slices of a sort
    int max_slices = 1;          ///< parts into which a sort is cut
    Shadows shadows = Shadows::off;
    bool generate_rays = true;      ///< in a launch of its own, not in intersect_closest's
    bool all_hits = true;           ///< t, and misses, are kept, not just what lights need
    bool boxes = false;             ///< around blocks' hits, for the lights' rays
    bool resolve_radiance = true;   ///< in a launch of its own, not in the last light's
    bool stream = true;             ///< the film is written past the caches
    bool write_in_place = true;     ///< the film's planes are the device's buffers
    int tile_blocks = 0;            ///< blocks in the largest tile
    std::vector<Tile> tiles;        ///< covering the image, row by row
    bool shares_tiles = false;      ///< with other devices: none is taken before there is room for it
    int workers = 1;                ///< who works on tiles: 1, the whole device; more, so many of its cores
    int tile_sets = 1;              ///< tiles under way at once, each with buffers of its own
    std::vector<Variant> variants;  ///< the kernels to build: these and no others
    std::vector<Step> steps;        ///< for each tile, in order; empty when there is nothing to trace
    float group_depth = 0;  ///< receivers whose distances differ by no more than this factor are traced together
    int64_t spheres = 0;
    bool has_rests = false;  ///< their numbers are not all floats
    MemoryPlan memory;
    bool certified = false;        ///< the pixels that rounding may have decided are known
    int doubt_rays = BLOCK_RAYS;   ///< so many neighbours' hits have one bound: a block's, or each ray its own
    bool albedos_of_rays = false;  ///< looked up by the host when all hits are known, since no chunk has all

    int rays_per_item() const { return lanes * packets; }
    bool adds_to_blocks() const;  ///< of the image's blocks, what is kept of each is added to, and must be 0 before
    int items(Kernel kernel, const Tile& tile) const;  ///< work-items of a launch
    std::string walk() const;                          ///< how rays meet the spheres: cl/types.h
    bool flat() const;                ///< so few spheres that the host puts them in clusters and in view: no nodes
    bool uses(Kernel kernel) const;   ///< some step launches it
    int arrivals() const;             ///< of so many lights at once the shares that arrive are kept
    int slices(int64_t pairs) const;  ///< a sort's, of so many
};

/// Work-items in a group, where the device allows that many.
int preferred_local_size(bool cpu);

/// Of the spheres only what the survey says is looked at. Throws Error(Blame::input) for lanes or a tile that cannot
/// be, Error(Blame::run) when the scene does not fit the device.
Plan make_plan(const Scene& scene, const Survey& survey, const RenderOptions& options, const DeviceLimits& limits);

/// What computes the pixels that a certified plan leaves undecided, each by itself, so many at a time, none of it
/// resolved: in float (certified), with bounds that are its own and no work-item's, or in double (full).
constexpr int refinement_batch = 1 << 15;
Plan make_refinement_plan(const Plan& plan, const Scene& scene, Accuracy accuracy);

}  // namespace gnomon
