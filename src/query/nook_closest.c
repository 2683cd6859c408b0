/* nook_closest.c -- nearest boxes first, and the nearest of each triangle's points in them. */
#include "query/nook_closest.h"

#include "query/nook_lanes.h"
#include "query/nook_pair.h"

/* ---- boxes ---------------------------------------------------------------------------------------- */

static inline void set_axis(nook_closest *q, uint32_t axis) {
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

static nook_lanes off_lines(const nook_closest *q, const nook_boxes *g, uint32_t child, nook_lanes square) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        nook_lanes off = nook_larger(off_line(q, g, child, axis), nook_lanes_of(0));
        square = nook_larger(square, off * off);
    }
    return square;
}

/* How far the box of the segment is from some boxes along an axis. */
NOOK_WIDE nook_lanes apart(const nook_bound *from, const nook_bound *to, nook_lanes low, nook_lanes high,
                           nook_lanes width) {
    nook_lanes off = nook_larger(nook_load(from) - high, low - nook_load(to));
    return nook_larger(off, nook_lanes_of(0)) * width;
}

/* What groups are held against: the box of the segment, and the width of a cell. */
typedef struct around {
    nook_vectors low, high, width;
} around;

static inline void visit_group(nook_closest *q, const around *s) {
    const nook_boxes *g = nook_descent_boxes(&q->descent, q->bvh);
    uint32_t entry[4], bits = 0, i;
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_lanes x = apart(g->low[0] + i, g->high[0] + i, s->low.x, s->high.x, s->width.x), y, z, square;
        y = apart(g->low[1] + i, g->high[1] + i, s->low.y, s->high.y, s->width.y);
        z = apart(g->low[2] + i, g->high[2] + i, s->low.z, s->high.z, s->width.z);
        square = x * x + y * y + z * z;
        if (q->is_segment) square = off_lines(q, g, i, square);
        square = square * nook_lanes_of(1.0f - 0x1p-18f);
        bits |= nook_set_entries(entry, i, square <= nook_lanes_of(q->reach), square);
    }
    nook_descent_push(&q->descent, q->bvh->places, bits, entry);
}

/* ---- triangles ------------------------------------------------------------------------------------ */

/* Pairs of nearest points of some triangles and the segment, seen from its beginning. */
typedef struct nearest {
    nook_vectors point;
    nook_lanes at, square;
} nearest;

