/* nook.h -- triangle meshes in a fixed corner of memory. Include this one header.
 *
 * CONVENTIONS, once for all rooms
 *
 * Words. A mesh has T triangles (t), V vertices (v) and C = 3T corners (c). nt, nv are how many;
 * name[n] in a comment is an array of n entries. An edge is named by a corner that faces it.
 * The tables are those of Rossignac's corner table: core/nook_mesh.h draws them.
 *
 * Memory. There is no allocation, hence nothing to close. Every array is the caller's, and every
 * size is a macro that stands in a declaration. State structs belong to the caller; nothing is kept
 * between calls anywhere else, so any function may run in any task, on any data that no other task
 * is writing. There are no mutable statics.
 *
 * Indices. Stored as nook_index (16 or 32 bits, NOOK_INDEX_BITS); passed as uint32_t. NOOK_NONE means
 * no element, NOOK_UNKNOWN a count that cannot be told.
 *
 * Status. Functions that can fail return a nook_status; NOOK_OK is 0. A status about an element comes
 * with a nook_where. Data can never break an assertion; NOOK_REQUIRE is for mistakes of the program.
 *
 * Steps. Whatever takes longer than a look around one vertex comes in three forms:
 *     nook_X_begin(&state, ...)      checks the arguments, touches nothing large
 *     nook_X_step(&state, &units)    works until done or until units is 0: NOOK_OK when done,
 *                                    NOOK_MORE to be called again, else an error; what is left of
 *                                    units can be handed to the next call
 *     nook_X(...)                    both in a loop
 * nook_digest() and nook_drop_degenerate() are one plain pass and have only the last form; nook_survey and nook_geometry,
 * which link and check run for you, the searches of walk, nook_reverse, nook_split_fans, nook_reorder, and searches that give one
 * thing after another have only the first two. An edit of one place has one form: it is as long as the fans it
 * touches, to which nook_edit sets a limit.
 * begin copies marks, and views except in walk; all else it is given must stay until the end. Between steps nobody
 * else may write the tables or the marks, and results say nothing before NOOK_OK, but for queries, which hold bounds
 * at any time. A weld or link that is given up leaves the tables half done.
 * Each header says what a unit is and the most instructions it costs. States are at most 256 bytes. Nothing
 * recurses. The worst stack, helpers of the compiler included, is about 960 bytes on Cortex-M0 (930 on M4F) for nook_simplify, 820 for
 * one-call queries, nook_orient_shells, nook_levels and other edits that move a point, 740 for a step of nook_closest, 690 for those
 * of other queries and for one-call nook_check and nook_smooth, 600 for one-call nook_orient and nook_hull, 530 for normals, 510 for
 * a step of nook_smooth, 500 for one-call nook_link, 460 for a step of check and for the STL and number parsers, 440 for a step of
 * geometry, 410 and less for all others; and with a nook_guard 1,250 for an edit, 1,410 for nook_fill and 1,370 for nook_simplify.
 * `make stack` prints it function by function.
 *
 * Numbers. float32 only; the same bits on every core (build with -ffp-contract=off and without
 * -ffast-math). Coordinates are in any unit, finite, at most 2^30. Whatever is a yes or no (which side, how
 * many concave edges, convex or not, which way is out) is exact, as if computed with real numbers.
 *
 *     static NOOK_MESH_ARRAYS(1500, 500) link3;           500 triangles, as STL gives them
 *     static uint8_t Mt[NOOK_MT_BYTES(500)], Mv[NOOK_MV_BYTES(1500)];
 *
 * README.md has a whole example. */
#ifndef NOOK_H
#define NOOK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* core: the words */
#include "core/nook_config.h" /* settings, versions, index width */
#include "core/nook_status.h" /* every status and where it is */
#include "core/nook_mesh.h"   /* the tables, view and mesh, digest */
#include "core/nook_corner.h" /* t v n p o l r s b g, nvat, ntav */
#include "core/nook_marks.h"  /* Mt and Mv */
#include "core/nook_vector.h" /* vectors, square root */

/* exact: signs that rounding cannot turn */
#include "exact/nook_exact.h" /* which side, which is longer, how much volume */

/* ingest: from bytes to triangles */
#include "ingest/nook_number.h" /* decimal text to float */
#include "ingest/nook_stl.h"    /* STL in chunks */

/* table: from triangles to a checked mesh */
#include "table/nook_weld.h"     /* equal vertices become one */
#include "table/nook_link.h"     /* O and C from V */
#include "table/nook_survey.h"   /* components, fans, loops */
#include "table/nook_geometry.h" /* box, area, volume, mass, edges, convexity */
#include "table/nook_check.h"    /* sound or not, and where */

