/* nook_survey.h -- what the triangles form together: components, fans, border loops.
 *
 * It walks edge rings: every corner's entry names the next corner that faces the same edge, in a
 * cycle. A finished O table is the special case in which all rings have one or two corners. link
 * surveys the rings of a defective mesh before it cuts them; check surveys O.
 *
 * Three passes, each with 3 bits a triangle and 1 bit a vertex:
 *   components  depth-first search without a stack: the code of a triangle says how it was entered,
 *               so the way back is read from the tables. 3 looks a triangle, paused anywhere.
 *   fans        corners joined around their vertex across edges of two triangles. A vertex whose
 *               triangles form more than one fan is non-manifold.
 *   loops       border edges joined around the vertices of the border, inside fans: two loops that
 *               touch at a vertex are two. */
#ifndef NOOK_SURVEY_H
#define NOOK_SURVEY_H

#include "core/nook_corner.h"
#include "core/nook_marks.h"

typedef struct nook_survey {
    uint32_t components;           /* connected through any shared edge */
    uint32_t fans;                 /* vertices after cutting at non-manifold vertices and edges */
    uint32_t nonmanifold_vertices; /* of more than one fan; the ends of non-manifold edges included */
    uint32_t border_loops;         /* NOOK_UNKNOWN with non-manifold edges */
    nook_truth orientable;         /* NOOK_MAYBE with non-manifold edges */
} nook_survey;

/* One edge-connected component, closed or not. */
typedef struct nook_shell {
    uint32_t first_triangle; /* the smallest */
    uint32_t triangles;
    uint32_t vertices; /* distinct ones */
    uint32_t fans;     /* vertices after cutting at non-manifold ones */
    uint32_t border_edges, border_loops;
    uint32_t incoherent_edges;
    bool has_nonmanifold_edge;
    bool orientable;     /* meaningless with a non-manifold edge */
    float signed_volume; /* filled by check, for a closed, coherently oriented shell; else 0 */
} nook_shell;

/* The genus of a shell (number of handles) from fans - edges + triangles = 2 - 2g - loops;
 * NOOK_UNKNOWN if it is not orientable or has a non-manifold edge. */
uint32_t nook_shell_genus(const nook_shell *shell);

/* Where to put the shells one by one; optional. All arrays are the caller's. */
typedef struct nook_shells {
    nook_shell *shell;     /* [max_shells], in the order of their first triangles */
    nook_index *component; /* [nt] out: the shell of a triangle */
    nook_index *stamp;     /* [nv] scratch */
    uint32_t max_shells;   /* further shells are counted but not described */
    uint32_t count;        /* out: how many are described */
} nook_shells;

typedef struct nook_survey_state {
    nook_view view;
    nook_marks marks;
    const nook_finder *finder;
    nook_shells *shells;
    nook_survey *result;
    uint32_t phase, at;   /* the pass, and the triangle or corner it has come to */
    uint32_t c, entry;    /* where the walk stands */
    uint32_t root, start; /* where it began */
    uint32_t v;           /* the vertex it turns about */
    uint8_t third;        /* what the third bit of a code means; private */
    bool other_way;
} nook_survey_state;

/* rings: a view whose V and C are valid and whose O holds edge rings or opposite corners.
 * has_nonmanifold: whether any ring has three corners or more.
 * marks: for at least nt triangles and nv vertices. shells and finder may be null.
 * Found through finder: NOOK_NOT_ORIENTABLE (once a component), NOOK_NONMANIFOLD_VERTEX (once each).
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks too small)
 *   NOOK_BAD_OPPOSITE from step, if the rings change underneath it: never an endless walk
 * Steps: at most 3 nt hops of the search, 3 of the fans and 3 of the loops, plus the clearing of
 * the marks; one unit is one hop, at most 120 instructions. */
nook_status nook_survey_begin(nook_survey_state *state, const nook_view *rings, bool has_nonmanifold,
                              const nook_marks *marks, nook_shells *shells, const nook_finder *finder,
                              nook_survey *result);
nook_status nook_survey_step(nook_survey_state *state, uint32_t *units);

#endif
