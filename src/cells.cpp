#include "cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gnomon {

namespace {

/// Places in the grid of cells.
class Grid {
  public:
    Grid(const Survey& survey, const Frame& frame) {
        for (unsigned place = 0; place < apart_.size(); ++place)
            for (int bit = 0; bit < cell_bits; ++bit) apart_[place] |= (place >> bit & 1) << 3 * bit;
        const Vec3 low = frame.place(survey.low), size = frame.place(survey.high) - low;
        const double lows[] = {low.x, low.y, low.z}, side = std::max({size.x, size.y, size.z});
        std::copy(std::begin(lows), std::end(lows), low_);
        scale_ = side > 0 ? (1 << cell_bits) / side : 0;
    }
    size_t cell(const RowView& r) const {
        unsigned index = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<int>((static_cast<double>(r.row[axis]) - low_[axis]) * scale_);
            index |= apart_[static_cast<size_t>(std::clamp(place, 0, (1 << cell_bits) - 1))] << axis;
        }
        return index;
    }

  private:
    double low_[3], scale_;
    std::array<unsigned, 1 << cell_bits> apart_{};  // a place's bits with room between them for those of other axes
};

}  // namespace

std::vector<int64_t> count_cells(const Scene& scene, const Survey& survey, const Frame& frame,
                                 std::vector<uint16_t>& cell_of) {
    const Grid grid(survey, frame);
    std::vector<int64_t> counts[2] = {std::vector<int64_t>(cells), std::vector<int64_t>(cells)};
    for_each_block(survey.count, [&](int64_t number, size_t half) {
        visit_block(scene, frame, number, survey.count, [&](const SphereRows& rows) {
            for (int64_t i = 0; i < rows.count; ++i) {
                const size_t cell = grid.cell(view_of(rows, i));
                cell_of[static_cast<size_t>(rows.first + i)] = static_cast<uint16_t>(cell);
                ++counts[half][cell];
            }
        });
    });
    for (size_t cell = 0; cell < cells; ++cell) counts[0][cell] += counts[1][cell];
    return counts[0];
}

uint32_t hash_of(const RowView& r) {
    uint32_t hash = 2166136261u;  // Fowler, Noll and Vo's, on words
    const auto add = [&](const float* numbers) {
        for (int i = 0; numbers && i < 4; ++i) {
            const float number = numbers[i] + 0.0f;  // -0 becomes 0
            uint32_t word;
            std::memcpy(&word, &number, sizeof word);
            hash = (hash ^ word) * 16777619u;
            hash ^= hash >> 15;
        }
    };
    add(r.row);
    add(r.rest);
    return hash;
}

ChunksOfCells::ChunksOfCells(const std::vector<int64_t>& sizes, int64_t capacity) {
    int64_t room = 0;
    for (size_t cell = 0; cell < cells; ++cell) {
        if (sizes[cell] > capacity) {
            first[cell] = count;
            parts[cell] = static_cast<int>(sizes[cell] / std::max<int64_t>(capacity / 2, 1)) + 1;
            count += parts[cell];
            room = 0;
            continue;
        }
        if (sizes[cell] > room) {
            ++count;
            room = capacity;
        }
        room -= sizes[cell];
        first[cell] = std::max(0, count - 1);
    }
}

}  // namespace gnomon
