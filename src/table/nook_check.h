/* nook_check.h -- is this mesh sound, and if not, where? Over const tables, at boot or at any time.
 *
 * Everything is checked before it is used: indices, then coordinates, then O, then what the
 * triangles form together, then their geometry. A pass whose ground is broken is left out and its
 * answers are unknown. Nothing is repaired and nothing but *result, the marks and the shells is written. */
#ifndef NOOK_CHECK_H
#define NOOK_CHECK_H

#include "table/nook_geometry.h"
#include "table/nook_link.h"

typedef struct nook_check_result {
    /* Tables. With any of the first three, what follows that needs them is unknown. */
    uint32_t bad_indices;     /* corners whose V is out of range */
    uint32_t bad_opposites;   /* corners whose O is out of range, not mutual, or faces another edge */
    uint32_t bad_corners;     /* vertices whose C is not one of their corners, or hides that they have one */
    uint32_t bad_coordinates; /* vertices not finite or beyond 2^30 */
    uint32_t repeated_vertex_triangles;
    uint32_t isolated_vertices;

    uint32_t vertices, triangles; /* as in the view */
    /* From link's report; NOOK_UNKNOWN without it. */
    uint32_t edges, border_edges, matched_edges, incoherent_edges, nonmanifold_edges, duplicate_triangles;
    /* What the triangles form. */
    nook_survey survey;
    int32_t euler; /* referenced vertices - edges + triangles; only when edges is known */
    bool euler_known;
    /* Of all components together, if orientable: fans - edges + triangles = 2 s - 2 g - h (Euler-Poincare);
     * NOOK_UNKNOWN where no g fits, for then report and tables are not of one surface. */
    uint32_t handles;

    nook_truth edge_manifold; /* no edge with more than two triangles */
    nook_truth manifold;      /* that, at least one triangle, and every vertex a single fan */
    nook_truth even;          /* every edge has an even number of triangles */
    nook_truth watertight;    /* at least one triangle, and every edge has exactly two */
    nook_truth oriented;      /* no incoherent edge */
    nook_truth clean;         /* no isolated vertex, no triangle with a repeated vertex */
    nook_truth simple;        /* one shell of genus 0: watertight, manifold, orientable */
    nook_truth patch;         /* a disk (T-patch): one component, manifold, orientable, genus 0, one loop */
    nook_truth inside_out;    /* signed volume < 0; NOOK_MAYBE unless watertight and oriented */

    nook_geometry geometry; /* known if the tables and all coordinates are good */
} nook_check_result;

typedef struct nook_check_state {
    nook_view view;
    nook_marks marks;
    const nook_report *report;
    nook_shells *shells;
    const nook_finder *finder;
    nook_check_result *result;
    uint32_t phase, at, loose; /* loose: corners that are their own opposite */
    union {
        nook_survey_state survey;
        nook_geometry_state geometry;
    } in;
} nook_check_state;

/* Check a view.
 *   marks   for nt triangles and nv vertices
 *   report  what link said of this mesh. Null: then edges that O leaves alone are taken for borders, though they
 *           may be incoherent or non-manifold; the survey is of the mesh cut there, and which edges there
 *           are, and with them manifold, watertight and oriented, is unknown. Nothing is sound without it
 *   shells  each component described, signed volumes included; the same struct that was given to
 *           link; may be null
 *   finder  told of what check itself finds: bad tables and numbers, isolated vertices, what
 *           nook_geometry finds, and the survey's findings if it is done here. Edges and duplicates were told by link. May be null
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (marks too small, or report of another triangle count)
 * A report that cannot be of these tables (its edges do not add up to the corners that O leaves alone) is
 * taken for no report: edges is then NOOK_UNKNOWN. view and marks are copied; report, shells, finder, result and
 * the tables must stay until the end, and nobody else may touch the marks; result says nothing before that.
 * A defect is not an error of the call: step returns NOOK_OK when the check is finished, and
 * nook_is_sound() gives the verdict. Every table may hold any bits, as long as they hold still: no access leaves
 * the arrays and the bound on steps holds. If O or marks change on the way the same is true of those, and step may
 * return NOOK_BAD_OPPOSITE; V that changes on the way is not looked at again.
 * Steps: at most NOOK_CHECK_UNITS(nt, nv, 0), about 60 nt + 5 nv on a sound mesh; the third number counts
 * elements that must be held against all others (nook_geometry.h: only in closed meshes without a concave
 * edge but with triangles without area, or wound twice). One unit is at most 450 instructions on M4F. */
#define NOOK_CHECK_UNITS(nt, nv, doubtful)                                                                   \
    (175u * (uint64_t)(nt) + 25u * (uint64_t)(nv) + 50u +                                                    \
     ((doubtful) != 0 ? (90u + 10u * (uint64_t)(doubtful)) * ((uint64_t)(nt) + (nv)) : 0u))

nook_status nook_check_begin(nook_check_state *state, const nook_view *view, const nook_marks *marks,
                             const nook_report *report, nook_shells *shells, const nook_finder *finder,
                             nook_check_result *result);
nook_status nook_check_step(nook_check_state *state, uint32_t *units);
nook_status nook_check(const nook_view *view, const nook_marks *marks, const nook_report *report,
                       nook_shells *shells, const nook_finder *finder, nook_check_result *result);

/* The verdict: tables whole, manifold, watertight, oriented, no duplicate, no repeated vertex, no
 * triangle without area, no fold, and a positive volume: of every shell if shells were given, else of all
 * together. Unknown counts as no. */
bool nook_is_sound(const nook_check_result *result);

#endif
