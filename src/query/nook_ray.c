/* nook_ray.c -- down the tree along a ray; exact where it counts. */
#include "query/nook_ray.h"

#include "exact/nook_exact.h"
#include "query/nook_lanes.h"

/* ---- boxes ---------------------------------------------------------------------------------------- */

/* The direction, its largest component between 1 and 2; and t along it is t / unit. */
static inline nook_point toward(const nook_ray *r) { return nook_scaled(r->direction, r->unit); }

/* Along one axis the ray is at cell c at t = (c - origin) inverse. near and far are that origin for the bounds that it comes
 * upon first and last, moved by as much as rounding may be off, and for high ones by the width of a cell, which they leave
 * out. */
static inline void set_axis(nook_ray *r, uint32_t axis) {
    float slack, origin = nook_in_cells(r->bvh, nook_along(&r->origin, axis), axis, &slack);
    float d = nook_along(&r->direction, axis) * r->unit;
    float inverse = 1.0f / (d * nook_along(&r->bvh->cells, axis));
    float side[2] = {origin + slack, origin - 1.0f - slack};
    if (d != 0 && nook_abs(d) < 0x1p-60f) /* so slow that its cells could underflow: never refused */
        inverse = 1.0f, side[0] = 0x1p126f, side[1] = -0x1p126f;
    *nook_axis(&r->inverse, axis) = inverse;
    *nook_axis(&r->near, axis) = side[inverse < 0];
    *nook_axis(&r->far, axis) = side[!(inverse < 0)];
}

/* The part of the ray, from near to far, between the bounds of some children along one axis. */
static inline void cut(const nook_bound *first, const nook_bound *last, nook_lanes inverse, nook_lanes from,
                       nook_lanes to, nook_lanes *near, nook_lanes *far) {
    *near = nook_larger((nook_load(first) - from) * inverse, *near);
    *far = nook_smaller((nook_load(last) - to) * inverse, *far);
}

/* What groups are held against. x, y, z: where, of the 24 bounds of a group, those are that the ray comes upon first; those
 * that it comes upon last are where the others of that axis are. */
typedef struct slabs {
    nook_vectors inverse, near, far;
    uint32_t x, y, z;
} slabs;

static inline void visit_group(nook_ray *r, const slabs *s) {
    const nook_bound *g = nook_descent_boxes(&r->descent, r->bvh)->low[0];
    uint32_t entry[4], bits = 0, i;
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_lanes near = nook_lanes_of(0), far = nook_lanes_of(r->reach);
        cut(g + i + s->x, g + i + (12u - s->x), s->inverse.x, s->near.x, s->far.x, &near, &far);
        cut(g + i + s->y, g + i + (20u - s->y), s->inverse.y, s->near.y, s->far.y, &near, &far);
        cut(g + i + s->z, g + i + (28u - s->z), s->inverse.z, s->near.z, s->far.z, &near, &far);
        bits |= nook_set_entries(entry, i, near <= far, near);
    }
    nook_descent_push(&r->descent, r->bvh->places, bits, entry);
}

/* ---- triangles ------------------------------------------------------------------------------------ */

static bool differ(int a, int b) { return a * b < 0; }

/* What triangles are held against: the ray seen against its axis, the last of three, and how far it moves along the first two
 * while it does by 1 along that. */
typedef struct sight {
    uint32_t axis[3];
    float origin[3], shear[2];
} sight;

static inline sight sight_of(const nook_ray *r) {
    uint32_t w = r->axis, u = nook_after(w), v = nook_after(u);
    nook_point o = r->origin, d = r->direction;
    sight s = {{u, v, w},
               {nook_along(&o, u), nook_along(&o, v), nook_along(&o, w)},
               {nook_along(&d, u) / nook_along(&d, w), nook_along(&d, v) / nook_along(&d, w)}};
    return s;
}

/* The three corners of some triangles along axis i of those, from the origin on. */
NOOK_WIDE nook_vectors seen(const sight *s, const nook_some *some, uint32_t i) {
    float o = s->origin[i];
    return nook_vectors_sub(nook_some_along(some, s->axis[i]), nook_vectors_of(nook_make(o, o, o)));
}

