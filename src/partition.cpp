#include "partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <string>

#include "error.h"

namespace gnomon {

namespace {

constexpr int cell_bits = 5;  // an axis
constexpr size_t cells = size_t{1} << 3 * cell_bits;
// Partition::chunk_of holds cells at first.
static_assert(cells <= size_t{std::numeric_limits<uint16_t>::max()} + 1);
constexpr int64_t block = 1 << 16;  // rows that are made at a time

/// A row with what rounding left over, as the kernels see it.
struct RowView {
    const float *row, *rest;  // rest may be null
};

/// Calls visit(from, rows) for blocks of rows with ids from `first` to `last`.
template <class Visit>
void for_each_block(const Scene& scene, const Frame& frame, int64_t first, int64_t last, Visit visit) {
    for (int64_t from = first; from < last; from += block) {
        const SphereRows rows = sphere_rows(scene, frame, from, std::min(block, last - from));
        visit(from, rows);
        if (rows.forget) rows.forget();
    }
}

RowView view_of(const SphereRows& rows, int64_t i) {
    return {rows.rows + i * rows.columns, rows.rests.empty() ? nullptr : rows.rests.data() + 4 * i};
}

/// Calls visit(id, row) for the ids from `first` to `last`.
template <class Visit>
void for_each_row(const Scene& scene, const Frame& frame, int64_t first, int64_t last, Visit visit) {
    for_each_block(scene, frame, first, last, [&](int64_t from, const SphereRows& rows) {
        for (int64_t i = 0; i < rows.count; ++i) visit(from + i, view_of(rows, i));
    });
}

/// Runs work(first, last) over both halves of the ids at once.
template <class Work>
void in_halves(int64_t count, Work work) {
    auto first = std::async(std::launch::async, work, int64_t{0}, count / 2, 0);
    work(count / 2, count, 1);
    first.get();
}

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

/// The same for spheres that coincide. Adding 0 makes -0 into 0.
uint32_t hash_of(const RowView& r) {
    uint32_t hash = 2166136261u;  // Fowler, Noll and Vo's, on words
    const auto add = [&](const float* numbers) {
        for (int i = 0; numbers && i < 4; ++i) {
            const float number = numbers[i] + 0.0f;
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

/// The chunks that each cell's spheres go to.
struct Cells {
    std::vector<int> first = std::vector<int>(cells), parts = std::vector<int>(cells, 1);
    int chunks = 0;

    /// Whether some cell's spheres go to several chunks, by their hashes.
    bool any_cut() const {
        return std::any_of(parts.begin(), parts.end(), [](int n) { return n > 1; });
    }
};

/// Cells in their order, as many to a chunk as fit; one that holds more is cut so that its parts are about half full.
Cells assign(const std::vector<int64_t>& sizes, int64_t capacity) {
    Cells result;
    int64_t room = 0;
    for (size_t cell = 0; cell < cells; ++cell) {
        if (sizes[cell] > capacity) {
            result.first[cell] = result.chunks;
            result.parts[cell] = static_cast<int>(sizes[cell] / std::max<int64_t>(capacity / 2, 1)) + 1;
            result.chunks += result.parts[cell];
            room = 0;
            continue;
        }
        if (sizes[cell] > room) {
            ++result.chunks;
            room = capacity;
        }
        room -= sizes[cell];
        result.first[cell] = std::max(0, result.chunks - 1);
    }
    return result;
}

/// How many spheres lie in each cell; `cell_of` gets that of each id.
std::vector<int64_t> count_cells(const Scene& scene, const Survey& survey, const Frame& frame,
                                 std::vector<uint16_t>& cell_of) {
    const Grid grid(survey, frame);
    std::vector<int64_t> counts[2] = {std::vector<int64_t>(cells), std::vector<int64_t>(cells)};
    in_halves(survey.count, [&](int64_t first, int64_t last, int half) {
        for_each_row(scene, frame, first, last, [&](int64_t id, const RowView& r) {
            const size_t cell = grid.cell(r);
            cell_of[static_cast<size_t>(id)] = static_cast<uint16_t>(cell);
            ++counts[half][cell];
        });
    });
    for (size_t cell = 0; cell < cells; ++cell) counts[0][cell] += counts[1][cell];
    return counts[0];
}

[[noreturn]] void too_many(int64_t capacity) {
    throw Error(Blame::run, "more spheres lie in one place than the " + std::to_string(capacity) + " that fit a chunk",
                "", "allow more memory (--memory), or use a device with more");
}

}  // namespace

Partition cut_into_chunks(const Scene& scene, const Survey& survey, const Frame& frame, int64_t capacity) {
    Partition result;
    result.chunk_of.resize(static_cast<size_t>(survey.count));
    const Cells chunks = assign(count_cells(scene, survey, frame, result.chunk_of), capacity);
    if (chunks.chunks > std::numeric_limits<uint16_t>::max()) too_many(capacity);
    std::vector<int64_t> sizes[2] = {std::vector<int64_t>(static_cast<size_t>(chunks.chunks)),
                                     std::vector<int64_t>(static_cast<size_t>(chunks.chunks))};
    in_halves(survey.count, [&](int64_t first, int64_t last, int half) {
        const auto put = [&](int64_t id, const RowView* row) {
            uint16_t& place = result.chunk_of[static_cast<size_t>(id)];  // the cell until now
            const auto parts = static_cast<uint32_t>(chunks.parts[place]);
            const int chunk = chunks.first[place] + static_cast<int>(parts > 1 ? hash_of(*row) % parts : 0);
            place = static_cast<uint16_t>(chunk);
            ++sizes[half][static_cast<size_t>(chunk)];
        };
        if (chunks.any_cut())
            for_each_row(scene, frame, first, last, [&](int64_t id, const RowView& r) { put(id, &r); });
        else
            for (int64_t id = first; id < last; ++id) put(id, nullptr);
    });
    for (size_t chunk = 0; chunk < sizes[0].size(); ++chunk) {
        result.sizes.push_back(sizes[0][chunk] + sizes[1][chunk]);
        result.early.push_back(sizes[0][chunk]);
        if (result.sizes.back() > capacity) too_many(capacity);
    }
    return result;
}

namespace {

/// Writes the rows of one chunk, as far as they are in a block, from place `to` on.
class Picker {
  public:
    Picker(const Partition& partition, int chunk, SphereRows& rows, int64_t to)
        : partition_(partition), chunk_(chunk), rows_(rows), to_(static_cast<size_t>(to)), picked_(block) {}

    void operator()(int64_t from, const SphereRows& source) {
        // Every place is written and the count goes on where it counts: to branch would be to guess wrong each time.
        const uint16_t* chunks = partition_.chunk_of.data() + from;
        size_t count = 0;
        for (int64_t i = 0; i < source.count; ++i) {
            picked_[count] = static_cast<int>(i);
            count += chunks[i] == chunk_;
        }
        for (size_t k = 0; k < count; ++k, ++to_) {
            const RowView r = view_of(source, picked_[k]);
            std::copy(r.row, r.row + 4, &rows_.made[4 * to_]);
            if (r.rest) std::copy(r.rest, r.rest + 4, &rows_.rests[4 * to_]);
            rows_.ids[to_] = static_cast<int>(from) + picked_[k];
        }
    }

  private:
    const Partition& partition_;
    int chunk_;
    SphereRows& rows_;
    size_t to_;
    std::vector<int> picked_;
};

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
    const auto all = static_cast<int64_t>(partition.chunk_of.size());
    in_halves(all, [&](int64_t first, int64_t last, int half) {
        const int64_t to = half == 0 ? 0 : partition.early[static_cast<size_t>(chunk)];
        for_each_block(scene, frame, first, last, Picker(partition, chunk, rows, to));
    });
    rows.rows = rows.made.data();
}

}  // namespace gnomon
