// bound_clusters: the lowest level of nodes, over the clusters as one pencil sees them.
//
// Reads the clusters. Writes nodes[origin + i], whose children are the clusters from 16 i on, as far as there are any.
// -D PARALLEL=1: rectangles across the light (the clusters are in its basis already); else as `basis` sees them from
// the apex. One work-item: one node.
#include "bounds.h"
#include "cluster.h"

static inline float16 dot_16(Float3 a, float16 x, float16 y, float16 z) {
    return fma((float16)(a.x), x, fma((float16)(a.y), y, (float16)(a.z) * z));
}

#if PARALLEL

static inline Rectangles rectangles(global const PencilCluster* c, Basis basis) {
    const float16 x = floats_at(c->x, 0), y = floats_at(c->y, 0), z = floats_at(c->z, 0), reach = vload16(0, c->reach);
    return (Rectangles){x - reach, x + reach, y - reach, y + reach, z + reach};
}

#else

// The rectangle of a ball in front of the apex, near > 0: all its points have x in [x - reach, x + reach] and z in
// [near, far].
static inline float16 lower(float16 x, float16 near, float16 far) { return x / (x < 0.0f ? near : far); }
static inline float16 upper(float16 x, float16 near, float16 far) { return x / (x > 0.0f ? near : far); }

// A ball in front has a rectangle, one behind the apex meets no ray of this face, and one that is in both halves may be
// seen anywhere.
static inline Rectangles rectangles(global const PencilCluster* c, Basis basis) {
    const float16 x = floats_at(c->x, 0), y = floats_at(c->y, 0), z = floats_at(c->z, 0), reach = vload16(0, c->reach);
    const float16 p = dot_16(basis.u, x, y, z), q = dot_16(basis.v, x, y, z), s = dot_16(basis.axis, x, y, z);
    const float16 near = s - reach, far = s + reach, infinite = INFINITY;
    const int16 front = near > 0.0f, behind = far < 0.0f;
    const float16 outside = behind ? infinite : -infinite;
    return (Rectangles){front ? lower(p - reach, near, far) : outside, front ? upper(p + reach, near, far) : -outside,
                        front ? lower(q - reach, near, far) : outside, front ? upper(q + reach, near, far) : -outside,
                        sqrt(fma(x, x, fma(y, y, z * z))) - reach};
}

#endif

kernel void bound_clusters(global const PencilCluster* restrict clusters, const Basis basis, const int count,
                           const int origin, const int items, global Node* restrict nodes, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    Children children;
    for (int i = 0; i < CLUSTER; ++i) {
        const int child = item * CLUSTER + i;
        if (child >= count) {
            unite(empty_rectangles(), &children, i, -1);
            continue;
        }
        global const PencilCluster* c = clusters + child;
        const Rectangles none = empty_rectangles(), r = rectangles(c, basis);
        const int16 empty = vload16(0, c->id) < 0;
        unite((Rectangles){empty ? none.x0 : r.x0, empty ? none.x1 : r.x1, empty ? none.y0 : r.y0,
                           empty ? none.y1 : r.y1, empty ? none.depth : r.depth},
              &children, i, child);
    }
    write_sorted(&children, nodes + origin + item);
}