/* How the line passes some triangles: past, where two edges are on different sides by more than rounding can do; through,
 * where all are on its left, or right, seen against the axis. That settles nearly all; the exact signs settle the rest.
 * Where the line is at the height of a corner it is x, y off, which may be off by E = 2^-22 far; so an edge by 5 off E + 2 E^2. */
static inline uint32_t judge(const sight *s, const nook_some *some, uint32_t *left, uint32_t *right) {
    nook_vectors z = seen(s, some, 2),
                 x = nook_vectors_sub(seen(s, some, 0), nook_vectors_scaled(z, s->shear[0])),
                 y = nook_vectors_sub(seen(s, some, 1), nook_vectors_scaled(z, s->shear[1])),
                 edges = nook_vectors_cross(x, y);
    nook_lanes off = nook_larger(nook_largest(x), nook_largest(y)), far = off + nook_largest(z), margin;
    nook_lanes least = nook_least(edges), most = nook_most(edges);
    margin = (off + far * nook_lanes_of(0x1p-21f)) * far * nook_lanes_of(0x1p-18f) + nook_lanes_of(0x1p-120f);
    *left = nook_bits(least > margin);
    *right = nook_bits(most < -margin);
    return nook_bits(nook_not((least < -margin) & (most > margin)));
}

/* Whether the line goes through the triangle or touches it, exactly: it passes all edges on one side, of which turn is the
 * sign. In one plane with it, that is 0. */
static bool meets(const nook_ray *r, const nook_point *const p[3], int *turn) {
    int a = nook_passing(&r->origin, &r->direction, p[0], p[1]);
    int b = nook_passing(&r->origin, &r->direction, p[1], p[2]), c;
    if (differ(a, b)) return false;
    c = nook_passing(&r->origin, &r->direction, p[2], p[0]);
    *turn = a + b + c;
    return !differ(a, c) && !differ(b, c);
}

/* t of a point on the ray. */
static float t_of(const nook_ray *r, const nook_point *p) {
    return (nook_along(p, r->axis) - nook_along(&r->origin, r->axis)) /
           (nook_along(&r->direction, r->axis) * r->unit);
}

/* Twice the area of the triangle as a vector, at the corner that faces its longest edge, which comes first then: the two
 * others tell most about a thin one. */
static nook_point area_of(const nook_point *const p[3], const nook_point *q[3]) {
    nook_point ab = nook_sub(*p[1], *p[0]), bc = nook_sub(*p[2], *p[1]), ca = nook_sub(*p[0], *p[2]);
    float c = nook_dot(ab, ab), a = nook_dot(bc, bc), b = nook_dot(ca, ca);
    uint32_t first = a >= b && a >= c ? 0 : b >= c ? 1u : 2u;
    q[0] = p[first];
    q[1] = p[nook_after(first)];
    q[2] = p[nook_after(nook_after(first))];
    return nook_cross(nook_sub(*q[1], *q[0]), nook_sub(*q[2], *q[0]));
}

static float by_powers(float x, int32_t exponent) {
    for (; exponent > 100; exponent -= 100) x *= 0x1p100f;
    for (; exponent < -100; exponent += 100) x *= 0x1p-100f;
    return x * nook_power_of_two((uint32_t)(127 + exponent));
}

/* The same without rounding but at the end. */
NOOK_APART static float t_exactly(const nook_ray *r, const nook_point *const p[3]) {
    const nook_point *const above[4] = {p[0], p[1], p[2], &r->origin}, *const along[4] = {p[0], p[1], p[2],
                                                                                          &r->direction};
    int32_t high, across;
    float height = nook_determinant(above, false, &high), speed = nook_determinant(along, true, &across);
    return by_powers(-height / speed, high - across) / r->unit;
}

