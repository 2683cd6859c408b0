/* nook_closest.h -- how far is the mesh from a point, a sphere, a capsule?
 *
 * The nearest of the mesh's points to a segment a b; a point is a segment of length 0, a capsule a segment with a
 * radius, a sphere a point with one. distance_min and distance_max hold the distance between them at any time, before
 * the first unit too: rounding is allowed for. So
 *     distance_min >  radius   the body is clear of the surface
 *     distance_max <= radius   they touch
 * and what is asked within a budget is answered as far as that goes. When all is known the two differ by no more than
 * the rounding of a few operations: 2e-6 of the longest of the mesh, the way to it, and the segment; and not at all where a segment goes
 * through the surface, which is told exactly. */
#ifndef NOOK_CLOSEST_H
#define NOOK_CLOSEST_H

#include "query/nook_descent.h"

typedef struct nook_closest {
    /* What is known so far. */
    uint32_t triangle; /* the nearest seen, or NOOK_NONE: none within the limit */
    nook_point point;  /* its nearest point */
    float at;          /* and the nearest of the segment: a + at (b - a), 0 <= at <= 1 */
    float distance;    /* between the two, rounded; the limit while there is no triangle */
    float distance_min,
        distance_max; /* of the mesh from the segment. Without a triangle distance_min is the limit, but for rounding */

    const nook_bvh *bvh;
    nook_point a, b; /* of a point, b may be the way to the nearest seen, of length 1 or less */
    bool is_segment, crosses;
    float enough;
    float scale;          /* a power of two that brings lengths near 1, so that squares stay in range */
    float square, margin; /* of the distance, scaled; what it may be off */
    float reach;          /* how far to look, squared */
    nook_point low, high; /* the segment's box in cells, widened by what rounding may be off */
    nook_point width;     /* of a cell */
    nook_descent descent;
} nook_closest;

#define NOOK_FAR 0x1p33f

/* Ask for the distance of segment a b.
 *   limit   what lies farther is of no interest; NOOK_FAR for none
 *   enough  stop as soon as something is found that is no farther than this; 0 for the nearest
 *   NOOK_NULL_ARGUMENT, NOOK_EMPTY_MESH (nothing was built), NOOK_NOT_FINITE, NOOK_COORDINATE_TOO_LARGE
 * Of triangles whose squared distances are the same float, the one of the lowest number, if enough is 0. */
nook_status nook_closest_begin(nook_closest *closest, const nook_bvh *bvh, nook_point a, nook_point b,
                               float limit, float enough);
/* Statuses as of nook_ray_step. Steps: 1 a node; about 2 log4(nt) + 10, at most nt / 3 + 10. One unit is at most 2,700 instructions on M4F
 * and 86,000 on M0 for a point, 35,000 and 441,000 for a segment. */
nook_status nook_closest_step(nook_closest *closest, uint32_t *units);
nook_status nook_closest_point(nook_closest *closest, const nook_bvh *bvh, nook_point point);

#endif
