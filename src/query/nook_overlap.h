/* nook_overlap.h -- which triangles are about here?
 *
 *     nook_overlap q;
 *     nook_overlap_begin(&q, &bvh, low, high);
 *     while ((status = nook_overlap_step(&q, &units)) == NOOK_TRIANGLE) ... q.t ... */
#ifndef NOOK_OVERLAP_H
#define NOOK_OVERLAP_H

#include "query/nook_descent.h"

typedef struct nook_overlap {
    uint32_t t; /* out, with NOOK_TRIANGLE */

    const nook_bvh *bvh;
    nook_point low, high;
    nook_bound from[3], to[3]; /* the same in cells */
    uint32_t next;             /* of the places of a leaf */
    nook_descent descent;
} nook_overlap;

/* All triangles whose box meets the box from low to high, borders included, each once, in the order of the tree.
 *   NOOK_NULL_ARGUMENT, NOOK_EMPTY_MESH (nothing was built)
 * step: NOOK_TRIANGLE, NOOK_MORE, NOOK_OK at the end, NOOK_INDEX_OUT_OF_RANGE (tables spoiled after the build).
 * Steps: 1 a node, at most nt / 3 + 10; one unit is at most 620 instructions on M4F, 3,400 on M0. */
nook_status nook_overlap_begin(nook_overlap *overlap, const nook_bvh *bvh, nook_point low, nook_point high);
nook_status nook_overlap_step(nook_overlap *overlap, uint32_t *units);

#endif
