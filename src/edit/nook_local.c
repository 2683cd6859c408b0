/* nook_local.c -- the operators of nook_local.h. Everything is read before anything is written. */
#include "edit/nook_local.h"

#include "edit/nook_inner.h"

static const nook_point *point_of(const nook_mesh *m, uint32_t c) { return &m->G[m->V[c]]; }

/* Room for vertices and triangles. */
static bool has_capacity(const nook_mesh *m, uint32_t vertices, uint32_t triangles) {
    return m->max_nv - m->nv >= vertices && m->max_nt - m->nt >= triangles;
}

/* ---- flip and splits ------------------------------------------------------------------------------- */

/* Both triangles to be, seen along the normal of the quadrilateral A B D C. */
NOOK_APART static bool flip_turns(const nook_mesh *m, uint32_t c, uint32_t o, const nook_edit *edit) {
    const nook_point *const p[4] = {point_of(m, c), point_of(m, nook_next(c)), point_of(m, o),
                                    point_of(m, nook_prev(c))};
    return nook_is_turned(edit, p[0], p[1], p[2], p) || nook_is_turned(edit, p[0], p[2], p[3], p);
}

NOOK_APART static nook_status flip_cuts(const nook_mesh *m, uint32_t c, uint32_t o, const nook_edit *edit) {
    nook_change change;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, nook_triangle(c), nook_triangle(o));
    nook_change_make(&change, point_of(m, c), point_of(m, nook_next(c)), point_of(m, o));
    nook_change_make(&change, point_of(m, c), point_of(m, o), point_of(m, nook_prev(c)));
    return edit->guard->look(edit->guard, &change);
}

nook_status nook_flip(nook_mesh *m, uint32_t c, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status = nook_edge_status(m, c);
    uint32_t o, x, y, b, d, n;
    if (status != NOOK_OK) return status;
    if (m->O[c] == c) return NOOK_BORDER_EDGE;
    o = m->O[c];
    n = m->V[nook_prev(c)], b = m->V[nook_prev(o)], d = m->V[o];
    if (!nook_has_room(&view, c, 1, edit) || !nook_has_room(&view, o, 1, edit))
        return NOOK_TOO_MANY_TRIANGLES;
    if (d == m->V[c] || nook_is_joined(&view, c, d)) return NOOK_DUPLICATE_EDGE;
    if (flip_turns(m, c, o, edit)) return NOOK_TURNED_TRIANGLE;
    status = flip_cuts(m, c, o, edit);
    if (status != NOOK_OK) return status;
    x = nook_across(m, nook_next(o));
    y = nook_across(m, nook_next(c));
    m->V[nook_prev(c)] = nook_store(d);
    m->V[nook_prev(o)] = m->V[c];
    nook_copy_attributes(edit, nook_prev(c), o);
    nook_copy_attributes(edit, nook_prev(o), c);
    nook_join(m, c, x);
    nook_join(m, o, y);
    nook_join(m, nook_next(c), nook_next(o));
    m->C[n] = nook_store(nook_next(o));
    m->C[b] = nook_store(nook_next(c));
    nook_follow_triangle(m, nook_triangle(c), edit);
    nook_follow_triangle(m, nook_triangle(o), edit);
    return NOOK_OK;
}

/* Whether corner c can be moved to at; of its triangle alone. */
NOOK_APART static bool corner_turns(const nook_mesh *m, uint32_t c, nook_point at, const nook_edit *edit) {
    nook_move move = {{m->V[c], NOOK_NONE}, {at, at}};
    return nook_move_turns(m, nook_triangle(c), &move, edit);
}

/* Triangles are to be cut up, the pieces being each that of one of these corners with the corner moved to at. */
NOOK_APART static nook_status pieces_cut(const nook_mesh *m, const uint32_t *corner, uint32_t n,
                                         const nook_point *at, const nook_edit *edit) {
    nook_change change;
    uint32_t i;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, nook_triangle(corner[0]), nook_triangle(corner[n - 1u]));
    for (i = 0; i < n; i++)
        nook_change_make(&change, at, point_of(m, nook_next(corner[i])), point_of(m, nook_prev(corner[i])));
    return edit->guard->look(edit->guard, &change);
}

