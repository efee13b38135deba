// The channels of a film, by the names that they have in an EXR.
#pragma once

#include <array>
#include <cstddef>

#include "film.h"

namespace gnomon {

/// What a float channel is a part of; ids are a channel of their own, of another type.
enum class Result { radiance, distance, normal };

struct FloatChannel {
    const char* name;
    Result result;
};

/// In the order in which they are written.
inline constexpr std::array<FloatChannel, 7> float_channels{{{"R", Result::radiance},
                                                             {"G", Result::radiance},
                                                             {"B", Result::radiance},
                                                             {"distance.Z", Result::distance},
                                                             {"N.X", Result::normal},
                                                             {"N.Y", Result::normal},
                                                             {"N.Z", Result::normal}}};
inline constexpr const char* id_channel = "id";

/// The plane of float_channels[channel], of a film or of a const film.
template <class AnyFilm>
auto& plane_of(AnyFilm& film, size_t channel) {
    if (channel < 3) return film.radiance[channel];
    return channel == 3 ? film.distance : film.normal[channel - 4];
}

}  // namespace gnomon
