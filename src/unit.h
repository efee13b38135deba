// The unit in which a scene is rendered, so that float neither overflows nor underflows on the way.
#pragma once

#include "scene.h"

namespace gnomon {

/// A power of two: 1 for scenes whose spheres reach between 2^-20 and 2^40 from the eye, where the cube of a distance,
/// the largest power that a kernel takes, stays well inside float's range; else about how far they reach.
double choose_unit(const Scene& scene);

/// The same scene with that unit: lengths divided by it, the eye in the origin, point lights' power by its square. All
/// exact but for the subtraction of the eye, so the bits of a picture do not depend on the unit; its distances are to
/// be multiplied.
Scene in_unit(Scene scene, double unit);

}  // namespace gnomon