NOOK_APART static nook_status split_triangle_status(const nook_mesh *m, uint32_t t, nook_point at,
                                                    const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    const uint32_t corner[3] = {3u * t, 3u * t + 1u, 3u * t + 2u};
    nook_status status;
    uint32_t c;
    if (t >= m->nt) return NOOK_INDEX_OUT_OF_RANGE;
    status = nook_triangle_status(m, 3u * t);
    if (status != NOOK_OK) return status;
    if (!has_capacity(m, 1, 2)) return NOOK_NO_CAPACITY;
    if (!nook_is_within(edit, 3)) return NOOK_TOO_MANY_TRIANGLES;
    for (c = 3u * t; c < 3u * t + 3u; c++) {
        if (!nook_has_room(&view, c, 1, edit)) return NOOK_TOO_MANY_TRIANGLES;
        if (corner_turns(m, c, at, edit)) return NOOK_TURNED_TRIANGLE;
    }
    return pieces_cut(m, corner, 3, &at, edit);
}

/* Those of a point in the triangle of c, at the first new corner. */
NOOK_APART static void set_attributes_inside(const nook_mesh *m, uint32_t c, nook_point at,
                                             const nook_edit *edit) {
    nook_point corners[3];
    float w[3];
    uint32_t i;
    if (edit == NULL || edit->attributes == NULL) return;
    for (i = 0; i < 3u; i++) corners[i] = *point_of(m, c + i);
    nook_barycentric(corners, at, w);
    nook_blend_attributes(edit, 3u * m->nt, c, w);
}

nook_status nook_split_triangle(nook_mesh *m, uint32_t t, nook_point at, const nook_edit *edit) {
    nook_status status = split_triangle_status(m, t, at, edit);
    uint32_t c = 3u * t, q = 3u * m->nt, r = q + 3u, v = m->nv, a, second, third;
    if (status != NOOK_OK) return status;
    a = m->V[c];
    second = nook_across(m, c + 1u);
    third = nook_across(m, c + 2u);
    nook_set_triangle(m, m->nt, v, m->V[c + 2u], a);
    nook_set_triangle(m, m->nt + 1u, v, a, m->V[c + 1u]);
    set_attributes_inside(m, c, at, edit);
    nook_copy_attributes(edit, q + 1u, c + 2u);
    nook_copy_attributes(edit, q + 2u, c);
    nook_copy_attributes(edit, r, q);
    nook_copy_attributes(edit, r + 1u, c);
    nook_copy_attributes(edit, r + 2u, c + 1u);
    nook_copy_attributes(edit, c, q);
    nook_copy_color(edit, m->nt, t);
    nook_copy_color(edit, m->nt + 1u, t);
    m->V[c] = nook_store(v);
    m->nt += 2u;
    nook_join(m, q, second);
    nook_join(m, r, third);
    nook_join(m, c + 1u, q + 2u);
    nook_join(m, c + 2u, r + 1u);
    nook_join(m, q + 1u, r + 2u);
    nook_add_vertex(m, at, c, edit);
    m->C[a] = nook_store(q + 2u);
    nook_follow_fan(m, c, edit);
    return NOOK_OK;
}

/* How far from v(b) to v(c) the foot of a point is, from 0 to 1; a half if they are in one place. */
NOOK_APART static float along(const nook_mesh *m, uint32_t b, uint32_t c, nook_point at) {
    nook_point edge = nook_sub(*point_of(m, c), *point_of(m, b)), to = nook_sub(at, *point_of(m, b));
    float scale = nook_power_of_two(254u - nook_exponent(nook_length(edge))), square, s;
    edge = nook_scaled(edge, scale);
    square = nook_dot(edge, edge);
    s = nook_dot(edge, nook_scaled(to, scale)) / square;
    if (!(square > 0)) return 0.5f;
    return s < 0 ? 0 : s > 1 ? 1 : s;
}

/* Those of a point on the edge that c faces, at corner to: as the triangle of c has them, or (o) that of o(c), which sees
 * the edge from its other end. Both reckon from the same end, so that they agree to the last bit. */
static void set_attributes_between(const nook_mesh *m, uint32_t to, uint32_t c, bool o, nook_point at,
                                   const nook_edit *edit) {
    float w[3] = {0, 0, 0};
    if (edit == NULL || edit->attributes == NULL) return;
    w[o ? 1 : 2] = along(m, o ? nook_prev(c) : nook_next(c), o ? nook_next(c) : nook_prev(c), at);
    w[o ? 2 : 1] = 1.0f - w[o ? 1 : 2];
    nook_blend_attributes(edit, to, c, w);
}

