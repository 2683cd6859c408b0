/* nook_simplify.h -- the same shape with fewer triangles.
 *
 * Edges are collapsed one by one, each to the point where the squares of the volumes between it and the triangles around it
 * have the least sum (memoryless quadrics: Lindstrom and Turk 1998; Garland and Heckbert 1997 carry theirs along). There is
 * no queue: a few edges drawn by lot are held against a pool of 16, and the best of all goes (multiple choice: Wu and
 * Kobbelt 2002). So nothing is kept for a triangle or a vertex, and no seed is taken: every machine gives the same mesh.
 * How many handles, borders and shells there are stays, and which way triangles face: each collapse is one of nook_collapse()
 * with no_turn. Borders keep their shape as the surface does, by the areas that they would sweep.
 *
 * What may be asked besides
 *   deviation  [max_nv]: how far the surface has moved at most, exactly enough to rely on: see below
 *   outside    nothing that was inside comes to be outside, as a hull for collision must not
 *   convex     outside, and convex as it was: a hull of fewer triangles
 *
 * Deviation. A surface comes with a number at each vertex, linear over its triangles, and there is a map of the surface it came
 * from onto it that moves no point farther than the number where it arrives. So neither is anywhere farther from the other
 * (Hausdorff distance) than the largest number, in both directions; before the first collapse all are 0, or as they came from
 * another simplification. A collapse follows that map by one of two: (1) the triangles of both ends are carried along with
 * their vertices, which moves a point by no more than its share of how far the ends go; or (2), where old and new triangles
 * both lie over the ring around them without a fold, seen along its vector area, each point goes straight along that. There
 * the gap is linear between edges of the old and the new, so it need be looked at only where these meet, and at the three
 * vertices. Rounding is added. The smaller of both becomes the number of the new vertex, all others stay.
 *
 * Outside. The new vertex lies on no triangle's inner side, of those around either end (progressive hulls: Sander, Gu, Gortler,
 * Hoppe and Snyder 2000). New surface less old is then the boundary of the tetrahedra from them to it, none of which is inside
 * out: the winding number grows nowhere smaller. A point that a sound mesh has inside is inside, or where the result overlaps itself, inside
 * twice: ask for nook_inside.winding >= 1. Signs are exact. Convex: nor does it lie outside any of the triangles across the ring; the
 * hull of all and the new vertex is then the new mesh. */
#ifndef NOOK_SIMPLIFY_H
#define NOOK_SIMPLIFY_H

#include "edit/nook_edit.h"

typedef struct nook_simplify_goal {
    uint32_t triangles; /* stop at so many or less; 0: as few as all else allows */
    float error;        /* with deviation: none may become larger */
    float *deviation;   /* [max_nv] or null; in: usually 0, out: one for each vertex */
    bool outside;       /* for closed, oriented meshes; what is at a border stays as it is */
    bool convex;        /* with outside, for convex ones */
} nook_simplify_goal;

enum { NOOK_SIMPLIFY_POOL = 16 };

typedef struct nook_simplify_state {
    nook_mesh *mesh;
    const nook_edit *edit;
    const nook_simplify_goal *goal;
    nook_status refused;  /* why the last edge that was refused was, */
    nook_where where;     /* and its corner; or the vertex of an error */
    uint32_t phase, at;   /* of a pass: the vertex or corner to come */
    uint32_t fresh, idle; /* edges drawn since the last round; since the last collapse */
    uint32_t dice, pooled;
    float extent;      /* of the mesh, the larger of a coordinate */
    float scale, unit; /* powers of two: the extent, scaled, is near 1024; and back */
    struct {
        float cost;
        uint32_t c;
    } pool[NOOK_SIMPLIFY_POOL]; /* the worst first. Edges may have changed since, or be none */
} nook_simplify_state;

/* Simplify a linked manifold mesh, and all that edit takes along with it.
 *   edit  max_valence is respected; no_turn is always asked. Or null
 *   goal  must stay until the end
 *   NOOK_OK              done: goal->triangles are reached, or that is 0 and nothing more can go
 *   NOOK_NULL_ARGUMENT   mesh, goal
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  state->where: the vertex. Nothing was changed
 * else goal->triangles cannot be reached: all edges were tried, and this is why the last was refused, with state->where:
 *   NOOK_DUPLICATE_EDGE, NOOK_NONMANIFOLD_VERTEX, NOOK_DUPLICATE_TRIANGLE, NOOK_LAST_TRIANGLE  as of nook_collapse()
 *   NOOK_TURNED_TRIANGLE     a triangle would turn over
 *   NOOK_TOO_MANY_TRIANGLES  edit->max_valence, or more than 58 triangles around the edge, which is never collapsed
 *   NOOK_NO_PLACE            the deviation would be too large; outside or convex: no point was found
 *   NOOK_BAD_OPPOSITE, NOOK_INDEX_OUT_OF_RANGE  the tables do not hold
 * An inner edge takes two triangles with it, one at a border one: what is reached is goal->triangles, or one less.
 * Steps: nv, and then about 4 for each collapse; between two collapses never more than 11 nt + 100. A step is one edge looked at, at
 * most one collapsed. */
nook_status nook_simplify_begin(nook_simplify_state *state, nook_mesh *mesh, const nook_simplify_goal *goal,
                                const nook_edit *edit);
nook_status nook_simplify_step(nook_simplify_state *state, uint32_t *units);
/* where may be null. */
nook_status nook_simplify(nook_mesh *mesh, const nook_simplify_goal *goal, const nook_edit *edit,
                          nook_where *where);

#endif
