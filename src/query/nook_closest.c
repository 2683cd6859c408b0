/* nook_closest.c -- nearest boxes first, and the nearest of each triangle's points in them. */
#include "query/nook_closest.h"

#include "query/nook_lanes.h"
#include "query/nook_pair.h"

/* ---- boxes ---------------------------------------------------------------------------------------- */

static void set_axis(nook_closest *q, uint32_t axis) {
    float a = nook_along(&q->a, axis), b = nook_along(&q->b, axis), slack, more;
    float low = nook_in_cells(q->bvh, a < b ? a : b, axis, &slack);
    float high = nook_in_cells(q->bvh, a < b ? b : a, axis, &more);
    *nook_axis(&q->low, axis) = low - slack - 1.0f; /* a bound leaves out the width of its cell */
    *nook_axis(&q->high, axis) = high + more;
    *nook_axis(&q->width, axis) = q->scale / nook_along(&q->bvh->cells, axis);
}

/* How far the line of the segment is from some boxes, seen along an axis: there it is a line, and a box a rectangle. Its
 * normal, of length 1, is u, v in the lengths of a cell. Less than 0 if it meets them. */
static nook_lanes off_line(const nook_closest *q, const nook_boxes *g, uint32_t child, uint32_t axis) {
    uint32_t i = nook_after(axis), j = nook_after(i);
    nook_point d = nook_scaled(nook_sub(q->b, q->a), q->scale);
    float x = nook_along(&d, i), y = nook_along(&d, j), length = nook_sqrt(x * x + y * y), slack, more, u, v,
          at;
    nook_lanes low[2], high[2], centre, half;
    if (!(length > 0)) return nook_lanes_of(-1.0f); /* a point */
    u = y / length * nook_along(&q->width, i);
    v = -x / length * nook_along(&q->width, j);
    at = u * nook_in_cells(q->bvh, nook_along(&q->a, i), i, &slack) +
         v * nook_in_cells(q->bvh, nook_along(&q->a, j), j, &more);
    slack = 8.0f * (slack * nook_abs(u) + more * nook_abs(v));
    low[0] = nook_load(&g->low[i][child]), high[0] = nook_load(&g->high[i][child]) + nook_lanes_of(1.0f);
    low[1] = nook_load(&g->low[j][child]), high[1] = nook_load(&g->high[j][child]) + nook_lanes_of(1.0f);
    centre = (low[0] + high[0]) * nook_lanes_of(0.5f * u) + (low[1] + high[1]) * nook_lanes_of(0.5f * v);
    half = (high[0] - low[0]) * nook_lanes_of(0.5f * nook_abs(u)) +
           (high[1] - low[1]) * nook_lanes_of(0.5f * nook_abs(v));
    return nook_magnitude(centre - nook_lanes_of(at)) - half - nook_lanes_of(slack);
}

/* How far the box of the segment is from some boxes along an axis. */
static inline nook_lanes apart(const nook_closest *q, const nook_boxes *g, uint32_t child, uint32_t axis) {
    nook_lanes above = nook_load(&g->low[axis][child]) - nook_lanes_of(nook_along(&q->high, axis));
    nook_lanes below = nook_lanes_of(nook_along(&q->low, axis)) - nook_load(&g->high[axis][child]);
    return nook_larger(nook_larger(above, below), nook_lanes_of(0)) *
           nook_lanes_of(nook_along(&q->width, axis));
}

static inline void visit_group(nook_closest *q) {
    const nook_boxes *group = nook_descent_boxes(&q->descent, q->bvh);
    uint32_t entry[4], axis, i;
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_lanes x = apart(q, group, i, 0), y = apart(q, group, i, 1), z = apart(q, group, i, 2);
        nook_lanes square = x * x + y * y + z * z;
        for (axis = 0; axis < 3u && q->is_segment; axis++) {
            nook_lanes off = nook_larger(off_line(q, group, i, axis), nook_lanes_of(0));
            square = nook_larger(square, off * off);
        }
        square = square * nook_lanes_of(1.0f - 0x1p-18f);
        nook_set_entries(entry, i, square <= nook_lanes_of(q->reach), square);
    }
    nook_descent_push(&q->descent, entry);
}

