// intersect_closest: the first sphere that each ray of the eye's pencil meets.
//
// Reads dirs (block order, 3 a ray) and the hierarchy of the spheres as the eye sees them; with -D RAYS=RAYS_GENERATED
// it writes dirs itself, as generate_rays would, but not those of work-items that meet nothing. Writes per ray t, the
// outward unit normal and the id (a miss: +inf, (inf, inf, inf), -1); adds to hit_counts[first_group + g] how many more
// rays of work-group g hit. Where the spheres come in chunks (-D CHUNKS=1) and this is not the first of them, what was
// written for those before is read, and stays where nothing is closer. With -D CERTIFIED=1 it also sets the bits of the
// rays of which rounding may decide what they hit in undecided (one a ray, from word first_word on), and keeps in
// doubts what is to be known of all others' hits (certify.h). One work-item: PACKETS * LANES neighbouring rays of a
// block against the spheres that their fat ray may meet.
#include "certify.h"
#include "eye_pencil.h"
#include "fat_ray.h"
#include "grazing.h"
#include "ray_buffers.h"
#include "sphere.h"

#define FAT FatRay
#define NODE_CANDIDATES node_candidates
#include "hierarchy.h"

// The closest hit so far.
typedef struct {
    realw t;
    wholew id;
    vec3w center;
} Hit;

// What is sure of the closest hits.
typedef struct {
    realw other[PACKETS];  // whatever else the rays may meet begins no nearer
    real steep;            // of all spheres that they hit: certify.h
} Bounds;

static inline Hit no_hit(void) {
    const Hit hit = {wide(INFINITY), (wholew)(-1), {wide(0.0f), wide(0.0f), wide(0.0f)}};
    return hit;
}

static inline void store_misses(global real* ts, global real* normals, global int* ids, int item) {
    FOR_PACKETS(k) {
        store_r(wide(INFINITY), ts, item, k);
        store_3(broadcast((Real3){INFINITY, INFINITY, INFINITY}), normals, item, k);
        store_i((wholew)(-1), ids, item, k);
    }
}

// The next cluster with spheres that the fat ray may meet, and these as bits; -1 after the last. A call would copy the
// fat ray to memory each time, which is 5 % of the time that 10^6 spheres take.
__attribute__((always_inline)) static inline int next_candidates(Hierarchy hierarchy, Traversal* traversal, FatRay fat,
                                                                 int* spheres) {
    int c;
    do {
        c = next_cluster(hierarchy, traversal, fat);
        *spheres = c < 0 ? 0 : candidates(fat, hierarchy.clusters + c);
    } while (c >= 0 && !*spheres);
    return c;
}

#if CERTIFIED

// As below, but only what bounds settle is a hit; of all else is kept where it may begin.
static inline int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit, Bounds* bounds) {
    const Doubt doubt = doubt_of(s, base);
    const real behind = surely_outside(s, doubt.power) ? -doubt.shift : -INFINITY;
    realw b[PACKETS], discriminant[PACKETS];
    wholew near[PACKETS], any = 0;
    FOR_PACKETS(k) {
        b[k] = dot_r(s.center, dir[k]);
        discriminant[k] = sphere_discriminant(s, dir[k], b[k]);
        near[k] = !((discriminant[k] < -doubt.discriminant) | (b[k] < behind));
        any |= near[k];
    }
    if (!any_lane(any)) return 0;
    const RootDoubt off = root_doubt(s, doubt);
#if REAL_IS_DOUBLE
    bounds->steep = off.plain < INFINITY ? MORE(bounds->steep, off.steep) : bounds->steep;  // else it is nobody's hit
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
    }
    return 1;
}

// What begins beyond cannot come before the hit.
static inline realw reaches(Hit hit) { return fma(hit.t, wide(MOST_OFF), hit.t); }

#else

