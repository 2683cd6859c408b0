/* nook_guard.h -- a tree that follows a mesh through its edits, and refuses what would make it cut itself.
 *
 *     static nook_boxes boxes[NOOK_BVH_GROUPS(MAX_T)];
 *     nook_guard guard;
 *     nook_edit careful = {.guard = &guard};
 *     nook_guard_begin(&guard, &mesh, boxes);
 *     nook_bvh_refit(&guard.bvh, boxes, &where);
 *     status = nook_collapse(&mesh, c, at, &careful);        NOOK_SELF_INTERSECTION: it would
 * Triangles that are made or move are held against all others as these are or will be (nook_triangles_intersect): one look down
 * the tree each, and one pair with each other triangle that changes. Triangles that stay where they are may go on
 * intersecting, so nook_cut, nook_split_fans and nook_reverse never ask.
 * Every edit of the mesh must know of the guard. guard.bvh is a tree for any question between edits; it has no order: mesh->nt
 * triangles stand as they stand, best in the order of a tree (nook_reorder). Edits widen boxes and never shrink them: refit from
 * time to time, and when triangles have left the box that the mesh had, for from then on rays and distances are slow.
 * Memory: 2 bytes a triangle of max_nt (4 with 32-bit indices). Stack: an edit with a guard takes up to 1,250 bytes, nook_fill_hole()
 * 1,410 and nook_simplify() 1,370. A collapse at valence 6 in a mesh of 300 triangles is 140,000 instructions on M4F and 750,000 on
 * M0. */
#ifndef NOOK_GUARD_H
#define NOOK_GUARD_H

#include "edit/nook_edit.h"
#include "query/nook_bvh.h"

struct nook_change;

struct nook_guard {
    nook_bvh bvh;
    nook_boxes *boxes;
    /* What edits call; by pointers, so that it is linked where there is a guard only. */
    nook_status (*look)(const nook_guard *guard, const struct nook_change *change);
    bool (*intersect)(const nook_point *a[3], const nook_point *b[3]);
    void (*widen)(nook_guard *guard, uint32_t t, const nook_point *const p[3]);
};

/* boxes[NOOK_BVH_GROUPS(mesh->max_nt)]; refit it then: until that is done edits of a mesh with triangles say NOOK_EMPTY_MESH.
 *   NOOK_NULL_ARGUMENT */
nook_status nook_guard_begin(nook_guard *guard, const nook_mesh *mesh, nook_boxes *boxes);
/* NOOK_OK, NOOK_SELF_INTERSECTION, or NOOK_INDEX_OUT_OF_RANGE (tables that do not hold). */
nook_status nook_guard_look(const nook_guard *guard, const struct nook_change *change);

#endif
