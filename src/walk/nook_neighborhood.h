/* nook_neighborhood.h -- the k-rings of a vertex, an edge or a face by stars (seed 001).
 *
 * The 1-ring of a face is the union of the stars of its vertices, and its k-ring the union of the 1-rings of the
 * faces of its (k-1)-ring; of a vertex or an edge the same, beginning with one vertex or two. For distances
 * across edges see nook_rings. At a vertex where several fans touch, the fan of C[v] counts. */
#ifndef NOOK_NEIGHBORHOOD_H
#define NOOK_NEIGHBORHOOD_H

#include "core/nook_marks.h"
#include "walk/nook_star.h"

typedef struct nook_neighborhood {
    nook_star star;
    nook_marks marks;
    nook_index *queue;
    uint32_t corner; /* out, with NOOK_TRIANGLE: a corner of a triangle first met now */
    uint32_t ring;   /* out: its ring, from 1 */
    uint32_t head, tail, ring_end, at;
    nook_where seed;
} nook_neighborhood;

/* Grow rings around a vertex (NOOK_AT_VERTEX), an edge (NOOK_AT_CORNER: a corner that faces it) or a face
 * (NOOK_AT_TRIANGLE). The view, marks->Mt and marks->Mv must stay; what they hold is overwritten.
 *   queue[nv]  scratch, at the end the vertices reached, ring by ring
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks), NOOK_INDEX_OUT_OF_RANGE (seed)
 * step returns NOOK_TRIANGLE for each triangle, ring after ring: stop calling when ring is beyond the k you want;
 * NOOK_MORE when out of units; NOOK_OK when all that is connected has been met; NOOK_BAD_OPPOSITE.
 * Steps: 0.375 nt + 0.125 nv for the marks, 3 nt + nv; a step may take one star longer. */
nook_status nook_neighborhood_begin(nook_neighborhood *n, const nook_view *view, const nook_marks *marks,
                                    nook_index *queue, nook_where seed);
nook_status nook_neighborhood_step(nook_neighborhood *n, uint32_t *units);

#endif
