// The closest hits of a work-item's rays in certified pictures: as closest_hit.h has them, but only of what bounds
// settle.
#ifndef GNOMON_CERTAIN_HIT_H
#define GNOMON_CERTAIN_HIT_H

#include "closest_hit.h"

#if CERTIFIED

// What the root t of a plain meeting is at least. The true D is no less than 3/4 of what is known, so that 1.16 r /
// sqrt(D) is no less than the true x, and 5/4 of k (1 + r / sqrt(D)) than what t is off by.
INLINE realw least_root(realw t, PencilSphere s, RootDoubt off, realw discriminant) {
    const real slope = 1.25f * off.steep;
    return fma(-t, fma(wide(slope * radius_of(s)), reciprocal_bound(square_root(discriminant)), wide(slope)), t);
}

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
    FOR_PACKETS(k) {
        const wholew plain = near[k] & (discriminant[k] > off.plain);
        const realw t = choose(plain, sphere_root(s, b[k], discriminant[k]), wide(INFINITY));
        const wholew closer = t < hit[k].t;
        const realw no_plain = choose(near[k], b[k] - off.back, wide(INFINITY));
        const realw begin = choose(plain, least_root(t, s, off, discriminant[k]), no_plain);
        const realw later = choose(begin > bounds->first[k], begin, bounds->first[k]);
        bounds->first[k] = choose(begin < bounds->first[k], begin, bounds->first[k]);
        bounds->second[k] = choose(later < bounds->second[k], later, bounds->second[k]);
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

// What begins beyond leaves no hit undecided, however steep both are, so that it does not matter whether it is looked
// at (docs/accuracy.md, "What is passed over").
INLINE realw reaches(Hit hit) { return fma(hit.t, wide(2 * MOST_OFF), hit.t); }

// Where what else the ray of packet k may meet begins. If that is nearer than its hit does, so that the hit itself is
// the second, neither is beyond the hit.
INLINE realw other_than(Hit hit, const Bounds* bounds, int k) {
    return choose(hit.id >= 0, bounds->second[k], bounds->first[k]);
}

// Whether it is certain what the ray meets, if that may be off by so much: whatever else there is begins beyond. A miss
// must have met nothing at all. What is added to t's own doubt (position_doubt) is nothing beside it.
INLINE wholew is_certain(Hit hit, realw other, realw off) {
    const realw reach = hit.t + off;
    return other > choose(reach < MAXFLOAT, reach, wide(MAXFLOAT));
}

// What lights must know of the hits that are certain: the most of each lane.
typedef struct {
    realw position, curvature;
} HitDoubts;

// Hits of which little needs to be asked to see that all are certain: none is steep, and nothing is near. Steepness 16
// may count as 18 (reciprocal_bound), which leaves t off by less than (1.3 * 40 * 18 + 60) u + base < 2^-14 t + base.
#define EASY_OFF 0x1p-14f
#if REAL_IS_DOUBLE
#define EASY_COSINE INFINITY  // of few rays each is asked
#else
#define EASY_COSINE 0x1p-4f
#endif
typedef struct {
    wholew hard;
    realw t, cosine, curvature;  // the most, the least and the most of each lane
} EasyHits;

INLINE EasyHits no_hits(void) { return (EasyHits){0, wide(0.0f), wide(1.0f), wide(0.0f)}; }

// What a miss has in place of a cosine and of a curvature, inf, NaN or 0, is no less and no more than the others'.
INLINE void add_hit(EasyHits* all, Hit hit, realw other, realw cosine, realw curvature, real base) {
    all->hard |= !is_certain(hit, other, fma(hit.t, wide(EASY_OFF), wide(base)));
    all->t = MORE_WHERE(hit.id >= 0, hit.t, all->t);
    all->cosine = choose(cosine < all->cosine, cosine, all->cosine);
    all->curvature = choose(curvature > all->curvature, curvature, all->curvature);
}

INLINE int are_easy(EasyHits all) { return !any_lane(all.hard | (all.cosine < EASY_COSINE)); }

INLINE HitDoubts easy_doubts(EasyHits all, real steep, real base) {
    return (HitDoubts){position_doubt(all.t, all.cosine, steep, base), all.curvature};
}

// Of other work-items each hit is asked, as if nothing were known of it. The result is those that are undecided, as
// bits of the work-item.
INLINE ulong undecided_hits(const vec3w* dir, const Hit* hit, const Bounds* bounds, real base, HitDoubts* doubts) {
    Packets own = copies_of(dir, hit);
    realw other[PACKETS];
    FOR_PACKETS(k) other[k] = other_than(hit[k], bounds, k);
    ulong open = 0;
    HitDoubts most = {wide(0.0f), wide(0.0f)};
    ONE_PACKET_AT_A_TIME(k) {
        realw curvature;
        const vec3w normal = outward_normal(own.hit[k], own.dir[k], &curvature);
        const realw cosine = fabs(dot_w(own.dir[k], normal));
        const realw off = position_doubt(own.hit[k].t, cosine, bounds->steep, base);
        const wholew certain = is_certain(own.hit[k], other[k], off), valid = own.dir[k].x == own.dir[k].x;
        const wholew counts = (own.hit[k].id >= 0) & certain;
        open |= bits_of_packet(valid & !certain, k);
        most.position = MORE_WHERE(counts, off, most.position);
        most.curvature = MORE_WHERE(counts, curvature, most.curvature);
    }
    *doubts = most;
    return open;
}

#endif

#endif