/* ---- triangles ------------------------------------------------------------------------------------ */

/* A pair of nearest points, seen from the beginning of the segment. */
typedef struct nearest {
    nook_point point;
    float at, square;
    bool crosses; /* exactly */
} nearest;

static nook_point along(nook_point a, nook_point d, float t) {
    return nook_make(a.x + t * d.x, a.y + t * d.y, a.z + t * d.z);
}

static float clamp(float t) { return t > 0 ? t < 1.0f ? t : 1.0f : 0; }

static void consider(nearest *n, nook_point point, nook_point on, float at) {
    nook_point d = nook_sub(point, on);
    float square = nook_dot(d, d);
    if (square >= n->square) return;
    n->point = point;
    n->at = at;
    n->square = square;
}

/* The point of the segment a b nearest to x; the ends as they are. */
static nook_point on_segment(nook_point a, nook_point b, nook_point x) {
    nook_point d = nook_sub(b, a);
    float t = clamp(nook_dot(nook_sub(x, a), d) / nook_dot(d, d)); /* no number: a point */
    return t < 1.0f ? along(a, d, t) : b;
}

/* The nearest point of a triangle to x, which is at of the segment: on an edge, or the foot of x. The foot is sought from
 * the nearest edge: the normal of a thin triangle is uncertain, but not so much as to matter across its width. */
static void consider_triangle(nearest *n, const nook_point p[3], nook_point x, float at) {
    nook_point a = nook_sub(p[0], x), b = nook_sub(p[1], x), c = nook_sub(p[2], x), normal;
    nook_point zero = nook_make(0, 0, 0), foot;
    nearest edge = {a, 0, nook_dot(a, a), false};
    consider(&edge, on_segment(a, b, zero), zero, 0);
    consider(&edge, on_segment(b, c, zero), zero, 0);
    consider(&edge, on_segment(c, a, zero), zero, 0);
    normal = nook_cross(nook_sub(b, a), nook_sub(c, a));
    foot = edge.point;
    if (nook_dot(nook_cross(a, b), normal) > 0 && nook_dot(nook_cross(b, c), normal) > 0 &&
        nook_dot(nook_cross(c, a), normal) > 0) {
        foot = nook_scaled(normal, nook_dot(foot, normal) / nook_dot(normal, normal));
        consider(&edge, foot, zero, 0);
    }
    if (edge.square >= n->square) return;
    n->point = nook_make(x.x + edge.point.x, x.y + edge.point.y, x.z + edge.point.z);
    n->at = at;
    n->square = edge.square;
}

/* The nearest points of two segments, 0 d and a b, where they are between the ends; the nearest to an end is found from
 * there. By cross products: dot products lose twice as many bits where they are nearly parallel. */
static void consider_edge(nearest *n, nook_point d, nook_point a, nook_point b) {
    nook_point e = nook_sub(b, a), normal = nook_cross(d, e), point;
    float s = clamp(nook_dot(nook_cross(a, e), normal) / nook_dot(normal, normal));
    point = on_segment(a, b, nook_scaled(d, s));
    s = clamp(nook_dot(point, d) / nook_dot(d, d));
    consider(n, point, nook_scaled(d, s), s);
}

/* From both ends, from where it comes through the plane, and along each edge. */
NOOK_APART static void consider_segment(nearest *n, nook_point d, const nook_point p[3]) {
    nook_point normal = nook_cross(nook_sub(p[1], p[0]), nook_sub(p[2], p[0]));
    float s = clamp(nook_dot(p[0], normal) / nook_dot(d, normal));
    consider_triangle(n, p, d, 1);
    consider_triangle(n, p, nook_scaled(d, s), s);
    consider_edge(n, d, p[0], p[1]);
    consider_edge(n, d, p[1], p[2]);
    consider_edge(n, d, p[2], p[0]);
}

/* ---- finding -------------------------------------------------------------------------------------- */

static void found(nook_closest *q, uint32_t t, const nearest *n) {
    float far = nook_sqrt(n->square) + q->margin;
    if (n->square > q->square || (n->square == q->square && t > q->triangle)) return;
    q->triangle = t;
    q->square = n->square;
    q->reach = far * far;
    q->crosses = n->crosses;
    q->at = n->at;
    q->point = along(q->a, n->point, 1.0f / q->scale);
}

