/* nook_star.h -- the triangles around a vertex, one after the other, in either direction.
 *
 * A vertex of a manifold mesh has one fan of triangles: closed inside, open at a border. A star visits the fan
 * of one corner, each triangle once, and ends. At a vertex where several fans touch (a bow-tie) it stays in
 * the fan of the corner it is given; nook_corner_after() finds those of the other fans.
 * Tables may hold any bits: no access leaves them, and no star is longer than nt triangles. */
#ifndef NOOK_STAR_H
#define NOOK_STAR_H

#include "core/nook_corner.h"

typedef struct nook_star {
    const nook_view *view;
    uint32_t first; /* the corner it began with */
    uint32_t next;  /* the corner to come; NOOK_NONE: that was all */
    uint32_t left;  /* how many may still come */
    bool open;      /* ends at a border; else it comes round */
    bool clockwise;
} nook_star;

/* The next corner about v(c), clockwise (as the swing turns) or counter-clockwise; NOOK_NONE at a border,
 * and where the tables do not hold. */
static inline uint32_t nook_turn(const nook_view *m, uint32_t c, bool clockwise) {
    uint32_t e = clockwise ? nook_prev(c) : nook_next(c), o = m->O[e];
    if (o == e || o >= 3u * m->nt) return NOOK_NONE;
    o = clockwise ? nook_prev(o) : nook_next(o);
    return m->V[o] == m->V[c] ? o : NOOK_NONE;
}

/* Begin the star of v(c) in the fan of corner c: at c if the fan is closed, else at the end from which all
 * others follow. *star keeps the pointer to the view.
 *   NOOK_INDEX_OUT_OF_RANGE  c is no corner
 *   NOOK_BAD_OPPOSITE        turning back from c leads neither to a border nor back to c
 * Steps: the triangles of the fan. */
nook_status nook_star_begin(nook_star *star, const nook_view *view, uint32_t c, bool clockwise);

/* The next corner of the star, or NOOK_NONE after the last. Steps: 1. */
uint32_t nook_star_next(nook_star *star);

/* How many triangles the fan of corner c has; 0 where nook_star_begin() would fail. */
uint32_t nook_valence(const nook_view *view, uint32_t c);

/* The first corner of vertex v after corner c (NOOK_NONE: from the first), in any fan; NOOK_NONE if there is
 * none. Steps: the corners between, up to 3 nt. */
uint32_t nook_corner_after(const nook_view *view, uint32_t v, uint32_t c);

#endif
