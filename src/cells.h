// Cells of a grid over all spheres, and the chunks that their spheres go to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "id_blocks.h"

namespace gnomon {

/// Of the grid: 32 along each axis of the largest box's side, in the order of Morton's curve.
constexpr int cell_bits = 5;
constexpr size_t cells = size_t{1} << 3 * cell_bits;

/// How many spheres lie in each cell; `cell_of` gets that of each id.
std::vector<int64_t> count_cells(const Scene& scene, const Survey& survey, const Frame& frame,
                                 std::vector<uint16_t>& cell_of);

/// The same for spheres that coincide.
uint32_t hash_of(const RowView& row);

/// The chunks that each cell's spheres go to.
struct ChunksOfCells {
    std::vector<int> first = std::vector<int>(cells), parts = std::vector<int>(cells, 1);
    int count = 0;

    /// Cells in their order, as many to a chunk as fit; one that holds more is cut so that its parts are about half
    /// full.
    ChunksOfCells(const std::vector<int64_t>& sizes, int64_t capacity);

    /// Whether some cell's spheres go to several chunks, by their hashes.
    bool any_cut() const {
        return std::any_of(parts.begin(), parts.end(), [](int n) { return n > 1; });
    }
};

}  // namespace gnomon
