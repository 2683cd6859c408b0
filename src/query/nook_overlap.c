/* nook_overlap.c -- down the tree where boxes meet one. */
#include "query/nook_overlap.h"

#include "query/nook_lanes.h"

nook_status nook_overlap_begin(nook_overlap *q, const nook_bvh *bvh, nook_point low, nook_point high) {
    nook_status status = nook_bvh_status(bvh);
    if (q == NULL) return NOOK_NULL_ARGUMENT;
    if (status != NOOK_OK) return status;
    memset(q, 0, sizeof *q);
    q->bvh = bvh;
    q->low = low;
    q->high = high;
    nook_set_cells(bvh, low, high, q->from, q->to);
    nook_descent_begin(&q->descent, bvh);
    return NOOK_OK;
}

static bool is_here(const nook_overlap *q, const nook_point *const p[3]) {
    nook_point low = nook_low(nook_low(*p[0], *p[1]), *p[2]),
               high = nook_high(nook_high(*p[0], *p[1]), *p[2]);
    return low.x <= q->high.x && low.y <= q->high.y && low.z <= q->high.z && high.x >= q->low.x &&
           high.y >= q->low.y && high.z >= q->low.z;
}

/* The places of a leaf from next on, up to one that is here. */
static nook_status visit_leaf(nook_overlap *q) {
    const nook_point *p[3];
    while (q->next < 4u && 4u * q->descent.node + q->next < q->bvh->view.nt) {
        q->t = nook_triangle_at(q->bvh, 4u * q->descent.node + q->next++);
        if (!nook_points_of(q->bvh, q->t, p)) return NOOK_INDEX_OUT_OF_RANGE;
        if (is_here(q, p)) return NOOK_TRIANGLE;
    }
    q->next = 0;
    nook_descent_leave(&q->descent);
    return NOOK_OK;
}

nook_status nook_overlap_step(nook_overlap *q, uint32_t *units) {
    nook_descent *d = &q->descent;
    while (nook_descent_next(d, q->bvh->places, NOOK_UP)) {
        nook_status status = NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (d->level != 0) {
            nook_visit_overlap(d, q->bvh, q->from, q->to, 0);
        } else {
            status = visit_leaf(q);
        }
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}
