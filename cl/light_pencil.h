// The pencil of the kind of light that this program is built for, -D LIGHT=...; each kind defines LightPencil,
// ShadowRay, shadow_ray(), arriving(), occludes(), and the fat versions of the ray.
#include "types.h"

#if LIGHT == LIGHT_DIRECTIONAL
#include "parallel_doubt.h"
#include "parallel_pencil.h"
#elif LIGHT == LIGHT_POINT
#include "point_doubt.h"
#include "point_pencil.h"
#else
#error "LIGHT must be LIGHT_DIRECTIONAL or LIGHT_POINT"
#endif
