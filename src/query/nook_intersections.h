/* nook_intersections.h -- does the mesh cut itself, and do its edges fit?
 *
 *   nook_intersections    pairs of triangles that intersect (nook_triangles_intersect): the mesh is consistent if there are none
 *   nook_t_junctions  vertices within border edges: where one side of a seam has an edge and the other two (non-conforming
 *                     adjacency)
 * Both give what they find one by one: step returns NOOK_TRIANGLE with it in the struct; call again for the next. */
#ifndef NOOK_INTERSECTIONS_H
#define NOOK_INTERSECTIONS_H

#include "query/nook_descent.h"

typedef struct nook_intersections {
    uint32_t t, u;  /* out, with NOOK_TRIANGLE: a pair, t < u */
    uint32_t count; /* out: pairs so far */

    const nook_bvh *bvh;
    uint32_t leaf;
    nook_bound low[3], high[3]; /* its box */
    uint32_t pairs;             /* of it and the leaf that the descent is at, still to be tried */
    nook_descent descent;
} nook_intersections;

/* All pairs of the mesh, each once, in the order of the tree. *bvh must stay until the end.
 *   NOOK_NULL_ARGUMENT, NOOK_EMPTY_MESH (nothing was built)
 * step: NOOK_TRIANGLE, NOOK_MORE, NOOK_OK at the end, NOOK_INDEX_OUT_OF_RANGE (tables spoiled after the build).
 * Steps: 1 a node for each leaf; about 2 to 5 nt on meshes that do not cut themselves much, at most nt^2 / 20 + 3 nt. One unit, two leaves
 * held against each other, is at most 21,000 instructions on M4F and 110,000 on M0 where floats and integers decide. */
nook_status nook_intersections_begin(nook_intersections *found, const nook_bvh *bvh);
nook_status nook_intersections_step(nook_intersections *found, uint32_t *units);

typedef struct nook_t_junctions {
    uint32_t corner,
        vertex; /* out, with NOOK_TRIANGLE: a corner that faces a border edge, and the vertex within that edge */
    uint32_t count; /* out: so far */

    const nook_bvh *bvh;
    uint32_t from, to; /* the ends of the edge */
    float tolerance;
    nook_bound low[3], high[3];
    uint32_t next;
    nook_descent descent;
} nook_t_junctions;

/* All pairs of a border edge (O[c] = c) and a vertex that is no end of it, has a triangle, and lies on it: no farther than
 * tolerance from a point of the edge, and farther than that from both its ends. The float of 2^-22 of the largest coordinate allows for
 * what rounding to float32 does to a point on an edge.
 *   NOOK_NULL_ARGUMENT (O and C are needed too), NOOK_EMPTY_MESH. step as above. */
nook_status nook_t_junctions_begin(nook_t_junctions *junctions, const nook_bvh *bvh, float tolerance);
nook_status nook_t_junctions_step(nook_t_junctions *junctions, uint32_t *units);

#endif