/* walk: around vertices, along borders, across edges */
#include "walk/nook_star.h"         /* the triangles around a vertex */
#include "walk/nook_border.h"       /* along the loops of a border */
#include "walk/nook_relation.h"     /* VV VE VF EV EE EF FV FE FF */
#include "walk/nook_halfedge.h"     /* half-edges, MeshLib, quad-edge */
#include "walk/nook_flood.h"        /* searches, distances, components */
#include "walk/nook_neighborhood.h" /* k-rings by stars */
#include "walk/nook_trees.h"        /* spanning trees, loops of handles */
#include "walk/nook_normals.h"      /* normals of vertices, creases */

/* query: what is where on a mesh */
#include "query/nook_bvh.h"           /* a tree of boxes over it */
#include "query/nook_overlap.h"       /* which triangles are about a place */
#include "query/nook_ray.h"           /* what a ray hits */
#include "query/nook_closest.h"       /* how far a point or a capsule is */
#include "query/nook_inside.h"        /* inside or not; winding number */
#include "query/nook_pair.h"          /* whether two triangles meet */
#include "query/nook_intersections.h" /* whether it cuts itself; T-junctions */

/* edit: change a linked mesh, a place at a time */
#include "edit/nook_edit.h"  /* what edits respect and take along */
#include "edit/nook_guard.h" /* a tree that refuses what would cut the mesh */
#include "edit/nook_local.h" /* flip, splits, collapse, merge */
#include "edit/nook_sew.h"   /* at the border: make, remove, stitch, cut */
#include "edit/nook_fill.h"  /* fill a hole: fan, centroid, ears */
#include "edit/nook_whole.h" /* reverse a shell, split vertices, reorder triangles */

/* shape: change a mesh as a whole, by edits */
#include "shape/nook_hull.h"     /* convex hull of points */
#include "shape/nook_orient.h"   /* triangles that agree, solids that face outward */
#include "shape/nook_smooth.h"   /* noise away, Laplace or Taubin */
#include "shape/nook_levels.h"   /* coarser and finer, to the last bit */
#include "shape/nook_simplify.h" /* fewer triangles */

#ifdef __cplusplus
}
#endif

