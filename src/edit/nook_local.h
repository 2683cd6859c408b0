/* nook_local.h -- local operators: flip, splits, collapse, merge, removal of a vertex.
 *
 * All take a linked, manifold mesh without duplicate triangles and keep it so: V, O and C hold afterwards, every
 * vertex with a corner of its own in C. New vertices and triangles take the next numbers; what goes is filled by the
 * last ones, which the caller hears of. Edges are named by a corner that faces them. In the pictures A = v(c),
 * B = v(n(c)), C = v(p(c)), D = v(o(c)).
 * O, V or C that hold other bits end in NOOK_BAD_OPPOSITE before anything is changed where an operator looks at
 * them; run nook_check() on tables of unknown origin. Besides those named, every operator may say
 *   NOOK_INDEX_OUT_OF_RANGE  no such corner, triangle or vertex
 *   NOOK_NO_CAPACITY         the arrays are full (splits)
 *   NOOK_TURNED_TRIANGLE, NOOK_TOO_MANY_TRIANGLES  if edit asks for it
 * Steps: the triangles around the vertices concerned; a collapse, those of one end times those of the other. With
 * edit->no_turn, one exact sign for each triangle that changes.
 * Memory: none. */
#ifndef NOOK_LOCAL_H
#define NOOK_LOCAL_H

#include "edit/nook_edit.h"

/* Turn the edge B C, which c faces, into A D. c and o(c) keep their vertices.
 *
 *            A                     A
 *           / \                   /|\
 *          B---C        ->       B | C
 *           \ /                   \|/
 *            D                     D
 *   NOOK_BORDER_EDGE      there is no D
 *   NOOK_DUPLICATE_EDGE   A and D are joined already, or the same
 *   NOOK_TURNED_TRIANGLE  A B D C, seen along its normal, is not a convex quadrilateral */
nook_status nook_flip(nook_mesh *mesh, uint32_t c, const nook_edit *edit);

/* A new vertex in triangle t, joined to its three: t keeps the edge that corner 3 t faces, and two triangles are
 * new. The vertex is mesh->nv - 1. Its inverse is nook_remove_vertex().
 *
 *            A                     A
 *           / \                   /|\
 *          /   \        ->       / v \
 *         B-----C               B-----C     */
nook_status nook_split_triangle(nook_mesh *mesh, uint32_t t, nook_point at, const nook_edit *edit);

/* A new vertex on the edge B C, which c faces, joined to A and D: c then faces the edge from B to it. The vertex is
 * mesh->nv - 1; nook_collapse() of its edge to C, or nook_merge_edges(), is the inverse.
 *
 *            A                     A
 *           / \                   /|\
 *          B---C        ->       B-v-C
 *           \ /                   \|/
 *            D                     D
 *   NOOK_DUPLICATE_TRIANGLE  A and D are the same */
nook_status nook_split_edge(nook_mesh *mesh, uint32_t c, nook_point at, const nook_edit *edit);

/* Cut along two edges at a vertex v and open them: the triangles from that of c on, counter-clockwise to that of d,
 * get a new vertex w, and two new triangles fill the gap (the first new at c). c and d are the corners of the first
 * and the last of these triangles that face the edges: n(c) and p(d) are corners of v. At a border one of them may
 * be NOOK_NONE: these triangles then reach to that end of the fan, where nothing is filled, and v w is a border edge.
 * Where c or d itself faces a border edge, its new triangle has that border instead.
 * w is mesh->nv - 1, and nook_collapse() of the edge w v is the inverse: by corner 3 t of the first new triangle t.
 *
 *         x1                       x1
 *     c  /|                       /|\
 *       / |                      / | \
 *      /  v---         ->       /  w--v---
 *     d \ |                     \  | /
 *        \|                      \ |/
 *         x2                       x2
 *   NOOK_NONMANIFOLD_VERTEX  turning from the triangle of c does not lead to that of d
 *   NOOK_INTERIOR_VERTEX     c or d is NOOK_NONE, and v is not at a border
 *   NOOK_DUPLICATE_TRIANGLE  both edges are the same */
nook_status nook_split_vertex(nook_mesh *mesh, uint32_t c, uint32_t d, nook_point at, const nook_edit *edit);

/* Collapse the edge B C, which c faces: B becomes one with C, which moves to a point; the triangles at the edge go.
 * The link condition is asked in full, borders included (Dey, Edelsbrunner, Guha and Nekhayev 1999).
 *   NOOK_DUPLICATE_EDGE      a vertex other than A and D is joined to both B and C: two edges would be one
 *   NOOK_NONMANIFOLD_VERTEX  B and C are on the border but the edge is not: two loops would touch
 *   NOOK_DUPLICATE_TRIANGLE  two triangles would be on the same vertices, as of a tetrahedron
 *   NOOK_LAST_TRIANGLE       the triangle is joined to no other */
nook_status nook_collapse(nook_mesh *mesh, uint32_t c, nook_point at, const nook_edit *edit);

/* Remove v(c), a vertex of four triangles, which become two (or of two at a border, which become one): the new edge
 * leads from v(n(c)) to the vertex that was opposite to it about v(c). Where both diagonals are possible and
 * geometry matters, the turn of c decides between them.
 *   NOOK_WRONG_VALENCE   another number of triangles
 *   NOOK_INTERIOR_EDGE   at a border, c is not the corner whose edge v(c) v(n(c)) is a border edge
 *   NOOK_DUPLICATE_EDGE, NOOK_DUPLICATE_TRIANGLE  as of nook_collapse() of the edge v(c) v(n(c)) */
nook_status nook_merge_edges(nook_mesh *mesh, uint32_t c, const nook_edit *edit);

/* Remove a vertex in a closed fan of three triangles, one triangle stays in their place; or one of no triangle.
 *   NOOK_WRONG_VALENCE       another number of triangles, or at a border
 *   NOOK_DUPLICATE_TRIANGLE  there is one on the same three vertices, as of a tetrahedron */
nook_status nook_remove_vertex(nook_mesh *mesh, uint32_t v, const nook_edit *edit);

#endif
