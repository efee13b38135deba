// What the rays of one pass share: the eye's pencil, and each light's. Computed from the scene's doubles and rounded to
// float once.
#pragma once

#include "../cl/types.h"
#include "scene.h"

namespace gnomon {

/// The eye's pencil: x_c = up x z_c, y_c = z_c x x_c, rays through pixel centres, row 0 at the top.
EyePencil eye_pencil(const Camera& camera, const ImageSize& image);
/// The pencil toward a directional light: an orthonormal basis with the light's direction last.
ParallelPencil parallel_pencil(const DirectionalLight& light);
/// The pencil from a point light, placed relative to the eye.
PointPencil point_pencil(const PointLight& light, const Camera& camera);

/// The factor of albedo * geometry in a light's Lambert term: irradiance / pi, and power / (4 pi^2) for a point light.
Float3 lambert_factor(const DirectionalLight& light);
Float3 lambert_factor(const PointLight& light);

}  // namespace gnomon