/* ---- leaves --------------------------------------------------------------------------------------- */

/* How far the box of the segment is from those of some triangles, squared; both from the segment's beginning. */
static nook_lanes square_of_boxes(const nook_closest *q, const nook_vectors p[3]) {
    nook_vectors low = nook_lowest(p), high = nook_highest(p);
    nook_point d = nook_scaled(nook_sub(q->b, q->a), q->scale), zero = nook_make(0, 0, 0);
    nook_vectors from = nook_vectors_of(nook_low(d, zero)), to = nook_vectors_of(nook_high(d, zero));
    nook_vectors off = nook_vectors_larger(nook_vectors_sub(low, to), nook_vectors_sub(from, high));
    off = nook_vectors_larger(off, nook_vectors_of(zero));
    return nook_vectors_dot(off, off);
}

#if NOOK_LANES > 1
/* How far the edge from a to b is from 0, squared. */
static inline nook_lanes square_of_edge(nook_vectors a, nook_vectors b) {
    nook_vectors d = nook_vectors_sub(b, a), x;
    nook_lanes t = -nook_vectors_dot(a, d) / nook_vectors_dot(d, d);
    t = nook_smaller(nook_larger(t, nook_lanes_of(0)), nook_lanes_of(1.0f));
    x.x = a.x + t * d.x, x.y = a.y + t * d.y, x.z = a.z + t * d.z;
    return nook_vectors_dot(x, x);
}

/* How far some triangles are from 0, squared: that of the nearest edge, or where 0 is above the inside, of the boxes. */
static nook_lanes square_of_triangles(const nook_vectors p[3], nook_lanes boxes) {
    nook_vectors n = nook_vectors_cross(nook_vectors_sub(p[1], p[0]), nook_vectors_sub(p[2], p[0]));
    nook_lanes ab = nook_vectors_dot(nook_vectors_cross(p[0], p[1]), n), square, zero = nook_lanes_of(0);
    nook_lanes bc = nook_vectors_dot(nook_vectors_cross(p[1], p[2]), n), ca;
    ca = nook_vectors_dot(nook_vectors_cross(p[2], p[0]), n);
    square = nook_smaller(square_of_edge(p[0], p[1]), square_of_edge(p[1], p[2]));
    square = nook_smaller(square, square_of_edge(p[2], p[0]));
    square = nook_if(nook_not((ab > zero) & (bc > zero) & (ca > zero)), square);
    return nook_larger(square, boxes);
}
#endif

/* A distance that some triangles are not nearer than, squared. */
static inline nook_lanes least_square(const nook_closest *q, const nook_some *x) {
    nook_vectors p[3], a = nook_vectors_of(q->a);
    nook_lanes square;
    uint32_t i;
    for (i = 0; i < 3u; i++) p[i] = nook_vectors_scaled(nook_vectors_sub(x->p[i], a), q->scale);
    square = square_of_boxes(q, p);
#if NOOK_LANES > 1
    if (!q->is_segment) square = square_of_triangles(p, square);
#endif
    return square;
}

static void look_at(nook_closest *q, uint32_t t, const nook_point *const at[3]) {
    const nook_point *const segment[3] = {&q->a, &q->b, &q->b};
    nook_point p[3];
    nearest n = {{0, 0, 0}, 0, 0x1p127f, false};
    uint32_t i;
    for (i = 0; i < 3u; i++) p[i] = nook_scaled(nook_sub(*at[i], q->a), q->scale);
    consider_triangle(&n, p, nook_make(0, 0, 0), 0);
    if (q->is_segment) {
        consider_segment(&n, nook_scaled(nook_sub(q->b, q->a), q->scale), p);
        n.crosses = nook_triangles_meet(segment, at);
        if (n.crosses) n.square = 0;
    }
    found(q, t, &n);
}