NOOK_APART static nook_status split_edge_status(const nook_mesh *m, uint32_t c, nook_point at,
                                                const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status = nook_edge_status(m, c);
    uint32_t o, side, corner[4];
    if (status != NOOK_OK) return status;
    o = nook_across(m, c);
    if (o != NOOK_NONE && m->V[o] == m->V[c]) return NOOK_DUPLICATE_TRIANGLE;
    if (!has_capacity(m, 1, o == NOOK_NONE ? 1 : 2)) return NOOK_NO_CAPACITY;
    if (!nook_is_within(edit, o == NOOK_NONE ? 2 : 4)) return NOOK_TOO_MANY_TRIANGLES;
    for (side = 0; side < (o == NOOK_NONE ? 1u : 2u); side++) {
        uint32_t x = side == 0 ? c : o;
        if (!nook_has_room(&view, x, 1, edit)) return NOOK_TOO_MANY_TRIANGLES;
        if (corner_turns(m, nook_next(x), at, edit)) return NOOK_TURNED_TRIANGLE;
        if (corner_turns(m, nook_prev(x), at, edit)) return NOOK_TURNED_TRIANGLE;
        corner[2u * side] = nook_next(x);
        corner[2u * side + 1u] = nook_prev(x);
    }
    return pieces_cut(m, corner, 2u * side, &at, edit);
}

nook_status nook_split_edge(nook_mesh *m, uint32_t c, nook_point at, const nook_edit *edit) {
    nook_status status = split_edge_status(m, c, at, edit);
    uint32_t o, q = 3u * m->nt, r = q + 3u, v = m->nv, end, y, z;
    if (status != NOOK_OK) return status;
    o = nook_across(m, c);
    end = m->V[nook_prev(c)];
    y = nook_across(m, nook_next(c));
    nook_set_triangle(m, m->nt, m->V[c], v, end);
    nook_copy_attributes(edit, q, c);
    set_attributes_between(m, q + 1u, c, false, at, edit);
    nook_copy_attributes(edit, q + 2u, nook_prev(c));
    nook_copy_attributes(edit, nook_prev(c), q + 1u);
    nook_copy_color(edit, m->nt++, nook_triangle(c));
    m->V[nook_prev(c)] = nook_store(v);
    nook_join(m, q + 1u, y);
    nook_join(m, nook_next(c), q + 2u);
    nook_join(m, q, NOOK_NONE);
    if (o != NOOK_NONE) {
        z = nook_across(m, nook_prev(o));
        nook_set_triangle(m, m->nt, m->V[o], end, v);
        nook_copy_attributes(edit, r, o);
        nook_copy_attributes(edit, r + 1u, nook_next(o));
        set_attributes_between(m, r + 2u, o, true, at, edit);
        nook_copy_attributes(edit, nook_next(o), r + 2u);
        nook_copy_color(edit, m->nt++, nook_triangle(o));
        m->V[nook_next(o)] = nook_store(v);
        nook_join(m, r + 2u, z);
        nook_join(m, nook_prev(o), r + 1u);
        nook_join(m, q, r);
    }
    nook_add_vertex(m, at, nook_prev(c), edit);
    m->C[end] = nook_store(q + 2u);
    nook_follow_fan(m, nook_prev(c), edit);
    return NOOK_OK;
}

/* ---- split of a vertex ----------------------------------------------------------------------------- */

/* The triangles that change hands: those from corner first on, counter-clockwise, n of them. */
typedef struct sector {
    uint32_t first, last, n;
} sector;

/* Turn about v(*c) to the end of an open fan; false where it comes round. */
static bool turn_to_border(const nook_view *m, uint32_t *c) {
    uint32_t left = m->nt, x;
    while (left-- > 0 && (x = nook_turn(m, *c, true)) != NOOK_NONE) *c = x;
    return nook_turn(m, *c, true) == NOOK_NONE;
}

