/* nook_relation.h -- the nine relations between vertices, edges and faces.
 *
 * An edge is named by its canonical corner: the smaller of the one or two that face it. Lists about a vertex run
 * counter-clockwise: face i lies between edges i and i + 1, and vertex i ends edge i. Inside, the list is
 * circular and begins anywhere; at a border it begins at the border, and k faces lie between k + 1 edges.
 * (At a vertex where several fans touch, the fan of its own corner C[v].)
 *
 *                v2
 *               /|\           For edge e, faced by its corner c: v1 = v(n(c)), v2 = v(p(c)),
 *           e3 / | \ e4       f1 = t(c) on the left of v1 -> v2, f2 = t(o(c)) on the right.
 *             /  |  \
 *           c<f1 |e f2>o(c)
 *             \  |  /
 *           e1 \ | / e2
 *               \|/
 *                v1
 *
 * Memory: none. Steps: VV, VE, VF one for a triangle of the fan, twice; the others one. */
#ifndef NOOK_RELATION_H
#define NOOK_RELATION_H

#include "walk/nook_star.h"

/* The edge that corner c faces. */
static inline uint32_t nook_edge(const nook_view *m, uint32_t c) { return m->O[c] < c ? m->O[c] : c; }

typedef enum nook_relation {
    NOOK_VV, /* the vertices joined to a vertex by an edge */
    NOOK_VE, /* the edges that end at a vertex */
    NOOK_VF, /* the faces at a vertex */
    NOOK_EV, /* v1, v2 */
    NOOK_EE, /* e1, e2, e3, e4; NOOK_NONE for e2 and e4 at a border */
    NOOK_EF, /* f1, f2: the star of the edge; NOOK_NONE for f2 at a border */
    NOOK_FV, /* v0, v1, v2 of the face */
    NOOK_FE, /* e0, e1, e2: e_i joins v_i and v_(i+1) */
    NOOK_FF  /* the face across e_i; NOOK_NONE at a border */
} nook_relation;

typedef struct nook_related {
    nook_star star;
    nook_relation relation;
    uint32_t c;  /* a corner of the vertex, edge or face; of a star, the last one given */
    uint32_t at; /* how many have been given */
} nook_related;

/* Begin with the vertex, edge (any corner that faces it) or face.
 *   NOOK_INDEX_OUT_OF_RANGE  there is no such element
 *   NOOK_BAD_OPPOSITE        as for a star */
nook_status nook_related_begin(nook_related *list, const nook_view *view, nook_relation relation,
                               uint32_t element);

/* Whether there is another; then it is in *element. */
bool nook_related_next(nook_related *list, uint32_t *element);

#endif
