// project_spheres: the spheres of the scene as one pencil sees them.
//
// Reads the clusters and what rounding left over of them (-D RESTS=1; else the clusters are exact, and rests is not
// touched). Writes for each place centre, reach, r^2, power and id: types.h. -D PARALLEL=1: in the light's basis, from
// the eye, which is then the apex; else from the apex. One work-item: one cluster.
#include "reach.h"
#include "two_float.h"

kernel void project_spheres(global const Cluster* restrict clusters, global const ClusterRest* restrict rests,
                            const Apex apex, const ParallelPencil light, const int items,
                            global PencilCluster* restrict seen) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    global const Cluster* c = clusters + item;
    global PencilCluster* to = seen + item;
    const float16 none = 0.0f, radius = vload16(0, c->radius);
    const int16 id = vload16(0, c->id), empty = id < 0;
#if RESTS
    global const ClusterRest* rest = rests + item;
    const float16 x_rest = vload16(0, rest->x), y_rest = vload16(0, rest->y), z_rest = vload16(0, rest->z);
    const float16 radius_rest = vload16(0, rest->radius);
#else
    const float16 x_rest = none, y_rest = none, z_rest = none, radius_rest = none;
#endif
    const TwoFloat3 f = {two_difference(vload16(0, c->x), x_rest, apex.hi.x, apex.lo.x),
                         two_difference(vload16(0, c->y), y_rest, apex.hi.y, apex.lo.y),
                         two_difference(vload16(0, c->z), z_rest, apex.hi.z, apex.lo.z)};
#if PARALLEL
    const float16 x = along(light.basis.u, f), y = along(light.basis.v, f), z = along(light.basis.axis, f);
#else
    const float16 x = f.x.hi, y = f.y.hi, z = f.z.hi;
#endif
    const float16 distance = sqrt(fma(x, x, fma(y, y, z * z)));
    vstore16(x, 0, to->x);
    vstore16(y, 0, to->y);
    vstore16(z, 0, to->z);
    vstore16(empty ? (float16)(-INFINITY) : reach_of(radius, distance), 0, to->reach);
    vstore16(empty ? (float16)(-INFINITY) : fma(radius, radius, 2.0f * radius * radius_rest), 0, to->r2);
    vstore16(empty ? (float16)(INFINITY) : power_of(f, radius, radius_rest), 0, to->power);
    vstore16(id, 0, to->id);
}