NOOK_APART static nook_status find_sector(const nook_mesh *m, uint32_t c, uint32_t d, sector *s) {
    nook_view view = nook_view_of(m);
    nook_status status = c == NOOK_NONE ? NOOK_OK : nook_edge_status(m, c);
    uint32_t x;
    if (status == NOOK_OK && (d != NOOK_NONE || c == NOOK_NONE)) status = nook_edge_status(m, d);
    if (status != NOOK_OK) return status;
    s->first = c != NOOK_NONE ? nook_next(c) : nook_prev(d);
    s->last = d != NOOK_NONE ? nook_prev(d) : NOOK_NONE;
    if (c == NOOK_NONE && !turn_to_border(&view, &s->first)) return NOOK_INTERIOR_VERTEX;
    for (s->n = 1, x = s->first; x != s->last; s->n++) {
        uint32_t turned = nook_turn(&view, x, false);
        if (m->V[nook_next(x)] >= m->nv || m->V[nook_prev(x)] >= m->nv) return NOOK_BAD_OPPOSITE;
        if (turned == NOOK_NONE && d == NOOK_NONE) break;
        if (turned == s->first && d == NOOK_NONE) return NOOK_INTERIOR_VERTEX;
        if (turned == NOOK_NONE || turned == s->first || s->n >= m->nt) return NOOK_NONMANIFOLD_VERTEX;
        x = turned;
    }
    s->last = x;
    return nook_turn(&view, x, false) == s->first ? NOOK_DUPLICATE_TRIANGLE : NOOK_OK;
}

/* A new triangle v w x at corner c of the sector, which faces the edge of v(k) and x. */
NOOK_APART static bool wedge_turns(const nook_mesh *m, uint32_t c, uint32_t k, uint32_t x, nook_point at,
                                   const nook_edit *edit) {
    uint32_t i, y = nook_across(m, c);
    const nook_point *const v = point_of(m, k), *const w = &at;
    bool first = k == nook_next(c);
    for (i = 0; i < 2u && !(i == 1 && y == NOOK_NONE); i++, c = y) {
        const nook_point *const old[4] = {point_of(m, c), point_of(m, nook_next(c)),
                                          point_of(m, nook_prev(c)), point_of(m, nook_prev(c))};
        if (nook_is_turned(edit, point_of(m, x), first ? w : v, first ? v : w, old)) return true;
    }
    return false;
}

/* The triangle of wedge_turns(). */
static void make_wedge(nook_change *change, const nook_mesh *m, uint32_t c, uint32_t k, uint32_t x,
                       const nook_point *at) {
    const nook_point *v = point_of(m, k);
    bool first = k == nook_next(c);
    nook_change_make(change, point_of(m, x), first ? at : v, first ? v : at);
}

NOOK_APART static nook_status sector_cuts(const nook_mesh *m, uint32_t c, uint32_t d, const nook_point *at,
                                          const nook_edit *edit, const sector *s) {
    nook_change change;
    nook_star star;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, NOOK_NONE, NOOK_NONE);
    nook_change_fan(&change, 0, s->first, at);
    star.view = &change.view;
    star.first = star.next = s->first;
    star.left = s->n;
    star.open = star.clockwise = false;
    change.fan[0] = star;
    if (c != NOOK_NONE) make_wedge(&change, m, c, nook_next(c), nook_prev(c), at);
    if (d != NOOK_NONE) make_wedge(&change, m, d, nook_prev(d), nook_next(d), at);
    return edit->guard->look(edit->guard, &change);
}

NOOK_APART static nook_status split_vertex_status(const nook_mesh *m, uint32_t c, uint32_t d, nook_point at,
                                                  const nook_edit *edit, sector *s) {
    nook_view view = nook_view_of(m);
    nook_status status = find_sector(m, c, d, s);
    uint32_t x, more = (uint32_t)(c != NOOK_NONE) + (uint32_t)(d != NOOK_NONE), n;
    nook_move move = {{NOOK_NONE, NOOK_NONE}, {at, at}};
    if (status != NOOK_OK) return status;
    if (!has_capacity(m, 1, more)) return NOOK_NO_CAPACITY;
    if (edit == NULL) return NOOK_OK;
    if (edit->max_valence != 0) {
        n = nook_valence(&view, s->first);
        if (s->n + more > edit->max_valence || n - s->n + more > edit->max_valence)
            return NOOK_TOO_MANY_TRIANGLES;
        if (c != NOOK_NONE && !nook_has_room(&view, nook_prev(c), 1, edit)) return NOOK_TOO_MANY_TRIANGLES;
        if (d != NOOK_NONE && !nook_has_room(&view, nook_next(d), 1, edit)) return NOOK_TOO_MANY_TRIANGLES;
    }
    if (!edit->no_turn) return NOOK_OK;
    move.v[0] = m->V[s->first];
    for (x = s->first, n = s->n; n-- > 0; x = nook_turn(&view, x, false)) {
        if (nook_move_turns(m, nook_triangle(x), &move, edit)) return NOOK_TURNED_TRIANGLE;
    }
    if (c != NOOK_NONE && wedge_turns(m, c, nook_next(c), nook_prev(c), at, edit))
        return NOOK_TURNED_TRIANGLE;
    if (d != NOOK_NONE && wedge_turns(m, d, nook_prev(d), nook_next(d), at, edit))
        return NOOK_TURNED_TRIANGLE;
    return NOOK_OK;
}

