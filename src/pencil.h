// What the rays of one pass share: the eye's pencil and each light's, and the spheres as each of them sees them.
// Everything here is computed from the scene's doubles and rounded to float once.
#pragma once

#include <vector>

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

/// Indices, ascending, of the spheres without those that coincide with an earlier one: coincident spheres count as one,
/// the lowest id stands for all.
std::vector<int> distinct_spheres(const std::vector<Sphere>& spheres);

/// The spheres of `ids` as seen from the eye.
std::vector<SphereCluster> spheres_from_eye(const Scene& scene, const std::vector<int>& ids);
/// The same along a directional light: in the pencil's basis, still relative to the eye.
std::vector<SphereCluster> spheres_along(const ParallelPencil& pencil, const Scene& scene, const std::vector<int>& ids);
/// The same as seen from a point light.
std::vector<SphereCluster> spheres_from_point(const PointPencil& pencil, const Scene& scene,
                                              const std::vector<int>& ids);

}  // namespace gnomon
