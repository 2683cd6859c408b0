/* nook_sew.c -- the operators of nook_sew.h. Everything is read before anything is written. */
#include "edit/nook_sew.h"

#include "edit/nook_inner.h"

/* ---- make and remove ------------------------------------------------------------------------------- */

nook_status nook_make_vertex(nook_mesh *m, nook_point at) {
    if (m->nv == m->max_nv) return NOOK_NO_CAPACITY;
    nook_add_vertex(m, at, NOOK_NONE, NULL);
    return NOOK_OK;
}

/* The border corner whose edge runs from b to a, so that a triangle that runs it from a to b can be joined to it;
 * NOOK_NONE if there is no edge. */
static nook_status find_partner(const nook_mesh *m, uint32_t a, uint32_t b, uint32_t *partner) {
    nook_view view = nook_view_of(m);
    nook_star star;
    uint32_t x = nook_corner_of(&view, a);
    *partner = NOOK_NONE;
    if (x == NOOK_NONE) return NOOK_OK;
    if (nook_star_begin(&star, &view, x, false) != NOOK_OK) return NOOK_BAD_OPPOSITE;
    while ((x = nook_star_next(&star)) != NOOK_NONE) {
        uint32_t n = nook_next(x), p = nook_prev(x);
        if (m->V[n] == b) return m->O[p] == p ? NOOK_INCOHERENT_EDGE : NOOK_NONMANIFOLD_EDGE;
        if (m->V[p] == b) *partner = n;
    }
    return *partner != NOOK_NONE && m->O[*partner] != *partner ? NOOK_NONMANIFOLD_EDGE : NOOK_OK;
}

/* partner[i] is the corner opposite to corner i to be. */
NOOK_APART static nook_status make_status(const nook_mesh *m, const uint32_t v[3], uint32_t partner[3],
                                          const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    uint32_t i, c;
    nook_status status;
    if (v[0] >= m->nv || v[1] >= m->nv || v[2] >= m->nv) return NOOK_INDEX_OUT_OF_RANGE;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return NOOK_REPEATED_VERTEX;
    if (m->nt == m->max_nt) return NOOK_NO_CAPACITY;
    for (i = 0; i < 3u; i++) {
        c = nook_corner_of(&view, v[i]);
        if (c == NOOK_NONE) continue;
        if (c >= 3u * m->nt || m->V[c] != v[i]) return NOOK_BAD_OPPOSITE;
        if (!nook_has_room(&view, c, 1, edit)) return NOOK_TOO_MANY_TRIANGLES;
    }
    for (i = 0; i < 3u; i++) {
        status = find_partner(m, v[(i + 1u) % 3u], v[(i + 2u) % 3u], &partner[i]);
        if (status != NOOK_OK) return status;
    }
    for (i = 0; i < 3u; i++) {
        if (partner[(i + 1u) % 3u] != NOOK_NONE || partner[(i + 2u) % 3u] != NOOK_NONE) continue;
        if (nook_corner_of(&view, v[i]) != NOOK_NONE) return NOOK_NONMANIFOLD_VERTEX;
    }
    return NOOK_OK;
}

NOOK_APART static nook_status triangle_cuts(const nook_mesh *m, const uint32_t v[3], const nook_edit *edit) {
    nook_change change;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, NOOK_NONE, NOOK_NONE);
    nook_change_make(&change, &m->G[v[0]], &m->G[v[1]], &m->G[v[2]]);
    return edit->guard->look(edit->guard, &change);
}

