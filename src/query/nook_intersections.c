/* nook_intersections.c -- each triangle, and each border edge, against the tree. */
#include "query/nook_intersections.h"

#include "query/nook_apart.h"
#include "query/nook_pair.h"

/* The cells of a box. */
static void set_cells(const nook_bvh *bvh, nook_point low, nook_point high, nook_bound from[3],
                      nook_bound to[3]) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        from[axis] = (nook_bound)nook_cell(bvh, nook_along(&low, axis), axis);
        to[axis] = (nook_bound)nook_cell(bvh, nook_along(&high, axis), axis);
    }
}

/* Which children's boxes overlap one in cells. */
static inline nook_flags overlap(const nook_boxes *g, uint32_t child, uint32_t axis, const nook_bound low[3],
                                 const nook_bound high[3]) {
    return (nook_load_cells(&g->low[axis][child]) <= high[axis]) &
           (nook_load_cells(&g->high[axis][child]) >= low[axis]);
}

static inline void visit_group(nook_descent *d, const nook_bvh *bvh, const nook_bound low[3],
                               const nook_bound high[3]) {
    const nook_boxes *g = nook_descent_boxes(d, bvh);
    uint32_t entry[4], bits = 0, i;
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_flags some =
            overlap(g, i, 0, low, high) & overlap(g, i, 1, low, high) & overlap(g, i, 2, low, high);
        bits |= nook_set_entries(entry, i, some, nook_lanes_of(0));
    }
    nook_descent_push(d, bvh->view.nt, bits, entry);
}

/* ---- pairs ---------------------------------------------------------------------------------------- */

nook_status nook_intersections_begin(nook_intersections *q, const nook_bvh *bvh) {
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    memset(q, 0, sizeof *q);
    q->bvh = bvh;
    q->leaf = NOOK_NONE;
    q->descent.now = NOOK_UP;
    return NOOK_OK;
}

/* The next leaf, its box as its group has it, is held against the tree. */
static void begin_leaf(nook_intersections *q) {
    const nook_boxes *group = &q->bvh->boxes[++q->leaf >> 2];
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        q->low[axis] = group->low[axis][q->leaf & 3u];
        q->high[axis] = group->high[axis][q->leaf & 3u];
    }
    nook_descent_begin(&q->descent, q->bvh);
}

/* The triangle at a place, or the last one, in all lanes. */
static bool spread(const nook_bvh *bvh, uint32_t place, nook_several *to) {
    uint32_t last = bvh->view.nt - 1u, t = nook_triangle_at(bvh, place < last ? place : last), i;
    const nook_point *p[3];
    if (!nook_points_of(bvh, t, p)) return false;
    for (i = 0; i < 3u; i++) {
        to->v[i] = nook_all_flags() & (int32_t)bvh->view.V[3u * t + i];
        to->p[i] = nook_vectors_of(*p[i]);
    }
    return true;
}

/* Some with their vertices. */
static bool gather(const nook_bvh *bvh, uint32_t place, nook_several *to) {
    int32_t v[NOOK_LANES];
    nook_some x;
    uint32_t i, k;
    if (!nook_gather(bvh, place, &x)) return false;
    for (i = 0; i < 3u; i++) {
        for (k = 0; k < NOOK_LANES; k++) v[k] = (int32_t)bvh->view.V[3u * x.t[k] + i];
        memcpy(&to->v[i], v, sizeof v);
        to->p[i] = x.p[i];
    }
    return true;
}

#if NOOK_LANES > 1
/* The axis along which a triangle, the same in all lanes, is seen largest. */
static uint32_t broadest(const nook_several *a) {
    nook_vectors n =
        nook_vectors_cross(nook_vectors_sub(a->p[1], a->p[0]), nook_vectors_sub(a->p[2], a->p[0]));
    float x = nook_abs(n.x[0]), y = nook_abs(n.y[0]), z = nook_abs(n.z[0]);
    return x > y ? (x > z ? 0 : 2u) : (y > z ? 1u : 2u);
}
#endif

