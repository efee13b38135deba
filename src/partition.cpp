#include "partition.h"

#include <algorithm>
#include <limits>
#include <string>

#include "cells.h"
#include "error.h"

namespace gnomon {

namespace {

// What tells cells and chunks apart, and ids in a block.
constexpr size_t most_places = size_t{std::numeric_limits<uint16_t>::max()} + 1;
static_assert(cells <= most_places && id_block <= int64_t{most_places});

/// From the cells of a block's spheres to their chunks. `rows` is null where no cell is cut.
void to_chunks(const ChunksOfCells& chunks, const SphereRows* rows, uint16_t* places, int64_t count) {
    for (int64_t i = 0; i < count; ++i) {
        const uint16_t cell = places[i];
        const auto parts = static_cast<uint32_t>(chunks.parts[cell]);
        const auto part = parts > 1 ? hash_of(view_of(*rows, i)) % parts : 0;
        places[i] = static_cast<uint16_t>(chunks.first[cell] + static_cast<int>(part));
    }
}

/// From the chunks of a block's spheres to the order of these: a sort by counting, in which `next` is room for a number
/// a chunk.
void put_in_order(uint16_t* places, int64_t count, uint32_t* starts, std::vector<uint32_t>& next) {
    uint16_t chunk_of[id_block];
    std::copy(places, places + count, chunk_of);
    for (int64_t i = 0; i < count; ++i) ++starts[chunk_of[i] + 1];
    for (size_t chunk = 0; chunk < next.size(); ++chunk) starts[chunk + 1] += next[chunk] = starts[chunk];
    for (int64_t i = 0; i < count; ++i) places[next[chunk_of[i]]++] = static_cast<uint16_t>(i);
}

[[noreturn]] void too_many(int64_t capacity) {
    throw Error(Blame::run, "more spheres lie in one place than the " + std::to_string(capacity) + " that fit a chunk",
                "", "allow more memory (--memory), or use a device with more");
}

/// The sizes of chunks.
std::vector<int64_t> sum_of_blocks(const std::vector<uint32_t>& starts, size_t chunks) {
    std::vector<int64_t> sizes(chunks);
    for (size_t block = 0; block < starts.size(); block += chunks + 1)
        for (size_t chunk = 0; chunk < chunks; ++chunk)
            sizes[chunk] += starts[block + chunk + 1] - starts[block + chunk];
    return sizes;
}

}  // namespace

Partition cut_into_chunks(const Scene& scene, const Survey& survey, const Frame& frame, int64_t capacity) {
    Partition result;
    result.places.resize(static_cast<size_t>(survey.count));
    const ChunksOfCells chunks(count_cells(scene, survey, frame, result.places), capacity);
    if (static_cast<size_t>(chunks.count) > most_places) too_many(capacity);
    const auto all = static_cast<size_t>(chunks.count);
    result.starts.resize(static_cast<size_t>(blocks_of(survey.count)) * (all + 1));
    std::vector<uint32_t> next[2] = {std::vector<uint32_t>(all), std::vector<uint32_t>(all)};
    const bool any_cut = chunks.any_cut();
    for_each_block(survey.count, [&](int64_t number, size_t half) {
        uint16_t* const places = result.places.data() + number * id_block;
        const int64_t count = ids_in_block(number, survey.count);
        if (any_cut)
            visit_block(scene, frame, number, survey.count,
                        [&](const SphereRows& rows) { to_chunks(chunks, &rows, places, count); });
        else
            to_chunks(chunks, nullptr, places, count);
        put_in_order(places, count, result.starts.data() + static_cast<size_t>(number) * (all + 1), next[half]);
    });
    result.sizes = sum_of_blocks(result.starts, all);
    if (*std::max_element(result.sizes.begin(), result.sizes.end()) > capacity) too_many(capacity);
    return result;
}

}  // namespace gnomon
