// Bounds of spheres as one pencil sees them, and nodes made of 16 of them.
#ifndef GNOMON_BOUNDS_H
#define GNOMON_BOUNDS_H

#include "lanes.h"

// 16 rectangles with their depths (types.h, Node), one for each lane.
typedef struct {
    float16 x0, x1, y0, y1, depth;
} Rectangles;

// 16 of them in the making: one after the other.
typedef struct {
    float x0[CLUSTER], x1[CLUSTER], y0[CLUSTER], y1[CLUSTER], depth[CLUSTER];
    int child[CLUSTER];
} Children;

// What holds nothing and is held by everything.
static inline Rectangles empty_rectangles(void) {
    const float16 infinite = INFINITY;
#if PARALLEL
    return (Rectangles){infinite, -infinite, infinite, -infinite, -infinite};
#else
    return (Rectangles){infinite, -infinite, infinite, -infinite, infinite};
#endif
}

// Child i is what holds all of the 16.
static inline void unite(Rectangles r, Children* to, int i, int child) {
    to->x0[i] = least_of_16(r.x0);
    to->x1[i] = most_of_16(r.x1);
    to->y0[i] = least_of_16(r.y0);
    to->y1[i] = most_of_16(r.y1);
#if PARALLEL
    to->depth[i] = most_of_16(r.depth);
#else
    to->depth[i] = least_of_16(r.depth);
#endif
    to->child[i] = child;
}

// Each lane's place when lanes are sorted by depth. Floats in the order of their bits, so that any bits make an order.
static inline int16 ranks(const float* depth) {
    const int16 lane = INDEX_OF_16, bits = as_int16(vload16(0, depth)), order = bits < 0 ? bits ^ 0x7fffffff : bits;
    int key[CLUSTER];
    vstore16(order, 0, key);
    int16 rank = 0;
    for (int i = 0; i < CLUSTER; ++i) rank -= (key[i] < order) | ((key[i] == order) & (i < lane));
    return rank;
}

static inline void write_sorted(const Children* c, global Node* to) {
    int rank[CLUSTER];
    vstore16(ranks(c->depth), 0, rank);
    for (int i = 0; i < CLUSTER; ++i) {
        to->x0[rank[i]] = c->x0[i];
        to->x1[rank[i]] = c->x1[i];
        to->y0[rank[i]] = c->y0[i];
        to->y1[rank[i]] = c->y1[i];
        to->depth[rank[i]] = c->depth[i];
        to->child[rank[i]] = c->child[i];
    }
}

#endif
