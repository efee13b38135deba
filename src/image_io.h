// Films to image files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "film.h"

namespace gnomon {

/// Which of the film's results a display image (PNG and the like) shows.
enum class View { radiance, distance, normal, id };

/// How a film becomes a display image.
struct Display {
    View view = View::radiance;
    double exposure = 0;  ///< stops: radiance is multiplied by 2^exposure before the sRGB curve; radiance view only
    int bits = 8;         ///< a channel, 8 or 16
};

/// Name and value, kept in the file's header.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Whether the name says that the file holds numbers, and not a view.
bool is_exr(const std::string& path);

/// The planes that writing `path` needs: all of them for an EXR, the view's for anything else.
Outputs outputs_for(const std::string& path, const Display& display);

/// Throws Error(Blame::input) unless `path`'s extension is one that can be written and its folder exists; so that hours
/// of rendering do not end in a typing mistake.
void check_writable(const std::string& path, const Display& display);

/// Writes `film` to `path` by way of a temporary file beside it, so that a picture is there whole or not at all.
/// EXR: R G B, distance.Z, N.X N.Y N.Z as float and id as uint, linear. Anything else: the view, sRGB encoded.
/// Throws Error(Blame::run) when writing fails.
void write_image(const Film& film, const std::string& path, const Display& display, const Metadata& metadata);

}  // namespace gnomon
