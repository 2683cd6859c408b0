/* nook_trees.h -- a tree of triangles, the tree of vertices beside it, and the loops of handles and holes.
 *
 *   triangle-spanning tree (TST)  crosses edges, f - 1 of them, so that all triangles of a component hang together; in one
 *                                 with a border it also leaves across one border edge
 *   vertex-spanning tree (VST)    runs along edges that the first does not cross, v - 1 of them, to all vertices
 *
 * In a simple mesh that is every edge, e = (f - 1) + (v - 1): cut along the VST, and it is a polygon without a vertex inside
 * ("Triangle meshes"). Otherwise some edges belong to neither, the generators: 2 g in a closed component of genus g, and
 * 2 g + h - 1 in one with h > 0 border loops, as v - e + f = 2 - 2 g - h. Each is closed by the VST to a loop without
 * a repeated vertex. As the TST crosses no edge of any loop, cutting along all of them leaves a component in one piece;
 * and any loop on the surface can be moved to a sum of these and of no fewer (they are a basis of its homology).
 *
 * Going on from corner to corner, and across edges of the TST, is going round that polygon. The search that finds the
 * TST does so, and where it first comes to a vertex it came along an edge that the TST does not cross: that is the VST.
 * Seen of both, and no more is stored: the code of a triangle in Mt says by which corner it was entered, and
 * up[v] is a corner that faces the edge from v to the vertex it hangs on. */
#ifndef NOOK_TREES_H
#define NOOK_TREES_H

#include "core/nook_corner.h"
#include "core/nook_marks.h"

typedef struct nook_trees {
    const nook_view *view;
    nook_marks marks;
    nook_index *up;
    uint32_t components; /* out */
    uint32_t generators; /* out: of all components */
    uint32_t sides;      /* of edges that the TST does not cross, the side of a hole included */
    uint32_t hops;
    uint32_t c, first; /* the corner to look across; the first one of the component */
    uint32_t at, phase;
    bool looking;
} nook_trees;

/* Grow both trees in all components. The view, marks->Mt (for nt triangles) and up must stay as long as the trees are
 * asked; what they hold is overwritten.
 *   up[nv]  out: a corner that faces the edge up the VST; of a vertex on which a tree hangs a corner at itself;
 *           NOOK_STORED_NONE for a vertex of no triangle
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks)
 * step returns NOOK_BAD_OPPOSITE where the tables do not hold; that it returns NOOK_OK does not say that they do.
 * At vertices of several fans all fans hang together: then there are more generators, e - f - v + 2 in a closed component and
 * one less in one with a border, or trees of two components that grew into one.
 * Steps: 7 nt, of which 3 nt are the search, and to clear nv or the bytes of Mt, whichever are more. One unit is at most 150
 * instructions on M4F and 200 on M0; of a loop 100 and 130. */
nook_status nook_trees_begin(nook_trees *trees, const nook_view *view, const nook_marks *marks,
                             nook_index *up);
nook_status nook_trees_step(nook_trees *trees, uint32_t *units);

/* Of the edge that corner c faces, when the trees are grown: whether the TST crosses it; whether it is in the VST; and for
 * the smaller of the corners that face it (nook_edge) whether it is a generator. Steps: 1. */
bool nook_in_triangle_tree(const nook_trees *trees, uint32_t c);
bool nook_in_vertex_tree(const nook_trees *trees, uint32_t c);
bool nook_is_generator(const nook_trees *trees, uint32_t c);

typedef struct nook_loop {
    const nook_trees *trees;
    uint32_t corner; /* out, with NOOK_TRIANGLE: a corner that faces an edge of the loop, */
    uint32_t vertex; /* out: and the vertex to which that edge leads */
    uint32_t start;  /* where the loop begins and ends */
    uint32_t left;   /* how many steps may still come */
    uint32_t first;  /* the corner of the first edge, until that has been given */
} nook_loop;

/* The loop of the edge that corner c faces: from v(n(c)) to v(p(c)), and back along the VST, edge by edge.
 *   NOOK_INDEX_OUT_OF_RANGE  c is no corner
 * First the tree of the loop is hung up at v(n(c)): up[] changes, the trees do not. So of one nook_trees only one loop can
 * be followed at a time, and one that was begun must come to its first edge.
 * step returns NOOK_TRIANGLE for each edge, NOOK_OK after the last; NOOK_MORE; and NOOK_NONMANIFOLD_VERTEX if the VST does
 * not lead back, which is so only where vertices have several fans or the tables do not hold.
 * Steps: the vertices up to the root and 1 an edge, at most 2 nv. */
nook_status nook_loop_begin(nook_loop *loop, const nook_trees *trees, uint32_t c);
nook_status nook_loop_step(nook_loop *loop, uint32_t *units);

#endif
