/* nook_exact.h -- which side, which is longer, how much volume: exact for every finite float.
 *
 * A float determinant of nearly coplanar points has a random sign, and real meshes are full of
 * coplanar neighbours. Here the sign is that of the real number, whatever the exponents (1e-33
 * beside 1, subnormals, 3e38); so it is the same on every core, and f(a,b) never contradicts f(b,a).
 * Three stages, each only if the one before could not decide:
 *   float     with a bound on its error (Shewchuk 1997), only where the core has an FPU
 *   integers  each coordinate of the query on its own common exponent in 32 bits, the determinant
 *             in 96; decides nine queries of ten that the filter leaves, exact zeros included
 *   sum       the determinant as a sum of products of three floats, added up in one fixed-point number
 *             that spans all exponents (Kulisch)
 * NaN and infinities must not come in (nook_check finds them); they give some sign, never a bad access.
 * Loops: at most 24 products, each at most 27 words. `make stack` and tests/costs.txt have stack and instructions. */
#ifndef NOOK_EXACT_H
#define NOOK_EXACT_H

#include "core/nook_vector.h"

/* The side of the plane of a, b, c on which d lies, as a sign: +1 where a b c run counter-clockwise seen
 * from d (d is outside, where the normal points), -1 on the other side, 0 if the four are coplanar.
 * This is the sign of (b-a) x (c-a) . (d-a), as of CGAL's orientation(); Shewchuk's orient3d has the opposite. */
int nook_orient3d(const nook_point *a, const nook_point *b, const nook_point *c, const nook_point *d);

/* The turn a -> b -> c seen against axis 0, 1, 2 (x, y, z; the coordinate that is dropped): +1 counter-
 * clockwise, -1 clockwise, 0 if the three lie on a line there. This is the sign of that component of
 * the normal (b-a) x (c-a). */
int nook_orient2d(const nook_point *a, const nook_point *b, const nook_point *c, uint32_t axis);

/* The same two with a direction in place of the last point, which need not be a point that a float can reach:
 * passing, how a line from o along d passes the edge a b: +1 where a to b runs counter-clockwise about the line for
 *     one whom d points at, -1 where clockwise, 0 if both lie in one plane: the sign of (a-o) x (b-o) . d;
 * turning, the sign of component axis of (b-a) x d. */
int nook_passing(const nook_point *o, const nook_point *d, const nook_point *a, const nook_point *b);
int nook_turning(const nook_point *a, const nook_point *b, const nook_point *d, uint32_t axis);

/* The value of which nook_orient3d gives the sign, or with direction nook_passing(p[0], p[3], p[1], p[2]): the number returned,
 * correctly rounded, times 2^exponent. As slow as the last stage. */
float nook_determinant(const nook_point *const p[4], bool direction, int32_t *exponent);

/* The first axis along which the triangle a, b, c is seen with an area, in *axis, and orient2d there;
 * 0, and any axis, if the three lie on a line: a triangle without area. */
int nook_facing(const nook_point *a, const nook_point *b, const nook_point *c, uint32_t *axis);

/* +1 if a is farther from b than c from d, -1 if nearer, 0 if both distances are equal. */
int nook_compare_distances(const nook_point *a, const nook_point *b, const nook_point *c,
                           const nook_point *d);

/* Whether two flat pieces face the same way: the sign of the dot product of their normals. A piece is four points, its
 * normal (p2 - p0) x (p3 - p1), twice its vector area; for a triangle give the last point twice. +1 less than a right
 * angle apart, -1 more, 0 exactly that, or a piece without area. Floats are tried first on every core. */
int nook_compare_normals(const nook_point *const p[4], const nook_point *const q[4]);

/* ---- the first stage, for loops that have something cheaper to try than the others ---- */

#define NOOK_UNDECIDED 2

/* A sign, if the value is beyond its error: that of rounding, relative to what was added up, and that of
 * products below the smallest normal float, which scale carries along. Else NOOK_UNDECIDED. NaN decides nothing. */
static inline int nook_decided(float value, float relative, float magnitude, float scale) {
    float error = relative * magnitude + 7.52316385e-37f /* 2^-120 */ * (scale + 1.0f);
    if (value > error) return 1;
    return -value > error ? -1 : NOOK_UNDECIDED;
}

static inline float nook_abs(float x) {
#ifdef __GNUC__
    return __builtin_fabsf(x);
#else
    return x < 0 ? -x : x;
#endif
}

/* The sign of b x c . d, each rounded once; always NOOK_UNDECIDED without an FPU. */
static inline int nook_triple_sign(nook_point b, nook_point c, nook_point d) {
#if NOOK_HAS_FPU
    float bc = b.x * c.y, cb = c.x * b.y, cd = c.x * d.y, dc = d.x * c.y, db = d.x * b.y, bd = b.x * d.y;
    float zb = nook_abs(b.z), zc = nook_abs(c.z), zd = nook_abs(d.z);
    float most = (nook_abs(bc) + nook_abs(cb)) * zd + (nook_abs(cd) + nook_abs(dc)) * zb +
                 (nook_abs(db) + nook_abs(bd)) * zc;
    return nook_decided((bc - cb) * d.z + (cd - dc) * b.z + (db - bd) * c.z, 4.76837158e-7f /* 2^-21 */, most,
                        zb + zc + zd);
#else
    (void)b, (void)c, (void)d;
    return NOOK_UNDECIDED;
#endif
}

static inline int nook_orient3d_fast(const nook_point *a, const nook_point *b, const nook_point *c,
                                     const nook_point *d) {
    return nook_triple_sign(nook_sub(*b, *a), nook_sub(*c, *a), nook_sub(*d, *a));
}

/* The volume enclosed by triangles: six times the sum of the tetrahedra over them from the origin, exact,
 * so the order of the triangles does not matter. For coordinates up to 2^30 and up to 2^32 triangles. */
#define NOOK_VOLUME_WORDS 18u
typedef struct nook_volume {
    uint32_t word[NOOK_VOLUME_WORDS];
} nook_volume;

void nook_volume_clear(nook_volume *volume);
void nook_volume_add(nook_volume *volume, const nook_point *a, const nook_point *b, const nook_point *c);
void nook_volume_merge(nook_volume *volume, const nook_volume *other);
int nook_volume_sign(const nook_volume *volume);
/* The volume itself, a sixth of the sum, as the nearest float (below 2^-126 within one unit). */
float nook_volume_value(const nook_volume *volume);

#endif
