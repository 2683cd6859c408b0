/* nook_ray.h -- what does this ray hit?
 *
 * Whether a ray meets a triangle is decided exactly: by the sides of the ray on which its edges pass, and of the
 * triangle on which the origin lies (nook_exact.h). So a ray through an edge or vertex of a closed mesh never slips
 * through, whatever the scale and however thin the triangles. Where on the ray is computed in floats.
 * A triangle is met on its border too, and from both sides, and if it has no area; where it lies along the ray it is met at
 * its first edge.
 *
 *     nook_ray ray;
 *     nook_ray_begin(&ray, &bvh, eye, toward, NOOK_MAX_T, NOOK_NEAREST);
 *     units = 200;
 *     if (nook_ray_step(&ray, &units) == NOOK_OK && ray.triangle != NOOK_NONE) ... ray.t ...
 * At any time, out of units or not: nothing is met before t_min, and ray.triangle, if any, is met at ray.t. */
#ifndef NOOK_RAY_H
#define NOOK_RAY_H

#include "query/nook_descent.h"

typedef enum nook_ray_kind {
    NOOK_NEAREST,  /* the first hit; of several at the same t the triangle of the lowest number */
    NOOK_ANY,      /* whether anything is hit: the first that is found */
    NOOK_CROSSINGS /* how often the surface is crossed, every edge and vertex counted for one of its triangles:
                    * as if the ray stood a trifle aside, the same for all triangles. No hit is named */
} nook_ray_kind;

typedef struct nook_ray {
    /* What is known so far. */
    uint32_t triangle;  /* that is hit, or NOOK_NONE */
    float t;            /* there: origin + t direction; without a hit, t_max */
    float t_min;        /* nothing is hit before; t when all is known */
    uint32_t crossings; /* NOOK_CROSSINGS: triangles crossed at 0 <= t */
    int32_t winding;    /* and those left (+1: outward) less those entered (-1): around the origin */

    const nook_bvh *bvh;
    nook_ray_kind kind;
    uint32_t axis; /* of the largest component */
    nook_point origin, direction;
    float unit;                    /* times which the largest component is between 1 and 2 */
    float best, reach;             /* the first hit along toward, and how far to look */
    nook_point inverse, near, far; /* in cells of the grid */
    nook_descent descent;
} nook_ray;

/* Any t: as far as floats go. */
#define NOOK_MAX_T 0x1p126f

/* Ask. direction need not be of length 1; t is in units of it. Hits beyond t_max are not reported (by floats). A finite
 * origin up to 2^30, any finite direction but 0.
 *   NOOK_NULL_ARGUMENT, NOOK_EMPTY_MESH (nothing was built), NOOK_NOT_FINITE (origin, direction, or a direction of 0), NOOK_COORDINATE_TOO_LARGE */
nook_status nook_ray_begin(nook_ray *ray, const nook_bvh *bvh, nook_point origin, nook_point direction,
                           float t_max, nook_ray_kind kind);
/* NOOK_OK: all is known. NOOK_MORE: out of units. NOOK_INDEX_OUT_OF_RANGE: V or order names nothing (a table
 * that was spoiled after the build).
 * Steps: 1 a node of the tree that is looked at, a group or a leaf; some log4(nt) + 5 on most meshes, at most nt / 3 + 10. One unit is at most
 * 1,900 instructions on M4F, 28,000 on M0, where floats and integers decide; 100,000 if all four triangles of a leaf need the exact
 * sums, which random data can ask for and meshes do not. */
nook_status nook_ray_step(nook_ray *ray, uint32_t *units);
/* Ask and wait. */
nook_status nook_ray_cast(nook_ray *ray, const nook_bvh *bvh, nook_point origin, nook_point direction,
                          float t_max, nook_ray_kind kind);

/* The normal, of length 1, of the triangle that was hit; 0 if none, or if it has no area in floats. */
nook_point nook_ray_normal(const nook_ray *ray);
/* Where it was hit, in barycentric coordinates of corners 3 t, 3 t + 1, 3 t + 2, none negative, of sum 1; a third each without
 * area, 0 without a hit. */
void nook_ray_weights(const nook_ray *ray, float w[3]);

#endif
