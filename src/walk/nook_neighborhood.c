/* nook_neighborhood.c -- rings by stars: a queue of vertices, worked off star by star. */
#include "walk/nook_neighborhood.h"

#include <string.h>

nook_status nook_neighborhood_begin(nook_neighborhood *n, const nook_view *view, const nook_marks *marks,
                                    nook_index *queue, nook_where seed) {
    uint32_t end = seed.kind == NOOK_AT_VERTEX   ? view->nv
                   : seed.kind == NOOK_AT_CORNER ? 3u * view->nt
                                                 : view->nt;
    if (marks->Mt == NULL || marks->Mv == NULL || queue == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt || marks->max_nv < view->nv) return NOOK_NO_CAPACITY;
    if (seed.index >= end) return NOOK_INDEX_OUT_OF_RANGE;
    memset(n, 0, sizeof *n);
    n->star.view = view;
    n->star.next = NOOK_NONE;
    n->marks = *marks;
    n->queue = queue;
    n->seed = seed;
    return NOOK_OK;
}

static void reach(nook_neighborhood *n, uint32_t v) {
    if (v >= n->star.view->nv || nook_bit(n->marks.Mv, v)) return;
    nook_set_bit(n->marks.Mv, v);
    n->queue[n->tail++] = nook_store(v);
}

static void reach_seed(nook_neighborhood *n) {
    const nook_index *V = n->star.view->V;
    uint32_t c = n->seed.kind == NOOK_AT_TRIANGLE ? 3u * n->seed.index : n->seed.index;
    if (n->seed.kind == NOOK_AT_VERTEX) {
        reach(n, c);
    } else {
        reach(n, V[nook_next(c)]);
        reach(n, V[nook_prev(c)]);
        if (n->seed.kind == NOOK_AT_TRIANGLE) reach(n, V[c]);
    }
}

/* The marks up to at; then the seed. */
static void clear(nook_neighborhood *n, uint32_t mt, uint32_t mv) {
    if (n->at < mt) n->marks.Mt[n->at] = 0;
    if (n->at < mv) n->marks.Mv[n->at] = 0;
    if (++n->at == (mt > mv ? mt : mv)) reach_seed(n);
}

/* The next vertex of the queue; the first of a ring's vertices begins a ring. */
static nook_status next_star(nook_neighborhood *n) {
    uint32_t c;
    if (n->head == n->ring_end) {
        n->ring++;
        n->ring_end = n->tail;
    }
    c = nook_corner_of(n->star.view, n->queue[n->head++]);
    if (c == NOOK_NONE) return NOOK_OK;
    return nook_star_begin(&n->star, n->star.view, c, false) == NOOK_OK ? NOOK_OK : NOOK_BAD_OPPOSITE;
}

/* A corner has its bit in Mt, so that stars which run into each other end. */
static nook_status visit(nook_neighborhood *n) {
    uint32_t c = nook_star_next(&n->star);
    bool met;
    if (c == NOOK_NONE || nook_bit(n->marks.Mt, c)) return NOOK_BAD_OPPOSITE;
    met = nook_code(n->marks.Mt, nook_triangle(c)) != 0;
    nook_set_bit(n->marks.Mt, c);
    if (met) return NOOK_OK;
    reach(n, n->star.view->V[nook_next(c)]);
    reach(n, n->star.view->V[nook_prev(c)]);
    n->corner = c;
    return NOOK_TRIANGLE;
}

nook_status nook_neighborhood_step(nook_neighborhood *n, uint32_t *units) {
    uint32_t mt = (uint32_t)NOOK_MT_BYTES(n->star.view->nt), mv = (uint32_t)NOOK_MV_BYTES(n->star.view->nv);
    uint32_t end = mt > mv ? mt : mv;
    while (n->at < end || n->star.next != NOOK_NONE || n->head < n->tail) {
        nook_status status = NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (n->at < end) {
            clear(n, mt, mv);
        } else {
            status = n->star.next != NOOK_NONE ? visit(n) : next_star(n);
        }
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}
