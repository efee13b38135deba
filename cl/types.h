// Structs and constants that cross between host and device: 32-bit scalars and packed float3 only. Included by both;
// the sizes are asserted at the end for whichever compiler reads this.
#ifndef GNOMON_TYPES_H
#define GNOMON_TYPES_H

// Rays travel in blocks of 8 x 8 pixels. In every ray and hit buffer a block is 64 neighbouring values for each
// component (x of all 64 rays, then y, then z); inside a block the order is row by row. Nothing in memory depends on
// the lane width.
#define BLOCK_SIDE 8
#define BLOCK_RAYS 64

// Which formula decides whether a line from the pencil's apex meets a sphere: see sphere.h.
#define FORM_SMALL 0  // the sphere looks small: perpendicular form
#define FORM_LARGE 1  // the sphere looks large, or the apex is in it: power of the apex

#define LIGHT_DIRECTIONAL 0
#define LIGHT_POINT 1

// Where shade_light has its shadows from.
#define SHADOWS_OFF 0
#define SHADOWS_READ 1
#define SHADOWS_TRACED 2

#ifdef __cplusplus
namespace gnomon {
#endif

typedef struct {
    float x, y, z;
} Float3;

// What a fat ray is tested against, 16 at a time: spheres as one pencil sees them, or balls that hold 16 of the level
// below. Computed in double and rounded once. Places that nothing fills have id -1.
#define CLUSTER 16
typedef struct {
    float x[CLUSTER], y[CLUSTER], z[CLUSTER];  // centre from the pencil's apex; parallel: from the eye, in its basis
    float distance[CLUSTER], reach[CLUSTER];   // |centre| and the radius, both rounded up and out: see fat_ray.h
    int id[CLUSTER];                           // a sphere's index in the scene; a ball's node or cluster
} Bounds;

// Spheres: what else the exact tests need.
typedef struct {
    Bounds bounds;
    float r2[CLUSTER];     // radius^2
    float power[CLUSTER];  // |centre|^2 - radius^2, the power of the apex (parallel: of the eye): < 0 inside
    int form[CLUSTER];     // FORM_SMALL or FORM_LARGE
} SphereCluster;

// 16^8 spheres are more than an int counts.
#define MAX_LEVELS 8

// Rays from the eye: pixel (i, j) looks along forward + (2i + 1 - width) right + (height - 1 - 2j) up.
typedef struct {
    Float3 forward, right, up;
    int width, height;  // pixels
} EyePencil;

// Rays toward a directional light; positions are relative to the eye.
typedef struct {
    Float3 u, v;  // across the light, with dir an orthonormal basis
    Float3 dir;   // toward the light
} ParallelPencil;

// Rays from a point light.
typedef struct {
    Float3 origin;  // relative to the eye
} PointPencil;

// A rectangle of blocks that one chain of launches computes.
typedef struct {
    int x, y;      // its first pixel
    int blocks_x;  // blocks in a row
    int blocks;    // blocks in all
} Tile;

typedef char assert_size_of_Float3[sizeof(Float3) == 12 ? 1 : -1];
typedef char assert_size_of_Bounds[sizeof(Bounds) == 6 * 4 * CLUSTER ? 1 : -1];
typedef char assert_size_of_SphereCluster[sizeof(SphereCluster) == 9 * 4 * CLUSTER ? 1 : -1];
typedef char assert_size_of_EyePencil[sizeof(EyePencil) == 44 ? 1 : -1];
typedef char assert_size_of_ParallelPencil[sizeof(ParallelPencil) == 36 ? 1 : -1];
typedef char assert_size_of_PointPencil[sizeof(PointPencil) == 12 ? 1 : -1];
typedef char assert_size_of_Tile[sizeof(Tile) == 16 ? 1 : -1];

#ifdef __cplusplus
}
#endif

#endif
