/* nook_geometry.h -- what a linked mesh measures: box, area, volume, mass, edges, convexity.
 *
 * Signs and counts are exact for all finite coordinates; they do not depend on the order of triangles or on
 * the core. Area, centroid and inertia are compensated float32 sums in the order of the triangles, the same
 * bits on every core. nook_check() does all this as its last part; call it yourself for tables that are
 * known to be good. */
#ifndef NOOK_GEOMETRY_H
#define NOOK_GEOMETRY_H

#include "table/nook_survey.h"

/* A running sum that keeps what rounding lost (Neumaier 1974): the error of the total is that of
 * one addition, for any number of terms and any order of magnitudes. */
typedef struct nook_sum {
    float total, lost;
} nook_sum;

void nook_add(nook_sum *sum, float term);

static inline float nook_sum_value(const nook_sum *sum) { return sum->total + sum->lost; }

typedef struct nook_geometry {
    bool known;                  /* the rest is filled */
    nook_point box_min, box_max; /* of the vertices of triangles; 0 without any */
    float area;
    uint32_t zero_area_triangles; /* three different vertices on one line */

    /* Edges of two triangles that run it in opposite directions, seen from the side the triangles face; of a
     * closed mesh from outside, which is the other side if the volume is negative. Edges beside a triangle
     * without area count as none of them, so the four need not add up to all edges. */
    uint32_t concave_edges; /* the far corner of each triangle lies above the plane of the other */
    uint32_t convex_edges;  /* below */
    uint32_t flat_edges;    /* in it, and both face the same way */
    uint32_t folded_edges;  /* in it, and one lies back upon the other */

    /* Only for a closed mesh; else 0 and NOOK_MAYBE. */
    nook_volume volume; /* six times the signed volume, exact */
    int volume_sign;
    float signed_volume; /* rounded once */
    /* Of the solid of density 1, whichever way its triangles face: the centroid, and the inertia about it in
     * the order of URDF, xx, xy, xz, yy, yz, zz, where xy is minus the integral of x y; times m / |volume| for
     * a mass m. Only with mass_known: where the volume is more than a 4096th of the area times the size, and
     * float32 sums come within a thousandth of it; thinner bodies need more digits. */
    bool mass_known;
    nook_point centroid;
    float inertia[6];
    /* It has a volume, and no vertex is outside the plane of a triangle. If not convex, such a vertex and triangle
     * are the witness; NOOK_NONE without volume. */
    nook_truth convex;
    uint32_t witness_vertex, witness_triangle;
    /* Closed, oriented shells of negative and of no volume; without shells the whole mesh is one. */
    uint32_t inside_out_shells, flat_shells;
} nook_geometry;

typedef struct nook_geometry_state {
    nook_view view;
    nook_shells *shells;
    const nook_finder *finder;
    nook_geometry *result;
    uint32_t phase, at;
    uint32_t debt; /* units of work done and not yet paid for */
    bool closed;
    union {
        struct {
            float scale;       /* brings the box to about 1 */
            nook_point offset; /* of the centroid from the middle of the box, scaled */
            nook_sum sum[6];   /* area; or volume and three moments; or six second moments */
        } mass;
        struct {
            uint32_t vertex[4], found; /* four vertices that span a volume */
            uint32_t axis;             /* against which the first three turn */
            uint32_t layers;           /* triangles above the first of them */
            uint32_t against, held;    /* next to hold the present item against; the last triangle held */
        } hull;
    } in;
} nook_geometry_state;

/* Measure a view with good tables: V in range, O of pairs that face one edge in opposite directions, C naming
 * corners, coordinates finite and at most 2^30. With any bits in O, C and G the answers are wrong, but no
 * access leaves the arrays and the bound on steps holds; V is trusted.
 *   closed  every corner's edge has two triangles, in O: then there is a volume
 *   shells  as nook_survey() filled them: each gets its own signed volume; or null
 *   finder  hears of NOOK_ZERO_AREA_TRIANGLE, NOOK_FOLDED_EDGE, NOOK_INSIDE_OUT, NOOK_FLAT_SHELL; or null
 *   NOOK_NULL_ARGUMENT
 * Convexity takes one pass: every edge convex or flat, four vertices that span a volume on the inner
 * side of every triangle, and one triangle above a point between them (Mehlhorn et al. 1999). Where that does
 * not tell, triangles are held against all vertices and vertices against all triangles: k of them, beside
 * triangles without area (one for each run of them in a plane) and vertices of nothing else, or all
 * if the surface goes round more than once.
 * Steps: less than 140 nt + 13 nv + 30 units; with k > 0 such elements 90 (nt + nv) + 10 k (nv + nt) more.
 * About 40 nt on a mesh with a concave edge, 90 nt on a convex one. A unit is at most 450 instructions on
 * M4F; exact signs are paid at their worst, 9 units for orient3d and 4 for orient2d, so the mean is far
 * less. What is begun is done: a call may overdraw its units by 88, and the next calls pay first. */
nook_status nook_geometry_begin(nook_geometry_state *state, const nook_view *view, bool closed,
                                nook_shells *shells, const nook_finder *finder, nook_geometry *result);
nook_status nook_geometry_step(nook_geometry_state *state, uint32_t *units);

#endif