/* The triangle that fills the gap at c, which faces the edge of v and x in the sector: x, then w and v as the side asks. Its
 * first corner faces the new edge. */
static uint32_t add_wedge(nook_mesh *m, uint32_t c, bool first, uint32_t v, uint32_t w,
                          const nook_edit *edit) {
    uint32_t q = 3u * m->nt, across = nook_across(m, c);
    uint32_t x = first ? nook_prev(c) : nook_next(c), at = first ? nook_next(c) : nook_prev(c);
    uint32_t to_v = first ? q + 2u : q + 1u, to_w = first ? q + 1u : q + 2u;
    nook_set_triangle(m, m->nt, m->V[x], first ? w : v, first ? v : w);
    nook_copy_attributes(edit, q, x);
    nook_copy_attributes(edit, q + 1u, at);
    nook_copy_attributes(edit, q + 2u, at);
    nook_copy_color(edit, m->nt++, nook_triangle(c));
    nook_join(m, q, NOOK_NONE);
    nook_join(m, to_w, across);
    nook_join(m, to_v, c);
    m->C[v] = nook_store(to_v);
    return q;
}

/* The corner of the sector in whose triangle a point is, or comes nearest to be, and its coordinates there. */
NOOK_APART static uint32_t find_place(const nook_mesh *m, const sector *s, nook_point at, float w[3]) {
    nook_view view = nook_view_of(m);
    uint32_t x = s->first, n, found = NOOK_NONE;
    float most = 0;
    for (n = s->n; n > 0; n--, x = nook_turn(&view, x, false)) {
        const nook_point corners[3] = {*point_of(m, x), *point_of(m, nook_next(x)),
                                       *point_of(m, nook_prev(x))};
        float here[3], least;
        nook_barycentric(corners, at, here);
        least = here[1] < here[2] ? here[1] : here[2];
        if (found != NOOK_NONE && !(least > most)) continue;
        found = x;
        most = least;
        memcpy(w, here, sizeof here);
    }
    return found;
}

/* The new vertex has the attributes of a place in the triangle of x; those of its corners beyond a crease stay. */
static void place_attributes(const nook_mesh *m, uint32_t x, const float w[3], const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_star star;
    uint32_t y;
    (void)nook_star_begin(&star, &view, x, false);
    while ((y = nook_star_next(&star)) != NOOK_NONE) {
        if (y != x && nook_same_attributes(edit, x, y)) nook_blend_attributes(edit, y, x, w);
    }
    nook_blend_attributes(edit, x, x, w);
}

nook_status nook_split_vertex(nook_mesh *m, uint32_t c, uint32_t d, nook_point at, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    sector s;
    nook_status status = split_vertex_status(m, c, d, at, edit, &s);
    uint32_t x, next, w = m->nv, v, q = NOOK_NONE, place = NOOK_NONE;
    float weights[3];
    if (status == NOOK_OK) status = sector_cuts(m, c, d, &at, edit, &s);
    if (status != NOOK_OK) return status;
    if (edit != NULL && edit->attributes != NULL) place = find_place(m, &s, at, weights);
    v = m->V[s.first];
    for (x = s.first; s.n-- > 0; x = next) {
        next = nook_turn(&view, x, false);
        m->V[x] = nook_store(w);
    }
    nook_add_vertex(m, at, s.first, edit);
    if (c != NOOK_NONE) q = add_wedge(m, c, true, v, w, edit);
    if (d != NOOK_NONE) nook_join(m, add_wedge(m, d, false, v, w, edit), q);
    if (place != NOOK_NONE) place_attributes(m, place, weights, edit);
    nook_follow_fan(m, s.first, edit);
    return NOOK_OK;
}

