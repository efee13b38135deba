#include "chunk_rows.h"

#include <algorithm>

#include "id_blocks.h"

namespace gnomon {

namespace {

/// Those of a block's rows that are in a chunk, and where they go in it.
struct Picked {
    const uint16_t* places;
    size_t count, to;
};

/// The same for each block.
std::vector<Picked> picked_of(const Partition& partition, int chunk) {
    std::vector<Picked> result;
    const size_t a_block = partition.sizes.size() + 1;
    const uint16_t* places = partition.places.data();
    size_t to = 0;
    for (size_t block = 0; block < partition.starts.size(); block += a_block, places += id_block) {
        const uint32_t* const start = partition.starts.data() + block + chunk;
        const size_t count = start[1] - start[0];
        result.push_back({places + start[0], count, to});
        to += count;
    }
    return result;
}

/// Rows lie anywhere in their block, so those to come are fetched while one is copied.
void pick(const SphereRows& source, Picked picked, SphereRows& rows) {
    constexpr size_t ahead = 16;
    for (size_t k = 0; k < picked.count; ++k, ++picked.to) {
        __builtin_prefetch(view_of(source, picked.places[std::min(k + ahead, picked.count - 1)]).row);
        const RowView r = view_of(source, picked.places[k]);
        std::copy(r.row, r.row + 4, &rows.made[4 * picked.to]);
        if (r.rest) std::copy(r.rest, r.rest + 4, &rows.rests[4 * picked.to]);
        rows.ids[picked.to] = static_cast<int>(source.first) + picked.places[k];
    }
}

}  // namespace

void rows_of_chunk(const Scene& scene, const Frame& frame, const Partition& partition, int chunk, SphereRows& rows) {
    rows.columns = 4;
    rows.count = partition.sizes[static_cast<size_t>(chunk)];
    const auto count = static_cast<size_t>(rows.count);
    const auto most = static_cast<size_t>(*std::max_element(partition.sizes.begin(), partition.sizes.end()));
    rows.made.reserve(4 * most);
    rows.ids.reserve(most);
    rows.made.resize(4 * count);
    rows.ids.resize(count);
    if (!frame.floats) rows.rests.reserve(4 * most);
    if (!frame.floats) rows.rests.resize(4 * count);
    const std::vector<Picked> picked = picked_of(partition, chunk);
    const auto ids = static_cast<int64_t>(partition.places.size());
    for_each_block(ids, [&](int64_t number, size_t) {
        const Picked& here = picked[static_cast<size_t>(number)];
        if (here.count == 0) return;
        visit_block(scene, frame, number, ids, [&](const SphereRows& source) { pick(source, here, rows); });
    });
    rows.rows = rows.made.data();
}

}  // namespace gnomon
