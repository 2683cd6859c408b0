/* nook_normals.h -- the normal of a vertex, and of corners between creases.
 *
 * The normal of a triangle is nook_normal(). That of a vertex is the mean of those of its triangles, each weighing as much as
 *   NOOK_BY_AREA   its area: cheap; but how a face is cut into triangles shows
 *   NOOK_BY_ANGLE  its angle at the vertex (Thuermer, Wuethrich 1998): it does not
 * A crease is an edge at which the surface turns by more than a given angle. Each corner has the mean over those triangles of
 * its fan that are reached without crossing a crease: so smooth parts look smooth and hard edges stay hard.
 * Corners turn within one fan; at a vertex of several each has its own.
 *
 * A triangle without area (in floats), or of which a corner has no vertex, has no weight; with a cosine
 * above 0 its edges are creases. A mean that is less than a 65536th of what was added up, as where a fan lies back upon
 * itself, is noise of rounding and is none; by area, so is one of triangles whose edges are below 1e-20. The last bits
 * depend on the corner the sum begins with. Any bits in G, V and O do no harm, and a normal is never NaN. */
#ifndef NOOK_NORMALS_H
#define NOOK_NORMALS_H

#include "core/nook_vector.h"
#include "walk/nook_star.h"

typedef enum nook_weight { NOOK_BY_AREA, NOOK_BY_ANGLE } nook_weight;

/* The normal of v(c), of length 1, over the fan of corner c.
 *   NOOK_INDEX_OUT_OF_RANGE  c is no corner
 *   NOOK_BAD_OPPOSITE        as for a star
 *   NOOK_ZERO_AREA_TRIANGLE  there is none: no triangle of the fan has an area, or they cancel out
 * *normal is 0 unless the status is NOOK_OK. Steps: twice round the fan; for each triangle 400 instructions by area and 600 by angle
 * on M4F, 6,000 and 12,000 on M0. */
nook_status nook_vertex_normal(const nook_view *view, uint32_t c, nook_weight weight, nook_point *normal);

typedef struct nook_creases {
    const nook_view *view;
    nook_weight weight;
    float cosine;
    float *to;
    uint32_t width;
    uint32_t without; /* out: corners without a normal */
    uint32_t at;
} nook_creases;

/* The normals of all corners, as attributes beside the mesh.
 *   cosine  of the angle by which the surface turns at a crease: 0.866 for 30 degrees. Above 1 all edges are creases and below
 *           -1 none is
 *   to      [3 nt] times width floats out, of which the first three of each corner are written: edit->attributes and edit->width,
 *           or from any place in the first on, if normals are to stand there. 0 where there is none
 *   NOOK_NULL_ARGUMENT, NOOK_NO_CAPACITY (width below 3)
 * step returns NOOK_BAD_OPPOSITE as for a star; what is written then is of no use.
 * Steps: 6 nt. One may be three times round a part of a fan: at most 1,400 instructions for each of its triangles on M4F, and
 * 30,000 on M0. */
nook_status nook_creases_begin(nook_creases *creases, const nook_view *view, nook_weight weight, float cosine,
                               float *to, uint32_t width);
nook_status nook_creases_step(nook_creases *creases, uint32_t *units);

#endif
