// Two pictures of the same scene: by how much they differ, and where.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "channel_diff.h"
#include "channels.h"
#include "film.h"

namespace gnomon {

/// A number of pixels, those at silhouettes apart. A pixel is at a silhouette where, in A or in B, one of its up to 8
/// neighbours has another id than itself. If only one picture has ids, it alone tells; without any, all are inside.
struct PixelCount {
    int64_t inside = 0, silhouette = 0;
    int64_t all() const { return inside + silhouette; }
};

/// How large a difference may be, in each float channel of a result: relative to the largest finite magnitude that A
/// has in the compared channels of that result. 0: the values have to be equal.
struct Tolerances {
    double radiance = 0, distance = 0, normal = 0;

    double of(Result result) const {
        if (result == Result::radiance) return radiance;
        return result == Result::distance ? distance : normal;
    }
};

/// A float channel that both pictures have.
struct ComparedChannel {
    FloatChannel channel;
    double scale;      ///< the largest finite magnitude in A of the channel's result
    double tolerance;  ///< absolute, in the channel's unit
    ChannelDiff diff;
};

/// An id as it is in a file; a miss is 0xFFFFFFFF.
struct ComparedIds {
    PixelCount different;
    std::optional<Sample<uint32_t>> first;  ///< pixel that differs
};

/// All that there is to tell about two pictures.
struct PictureDiff {
    int width = 0, height = 0;
    std::vector<ComparedChannel> channels;
    std::optional<ComparedIds> id;                  ///< if both have ids
    std::vector<std::string> only_in_a, only_in_b;  ///< channels
    bool ids_in_a = false, ids_in_b = false;        ///< where silhouettes come from
    PixelCount pixels;                              ///< of the picture
    PixelCount different;        ///< pixels in which any channel differs by more than its tolerance, or the id does
    std::vector<uint8_t> marks;  ///< a byte a pixel: bits of Mark
};

/// Compares all channels that both films have, in time and memory proportional to the pixels: 9 bytes a pixel beside
/// the films. Throws Error(Blame::input) unless they have the same size and a channel in common.
PictureDiff diff_pictures(const Film& a, const Film& b, const Tolerances& tolerances);

}  // namespace gnomon
