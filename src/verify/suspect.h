// Which kernel computes what differs.
#pragma once

#include <string>

#include "record.h"

namespace gnomon::verify {

/// What is known of a picture that differs from the record.
struct Evidence {
    const Case& of;
    Mode mode;
    const Print& expected;
    const Fingerprint& found;
    const RenderStats& stats;  ///< of the picture that was just rendered
};

/// The first kernel of the chain whose output is another, in words: where the eye's results differ, those that trace
/// its rays; where the radiance alone does, lights are rendered one by one, with and without shadows, to tell.
std::string suspect(Renderer& renderer, const Evidence& evidence);

}  // namespace gnomon::verify
