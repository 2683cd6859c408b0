/* nook_simplify.h -- the same shape with fewer triangles.
 *
 * Edges are collapsed one by one, each to the point where the squares of its distances from the planes of the triangles around it,
 * times their areas, have the least sum (quadrics: Garland and Heckbert 1997; of the triangles as they are, not carried along:
 * Lindstrom and Turk 1998). There is no queue: of a few vertices drawn by lot the edge that seems the best from there goes to a
 * pool of 16, and the best of all goes (multiple choice: Wu and Kobbelt 2002), after a longer search if it costs more than what
 * went before. So nothing is kept for a triangle or a vertex; and as the lots are always the same, so is the mesh, on every
 * machine. The numbers of handles, borders and shells stay, and the way triangles face: each collapse is one of
 * nook_collapse() with no_turn. Borders keep their shape as the surface does, by the areas between.
 *
 *     static nook_simplify_state state;
 *     nook_simplify_goal goal = {.triangles = 500};
 *     status = nook_simplify(&state, &mesh, &goal, NULL);           linked, and by nook_check() manifold and oriented
 *
 * What is beside the mesh is of the mesh as it was: build its tree (nook_bvh) anew, and to check it, link it again.
 * Levels of detail are the same mesh taken to several counts, or with a record (nook_levels.h) any count between, forth and back.
 * What may be asked besides:
 *
 * Deviation, how far the surface has moved at most. A surface comes with a number at each vertex, linear over its triangles,
 * and there is a map of the surface it came from onto it that moves no point farther than the number where it arrives. So no
 * point of either is farther from the other than the largest number (Hausdorff distance, both ways). Before the first
 * collapse all are 0, or as they came from another simplification. A collapse goes on from that map by one of two:
 *   (1) triangles are carried along with the ends of the edge, which moves a point by its share of how far these go;
 *   (2) where old and new triangles lie over the ring around them without a fold, as seen along its vector area, each point
 *       goes along that. The gap is then linear between the edges of old and new, so it is looked at where these cross, and
 *       at the three vertices. Not at borders.
 * Rounding is allowed for. The new vertex gets the smaller number of both that is enough, all others keep theirs.
 * What moves the surface least goes first: a 4096th of the error, or of the extent of the mesh if that is less, is allowed, and
 * twice as much when 64 steps found nothing.
 *
 * Outside: the new vertex is on the inner side of no triangle around either end (progressive hulls: Sander, Gu, Gortler,
 * Hoppe and Snyder 2000), exactly. The new surface less the old one is then the boundary of the tetrahedra between these
 * triangles and the vertex, none of which is inside out, so the winding number becomes smaller nowhere. What a sound mesh
 * had inside, and on it, is inside or on it, or, if the result overlaps itself, inside twice: ask for nook_inside.winding >= 1.
 * For a convex one take nook_hull() of the result. If its hull was what it came from, deviation still holds: no
 * vertex is farther than d from a convex body, so neither is their hull; and who goes outward by d from that body has left it. */
#ifndef NOOK_SIMPLIFY_H
#define NOOK_SIMPLIFY_H

#include "edit/nook_edit.h"
#include "shape/nook_levels.h"

typedef struct nook_simplify_goal {
    uint32_t triangles; /* stop at so many or less; 0: as few as all else allows */
    float error;        /* with deviation: none may become larger; FLT_MAX: any may be */
    float *deviation;   /* [max_nv] or null; in: usually 0, out: one for each vertex */
    bool outside;       /* for solids, all shells facing out of them; what is at a border stays as it is */
    /* Or null: every collapse is recorded, to be taken back and made again. From nt to triangles there are (nt - triangles) / 2
     * on a closed mesh; with a border some more, as one at the border takes one triangle only. */
    nook_levels *levels;
} nook_simplify_goal;

enum { NOOK_SIMPLIFY_POOL = 16 };

typedef struct nook_simplify_state {
    nook_mesh *mesh;
    const nook_edit *edit;
    const nook_simplify_goal *goal;
    nook_status refused;  /* why the last edge that was refused was, */
    nook_where where;     /* and its corner; or the vertex of an error */
    uint32_t phase, at;   /* of a pass: the vertex or corner to come */
    uint32_t fresh, idle; /* since the last collapse: vertices drawn; steps */
    uint32_t dice, pooled;
    float extent;      /* of the mesh, the larger of a coordinate */
    float allowed;     /* deviation, for now */
    float usual;       /* cost: a fifth of those that went, or so, cost more */
    float scale, unit; /* powers of two: the extent, scaled, is near 1024; and back */
    struct {
        float cost;
        uint32_t c;
    } pool[NOOK_SIMPLIFY_POOL]; /* the worst first. Edges may have changed since, or be none */
} nook_simplify_state;

/* Simplify a linked manifold mesh, and all that edit takes along with it.
 *   edit  max_valence is respected; no_turn is always asked; with a guard, what does not cut itself does not come to. A guard
 *         grows slow as triangles go: go by parts of a fortieth, and before each build its tree, reorder, refit. Or null
 *   goal  must stay until the end
 *   NOOK_OK              done: goal->triangles are reached, or that is 0 and nothing more can go
 *   NOOK_NULL_ARGUMENT   state, mesh, goal
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE  state->where: the vertex. Nothing was changed
 * else goal->triangles cannot be reached: all edges were tried, and this is why the last was refused, with state->where:
 *   NOOK_DUPLICATE_EDGE, NOOK_NONMANIFOLD_VERTEX, NOOK_DUPLICATE_TRIANGLE, NOOK_LAST_TRIANGLE  as of nook_collapse()
 *   NOOK_TURNED_TRIANGLE     a triangle would turn over
 *   NOOK_SELF_INTERSECTION   edit->guard
 *   NOOK_TOO_MANY_TRIANGLES  edit->max_valence, or more than some 40 triangles around the edge, which is never collapsed
 *   NOOK_NO_PLACE            the deviation would be too large, or no point outside was found
 *   NOOK_NO_CAPACITY         the record is full
 *   NOOK_BAD_OPPOSITE, NOOK_INDEX_OUT_OF_RANGE  the tables do not hold
 * An inner edge takes two triangles with it, one at a border one: what is reached is goal->triangles, or one less.
 * Steps: nv, and then about 4 for each collapse of a smooth mesh; up to 28 where edges cost more than those before, and, with
 * deviation, 65 more for each time that more is allowed; between two collapses never more than 11 nt + 1,000. A step is one vertex
 * or edge looked at, at most one edge collapsed: at most 5,000 instructions on M4F and 120,000 on M0 on meshes as they are, 17,000
 * and 600,000 with deviation, 82,000 and 3,400,000 outside. With all the corners around an edge that there may be, 21,000 and
 * 400,000, with deviation 75,000 and 2,300,000, and outside 112,000 and 5,300,000, where floats decide. */
nook_status nook_simplify_begin(nook_simplify_state *state, nook_mesh *mesh, const nook_simplify_goal *goal,
                                const nook_edit *edit);
nook_status nook_simplify_step(nook_simplify_state *state, uint32_t *units);
/* Both in a loop; the state is the caller's, as it is too large for most stacks. */
nook_status nook_simplify(nook_simplify_state *state, nook_mesh *mesh, const nook_simplify_goal *goal,
                          const nook_edit *edit);

#endif
