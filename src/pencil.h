// What the rays of one pass share: the eye's pencil, and each light's. Computed from the scene's doubles and rounded to
// reals once.
#pragma once

#include "reals.h"
#include "scene.h"
#include "survey.h"

namespace gnomon {

/// The eye's pencil: x_c = up x z_c, y_c = z_c x x_c, rays through pixel centres, row 0 at the top.
template <class real = float>
EyePencilOf<real> eye_pencil(const Camera& camera, const ImageSize& image);
/// Its orthonormal basis, the axis along the view.
Basis eye_basis(const Camera& camera);
/// The pencil toward a directional light: a basis with the light's direction as its axis.
template <class real = float>
ParallelPencilOf<real> parallel_pencil(const DirectionalLight& light);
/// The pencil from a point light, placed relative to the eye in the frame's unit, with one face if all spheres lie on
/// one side of the light.
template <class real = float>
PointPencilOf<real> point_pencil(const PointLight& light, const Camera& camera, const Survey& survey,
                                 const Frame& frame);

/// Where a pencil's rays meet, in the frame: the eye, and the light where the kernels' reals say it is.
template <class real = float>
ApexOf<real> eye_apex(const Camera& camera, const Frame& frame);
template <class real>
ApexOf<real> point_apex(const PointPencilOf<real>& pencil, const Camera& camera, const Frame& frame);

/// The factor of albedo * geometry in a light's Lambert term, for lengths in this unit: irradiance / pi, and power / (4
/// pi^2) for a point light.
template <class real = float>
Real3Of<real> lambert_factor(const DirectionalLight& light, double unit);
template <class real = float>
Real3Of<real> lambert_factor(const PointLight& light, double unit);

/// How far a number may be off that kernels have of the scene, in the frame's unit: 2^-46 of the largest coordinate.
/// Two floats hold 2^-48 of a number, and what is said relative to an apex is of two such numbers.
float base_doubt(const Scene& scene, const Survey& survey, const Frame& frame);

}  // namespace gnomon
