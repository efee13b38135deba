// PNG through libpng alone, so that a picture needs no more libraries than that. (OpenImageIO brings 250 along: 0.25
// s.)
#pragma once

#include <string>

#include "image_io.h"
#include "temporary_file.h"

namespace gnomon {

/// Writes the film's view to `file` and closes it. `path` is its name in errors. Throws Error(Blame::run).
void write_png(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
               TemporaryFile& file);

}  // namespace gnomon
