/* weights.h -- the oracle of meetings: exact, from one theorem.
 *
 * Two convex hulls meet if and only if 0 is a mean, with weights that are not negative, of the differences
 * of their points; a ray from o along d meets a triangle a b c if and only if 0 is such a mean of a - o, b
 * - o, c - o and -d. By Caratheodory four of the vectors are enough, so all ones, twos, threes and fours
 * are tried; Cramer gives their weights. Nothing here knows of planes, sides or projections, and no case
 * is special. The numbers are integers: floats on a common unit of 2^-40 of the largest (lattice), or of
 * any length (big.h). */
#ifndef WEIGHTS_H
#define WEIGHTS_H

#include "big.h"

typedef struct vector {
    int64_t at[3];
} vector;

/* Signs of what is known of n vectors: coordinates, components of the cross product of two, determinants
 * of three. Those of i < j < k are filled in. */
enum { MOST_VECTORS = 9 };
typedef struct signs {
    uint32_t n;
    int8_t at[MOST_VECTORS][3];
    int8_t cross[MOST_VECTORS][MOST_VECTORS][3];
    int8_t determinant[MOST_VECTORS][MOST_VECTORS][MOST_VECTORS];
} signs;

/* Whether 0 is a mean of the vectors. */
bool zero_is_mean(const signs *s);

/* The sign of the determinant of three vectors, of coordinates below 2^40. */
int sign_of(const vector *a, const vector *b, const vector *c);
vector minus(const vector *a, const vector *b);
bool mean_of_vectors(const vector *d, uint32_t n);
/* Two hulls of m and n points, m n at most MOST_VECTORS. */
bool hulls_meet(const vector *a, uint32_t m, const vector *b, uint32_t n);
bool ray_meets(const vector *origin, const vector *direction, const vector triangle[3]);
/* Whether the triangle lies on a line. */
bool has_no_area(const vector p[3]);

/* The lattice: a unit of 2^place. A point must be on it: on_lattice() says so, to_lattice() brings it
 * there. */
typedef struct lattice {
    int place;
} lattice;
/* For coordinates up to the largest of n points. */
lattice lattice_of(const nook_point *p, uint32_t n);
bool on_lattice(lattice l, nook_point p);
nook_point to_lattice(lattice l, nook_point p);
vector take_point(lattice l, nook_point p);

/* Any floats, in integers of any length: slow. */
bool big_triangles_meet(const nook_point a[3], const nook_point b[3]);
bool big_ray_meets(nook_point origin, nook_point direction, const nook_point triangle[3]);
bool big_point_is_on(nook_point p, const nook_point triangle[3]);

#endif
