/* nook_apart.h -- several pairs of triangles at once: which are apart for certain, but for the corners that they share.
 *
 * Floats with bounds on their error say so for nearly all pairs of neighbours; what they leave open, nook_pair.h settles. */
#ifndef NOOK_APART_H
#define NOOK_APART_H

#include "query/nook_lanes.h"

/* Some triangles: their corners' vertices, and where those are. */
typedef struct nook_several {
    nook_flags v[3];
    nook_vectors p[3];
} nook_several;

#if NOOK_LANES > 1
/* Whether corner j of some triangles is corner i of others. */
static inline nook_flags nook_is_shared(const nook_several *a, uint32_t i, const nook_several *b,
                                        uint32_t j) {
    return (nook_flags)(a->v[i] == b->v[j]);
}

/* On which side of the planes of a, with normal n, corner j of b lies; shared corners lie on both. */
typedef struct nook_sides {
    nook_flags above, below, shared;
} nook_sides;

static inline void nook_add_side(nook_sides *s, const nook_several *a, nook_vectors n, nook_lanes size,
                                 const nook_several *b, uint32_t j) {
    nook_vectors d = nook_vectors_sub(b->p[j], a->p[0]);
    nook_lanes h = nook_vectors_dot(n, d);
    nook_lanes margin = size * nook_largest(d) * nook_lanes_of(0x1p-17f) + nook_lanes_of(0x1p-120f);
    nook_flags shared = nook_is_shared(a, 0, b, j) | nook_is_shared(a, 1, b, j) | nook_is_shared(a, 2, b, j);
    s->above = s->above & ((h > margin) | shared);
    s->below = s->below & ((h < -margin) | shared);
    s->shared = s->shared & shared;
}

/* Whether b touches the plane of a in shared corners only, and else lies on one side. Then it meets a nowhere else. */
static inline nook_flags nook_is_on_one_side(const nook_several *a, const nook_several *b) {
    nook_vectors e = nook_vectors_sub(a->p[1], a->p[0]), f = nook_vectors_sub(a->p[2], a->p[0]);
    nook_vectors n = nook_vectors_cross(e, f);
    nook_lanes size = nook_largest(e) * nook_largest(f);
    nook_flags all = nook_all_flags();
    nook_sides s = {all, all, all};
    nook_add_side(&s, a, n, size, b, 0);
    nook_add_side(&s, a, n, size, b, 1);
    nook_add_side(&s, a, n, size, b, 2);
    return (s.above | s.below) & nook_not(s.shared);
}

/* The same seen along an axis: coordinates u and v of corner i. */
typedef struct nook_seen {
    nook_lanes u[3], v[3], turn; /* twice the area as it is seen; 0 where that is not certain */
} nook_seen;

static inline nook_seen nook_see(const nook_several *a, uint32_t axis) {
    nook_lanes left, right;
    nook_seen s;
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        s.u[i] = axis == 0 ? a->p[i].y : axis == 1u ? a->p[i].z : a->p[i].x;
        s.v[i] = axis == 0 ? a->p[i].z : axis == 1u ? a->p[i].x : a->p[i].y;
    }
    left = (s.u[1] - s.u[0]) * (s.v[2] - s.v[0]), right = (s.v[1] - s.v[0]) * (s.u[2] - s.u[0]);
    s.turn = nook_if(nook_magnitude(left - right) >
                         (nook_magnitude(left) + nook_magnitude(right)) * nook_lanes_of(0x1p-20f),
                     left - right);
    return s;
}

/* Whether corner k of b lies beyond the edge from corner i to j of a, or is one of its ends. */
static inline nook_flags nook_is_past(const nook_several *a, const nook_seen *x, uint32_t i, uint32_t j,
                                      const nook_several *b, const nook_seen *y, uint32_t k) {
    nook_lanes eu = x->u[j] - x->u[i], ev = x->v[j] - x->v[i], du = y->u[k] - x->u[i], dv = y->v[k] - x->v[i];
    nook_lanes left = eu * dv, right = ev * du, margin = nook_magnitude(left) + nook_magnitude(right);
    margin = (margin * nook_lanes_of(0x1p-20f) + nook_lanes_of(0x1p-100f)) * nook_magnitude(x->turn);
    return ((left - right) * x->turn < -margin) | nook_is_shared(a, i, b, k) | nook_is_shared(a, j, b, k);
}

static inline nook_flags nook_edge_parts(const nook_several *a, const nook_seen *x, uint32_t i, uint32_t j,
                                         const nook_several *b, const nook_seen *y) {
    return nook_is_past(a, x, i, j, b, y, 0) & nook_is_past(a, x, i, j, b, y, 1) &
           nook_is_past(a, x, i, j, b, y, 2);
}

/* Whether, seen along an axis, b is beyond an edge of a but for shared ends of that. An edge with both is in two triangles
 * only if the third corner is beyond it. */
static inline nook_flags nook_is_beside(const nook_several *a, const nook_seen *x, const nook_several *b,
                                        const nook_seen *y) {
    return nook_edge_parts(a, x, 0, 1, b, y) | nook_edge_parts(a, x, 1, 2, b, y) |
           nook_edge_parts(a, x, 2, 0, b, y);
}
#endif

#endif
