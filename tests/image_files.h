// Films that fill image files, and the files as OpenImageIO reads them.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "image_io.h"
#include "run_program.h"

namespace gnomon::test {

using OIIO::TypeDesc;

constexpr float inf = std::numeric_limits<float>::infinity();
inline const Metadata metadata{{"Software", "gnomon test"}, {"gnomon:scene", "0123abcd"}};

/// Values with all sorts of bits, a miss every fifth pixel and ids that no float can hold.
inline Film make_film(int width, int height, const Outputs& outputs = {true, true, true, true}) {
    Film film(width, height, outputs);
    const auto fill = [](Plane<float>& plane, float scale, float miss) {
        for (size_t i = 0; i < plane.size(); ++i)
            plane[i] = i % 5 == 4 ? miss : scale * static_cast<float>(i * 7919 % 1013) / 1013;
    };
    for (size_t c = 0; c < 3; ++c) {
        fill(film.radiance[c], 1.3f + static_cast<float>(c), 0);
        fill(film.normal[c], 0.9f - static_cast<float>(c), inf);
    }
    fill(film.distance, 1e6f, inf);
    for (size_t i = 0; i < film.id.size(); ++i) film.id[i] = i % 5 == 4 ? -1 : 16777217 + static_cast<int32_t>(i);
    return film;
}

inline std::unique_ptr<OIIO::ImageInput> open_image(const std::string& path) {
    auto image = OIIO::ImageInput::open(path);
    if (!image) throw std::runtime_error(path + ": " + OIIO::geterror());
    return image;
}

/// One channel of an image in the type it has in the file.
template <class T>
std::vector<T> read_channel(const std::string& path, int channel, TypeDesc type) {
    const auto image = open_image(path);
    std::vector<T> values(image->spec().image_pixels());
    if (!image->read_image(0, 0, channel, channel + 1, type, values.data()))
        throw std::runtime_error(image->geterror());
    return values;
}

/// All channels of a display image, side by side.
template <class T>
std::vector<T> read_codes(const std::string& path, TypeDesc type) {
    const auto image = open_image(path);
    std::vector<T> values(image->spec().image_pixels() * static_cast<size_t>(image->spec().nchannels));
    if (!image->read_image(0, 0, 0, image->spec().nchannels, type, values.data()))
        throw std::runtime_error(image->geterror());
    return values;
}

}  // namespace gnomon::test
