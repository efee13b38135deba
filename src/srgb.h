// The sRGB curve: IEC 61966-2-1:1999, a straight part and a power.
#pragma once

namespace gnomon {

/// The sRGB encoding of linear light in [0, 1].
double srgb_encode(double linear);

/// Its inverse, for codes in [0, 1].
double srgb_decode(double encoded);

}  // namespace gnomon
