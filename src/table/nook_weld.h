/* nook_weld.h -- join vertices with equal coordinates; then drop the triangles that this made empty.
 *
 * Bit-exact: two vertices are one if all three coordinates are numerically equal, so that -0 joins
 * +0 and nothing else moves. Vertices keep the order of their first occurrence. */
#ifndef NOOK_WELD_H
#define NOOK_WELD_H

#include "core/nook_mesh.h"
#include "table/nook_sort.h"

/* Entries of order[] for nv vertices. */
#define NOOK_WELD_SCRATCH(nv) (nv)

typedef struct nook_weld_state {
    nook_mesh *mesh;
    nook_index *map, *order;
    nook_list_sort sort;
    uint32_t at, kept, phase;
    nook_where where;
} nook_weld_state;

/* Weld the vertices of mesh (G, V, nv; O and C are neither read nor kept valid).
 *   map[nv]    out: the new vertex of every old one (nv as it was before)
 *   order[NOOK_WELD_SCRATCH(nv)]  scratch
 * Both may be the mesh's own C and O, which hold nothing yet: C has room for nv entries, and O for the 3 nt
 * vertices of a soup.
 *   NOOK_NULL_ARGUMENT
 *   NOOK_INDEX_OUT_OF_RANGE       V names no vertex; state->where. The mesh is then unchanged
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  a coordinate; state->where. Unchanged
 * Steps: less than 2 nv (log2 nv + 4) + 6 nt units, nv log2 nv of them comparisons; one unit is at most 150
 * instructions on M4F.
 * When done, mesh->nv is the new count. */
nook_status nook_weld_begin(nook_weld_state *state, nook_mesh *mesh, nook_index *map, nook_index *order);
nook_status nook_weld_step(nook_weld_state *state, uint32_t *units);
nook_status nook_weld(nook_mesh *mesh, nook_index *map, nook_index *order, nook_where *where);

/* Remove every triangle with a repeated vertex; the others keep their order. Returns how many were
 * removed; mesh->nt shrinks by it. V is read and rewritten, O and C are not. Steps: nt. */
uint32_t nook_drop_degenerate(nook_mesh *mesh);

#endif
