#include "silhouettes.h"

namespace gnomon {

/// Each pair of neighbours is looked at once, from the pixel that comes first: to the right, and the three below.
void mark_silhouettes(const Plane<int32_t>& ids, size_t width, uint8_t bit, std::vector<uint8_t>& marks) {
    const auto compare = [&](size_t pixel, size_t neighbour) {
        if (ids[pixel] == ids[neighbour]) return;
        marks[pixel] |= bit;
        marks[neighbour] |= bit;
    };
    for (size_t row = 0; row < ids.size(); row += width) {
        const bool last_row = row + width == ids.size();
        for (size_t x = 0; x < width; ++x) {
            const size_t pixel = row + x, below = pixel + width;
            if (x + 1 < width) compare(pixel, pixel + 1);
            if (last_row) continue;
            for (size_t i = x > 0 ? below - 1 : below; i <= below + (x + 1 < width ? 1 : 0); ++i) compare(pixel, i);
        }
    }
}

}  // namespace gnomon
