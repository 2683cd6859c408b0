/* nook_corner.h -- the operators of the corner table (Rossignac, "Triangle Meshes: Summary").
 *
 * Each is one or two reads, without a loop. Operators trust their argument and the tables: run
 * nook_check() first on tables of unknown origin. A corner c faces the edge from v(n(c)) to v(p(c)).
 *
 *                      v(c)
 *                       /\                 t   triangle            b   faces a border
 *                      /c \                v   vertex              o   opposite
 *            l(c)     /    \     r(c)      g   point               l   left      o(p(c))
 *                    /  t   \              n   next                r   right     o(n(c))
 *                   /n      p\             p   previous            s   swing     p(l(c))
 *             v(n) /__________\ v(p)
 *                  \          /            Where the listing in the seed swaps l and r, its text is
 *                   \        /             right: with l(c) = o(p(c)) the swing keeps the vertex.
 *                    \      /
 *                     \o(c)/
 *                      \  /
 *                       \/
 */
#ifndef NOOK_CORNER_H
#define NOOK_CORNER_H

#include "core/nook_mesh.h"

/* t(c): the triangle of a corner. 43691/2^17 is exact for every 16-bit corner, so a core without
 * a divider does not call one. */
static inline uint32_t nook_triangle(uint32_t c) {
#if NOOK_INDEX_BITS == 16
    return (c * 43691u) >> 17;
#else
    return c / 3u;
#endif
}

/* n(c): the next corner counter-clockwise in the same triangle. */
static inline uint32_t nook_next(uint32_t c) { return c - 3u * nook_triangle(c) == 2u ? c - 2u : c + 1u; }

/* p(c): the previous corner; p(c) = n(n(c)). */
static inline uint32_t nook_prev(uint32_t c) { return c == 3u * nook_triangle(c) ? c + 2u : c - 1u; }

/* v(c): the vertex of a corner. */
static inline uint32_t nook_vertex(const nook_view *m, uint32_t c) { return m->V[c]; }

/* g(c): the point of the vertex of a corner. */
static inline nook_point nook_point_at(const nook_view *m, uint32_t c) { return m->G[m->V[c]]; }

/* o(c): the corner on the other side of the edge that c faces; c itself at a border.
 *
 *          c
 *         /\
 *        /  \          v(n(c)) = v(p(o(c)))
 *       /n__p\         v(p(c)) = v(n(o(c)))
 *       \p  n/
 *        \  /
 *         \/
 *        o(c)                    */
static inline uint32_t nook_opposite(const nook_view *m, uint32_t c) { return m->O[c]; }

/* b(c): whether c faces a border edge. */
static inline bool nook_is_border(const nook_view *m, uint32_t c) { return m->O[c] == c; }

/* l(c): the corner opposite to p(c), across the edge from v(c) to v(n(c)); p(c) itself at a border. */
static inline uint32_t nook_left(const nook_view *m, uint32_t c) { return m->O[nook_prev(c)]; }

/* r(c): the corner opposite to n(c), across the edge from v(c) to v(p(c)); n(c) itself at a border. */
static inline uint32_t nook_right(const nook_view *m, uint32_t c) { return m->O[nook_next(c)]; }

/* s(c): the corner at the same vertex in the triangle on the left: one turn clockwise about v(c).
 * Where the edge v(c) v(n(c)) is a border, s(c) = n(c) leaves the vertex and goes on along the
 * border: s is then a permutation of all corners, whose orbits are the stars of interior vertices
 * and one orbit for each border loop. To visit a star, test for the border first.
 *
 *        v(n(c)) _____ v(p(c))
 *              /\     /
 *             /  \ t /
 *       l(c) /    \c/
 *           /_____s\v(c)           s(c) = p(l(c)) */
static inline uint32_t nook_swing(const nook_view *m, uint32_t c) { return nook_prev(nook_left(m, c)); }

/* The corner of triangle t at vertex v, or NOOK_NONE. */
static inline uint32_t nook_corner_in(const nook_view *m, uint32_t t, uint32_t v) {
    uint32_t c = 3u * t;
    if (m->V[c] == v) return c;
    if (m->V[c + 1u] == v) return c + 1u;
    return m->V[c + 2u] == v ? c + 2u : NOOK_NONE;
}

/* One corner of vertex v, or NOOK_NONE if it belongs to no triangle. */
static inline uint32_t nook_corner_of(const nook_view *m, uint32_t v) {
    nook_index c = m->C[v];
    return c == NOOK_STORED_NONE ? NOOK_NONE : (uint32_t)c;
}

/* nvat(v,t): the next vertex around triangle t after v, or NOOK_NONE if v is not one of t's. */
static inline uint32_t nook_nvat(const nook_view *m, uint32_t v, uint32_t t) {
    uint32_t c = nook_corner_in(m, t, v);
    return c == NOOK_NONE ? NOOK_NONE : (uint32_t)m->V[nook_next(c)];
}

/* ntav(t,v): the next triangle around vertex v after t (clockwise, as the swing turns), or
 * NOOK_NONE at a border or if v is not one of t's. */
static inline uint32_t nook_ntav(const nook_view *m, uint32_t t, uint32_t v) {
    uint32_t c = nook_corner_in(m, t, v);
    if (c == NOOK_NONE || nook_is_border(m, nook_prev(c))) return NOOK_NONE;
    return nook_triangle(nook_left(m, c));
}

#endif