// Whether a sphere that the rays meet could be closer to one of them than what they hit so far: no root is nearer than
// b - r but for roundings, which `reach` allows for (reach.h). Few spheres meet all rays of a block or none, so that a
// branch for each packet would only be guessed wrong; many are small, and mostly behind what is hit already.
static inline int may_be_closer(wholew meets, realw b, float reach, Hit hit) {
#if WALK == WALK_NODES
    return any_lane(meets & (b - (real)reach < hit.t));
#else
    return 1;
#endif
}

// Of equal distances the lowest id's.
static inline void keep_closer(PencilSphere s, wholew meets, realw t, Hit* hit) {
    const wholew closer = meets & (t > 0.0f) & ((t < hit->t) | ((t == hit->t) & (hit->id > s.id)));
    hit->t = choose(closer, t, hit->t);
    hit->id = choose(closer, (wholew)(s.id), hit->id);
    hit->center = select_w(closer, broadcast(s.center), hit->center);
}

// The rays that may graze the sphere, as `intersect` leaves them. They are few, and this works on copies, so that
// everything else stays in registers.
static inline int intersect_grazed(PencilSphere s, const vec3w* dir, Hit* hit) {
    vec3w dirs[PACKETS];
    Hit hits[PACKETS];
    FOR_PACKETS(k) {
        dirs[k] = dir[k];
        hits[k] = hit[k];
    }
    const SphereRests rests = rests_of(s);
    const real edge = grazing_edge(s);
    ONE_PACKET_AT_A_TIME(k) {
        const realw b = dot_r(s.center, dirs[k]);
        realw discriminant = sphere_discriminant(s, dirs[k], b);
        const wholew grazes = may_meet(s, b, discriminant, edge) & is_grazing(discriminant, edge);
        if (!any_lane(grazes) || !may_be_closer(grazes, b, s.reach, hits[k])) continue;
        const realw t = compensated_root(s, rests, dirs[k], &discriminant);
        keep_closer(s, grazes & (discriminant >= 0.0f), t, hits + k);
    }
    FOR_PACKETS(k) hit[k] = hits[k];
    return 1;
}