nook_status nook_make_triangle(nook_mesh *m, const uint32_t v[3], const nook_edit *edit) {
    uint32_t partner[3], i, c = 3u * m->nt, from;
    nook_status status = make_status(m, v, partner, edit);
    const nook_point *none[4];
    if (status != NOOK_OK) return status;
    if (partner[0] != NOOK_NONE && m->V[partner[0]] == v[0]) return NOOK_DUPLICATE_TRIANGLE;
    for (i = 0; i < 4u; i++) none[i] = &m->G[v[0]];
    if (nook_is_turned(edit, &m->G[v[0]], &m->G[v[1]], &m->G[v[2]], none)) return NOOK_TURNED_TRIANGLE;
    status = triangle_cuts(m, v, edit);
    if (status != NOOK_OK) return status;
    nook_new_triangle(m->nt, edit);
    nook_set_triangle(m, m->nt++, v[0], v[1], v[2]);
    for (i = 0; i < 3u; i++, c++) {
        uint32_t o = partner[i], before = partner[(i + 1u) % 3u], after = partner[(i + 2u) % 3u];
        nook_join(m, c, o);
        /* Corner i meets those at the other two edges, if they are there. */
        from = before != NOOK_NONE ? nook_next(before) : after != NOOK_NONE ? nook_prev(after) : c;
        nook_copy_attributes(edit, c, from);
        if (o != NOOK_NONE) nook_copy_color(edit, m->nt - 1u, nook_triangle(o));
        if (m->C[v[i]] == NOOK_STORED_NONE) m->C[v[i]] = nook_store(c);
    }
    nook_follow_triangle(m, m->nt - 1u, edit);
    return NOOK_OK;
}

nook_status nook_remove_triangle(nook_mesh *m, uint32_t t, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status;
    uint32_t c, i, stays[3];
    if (t >= m->nt) return NOOK_INDEX_OUT_OF_RANGE;
    status = nook_triangle_status(m, 3u * t);
    if (status != NOOK_OK) return status;
    for (i = 0; i < 3u; i++) {
        uint32_t left = nook_turn(&view, 3u * t + i, false), right = nook_turn(&view, 3u * t + i, true);
        stays[i] = left != NOOK_NONE ? left : right;
        if (left == NOOK_NONE || right == NOOK_NONE) continue;
        if (nook_is_at_border(&view, 3u * t + i)) return NOOK_NONMANIFOLD_VERTEX;
    }
    for (i = 0; i < 3u; i++) {
        c = 3u * t + i;
        if (nook_triangle(m->C[m->V[c]]) == t) m->C[m->V[c]] = nook_store(stays[i]);
        if (nook_across(m, c) != NOOK_NONE) nook_join(m, m->O[c], NOOK_NONE);
        nook_join(m, c, NOOK_NONE);
    }
    nook_drop_triangle(m, t, edit);
    return NOOK_OK;
}

/* ---- stitch and cut -------------------------------------------------------------------------------- */

/* Corners of the ends: b and e of one edge are to become one with b2 and e2 of the other. */
typedef struct seam {
    uint32_t b, e, b2, e2;
} seam;

/* The name of vertex x when all is sewn. */
static uint32_t sewn(const nook_mesh *m, const seam *s, uint32_t x) {
    return x == m->V[s->b2] ? m->V[s->b] : x == m->V[s->e2] ? m->V[s->e] : x;
}

/* Whether v(c) and v(d) can become one: no neighbour but that along the seam is one of both. */
NOOK_APART static nook_status meet_status(const nook_mesh *m, const seam *s, uint32_t c, uint32_t d) {
    nook_view view = nook_view_of(m);
    nook_ring one, other;
    uint32_t n = 0, v, w;
    if (m->V[c] == m->V[d]) return NOOK_OK;
    (void)nook_ring_begin(&one, &view, c); /* where it cannot, there is no neighbour at all */
    while ((v = nook_ring_next(&one)) != NOOK_NONE) {
        if (v == m->V[d]) return NOOK_REPEATED_VERTEX;
        (void)nook_ring_begin(&other, &view, d);
        while ((w = nook_ring_next(&other)) != NOOK_NONE) n += sewn(m, s, v) == sewn(m, s, w);
    }
    return n == 1 ? NOOK_OK : NOOK_DUPLICATE_EDGE;
}

NOOK_APART static nook_status stitch_conditions(const nook_mesh *m, const seam *s, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_move move = {{m->V[s->b2], m->V[s->e2]}, {m->G[m->V[s->b]], m->G[m->V[s->e]]}};
    uint32_t end;
    for (end = 0; end < 2u; end++) {
        uint32_t c = end == 0 ? s->b : s->e, d = end == 0 ? s->b2 : s->e2;
        if (edit == NULL || m->V[c] == m->V[d]) continue;
        if (!nook_has_room(&view, c, nook_count_fan(&view, d, edit), edit)) return NOOK_TOO_MANY_TRIANGLES;
        if (edit->no_turn && nook_move_turns_fan(m, d, &move, NOOK_NONE, NOOK_NONE, edit))
            return NOOK_TURNED_TRIANGLE;
    }
    return NOOK_OK;
}

