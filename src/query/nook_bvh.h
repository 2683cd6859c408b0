/* nook_bvh.h -- a tree of boxes over a mesh, so that a question about a place looks at few triangles.
 *
 * Four triangles are a leaf, four leaves a group, four groups a group of the next level, and so on up to one group:
 * a complete tree, without links. A group holds the boxes of its four children side by side, their bounds
 * rounded outward to a grid of 255 (65,535 with NOOK_BOUND_BITS 16) cells along each axis of the mesh's box.
 * Which triangles make a leaf is the order in which they stand: order[] lists them, or the mesh's own order is it.
 *
 *   bytes a triangle    8-bit bounds   16-bit bounds
 *   boxes                    2               4        (24 or 48 a group, 3 groups for 64 triangles and 1 more for 256 ...)
 *   order                    2 or 4 as nook_index; 0 where the mesh stands in the order of the tree (nook_reorder)
 *
 * Built anywhere, it is the same everywhere, bit for bit; const afterwards, in flash or RAM, for any number of tasks.
 * Boxes may hold any bits: answers may then be wrong, but no access leaves the arrays. */
#ifndef NOOK_BVH_H
#define NOOK_BVH_H

#include "core/nook_corner.h"
#include "core/nook_vector.h"

/* The boxes of four children, in cells: low and high bounds along x, y, z. A child that is not there is empty:
 * low bounds all ones, high ones 0. */
typedef struct nook_boxes {
    nook_bound low[3][4], high[3][4];
} nook_boxes;

/* Levels of groups, at most. */
#define NOOK_BVH_LEVELS (NOOK_INDEX_BITS == 16 ? 7 : 14)

/* Groups for max_nt triangles, and one more to build in; a constant expression. */
#define NOOK_BVH_LEVEL(nt, k) ((nt) > (1u << (2 * (k))) ? (((nt)-1u) >> (2 * (k) + 2)) + 1u : 0u)
#define NOOK_BVH_GROUPS(max_nt)                                                                              \
    (((max_nt) + 15u) / 16u + 1u + NOOK_BVH_LEVEL(max_nt, 2) + NOOK_BVH_LEVEL(max_nt, 3) +                   \
     NOOK_BVH_LEVEL(max_nt, 4) + NOOK_BVH_LEVEL(max_nt, 5) + NOOK_BVH_LEVEL(max_nt, 6) +                     \
     NOOK_BVH_LEVEL(max_nt, 7) + NOOK_BVH_LEVEL(max_nt, 8) + NOOK_BVH_LEVEL(max_nt, 9) +                     \
     NOOK_BVH_LEVEL(max_nt, 10) + NOOK_BVH_LEVEL(max_nt, 11) + NOOK_BVH_LEVEL(max_nt, 12) +                  \
     NOOK_BVH_LEVEL(max_nt, 13) + NOOK_BVH_LEVEL(max_nt, 14))

/* Boxes and order as one struct type, for a static declaration:
 *     static NOOK_BVH_ARRAYS(500) tree3;
 *     nook_bvh_build(&bvh, &view, tree3.boxes, tree3.order, &where);  */
#define NOOK_BVH_ARRAYS(max_nt)                                                                              \
    struct {                                                                                                 \
        nook_boxes boxes[NOOK_BVH_GROUPS(max_nt)];                                                           \
        nook_index order[max_nt];                                                                            \
    }

typedef struct nook_bvh {
    nook_view
        view; /* the mesh: G, V and their sizes are used, O and C by nook_intersections and nook_t_junctions only */
    const nook_boxes *boxes;              /* [NOOK_BVH_GROUPS(places)] */
    const nook_index *order;              /* [view.nt], or null: as they stand */
    uint32_t places;                      /* triangles that it is laid out for, at least view.nt */
    uint32_t levels;                      /* of groups, the leaves on level 0 */
    nook_index base[NOOK_BVH_LEVELS + 1]; /* where the groups of each level begin in boxes */
    nook_point origin;                    /* of the grid */
    nook_point cells;                     /* cells a unit of length, along each axis */
    float
        stray; /* 0, or more cells than any, when a triangle has left the grid: its bounds say nothing then */
} nook_bvh;

typedef struct nook_bvh_state {
    nook_bvh *bvh;
    nook_boxes *boxes;
    nook_index *order;
    nook_where *where;
    uint32_t phase, at, end, base;
    uint32_t start, height, from, to,
        middle; /* the leaves to be cut, their places, and the place of the cut */
    uint32_t first, last, left, axis, pivot; /* what still holds that place, and how far it is parted */
    uint32_t least[3], most[3];              /* of the keys in it */
    nook_point low, high;
    bool fresh; /* there are no keys yet */
} nook_bvh_state;

/* Build the boxes over a mesh, and the order.
 *   boxes[NOOK_BVH_GROUPS(view->nt)], order[view->nt]: out, aligned to their elements; also what the build works in
 *   order null: the triangles are taken as they stand, which is quick and, if they stand anyhow, makes a slow tree
 *   where  of a status below; may be null
 * The view is copied into *bvh; its tables, boxes and order stay the caller's and must outlive it.
 *   NOOK_NULL_ARGUMENT
 *   NOOK_EMPTY_MESH              no triangle
 *   NOOK_INDEX_OUT_OF_RANGE      V names no vertex. where: the corner
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE   where: the vertex, if a triangle uses it
 * Steps: about 2.5 nt log2(nt); at most 12 nt log2(nt) + 3 nt, with 16-bit bounds 24: to halve what stands at a place one has to
 * know how far it reaches, perhaps to give it finer keys (3), and to part it at a key that leaves three quarters of the keys
 * or fewer, until one is left (9 times of 32 keys, 21 of 1,024). One unit is a triangle looked at once: at most 360 instructions on M4F, 4,800 on M0. */
nook_status nook_bvh_begin(nook_bvh_state *state, nook_bvh *bvh, const nook_view *view, nook_boxes *boxes,
                           nook_index *order, nook_where *where);
/* The same with the order that *bvh has: after vertices moved. boxes are those of *bvh. */
nook_status nook_bvh_refit_begin(nook_bvh_state *state, nook_bvh *bvh, nook_boxes *boxes, nook_where *where);
/* Triangle t of a tree without order gets these corners: all boxes that hold it are widened (nook_guard). Steps: 1 a level, at
 * most 14. */
void nook_bvh_widen(nook_bvh *bvh, nook_boxes *boxes, uint32_t t, const nook_point *const p[3]);
nook_status nook_bvh_step(nook_bvh_state *state, uint32_t *units);
nook_status nook_bvh_build(nook_bvh *bvh, const nook_view *view, nook_boxes *boxes, nook_index *order,
                           nook_where *where);
nook_status nook_bvh_refit(nook_bvh *bvh, nook_boxes *boxes, nook_where *where);

#endif
