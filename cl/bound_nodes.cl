// bound_nodes: a level of nodes over the level below.
//
// Reads, from nodes[origin] on, where this face's begin, nodes[below] up to nodes[below + count]. Writes from
// nodes[below + count] on: the i-th has as children the nodes of the level below from its 16 i-th on, as far as there
// are any. One work-item: one node.
#include "bounds.h"

kernel void bound_nodes(const int origin, const int below, const int count, const int items, global Node* nodes,
                        const int first_item) {
    const int item = first_item + (int)get_global_id(0);
    if (item >= items) return;
    Children children;
    for (int i = 0; i < CLUSTER; ++i) {
        const int child = item * CLUSTER + i;
        if (child >= count) {
            unite(empty_rectangles(), &children, i, -1);
            continue;
        }
        global const Node* n = nodes + origin + below + child;
        unite((Rectangles){vload16(0, n->x0), vload16(0, n->x1), vload16(0, n->y0), vload16(0, n->y1),
                           vload16(0, n->depth)},
              &children, i, below + child);
    }
    write_sorted(&children, nodes + origin + below + count + item);
}