NOOK_WIDE nook_vectors along(nook_vectors a, nook_vectors d, nook_lanes t) {
    nook_vectors p = {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
    return p;
}

NOOK_WIDE nook_lanes clamp(nook_lanes t) {
    return nook_smaller(nook_larger(t, nook_lanes_of(0)), nook_lanes_of(1.0f));
}

NOOK_WIDE void keep_nearer(nearest *n, nook_vectors point, nook_lanes at, nook_lanes square) {
    nook_flags nearer = square < n->square;
    n->point = nook_vectors_choose(nearer, point, n->point);
    n->at = nook_choose(nearer, at, n->at);
    n->square = nook_smaller(square, n->square);
}

/* The point of the segment a b nearest to x; the ends as they are. */
NOOK_WIDE nook_vectors on_segment(nook_vectors a, nook_vectors b, nook_vectors x) {
    nook_vectors d = nook_vectors_sub(b, a);
    nook_lanes t = nook_vectors_dot(nook_vectors_sub(x, a), d) / nook_vectors_dot(d, d);
    t = clamp(t); /* no number: a point */
    return nook_vectors_choose(t < nook_lanes_of(1.0f), along(a, d, t), b);
}

/* That nearest to 0, of edge a b. */
NOOK_WIDE void keep_edge(nearest *n, nook_vectors a, nook_vectors b) {
    nook_vectors p = on_segment(a, b, nook_vectors_of(nook_make(0, 0, 0)));
    keep_nearer(n, p, n->at, nook_vectors_dot(p, p));
}

NOOK_WIDE nook_flags is_left(nook_vectors a, nook_vectors b, nook_vectors normal) {
    return nook_vectors_dot(nook_vectors_cross(a, b), normal) > nook_lanes_of(0);
}

/* The nearest points of triangles to x, which is at of the segment: on an edge, or the foot of x. The foot is sought from
 * the nearest edge: the normal of a thin triangle is uncertain, but not so much as to matter across its width. */
NOOK_WIDE nearest of_triangles(const nook_vectors p[3], nook_vectors x) {
    nook_vectors a = nook_vectors_sub(p[0], x), b = nook_vectors_sub(p[1], x), c = nook_vectors_sub(p[2], x);
    nook_vectors normal = nook_vectors_cross(nook_vectors_sub(b, a), nook_vectors_sub(c, a));
    nearest e = {a, nook_lanes_of(0), nook_vectors_dot(a, a)};
    nook_flags inside = is_left(a, b, normal);
    keep_edge(&e, a, b);
    keep_edge(&e, b, c);
    keep_edge(&e, c, a);
    if (nook_any_flag(inside)) inside = inside & is_left(b, c, normal);
    if (nook_any_flag(inside)) inside = inside & is_left(c, a, normal);
    if (nook_any_flag(inside)) {
        nook_lanes t = nook_vectors_dot(e.point, normal) / nook_vectors_dot(normal, normal);
        nook_vectors foot = {t * normal.x, t * normal.y, t * normal.z};
        keep_nearer(&e, foot, e.at, nook_choose(inside, nook_vectors_dot(foot, foot), e.square));
    }
    return e;
}

/* The nearest points of two segments, 0 d and a b, where they are between the ends; the nearest to an end is found from
 * there. By cross products: dot products lose twice as many bits where they are nearly parallel. */
NOOK_WIDE void consider_edges(nearest *n, nook_vectors d, nook_vectors a, nook_vectors b) {
    nook_vectors e = nook_vectors_sub(b, a), normal = nook_vectors_cross(d, e),
                 zero = nook_vectors_of(nook_make(0, 0, 0)), point, off;
    nook_lanes s =
        clamp(nook_vectors_dot(nook_vectors_cross(a, e), normal) / nook_vectors_dot(normal, normal));
    point = on_segment(a, b, along(zero, d, s));
    s = clamp(nook_vectors_dot(point, d) / nook_vectors_dot(d, d));
    off = nook_vectors_sub(point, along(zero, d, s));
    keep_nearer(n, point, s, nook_vectors_dot(off, off));
}

/* From both ends of the segment, from where it comes through the plane, and along each edge. */
NOOK_APART static void consider_segment(nearest *n, const nook_closest *q, const nook_vectors p[3]) {
    nook_vectors normal = nook_vectors_cross(nook_vectors_sub(p[1], p[0]), nook_vectors_sub(p[2], p[0])),
                 zero = nook_vectors_of(nook_make(0, 0, 0)),
                 d = nook_vectors_of(nook_scaled(nook_sub(q->b, q->a), q->scale));
    nook_lanes s = nook_lanes_of(0);
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        nook_vectors x = along(zero, d, s);
        nearest e = of_triangles(p, x);
        keep_nearer(n, along(x, e.point, nook_lanes_of(1.0f)), s, e.square);
        s = i == 0 ? nook_lanes_of(1.0f)
                   : clamp(nook_vectors_dot(p[0], normal) / nook_vectors_dot(d, normal));
    }
    for (i = 0; i < 3u; i++) consider_edges(n, d, p[i], p[nook_after(i)]);
}

/* ---- finding -------------------------------------------------------------------------------------- */

static void found(nook_closest *q, uint32_t t, const nearest *n, uint32_t k, bool crosses) {
    float square = crosses ? 0 : nook_lane(n->square, k), far = nook_sqrt(square) + q->margin,
          length = 1.0f / q->scale;
    nook_point p = nook_make(nook_lane(n->point.x, k), nook_lane(n->point.y, k), nook_lane(n->point.z, k));
    if (square > q->square || (square == q->square && t > q->triangle)) return;
    q->triangle = t;
    q->square = square;
    q->reach = far * far;
    q->crosses = crosses;
    q->at = nook_lane(n->at, k);
    q->point = nook_make(q->a.x + length * p.x, q->a.y + length * p.y, q->a.z + length * p.z);
    if (NOOK_LANES > 1 && !q->is_segment)
        q->b = nook_scaled(p, square > 0x1p-100f ? (1.0f - 0x1p-20f) / nook_sqrt(square) : 0);
}

/* ---- leaves --------------------------------------------------------------------------------------- */

/* How far the box of the segment is from those of some triangles, squared; both from the segment's beginning. */
static inline nook_lanes square_of_boxes(const nook_closest *q, const nook_vectors p[3]) {
    nook_vectors low = nook_lowest(p), high = nook_highest(p);
    nook_point d = nook_scaled(nook_sub(q->b, q->a), q->scale), zero = nook_make(0, 0, 0);
    nook_vectors from = nook_vectors_of(nook_low(d, zero)), to = nook_vectors_of(nook_high(d, zero));
    nook_vectors off = nook_vectors_larger(nook_vectors_sub(low, to), nook_vectors_sub(from, high));
    off = nook_vectors_larger(off, nook_vectors_of(zero));
    return nook_vectors_dot(off, off);
}

/* The same by how far the triangles are at least along a line: that from the point to the nearest one seen tells most. */
static inline nook_lanes square_toward(const nook_closest *q, const nook_vectors p[3]) {
    nook_vectors w = nook_vectors_of(q->b);
    nook_vectors along = {nook_vectors_dot(p[0], w), nook_vectors_dot(p[1], w), nook_vectors_dot(p[2], w)};
    nook_lanes on = nook_larger(nook_least(along) - nook_lanes_of(q->margin), nook_lanes_of(0));
    return on * on;
}

