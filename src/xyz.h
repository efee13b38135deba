// XYZ files, plain and extended: atoms as spheres.
#pragma once

#include "mapped_file.h"
#include "scene.h"
#include "sphere_io.h"

namespace gnomon {

constexpr int64_t xyz_first_line = 3;  ///< of the first atom, the number and the comment being before it

/// One frame of atoms, as double. Radius and albedo are those of the file's columns "radius" and "color", else the
/// defaults, else those of the element that the species names. A "color" of integers is in 255ths.
SphereTable read_xyz(const SharedFile& file, const SphereDefaults& defaults);

}  // namespace gnomon
