// The rows of large scenes, block by block: what is made of one need not stay while the others are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <future>

#include "sphere_rows.h"

namespace gnomon {

/// Ids that are looked at together: few enough that 16 bits tell those of a block apart.
constexpr int64_t id_block = 1 << 16;

/// A row with what rounding left over, as the kernels see it.
struct RowView {
    const float *row, *rest;  // rest may be null
};

inline RowView view_of(const SphereRows& rows, int64_t i) {
    return {rows.rows + i * rows.columns, rows.rests.empty() ? nullptr : rows.rests.data() + 4 * i};
}

inline int64_t blocks_of(int64_t ids) { return (ids + id_block - 1) / id_block; }

/// In one block of so many.
inline int64_t ids_in_block(int64_t number, int64_t ids) { return std::min(id_block, ids - number * id_block); }

/// Calls visit(rows) for those of a block of a scene's ids.
template <class Visit>
void visit_block(const Scene& scene, const Frame& frame, int64_t number, int64_t ids, Visit visit) {
    const SphereRows rows = sphere_rows(scene, frame, number * id_block, ids_in_block(number, ids));
    visit(rows);
    if (rows.forget) rows.forget();
}

/// Runs work(number, half) for all blocks, both halves of them at once.
template <class Work>
void for_each_block(int64_t ids, Work work) {
    const int64_t blocks = blocks_of(ids);
    const auto run = [&work](int64_t first, int64_t last, size_t half) {
        for (int64_t number = first; number < last; ++number) work(number, half);
    };
    auto first = std::async(std::launch::async, run, int64_t{0}, blocks / 2, size_t{0});
    run(blocks / 2, blocks, 1);
    first.get();
}

}  // namespace gnomon
