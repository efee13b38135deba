// intersect_closest: the first sphere that each ray of the eye's pencil meets.
//
// Reads dirs (block order, 3 a ray) and the hierarchy of the spheres as the eye sees them; with -D RAYS=RAYS_GENERATED
// it writes dirs itself, as generate_rays would, but not those of work-items that meet nothing. Writes per ray t, the
// outward unit normal and the id (a miss: +inf, (inf, inf, inf), -1); adds to hit_counts[first_group + g] how many more
// rays of work-group g hit. Where the spheres come in chunks (-D CHUNKS=1) and this is not the first of them, what was
// written for those before is read, and stays where nothing is closer. With -D CERTIFIED=1 it also writes doubts (2 a
// ray): how far the position may be off, +inf where rounding may have decided what is hit, and the normal. One
// work-item: PACKETS * LANES neighbouring rays of a block against the spheres that their fat ray may meet.
#include "certify.h"
#include "eye_pencil.h"
#include "fat_ray.h"
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
#if CERTIFIED
    realw unsure;  // what rounding may have decided lies no nearer than this
#endif
} Hit;

static inline Hit no_hit(void) {
    Hit hit = {wide(INFINITY), (wholew)(-1), {wide(0.0f), wide(0.0f), wide(0.0f)}};
#if CERTIFIED
    hit.unsure = wide(INFINITY);
#endif
    return hit;
}

