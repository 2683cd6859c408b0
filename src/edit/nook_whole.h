/* nook_whole.h -- edits of a whole mesh: turn a shell inside out, give every fan a vertex of its own, and put the triangles in
 * another order.
 *
 * The first two look at everything first, and change nothing if they refuse. */
#ifndef NOOK_WHOLE_H
#define NOOK_WHOLE_H

#include "core/nook_marks.h"
#include "edit/nook_edit.h"

typedef struct nook_reverse {
    nook_mesh *mesh;
    const nook_edit *edit;
    const nook_index *component;
    uint32_t which, t, phase;
} nook_reverse;

/* Run the triangles t with component[t] == which the other way, by exchanging their corners 3 t + 1 and 3 t + 2 with all
 * that belongs to them; all triangles if component is null. component[nt] is that of nook_components, nook_shells, or any
 * choice of triangles without neighbours outside it. Done twice it restores every table.
 *   NOOK_NULL_ARGUMENT    mesh
 *   NOOK_INCOHERENT_EDGE  a neighbour does not belong to them
 *   NOOK_BAD_OPPOSITE     the tables do not hold
 * Steps: 2 nt. */
nook_status nook_reverse_begin(nook_reverse *reverse, nook_mesh *mesh, const nook_index *component,
                               uint32_t which, const nook_edit *edit);
nook_status nook_reverse_step(nook_reverse *reverse, uint32_t *units);

typedef struct nook_split_fans {
    nook_mesh *mesh;
    const nook_edit *edit;
    nook_marks marks;
    uint32_t more;  /* fans that need a vertex; out: vertices made */
    uint32_t at, x; /* bytes cleared or corners tried; a corner of a fan on the way round, */
    uint32_t other; /* and one on the other side of its first */
    uint32_t v;     /* the vertex that this fan gets */
    bool clockwise; /* the way */
    uint32_t phase;
} nook_split_fans;

/* Split non-manifold vertices: the fan of the first corner keeps the vertex, every other gets a copy of its own, in the
 * order of their first corners; C names a corner of each. O is not touched. Fans are what O leaves together:
 * where link cut edges of three triangles and more, or incoherent ones, the parts come apart as far as their vertices
 * let them; link again afterwards, as edges that were three may be two and one by then.
 * marks: Mt for nt triangles and Mv for nv vertices; what they hold is overwritten.
 *   NOOK_NULL_ARGUMENT  mesh, marks
 *   NOOK_NO_CAPACITY    marks, or mesh->max_nv, which more says by how many vertices; nothing was changed
 *   NOOK_INDEX_OUT_OF_RANGE  V names a vertex that does not exist
 * Steps: less than 13 nt + nv / 4 + 8. */
nook_status nook_split_fans_begin(nook_split_fans *split, nook_mesh *mesh, const nook_marks *marks,
                                  const nook_edit *edit);
nook_status nook_split_fans_step(nook_split_fans *split, uint32_t *units);

typedef struct nook_reorder {
    nook_mesh *mesh;
    nook_index *order;
    const nook_edit *edit;
    uint32_t first, at;
} nook_reorder;

/* Triangle order[t] becomes triangle t, with its corners as they are, its color and its attributes; order[nt] becomes 0, 1, 2
 * ... So that a tree needs no order: build it, reorder its mesh by its order, and set bvh.order to null (the boxes stay as they are).
 * Renames are not told: order says them all before. The mesh is whole after every step.
 *   NOOK_NULL_ARGUMENT       mesh, order
 *   NOOK_INDEX_OUT_OF_RANGE  order names no triangle, or one twice; some triangles have moved
 * Steps: 2 nt. One unit exchanges two triangles. */
nook_status nook_reorder_begin(nook_reorder *reorder, nook_mesh *mesh, nook_index *order,
                               const nook_edit *edit);
nook_status nook_reorder_step(nook_reorder *reorder, uint32_t *units);

#endif