/* INDEX OF TERMS (the seeds' words, and where they stand)
 *
 * adjacent triangles          nook_opposite, nook_ntav
 * area                        nook_geometry.area
 * attributes, colors          nook_edit.attributes, nook_edit.color
 * barycentric coordinates     nook_barycentric
 * border, border edge         nook_is_border; NOOK_BORDER_EDGE
 * bounding volume hierarchy   nook_bvh; that follows edits: nook_guard.bvh
 * bow-tie                     NOOK_NONMANIFOLD_VERTEX
 * box, what is in one         nook_overlap
 * breadth-first, rings        nook_rings (distance across edges)
 * bridge                      out of scope: a modeling tool; make triangles between the loops with nook_make_triangle
 * capsule, sphere             nook_closest with a radius
 * cavity                      nook_shell.cavity, by nook_orient_shells
 * centroid                    nook_geometry.centroid
 * clean                       nook_check_result.clean
 * closest point               nook_closest
 * component                   nook_survey.components, nook_shells; tags: nook_components, nook_flood
 * concave edge                nook_geometry.concave_edges
 * consistent                  no self-intersection: nook_intersections
 * containment, inside         nook_inside, nook_side_of
 * convex edge                 nook_geometry.convex_edges
 * convex hull                 nook_hull
 * convex mesh                 nook_geometry.convex, with a witness if not
 * corner, corner table        nook_view: V, O
 * crease, hard edge           nook_creases
 * cut, cut open               nook_cut (an edge that reaches the border); nook_split_vertex
 * decimation                  nook_simplify
 * delete vertex               nook_remove_vertex
 * depth-first search, Visit   nook_flood
 * dual graph                  its links are nook_opposite
 * duplicate                   NOOK_DUPLICATE_TRIANGLE
 * edge                        nook_edge (its canonical corner)
 * edge collapse               nook_collapse
 * edge merge                  nook_merge_edges
 * edge split, edge swap       nook_split_edge, nook_flip
 * edge-connected              nook_survey
 * edge-manifold               nook_check_result.edge_manifold
 * eLnext, eLprev              nook_next_halfedge, nook_prev_halfedge
 * eOnext ... eRprev           nook_onext, nook_oprev, nook_dnext, nook_dprev, nook_rnext, nook_rprev
 * eSym, pair                  nook_pair
 * Euler number                nook_check_result.euler
 * Euler operators             nook_sew.h lists them: MVS, MEV, MEF, KHMF
 * Euler-Poincare formula      nook_check_result.handles
 * even                        nook_check_result.even (the seed's weaker "watertight")
 * fan                         nook_survey.fans
 * fill a hole                 nook_fill: fan, centroid, ears
 * flat edge                   nook_geometry.flat_edges
 * folded edge                 NOOK_FOLDED_EDGE
 * genus, handles              nook_shell_genus; of all shells: nook_check_result.handles; their loops: nook_loop
 * half-edge                   nook_halfedge
 * hole, border loop           nook_border_next, nook_border_length; counted: nook_survey.border_loops
 * incidence table             nook_view.V
 * indexed structure           nook_view.G, nook_view.V; with adjacencies: O, C
 * inertia                     nook_geometry.inertia
 * inside out, outward         NOOK_INSIDE_OUT; nook_geometry.inside_out_shells; with cavities: nook_orient_shells
 * intersection of triangles   nook_triangles_meet, nook_triangles_intersect
 * invisible                   color 0: nook_edit.color
 * isolated vertex (hair)      NOOK_ISOLATED_VERTEX
 * k-ring                      nook_neighborhood
 * KHMF                        nook_make_triangle on three border edges, nook_fill
 * l, left                     nook_left
 * label vertices              nook_flood_new_vertices
 * left, right face            nook_left_face, nook_right_face
 * level of detail             nook_levels; discrete: nook_simplify to several counts
 * lone edge                   !nook_is_halfedge
 * manifold                    nook_check_result.manifold
 * marks Mt, Mv                nook_marks
 * mask                        nook_marks
 * MEF                         nook_make_triangle on two border edges; nook_split_edge
 * merge border edges          nook_stitch
 * MEV                         nook_make_triangle with a vertex of nook_make_vertex; nook_split_vertex
 * MVS                         nook_make_vertex
 * n, next                     nook_next
 * next, prev (half-edge)      nook_next_halfedge, nook_prev_halfedge; of MeshLib: nook_onext, nook_oprev
 * nested shells               nook_orient_shells
 * non-conforming adjacency    nook_t_junctions
 * normal                      nook_normal; nook_vertex_normal; which way it points: nook_facing, nook_compare_normals
 * ntav, nvat                  nook_ntav, nook_nvat
 * o, opposite                 nook_opposite; computed by nook_link
 * one-ring                    NOOK_VV, NOOK_VF
 * orient                      nook_orient: triangles of a surface alike; nook_orient_shells: solids and cavities outward
 * orient2d, orient3d          nook_orient2d, nook_orient3d
 * orientable                  nook_survey.orientable
 * oriented                    nook_check_result.oriented
 * origin ring                 nook_onext from nook_halfedge_of_vertex
 * origin, target; org, dest   nook_origin, nook_target
 * p, previous                 nook_prev
 * progressive mesh            nook_levels; its vertex splits, nook_vertex_split
 * r, right                    nook_right
 * ray                         nook_ray
 * reorder triangles           nook_reorder
 * reverse                     nook_reverse
 * s, swing                    nook_swing; nook_turn stops at borders
 * self-intersection           nook_intersections; that an edit would make: nook_edit.guard
 * shell                       nook_shell
 * sibling                     nook_pair
 * signed distance             nook_signed_distance
 * simple mesh                 nook_check_result.simple
 * simplify                    nook_simplify; for collision: nook_simplify_goal.outside
 * smooth a shell              nook_smooth
 * soup                        nook_mesh_append, nook_weld
 * spanning tree (TST, VST)    nook_trees
 * split non-manifold vertices nook_split_fans
 * star of a vertex            nook_star
 * star of an edge             NOOK_EF
 * stitch                      nook_stitch
 * strips                      out of scope: an order for graphics hardware
 * subdivision                 out of scope: it makes meshes finer for looks; nook_split_edge and nook_flip are its steps
 * t, triangle                 nook_triangle
 * Taubin smoothing            nook_smooth
 * T-junction                  nook_t_junctions
 * T-mesh                      nook_check_result.manifold, watertight, oriented
 * T-patch                     nook_check_result.patch
 * trace                       nook_border_next
 * triangle flip (turn over)   NOOK_TURNED_TRIANGLE: nook_edit.no_turn
 * triangle split              nook_split_triangle
 * v, vertex                   nook_vertex
 * valence                     nook_valence
 * valid vertex                nook_corner_of is not NOOK_NONE
 * vertex split                nook_split_vertex
 * volume                      nook_geometry.signed_volume; exact: nook_volume
 * VV VE VF EV EE EF FV FE FF  nook_related
 * watertight                  nook_check_result.watertight
 * winding number              nook_winding; an integer: nook_inside.winding
 * winged edge                 NOOK_EV, NOOK_EF, NOOK_EE; its walk: NOOK_VE
 * zero-area triangle          NOOK_ZERO_AREA_TRIANGLE
 */

#endif
