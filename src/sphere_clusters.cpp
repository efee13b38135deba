#include "sphere_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "flat_view.h"

namespace gnomon {

namespace {

// Runs of more equal keys than this make clusters that overlap, and looking through them for coincident spheres slow.
constexpr int max_run = 2 * CLUSTER;
constexpr int any_run = std::numeric_limits<int>::max();

int groups_of_16(int count) { return (count + CLUSTER - 1) / CLUSTER; }

/// The grid in which places are looked up: its corner, and cells per length on the coarsest level, a power of two.
struct Grid {
    Float3 low;
    float scale;

    Grid(const Survey& survey, const Frame& frame) {
        const Vec3 corner = frame.place(survey.low), size = frame.place(survey.high) - corner;
        low = {static_cast<float>(corner.x), static_cast<float>(corner.y), static_cast<float>(corner.z)};
        const double side = std::max({size.x, size.y, size.z});
        scale = side > 0 ? static_cast<float>(std::ldexp(1.0, HILBERT_BITS - 1 - std::ilogb(side))) : 0;
    }
};

/// Two words a sphere, a key and a row, and room to sort them in.
struct Pair {
    cl_uint key, row;
};

}  // namespace

RowBuffers upload(const DeviceMemory& memory, const SphereRows& rows) {
    RowBuffers buffers;
    buffers.columns = rows.columns;
    buffers.first_id = static_cast<int>(rows.first);
    buffers.count = static_cast<int>(rows.count);
    buffers.has_rests = !rows.rests.empty();
    buffers.has_ids = !rows.ids.empty();
    buffers.rows = memory.over(rows.rows, rows.count * rows.columns);
    buffers.rests = buffers.has_rests ? memory.over(rows.rests.data(), 4 * rows.count) : memory.room<float>(1);
    buffers.ids = buffers.has_ids ? memory.over(rows.ids.data(), rows.count) : memory.room<int>(1);
    return buffers;
}

ClusterBuffers few_clusters(const SphereRows& rows) {
    ClusterBuffers made;
    made.shape = hierarchy_over(rows.count);
    made.has_rests = !rows.rests.empty();
    made.few = flat_clusters(rows);
    return made;
}

struct SphereKernels::Pairs {
    cl::Buffer sorted, other, counts, totals;
};

/// By one word of the key: a radix sort of its digits, the lowest first.
void SphereKernels::sort(Pairs& pairs, const RowBuffers& rows, int word, bool first, const Survey& survey,
                         const Frame& frame) {
    const Grid grid(survey, frame);
    // Unless there are size classes (cl/sphere_keys.cl), no key has more than KEY_BITS, and one pass is spared.
    const bool classes = word == 0 && survey.largest_radius > MUCH_LARGER * survey.middle_radius;
    const int bits = classes ? 32 : KEY_BITS;
    const int count = rows.count, slices = plan_.slices(count), all = groups_of_16(count), local = plan_.local_size;
    const float middle = classes ? static_cast<float>(survey.middle_radius / frame.unit) : INFINITY;
    launcher_.launch(sphere_variant(Kernel::sphere_keys, plan_.accuracy, rows.has_rests), all, local, rows.rows,
                     rows.rests, rows.columns, pairs.sorted, first ? 1 : 0, word, grid.low, grid.scale, middle, count,
                     all, pairs.other);
    std::swap(pairs.sorted, pairs.other);
    for (int shift = 0; shift < bits; shift += DIGIT_BITS) {
        launcher_.fill_with_zeros(pairs.totals);
        launcher_.launch(sphere_variant(Kernel::count_digits, plan_.accuracy), slices, plan_.slice_local_size,
                         pairs.sorted, count, shift, slices, pairs.counts, pairs.totals);
        launcher_.launch(sphere_variant(Kernel::scan_counts, plan_.accuracy), DIGITS / DIGITS_AN_ITEM, local, slices,
                         DIGITS / DIGITS_AN_ITEM, pairs.counts, pairs.totals);
        launcher_.launch(sphere_variant(Kernel::scatter_pairs, plan_.accuracy), slices, plan_.slice_local_size,
                         pairs.sorted, count, shift, slices, pairs.counts, pairs.other);
        std::swap(pairs.sorted, pairs.other);
    }
}

/// False when runs of equal keys are too long.
bool SphereKernels::find_duplicates(const Pairs& pairs, const RowBuffers& rows, bool hashed, int longest,
                                    const cl::Buffer& order) {
    const int none = 0;
    const cl::Buffer crowded = memory_.copy(&none, 1);
    launcher_.launch(sphere_variant(Kernel::find_duplicates, plan_.accuracy, rows.has_rests), groups_of_16(rows.count),
                     plan_.local_size, rows.rows, rows.rests, rows.columns, pairs.sorted, hashed ? 1 : 0, longest,
                     rows.count, groups_of_16(rows.count), order, crowded);
    return longest == any_run || launcher_.read_int(crowded) == 0;
}

/// The rows of distinct spheres in the order of the hierarchy.
void SphereKernels::order(const RowBuffers& rows, const Survey& survey, const Frame& frame, const cl::Buffer& order) {
    Pairs pairs{memory_.room<Pair>(rows.count), memory_.room<Pair>(rows.count),
                memory_.room<int>(int64_t{DIGITS} * plan_.slices(rows.count)), memory_.room<int>(DIGITS)};
    sort(pairs, rows, 0, true, survey, frame);
    if (!find_duplicates(pairs, rows, false, max_run, order)) {
        sort(pairs, rows, HASH_WORD, true, survey, frame);
        for (int word = PLACE_WORDS - 1; word >= 0; --word) sort(pairs, rows, word, false, survey, frame);
        find_duplicates(pairs, rows, true, any_run, order);
    }
    launcher_.finish();  // only then are the pairs given back
}

ClusterBuffers SphereKernels::gather(const RowBuffers& rows, const Survey& survey, const Frame& frame) {
    ClusterBuffers result;
    result.shape = hierarchy_over(rows.count, 0);
    result.has_rests = rows.has_rests;
    const cl::Buffer order = memory_.room<int>(rows.count);
    this->order(rows, survey, frame, order);
    result.clusters = memory_.room<Cluster>(result.shape.clusters);
    result.rests = memory_.room<ClusterRest>(rows.has_rests ? result.shape.clusters : 1);
    launcher_.launch(sphere_variant(Kernel::gather_spheres, plan_.accuracy, rows.has_rests, false, rows.has_ids),
                     result.shape.clusters, plan_.local_size, rows.rows, rows.rests, rows.columns, order, rows.ids,
                     rows.first_id, rows.count, result.shape.clusters, result.clusters, result.rests);
    return result;
}

SphereBuffers SphereKernels::project(const ClusterBuffers& spheres, const PencilView& view) {
    const HierarchyShape& shape = spheres.shape;
    SphereBuffers result{{}, {}, shape.levels(), shape.last()};
    result.nodes = memory_.room<Node>(static_cast<int64_t>(view.faces.size()) * shape.all_nodes());
    if (shape.is_flat()) {
        result.clusters = with_real(plan_.accuracy, [&](auto real) { return look<decltype(real)>(spheres.few, view); });
        return result;
    }
    const auto room = [&](auto real) { return memory_.room<PencilClusterOf<decltype(real)>>(shape.clusters); };
    result.clusters = with_real(plan_.accuracy, room);
    launcher_.branch();
    launcher_.launch(sphere_variant(Kernel::project_spheres, plan_.accuracy, spheres.has_rests), shape.clusters,
                     plan_.local_size, spheres.clusters, spheres.rests, view.apex, view.parallel,
                     view.is_parallel ? 1 : 0, shape.clusters, result.clusters);
    bound(result, shape, view);
    return result;
}

template <class real>
cl::Buffer SphereKernels::look(const FlatClusters& spheres, const PencilView& view) const {
    const std::vector<PencilClusterOf<real>> seen = flat_view(
        spheres, std::get<ApexOf<real>>(view.apex), std::get<ParallelPencilOf<real>>(view.parallel), view.is_parallel);
    return memory_.copy(seen.data(), static_cast<int64_t>(seen.size()));
}

/// Level by level, for each face.
void SphereKernels::bound(const SphereBuffers& spheres, const HierarchyShape& shape, const PencilView& view) {
    const Variant lowest = sphere_variant(Kernel::bound_clusters, plan_.accuracy, false, view.is_parallel);
    const Variant upper = sphere_variant(Kernel::bound_nodes, plan_.accuracy, false, view.is_parallel);
    for (size_t face = 0; face < view.faces.size(); ++face) {
        const int origin = static_cast<int>(face) * shape.all_nodes();
        launcher_.launch(lowest, shape.nodes[0], plan_.local_size, spheres.clusters, view.faces[face], shape.clusters,
                         origin, shape.nodes[0], spheres.nodes);
        for (int level = 1, below = 0; level < shape.levels(); below += shape.nodes[static_cast<size_t>(level++ - 1)]) {
            const int count = shape.nodes[static_cast<size_t>(level - 1)],
                      items = shape.nodes[static_cast<size_t>(level)];
            launcher_.launch(upper, items, plan_.local_size, origin, below, count, items, spheres.nodes);
        }
    }
}

}  // namespace gnomon
