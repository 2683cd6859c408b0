/* nook_intersections.c -- each triangle, and each border edge, against the tree. */
#include "query/nook_intersections.h"

#include "query/nook_pair.h"

static void set_cells(const nook_bvh *bvh, nook_point low, nook_point high, nook_bound from[3],
                      nook_bound to[3]) {
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        from[axis] = (nook_bound)nook_cell(bvh, (&low.x)[axis], axis);
        to[axis] = (nook_bound)nook_cell(bvh, (&high.x)[axis], axis);
    }
}

/* Which children's boxes overlap one in cells. */
static void visit_group(nook_descent *d, const nook_bvh *bvh, const nook_bound low[3],
                        const nook_bound high[3]) {
    const nook_boxes *g = nook_descent_boxes(d, bvh);
    uint32_t apart[4] = {0, 0, 0, 0}, entry[4], axis, i;
    for (axis = 0; axis < 3u; axis++) {
        for (i = 0; i < 4u; i++) {
            apart[i] |= (uint32_t)(g->low[axis][i] > high[axis]) | (uint32_t)(g->high[axis][i] < low[axis]);
        }
    }
    for (i = 0; i < 4u; i++) entry[i] = apart[i] != 0 ? NOOK_UP : i;
    nook_descent_push(d, entry);
}

/* ---- pairs ---------------------------------------------------------------------------------------- */

static bool begin_triangle(nook_intersections *q) {
    const nook_point *p[3];
    nook_point low, high;
    if (!nook_points_of(q->bvh, q->t, p)) return false;
    nook_box(&q->bvh->view, q->t, &low, &high);
    set_cells(q->bvh, low, high, q->low, q->high);
    nook_descent_begin(&q->descent, q->bvh->view.nt);
    return true;
}

nook_status nook_intersections_begin(nook_intersections *q, const nook_bvh *bvh) {
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    memset(q, 0, sizeof *q);
    q->bvh = bvh;
    q->t = NOOK_NONE;
    q->descent.now = NOOK_UP;
    return NOOK_OK;
}

/* The triangles of a leaf from next on, up to one that t intersects. */
static nook_status visit_leaf(nook_intersections *q) {
    uint32_t first = 4u * q->descent.node, nt = q->bvh->view.nt;
    while (q->next < 4u && first + q->next < nt) {
        uint32_t u = nook_triangle_at(q->bvh, first + q->next++);
        const nook_point *p[3];
        if (!nook_points_of(q->bvh, u, p)) return NOOK_INDEX_OUT_OF_RANGE;
        if (u <= q->t || !nook_triangles_intersect(&q->bvh->view, q->t, u)) continue;
        q->u = u;
        q->count++;
        return NOOK_TRIANGLE;
    }
    q->next = 0;
    nook_descent_leave(&q->descent);
    return NOOK_OK;
}

nook_status nook_intersections_step(nook_intersections *q, uint32_t *units) {
    uint32_t nt = q->bvh->view.nt;
    for (;;) {
        nook_status status = NOOK_OK;
        bool more = nook_descent_next(&q->descent, nt, NOOK_UP);
        if (!more && q->t + 1u >= nt) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            q->t++;
            if (!begin_triangle(q)) status = NOOK_INDEX_OUT_OF_RANGE;
        } else if (q->descent.level != 0) {
            visit_group(&q->descent, q->bvh, q->low, q->high);
        } else {
            status = visit_leaf(q);
        }
        if (status != NOOK_OK) return status;
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
    nook_descent_begin(&q->descent, m->nt);
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
