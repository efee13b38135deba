// EXR files to films.
#pragma once

#include <string>
#include <vector>

#include "film.h"

namespace gnomon {

/// A picture as its file holds it.
struct PictureFile {
    Film film;                        ///< planes of the channels that the file has; the others are empty
    int left = 0, top = 0;            ///< where its first pixel lies in the file's coordinates (the data window)
    std::vector<std::string> others;  ///< channels that no film has, and that were not read
};

/// Reads the channels R G B, distance.Z, N.X N.Y N.Z (float, or half, which converts exactly) and id (uint) of an EXR,
/// scanlines or tiles; the resolution of a mip map that is read is the full one. Throws Error(Blame::input) for
/// files that are missing, damaged or no EXR, have deep pixels or several parts, or a channel of another type.
PictureFile read_exr(const std::string& path);

}  // namespace gnomon
