/* nook_ring.h -- what nook_simplify and nook_deviation know of the triangles around an edge. Not for others. */
#ifndef NOOK_RING_H
#define NOOK_RING_H

#include "core/nook_corner.h"
#include "shape/nook_triple.h"

enum { NOOK_RING_MOST = 44 }; /* corners around an edge */

/* The sum of squared distances from planes, times areas, as a function of the place: x A x, about a vertex. */
typedef struct nook_quadric {
    nook_triple square, mixed; /* of A: xx yy zz, xy yz zx */
} nook_quadric;

/* In the picture of nook_collapse(): corners at the vertices around C (end 0) and B (end 1), in chains of which any two
 * that follow each other are in one triangle, the second's. Chain 0 is B, A, and so on clockwise about C, to D or a border;
 * chain 1 is, if there was one, D and so on to the other border. Chains 2 and 3 are C, D ... A and A ... about B. */
typedef struct nook_edge_ring {
    uint32_t n, start[5];
    bool met, open; /* the last chain has met a border; the first of an end has */
    uint32_t v[2];  /* C, B */
    nook_point p[2];
    nook_quadric a[2];
    nook_index c[NOOK_RING_MOST + 4]; /* some are in before the first is walked to */
} nook_edge_ring;

static inline nook_point nook_between(nook_point p, nook_point q, float scale) {
    return nook_scaled(nook_sub(q, p), scale);
}

static inline const nook_point *nook_ring_point(const nook_mesh *m, const nook_edge_ring *r, uint32_t i) {
    return &m->G[m->V[r->c[i]]];
}

/* The triangle of ring corner i, of C and B; if there is one. */
static inline bool nook_ring_face(const nook_mesh *m, const nook_edge_ring *r, uint32_t i,
                                  const nook_point *t[3]) {
    uint32_t end = i >= r->start[2];
    if (i == r->start[2u * end]) return false;
    t[0] = &r->p[end];
    t[1] = nook_ring_point(m, r, i);
    t[2] = nook_ring_point(m, r, i - 1u);
    return true;
}

#endif