NOOK_APART static nook_status stitch_cuts(const nook_mesh *m, const seam *s, const nook_edit *edit) {
    nook_change change;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, NOOK_NONE, NOOK_NONE);
    if (m->V[s->b] != m->V[s->b2]) nook_change_fan(&change, 0, s->b2, &m->G[m->V[s->b]]);
    if (m->V[s->e] != m->V[s->e2]) nook_change_fan(&change, 1, s->e2, &m->G[m->V[s->e]]);
    return edit->guard->look(edit->guard, &change);
}

NOOK_APART static nook_status stitch_status(const nook_mesh *m, uint32_t c, uint32_t d, const seam *s) {
    nook_status status = nook_triangle_status(m, c);
    if (status == NOOK_OK) status = nook_triangle_status(m, d);
    if (status != NOOK_OK) return status;
    if (m->O[c] != c || m->O[d] != d) return NOOK_INTERIOR_EDGE;
    if (c == d) return NOOK_REPEATED_VERTEX;
    status = meet_status(m, s, s->b, s->b2);
    if (status == NOOK_OK) status = meet_status(m, s, s->e, s->e2);
    if (status != NOOK_OK) return status;
    return m->V[c] == m->V[d] ? NOOK_DUPLICATE_TRIANGLE : NOOK_OK;
}

nook_status nook_stitch(nook_mesh *m, uint32_t c, uint32_t d, const nook_edit *edit) {
    seam s = {nook_next(c), nook_prev(c), nook_prev(d), nook_next(d)};
    nook_status status = stitch_status(m, c, d, &s);
    uint32_t b, b2, e, e2;
    if (status == NOOK_OK) status = stitch_conditions(m, &s, edit);
    if (status == NOOK_OK) status = stitch_cuts(m, &s, edit);
    if (status != NOOK_OK) return status;
    b = m->V[s.b], e = m->V[s.e], b2 = m->V[s.b2], e2 = m->V[s.e2];
    if (b != b2) nook_rename_fan(m, s.b2, b);
    if (e != e2) nook_rename_fan(m, s.e2, e);
    nook_join(m, c, d);
    nook_follow_fan(m, s.b, edit);
    nook_follow_fan(m, s.e, edit);
    if (b != b2 && e != e2) {
        nook_drop_vertices(m, b2, e2, edit);
    } else if (b != b2 || e != e2) {
        nook_drop_vertex(m, b != b2 ? b2 : e2, edit);
    }
    return NOOK_OK;
}

/* The fan of corner x gets a vertex of its own; that of corner y keeps the old one. */
static void divide(nook_mesh *m, uint32_t x, uint32_t y, const nook_edit *edit) {
    uint32_t v = m->V[x];
    m->C[v] = nook_store(y);
    nook_rename_fan(m, x, m->nv);
    nook_add_vertex(m, m->G[v], x, edit);
    nook_copied(edit, v, m->nv - 1u);
}

nook_status nook_cut(nook_mesh *m, uint32_t c, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status = nook_triangle_status(m, c);
    uint32_t o;
    bool b_open, e_open;
    if (status == NOOK_OK) status = nook_triangle_status(m, m->O[c]);
    if (status != NOOK_OK) return status;
    o = m->O[c];
    if (o == c) return NOOK_BORDER_EDGE;
    b_open = nook_is_at_border(&view, nook_next(c));
    e_open = nook_is_at_border(&view, nook_prev(c));
    if (!b_open && !e_open) return NOOK_DUPLICATE_EDGE;
    if (m->max_nv - m->nv < (uint32_t)b_open + (uint32_t)e_open) return NOOK_NO_CAPACITY;
    nook_join(m, c, NOOK_NONE);
    nook_join(m, o, NOOK_NONE);
    if (b_open) divide(m, nook_prev(o), nook_next(c), edit);
    if (e_open) divide(m, nook_next(o), nook_prev(c), edit);
    return NOOK_OK;
}
