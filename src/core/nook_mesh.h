/* nook_mesh.h -- a triangle mesh as Rossignac's corner table, in arrays that the caller owns.
 *
 * T triangles, V vertices, C = 3T corners. Triangle t has the corners 3t, 3t+1, 3t+2, listed
 * counter-clockwise seen from outside.
 *
 *   G[V]   point of a vertex (any unit; |x| <= 2^30)
 *   V[3T]  vertex of a corner
 *   O[3T]  opposite corner: the corner across the edge that this one faces; itself at a border
 *   C[V]   one corner of a vertex; the stored "none" (all bits set) for a vertex of no triangle
 *
 * At V = T/2, as on any closed mesh, that is 6 + 6 + 6 + 1 = 19 bytes a triangle with 16-bit
 * indices and 6 + 12 + 12 + 2 = 32 with 32-bit ones.
 *
 * Two types: nook_view is const, may lie in flash, and is what everything that only reads takes;
 * nook_mesh is mutable, has room to grow, and is what table and edit take. */
#ifndef NOOK_MESH_H
#define NOOK_MESH_H

#include "core/nook_status.h"

typedef struct nook_point {
    float x, y, z;
} nook_point;

typedef struct nook_view {
    const nook_point *G;
    const nook_index *V;
    const nook_index *O;
    const nook_index *C;
    uint32_t nv, nt; /* vertices and triangles in use */
} nook_view;

typedef struct nook_mesh {
    nook_point *G;
    nook_index *V;
    nook_index *O;
    nook_index *C;
    uint32_t nv, nt;         /* in use */
    uint32_t max_nv, max_nt; /* room in the arrays */
} nook_mesh;

/* What a struct that holds the arrays must be aligned to; ordinary declarations are. */
#define NOOK_ALIGNMENT 4u

/* Bytes of all four arrays; a constant expression. nook_mesh_bytes() computes the same number. */
#define NOOK_MESH_BYTES(max_nv, max_nt)                                                                      \
    ((size_t)(max_nv) * (sizeof(nook_point) + sizeof(nook_index)) + (size_t)(max_nt)*6u * sizeof(nook_index))

/* The four arrays as one struct type, for a static declaration:
 *     static NOOK_MESH_ARRAYS(500, 1000) link3;
 *     nook_mesh_init(&mesh, link3.G, link3.V, link3.O, link3.C, 500, 1000);  */
#define NOOK_MESH_ARRAYS(max_nv, max_nt)                                                                     \
    struct {                                                                                                 \
        nook_point G[max_nv];                                                                                \
        nook_index V[3u * (max_nt)];                                                                         \
        nook_index O[3u * (max_nt)];                                                                         \
        nook_index C[max_nv];                                                                                \
    }

/* The number NOOK_MESH_BYTES gives; 0 if it does not fit a size_t or this index width. */
size_t nook_mesh_bytes(uint32_t max_nv, uint32_t max_nt);

/* Make an empty mesh over the caller's arrays: G[max_nv], V[3 max_nt], O[3 max_nt], C[max_nv].
 * Nothing is read or written but *mesh; the arrays stay the caller's and must outlive it. To fill it, append
 * triangles, or write G and V yourself and set mesh->nv and mesh->nt.
 *   NOOK_NULL_ARGUMENT  mesh, or an array that must hold something, is null
 *   NOOK_MISALIGNED     an array is not aligned to its element
 *   NOOK_NO_CAPACITY    max_nv > NOOK_MAX_VERTICES or max_nt > NOOK_MAX_TRIANGLES
 * On failure *mesh (if given) is empty with no capacity. Steps: constant. */
nook_status nook_mesh_init(nook_mesh *mesh, nook_point *G, nook_index *V, nook_index *O, nook_index *C,
                           uint32_t max_nv, uint32_t max_nt);

/* Make a view of const arrays, for instance in flash: G[nv], V[3 nt], O[3 nt], C[nv].
 * Statuses as above. The contents are not read: nook_check() does that. */
nook_status nook_view_init(nook_view *view, const nook_point *G, const nook_index *V, const nook_index *O,
                           const nook_index *C, uint32_t nv, uint32_t nt);

/* The const view of a mesh, as it is now. */
static inline nook_view nook_view_of(const nook_mesh *mesh) {
    nook_view view = {mesh->G, mesh->V, mesh->O, mesh->C, mesh->nv, mesh->nt};
    return view;
}

/* Append one triangle with three vertices of its own, as STL gives them; nook_weld() joins them
 * later. NOOK_NO_CAPACITY if either array is full; the mesh is then unchanged. O and C are not set. */
nook_status nook_mesh_append(nook_mesh *mesh, const nook_point corners[3]);

/* Whether a point can be used: NOOK_OK, NOOK_NOT_FINITE or NOOK_COORDINATE_TOO_LARGE. */
nook_status nook_point_status(nook_point point);

/* The stored form of an index. Its value must fit; "none" becomes all bits set. */
static inline nook_index nook_store(uint32_t index) { return (nook_index)index; }
#define NOOK_STORED_NONE ((nook_index)NOOK_NONE)

/* CRC-32 (IEEE 802.3, reflected) over V, T, G, V[], O[], every item as a little-endian 32-bit
 * word, floats as their bits with -0 as +0: one number that says whether a PC and a board, or two
 * index widths, hold the same mesh. Steps: 4 (2 + 3 nv + 6 nt) bytes. Stack: 72 bytes. */
uint32_t nook_digest(const nook_view *view);

#endif
