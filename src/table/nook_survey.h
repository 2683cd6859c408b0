/* nook_survey.h -- what the triangles form together: components, fans, border loops.
 *
 * Three passes over V, O and C, each with 3 bits a triangle and 1 bit a vertex:
 *   components  depth-first search without a stack: the code of a triangle says by which corner it
 *               was entered, so the way back is O of that corner. 3 looks a triangle, and a pause
 *               anywhere.
 *   fans        corners joined around their vertex across edges of two triangles. A vertex whose
 *               triangles form more than one fan is non-manifold.
 *   loops       border edges joined around the vertices of the border, inside fans: two loops that
 *               touch at a vertex are two.
 * Two triangles that run their edge in the same direction are neighbours like others. link surveys
 * the mesh while O still pairs such edges; check surveys a finished O. */
#ifndef NOOK_SURVEY_H
#define NOOK_SURVEY_H

#include "core/nook_corner.h"
#include "core/nook_marks.h"
#include "exact/nook_exact.h"

typedef struct nook_survey {
    uint32_t components;           /* connected through any shared edge */
    uint32_t fans;                 /* vertices after cutting at non-manifold vertices and edges */
    uint32_t nonmanifold_vertices; /* of more than one fan; the ends of non-manifold edges included */
    uint32_t border_loops;         /* NOOK_UNKNOWN with non-manifold edges */
    nook_truth orientable;         /* NOOK_MAYBE with non-manifold edges */
} nook_survey;

static inline void nook_survey_unknown(nook_survey *survey) {
    survey->components = survey->fans = survey->nonmanifold_vertices = survey->border_loops = NOOK_UNKNOWN;
    survey->orientable = NOOK_MAYBE;
}

/* One edge-connected component, closed or not. */
typedef struct nook_shell {
    uint32_t first_triangle; /* the smallest */
    uint32_t triangles;
    uint32_t vertices;         /* distinct ones */
    uint32_t fans;             /* vertices after cutting at non-manifold ones */
    bool has_nonmanifold_edge; /* then the next four say nothing, and there is no volume */
    bool orientable;
    uint32_t border_edges, border_loops;
    uint32_t incoherent_edges;
    /* Filled by nook_geometry: */
    nook_volume volume;  /* six times the signed volume, exact; a volume only if closed and oriented */
    float signed_volume; /* rounded once; 0 unless the shell is closed and coherently oriented */
    /* By nook_orient_shells: it lies inside an odd number of others; until then NOOK_MAYBE. */
    nook_truth cavity;
} nook_shell;

/* The genus of a shell (number of handles) from fans - edges + triangles = 2 - 2g - loops;
 * NOOK_UNKNOWN if it is not orientable or has a non-manifold edge, and where no g fits: then the numbers are of no shell. */
uint32_t nook_shell_genus(const nook_shell *shell);

/* Where to put the shells one by one; optional. All arrays are the caller's. */
typedef struct nook_shells {
    nook_shell *shell;     /* [max_shells], in the order of their first triangles */
    nook_index *component; /* [nt] out: the shell of a triangle */
    nook_index *stamp;     /* [nv] scratch */
    uint32_t max_shells;   /* further shells are counted but not described */
    uint32_t count;        /* out: how many are described */
} nook_shells;

/* NOOK_NULL_ARGUMENT if shells is given without an array that nt triangles need. */
static inline nook_status nook_shells_status(const nook_shells *shells, uint32_t nt) {
    if (shells == NULL || nt == 0) return NOOK_OK;
    if (shells->component == NULL || shells->stamp == NULL) return NOOK_NULL_ARGUMENT;
    return shells->max_shells != 0 && shells->shell == NULL ? NOOK_NULL_ARGUMENT : NOOK_OK;
}

/* The shell of triangle t, or null if it is not described. */
static inline nook_shell *nook_shell_of(const nook_shells *shells, uint32_t t) {
    return shells != NULL && shells->component[t] < shells->count ? &shells->shell[shells->component[t]]
                                                                  : NULL;
}

typedef struct nook_survey_state {
    nook_view view;
    nook_index *rings;
    nook_marks marks;
    const nook_finder *finder;
    nook_shells *shells;
    nook_survey *result;
    uint32_t phase, at; /* the pass, and the triangle or corner it has come to */
    uint32_t hops;      /* left to this pass: tables that change underneath cannot hold it for ever */
    uint32_t c;         /* the corner looked across */
    uint32_t entry;     /* the corner by which the triangle of c was entered */
    uint32_t start;     /* where the walk began */
    uint32_t v;         /* the vertex it turns about */
    uint32_t home;      /* the corner that C names for v; NOOK_NONE once met */
    bool other_way, odd;
} nook_survey_state;

/* view: V and C valid; O pairs corners that face the same edge, and leaves others their own.
 * rings: null, or view->O writable, where the corners of each edge with more than two triangles name
 *   each other in a ring. The search takes these apart; it leaves no two of their corners mutual.
 * marks: for at least nt triangles and nv vertices. shells and finder may be null.
 * finder hears of NOOK_NOT_ORIENTABLE (once a component), NOOK_NONMANIFOLD_VERTEX (once each).
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks too small)
 *   NOOK_BAD_OPPOSITE from step, if O or V are not as above: never an endless walk nor a bad access
 * Steps: 8 nt hops of the search (5 nt without rings), 9 nt of the fans, 6 nt of the loops, and the
 * marks: less than 25 nt + 3 nv + 20 units, about 15 nt + nv on a closed mesh. One unit is at most 150
 * instructions on M4F. */
nook_status nook_survey_begin(nook_survey_state *state, const nook_view *view, nook_index *rings,
                              const nook_marks *marks, nook_shells *shells, const nook_finder *finder,
                              nook_survey *result);
nook_status nook_survey_step(nook_survey_state *state, uint32_t *units);

#endif
