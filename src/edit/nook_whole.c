/* nook_whole.c -- the passes of nook_whole.h. */
#include "edit/nook_whole.h"

#include "edit/nook_inner.h"

/* ---- reverse --------------------------------------------------------------------------------------- */

nook_status nook_reverse_begin(nook_reverse *r, nook_mesh *mesh, const nook_index *component, uint32_t which,
                               const nook_edit *edit) {
    if (mesh == NULL) return NOOK_NULL_ARGUMENT;
    r->mesh = mesh;
    r->edit = edit;
    r->component = component;
    r->which = which;
    r->t = r->phase = 0;
    return NOOK_OK;
}

static bool is_chosen(const nook_reverse *r, uint32_t t) {
    return r->component == NULL || r->component[t] == r->which;
}

static nook_status look_at(const nook_reverse *r, uint32_t t) {
    nook_status status = nook_triangle_status(r->mesh, 3u * t);
    uint32_t c;
    if (status != NOOK_OK) return status;
    for (c = 3u * t; c < 3u * t + 3u; c++) {
        if (!is_chosen(r, nook_triangle(r->mesh->O[c]))) return NOOK_INCOHERENT_EDGE;
    }
    return NOOK_OK;
}

/* The name of corner c when all is reversed. */
static uint32_t turned(uint32_t c) {
    uint32_t first = 3u * nook_triangle(c);
    return c == first ? c : 2u * first + 3u - c;
}

/* Each opposite is renamed where it stands, and it stands at the corner that takes the other's place. */
void nook_turn_over(nook_mesh *m, uint32_t t, const nook_edit *edit) {
    uint32_t c = 3u * t + 1u, v = m->V[c], w = m->V[c + 1u], x = m->O[c], y = m->O[c + 1u];
    m->O[3u * t] = nook_store(turned(m->O[3u * t]));
    m->O[c] = nook_store(turned(y));
    m->O[c + 1u] = nook_store(turned(x));
    m->V[c] = nook_store(w);
    m->V[c + 1u] = nook_store(v);
    if (m->C[v] == c) m->C[v] = nook_store(c + 1u);
    if (m->C[w] == c + 1u) m->C[w] = nook_store(c);
    nook_swap_attributes(edit, c, c + 1u);
}

nook_status nook_reverse_step(nook_reverse *r, uint32_t *units) {
    for (; r->phase < 2u; r->phase++, r->t = 0) {
        for (; r->t < r->mesh->nt; r->t++) {
            nook_status status;
            if (*units == 0) return NOOK_MORE;
            --*units;
            if (!is_chosen(r, r->t)) continue;
            status = r->phase == 0 ? look_at(r, r->t) : NOOK_OK;
            if (status != NOOK_OK) return status;
            if (r->phase == 1u) nook_turn_over(r->mesh, r->t, r->edit);
        }
    }
    return NOOK_OK;
}

/* ---- split of vertices ----------------------------------------------------------------------------- */

enum { CLEAR, COUNT, CLEAR_AGAIN, SPLIT, ALL };

