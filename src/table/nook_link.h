/* nook_link.h -- find the opposite corner of every corner: O and C from V.
 *
 * Two corners are opposite when the edges they face carry the same two vertices in opposite
 * directions (Rossignac). A corner on an edge of one triangle, of more than two, or of two that run
 * it the same way, becomes its own opposite; the report says how many of each kind there are, since
 * O alone can no longer tell. No triangle is ever dropped. */
#ifndef NOOK_LINK_H
#define NOOK_LINK_H

#include "table/nook_sort.h"
#include "table/nook_survey.h"

/* What link learned and O cannot show. Keep it with the mesh: nook_check() reads it. */
typedef struct nook_report {
    uint32_t triangles;           /* of the mesh that was linked */
    uint32_t edges;               /* distinct vertex pairs: the sum of the next four */
    uint32_t border_edges;        /* one triangle */
    uint32_t matched_edges;       /* two triangles, opposite directions */
    uint32_t incoherent_edges;    /* two triangles, the same direction */
    uint32_t nonmanifold_edges;   /* three triangles or more */
    uint32_t odd_edges;           /* with an odd number of triangles */
    uint32_t duplicate_triangles; /* sum over vertex sets of (copies - 1) */
    nook_survey survey; /* filled for a mesh with incoherent or non-manifold edges, if marks were given;
                           else its counts are NOOK_UNKNOWN and check finds them from O */
} nook_report;

typedef struct nook_link_state {
    nook_mesh *mesh;
    nook_report *report;
    const nook_finder *finder;
    nook_marks marks;
    nook_shells *shells;
    nook_where where;      /* of an error */
    uint32_t phase, at;    /* the pass, and the vertex, triangle or corner it has come to */
    uint32_t list, leader; /* inside a list or ring: the corner reached, and the one it began with */
    uint32_t corners;      /* of the ring being counted */
    uint32_t flags;        /* private: what was met that a sound mesh does not have */
    union {
        nook_list_sort sort;
        nook_survey_state survey;
    } in;
} nook_link_state;

/* Link mesh: reads V[3 nt], writes O[3 nt] and C[nv]. The only other memory is C itself, which
 * holds the heads of lists on the way.
 *   marks   for nt triangles and nv vertices, or null: then a mesh with incoherent or non-manifold
 *           edges is linked and its edges are counted, but its components, orientability,
 *           non-manifold vertices and, with non-manifold edges, duplicates stay unknown
 *   shells  described here if the mesh is surveyed here; may be null
 *   finder  told of NOOK_BORDER_EDGE, NOOK_INCOHERENT_EDGE, NOOK_NONMANIFOLD_EDGE (where: the smallest
 *           corner that faces the edge), NOOK_DUPLICATE_TRIANGLE, and what the survey finds; may be null
 *   NOOK_NULL_ARGUMENT       an argument, or an array of marks or shells
 *   NOOK_NO_CAPACITY         marks too small
 *   NOOK_INDEX_OUT_OF_RANGE  V names no vertex. state->where: the corner
 *   NOOK_REPEATED_VERTEX     state->where: the triangle; nook_drop_degenerate() removes such
 * After an error O, C and the report hold nothing of use; V and G are never written.
 * Steps: nv + 4 nt units for a sound mesh: 3 nt insertions of at most 16 looks, three to a unit, and 3 nt to
 * pair. Edges beyond the 16th of one vertex are sorted: 2 n (log2 n + 3) units for n of them. A mesh
 * with defects: at most 15 nt + nv more, and the survey. One unit is at most 1,200 instructions on M4F. */
nook_status nook_link_begin(nook_link_state *state, nook_mesh *mesh, const nook_marks *marks,
                            nook_shells *shells, const nook_finder *finder, nook_report *report);
nook_status nook_link_step(nook_link_state *state, uint32_t *units);
nook_status nook_link(nook_mesh *mesh, const nook_marks *marks, nook_shells *shells,
                      const nook_finder *finder, nook_report *report, nook_where *where);

/* The first half of it, without a report, for those who look at edges before there are opposites: O[c] is the next of the
 * corners that face the edge of c, whichever way their triangles run it, round in a ring. One of a border is alone, two
 * name each other, and of three or more no two do. C is as after link. Statuses and steps are those of a sound mesh. */
nook_status nook_link_rings_begin(nook_link_state *state, nook_mesh *mesh);

#endif