/* Where the line goes through the plane. Where it is so flat to it, or the triangle so thin, that rounding would show: exactly. */
static float t_through(const nook_ray *r, const nook_point *const p[3]) {
    const nook_point *q[3];
    nook_point n = area_of(p, q), d = toward(r), a = nook_sub(*q[0], r->origin);
    float speed = nook_dot(d, n), size = nook_abs(d.x * n.x) + nook_abs(d.y * n.y) + nook_abs(d.z * n.z);
    nook_point ab = nook_sub(*q[1], *q[0]), ac = nook_sub(*q[2], *q[0]);
    size += 2.0f * (nook_abs(ab.x * ac.y * d.z) + nook_abs(ab.y * ac.z * d.x) + nook_abs(ab.z * ac.x * d.y));
    if (nook_abs(speed) * 32.0f > size + 0x1p-70f) return nook_dot(a, n) / speed;
    return t_exactly(r, p);
}

/* The plane of the triangle cut by the line at t >= 0: the origin is not beyond it. turn is the sign of the edges. */
static bool is_ahead(const nook_ray *r, const nook_point *const p[3], int turn) {
    return !(nook_orient3d(p[0], p[1], p[2], &r->origin) * turn > 0);
}

/* ---- in the plane --------------------------------------------------------------------------------- */

/* A triangle seen along an axis in which it, or at least its line, does not become a point: how its corners lie
 * about the ray's line. */
typedef struct flat {
    const nook_point *const *p;
    uint32_t axis;
    int side[3];
} flat;

static bool see_along(const nook_ray *r, flat *f, uint32_t axis) {
    uint32_t i;
    f->axis = axis;
    for (i = 0; i < 3u; i++) f->side[i] = nook_turning(&r->origin, f->p[i], &r->direction, axis);
    return f->side[0] != 0 || f->side[1] != 0 || f->side[2] != 0;
}

/* Keep t, which is 0 or more where ahead says so; behind and ahead of the origin at once is at the origin. */
typedef struct span {
    float t;
    bool behind, ahead;
} span;

static void take(span *s, float t, int sign) {
    if (sign < 0) s->behind = true;
    if (sign == 0) s->behind = s->ahead = true;
    if (sign > 0 && (!s->ahead || t < s->t)) s->t = t;
    if (sign > 0) s->ahead = true;
}

/* Edge i crosses the line. */
static void cross(const nook_ray *r, const flat *f, uint32_t i, span *s) {
    const nook_point *a = f->p[i], *b = f->p[nook_after(i)];
    int sign = nook_orient2d(&r->origin, a, b, f->axis) * nook_turning(a, b, &r->direction, f->axis);
    float x, y, t = t_of(r, a);
    nook_point n = nook_cross(nook_sub(*a, r->origin), toward(r)),
               m = nook_cross(nook_sub(*b, r->origin), toward(r));
    x = nook_along(&n, f->axis);
    y = nook_along(&m, f->axis);
    if (x != y) t += (t_of(r, b) - t) * (x / (x - y));
    take(s, t > 0 ? t : 0, -sign);
}

/* Triangle and ray in one plane: where the ray first comes upon it. False if it does not. */
static bool meets_in_plane(const nook_ray *r, const nook_point *const p[3], float *t) {
    flat f = {p, 0, {0, 0, 0}};
    span s = {0, false, false};
    uint32_t i;
    /* Along the two axes in which the ray does not become a point. */
    if (!see_along(r, &f, nook_after(r->axis))) (void)see_along(r, &f, nook_after(nook_after(r->axis)));
    for (i = 0; i < 3u; i++) {
        int sign = nook_along(p[i], r->axis) > nook_along(&r->origin, r->axis)   ? 1
                   : nook_along(p[i], r->axis) < nook_along(&r->origin, r->axis) ? -1
                                                                                 : 0;
        if (nook_along(&r->direction, r->axis) < 0) sign = -sign;
        if (f.side[i] == 0) take(&s, t_of(r, p[i]), sign);
        if (differ(f.side[i], f.side[nook_after(i)])) cross(r, &f, i, &s);
    }
    *t = s.behind ? 0 : s.t;
    return s.ahead;
}

/* ---- hits ----------------------------------------------------------------------------------------- */

/* How much farther to look than t: whatever is no farther but for rounding is seen too, so that of equals the lowest
 * number wins whichever box it is in. */