static inline void store_misses(global real* ts, global real* normals, global int* ids, global real* doubts, int item) {
    FOR_PACKETS(k) {
        store_r(wide(INFINITY), ts, item, k);
        store_3(broadcast((Real3){INFINITY, INFINITY, INFINITY}), normals, item, k);
        store_i((wholew)(-1), ids, item, k);
#if CERTIFIED
        store_2(wide(0.0f), wide(0.0f), doubts, item, k);
#endif
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

// The rays of a packet for which bounds do not settle at once whether the sphere is met, and before what is hit.
static inline void look_closer(PencilSphere s, Doubt doubt, vec3w dir, real base, realw b, realw discriminant,
                               wholew meets, realw t, wholew* closer, Hit* hit) {
    const real edge = doubt.discriminant;
    const int outside = s.power > doubt.power, inside = s.power < -doubt.power;
    const wholew passes = discriminant < -edge, behind = b < -doubt.shift, none = 0;
    const wholew misses = passes | (outside ? behind : none);
    const wholew sure = is_plain(doubt, s, dir, base, b, discriminant) & (outside  ? b > doubt.shift
                                                                          : inside ? !none
                                                                                   : none);
    const realw off = root_doubt(broadcast(s.center), dir, t, base),
                hit_off = root_doubt(hit->center, dir, hit->t, base);
    const realw near = t - off, hit_near = hit->id >= 0 ? hit->t - hit_off : hit->t;
    const wholew apart = (near > hit->t + hit_off) | (t + off < hit_near) | ((hit->id < 0) & (off < INFINITY));
    // Where it is grazed D < 2 edge, or nothing is known.
    const realw grazed = b - (doubt.shift + 1.5f * sqrt(edge)), all = -INFINITY;
    const realw from = (outside ? grazed > -INFINITY : none) ? LESS(grazed, near) : all;
    hit->unsure = LESS(sure | misses ? wide(INFINITY) : near == near ? from : all, hit->unsure);
    hit->unsure = LESS(sure & !apart ? LESS(near, hit_near) : wide(INFINITY), hit->unsure);
    *closer = (meets | sure) & !misses & (t > 0.0f) & (t < hit->t);
}

// 0 when no ray can have a closer hit now than before.
static inline int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit) {
    const Doubt doubt = doubt_of(s, EYE_TURN, base);
    realw b[PACKETS], discriminant[PACKETS];
    wholew near[PACKETS], any = 0;
    FOR_PACKETS(k) {
        b[k] = dot_r(s.center, dir[k]);
        discriminant[k] = sphere_discriminant(s, dir[k], b[k]);
        near[k] = !(discriminant[k] < -doubt.discriminant);
        any |= near[k];
    }
    if (!any_lane(any)) return 0;
    const int sided = fabs(s.power) > MORE(4 * doubt.shift * doubt.shift, doubt.power);
    FOR_PACKETS(k) {
        const realw t = sphere_root(s, b[k], discriminant[k]);
        const wholew meets = sphere_meets(s, b[k], discriminant[k]);
        const wholew plain =
            is_plain(doubt, s, dir[k], base, b[k], discriminant[k]) & (sided ? !(wholew)(0) : (wholew)(0));
        const wholew tied = fabs(t - hit[k].t) <= 4 * PLAINLY * t;
        wholew closer = meets & (t < hit[k].t);
        if (any_lane(near[k] & (!plain | tied)))
            look_closer(s, doubt, dir[k], base, b[k], discriminant[k], meets, t, &closer, hit + k);
        hit[k].t = closer ? t : hit[k].t;
        hit[k].id = closer ? (wholew)(s.id) : hit[k].id;
        hit[k].center = select_w(closer, broadcast(s.center), hit[k].center);
    }
    return 1;
}

// Hits that are not plain are not decided.
static inline realw reaches(Hit hit) { return fma(hit.t, wide(4 * PLAINLY), hit.t); }

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

// 0 when no ray can have a closer hit now than before.
static inline int intersect(PencilSphere s, const vec3w* dir, real base, Hit* hit) {
    realw b[PACKETS], discriminant[PACKETS];
    wholew meets[PACKETS], any = 0;
    FOR_PACKETS(k) {
        b[k] = dot_r(s.center, dir[k]);
        discriminant[k] = sphere_discriminant(s, dir[k], b[k]);
        meets[k] = sphere_meets(s, b[k], discriminant[k]);
        any |= meets[k];
    }
    if (!any_lane(any)) return 0;
    int any_closer = 0;
    FOR_PACKETS(k) {
        if (!may_be_closer(meets[k], b[k], s.reach, hit[k])) continue;
        any_closer = 1;
        const realw t = sphere_root(s, b[k], discriminant[k]);
        // Of equal distances the lowest id's.
        const wholew closer = meets[k] & (t > 0.0f) & ((t < hit[k].t) | ((t == hit[k].t) & (hit[k].id > s.id)));
        hit[k].t = closer ? t : hit[k].t;
        hit[k].id = closer ? (wholew)(s.id) : hit[k].id;
        hit[k].center = select_w(closer, broadcast(s.center), hit[k].center);
    }
    return any_closer;
}

static inline realw reaches(Hit hit) { return hit.t; }

#endif

// Where the farthest of the closest hits is; rays that are none do not count.
static inline float farthest_hit(const Hit* hit, const wholew* valid) {
    floatw farthest = wide_float(0.0f);
    FOR_PACKETS(k) farthest = MORE(floats_of(valid[k] ? reaches(hit[k]) : wide(0.0f)), farthest);
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
// The position is off by t's doubt along the ray and, the ray's turn and two roundings, 8 u t across it; the normal by
// that, the centre's rounding, 1 u |f| <= u (t + r), and out's own, over the radius, which is |out| but for as much.
// Twice the quotient serves while it is below 1/2; beyond, nothing is known.
static inline void store_doubts(Hit hit, vec3w dir, realw inverse, real base, global real* doubts, int item, int k) {
    const wholew hits = hit.id >= 0;
    realw position = wide(0.0f), normal = wide(0.0f);
    wholew sure = hit.unsure == INFINITY;
    if (any_lane(hits)) {
        const realw off = root_doubt(hit.center, dir, hit.t, base);
        const realw share = fma(fma(wide(12 * ROUNDING), hit.t, off + base), inverse, wide(4 * ROUNDING));
        position = hits ? fma(wide(8 * ROUNDING), hit.t, off) : position;
        normal = share < 0.5f ? fma(wide(2.0f), share, wide(4 * ROUNDING)) : wide(INFINITY);
        sure = hits ? hit.unsure > hit.t + off : sure;
    }
    store_2(sure ? position : wide(INFINITY), normal, doubts, item, k);
}
#endif

kernel void intersect_closest(global real* restrict dirs, const EyePencil eye, const Tile tile, const Basis basis,
                              global const PencilCluster* restrict clusters, global const Node* restrict nodes,
                              const int levels, const int last, const int first_chunk, const int items,
                              global real* restrict ts, global real* restrict normals, global int* restrict ids,
                              const int first_group, global int* restrict hit_counts, const real base,
                              global real* restrict doubts) {
    const int item = (int)get_global_id(0);
    if (item >= items) return;
    const Hierarchy hierarchy = {clusters, nodes, levels, last};
    vec3w dir[PACKETS];
    Hit hit[PACKETS];
    wholew valid[PACKETS];
#if RAYS == RAYS_GENERATED
    // Most work-items that meet nothing are known before their rays are.
    FatRay fat = eye_fat_ray(eye, tile, item, basis);
    Traversal traversal = begin(hierarchy, fat);
    int rest, c = next_candidates(hierarchy, &traversal, fat, &rest);
    if (c < 0) {
        store_misses(ts, normals, ids, doubts, item);
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
        for (; rest; rest &= rest - 1) closer |= intersect(sphere_of(clusters + c, lowest_bit(rest)), dir, base, hit);
#if WALK == WALK_NODES
        if (!closer) continue;
        traversal.farthest = farthest_hit(hit, valid);
        fat.distance = traversal.farthest;
#endif
    }
    wholew hits = 0;
    FOR_PACKETS(k) {
        store_r(hit[k].t, ts, item, k);
        realw inverse;
        vec3w normal = outward_normal(hit[k], dir[k], &inverse);
#if CERTIFIED
        store_doubts(hit[k], dir[k], inverse, base, doubts, item, k);
#endif
        hits += hit[k].id >= 0 ? (wholew)(1) : (wholew)(0);
#if CHUNKS
        if (!first_chunk) {
            const wholew before = load_i(ids, item, k);  // hits that stayed as they were have no centre here
            normal = select_w(hit[k].id != before, normal, load_3(normals, item, k));
            hits -= before >= 0 ? (wholew)(1) : (wholew)(0);
        }
#endif
        store_3(normal, normals, item, k);
        store_i(hit[k].id, ids, item, k);
    }
    atomic_add(hit_counts + first_group + get_group_id(0), REDUCE(count, ints_of(hits)));
}
