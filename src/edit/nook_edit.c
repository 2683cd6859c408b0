/* nook_edit.c -- the tools of nook_inner.h. */
#include "edit/nook_edit.h"

#include "edit/nook_inner.h"
#include "query/nook_descent.h"

/* ---- looking -------------------------------------------------------------------------------------- */

nook_status nook_triangle_status(const nook_mesh *m, uint32_t c) {
    uint32_t i;
    if (c >= 3u * m->nt) return NOOK_INDEX_OUT_OF_RANGE;
    for (i = 0; i < 3u; i++, c = nook_next(c)) {
        if (m->O[c] >= 3u * m->nt || m->O[m->O[c]] != c || m->V[c] >= m->nv) return NOOK_BAD_OPPOSITE;
    }
    return NOOK_OK;
}

nook_status nook_edge_status(const nook_mesh *m, uint32_t c) {
    nook_status status = nook_triangle_status(m, c);
    return status != NOOK_OK ? status : nook_triangle_status(m, m->O[c]);
}

nook_status nook_ring_begin(nook_ring *ring, const nook_view *m, uint32_t c) {
    ring->c = NOOK_NONE;
    return nook_star_begin(&ring->star, m, c, false);
}

uint32_t nook_ring_next(nook_ring *ring) {
    uint32_t last = ring->c;
    ring->c = nook_star_next(&ring->star);
    if (ring->c != NOOK_NONE) return ring->star.view->V[nook_next(ring->c)];
    return last != NOOK_NONE && ring->star.open ? ring->star.view->V[nook_prev(last)] : NOOK_NONE;
}

bool nook_is_joined(const nook_view *m, uint32_t c, uint32_t v) {
    nook_ring ring;
    uint32_t w = NOOK_NONE;
    if (nook_ring_begin(&ring, m, c) != NOOK_OK) return true;
    do {
        w = nook_ring_next(&ring);
    } while (w != NOOK_NONE && w != v);
    return w == v;
}

bool nook_is_at_border(const nook_view *m, uint32_t c) {
    nook_star star;
    return nook_star_begin(&star, m, c, false) == NOOK_OK && star.open;
}

/* ---- conditions ----------------------------------------------------------------------------------- */

uint32_t nook_count_fan(const nook_view *m, uint32_t c, const nook_edit *edit) {
    uint32_t n = 1, x = nook_turn(m, c, false),
             most = edit->max_valence < m->nt ? edit->max_valence + 4u : m->nt;
    for (; x != NOOK_NONE && x != c && n <= most; x = nook_turn(m, x, false)) n++;
    if (x != NOOK_NONE) return n;
    for (x = nook_turn(m, c, true); x != NOOK_NONE && n <= most; x = nook_turn(m, x, true)) n++;
    return n;
}

bool nook_has_room(const nook_view *m, uint32_t c, uint32_t more, const nook_edit *edit) {
    if (edit == NULL || edit->max_valence == 0) return true;
    return more <= edit->max_valence && nook_count_fan(m, c, edit) <= edit->max_valence - more;
}

bool nook_is_turned(const nook_edit *edit, const nook_point *a, const nook_point *b, const nook_point *c,
                    const nook_point *const p[4]) {
    const nook_point *const q[4] = {a, b, c, c};
    uint32_t axis;
    if (edit == NULL || !edit->no_turn || nook_compare_normals(q, p) > 0) return false;
    return nook_compare_normals(p, p) != 0 || nook_facing(a, b, c, &axis) == 0;
}

uint32_t nook_bits_that_differ(const nook_point *a, const nook_point *b) {
    return (nook_float_bits(a->x) ^ nook_float_bits(b->x)) | (nook_float_bits(a->y) ^ nook_float_bits(b->y)) |
           (nook_float_bits(a->z) ^ nook_float_bits(b->z));
}

bool nook_move_turns(const nook_mesh *m, uint32_t t, const nook_move *move, const nook_edit *edit) {
    const nook_point *old[4], *now[3];
    uint32_t i, moved = 0;
    for (i = 0; i < 3u; i++) {
        uint32_t v = m->V[3u * t + i];
        if (v >= m->nv) return true; /* no vertex at all */
        old[i] = &m->G[v];
        now[i] = v == move->v[0] ? &move->to[0] : v == move->v[1] ? &move->to[1] : old[i];
        moved |= nook_bits_that_differ(now[i], old[i]);
    }
    old[3] = old[2];
    return moved != 0 && nook_is_turned(edit, now[0], now[1], now[2], old);
}