static float beyond(const nook_ray *r, float t) { return t + (t + nook_bvh_size(r->bvh)) * 0x1p-18f; }

static void hit(nook_ray *r, uint32_t t, float at) {
    if (at > r->best || (at == r->best && t > r->triangle)) return;
    r->triangle = t;
    r->best = at;
    r->reach = beyond(r, at);
}

/* The line goes through: turn is the sign of the edges. */
static void go_through(nook_ray *r, uint32_t t, const nook_point *const p[3], int turn) {
    float at;
    if (!is_ahead(r, p, turn)) return;
    at = t_through(r, p);
    hit(r, t, at > 0 ? at : 0);
}

static void look_at(nook_ray *r, uint32_t t, const nook_point *const p[3]) {
    int turn;
    float at;
    if (!meets(r, p, &turn)) return;
    if (turn != 0) {
        go_through(r, t, p, turn);
    } else if (meets_in_plane(r, p, &at)) {
        hit(r, t, at);
    }
}

/* How the line passes an edge, if it stood aside by a trifle along one axis, and by a trifle of that along another. Then it
 * meets no edge, and of the triangles around one that it did meet it goes through as many as it should. */
static int passing_aside(const nook_ray *r, const nook_point *a, const nook_point *b) {
    uint32_t u = nook_after(r->axis);
    int sign = nook_passing(&r->origin, &r->direction, a, b);
    if (sign == 0) sign = -nook_turning(a, b, &r->direction, u);
    return sign != 0 ? sign : -nook_turning(a, b, &r->direction, nook_after(u));
}

static void count(nook_ray *r, const nook_point *const p[3]) {
    int turn, other;
    turn = passing_aside(r, p[0], p[1]);
    other = passing_aside(r, p[1], p[2]);
    if (turn == 0 || turn != other || turn != passing_aside(r, p[2], p[0]) || !is_ahead(r, p, turn)) return;
    r->crossings++;
    r->winding += turn;
}

/* Some triangles from a place on: those that there are and that are not missed for certain are looked at. */
static inline bool visit_some(nook_ray *r, const sight *s, uint32_t place) {
    uint32_t rest = r->bvh->view.nt - place, some = (1u << NOOK_LANES) - 1u, left = 0, right = 0, k;
    int turn = nook_along(&r->direction, r->axis) > 0 ? 1 : -1;
    const nook_point *p[3];
    nook_some x;
    if (!nook_gather(r->bvh, place, &x)) return false;
    if (NOOK_HAS_FPU) some = judge(s, &x, &left, &right);
    for (k = 0; some >> k != 0 && k < rest; k++) {
        if ((some >> k & 1u) == 0) continue;
        nook_corners_of(r->bvh, x.t[k], p);
        if (r->kind == NOOK_CROSSINGS) {
            count(r, p);
        } else if (((left | right) >> k & 1u) != 0) {
            go_through(r, x.t[k], p, (left >> k & 1u) != 0 ? turn : -turn);
        } else {
            look_at(r, x.t[k], p);
        }
    }
    return true;
}

static bool visit_leaf(nook_ray *r, const sight *s) {
    uint32_t place = 4u * r->descent.node, end = place + 4u, nt = r->bvh->view.nt;
    for (; place < end && place < nt; place += NOOK_LANES) {
        if (!visit_some(r, s, place)) return false;
    }
    nook_descent_leave(&r->descent);
    return true;
}

/* ---- asking --------------------------------------------------------------------------------------- */

static bool is_direction(nook_point d) {
    float sum = nook_abs(d.x) + nook_abs(d.y) + nook_abs(d.z);
    return sum > 0 && d.x - d.x == 0 && d.y - d.y == 0 && d.z - d.z == 0;
}

static void set_direction(nook_ray *r) {
    nook_point d = r->direction;
    float x = nook_abs(d.x), y = nook_abs(d.y), z = nook_abs(d.z), most = x > y ? x : y;
    r->axis = z > most ? 2u : x < y;
    r->unit = nook_power_of_two(254u - nook_exponent(z > most ? z : most));
}

