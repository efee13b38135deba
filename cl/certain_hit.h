// The closest hits of a work-item's rays in certified pictures: as closest_hit.h has them, but only of what bounds
// settle.
#ifndef GNOMON_CERTAIN_HIT_H
#define GNOMON_CERTAIN_HIT_H

#include "closest_hit.h"

#if CERTIFIED

#if !REAL_IS_DOUBLE
// The few hits of the sphere that graze it get the distance that strict pictures have.
INLINE void mend_grazed(PencilSphere s, const vec3w* dir, real edge, Hit* hit) {
    Packets own = copies_of(dir, hit);
    const SphereRests rests = rests_of(s);
    ONE_PACKET_AT_A_TIME(k) {
        realw discriminant = sphere_discriminant(s, own.dir[k], dot_r(s.center, own.dir[k]));
        const wholew grazes = (own.hit[k].id == s.id) & is_grazing(discriminant, edge);
        if (!any_lane(grazes)) continue;
        own.hit[k].t = choose(grazes, compensated_root(s, rests, own.dir[k], &discriminant), own.hit[k].t);
    }
    FOR_PACKETS(k) hit[k].t = own.hit[k].t;
}
#endif

// As there, but only what bounds settle is a hit; of all else is kept where it may begin.
INLINE int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit, Bounds* bounds) {
    const Doubt doubt = doubt_of(s, base);
    realw b[PACKETS], discriminant[PACKETS];
    wholew near[PACKETS], any = 0;
    FOR_PACKETS(k) {
        b[k] = dot_r(s.center, dir[k]);
        discriminant[k] = sphere_discriminant(s, dir[k], b[k]);
        near[k] = may_be_met(s, doubt, b[k], discriminant[k]);
        any |= near[k];
    }
    if (!any_lane(any)) return 0;
    const RootDoubt off = root_doubt(s, doubt);
#if REAL_IS_DOUBLE
    bounds->steep = off.plain < INFINITY ? MORE(bounds->steep, off.steep) : bounds->steep;  // else it is nobody's hit
#else
    const real edge = grazing_edge(s);
    wholew any_grazes = 0;
#endif
    const real kept = 1 - LESS(1.0625f * STEEPEST * bounds->steep, MOST_OFF);  // of t, at least
    FOR_PACKETS(k) {
        const realw t = sphere_root(s, b[k], discriminant[k]);
        const wholew plain = near[k] & (discriminant[k] > off.plain), closer = plain & (t < hit[k].t);
        const realw loser = kept * choose(closer, hit[k].t, choose(plain, t, wide(INFINITY)));
        const realw other = choose(near[k] & !plain, b[k] - off.back, loser);
        bounds->other[k] = choose(other < bounds->other[k], other, bounds->other[k]);
        hit[k].t = choose(closer, t, hit[k].t);
        hit[k].id = choose(closer, (wholew)(s.id), hit[k].id);
        hit[k].center = select_w(closer, broadcast(s.center), hit[k].center);
#if !REAL_IS_DOUBLE
        any_grazes |= closer & is_grazing(discriminant[k], edge);
#endif
    }
#if !REAL_IS_DOUBLE
    if (UNLIKELY(any_lane(any_grazes))) mend_grazed(s, dir, edge, hit);
#endif
    return 1;
}

// What begins beyond cannot come before the hit.
INLINE realw reaches(Hit hit) { return fma(hit.t, wide(MOST_OFF), hit.t); }

// Whether it is certain what the ray meets, if that may be off by so much: whatever else there is begins beyond. A miss
// must have met nothing at all. What is added to t's own doubt (position_doubt) is nothing beside it.
INLINE wholew is_certain(wholew hits, Hit hit, realw other, realw off) {
    return other > choose(hits, hit.t + off, wide(MAXFLOAT));
}

#endif

#endif