bool nook_move_turns_fan(const nook_mesh *m, uint32_t c, const nook_move *move, uint32_t a, uint32_t b,
                         const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_star star;
    uint32_t x, t;
    (void)nook_star_begin(&star, &view, c, false);
    while ((x = nook_star_next(&star)) != NOOK_NONE) {
        t = nook_triangle(x);
        if (t != a && t != b && nook_move_turns(m, t, move, edit)) return true;
    }
    return false;
}

/* ---- what cuts ------------------------------------------------------------------------------------- */

void nook_change_begin(nook_change *g, const nook_mesh *m, uint32_t gone, uint32_t gone_too) {
    memset(g, 0, sizeof *g);
    g->view = nook_view_of(m);
    g->gone[0] = gone;
    g->gone[1] = gone_too;
    g->gone[2] = g->v[0] = g->v[1] = g->fan[0].next = g->fan[1].next = NOOK_NONE;
}

void nook_change_make(nook_change *g, const nook_point *a, const nook_point *b, const nook_point *c) {
    const nook_point **to = g->made[g->count++];
    to[0] = a, to[1] = b, to[2] = c;
}

void nook_change_fan(nook_change *g, uint32_t i, uint32_t c, const nook_point *to) {
    g->v[i] = g->view.V[c];
    g->to[i] = to;
    (void)nook_star_begin(&g->fan[i], &g->view, c, false);
}

/* ---- changing -------------------------------------------------------------------------------------- */

void nook_follow(const nook_mesh *m, const nook_edit *edit) {
    if (nook_is_guarded(edit)) edit->guard->bvh.view = nook_view_of(m);
}

void nook_follow_triangle(const nook_mesh *m, uint32_t t, const nook_edit *edit) {
    const nook_point *p[3];
    nook_follow(m, edit);
    if (nook_is_guarded(edit) && nook_points_of(&edit->guard->bvh, t, p))
        edit->guard->widen(edit->guard, t, p);
}

void nook_follow_fan(const nook_mesh *m, uint32_t c, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_star star;
    if (!nook_is_guarded(edit) || nook_star_begin(&star, &view, c, false) != NOOK_OK) return;
    while ((c = nook_star_next(&star)) != NOOK_NONE) nook_follow_triangle(m, nook_triangle(c), edit);
}

void nook_add_vertex(nook_mesh *m, nook_point at, uint32_t c, const nook_edit *edit) {
    m->G[m->nv] = at;
    m->C[m->nv++] = nook_store(c);
    nook_follow(m, edit);
}

void nook_copied(const nook_edit *edit, uint32_t from, uint32_t to) {
    if (edit != NULL && edit->copied != NULL) edit->copied(edit->user, from, to);
}

static void tell(const nook_edit *edit, nook_kind kind, uint32_t from, uint32_t to) {
    if (edit != NULL && edit->renamed != NULL) edit->renamed(edit->user, kind, from, to);
}

void nook_move_triangle(nook_mesh *m, uint32_t from, uint32_t to, const nook_edit *edit) {
    uint32_t i;
    if (from == to) return;
    for (i = 0; i < 3u; i++) {
        uint32_t c = 3u * from + i, d = 3u * to + i, v = m->V[c];
        m->V[d] = nook_store(v);
        nook_join(m, d, nook_across(m, c));
        if (v < m->nv && m->C[v] == c) m->C[v] = nook_store(d);
        nook_swap_attributes(edit, d, c);
    }
    nook_swap_color(edit, to, from);
    nook_follow_triangle(m, to, edit);
    tell(edit, NOOK_AT_TRIANGLE, from, to);
}

void nook_drop_triangle(nook_mesh *m, uint32_t t, const nook_edit *edit) {
    m->nt--;
    nook_follow(m, edit);
    nook_move_triangle(m, m->nt, t, edit);
}

void nook_drop_triangles(nook_mesh *m, uint32_t t, uint32_t u, const nook_edit *edit) {
    nook_drop_triangle(m, t > u ? t : u, edit);
    nook_drop_triangle(m, t > u ? u : t, edit);
}