nook_status nook_ray_begin(nook_ray *r, const nook_bvh *bvh, nook_point origin, nook_point direction,
                           float t_max, nook_ray_kind kind) {
    nook_status status = nook_bvh_status(bvh);
    if (r == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    status = nook_point_status(origin);
    if (status != NOOK_OK) return status;
    if (!is_direction(direction)) return NOOK_NOT_FINITE;
    r->triangle = NOOK_NONE;
    r->t_min = 0, r->crossings = 0, r->winding = 0;
    r->bvh = bvh;
    r->kind = kind;
    r->origin = origin;
    r->direction = direction;
    set_direction(r);
    set_axis(r, 0), set_axis(r, 1), set_axis(r, 2);
    r->t = t_max;
    r->best = t_max / r->unit;
    r->reach = beyond(r, r->best);
    nook_descent_begin(&r->descent, bvh);
    return NOOK_OK;
}

/* What is known: nothing is hit before t_min. */
static nook_status conclude(nook_ray *r, nook_status status) {
    if (r->triangle != NOOK_NONE) r->t = r->best * r->unit;
    r->t_min = nook_descent_least(&r->descent, r->best) * r->unit;
    if (r->t_min > r->t) r->t_min = r->t;
    return status;
}

nook_status nook_ray_step(nook_ray *r, uint32_t *units) {
    const slabs boxes = {nook_vectors_of(r->inverse), nook_vectors_of(r->near),
                         nook_vectors_of(r->far),     r->inverse.x < 0 ? 12u : 0,
                         r->inverse.y < 0 ? 16u : 4u, r->inverse.z < 0 ? 20u : 8u};
    const sight triangles = sight_of(r);
    nook_descent *d = &r->descent;
    uint32_t limit = nook_limit(r->reach);
    while (nook_descent_next(d, r->bvh->places, limit)) {
        if (r->kind == NOOK_ANY && r->triangle != NOOK_NONE) break;
        if (*units == 0) return conclude(r, NOOK_MORE);
        --*units;
        if (d->level != 0) {
            visit_group(r, &boxes);
        } else if (visit_leaf(r, &triangles)) {
            limit = nook_limit(r->reach);
        } else {
            return conclude(r, NOOK_INDEX_OUT_OF_RANGE);
        }
    }
    return conclude(r, NOOK_OK);
}

nook_status nook_ray_cast(nook_ray *ray, const nook_bvh *bvh, nook_point origin, nook_point direction,
                          float t_max, nook_ray_kind kind) {
    uint32_t units = UINT32_MAX; /* more than a tree has nodes */
    nook_status status = nook_ray_begin(ray, bvh, origin, direction, t_max, kind);
    return status == NOOK_OK ? nook_ray_step(ray, &units) : status;
}

nook_point nook_ray_normal(const nook_ray *ray) {
    nook_point corners[3];
    const nook_point *p[3];
    uint32_t i;
    if (ray->triangle == NOOK_NONE || !nook_points_of(ray->bvh, ray->triangle, p)) return nook_make(0, 0, 0);
    for (i = 0; i < 3u; i++) corners[i] = *p[i];
    return nook_normal(corners);
}

void nook_ray_weights(const nook_ray *ray, float w[3]) {
    nook_point corners[3], at = nook_scaled(toward(ray), ray->best);
    const nook_point *p[3];
    float sum = 0;
    uint32_t i;
    w[0] = w[1] = w[2] = 0;
    if (ray->triangle == NOOK_NONE || !nook_points_of(ray->bvh, ray->triangle, p)) return;
    for (i = 0; i < 3u; i++) corners[i] = nook_sub(*p[i], ray->origin);
    nook_barycentric(corners, at, w);
    for (i = 0; i < 3u; i++) {
        if (!(w[i] > 0)) w[i] = 0;
        sum += w[i];
    }
    /* 1 or more, unless the triangle is lost in the rounding of the way to it: 0, or no number from here on. */
    sum += sum - sum;
    for (i = 0; i < 3u; i++) w[i] = sum > 0 ? w[i] / sum : 1.0f / 3.0f;
}
