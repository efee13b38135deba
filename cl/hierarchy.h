// The hierarchy over the spheres, from the top down: nodes of 16 children, each a node or, on the lowest level, a
// cluster. Its depth follows from the number of spheres alone, so the stack cannot overrun. Whoever includes this says
// with FAT, NODE_CANDIDATES and BALL_CANDIDATES what is traced: a type, and the functions that give the candidates of a
// node and of a cluster of balls.
#ifndef GNOMON_HIERARCHY_H
#define GNOMON_HIERARCHY_H

#include "cluster.h"

// Spheres as one pencil sees them: clusters, and `levels` levels of nodes over them, the last node being the root. Over
// few spheres (-D WALK=WALK_CLUSTERS) there are no nodes but, on one level or none, balls: the last cluster, of one
// around each of the others. With WALK_SPHERES all clusters, to the last, are visited one after the other.
typedef struct {
    global const PencilCluster* clusters;
    global const Node* nodes;
    int levels, last;
} Hierarchy;

#if WALK == WALK_CLUSTERS

// Which clusters are still to be visited.
typedef struct {
    int rest;
} Traversal;

INLINE Traversal begin(Hierarchy h, FAT fat) {
    if (!h.levels) return (Traversal){(2 << h.last) - 1};
    const int all = (1 << h.last) - 1;  // empty places may be candidates too
    return (Traversal){all & BALL_CANDIDATES(fat, h.clusters + h.last)};
}
INLINE int next_cluster(Hierarchy h, Traversal* t, FAT fat) {
    const int rest = t->rest;
    t->rest = rest & (rest - 1);
    return rest ? lowest_bit(rest) : -1;
}

#elif WALK == WALK_SPHERES

typedef struct {
    int next;
} Traversal;

INLINE Traversal begin(Hierarchy h, FAT fat) { return (Traversal){0}; }
INLINE int next_cluster(Hierarchy h, Traversal* t, FAT fat) { return t->next <= h.last ? t->next++ : -1; }

#else

// Where a traversal stands: on each level (1 is the lowest) a node, and which of its children are still to be visited.
typedef struct {
    int node[MAX_LEVELS + 1], rest[MAX_LEVELS + 1];
    int level;
    float farthest;  // nothing that begins beyond is of interest any more
} Traversal;

INLINE Traversal begin(Hierarchy h, FAT fat) {
    Traversal t;
    t.level = h.levels;
    t.farthest = INFINITY;
    t.node[h.levels] = h.last;
    t.rest[h.levels] = NODE_CANDIDATES(fat, h.nodes + h.last);
    return t;
}

// The next cluster that may hold something, -1 after the last. Children are sorted by where they begin, in pencils with
// an apex: the first that begins too far ends its node. (In parallel pencils nothing is too far.)
INLINE int next_cluster(Hierarchy h, Traversal* t, FAT fat) {
    while (t->level <= h.levels) {
        const int level = t->level, rest = t->rest[level];
        t->rest[level] = rest & (rest - 1);
        const int i = rest ? lowest_bit(rest) : 0;
        global const Node* n = h.nodes + t->node[level];
        if (!rest || n->depth[i] > t->farthest) {
            t->level = level + 1;
            continue;
        }
        if (level == 1) return n->child[i];
        t->level = level - 1;
        t->node[level - 1] = n->child[i];
        t->rest[level - 1] = NODE_CANDIDATES(fat, h.nodes + n->child[i]);
    }
    return -1;
}

#endif

#endif