/* Once round, or to both borders. Each is renamed when turning has gone on from it, and c last, so that it is known again. */
void nook_rename_fan(nook_mesh *m, uint32_t c, uint32_t v) {
    nook_view view = nook_view_of(m);
    uint32_t x, next, left = m->nt;
    if (c >= 3u * m->nt) return; /* a vertex of no triangle */
    for (x = nook_turn(&view, c, false); x != NOOK_NONE && x != c && left-- > 0; x = next) {
        next = nook_turn(&view, x, false);
        m->V[x] = nook_store(v);
    }
    for (x = x == NOOK_NONE ? nook_turn(&view, c, true) : NOOK_NONE; x != NOOK_NONE && left-- > 0; x = next) {
        next = nook_turn(&view, x, true);
        m->V[x] = nook_store(v);
    }
    m->V[c] = nook_store(v);
}

void nook_move_vertex(nook_mesh *m, uint32_t from, uint32_t to, const nook_edit *edit) {
    if (from == to) return;
    m->G[to] = m->G[from];
    m->C[to] = m->C[from];
    nook_rename_fan(m, m->C[to], to);
    tell(edit, NOOK_AT_VERTEX, from, to);
}

void nook_drop_vertex(nook_mesh *m, uint32_t v, const nook_edit *edit) {
    m->nv--;
    nook_follow(m, edit);
    nook_move_vertex(m, m->nv, v, edit);
}

void nook_drop_vertices(nook_mesh *m, uint32_t v, uint32_t w, const nook_edit *edit) {
    nook_drop_vertex(m, v > w ? v : w, edit);
    nook_drop_vertex(m, v > w ? w : v, edit);
}

/* ---- what goes along ------------------------------------------------------------------------------- */

void nook_copy_color(const nook_edit *edit, uint32_t to, uint32_t from) {
    if (edit != NULL && edit->color != NULL) edit->color[to] = edit->color[from];
}

void nook_swap_color(const nook_edit *edit, uint32_t t, uint32_t u) {
    uint8_t keep;
    if (edit == NULL || edit->color == NULL) return;
    keep = edit->color[t];
    edit->color[t] = edit->color[u];
    edit->color[u] = keep;
}

static float *attributes_of(const nook_edit *edit, uint32_t c) {
    return edit == NULL || edit->attributes == NULL ? NULL : edit->attributes + (size_t)c * edit->width;
}

void nook_copy_attributes(const nook_edit *edit, uint32_t to, uint32_t from) {
    float *at = attributes_of(edit, to);
    if (at != NULL && to != from) memcpy(at, attributes_of(edit, from), edit->width * sizeof *at);
}

void nook_new_triangle(uint32_t t, const nook_edit *edit) {
    float *at = attributes_of(edit, 3u * t);
    uint32_t i;
    if (edit != NULL && edit->color != NULL) edit->color[t] = 1;
    for (i = 0; at != NULL && i < 3u * edit->width; i++) at[i] = 0;
}

void nook_swap_attributes(const nook_edit *edit, uint32_t c, uint32_t d) {
    float *one = attributes_of(edit, c), *other = attributes_of(edit, d), keep;
    uint32_t i;
    for (i = 0; one != NULL && i < edit->width; i++) keep = one[i], one[i] = other[i], other[i] = keep;
}

bool nook_same_attributes(const nook_edit *edit, uint32_t c, uint32_t d) {
    const float *one = attributes_of(edit, c), *other = attributes_of(edit, d);
    uint32_t i;
    for (i = 0; i < edit->width; i++) {
        if (one[i] != other[i]) return false;
    }
    return true;
}

void nook_blend_attributes(const nook_edit *edit, uint32_t to, uint32_t c, const float w[3]) {
    float *at = attributes_of(edit, to), *a, *b;
    uint32_t i;
    a = attributes_of(edit, nook_next(c));
    b = attributes_of(edit, nook_prev(c));
    for (i = 0; i < edit->width; i++) at[i] = attributes_of(edit, c)[i] * w[0] + a[i] * w[1] + b[i] * w[2];
}

void nook_add_attributes(const nook_edit *edit, uint32_t to, uint32_t from, float weight) {
    float *at = attributes_of(edit, to);
    uint32_t i;
    for (i = 0; at != NULL && i < edit->width; i++) at[i] += weight * attributes_of(edit, from)[i];
}
