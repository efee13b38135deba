// How an image is cut into tiles, and how many workers share them.
#pragma once

#include "plan.h"

namespace gnomon {

struct Tiling {
    std::vector<Tile> tiles;  ///< covering the image, row by row
    int workers = 1;          ///< as in Plan
    int sets = 1;             ///< Plan::tile_sets

    int largest() const;  ///< blocks of the largest tile
};

/// Tiles of `rays` at most, under way one after the other.
Tiling one_by_one(const ImageSize& image, int rays);

/// Rays in a tile whose passes follow each other on one core of a CPU, at most.
int64_t core_tile_rays(int real_bytes, const DeviceLimits& limits);

/// Tiles of `rays` at most for so many workers on several devices, smaller to the end.
Tiling for_team(const ImageSize& image, int workers, int rays);

/// Tiles as the device likes them best, or of `asked` rays at most if that is not 0. Cores work on a tile each where
/// that pays: each gets two or more, and no tile may take many times as long as another of as many rays (`even`); or
/// where they are apart.
/// Throws Error(Blame::input) for a tile that cannot be.
Tiling choose_tiling(const ImageSize& image, int asked, bool even, int real_bytes, const DeviceLimits& limits);

}  // namespace gnomon
