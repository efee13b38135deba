// NumPy's .npy arrays of spheres.
#pragma once

#include "mapped_file.h"
#include "scene.h"
#include "sphere_io.h"

namespace gnomon {

/// Shape (N, 4), x y z radius, or (N, 7), with the albedo; float or double, in either byte order and either order of
/// rows and columns. In C's order and the machine's own bytes, aligned (as NumPy writes them), rows stay in the file.
SphereTable read_npy(const SharedFile& file, const SphereDefaults& defaults);

}  // namespace gnomon
