/* nook_halfedge.h -- the same mesh seen as half-edges: of a half-edge structure, of MeshLib, of the quad-edge.
 *
 * Nothing is stored. Half-edge h = 2 c + side, where c is the canonical corner of the edge: side 0 runs in the
 * triangle of c, side 1 in the triangle across or, at a border, along the hole. So h ^ 1 is always the other half,
 * and h / 2 the edge. A half-edge runs from its origin to its target with its face on the left; the face on
 * the left of a border's hole side is NOOK_NONE. The edge algebra of Guibas and Stolfi holds everywhere:
 * about a border vertex the two hole sides follow each other, as if the hole were a face.
 *
 *              target                     quad-edge (seed 004)        here
 *         lnext  |   rprev                eSym                        nook_pair
 *               ^|                        eOnext  eOprev              nook_onext   nook_oprev
 *      left  h | | right                  eDnext  eDprev              nook_dnext   nook_dprev
 *              | v                        eLnext  eLprev              nook_next_halfedge, nook_prev_halfedge
 *         lprev  |   rnext                eRnext  eRprev              nook_rnext   nook_rprev
 *              origin                     next, prev (MeshLib)        nook_onext   nook_oprev
 *
 * Memory: none. Steps: 1; on a hole side the triangles of one fan, and NOOK_NONE where O does not hold. h must be a
 * half-edge of the view. */
#ifndef NOOK_HALFEDGE_H
#define NOOK_HALFEDGE_H

#include "walk/nook_border.h"
#include "walk/nook_relation.h"

/* The half-edge that runs along the edge which corner c faces, in the triangle of c; and its other half. */
static inline uint32_t nook_halfedge(const nook_view *m, uint32_t c) {
    uint32_t e = nook_edge(m, c);
    return 2u * e + (e != c);
}
static inline uint32_t nook_pair(uint32_t h) { return h == NOOK_NONE ? h : h ^ 1u; }

/* The corner that faces the edge from the left face; NOOK_NONE on the hole side of a border, and where O names no
 * corner. */
static inline uint32_t nook_halfedge_corner(const nook_view *m, uint32_t h) {
    uint32_t c = h >> 1, o = nook_opposite(m, c);
    if ((h & 1u) == 0) return c;
    return o == c || o >= 3u * m->nt ? NOOK_NONE : o;
}

/* Whether h names a half-edge: an id from 0 to 6 nt - 1 whose corner is the canonical one of its edge. Others
 * are what MeshLib calls lone. */
static inline bool nook_is_halfedge(const nook_view *m, uint32_t h) {
    return h < 6u * m->nt && nook_edge(m, h >> 1) == h >> 1;
}

static inline uint32_t nook_origin(const nook_view *m, uint32_t h) {
    return m->V[(h & 1u) == 0 ? nook_next(h >> 1) : nook_prev(h >> 1)];
}
static inline uint32_t nook_target(const nook_view *m, uint32_t h) { return nook_origin(m, h ^ 1u); }

static inline uint32_t nook_left_face(const nook_view *m, uint32_t h) {
    uint32_t c = nook_halfedge_corner(m, h);
    return c == NOOK_NONE ? NOOK_NONE : nook_triangle(c);
}
static inline uint32_t nook_right_face(const nook_view *m, uint32_t h) { return nook_left_face(m, h ^ 1u); }

/* The next half-edge around the left face, or around the hole; and the one before. */
uint32_t nook_next_halfedge(const nook_view *m, uint32_t h);
uint32_t nook_prev_halfedge(const nook_view *m, uint32_t h);

/* Around the origin, counter-clockwise: the next, and the one before. */
static inline uint32_t nook_onext(const nook_view *m, uint32_t h) {
    return nook_pair(nook_prev_halfedge(m, h));
}
static inline uint32_t nook_oprev(const nook_view *m, uint32_t h) { return nook_next_halfedge(m, h ^ 1u); }
/* Around the target, counter-clockwise, of those that end there. */
static inline uint32_t nook_dnext(const nook_view *m, uint32_t h) { return nook_pair(nook_onext(m, h ^ 1u)); }
static inline uint32_t nook_dprev(const nook_view *m, uint32_t h) { return nook_pair(nook_oprev(m, h ^ 1u)); }
/* Around the right face, counter-clockwise, of those with that face on the right. */
static inline uint32_t nook_rnext(const nook_view *m, uint32_t h) {
    return nook_pair(nook_next_halfedge(m, h ^ 1u));
}
static inline uint32_t nook_rprev(const nook_view *m, uint32_t h) {
    return nook_pair(nook_prev_halfedge(m, h ^ 1u));
}

/* A half-edge that begins at vertex v, or NOOK_NONE, also where C names no corner; where to begin an origin ring. */
static inline uint32_t nook_halfedge_of_vertex(const nook_view *m, uint32_t v) {
    uint32_t c = nook_corner_of(m, v);
    return c >= 3u * m->nt ? NOOK_NONE : nook_halfedge(m, nook_prev(c));
}

#endif
