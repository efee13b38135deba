// intersect_shadow: does anything stand between each hit and one light?
//
// Reads what intersect_closest wrote (position, normal, id), and the spheres as this light's pencil sees them.
// Writes one of the arrivals: what arrives of the light (arriving() of its pencil, > 0) where a hit faces it and
// nothing is in between, else 0. Where the spheres come in chunks (-D CHUNKS=1) and this is not the first of them,
// it is read, and what arrives there may be taken away. With -D CERTIFIED=1 hits of which rounding may decide whether
// they are lit are left undecided, by doubts and undecided as intersect_closest wrote them. One work-item: PACKETS *
// LANES neighbouring rays against the spheres that their fat ray may meet.
#include "shadow.h"

kernel void intersect_shadow(HITS_GIVEN, global const PencilCluster* restrict clusters,
                             global const Node* restrict nodes, global real* restrict arrivals, const LightPencil light,
                             const Pass pass, const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= pass.items) return;
    realw share[PACKETS];
    ShadowRay ray[PACKETS];
    const Hierarchy hierarchy = {clusters, nodes, pass.levels, pass.last};
    const Hits hits = HITS_READ;
    const Certainty certainty = certainty_of(hits, light, pass, item);
    ulong open = 0;
    global real* arrival = arrival_of(arrivals, pass, pass.arrival);
#if CHUNKS
    if (!pass.first_chunk) FOR_PACKETS(k) {
            ray[k] = shadow_ray(light, position_of(hits, item, k));
            share[k] = load_r(arrival, item, k);
        }
    else
#endif
        open = face_light(hits, light, certainty, item, ray, share);
    open |= trace_shadows(hits, hierarchy, light, ray, pass.group_depth, item, share, certainty);
    leave_open(open, hits, pass, item);
    FOR_PACKETS(k) store_r(share[k], arrival, item, k);
}
