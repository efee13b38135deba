// The hierarchy over the spheres, from the top down: nodes of 16 children, each a node or, on the lowest level, a
// cluster. Its depth follows from the number of spheres alone, so the stack cannot overrun. Whoever includes this says
// with FAT and NODE_CANDIDATES what is traced: a type, and the function that gives the candidates of a node.
#ifndef GNOMON_HIERARCHY_H
#define GNOMON_HIERARCHY_H

#include "cluster.h"

// Spheres as one pencil sees them: clusters, and `levels` levels of nodes over them, the last node being the root. Few
// clusters are visited one after the other (-D WALK=WALK_CLUSTERS or WALK_SPHERES, else WALK_NODES): there are no
// nodes, and `last` is the last cluster.
typedef struct {
    global const PencilCluster* clusters;
    global const Node* nodes;
    int levels, last;
} Hierarchy;

#if WALK != WALK_NODES

typedef struct {
    int next;
} Traversal;

static inline Traversal begin(Hierarchy h, FAT fat) { return (Traversal){0}; }
static inline int next_cluster(Hierarchy h, Traversal* t, FAT fat) { return t->next <= h.last ? t->next++ : -1; }

#else

// Where a traversal stands: on each level (1 is the lowest) a node, and which of its children are still to be visited.
typedef struct {
    int node[MAX_LEVELS + 1], rest[MAX_LEVELS + 1];
    int level;
    float farthest;  // nothing that begins beyond is of interest any more
} Traversal;

static inline Traversal begin(Hierarchy h, FAT fat) {
    Traversal t;
    t.level = h.levels;
    t.farthest = INFINITY;
    t.node[h.levels] = h.last;
    t.rest[h.levels] = NODE_CANDIDATES(fat, h.nodes + h.last);
    return t;
}

// The next cluster that may hold something, -1 after the last. Children are sorted by where they begin, in pencils with
// an apex: the first that begins too far ends its node. (In parallel pencils nothing is too far.)
static inline int next_cluster(Hierarchy h, Traversal* t, FAT fat) {
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