/* ---- collapse -------------------------------------------------------------------------------------- */

enum { DOZEN = 12 };

/* The neighbours of a vertex whose fan is closed and has a dozen triangles at most; else 0. */
static uint32_t list_round(const nook_view *m, uint32_t c, uint32_t *near) {
    uint32_t n = 1, e = nook_next(c), o, corners = 3u * m->nt;
    near[0] = m->V[nook_prev(c)];
    while ((o = m->O[e]) != nook_prev(c)) {
        if (o == e || o >= corners || n == (uint32_t)DOZEN) return 0;
        near[n++] = m->V[o];
        e = nook_prev(o);
    }
    return n;
}

static uint32_t count_equal(const uint32_t *one, uint32_t n, uint32_t v) {
    uint32_t i, equal = 0;
    for (i = 0; i < n; i++) equal += one[i] == v;
    return equal;
}

/* How many neighbours B and C have in common, from their corners at the edge; those of B by the dozen, so that the
 * fan of C is walked once for most. NOOK_NONE where the tables do not hold. */
NOOK_APART static uint32_t count_common_of_any(const nook_view *m, uint32_t b, uint32_t c) {
    nook_ring one, other;
    uint32_t near[DOZEN], n, v, common = 0;
    (void)nook_ring_begin(&one, m, b); /* where it cannot, there is no neighbour at all */
    do {
        for (n = 0; n < (uint32_t)DOZEN && (v = nook_ring_next(&one)) != NOOK_NONE; n++) near[n] = v;
        if (nook_ring_begin(&other, m, c) != NOOK_OK) return NOOK_NONE;
        while ((v = nook_ring_next(&other)) != NOOK_NONE) common += count_equal(near, n, v);
    } while (n == (uint32_t)DOZEN);
    return common;
}

/* Whether the neighbours that B and C have in common are so many, and not both are at the border. */
NOOK_APART static nook_status common_status(const nook_view *m, uint32_t b, uint32_t c, uint32_t must) {
    uint32_t near[DOZEN], far[DOZEN], common = 0;
    uint32_t i = list_round(m, b, near), n = i == 0 ? 0 : list_round(m, c, far);
    if (n == 0) {
        if (must == 2u && nook_is_at_border(m, b) && nook_is_at_border(m, c)) return NOOK_NONMANIFOLD_VERTEX;
        common = count_common_of_any(m, b, c);
    }
    while (n-- > 0) common += count_equal(near, i, far[n]);
    if (common == NOOK_NONE) return NOOK_BAD_OPPOSITE;
    return common == must ? NOOK_OK : NOOK_DUPLICATE_EDGE;
}

/* Vertex v of the triangle across corner x; NOOK_NONE at a border. */
static uint32_t apex(const nook_mesh *m, uint32_t x) { return m->O[x] == x ? NOOK_NONE : m->V[m->O[x]]; }

/* Whether the triangle of c has no neighbour but across c. */
static bool is_loose(const nook_mesh *m, uint32_t c) {
    return nook_across(m, nook_next(c)) == NOOK_NONE && nook_across(m, nook_prev(c)) == NOOK_NONE;
}

/* Whether the triangle of o is across x. */
static bool is_beside(const nook_mesh *m, uint32_t x, uint32_t o) {
    return nook_triangle(m->O[x]) == nook_triangle(o);
}

/* The fans of B and C less the triangles at the edge. */
static bool has_room_for_both(const nook_view *m, uint32_t c, const nook_edit *edit) {
    uint32_t all;
    if (edit == NULL || edit->max_valence == 0) return true;
    all = nook_count_fan(m, nook_next(c), edit) + nook_count_fan(m, nook_prev(c), edit);
    return all - (nook_is_border(m, c) ? 2u : 4u) <= edit->max_valence;
}

