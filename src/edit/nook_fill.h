/* nook_fill.h -- fill the hole that a border loop goes round.
 *
 * Three ways:
 *   NOOK_FILL_FAN       a fan of L - 2 triangles from the vertex where border edge c begins ("Trace the border of a hole and
 *                       make a triangle fan to fill it")
 *   NOOK_FILL_CENTROID  a fan of L triangles from a new vertex at the mean of the loop's vertices
 *   NOOK_FILL_EARS      L - 2 triangles, cut off the loop one by one: always the best one, by area over the sum of the squares
 *                       of its edges, and of those that are convex and empty as seen along the axis which the loop
 *                       mostly faces, if there are any
 * The new triangles are planned in the unused ends of V and O (and of colors and attributes), and joined to the mesh when all is known; so until then
 * nothing happens to the mesh, and it can be given up. While step says NOOK_MORE nobody else may write the mesh.
 * Which axis that is, and from which side, is exact for loops of three edges; for longer ones it is read off their vector
 * area in floats (the first axis if that is nothing), and all that follows from it is exact. Where edges of the loop's
 * vertices stand in the way, ears may find no filling though there is one.
 * Where edit->no_turn is set, every new triangle must face the loop's way on that axis. A triangle takes its color from
 * the one at c, its corners attributes of their vertices, a centroid the mean.
 *   NOOK_INDEX_OUT_OF_RANGE  c is no corner
 *   NOOK_INTERIOR_EDGE       c faces no border
 *   NOOK_NO_CAPACITY         no room for the triangles or the vertex
 *   NOOK_DUPLICATE_EDGE      two vertices of the loop that are to be joined are joined already; or the loop has only two
 *                            edges, which nook_stitch() makes one
 *   NOOK_DUPLICATE_TRIANGLE  it would be the back of a lone triangle
 *   NOOK_TURNED_TRIANGLE, NOOK_TOO_MANY_TRIANGLES  if edit asks for it
 *   NOOK_BAD_OPPOSITE        the tables do not hold
 * Steps: for a loop of L edges less than 10 L; with ears up to L (L - 1) more for looking at each ear once at every size of the
 * loop, and L for each that is tried for emptiness: L^2 to L^3 / 2; with a limit on valence (3 L)^2 more. A step is at most the
 * triangles at one vertex. */
#ifndef NOOK_FILL_H
#define NOOK_FILL_H

#include "edit/nook_edit.h"

typedef enum nook_fill_way { NOOK_FILL_FAN, NOOK_FILL_CENTROID, NOOK_FILL_EARS } nook_fill_way;

typedef struct nook_fill {
    nook_mesh *mesh;
    const nook_edit *edit;
    nook_fill_way way;
    nook_point centroid, normal;
    uint32_t axis;           /* which the loop mostly faces, */
    int side;                /* and from where */
    uint32_t c, x;           /* the loop's first corner, and one on the way */
    uint32_t length, made;   /* edges of the loop; triangles planned */
    uint32_t ear, at, other; /* an ear that is looked at, and loop entries */
    uint32_t best;           /* the best ear so far, or NOOK_NONE, */
    float quality, most;     /* and what it is worth; and of the ear that is looked at */
    nook_status refusal;     /* why no ear was taken */
    uint32_t phase;
} nook_fill;

/* Fill the hole at border edge c; edit (may be null) must stay until the end. */
nook_status nook_fill_begin(nook_fill *fill, nook_mesh *mesh, uint32_t c, nook_fill_way way,
                            const nook_edit *edit);
nook_status nook_fill_step(nook_fill *fill, uint32_t *units);
nook_status nook_fill_hole(nook_mesh *mesh, uint32_t c, nook_fill_way way, const nook_edit *edit);

#endif
