// The closest hits of a work-item's rays, and how a sphere may bring them closer.
#ifndef GNOMON_CLOSEST_HIT_H
#define GNOMON_CLOSEST_HIT_H

#include "certify.h"
#include "grazing.h"

// The closest hit so far.
typedef struct {
    realw t;
    wholew id;
    vec3w center;
} Hit;

// What is sure of the closest hits.
typedef struct {
    realw first[PACKETS], second[PACKETS];  // no nearer begins what the rays may meet, and what they may besides
    real steep;                             // of all spheres that they hit: certify.h
} Bounds;

INLINE Bounds no_bounds(void) {
    Bounds bounds;
#if REAL_IS_DOUBLE
    bounds.steep = 0;
#else
    bounds.steep = MOST_STEEP;
#endif
    FOR_PACKETS(k) bounds.first[k] = bounds.second[k] = wide(INFINITY);
    return bounds;
}

INLINE Hit no_hit(void) {
    const Hit hit = {wide(INFINITY), (wholew)(-1), {wide(0.0f), wide(0.0f), wide(0.0f)}};
    return hit;
}

// Copies of what packets have, for a loop over them that is not unrolled: so everything else stays in registers.
typedef struct {
    vec3w dir[PACKETS];
    Hit hit[PACKETS];
} Packets;

INLINE Packets copies_of(const vec3w* dir, const Hit* hit) {
    Packets copies;
    FOR_PACKETS(k) {
        copies.dir[k] = dir[k];
        copies.hit[k] = hit[k];
    }
    return copies;
}

#if !CERTIFIED

// Whether a sphere that the rays meet could be closer to one of them than what they hit so far: no root is nearer than
// b - r but for roundings, which `reach` allows for (reach.h). Few spheres meet all rays of a block or none, so that a
// branch for each packet would only be guessed wrong; many are small, and mostly behind what is hit already.
INLINE int may_be_closer(wholew meets, realw b, float reach, Hit hit) {
#if WALK == WALK_NODES
    return any_lane(meets & (b - (real)reach < hit.t));
#else
    return 1;
#endif
}

// Of equal distances the lowest id's.
INLINE void keep_closer(PencilSphere s, wholew meets, realw t, Hit* hit) {
    const wholew closer = meets & (t > 0.0f) & ((t < hit->t) | ((t == hit->t) & (hit->id > s.id)));
    hit->t = choose(closer, t, hit->t);
    hit->id = choose(closer, (wholew)(s.id), hit->id);
    hit->center = select_w(closer, broadcast(s.center), hit->center);
}

// The few rays that may graze the sphere, as `intersect` leaves them.
INLINE int intersect_grazed(PencilSphere s, const vec3w* dir, Hit* hit) {
    Packets own = copies_of(dir, hit);
    const SphereRests rests = rests_of(s);
    const real edge = grazing_edge(s);
    ONE_PACKET_AT_A_TIME(k) {
        const realw b = dot_r(s.center, own.dir[k]);
        realw discriminant = sphere_discriminant(s, own.dir[k], b);
        const wholew grazes = may_meet(s, b, discriminant, edge) & is_grazing(discriminant, edge);
        if (!any_lane(grazes) || !may_be_closer(grazes, b, s.reach, own.hit[k])) continue;
        const realw t = compensated_root(s, rests, own.dir[k], &discriminant);
        keep_closer(s, grazes & (discriminant >= 0.0f), t, own.hit + k);
    }
    FOR_PACKETS(k) hit[k] = own.hit[k];
    return 1;
}

// 0 when no ray can have a closer hit now than before.
INLINE int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit, Bounds* bounds) {
    realw b[PACKETS], discriminant[PACKETS];
    wholew meets[PACKETS], any = 0, any_grazes = 0;
    const real edge = grazing_edge(s);
    FOR_PACKETS(k) {
        b[k] = dot_r(s.center, dir[k]);
        discriminant[k] = sphere_discriminant(s, dir[k], b[k]);
        meets[k] = may_meet(s, b[k], discriminant[k], edge);
        any |= meets[k];
    }
    if (!any_lane(any)) return 0;
    int any_closer = 0;
    FOR_PACKETS(k) {
        const wholew grazes = meets[k] & is_grazing(discriminant[k], edge);
        any_grazes |= grazes;
        meets[k] &= !grazes;
        if (!may_be_closer(meets[k], b[k], s.reach, hit[k])) continue;
        any_closer = 1;
        keep_closer(s, meets[k], sphere_root(s, b[k], discriminant[k]), hit + k);
    }
    if (UNLIKELY(any_lane(any_grazes))) any_closer |= intersect_grazed(s, dir, hit);
    return any_closer;
}

INLINE realw reaches(Hit hit) { return hit.t; }

#endif

// With 1 / |position - centre|, at hits.
INLINE vec3w outward_normal(Hit hit, vec3w dir, realw* inverse) {
    *inverse = wide(0.0f);
    const vec3w infinite = broadcast((Real3){INFINITY, INFINITY, INFINITY});
    const wholew hits = hit.id >= 0;
    // One lane alone has nothing to skip, and LLVM in PoCL 6 would abort ("did not reach a fixpoint").
    if (LANES > 1 && !any_lane(hits)) return infinite;
    const vec3w out = fma_w(hit.t, dir, (vec3w){-hit.center.x, -hit.center.y, -hit.center.z});
    *inverse = divide(wide(1.0f), square_root(dot_w(out, out)));
    return select_w(hits, scale_w(*inverse, out), infinite);
}

#endif
