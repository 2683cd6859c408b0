/* nook_flood.h -- visit triangles across edges: in depth, in rings, and as sets.
 *
 *   nook_flood       depth-first search without a stack: the code of a triangle in Mt says by which corner it was
 *                    entered, and O of that corner is the way back. Exactly three hops a triangle and one a
 *                    component, borders included, and a pause between any two.
 *   nook_rings       breadth-first from a seed triangle: the graph distance of every triangle (the
 *                    concentric rings of "Triangle Meshes: Summary").
 *   nook_components  the component of every triangle, by sets: no search, one index a triangle.
 * Triangles are connected across edges that O pairs. Tables may hold any bits: no access leaves them and
 * every search ends; NOOK_BAD_OPPOSITE says that O is not as it should be. */
#ifndef NOOK_FLOOD_H
#define NOOK_FLOOD_H

#include "core/nook_corner.h"
#include "core/nook_marks.h"

typedef struct nook_flood {
    const nook_view *view;
    nook_marks marks;
    uint32_t corner;     /* out, with NOOK_TRIANGLE: the corner by which a triangle was entered */
    uint32_t component;  /* out: its component, from 0 */
    uint32_t hops;       /* out: 3 a triangle visited and 1 a component */
    uint32_t root, last; /* triangles that may still be roots: from root up to last */
    uint32_t c;          /* the corner to look across */
    uint32_t at;         /* bytes of marks cleared */
    uint32_t phase;
} nook_flood;

/* Visit the component of triangle seed, or with NOOK_NONE all components in the order of their first
 * triangles. The view and marks->Mt (for nt triangles) must stay until the end; what Mt holds is overwritten.
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks), NOOK_INDEX_OUT_OF_RANGE (seed)
 * step returns NOOK_TRIANGLE each time it enters a triangle, the first of a component by its corner 3 t;
 * NOOK_MORE when out of units; NOOK_OK at the end; NOOK_BAD_OPPOSITE.
 * Steps: 3 nt hops, 1 a component, 1 for every triangle tried as a root, and 0.375 nt for the marks. */
nook_status nook_flood_begin(nook_flood *flood, const nook_view *view, const nook_marks *marks,
                             uint32_t seed);
nook_status nook_flood_step(nook_flood *flood, uint32_t *units);

/* The vertices that the triangle just entered shows for the first time, into v; how many. Mv, all 0 before the
 * first, has a bit a vertex. Numbering them in this order labels all vertices along the search. */
uint32_t nook_flood_new_vertices(const nook_flood *flood, uint8_t *Mv, uint32_t v[3]);

typedef struct nook_rings {
    const nook_view *view;
    nook_index *distance, *queue;
    uint32_t seed, head, tail; /* queue[0..tail) are the triangles reached, in the order of distance */
    uint32_t at, phase;
} nook_rings;

/* distance[nt] out: edges crossed from the seed; all bits set (NOOK_STORED_NONE) where it does not reach.
 * queue[nt] out: the triangles reached, nearest first; queue[0] is the seed; rings->tail of them.
 *   NOOK_NULL_ARGUMENT, NOOK_INDEX_OUT_OF_RANGE (seed)
 * Steps: nt for clearing and 1 a triangle. */
nook_status nook_rings_begin(nook_rings *rings, const nook_view *view, uint32_t seed, nook_index *distance,
                             nook_index *queue);
nook_status nook_rings_step(nook_rings *rings, uint32_t *units);

typedef struct nook_components {
    const nook_view *view;
    nook_index *component;
    uint32_t count; /* out, when done */
    uint32_t at, one, other, phase;
} nook_components;

/* component[nt] out: 0 for the component of triangle 0, and so on in the order of their first triangles.
 *   NOOK_NULL_ARGUMENT
 * Steps: 7.5 nt (9 nt where O holds other bits), and the way up to the roots of the sets, which paths halve: less than 6 nt log2 nt more, about
 * 3 nt on meshes. */
nook_status nook_components_begin(nook_components *sets, const nook_view *view, nook_index *component);
nook_status nook_components_step(nook_components *sets, uint32_t *units);

#endif
