// All image formats but PNG, in a library of their own that is loaded when one is first needed.
#pragma once

#include <string>

#include "image_io.h"
#include "image_read.h"
#include "temporary_file.h"

namespace gnomon {

constexpr const char* common_formats = "try .exr, .png, .tif or .jpg";

/// What that library offers, under the name gnomon_image_formats.
struct ImageFormats {
    /// Writes the film, or a view of it, in the format that `path` says, to `file`, and closes it.
    void (*write)(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
                  TemporaryFile& file);
    PictureFile (*read_exr)(const std::string& path);
};

/// Loads the library on first use: the quarter of a second that OpenImageIO and what it depends on take, none but
/// those who need it pay. Throws Error(Blame::run) when it cannot be loaded.
const ImageFormats& image_formats();

}  // namespace gnomon