NOOK_APART static nook_status collapse_status(const nook_mesh *m, uint32_t c, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status = nook_edge_status(m, c);
    uint32_t o, n = nook_next(c), p = nook_prev(c);
    if (status != NOOK_OK) return status;
    if (!has_room_for_both(&view, c, edit)) return NOOK_TOO_MANY_TRIANGLES;
    o = nook_across(m, c);
    if (o == NOOK_NONE) {
        if (is_loose(m, c)) return NOOK_LAST_TRIANGLE;
    } else {
        if (m->V[o] == m->V[c]) return NOOK_DUPLICATE_TRIANGLE;
        if (apex(m, n) == m->V[o] && apex(m, p) == m->V[o]) return NOOK_DUPLICATE_TRIANGLE;
        if (is_beside(m, nook_next(c), o) || is_beside(m, nook_prev(c), o)) return NOOK_BAD_OPPOSITE;
        if (is_loose(m, c) || is_loose(m, o)) return NOOK_NONMANIFOLD_VERTEX;
    }
    return common_status(&view, n, p, o == NOOK_NONE ? 1u : 2u);
}

NOOK_APART static bool collapse_turns(const nook_mesh *m, uint32_t c, nook_point at, const nook_edit *edit) {
    nook_move move = {{m->V[nook_next(c)], m->V[nook_prev(c)]}, {at, at}};
    uint32_t t = nook_triangle(c), u = nook_triangle(m->O[c]);
    if (edit == NULL || !edit->no_turn) return false;
    return nook_move_turns_fan(m, nook_next(c), &move, t, u, edit) ||
           nook_move_turns_fan(m, nook_prev(c), &move, t, u, edit);
}

NOOK_APART static nook_status collapse_cuts(const nook_mesh *m, uint32_t c, const nook_point *at,
                                            const nook_edit *edit) {
    nook_change change;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, nook_triangle(c), nook_triangle(m->O[c]));
    nook_change_fan(&change, 0, nook_next(c), at);
    nook_change_fan(&change, 1, nook_prev(c), at);
    return edit->guard->look(edit->guard, &change);
}

/* Attributes at the point to be, by triangle at the edge, are left at the corners c and o, which go. Where B or C had
 * those of that triangle, they become these; beyond a crease they stay. */
NOOK_APART static void merge_attributes(nook_mesh *m, uint32_t c, nook_point at, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    uint32_t o = nook_across(m, c), end, x;
    if (edit == NULL || edit->attributes == NULL) return;
    set_attributes_between(m, c, c, false, at, edit);
    if (o != NOOK_NONE) set_attributes_between(m, o, o, true, at, edit);
    for (end = 0; end < 2u; end++) {
        uint32_t here = end == 0 ? nook_next(c) : nook_prev(c), there = o == NOOK_NONE ? o
                                                                        : end == 0     ? nook_prev(o)
                                                                                       : nook_next(o);
        nook_star star;
        (void)nook_star_begin(&star, &view, here, false);
        while ((x = nook_star_next(&star)) != NOOK_NONE) {
            if (x == here || x == there) continue;
            if (nook_same_attributes(edit, x, here)) {
                nook_copy_attributes(edit, x, c);
            } else if (o != NOOK_NONE && nook_same_attributes(edit, x, there)) {
                nook_copy_attributes(edit, x, o);
            }
        }
    }
}

/* The triangle of c goes: its two other neighbours become neighbours of each other. Vertices that C says have their corner
 * here get one there; v(n(c)) is called by its new name by now. */
NOOK_APART static void close_gap(nook_mesh *m, uint32_t c) {
    nook_view view = nook_view_of(m);
    uint32_t y = nook_across(m, nook_next(c)), z = nook_across(m, nook_prev(c)), i;
    if (y != NOOK_NONE) nook_join(m, y, z);
    if (y == NOOK_NONE) nook_join(m, z, NOOK_NONE);
    for (i = 0; i < 2u; i++) {
        uint32_t v = m->V[i == 0 ? c : nook_prev(c)];
        if (nook_triangle(m->C[v]) != nook_triangle(c)) continue;
        m->C[v] = nook_store(nook_corner_in(&view, nook_triangle(y != NOOK_NONE ? y : z), v));
    }
}

