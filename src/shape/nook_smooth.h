/* nook_smooth.h -- every vertex goes a part of the way to the middle of its neighbours, all at once.
 *
 * Laplace: a round is one such pass, by lambda. It takes noise away, and volume with it: what is round shrinks.
 * Taubin (1995): a second pass goes back by mu, a little farther than lambda. Noise still dies out, waves as long as many
 * edges stay, and so nearly does the volume; how much is lost or gained is told exactly.
 *
 * The passes are Jacobi's: each vertex sees where its neighbours were, so names and order do not count. Axis by axis, because
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
    bool slide; /* a vertex at the border goes to the middle of its two neighbours there; else it stays */
    bool
        no_turn; /* no triangle may turn by a right angle or more, or lose its area, in the step along an axis: its
                         three vertices keep that coordinate. Exact. In a plane, no triangle ever turns over */
} nook_smoothing;

typedef struct nook_smoothed {
    nook_where where; /* of an error */
    float volume;     /* the signed volume of the mesh as it was, rounded once, */
    float
        gained; /* and by how much it grew, exact and rounded once. With a border that stays, the volume swept */
    uint32_t held; /* triangles that had to be held back, over all passes */
} nook_smoothed;

typedef struct nook_smooth_state {
    nook_view view;
    nook_point *G;
    nook_smoothing how;
    float *next;
    nook_smoothed *result;
    nook_volume volume;
    uint32_t phase, at, axis, round;
    bool back, held; /* the second pass of a round; the sweep has held a triangle back */
} nook_smooth_state;

/* Smooth a linked mesh: G changes, the tables stay.
 *   next[nv]  scratch
 *   NOOK_NULL_ARGUMENT
 *   NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE, NOOK_BAD_VERTEX_CORNER, NOOK_BAD_OPPOSITE, NOOK_INDEX_OUT_OF_RANGE
 *     result->where: the vertex, or the corner. Nothing was changed, unless the tables have changed since
 * All but *how must stay until the end. Given up, the mesh is smoothed along some axes more than along others.
 * Steps: nv + 2 nt + 3, and a pass 6 nv + 6; with no_turn a pass also sweeps over all triangles, along each axis until nothing
 * is held back any more: twice is the rule, nv + 1 times the most, nt + 1 steps each. A step is at most twice round a fan, or
 * a triangle of an exact volume. */
nook_status nook_smooth_begin(nook_smooth_state *state, nook_mesh *mesh, const nook_smoothing *how,
                              float *next, nook_smoothed *result);
nook_status nook_smooth_step(nook_smooth_state *state, uint32_t *units);
nook_status nook_smooth(nook_mesh *mesh, const nook_smoothing *how, float *next, nook_smoothed *result);

#endif