nook_status nook_split_fans_begin(nook_split_fans *s, nook_mesh *mesh, const nook_marks *marks,
                                  const nook_edit *edit) {
    if (mesh == NULL || marks == NULL || marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->mesh = mesh;
    s->edit = edit;
    s->marks = *marks;
    s->x = NOOK_NONE;
    return marks->max_nt < mesh->nt || marks->max_nv < mesh->nv ? NOOK_NO_CAPACITY : NOOK_OK;
}

/* A byte of both marks. */
static void clear(nook_split_fans *s) {
    size_t of_t = NOOK_MT_BYTES(s->mesh->nt), of_v = NOOK_MV_BYTES(s->mesh->nv);
    if (s->at < of_t) s->marks.Mt[s->at] = 0;
    if (s->at < of_v) s->marks.Mv[s->at] = 0;
    if (++s->at >= of_t && s->at >= of_v) s->phase++, s->at = 0;
}

/* Corner c leads a fan if it is in none before; the fan keeps its vertex if it is the first there. */
static nook_status lead(nook_split_fans *s, uint32_t c) {
    nook_mesh *m = s->mesh;
    nook_view view = nook_view_of(m);
    uint32_t v = m->V[c];
    bool first;
    if (nook_bit(s->marks.Mt, c)) return NOOK_OK;
    if (v >= m->nv) return NOOK_INDEX_OUT_OF_RANGE;
    first = !nook_bit(s->marks.Mv, v);
    nook_set_bit(s->marks.Mv, v);
    s->more += !first;
    s->v = first ? v : m->nv;
    s->x = c;
    s->other = nook_turn(&view, c, true);
    s->clockwise = false;
    if (s->phase != (uint32_t)SPLIT) return NOOK_OK;
    if (first) {
        m->C[v] = nook_store(c);
    } else {
        nook_add_vertex(m, m->G[v], c, s->edit);
        nook_copied(s->edit, v, s->v);
    }
    return NOOK_OK;
}

static bool is_new(const nook_split_fans *s, uint32_t c) {
    return c != NOOK_NONE && !nook_bit(s->marks.Mt, c);
}

/* Turn on from a corner, and only then give it its vertex; where there is no way on, from the first the other way. When the
 * fan is closed all are marked by then. */
static void turn_on(nook_split_fans *s) {
    nook_view view = nook_view_of(s->mesh);
    uint32_t x = s->x;
    s->x = nook_turn(&view, x, s->clockwise);
    nook_set_bit(s->marks.Mt, x);
    if (s->phase == (uint32_t)SPLIT) s->mesh->V[x] = nook_store(s->v);
    if (!is_new(s, s->x) && !s->clockwise) {
        s->x = s->other;
        s->clockwise = true;
    }
    if (!is_new(s, s->x)) s->x = NOOK_NONE;
}

/* The same walk twice: it depends on O, marks, and V where that is not renamed yet. */
nook_status nook_split_fans_step(nook_split_fans *s, uint32_t *units) {
    while (s->phase != (uint32_t)ALL) {
        nook_status status = NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->phase == (uint32_t)CLEAR || s->phase == (uint32_t)CLEAR_AGAIN) {
            clear(s);
        } else if (s->x != NOOK_NONE) {
            turn_on(s);
        } else if (s->at < 3u * s->mesh->nt) {
            status = lead(s, s->at++);
        } else if (s->phase == (uint32_t)COUNT && s->more > s->mesh->max_nv - s->mesh->nv) {
            status = NOOK_NO_CAPACITY;
        } else {
            s->more = s->phase == (uint32_t)COUNT ? 0 : s->more;
            s->at = 0;
            s->phase++;
        }
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}

/* ---- reorder --------------------------------------------------------------------------------------- */

nook_status nook_reorder_begin(nook_reorder *r, nook_mesh *mesh, nook_index *order, const nook_edit *edit) {
    if (mesh == NULL || order == NULL) return NOOK_NULL_ARGUMENT;
    r->mesh = mesh;
    r->order = order;
    r->edit = edit;
    r->first = r->at = 0;
    return NOOK_OK;
}

/* The name of corner c when triangles t and u have changed places. */
static uint32_t exchanged(uint32_t c, uint32_t t, uint32_t u) {
    uint32_t of = nook_triangle(c);
    return of == t ? c - 3u * t + 3u * u : of == u ? c - 3u * u + 3u * t : c;
}

/* All that names a corner of t or u first, then what stands at them. */
static void exchange(const nook_reorder *r, uint32_t t, uint32_t u) {
    nook_mesh *m = r->mesh;
    uint32_t i, c, d, o[6], v[6];
    bool stands[6];
    for (i = 0; i < 6u; i++) {
        c = i < 3u ? 3u * t + i : 3u * u + i - 3u;
        o[i] = m->O[c];
        v[i] = m->V[c];
        stands[i] = v[i] < m->nv && m->C[v[i]] == c;
    }
    for (i = 0; i < 6u; i++) {
        c = i < 3u ? 3u * t + i : 3u * u + i - 3u;
        d = exchanged(c, t, u);
        m->V[d] = nook_store(v[i]);
        m->O[d] = nook_store(exchanged(o[i], t, u));
        if (nook_triangle(o[i]) != t && nook_triangle(o[i]) != u && o[i] < 3u * m->nt)
            m->O[o[i]] = nook_store(d);
        if (stands[i]) m->C[v[i]] = nook_store(d);
    }
    for (i = 0; i < 3u; i++) nook_swap_attributes(r->edit, 3u * t + i, 3u * u + i);
    nook_swap_color(r->edit, t, u);
}

/* Along a cycle: what belongs at this place comes here, and what stood here goes on to where that was. */
nook_status nook_reorder_step(nook_reorder *r, uint32_t *units) {
    while (r->first < r->mesh->nt) {
        uint32_t at = r->at, next = r->order[at];
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (next >= r->mesh->nt) return NOOK_INDEX_OUT_OF_RANGE;
        r->order[at] = nook_store(at);
        if (next == r->first) {
            r->at = ++r->first;
        } else if (next == at) {
            return NOOK_INDEX_OUT_OF_RANGE;
        } else {
            exchange(r, at, next);
            r->at = next;
        }
    }
    return NOOK_OK;
}
