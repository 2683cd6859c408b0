/* big.h -- the oracle of exact predicates: the definitions computed in big integers, and cases that are
 * hard for floats. Nothing here is shared with src/core/nook_exact.c, neither code nor method: differences
 * first, then cofactors, in sign and magnitude. */
#ifndef BIG_H
#define BIG_H

#include "check.h"
#include "nook.h"

int big_orient3d(const nook_point p[4]);
int big_orient2d(const nook_point p[3], uint32_t axis);
/* The sign of the determinant of p1 - p0, p3 - p2 and p5 - p4. */
int big_determinant(const nook_point p[6]);
int big_compare_distances(const nook_point p[4]);
int big_compare_normals(const nook_point p[8]);
/* nook_compare_normals() of two pieces of points 0 to 3, and what it should be: by order, triangles that share an edge, in
 * two turns; triangles that share two points the other way; quadrilaterals. */
int compare_pieces(const nook_point p[4], uint32_t order, int *expected);
/* The sign of the sum of the determinants of n triangles p[0..2], p[3..5] and so on. */
int big_volume_sign(const nook_point *p, uint32_t n);

/* Four points, of one of the kinds below as the dice fall. */
enum {
    CASE_UNIFORM,
    CASE_COPLANAR,    /* a point of the plane of three, rounded, and a last place more or less */
    CASE_ON_TRIANGLE, /* the same without the last place */
    CASE_GRID,        /* small integers */
    CASE_SAME_PLANE,  /* one coordinate equal */
    CASE_CAD,         /* corners of boxes with 1e-17 and 1e-33 for 0 */
    CASE_FAR,         /* tiny, far from the origin */
    CASE_BITS,        /* any finite bits */
    CASE_SUBNORMAL,
    CASE_EXPONENTS, /* a few bits at far apart exponents */
    CASE_COLLINEAR, /* on a line, a last place more or less */
    CASE_EDGES,     /* +-0, +-1, the next to 1, 2^30, the smallest and the largest floats */
    CASE_KINDS
};
uint32_t throw_case(dice *d, nook_point p[4]);

#endif
