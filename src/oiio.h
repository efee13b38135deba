// What is read and written through OpenImageIO. Only what includes this names it.
#pragma once

#include "image_formats.h"

namespace gnomon {

/// As ImageFormats says it.
void write_through_oiio(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
                        TemporaryFile& file);
PictureFile read_exr_through_oiio(const std::string& path);

}  // namespace gnomon
