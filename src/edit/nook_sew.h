/* nook_sew.h -- at the border: make and remove a triangle, stitch and cut an edge.
 *
 * Out of these a mesh can be made from nothing, and taken apart. With nook_local.h and nook_fill.h they are the Euler
 * operators (Mantyla) in the form that a triangle mesh can have; here an edge does not stand without a triangle.
 *   MVS   make vertex, shell             nook_make_vertex; its inverse is nook_remove_vertex
 *   MEV   make edge, vertex              nook_make_triangle on a new vertex; in a surface, nook_split_edge, nook_split_vertex
 *   MEF   make edge, face                nook_make_triangle on two edges of a border; in a surface, nook_split_edge
 *   KHMF  kill hole, make face           nook_make_triangle on three edges, nook_fill
 * What nook_local.h says of tables, numbers and steps holds here. */
#ifndef NOOK_SEW_H
#define NOOK_SEW_H

#include "edit/nook_edit.h"

/* A vertex of no triangle: mesh->nv - 1.
 *   NOOK_NO_CAPACITY */
nook_status nook_make_vertex(nook_mesh *mesh, nook_point at);

/* A triangle on three vertices, counter-clockwise, joined to the border edges that are there: mesh->nt - 1, whose corner i
 * is at v[i]. A vertex may have been of no triangle; else the triangle must hang on an edge there.
 * Its color is that of a triangle it is joined to, else 1; its attributes are those of the corners it meets, else 0.
 *   NOOK_INDEX_OUT_OF_RANGE   no such vertex
 *   NOOK_REPEATED_VERTEX      two of them are the same
 *   NOOK_NO_CAPACITY
 *   NOOK_NONMANIFOLD_EDGE     there are two triangles already at one of its edges
 *   NOOK_INCOHERENT_EDGE      there is one that runs it the same way
 *   NOOK_NONMANIFOLD_VERTEX   it would touch others with a vertex only
 *   NOOK_DUPLICATE_TRIANGLE   it would be the back of a lone triangle */
nook_status nook_make_triangle(nook_mesh *mesh, const uint32_t v[3], const nook_edit *edit);

/* Take triangle t away; its neighbours get borders. Vertices that were its only are of no triangle then: the inverse
 * of nook_make_triangle().
 *   NOOK_INDEX_OUT_OF_RANGE
 *   NOOK_NONMANIFOLD_VERTEX   it joins two parts of a fan that would touch in a vertex only */
nook_status nook_remove_triangle(nook_mesh *mesh, uint32_t t, const nook_edit *edit);

/* Two border edges become one: v(n(c)) and v(p(d)) become one vertex if they are not, and so do v(p(c)) and v(n(d)),
 * at the places of those of c.
 *
 *    A                                A
 *   / \      B' \                    / \
 *  B---C      |  D      ->          B---C
 *            C' /                    \ /
 *                                     D
 *   NOOK_INTERIOR_EDGE       one of them is no border edge
 *   NOOK_REPEATED_VERTEX     c and d are the same, or an edge would become a point
 *   NOOK_DUPLICATE_EDGE      two other edges would become one as well
 *   NOOK_DUPLICATE_TRIANGLE  the two triangles would be on the same vertices */
nook_status nook_stitch(nook_mesh *mesh, uint32_t c, uint32_t d, const nook_edit *edit);

/* An edge becomes two border edges, which c and o(c) face. Its ends that are at the border become two vertices: c keeps
 * the old ones, and those of o(c) are new, first that of B = v(n(c)). nook_stitch(mesh, c, o) is the inverse.
 *   NOOK_BORDER_EDGE      it is one
 *   NOOK_DUPLICATE_EDGE   neither end is at a border: both edges would be on the same two vertices
 *   NOOK_NO_CAPACITY */
nook_status nook_cut(nook_mesh *mesh, uint32_t c, const nook_edit *edit);

#endif
