/* nook_apart.h -- several pairs of triangles at once: which are apart for certain, but for the corners that they share.
 *
 * Floats with bounds on their error say so for nearly all pairs of neighbours; what they leave open, nook_pair.h settles. */
#ifndef NOOK_APART_H
#define NOOK_APART_H

#include "query/nook_lanes.h"

/* Some triangles: their corners' vertices, where those are, and boxes. */
typedef struct nook_several {
    nook_flags v[3];
    nook_vectors p[3], low, high;
#if NOOK_LANES > 1
    nook_vectors normal;
    nook_lanes size; /* no component of the normal is larger than twice this */
#endif
} nook_several;

#if NOOK_LANES > 1
static inline nook_vectors nook_spread(const nook_vectors *a, uint32_t k) {
    return nook_vectors_of(nook_make(a->x[k], a->y[k], a->z[k]));
}

/* Triangle k of some, in all lanes: its plane and its first corner; and the others. */
static inline void nook_spread_plane(const nook_several *a, uint32_t k, nook_several *to) {
    uint32_t i;
    for (i = 0; i < 3u; i++) to->v[i] = nook_all_flags() & a->v[i][k];
    to->p[0] = nook_spread(&a->p[0], k);
    to->normal = nook_spread(&a->normal, k);
    to->size = nook_lanes_of(a->size[k]);
}

static inline void nook_spread_corners(const nook_several *a, uint32_t k, nook_several *to) {
    to->p[1] = nook_spread(&a->p[1], k);
    to->p[2] = nook_spread(&a->p[2], k);
}

/* The normals, as far as they are certainly less than a right angle off; else 0, which tells no sides. */
static inline void nook_set_normal(nook_several *a) {
    nook_vectors e = nook_vectors_sub(a->p[1], a->p[0]), f = nook_vectors_sub(a->p[2], a->p[0]);
    nook_vectors n = nook_vectors_cross(e, f);
    nook_flags sure;
    a->size = nook_largest(e) * nook_largest(f);
    sure = nook_largest(n) > a->size * nook_lanes_of(0x1p-20f) + nook_lanes_of(0x1p-100f);
    a->normal.x = nook_if(sure, n.x), a->normal.y = nook_if(sure, n.y), a->normal.z = nook_if(sure, n.z);
}

/* Whether corner j of some triangles is corner i of others. */
static inline nook_flags nook_is_shared(const nook_several *a, uint32_t i, const nook_several *b,
                                        uint32_t j) {
    return (nook_flags)(a->v[i] == b->v[j]);
}

static inline nook_flags nook_is_any_of(const nook_several *a, const nook_several *b, uint32_t j) {
    return nook_is_shared(a, 0, b, j) | nook_is_shared(a, 1, b, j) | nook_is_shared(a, 2, b, j);
}

/* How high corner j of b lies above a plane with normal n through corner i of a. */
static inline nook_lanes nook_height(const nook_several *a, uint32_t i, nook_vectors n, const nook_several *b,
                                     uint32_t j) {
    return nook_vectors_dot(n, nook_vectors_sub(b->p[j], a->p[i]));
}

/* Whether b touches the plane of a in shared corners only, and else lies on one side. Then it meets a nowhere else. No
 * corner is farther from one of the other along an axis than reach. */
static inline nook_flags nook_is_on_one_side(const nook_several *a, const nook_several *b, nook_lanes reach) {
    nook_lanes margin = a->size * reach * nook_lanes_of(0x1p-17f) + nook_lanes_of(0x1p-120f);
    nook_lanes x = nook_height(a, 0, a->normal, b, 0), y = nook_height(a, 0, a->normal, b, 1),
               z = nook_height(a, 0, a->normal, b, 2);
    nook_flags i = nook_is_any_of(a, b, 0), j = nook_is_any_of(a, b, 1), k = nook_is_any_of(a, b, 2);
    return ((((x > margin) | i) & ((y > margin) | j) & ((z > margin) | k)) |
            (((x < -margin) | i) & ((y < -margin) | j) & ((z < -margin) | k))) &
           nook_not(i & j & k);
}

/* Whether b lies beyond the edge from corner i to j of a, over which a plane stands upright, but for shared ends of that. */
static inline nook_flags nook_edge_parts(const nook_several *a, uint32_t i, uint32_t j, const nook_several *b,
                                         nook_lanes reach) {
    nook_vectors e = nook_vectors_sub(a->p[j], a->p[i]), out = nook_vectors_cross(e, a->normal);
    nook_lanes margin =
        a->size * nook_largest(e) * reach * nook_lanes_of(0x1p-16f) + nook_lanes_of(0x1p-100f);
    nook_flags past[3];
    uint32_t k;
    for (k = 0; k < 3u; k++) {
        past[k] = nook_height(a, i, out, b, k) > margin;
        past[k] = past[k] | nook_is_shared(a, i, b, k) | nook_is_shared(a, j, b, k);
    }
    return past[0] & past[1] & past[2];
}

static inline nook_flags nook_is_beside(const nook_several *a, const nook_several *b, nook_lanes reach) {
    return nook_edge_parts(a, 0, 1, b, reach) | nook_edge_parts(a, 1, 2, b, reach) |
           nook_edge_parts(a, 2, 0, b, reach);
}
#endif

#endif
