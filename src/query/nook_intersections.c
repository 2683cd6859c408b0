/* nook_intersections.c -- each triangle, and each border edge, against the tree. */
#include "query/nook_intersections.h"

#include "query/nook_apart.h"
#include "query/nook_pair.h"

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

/* Some triangles from a place on, beyond the end the last one again; false where order or V name nothing that there is. */
static bool gather(const nook_bvh *bvh, uint32_t place, nook_several *to) {
    const nook_index *V = bvh->view.V;
    nook_some s;
    uint32_t i;
    if (!nook_gather(bvh, place, &s)) return false;
    for (i = 0; i < 3u; i++) {
#if NOOK_LANES > 1
        const nook_flags name = {(int32_t)V[3u * s.t[0] + i], (int32_t)V[3u * s.t[1] + i],
                                 (int32_t)V[3u * s.t[2] + i], (int32_t)V[3u * s.t[3] + i]};
        to->v[i] = name;
#else
        to->v[i] = (int32_t)V[3u * s.t[0] + i];
#endif
        to->p[i] = nook_some_corners(&s, i);
    }
    to->low = nook_lowest(to->p);
    to->high = nook_highest(to->p);
#if NOOK_LANES > 1
    nook_set_normal(to);
#endif
    return true;
}

#if NOOK_LANES > 1
/* Which of some pairs of triangle i of a and others floats cannot tell apart. */
static uint32_t still_open(const nook_several *a, uint32_t i, const nook_several *b, nook_lanes reach,
                           uint32_t some) {
    nook_several one;
    nook_spread_plane(a, i, &one);
    some &= ~nook_bits(nook_is_on_one_side(&one, b, reach));
    if (some == 0) return 0;
    nook_spread_corners(a, i, &one);
    some &= ~nook_bits(nook_is_on_one_side(b, &one, reach));
    if (some == 0) return 0;
    some &= ~nook_bits(nook_is_beside(&one, b, reach));
    return some == 0 ? 0 : some & ~nook_bits(nook_is_beside(b, &one, reach));
}

/* Which of some pairs of triangle i of a and others may intersect. */
static uint32_t may_meet(const nook_several *a, uint32_t i, const nook_several *b, uint32_t some) {
    nook_vectors low = nook_spread(&a->low, i), high = nook_spread(&a->high, i), most;
    some &= nook_bits((b->low.x <= high.x) & (b->low.y <= high.y) & (b->low.z <= high.z) &
                      (b->high.x >= low.x) & (b->high.y >= low.y) & (b->high.z >= low.z));
    if (some == 0) return 0;
    most = nook_vectors_sub(nook_vectors_larger(high, b->high), nook_vectors_smaller(low, b->low));
    return still_open(a, i, b, nook_most(most), some);
}
#else
/* One by one, nook_pair.h is as quick. */
static uint32_t may_meet(const nook_several *a, uint32_t i, const nook_several *b, uint32_t some) {
    (void)i;
    if (some == 0 || b->low.x > a->high.x || b->low.y > a->high.y || b->low.z > a->high.z) return 0;
    return b->high.x >= a->low.x && b->high.y >= a->low.y && b->high.z >= a->low.z;
}
#endif

/* The leaf that is held against the tree, gathered once for many others. */
typedef struct leaf {
    uint32_t leaf;
    nook_several at[4 / NOOK_LANES];
} leaf;

/* Bits 4 i + k: place i of the leaf and place k of the node; each pair once, and none beyond the end. */
static uint32_t pairs_of(const nook_intersections *q) {
    uint32_t left = q->bvh->view.nt - 4u * q->descent.node,
             pairs = left < 4u ? 0x1111u * ((1u << left) - 1u) : 0xFFFFu;
    return q->leaf == q->descent.node ? pairs & 0x08CEu : pairs;
}

/* Those that may intersect. */
static bool find_pairs(nook_intersections *q, leaf *own) {
    uint32_t i, j, pairs = pairs_of(q), some = (1u << NOOK_LANES) - 1u;
    for (i = 0; own->leaf != q->leaf && i < 4u; i += NOOK_LANES) {
        if (!gather(q->bvh, 4u * q->leaf + i, &own->at[i / NOOK_LANES])) return false;
    }
    own->leaf = q->leaf;
    for (j = 0; j < 4u; j += NOOK_LANES) {
        nook_several b;
        if (!gather(q->bvh, 4u * q->descent.node + j, &b)) return false;
        for (i = 0; i < 4u; i++) {
            uint32_t at = 4u * i + j;
            q->pairs |= may_meet(&own->at[i / NOOK_LANES], i % NOOK_LANES, &b, pairs >> at & some) << at;
        }
    }
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

/* On to two leaves with pairs that may intersect: NOOK_TRIANGLE, or what step returns. */
NOOK_APART static nook_status search(nook_intersections *q, uint32_t *units) {
    uint32_t nt = q->bvh->view.nt;
    nook_descent *d = &q->descent;
    leaf own;
    own.leaf = NOOK_NONE;
    while (q->pairs == 0) {
        bool more = nook_descent_next(d, q->bvh->places, NOOK_UP);
        if (!more && q->leaf + 1u == (nt + 3u) / 4u) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            begin_leaf(q);
        } else if (d->level != 0) { /* what ends before this leaf has met it already */
            nook_visit_overlap(d, q->bvh, q->low, q->high, q->leaf >> 2u * (d->level - 1u));
        } else {
            nook_descent_leave(d);
            if (!find_pairs(q, &own)) return NOOK_INDEX_OUT_OF_RANGE;
        }
    }
    return NOOK_TRIANGLE;
}

nook_status nook_intersections_step(nook_intersections *q, uint32_t *units) {
    for (;;) {
        nook_status status = next_pair(q);
        if (status != NOOK_OK) return status;
        status = search(q, units);
        if (status != NOOK_TRIANGLE) return status;
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
    nook_set_cells(q->bvh, low, high, q->low, q->high);
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
        bool more = nook_descent_next(&q->descent, q->bvh->places, NOOK_UP);
        if (!more && q->corner + 1u >= 3u * nt) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!more) {
            q->corner++;
            if (!begin_edge(q)) status = NOOK_INDEX_OUT_OF_RANGE;
        } else if (q->descent.level != 0) {
            nook_visit_overlap(&q->descent, q->bvh, q->low, q->high, 0);
        } else {
            status = visit_corners(q);
        }
        if (status != NOOK_OK) return status;
    }
}
