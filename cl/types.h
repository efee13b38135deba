// Structs and constants that cross between host and device: scalars and packed triples only, reals (real.h) and 32-bit
// ones. Included by both; the sizes are asserted at the end for whichever compiler reads this.
#ifndef GNOMON_TYPES_H
#define GNOMON_TYPES_H

#include "real.h"

// Rays travel in blocks of 8 x 8 pixels. In every ray and hit buffer a block is 64 neighbouring values for each
// component (x of all 64 rays, then y, then z); inside a block the order is row by row. Nothing in memory depends on
// the lane width.
#define BLOCK_SIDE 8
#define BLOCK_RAYS 64

#define LIGHT_DIRECTIONAL 0
#define LIGHT_POINT 1

// How rays meet the spheres: all of them, one by one (but for the eye's rays, whose fat ray costs next to nothing);
// those that their fat ray (fat_ray.h) may meet, of each cluster that a ball around it, or the nodes above it, do not
// rule out.
#define WALK_SPHERES 0
#define WALK_CLUSTERS 1
#define WALK_NODES 2

// Where intersect_closest has its rays from: generate_rays, a launch before, or itself.
#define RAYS_READ 0
#define RAYS_GENERATED 1

// What intersect_closest writes of the hits: all, of misses too; or what lights need, of packets that hit.
#define HITS_ALL 0
#define HITS_FOR_LIGHTS 1

// Where shade_light has its shadows from.
#define SHADOWS_OFF 0
#define SHADOWS_READ 1
#define SHADOWS_TRACED 2

// Lights that one launch of shade_light adds, at most.
#define MOST_SHADED 4