/* Which pairs of a triangle, the same in all lanes, and others may intersect. One by one, nook_pair.h is as quick. */
static nook_flags may_meet(const nook_several *a, const nook_several *b) {
    nook_vectors low = nook_lowest(a->p), high = nook_highest(a->p), from = nook_lowest(b->p),
                 to = nook_highest(b->p);
    nook_flags some = (from.x <= high.x) & (from.y <= high.y) & (from.z <= high.z) & (to.x >= low.x) &
                      (to.y >= low.y) & (to.z >= low.z);
#if NOOK_LANES > 1
    uint32_t axis;
    nook_seen x, y;
    if (!nook_any_flag(some)) return some;
    some = some & nook_not(nook_is_on_one_side(a, b) | nook_is_on_one_side(b, a));
    if (!nook_any_flag(some)) return some;
    axis = broadest(a);
    x = nook_see(a, axis), y = nook_see(b, axis);
    some = some & nook_not(nook_is_beside(a, &x, b, &y) | nook_is_beside(b, &y, a, &x));
#endif
    return some;
}

/* Bits 4 i + j + k of pairs: place i of the leaf may meet places j + k of the node, k a lane. */
static bool find_pairs_of(const nook_intersections *q, uint32_t i, const nook_several *b, uint32_t j,
                          uint32_t *pairs) {
    uint32_t k, place = 4u * q->leaf + i, other = 4u * q->descent.node + j, nt = q->bvh->view.nt;
    nook_several a;
    nook_flags some;
    if (!spread(q->bvh, place, &a)) return false;
    some = may_meet(&a, b);
    for (k = 0; k < NOOK_LANES; k++) {
        if (nook_flag(some, k) && place < other + k && other + k < nt)
            *pairs |= (uint32_t)1 << (4u * i + j + k);
    }
    return true;
}

NOOK_APART static bool find_pairs(nook_intersections *q) {
    uint32_t i, j, pairs = 0;
    for (j = 0; j < 4u; j += NOOK_LANES) {
        nook_several b;
        if (!gather(q->bvh, 4u * q->descent.node + j, &b)) return false;
        for (i = 0; i < 4u; i++) {
            if (!find_pairs_of(q, i, &b, j, &pairs)) return false;
        }
    }
    q->pairs = pairs;
    return true;
}

/* The next of the pairs that intersects: NOOK_TRIANGLE, or NOOK_OK if there is none. */
NOOK_APART static nook_status next_pair(nook_intersections *q) {
    const nook_point *p[3];
    while (q->pairs != 0) {
        uint32_t i = 0, t, u;
        while ((q->pairs >> i & 1u) == 0) i++;
        q->pairs &= q->pairs - 1u;
        t = nook_triangle_at(q->bvh, 4u * q->leaf + (i >> 2));
        u = nook_triangle_at(q->bvh, 4u * q->descent.node + (i & 3u));
        if (!nook_points_of(q->bvh, t, p) || !nook_points_of(q->bvh, u, p)) return NOOK_INDEX_OUT_OF_RANGE;
        if (!nook_triangles_intersect(&q->bvh->view, t, u)) continue;
        q->t = t < u ? t : u;
        q->u = t < u ? u : t;
        q->count++;
        return NOOK_TRIANGLE;
    }
    return NOOK_OK;
}

/* A leaf before this one has seen this one already, and so have all below a group that ends before. */
static bool comes_before(const nook_intersections *q) {
    return (q->descent.node + 1u) << 2u * q->descent.level <= q->leaf;
}

/* Look at the node; false where the tables are spoiled. */
static bool visit(nook_intersections *q) {
    nook_descent *d = &q->descent;
    if (!comes_before(q) && d->level != 0) {
        visit_group(d, q->bvh, q->low, q->high);
        return true;
    }
    if (!comes_before(q) && !find_pairs(q)) return false;
    nook_descent_leave(d);
    return true;
}

nook_status nook_intersections_step(nook_intersections *q, uint32_t *units) {
    uint32_t nt = q->bvh->view.nt;
    for (;;) {
        nook_status status = next_pair(q);
        bool more;
        if (status != NOOK_OK) return status;
        more = nook_descent_next(&q->descent, nt, NOOK_UP);
        if (!more && q->leaf + 1u == (nt + 3u) / 4u) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            begin_leaf(q);
        } else if (!visit(q)) {
            return NOOK_INDEX_OUT_OF_RANGE;
        }
    }
}

