// One picture of a case: in which accuracy, and by which name it is recorded.
#pragma once

#include <string>
#include <vector>

#include "cases.h"
#include "film.h"
#include "render.h"

namespace gnomon::verify {

/// What a device without fp64 leaves open in a certified picture is decided exactly, not in double first: decisions are
/// the same, but roundings of t and normal may not be. So these pictures are apart.
struct Mode {
    Accuracy accuracy;
    bool fp64 = true;  ///< of the device; no matter but for certified pictures
};

/// "certified without fp64"
std::string to_string(const Mode& mode);

/// Those that a device can render: all but fast, whose bits are nobody's promise.
std::vector<Mode> modes(const DeviceInfo& device);
/// Those that are recorded, on a device that has fp64.
std::vector<Mode> recorded_modes();

/// "crowd 320x240 strict"
std::string picture_name(const Case& of, const Mode& mode);

/// All results.
RenderStats render(Renderer& renderer, const Case& of, const Mode& mode, Film& film);
/// The radiance under one of the scene's lights alone. Spheres must be those of the last picture.
RenderStats render_light(Renderer& renderer, const Case& of, const Mode& mode, size_t light, bool shadows, Film& film);

}  // namespace gnomon::verify