#ifdef __cplusplus
namespace gnomon {
#endif

STRUCT_OF_REALS(Real3) { real x, y, z; };

#if REAL_IS_DOUBLE
typedef struct {
    float x, y, z;
} Float3;
#else
typedef Real3 Float3;
#endif

// Spheres travel in clusters of 16, which the order of the hierarchy makes neighbours. Places that nothing fills have
// id -1.
#define CLUSTER 16

// Spheres as the scene has them, from its origin and in its unit (frame.h).
typedef struct {
    float x[CLUSTER], y[CLUSTER], z[CLUSTER], radius[CLUSTER];
    int id[CLUSTER];
} Cluster;

// Words of the keys by which spheres are sorted: three of 10 bits of each coordinate, and a hash (sphere_keys). Above
// the first are size classes, for spheres of more than so many times the middle radius.
#define HILBERT_BITS 10
#define KEY_BITS (3 * HILBERT_BITS)
#define PLACE_WORDS 3
#define HASH_WORD 3
#define MUCH_LARGER 8

// Digits by which keys are sorted: three a key, or four where there are size classes above it. Of 8 bits
// they would be four always, and a pass takes no longer for 10: a CPU's caches hold the places of 1024 digits as well.
// One work-item of scan_counts has DIGITS_AN_ITEM.
#define DIGIT_BITS 10
#define DIGITS (1 << DIGIT_BITS)
#define DIGITS_AN_ITEM 16

// What rounding left over of a cluster's numbers, where they are no floats: the exact ones are the sums of both.
typedef struct {
    float x[CLUSTER], y[CLUSTER], z[CLUSTER], radius[CLUSTER];
} ClusterRest;

// The spheres of a cluster as one pencil sees them. reach is the radius widened for conservative tests (reach.h); no
// ball of an empty place reaches anything, and no line meets it.
STRUCT_OF_REALS(PencilCluster) {
    real x[CLUSTER], y[CLUSTER], z[CLUSTER];  // centre from the apex; parallel: from the eye, in the pencil's basis
    float reach[CLUSTER];
    real r2[CLUSTER];     // radius^2
    real power[CLUSTER];  // |centre|^2 - radius^2, the power of the apex (parallel: of the eye): < 0 inside
    int id[CLUSTER];
};

// Bounds of 16 children as one pencil sees them, in its basis: rectangles across the axis, on a plane at distance 1
// (parallel: across the light), and the distance from the apex where the first sphere begins (parallel: along the
// light, where the last one ends). Children are sorted by depth.
typedef struct {
    float x0[CLUSTER], x1[CLUSTER], y0[CLUSTER], y1[CLUSTER];
    float depth[CLUSTER];
    int child[CLUSTER];  // a node, or on the lowest level a cluster
} Node;

// 16^8 spheres are more than an int counts.
#define MAX_LEVELS 8

// Three orthonormal directions; what is seen along `axis` is told apart across it. Bounds are floats in all programs.
typedef struct {
    Float3 u, v, axis;
} Basis;

// Around the positions of a block's hits, if it has any.
typedef struct {
    Float3 least, most;
} HitsBox;

// A point to a real's precision twice over: hi + lo.
STRUCT_OF_REALS(Apex) { OF_REALS(Real3) hi, lo; };

// Rays from the eye: pixel (i, j) looks along forward + (2i + 1 - width) right + (height - 1 - 2j) up.
STRUCT_OF_REALS(EyePencil) {
    OF_REALS(Real3) forward, right, up;
    int width, height;  // pixels
};

// Rays toward a directional light, along the axis; positions are relative to the eye, in the orthonormal basis of these
// three.
STRUCT_OF_REALS(ParallelPencil) { OF_REALS(Real3) u, v, axis; };

// Rays from a point light. Bounds are kept for each of its faces: one when all spheres lie on one side of the light,
// else the six of a cube around it.
#define MAX_FACES 6
STRUCT_OF_REALS(PointPencil) {
    OF_REALS(Real3) origin;  // relative to the eye
    int faces;
    Basis face[MAX_FACES];
};

// A rectangle of blocks that one chain of launches computes.
typedef struct {
    int x, y;      // its first pixel
    int blocks_x;  // blocks in a row
    int blocks;    // blocks in all
} Tile;

// Planes of pixels, row by row.
typedef struct {
    int width, height;     // of the image
    int first_x, first_y;  // the pixel of a plane's first value
    int pitch;             // values a row
} Planes;

// What the launches of one pass, the eye's or a light's, over a tile are told, beside their buffers: in one argument,
// for PoCL takes 0.1 to 0.2 us for each, and 2 us for a launch without.
typedef struct {
    Tile tile;
    int items;          // work-items of the pass
    int first_block;    // blocks of the tiles before this one
    int levels, last;   // of the hierarchy (hierarchy.h)
    int first_chunk;    // 1: no spheres were met before these
    int arrival;        // of the arrivals, the one that the pass writes; -1: hits are shaded
    float group_depth;  // shadow rays whose distances from the eye differ by less than this factor are traced together
    float base_doubt;   // how far the scene's numbers may be off (certify.h)
} Pass;

// What shade_light is told besides, of the lights that it adds.
STRUCT_OF_REALS(Shading) {
    OF_REALS(Real3) phi[MOST_SHADED];
    int first_albedo, albedo_stride;  // in floats, from id to id
    int first;                        // 1: no light was added before these
    int last;                         // 1: the launch resolves what it leaves
    Planes planes;
};

// A sphere as a pencil sees it, for measure_roots: from the apex, with power = |center|^2 - radius^2 rounded once.
typedef struct {
    Float3 center;
    float radius, power;
} RootSphere;

#define ASSERT_SIZE(type, bytes) typedef char assert_size_of_##type[sizeof(type) == (bytes) ? 1 : -1]
// Of a struct of floats, and of doubles.
#ifdef __cplusplus
#define ASSERT_SIZES(type, of_floats, of_doubles)                 \
    static_assert(sizeof(type##Of<float>) == (of_floats), #type); \
    static_assert(sizeof(type##Of<double>) == (of_doubles), #type)
#elif REAL_IS_DOUBLE
#define ASSERT_SIZES(type, of_floats, of_doubles) ASSERT_SIZE(type, of_doubles)
#else
#define ASSERT_SIZES(type, of_floats, of_doubles) ASSERT_SIZE(type, of_floats)
#endif
ASSERT_SIZE(Float3, 12);
ASSERT_SIZES(Real3, 12, 24);
ASSERT_SIZE(Cluster, 5 * 4 * CLUSTER);
ASSERT_SIZE(ClusterRest, 4 * 4 * CLUSTER);
ASSERT_SIZES(PencilCluster, 7 * 4 * CLUSTER, (5 * 8 + 2 * 4) * CLUSTER);
ASSERT_SIZE(Node, 6 * 4 * CLUSTER);
ASSERT_SIZES(Apex, 24, 48);
ASSERT_SIZES(EyePencil, 44, 80);
ASSERT_SIZES(ParallelPencil, 36, 72);
ASSERT_SIZES(PointPencil, 16 + 36 * MAX_FACES, 24 + 4 + 36 * MAX_FACES + 4);  // rounded up to whole doubles
ASSERT_SIZE(Tile, 16);
ASSERT_SIZE(Planes, 20);
ASSERT_SIZE(Pass, 48);
ASSERT_SIZES(Shading, 12 * MOST_SHADED + 36, 24 * MOST_SHADED + 40);  // rounded up to whole doubles
ASSERT_SIZE(RootSphere, 20);

#ifdef __cplusplus
}
#endif

#endif