static bool visit_leaf(nook_closest *q) {
    uint32_t place = 4u * q->descent.node, end = place + 4u, nt = q->bvh->view.nt, k;
    for (; place < end && place < nt; place += NOOK_LANES) {
        float least[NOOK_LANES];
        nook_lanes square;
        nook_some x;
        if (!nook_gather(q->bvh, place, &x)) return false;
        square = least_square(q, &x);
        memcpy(least, &square, sizeof least);
        for (k = 0; k < NOOK_LANES && place + k < nt; k++) {
            if (least[k] <= q->reach) look_at(q, x.t[k], x.at[k]);
        }
    }
    nook_descent_leave(&q->descent);
    return true;
}

/* ---- asking --------------------------------------------------------------------------------------- */

/* Everything that is added up is about as long as the mesh, as the way to it, or as the segment. */
static void set_scale(nook_closest *q) {
    float size = nook_bvh_size(q->bvh), far = nook_length(nook_sub(q->a, q->bvh->origin));
    float length = nook_length(nook_sub(q->b, q->a));
    size = far > size ? far : size;
    size = length > size ? length : size;
    q->scale = nook_power_of_two(254u - nook_exponent(size));
    q->margin = size * q->scale * 0x1p-20f;
}

/* Before anything: a corner of some triangle is not nearer than the nearest. */
static void begin_anywhere(nook_closest *q) {
    uint32_t t = nook_triangle_at(q->bvh, 0);
    const nook_point *at[3];
    nearest n = {{0, 0, 0}, 0, 0, false};
    if (!nook_points_of(q->bvh, t, at)) return;
    n.point = nook_scaled(nook_sub(*at[0], q->a), q->scale);
    n.square = nook_dot(n.point, n.point);
    q->distance_max = (nook_sqrt(n.square) + q->margin) / q->scale;
    found(q, t, &n);
}

static nook_status conclude(nook_closest *q, nook_status status) {
    float pending = nook_sqrt(nook_descent_least(&q->descent, 0x1p127f)) * (1.0f - 0x1p-20f);
    float distance = nook_sqrt(q->square), length = 1.0f / q->scale;
    float margin = q->crosses ? 0 : q->margin, known = distance > margin ? distance - margin : 0;
    q->distance = distance * length;
    if (q->triangle != NOOK_NONE) q->distance_max = (distance + margin) * length;
    q->distance_min = (pending < known ? pending : known) * length;
    return status;
}

nook_status nook_closest_begin(nook_closest *q, const nook_bvh *bvh, nook_point a, nook_point b, float limit,
                               float enough) {
    uint32_t axis;
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    status = nook_point_status(a);
    if (status == NOOK_OK) status = nook_point_status(b);
    if (status != NOOK_OK) return status;
    memset(q, 0, sizeof *q);
    q->triangle = NOOK_NONE;
    q->bvh = bvh;
    q->a = a;
    q->b = b;
    q->is_segment = a.x != b.x || a.y != b.y || a.z != b.z;
    q->enough = enough;
    set_scale(q);
    for (axis = 0; axis < 3u; axis++) set_axis(q, axis);
    limit = (limit < NOOK_FAR ? limit : NOOK_FAR) * q->scale; /* nothing is farther */
    q->square = limit * limit;
    q->reach = (limit + q->margin) * (limit + q->margin);
    nook_descent_begin(&q->descent, bvh);
    begin_anywhere(q);
    return conclude(q, NOOK_OK);
}

nook_status nook_closest_step(nook_closest *q, uint32_t *units) {
    nook_descent *d = &q->descent;
    while (nook_descent_next(d, q->bvh->places, nook_entry(q->reach, 3))) {
        if (q->enough > 0 && q->distance_max <= q->enough) break;
        if (*units == 0) return conclude(q, NOOK_MORE);
        --*units;
        if (d->level != 0) {
            visit_group(q);
        } else if (visit_leaf(q)) {
            if (q->enough > 0) (void)conclude(q, NOOK_OK);
        } else {
            return conclude(q, NOOK_INDEX_OUT_OF_RANGE);
        }
    }
    return conclude(q, NOOK_OK);
}

nook_status nook_closest_point(nook_closest *q, const nook_bvh *bvh, nook_point point) {
    nook_status status = nook_closest_begin(q, bvh, point, point, NOOK_FAR, 0);
    if (status != NOOK_OK) return status;
    do {
        uint32_t units = 16;
        status = nook_closest_step(q, &units);
    } while (status == NOOK_MORE);
    return status;
}
