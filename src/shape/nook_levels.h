/* nook_levels.h -- continuous level of detail: a record of edge collapses, by which a mesh goes coarser and finer.
 *
 * Progressive meshes (Hoppe 1996): the finest mesh is simplified by edge collapses, and each leaves a vertex split, which is
 * its inverse. The coarsest mesh and the splits hold all levels between. Level i is the mesh after i collapses; going from
 * one to the next, either way, is one step of one place.
 *
 *            A                     A
 *           / \                    |
 *      ... B---C ...    <->   ...  C ...       a collapse to the right, a split to the left
 *           \ /                    |
 *            D                     D
 *
 * Bit-exact: at every level V, O, C and G are the same bits whenever and from wherever one comes there, and so is the digest.
 * nook_split_vertex() is not the inverse: it numbers what is new last, where nook_collapse() has filled the gaps by what
 * was last, and it does not move C back, nor make a vertex at a border whose triangles are all new.
 *
 * The record is an array of the caller: 48 bytes a collapse with 16-bit indices, 60 with 32. Going finer and coarser only reads
 * it, so it may lie in flash together with the coarsest mesh.
 *
 *     static nook_vertex_split splits[400];                        record, on the PC or in the controller
 *     nook_levels levels = nook_levels_in(splits, 400);
 *     ... nook_levels_collapse(&levels, &mesh, c, at, NULL) ...     in any order, by any measure
 *
 *     static NOOK_MESH_ARRAYS(502, 1000) link3;                    replay: room for the finest level that is wanted,
 *     nook_levels levels = nook_levels_of(splits, 400);             filled with the tables of the coarsest
 *     units = 20;                                                   so much work a tick
 *     status = nook_levels_step(&levels, &mesh, 300, NULL, &units); NOOK_OK: as fine as 300 triangles can be
 *
 * Discrete levels are the same with few goals: 100 triangles for a quick check of contact, which comes first, all of them for
 * a precise one; on a display, as many as the distance asks for. */
#ifndef NOOK_LEVELS_H
#define NOOK_LEVELS_H

#include "edit/nook_local.h"

/* One collapse of the edge B C that corner c faced, of triangles A B C and D C B: B went, C stayed. */
typedef struct nook_vertex_split {
    nook_point gone, kept; /* where B and C are in the finer mesh */
    nook_point at;         /* where C is in the coarser */
    nook_index c, o;       /* in the finer mesh: c and o(c); o is none at a border */
    nook_index v;          /* the number of B */
    nook_index e, f; /* in the coarser: the corners that face A C and D C; at a border f is that of e at C */
    /* The finer C: 1, A had c; 2, D had o; 4, C had p(c), or 8, n(o); 16 times where B had its corner: 0, n(c),
     * i, the ith triangle from A to D that B keeps, more, p(o). */
    nook_index table;
} nook_vertex_split;

typedef struct nook_levels {
    const nook_vertex_split *split; /* [count], the first collapse first */
    nook_vertex_split *room;        /* the same array where it may be written, or null */
    uint32_t max, count;            /* how many it has room for, and has */
    uint32_t level;                 /* how many collapses the mesh has behind it, of those recorded */
} nook_levels;

/* An empty record in room[max]; the mesh is at level 0. */
static inline nook_levels nook_levels_in(nook_vertex_split *room, uint32_t max) {
    nook_levels levels = {NULL, NULL, 0, 0, 0};
    levels.split = levels.room = room;
    levels.max = max;
    return levels;
}

/* A record of count splits, which is only read; the mesh is at the coarsest level. */
static inline nook_levels nook_levels_of(const nook_vertex_split *split, uint32_t count) {
    nook_levels levels = {NULL, NULL, 0, 0, 0};
    levels.split = split;
    levels.count = levels.level = count;
    return levels;
}

/* What all of them respect. The mesh must be at levels->level, as they left it: between them nobody else may write its tables.
 * Records and tables of any bits are looked at before anything is changed, and each step is a collapse or a split that keeps
 * a manifold mesh manifold, whatever the record says.
 * edit->renamed() hears of new numbers in both directions. Data beside the mesh that is then exchanged between the two
 * numbers, not copied, comes back with what it belongs to, as what is gone stays behind the end; edit->color does so by
 * itself. Attributes of corners are blended by a collapse, and do not come back: hang on vertices what must. */

/* nook_collapse(), recorded: levels beyond the present one are forgotten. Its statuses, and
 *   NOOK_NO_CAPACITY         the record is full, or not to be written
 *   NOOK_TOO_MANY_TRIANGLES  v(n(c)) would leave C more than 4,094 triangles; name the edge from its other side
 * Steps: those of nook_collapse(), and the triangles of v(n(c)). At valence 6 2,600 instructions on M4F, 3,400 on M0. */
nook_status nook_levels_collapse(nook_levels *levels, nook_mesh *mesh, uint32_t c, nook_point at,
                                 const nook_edit *edit);

/* One level finer: the last split that is not undone yet. No condition of edit is asked.
 *   NOOK_INDEX_OUT_OF_RANGE  this is the finest; or the record names what does not exist
 *   NOOK_NO_CAPACITY         the arrays of the mesh are full
 *   NOOK_BAD_OPPOSITE        the record is not of this mesh at this level: its corners do not fit, or C is not at its place
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  a point of the record
 * Steps: the triangles of B and C, those of two triangles and a vertex that get their numbers back. At valence 6 2,000
 * instructions on M4F, 3,000 on M0. */
nook_status nook_levels_refine(nook_levels *levels, nook_mesh *mesh, const nook_edit *edit);

/* One level coarser: the collapse that was recorded, once more. Statuses as above, and those of nook_collapse(), which asks
 * edit's conditions again. At valence 6 2,200 instructions on M4F, 3,100 on M0. */
nook_status nook_levels_coarsen(nook_levels *levels, nook_mesh *mesh, const nook_edit *edit);

/* Go to the finest level of at most nt triangles, or as near as the record goes; a unit is one of the two above. There is no
 * state but the level: units, goal and edit may be others in the next call, and so may be the way. */
nook_status nook_levels_step(nook_levels *levels, nook_mesh *mesh, uint32_t nt, const nook_edit *edit,
                             uint32_t *units);

#endif