// 0 when no ray can have a closer hit now than before.
static inline int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit, Bounds* bounds) {
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

static inline realw reaches(Hit hit) { return hit.t; }

#endif

// Where the farthest of the closest hits is; rays that are none do not count.
static inline float farthest_hit(const Hit* hit, const wholew* valid) {
    floatw farthest = wide_float(0.0f);
    FOR_PACKETS(k) farthest = MORE_WHERE(ints_of(valid[k]), floats_of(reaches(hit[k])), farthest);
    return REDUCE(most, farthest);
}

// With 1 / |position - centre|, at hits.
static inline vec3w outward_normal(Hit hit, vec3w dir, realw* inverse) {
    *inverse = wide(0.0f);
    const vec3w infinite = broadcast((Real3){INFINITY, INFINITY, INFINITY});
    const wholew hits = hit.id >= 0;
    if (!any_lane(hits)) return infinite;
    const vec3w out = fma_w(hit.t, dir, (vec3w){-hit.center.x, -hit.center.y, -hit.center.z});
    *inverse = divide(wide(1.0f), square_root(dot_w(out, out)));
    return select_w(hits, scale_w(*inverse, out), infinite);
}

#if CERTIFIED
// Whether it is certain what the ray meets, if that may be off by so much: whatever else there is begins beyond. A miss
// must have met nothing at all. What is added to t's own doubt (position_doubt) is nothing beside it.
static inline wholew is_certain(wholew hits, Hit hit, realw other, realw off) {
    return other > choose(hits, hit.t + off, wide(MAXFLOAT));
}
#endif

kernel void intersect_closest(global real* restrict dirs, const EyePencil eye, const Tile tile, const Basis basis,
                              global const PencilCluster* restrict clusters, global const Node* restrict nodes,
                              const int levels, const int last, const int first_chunk, const int items,
                              global real* restrict ts, global real* restrict normals, global int* restrict ids,
                              const int first_group, global int* restrict hit_counts, const real base,
                              global real* restrict doubts, global uint* restrict undecided, const int first_word,
                              const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    const Hierarchy hierarchy = {clusters, nodes, levels, last};
    vec3w dir[PACKETS];
    Hit hit[PACKETS];
    Bounds bounds;
#if REAL_IS_DOUBLE
    bounds.steep = 0;
#else
    bounds.steep = MOST_STEEP;
#endif

    wholew valid[PACKETS];
#if RAYS == RAYS_GENERATED
    // Most work-items that meet nothing are known before their rays are.
    FatRay fat = eye_fat_ray(eye, tile, item, basis);
    Traversal traversal = begin(hierarchy, fat);
    int rest, c = next_candidates(hierarchy, &traversal, fat, &rest);
    if (c < 0) {
        store_misses(ts, normals, ids, item);
        return;
    }
#endif
    FOR_PACKETS(k) {
#if RAYS == RAYS_GENERATED
        dir[k] = eye_rays(eye, tile, item, k);
        store_3(dir[k], dirs, item, k);
#else
        dir[k] = load_3(dirs, item, k);
#endif
        valid[k] = dir[k].x == dir[k].x;  // pixels outside the image are NaN
        hit[k] = no_hit();
        bounds.other[k] = wide(INFINITY);
    }
#if CHUNKS
    if (!first_chunk) FOR_PACKETS(k) {
            hit[k].t = load_r(ts, item, k);
            hit[k].id = load_i(ids, item, k);
        }
#endif
#if RAYS == RAYS_READ
    FatRay fat = fat_ray(dir, valid, basis);
#if CHUNKS
    fat.distance = farthest_hit(hit, valid);
#endif
    Traversal traversal = begin(hierarchy, fat);
    int rest, c = next_candidates(hierarchy, &traversal, fat, &rest);
#endif
    for (; c >= 0; c = next_candidates(hierarchy, &traversal, fat, &rest)) {
        int closer = 0;
        for (; rest; rest &= rest - 1)
            closer |= intersect(sphere_of(clusters + c, lowest_bit(rest)), dir, base, hit, &bounds);
#if WALK == WALK_NODES
        if (!closer) continue;
        traversal.farthest = farthest_hit(hit, valid);
        fat.distance = traversal.farthest;
#endif
    }
    wholew hits = 0;
#if CERTIFIED
    ulong open = 0;
    realw farthest_off = wide(0.0f), most_curved = wide(0.0f);
#endif
    FOR_PACKETS(k) {
        store_r(hit[k].t, ts, item, k);
        realw inverse;
        vec3w normal = outward_normal(hit[k], dir[k], &inverse);
#if CERTIFIED
        const wholew hit_any = hit[k].id >= 0;
        const realw off = position_doubt(hit[k].t, dir[k], normal, bounds.steep, base);
        const wholew certain = is_certain(hit_any, hit[k], bounds.other[k], off);
        open |= bits_of_packet(valid[k] & !certain, k);
        farthest_off = MORE_WHERE(hit_any & certain, off, farthest_off);
        most_curved = MORE_WHERE(hit_any & certain, inverse, most_curved);
#endif
        hits += choose(hit[k].id >= 0, (wholew)(1), (wholew)(0));
#if CHUNKS
        if (!first_chunk) {
            const wholew before = load_i(ids, item, k);  // hits that stayed as they were have no centre here
            normal = select_w(hit[k].id != before, normal, load_3(normals, item, k));
            hits -= choose(before >= 0, (wholew)(1), (wholew)(0));
        }
#endif
        store_3(normal, normals, item, k);
        store_i(hit[k].id, ids, item, k);
    }
#if CERTIFIED
    keep_doubts(farthest_off, most_curved, doubts, doubts_place(first_word, item));
    leave_undecided(open, (Undecided){undecided, first_word}, item);
#endif
    atomic_add(hit_counts + first_group + group_of_all(first_item), REDUCE(count, ints_of(hits)));
}
