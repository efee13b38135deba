// project_spheres: the spheres of the scene as one pencil sees them.
//
// Reads the clusters and what rounding left over of them (-D RESTS=1; else the clusters are exact, and rests is not
// touched). Writes for each place centre, reach, r^2, power and id: types.h. For a parallel light in its basis, from
// the eye, which is then the apex; else from the apex. One work-item: one cluster.
#include "projection.h"

kernel void project_spheres(global const Cluster* restrict clusters, global const ClusterRest* restrict rests,
                            const Apex apex, const ParallelPencil light, const int parallel, const int items,
                            global PencilCluster* restrict seen, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    global const Cluster* c = clusters + item;
    global PencilCluster* to = seen + item;
    const int16 id = vload16(0, c->id);
    const wholen empty = wholes_of_n(id < 0);
#if RESTS
    global const ClusterRest* rest = rests + item;
    const float16 x_rest = vload16(0, rest->x), y_rest = vload16(0, rest->y), z_rest = vload16(0, rest->z);
    const float16 radius_rest = vload16(0, rest->radius);
#else
    const float16 x_rest = 0.0f, y_rest = x_rest, z_rest = x_rest, radius_rest = x_rest;
#endif
    const TwoReals3 center = {number_of(vload16(0, c->x), x_rest), number_of(vload16(0, c->y), y_rest),
                              number_of(vload16(0, c->z), z_rest)};
    const Projected s = projected(center, number_of(vload16(0, c->radius), radius_rest), apex, light, parallel);
    vstore16(s.x, 0, to->x);
    vstore16(s.y, 0, to->y);
    vstore16(s.z, 0, to->z);
    vstore16(id < 0 ? (float16)(-INFINITY) : s.reach, 0, to->reach);
    vstore16(empty ? (realn)(-INFINITY) : s.r2, 0, to->r2);
    vstore16(empty ? (realn)(INFINITY) : s.power, 0, to->power);
    vstore16(id, 0, to->id);
}
