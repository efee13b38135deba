// PLY point clouds: vertices that are spheres.
#pragma once

#include "mapped_file.h"
#include "scene.h"
#include "sphere_io.h"

namespace gnomon {

/// The element "vertex" with x y z, and radius and red green blue if it has them: colours of bytes are divided by 255,
/// others are the albedo. Everything else is skipped. In float when that holds what the file has, else in double.
SphereTable read_ply(const SharedFile& file, const SphereDefaults& defaults);

}  // namespace gnomon
