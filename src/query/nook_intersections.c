/* nook_intersections.c -- each triangle, and each border edge, against the tree. */
#include "query/nook_intersections.h"

#include "query/nook_lanes.h"
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
    uint32_t entry[4], i;
    for (i = 0; i < 4u; i += NOOK_LANES) {
        nook_flags some =
            overlap(g, i, 0, low, high) & overlap(g, i, 1, low, high) & overlap(g, i, 2, low, high);
        nook_set_entries(entry, i, some, nook_lanes_of(0));
    }
    nook_descent_push(d, entry);
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

/* The boxes of some triangles side by side. */
typedef struct bundle {
    float low[3][NOOK_LANES], high[3][NOOK_LANES];
} bundle;

static bool box_at(const nook_bvh *bvh, uint32_t place, nook_point *low, nook_point *high) {
    const nook_point *p[3];
    uint32_t last = bvh->view.nt - 1u;
    if (!nook_points_of(bvh, nook_triangle_at(bvh, place < last ? place : last), p)) return false;
    *low = nook_low(nook_low(*p[0], *p[1]), *p[2]);
    *high = nook_high(nook_high(*p[0], *p[1]), *p[2]);
    return true;
}

/* Which triangles of a leaf, as bits, have boxes that overlap one. */
static uint32_t overlapping(const bundle *b, nook_point low, nook_point high) {
    nook_flags some = nook_lanes_at(b->low[0]) <= nook_lanes_of(high.x);
    uint32_t bits = 0, axis, k;
    for (axis = 0; axis < 3u; axis++) {
        some = some & (nook_lanes_at(b->low[axis]) <= nook_lanes_of(nook_along(&high, axis)));
        some = some & (nook_lanes_at(b->high[axis]) >= nook_lanes_of(nook_along(&low, axis)));
    }
    for (k = 0; k < NOOK_LANES; k++) bits |= (uint32_t)nook_flag(some, k) << k;
    return bits;
}

/* Bits 4 i + j of pairs: place i of the leaf and place j of the node have boxes that overlap, and i comes first. */
NOOK_APART static bool find_pairs(nook_intersections *q) {
    uint32_t nt = q->bvh->view.nt, i, j, k, axis, first = 4u * q->leaf, second = 4u * q->descent.node;
    nook_point low[4], high[4], a, b;
    q->pairs = 0;
    for (i = 0; i < 4u; i++) {
        if (!box_at(q->bvh, first + i, &low[i], &high[i])) return false;
    }
    for (j = 0; j < 4u; j += NOOK_LANES) {
        bundle boxes;
        for (k = 0; k < NOOK_LANES; k++) {
            if (!box_at(q->bvh, second + j + k, &a, &b)) return false;
            for (axis = 0; axis < 3u; axis++) {
                boxes.low[axis][k] = nook_along(&a, axis);
                boxes.high[axis][k] = nook_along(&b, axis);
            }
        }
        for (i = 0; i < 4u; i++) q->pairs |= overlapping(&boxes, low[i], high[i]) << (4u * i + j);
    }
    for (i = 0; i < 16u; i++) {
        uint32_t one = first + (i >> 2), other = second + (i & 3u);
        if (one >= other || other >= nt) q->pairs &= ~((uint32_t)1 << i);
    }
    return true;
}

/* The next of the pairs that intersects. */
NOOK_APART static bool next_pair(nook_intersections *q) {
    while (q->pairs != 0) {
        uint32_t i = 0, t, u;
        while ((q->pairs >> i & 1u) == 0) i++;
        q->pairs &= q->pairs - 1u;
        t = nook_triangle_at(q->bvh, 4u * q->leaf + (i >> 2));
        u = nook_triangle_at(q->bvh, 4u * q->descent.node + (i & 3u));
        if (!nook_triangles_intersect(&q->bvh->view, t, u)) continue;
        q->t = t < u ? t : u;
        q->u = t < u ? u : t;
        q->count++;
        return true;
    }
    return false;
}

/* A leaf before this one has seen this one already, and so have all below a group that ends before. */
static bool comes_before(const nook_intersections *q) {
    return (q->descent.node + 1u) << 2u * q->descent.level <= q->leaf;
}

nook_status nook_intersections_step(nook_intersections *q, uint32_t *units) {
    uint32_t nt = q->bvh->view.nt;
    nook_descent *d = &q->descent;
    for (;;) {
        bool more;
        if (next_pair(q)) return NOOK_TRIANGLE;
        more = nook_descent_next(d, nt, NOOK_UP);
        if (!more && q->leaf + 1u == (nt + 3u) / 4u) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            begin_leaf(q);
        } else if (comes_before(q)) {
            nook_descent_leave(d);
        } else if (d->level != 0) {
            visit_group(d, q->bvh, q->low, q->high);
        } else if (find_pairs(q)) {
            nook_descent_leave(d);
        } else {
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
    uint32_t v = m->V[nook_next(q->corner)], w = m->V[nook_prev(q->corner)], x = m->V[c];
    return m->C[x] == c && x != v && x != w && is_within(q, m->G[v], m->G[w], m->G[x]);
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
