/* nook_flood.c -- three ways across edges. */
#include "walk/nook_flood.h"

#include <string.h>

/* The corner across the edge of c, or NOOK_NONE at a border and where O names none. */
static uint32_t across(const nook_view *m, uint32_t c) {
    uint32_t o = m->O[c];
    return o == c || o >= 3u * m->nt ? NOOK_NONE : o;
}

/* ---- depth ---------------------------------------------------------------------------------------- */

enum { CLEAR, ROOTS, LOOK, LEAVE };

nook_status nook_flood_begin(nook_flood *f, const nook_view *view, const nook_marks *marks, uint32_t seed) {
    if (f == NULL || view == NULL || marks == NULL || marks->Mt == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt) return NOOK_NO_CAPACITY;
    if (seed != NOOK_NONE && seed >= view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    memset(f, 0, sizeof *f);
    f->view = view;
    f->marks = *marks;
    f->root = seed == NOOK_NONE ? 0 : seed;
    f->last = seed == NOOK_NONE ? view->nt : seed + 1u;
    f->component = NOOK_NONE;
    return NOOK_OK;
}

/* Codes: 1 to 3 for the corner a triangle was entered by, 4 for the first of a component. */
static nook_status enter(nook_flood *f, uint32_t c, uint32_t code) {
    nook_set_code(f->marks.Mt, nook_triangle(c), code);
    f->corner = c;
    f->phase = LOOK;
    return NOOK_TRIANGLE;
}

static nook_status try_root(nook_flood *f) {
    uint32_t t = f->root++;
    if (nook_code(f->marks.Mt, t) != 0) return NOOK_OK;
    f->component++;
    f->c = 3u * t;
    return enter(f, 3u * t, 4);
}

/* Where the search goes on in the triangle of corner c, where c is what it looks across next; a first triangle
 * is left when it comes round. */
static void go_on(nook_flood *f, uint32_t c) {
    uint32_t t = nook_triangle(c);
    bool round = c == 3u * t && nook_code(f->marks.Mt, t) == 4u;
    f->c = c;
    f->phase = round ? LEAVE : LOOK;
}

/* One hop: across the edge of c into a new triangle, or on to the next corner, or back to where this one was
 * entered from. */
static nook_status hop(nook_flood *f) {
    uint32_t c = f->c, t = nook_triangle(c), code = nook_code(f->marks.Mt, t), o = across(f->view, c);
    f->hops++;
    if (f->phase == LEAVE) {
        f->phase = ROOTS;
    } else if (c - 3u * t + 1u == code) {
        if (o == NOOK_NONE || nook_code(f->marks.Mt, nook_triangle(o)) == 0) return NOOK_BAD_OPPOSITE;
        go_on(f, nook_next(o));
    } else if (o != NOOK_NONE && nook_code(f->marks.Mt, nook_triangle(o)) == 0) {
        f->c = nook_next(o);
        return enter(f, o, 1u + o - 3u * nook_triangle(o));
    } else {
        go_on(f, nook_next(c));
    }
    return NOOK_OK;
}

nook_status nook_flood_step(nook_flood *f, uint32_t *units) {
    for (;;) {
        nook_status status = NOOK_OK;
        if (f->phase == CLEAR && f->at == NOOK_MT_BYTES(f->view->nt)) f->phase = ROOTS;
        if (f->phase == ROOTS && f->root == f->last) return NOOK_OK;
        if (f->hops == 4u * f->view->nt) return NOOK_BAD_OPPOSITE;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (f->phase == CLEAR) {
            f->marks.Mt[f->at++] = 0;
        } else {
            status = f->phase == ROOTS ? try_root(f) : hop(f);
        }
        if (status != NOOK_OK) return status;
    }
}

uint32_t nook_flood_new_vertices(const nook_flood *f, uint8_t *Mv, uint32_t v[3]) {
    uint32_t c = f->corner, i, n = 0;
    for (i = 0; i < 3u; i++, c = nook_next(c)) {
        uint32_t w = f->view->V[c];
        if (w >= f->view->nv || nook_bit(Mv, w)) continue;
        nook_set_bit(Mv, w);
        v[n++] = w;
    }
    return n;
}

/* ---- rings ---------------------------------------------------------------------------------------- */

nook_status nook_rings_begin(nook_rings *r, const nook_view *view, uint32_t seed, nook_index *distance,
                             nook_index *queue) {
    if (r == NULL || view == NULL || distance == NULL || queue == NULL) return NOOK_NULL_ARGUMENT;
    if (seed >= view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    memset(r, 0, sizeof *r);
    r->view = view;
    r->distance = distance;
    r->queue = queue;
    r->seed = seed;
    return NOOK_OK;
}

static void reach(nook_rings *r, uint32_t t, uint32_t distance) {
    if (r->distance[t] != NOOK_STORED_NONE) return;
    r->distance[t] = nook_store(distance);
    r->queue[r->tail++] = nook_store(t);
}

/* distance is cleared up to at; then the queue is worked off. */
nook_status nook_rings_step(nook_rings *r, uint32_t *units) {
    uint32_t nt = r->view->nt;
    for (; r->at < nt || r->head < r->tail; --*units) {
        if (*units == 0) return NOOK_MORE;
        if (r->at < nt) {
            r->distance[r->at++] = NOOK_STORED_NONE;
            if (r->at == nt) reach(r, r->seed, 0);
        } else {
            uint32_t t = r->queue[r->head++], i;
            for (i = 0; i < 3u; i++) {
                uint32_t o = across(r->view, 3u * t + i);
                if (o != NOOK_NONE) reach(r, nook_triangle(o), r->distance[t] + 1u);
            }
        }
    }
    return NOOK_OK;
}

/* ---- sets ----------------------------------------------------------------------------------------- */

enum { ALONE, UNITE, CLIMB, FLATTEN, NUMBER, FINISHED };

nook_status nook_components_begin(nook_components *s, const nook_view *view, nook_index *component) {
    if (s == NULL || view == NULL || component == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->view = view;
    s->component = component;
    return NOOK_OK;
}

/* One step up from t, which from now on points to where its way leads after two. */
static uint32_t climb(nook_index *up, uint32_t t) {
    up[t] = up[up[t]];
    return up[t];
}

static bool is_root(const nook_components *s, uint32_t t) { return s->component[t] == t; }

/* Every triangle is in the set of a smaller one or its own; two sets become that of the smaller root. */
static void unite(nook_components *s) {
    uint32_t c = s->at, o = across(s->view, c);
    if (s->phase == UNITE) {
        s->at++;
        if (o == NOOK_NONE || o < c) return;
        s->one = nook_triangle(c);
        s->other = nook_triangle(o);
        s->phase = CLIMB;
    } else if (!is_root(s, s->one)) {
        s->one = climb(s->component, s->one);
    } else if (!is_root(s, s->other)) {
        s->other = climb(s->component, s->other);
    } else {
        uint32_t low = s->one < s->other ? s->one : s->other, high = s->one + s->other - low;
        s->component[high] = nook_store(low);
        s->phase = UNITE;
    }
}

/* In ascending order everything points to what is settled already. */
static void settle(nook_components *s) {
    nook_index *up = s->component;
    uint32_t t = s->at++;
    if (s->phase == ALONE) {
        up[t] = nook_store(t);
    } else if (s->phase == NUMBER && up[t] == t) {
        up[t] = nook_store(s->count++);
    } else {
        up[t] = up[up[t]];
    }
}

nook_status nook_components_step(nook_components *s, uint32_t *units) {
    while (s->phase != FINISHED) {
        uint32_t end = s->phase == UNITE ? 3u * s->view->nt : s->view->nt;
        if (s->phase != CLIMB && s->at == end) {
            s->at = 0;
            s->phase = s->phase == UNITE ? FLATTEN : s->phase + 1u;
            continue;
        }
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->phase == UNITE || s->phase == CLIMB) {
            unite(s);
        } else {
            settle(s);
        }
    }
    return NOOK_OK;
}
