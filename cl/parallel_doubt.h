// A directional light's shadow pencil in certified pictures: what rounding may decide of a shadow ray
// (parallel_pencil.h). Derived in docs/accuracy.md.
#ifndef GNOMON_PARALLEL_DOUBT_H
#define GNOMON_PARALLEL_DOUBT_H

#include "certify.h"
#include "parallel_pencil.h"

#if CERTIFIED

// `position` is how far the receiver is off, with what it takes to bring it into the basis (intersect_closest): this is
// turned by up to 2 u, and three dot products round by 3 u; together with the sphere's, 12 u |c| in line_edge, 12 u
// |p|.
typedef struct {
    real shift;   // of the receiver
    real facing;  // of n . l: the normal's doubt, l's turn and the dot product's 3 u
    real base;
} LightDoubt;

INLINE LightDoubt light_doubt(LightPencil light, real position, real normal, real base) {
    return (LightDoubt){position + base, normal + 8 * ROUNDING, base};
}

// Of all rays of a group alike.
typedef LightDoubt RayDoubt;
INLINE RayDoubt ray_doubt(LightDoubt doubt, const ShadowRay* ray, const wholew* open) { return doubt; }
INLINE RayDoubt own_ray_doubt(LightDoubt own, ShadowRay ray, int lane) { return own; }

// How far D may be off: all that there is to know.
typedef struct {
    real off;
} LineEdge;
typedef LineEdge Edge;

// For a sphere no farther from the eye than that.
INLINE LineEdge line_edge(PencilSphere s, LightDoubt doubt, RayDoubt most, real from_eye) {
    const real shift = doubt.shift + fma(12 * ROUNDING, from_eye, doubt.base);
    return (LineEdge){fma(fma((real)3, shift, 2 * radius_of(s)), shift, 12 * ROUNDING * s.r2)};
}
INLINE Edge edge_of(PencilSphere s, LightDoubt doubt, RayDoubt most, LineEdge line) {
    return (Edge){inverse_of(line.off)};
}

// Whether the line of the ray may meet the sphere: where it does not, the ray is surely clear.
INLINE wholew line_may_meet(PencilSphere s, ShadowRay ray, LineEdge edge) {
    return !(disc_discriminant(s, ray) < wide(-edge.off));
}

// D has one formula.
INLINE int formula_of_line(PencilSphere s) { return 0; }

// By how many of its doubts the ray is occluded: more than 1 is sure, and so is less than -1, that it is not. D >= 0
// says that the line meets the sphere, and D + ahead |ahead| >= 0, which is off by no more than twice as much, that the
// farther root is ahead. NaN where that is.
INLINE realw occluded_by(PencilSphere s, ShadowRay ray, Edge edge) {
    const realw ahead = wide(s.center.z) - ray.from.z, discriminant = disc_discriminant(s, ray);
    const realw farther = 0.5f * fma(ahead, fabs(ahead), discriminant);
    return choose(discriminant < farther, discriminant, farther) * wide(edge.off);
}

// Where it is open whether the surface faces the light.
INLINE wholew may_face(LightPencil light, ShadowRay ray, vec3w position, vec3w normal, LightDoubt doubt) {
    return !(fabs(dot_r(light.axis, normal)) > wide(doubt.facing));
}

// So wide that what is passed over is clear of each ray by its own doubt: docs/accuracy.md, "What is passed over".
INLINE FatShadowRay widened(FatShadowRay fat, LightPencil light, int face, RayDoubt doubt) {
    const float shift = (float)doubt.shift, across = 2 * shift, along = 4 * shift;
    return (FatShadowRay){fat.x0 - across, fat.x1 + across, fat.y0 - across, fat.y1 + across, fat.back - along};
}
INLINE int certain_shadow_candidates(FatShadowRay fat, RayDoubt doubt, global const PencilCluster* c) {
    return shadow_candidates(fat, c);
}

#endif

#endif