static bool is_crossed(const nook_closest *q, uint32_t t) {
    const nook_point *const segment[3] = {&q->a, &q->b, &q->b}, *p[3];
    nook_corners_of(q->bvh, t, p);
    return nook_triangles_meet(segment, p);
}

/* Some triangles, from a place on: which, and how near; crossed, those that the segment may go through. */
NOOK_APART static bool measure(const nook_closest *q, uint32_t place, uint32_t t[NOOK_LANES], nearest *n,
                               uint32_t *crossed) {
    nook_vectors p[3], a = nook_vectors_of(q->a), zero = nook_vectors_of(nook_make(0, 0, 0));
    nook_lanes boxes;
    uint32_t i;
    nook_some x;
    n->at = zero.x, n->square = nook_lanes_of(0x1p127f);
    *crossed = 0;
    if (!nook_gather(q->bvh, place, &x)) return false;
    for (i = 0; i < 3u; i++)
        p[i] = nook_vectors_scaled(nook_vectors_sub(nook_some_corners(&x, i), a), q->scale);
    n->point = p[0];
    memcpy(t, x.t, sizeof x.t);
    /* Boxes of triangles side by side are no cheaper than those, and one by one not so dear that a direction would pay. */
    boxes = NOOK_LANES == 1 || q->is_segment ? square_of_boxes(q, p) : square_toward(q, p);
    if (!nook_any_flag(boxes <= nook_lanes_of(q->reach))) return true;
    if (q->is_segment) {
        consider_segment(n, q, p);
        *crossed = nook_bits(boxes <= zero.x);
    } else {
        *n = of_triangles(p, zero);
    }
    return true;
}

static bool visit_leaf(nook_closest *q) {
    uint32_t place = 4u * q->descent.node, end = place + 4u, nt = q->bvh->view.nt, k;
    for (; place < end && place < nt; place += NOOK_LANES) {
        uint32_t t[NOOK_LANES], nearer, crossed;
        nearest n;
        if (!measure(q, place, t, &n, &crossed)) return false;
        nearer = nook_bits(n.square <= nook_lanes_of(q->square)) | crossed;
        for (k = 0; nearer >> k != 0; k++) {
            bool crosses = (crossed >> k & 1u) != 0 && is_crossed(q, t[k]);
            if ((nearer >> k & 1u) != 0) found(q, t[k], &n, k, crosses);
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
    nearest n;
    if (!nook_points_of(q->bvh, t, at)) return;
    n.point = nook_vectors_of(nook_scaled(nook_sub(*at[0], q->a), q->scale));
    n.at = nook_lanes_of(0), n.square = nook_vectors_dot(n.point, n.point);
    q->distance_max = (nook_sqrt(nook_lane(n.square, 0)) + q->margin) / q->scale;
    found(q, t, &n, 0, false);
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
    set_axis(q, 0), set_axis(q, 1), set_axis(q, 2);
    limit = (limit < NOOK_FAR ? limit : NOOK_FAR) * q->scale; /* nothing is farther */
    q->square = limit * limit;
    q->reach = (limit + q->margin) * (limit + q->margin);
    nook_descent_begin(&q->descent, bvh);
    if (NOOK_LANES > 1 && !q->is_segment) q->b = nook_make(0, 0, 0);
    begin_anywhere(q);
    return conclude(q, NOOK_OK);
}

nook_status nook_closest_step(nook_closest *q, uint32_t *units) {
    const around s = {nook_vectors_of(q->low), nook_vectors_of(q->high), nook_vectors_of(q->width)};
    nook_descent *d = &q->descent;
    uint32_t limit = nook_limit(q->reach);
    while (nook_descent_next(d, q->bvh->places, limit)) {
        if (q->enough > 0 && q->distance_max <= q->enough) break;
        if (*units == 0) return conclude(q, NOOK_MORE);
        --*units;
        if (d->level != 0) {
            visit_group(q, &s);
        } else if (visit_leaf(q)) {
            limit = nook_limit(q->reach);
            if (q->enough > 0) (void)conclude(q, NOOK_OK);
        } else {
            return conclude(q, NOOK_INDEX_OUT_OF_RANGE);
        }
    }
    return conclude(q, NOOK_OK);
}

nook_status nook_closest_point(nook_closest *q, const nook_bvh *bvh, nook_point point) {
    uint32_t units = UINT32_MAX; /* more than a tree has nodes */
    nook_status status = nook_closest_begin(q, bvh, point, point, NOOK_FAR, 0);
    return status == NOOK_OK ? nook_closest_step(q, &units) : status;
}
