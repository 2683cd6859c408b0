/* nook_smooth.h -- every vertex goes a part of the way to the middle of its neighbours, all at once.
 *
 * Laplace: a round is one such pass, by lambda. It takes noise away, and volume with it: what is round shrinks.
 * Taubin (1995): a second pass goes back by mu, a little farther than lambda. Noise still dies out, waves as long as many
 * edges stay, and so nearly does the volume; how much is lost or gained is told exactly.
 *
 * The passes are Jacobi's: each vertex sees where its neighbours were, not which of them moved first. Axis by axis, because
 * then one float a vertex is all the memory: the new coordinates along an axis, until all are known.
 * A sum of neighbours begins at the border, or at the smallest corner of the fan, and goes on counter-clockwise: it is G, V and
 * O that decide the result, to the last bit and on every core, whichever corner C names. At a vertex of several fans the
 * one that C names counts (nook_split_fans makes them vertices of their own). A vertex of no triangle stays, and so does a
 * coordinate that would leave the range of coordinates, or become no number by lambda or mu. */
#ifndef NOOK_SMOOTH_H
#define NOOK_SMOOTH_H

#include "exact/nook_exact.h"
#include "walk/nook_star.h"

#define NOOK_TAUBIN_LAMBDA 0.6307f
#define NOOK_TAUBIN_MU (-0.6732f)

typedef struct nook_smoothing {
    uint32_t rounds;
    float lambda, mu; /* mu 0: Laplace, no way back; 0.5 is a good lambda then */
    /* A vertex at the border goes to the middle of its two neighbours there; else it stays. */
    bool slide;
    /* [nv], or null: no triangle may come to face a right angle or more from where it faces at these points, or lose its
     * area; its vertices keep their coordinate along the axis at hand, and what did not go there does not go back. Exact; what
     * is flat never folds. A copy of G as it was before: no triangle turns over. mesh->G itself: none does in a single pass, but
     * wrinkles can be unfolded. */
    const nook_point *reference;
} nook_smoothing;

typedef struct nook_smoothed {
    nook_where where; /* of an error */
    uint32_t held;    /* triangles that had to be held back, over all passes */
    /* The signed volume of the mesh as it was, and by how much it grew: exact, each rounded once. With a border that stays, what
     * it grew by is the volume swept, though there is none before. */
    float volume, gained;
} nook_smoothed;

typedef struct nook_smooth_state {
    nook_view view;
    nook_point *G;
    nook_smoothing how;
    float *next;
    nook_smoothed *result;
    nook_volume volume;
    uint32_t phase, at, axis, round;
    bool back, held; /* the second pass along the axis; the sweep has held a triangle back */
} nook_smooth_state;

/* Smooth a linked mesh: G changes, the tables stay.
 *   next[nv]  scratch
 *   NOOK_NULL_ARGUMENT
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE, NOOK_BAD_VERTEX_CORNER, NOOK_BAD_OPPOSITE, NOOK_INDEX_OUT_OF_RANGE
 *     result->where: the vertex, or the corner. Nothing was changed, unless the tables have changed since
 * All but *how must stay until the end. Given up, the mesh is smoothed along some axes more than along others.
 * Steps: nv + 2 nt + 3, and a pass 6 nv + 6; with a reference a pass also sweeps over all triangles, along each axis until nothing
 * is held back any more: twice is the rule, nv + 1 times the most, nt + 1 steps each. A step is twice round a fan, at most
 * 150 instructions for each of its triangles on M4F and 410 on M0; or a triangle of an exact volume, 1,000 and 2,200; or two
 * nook_compare_normals(), 500 and 10,100 where floats decide. */
nook_status nook_smooth_begin(nook_smooth_state *state, nook_mesh *mesh, const nook_smoothing *how,
                              float *next, nook_smoothed *result);
nook_status nook_smooth_step(nook_smooth_state *state, uint32_t *units);
nook_status nook_smooth(nook_mesh *mesh, const nook_smoothing *how, float *next, nook_smoothed *result);

#endif
