// The chemical elements as spheres: how large, and in which colour.
#pragma once

#include <string_view>

#include "scene.h"

namespace gnomon {

struct Element {
    double radius;  ///< van der Waals, in angstrom; 0 where none is published
    Rgb albedo;
};

/// By its symbol in any case of letters, as "Cl", or its atomic number, as "17"; null for what is none.
const Element* find_element(std::string_view name);

}  // namespace gnomon
