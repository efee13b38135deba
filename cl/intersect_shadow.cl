// intersect_shadow: does anything stand between each hit and one light?
//
// Reads what intersect_closest wrote (t, normal, id) with dirs, and the spheres as this light's pencil sees them.
// Writes arrival: what arrives of the light (arriving() of its pencil, > 0) where a hit faces it and nothing is in
// between, else 0. Where the spheres come in chunks (-D CHUNKS=1) and this is not the first of them, arrival is read,
// and what arrives there may be taken away. One work-item: PACKETS * LANES neighbouring rays against the spheres that
// their fat ray may meet.
#include "shadow.h"

kernel void intersect_shadow(global const real* restrict dirs, global const real* restrict ts,
                             global const real* restrict normals, global const int* restrict ids,
                             global const PencilCluster* restrict clusters, global const Node* restrict nodes,
                             global real* restrict arrival, const LightPencil light, const Pass pass,
                             const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= pass.items) return;
    realw share[PACKETS];
    ShadowRay ray[PACKETS];
    const Hierarchy hierarchy = {clusters, nodes, pass.levels, pass.last};
    const Hits hits = {dirs, ts, normals, ids};
    FOR_PACKETS(k) {
        ray[k] = shadow_ray(light, position_of(hits, item, k));
#if CHUNKS
        share[k] = pass.first_chunk ? unshadowed(hits, light, ray[k], item, k) : load_r(arrival, item, k);
#else
        share[k] = unshadowed(hits, light, ray[k], item, k);
#endif
    }
    trace_shadows(hits, hierarchy, light, ray, pass.group_depth, item, share, (Certainty){0});
    FOR_PACKETS(k) store_r(share[k], arrival, item, k);
}