nook_status nook_collapse(nook_mesh *m, uint32_t c, nook_point at, const nook_edit *edit) {
    nook_status status = collapse_status(m, c, edit);
    uint32_t o, gone, kept;
    if (status != NOOK_OK) return status;
    if (collapse_turns(m, c, at, edit)) return NOOK_TURNED_TRIANGLE;
    status = collapse_cuts(m, c, &at, edit);
    if (status != NOOK_OK) return status;
    o = nook_across(m, c);
    gone = m->V[nook_next(c)];
    kept = m->V[nook_prev(c)];
    merge_attributes(m, c, at, edit);
    nook_rename_fan(m, nook_next(c), kept);
    close_gap(m, c);
    if (o != NOOK_NONE) close_gap(m, o);
    m->G[kept] = at;
    nook_follow_fan(m, m->C[kept], edit);
    if (o != NOOK_NONE) {
        nook_drop_triangles(m, nook_triangle(c), nook_triangle(o), edit);
    } else {
        nook_drop_triangle(m, nook_triangle(c), edit);
    }
    nook_drop_vertex(m, gone, edit);
    return NOOK_OK;
}

/* The four triangles around v(c), or two at a border. */
nook_status nook_merge_edges(nook_mesh *m, uint32_t c, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    nook_status status = nook_triangle_status(m, c);
    bool open;
    if (status != NOOK_OK) return status;
    open = nook_is_at_border(&view, c);
    if (nook_valence(&view, c) != (open ? 2u : 4u)) return NOOK_WRONG_VALENCE;
    if (open && m->O[nook_prev(c)] != nook_prev(c)) return NOOK_INTERIOR_EDGE;
    return nook_collapse(m, nook_prev(c), *point_of(m, nook_next(c)), edit);
}

/* Whether the one triangle for those of c, q and r, around a vertex, can be; a is the vertex that c does not see. */
NOOK_APART static nook_status remove_vertex_status(const nook_mesh *m, uint32_t c, uint32_t q, uint32_t r,
                                                   const nook_edit *edit) {
    nook_status status = nook_triangle_status(m, q);
    const nook_point *a, *none[4];
    nook_change change;
    uint32_t i;
    if (status == NOOK_OK) status = nook_triangle_status(m, r);
    if (status != NOOK_OK) return status;
    if (apex(m, c) == m->V[nook_prev(q)]) return NOOK_DUPLICATE_TRIANGLE;
    a = point_of(m, nook_prev(q));
    for (i = 0; i < 4u; i++) none[i] = a;
    if (nook_is_turned(edit, a, point_of(m, nook_next(c)), point_of(m, nook_prev(c)), none))
        return NOOK_TURNED_TRIANGLE;
    if (!nook_is_guarded(edit)) return NOOK_OK;
    nook_change_begin(&change, m, nook_triangle(c), nook_triangle(q));
    change.gone[2] = nook_triangle(r);
    nook_change_make(&change, a, point_of(m, nook_next(c)), point_of(m, nook_prev(c)));
    return edit->guard->look(edit->guard, &change);
}

nook_status nook_remove_vertex(nook_mesh *m, uint32_t v, const nook_edit *edit) {
    nook_view view = nook_view_of(m);
    uint32_t c, q, r, a;
    nook_status status;
    if (v >= m->nv) return NOOK_INDEX_OUT_OF_RANGE;
    c = nook_corner_of(&view, v);
    if (c == NOOK_NONE) {
        nook_drop_vertex(m, v, edit);
        return NOOK_OK;
    }
    status = nook_triangle_status(m, c);
    if (status != NOOK_OK) return status;
    q = nook_turn(&view, c, false);
    r = q == NOOK_NONE ? q : nook_turn(&view, q, false);
    if (r == NOOK_NONE || q == c || nook_turn(&view, r, false) != c) return NOOK_WRONG_VALENCE;
    status = remove_vertex_status(m, c, q, r, edit);
    if (status != NOOK_OK) return status;
    a = m->V[nook_prev(q)];
    m->V[c] = nook_store(a);
    nook_copy_attributes(edit, c, nook_prev(q));
    nook_join(m, nook_next(c), nook_across(m, q));
    nook_join(m, nook_prev(c), nook_across(m, r));
    m->C[a] = nook_store(c);
    m->C[m->V[nook_next(c)]] = nook_store(nook_next(c));
    m->C[m->V[nook_prev(c)]] = nook_store(nook_prev(c));
    nook_follow_triangle(m, nook_triangle(c), edit);
    nook_drop_triangles(m, nook_triangle(q), nook_triangle(r), edit);
    nook_drop_vertex(m, v, edit);
    return NOOK_OK;
}
