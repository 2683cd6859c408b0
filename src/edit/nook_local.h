/* nook_local.h -- local operators: flip, splits, collapse. Each looks first, then changes the mesh whole.
 *
 * All take a linked, manifold mesh without duplicate triangles and keep it so: V, O and C hold afterwards, every
 * vertex with a corner of its own in C. A refusal says why and leaves every table as it was. New vertices and
 * triangles take the next numbers; what goes is filled by the last ones, which the caller hears of. Edges
 * are named by a corner that faces them. In the pictures A = v(c), B = v(n(c)), C = v(p(c)), D = v(o(c)).
 * O, V or C that hold other bits end in NOOK_BAD_OPPOSITE before anything is changed where an operator looks at
 * them; run nook_check() on tables of unknown origin.
 * Steps: the triangles around the vertices concerned; a collapse, those of one end times those of the other.
 * Memory: none. */
#ifndef NOOK_LOCAL_H
#define NOOK_LOCAL_H

#include "walk/nook_star.h"

/* Told of every vertex (NOOK_AT_VERTEX) or triangle (NOOK_AT_TRIANGLE) that takes the number of one that is gone,
 * after it has: attributes move along. May be null. */
typedef struct nook_renamer {
    void (*renamed)(void *user, nook_kind kind, uint32_t from, uint32_t to);
    void *user;
} nook_renamer;

/* Turn the edge B C, which c faces, into A D. c and o(c) keep their vertices.
 *
 *            A                     A
 *           / \                   /|\
 *          B---C        ->       B | C
 *           \ /                   \|/
 *            D                     D
 *   NOOK_INDEX_OUT_OF_RANGE  c is no corner
 *   NOOK_BORDER_EDGE         there is no D
 *   NOOK_DUPLICATE_EDGE      A and D are joined already, or the same */
nook_status nook_flip(nook_mesh *mesh, uint32_t c);

/* A new vertex in triangle t, joined to its three: t keeps the edge that corner 3 t faces, and two triangles are
 * new. The vertex is mesh->nv - 1. Its inverse is nook_remove_vertex().
 *   NOOK_INDEX_OUT_OF_RANGE, NOOK_NO_CAPACITY */
nook_status nook_split_triangle(nook_mesh *mesh, uint32_t t, nook_point at);

/* A new vertex on the edge B C, which c faces, joined to A and D: c then faces the edge from B to it. The vertex is
 * mesh->nv - 1, and nook_collapse() of its edge to C is the inverse.
 *   NOOK_INDEX_OUT_OF_RANGE, NOOK_NO_CAPACITY
 *   NOOK_DUPLICATE_TRIANGLE  A and D are the same */
nook_status nook_split_edge(nook_mesh *mesh, uint32_t c, nook_point at);

/* Collapse the edge B C, which c faces: B becomes one with C, which moves to a point; the triangles at the edge go.
 * The link condition is asked in full, borders included (Dey, Edelsbrunner, Guha and Nekhayev 1999).
 *   NOOK_INDEX_OUT_OF_RANGE
 *   NOOK_DUPLICATE_EDGE      a vertex other than A and D is joined to both B and C: two edges would be one
 *   NOOK_NONMANIFOLD_VERTEX  B and C are on the border but the edge is not: two loops would touch
 *   NOOK_DUPLICATE_TRIANGLE  two triangles would be on the same vertices, as of a tetrahedron
 *   NOOK_LAST_TRIANGLE       the triangle is joined to no other */
nook_status nook_collapse(nook_mesh *mesh, uint32_t c, nook_point at, const nook_renamer *renamer);

/* Remove a vertex in a closed fan of three triangles: one triangle stays in their place.
 *   NOOK_INDEX_OUT_OF_RANGE  no such vertex, or one of no triangle
 *   NOOK_WRONG_VALENCE       not three triangles, or at a border
 *   NOOK_DUPLICATE_TRIANGLE  there is one on the same three vertices, as of a tetrahedron */
nook_status nook_remove_vertex(nook_mesh *mesh, uint32_t v, const nook_renamer *renamer);

#endif