/* ---- T-junctions ---------------------------------------------------------------------------------- */

nook_status nook_t_junctions_begin(nook_t_junctions *q, const nook_bvh *bvh, float tolerance) {
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    if (bvh->view.O == NULL || bvh->view.C == NULL) return NOOK_NULL_ARGUMENT;
    memset(q, 0, sizeof *q);
    q->bvh = bvh;
    q->tolerance = tolerance;
    q->corner = NOOK_NONE;
    q->descent.now = NOOK_UP;
    return NOOK_OK;
}

/* The edge that corner faces, if it is a border and its ends are vertices. */
static bool begin_edge(nook_t_junctions *q) {
    const nook_view *m = &q->bvh->view;
    uint32_t c = q->corner, v = m->V[nook_next(c)], w = m->V[nook_prev(c)];
    nook_point low, high, more = nook_make(q->tolerance, q->tolerance, q->tolerance);
    if (!nook_is_border(m, c)) return true;
    if (v >= m->nv || w >= m->nv) return false;
    low = nook_sub(nook_low(m->G[v], m->G[w]), more);
    high = nook_high(m->G[v], m->G[w]);
    high = nook_make(high.x + more.x, high.y + more.y, high.z + more.z);
    set_cells(q->bvh, low, high, q->low, q->high);
    q->from = v;
    q->to = w;
    nook_descent_begin(&q->descent, q->bvh);
    return true;
}

/* Whether x lies within the edge from a to b. */
static bool is_within(const nook_t_junctions *q, nook_point a, nook_point b, nook_point x) {
    float square = q->tolerance * q->tolerance, t;
    nook_point d = nook_sub(b, a), from = nook_sub(x, a), to = nook_sub(x, b), off;
    if (!(nook_dot(from, from) > square && nook_dot(to, to) > square)) return false;
    t = nook_dot(from, d) / nook_dot(d, d);
    off = nook_sub(from, nook_scaled(d, t));
    return t > 0 && t < 1.0f && nook_dot(off, off) <= square;
}

/* Each vertex comes once: with the corner that stands for it. */
static bool is_junction(const nook_t_junctions *q, uint32_t c) {
    const nook_view *m = &q->bvh->view;
    uint32_t x = m->V[c];
    return m->C[x] == c && x != q->from && x != q->to && is_within(q, m->G[q->from], m->G[q->to], m->G[x]);
}

/* The corners of a leaf from next on, up to one that is a junction. */
static nook_status visit_corners(nook_t_junctions *q) {
    uint32_t first = 4u * q->descent.node, nt = q->bvh->view.nt;
    while (q->next < 12u && first + q->next / 3u < nt) {
        uint32_t t = nook_triangle_at(q->bvh, first + q->next / 3u), c = 3u * t + q->next % 3u;
        const nook_point *p[3];
        q->next++;
        if (!nook_points_of(q->bvh, t, p)) return NOOK_INDEX_OUT_OF_RANGE;
        if (!is_junction(q, c)) continue;
        q->vertex = q->bvh->view.V[c];
        q->count++;
        return NOOK_TRIANGLE;
    }
    q->next = 0;
    nook_descent_leave(&q->descent);
    return NOOK_OK;
}

nook_status nook_t_junctions_step(nook_t_junctions *q, uint32_t *units) {
    uint32_t nt = q->bvh->view.nt;
    for (;;) {
        nook_status status = NOOK_OK;
        bool more = nook_descent_next(&q->descent, nt, NOOK_UP);
        if (!more && q->corner + 1u >= 3u * nt) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            q->corner++;
            if (!begin_edge(q)) status = NOOK_INDEX_OUT_OF_RANGE;
        } else if (q->descent.level != 0) {
            visit_group(&q->descent, q->bvh, q->low, q->high);
        } else {
            status = visit_corners(q);
        }
        if (status != NOOK_OK) return status;
    }
}
