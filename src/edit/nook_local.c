/* nook_local.c -- the operators of nook_local.h. Everything is read before anything is written. */
#include "edit/nook_local.h"

/* ---- looking -------------------------------------------------------------------------------------- */

/* The corner across, or NOOK_NONE at a border and where O names none. */
static uint32_t across(const nook_mesh *m, uint32_t c) {
    return m->O[c] == c || m->O[c] >= 3u * m->max_nt ? NOOK_NONE : m->O[c];
}

/* Whether c is a corner, and its triangle's tables lead to corners and vertices that exist. */
static nook_status triangle_status(const nook_mesh *m, uint32_t c) {
    uint32_t i;
    if (c >= 3u * m->nt) return NOOK_INDEX_OUT_OF_RANGE;
    for (i = 0; i < 3u; i++, c = nook_next(c)) {
        if (m->O[c] >= 3u * m->nt || m->O[m->O[c]] != c || m->V[c] >= m->nv) return NOOK_BAD_OPPOSITE;
    }
    return NOOK_OK;
}

/* The same of both triangles at the edge of c. */
static nook_status edge_status(const nook_mesh *m, uint32_t c) {
    nook_status status = triangle_status(m, c);
    return status != NOOK_OK ? status : triangle_status(m, m->O[c]);
}

/* The neighbours of a vertex one by one; at the end of an open fan the last vertex. */
typedef struct ring {
    nook_star star;
    uint32_t c;
} ring;

static nook_status begin_ring(ring *r, const nook_view *m, uint32_t c) {
    r->c = NOOK_NONE;
    return nook_star_begin(&r->star, m, c, false);
}

static uint32_t next_of_ring(ring *r) {
    uint32_t last = r->c;
    r->c = nook_star_next(&r->star);
    if (r->c != NOOK_NONE) return r->star.view->V[nook_next(r->c)];
    return last != NOOK_NONE && r->star.open ? r->star.view->V[nook_prev(last)] : NOOK_NONE;
}

/* Whether v(c) and v are joined by an edge of the fan of c. */
static bool is_joined(const nook_view *m, uint32_t c, uint32_t v) {
    ring r;
    uint32_t w = NOOK_NONE;
    if (begin_ring(&r, m, c) != NOOK_OK) return true;
    do {
        w = next_of_ring(&r);
    } while (w != NOOK_NONE && w != v);
    return w == v;
}

/* ---- changing -------------------------------------------------------------------------------------- */

static void join(nook_mesh *m, uint32_t c, uint32_t o) {
    m->O[c] = nook_store(o == NOOK_NONE ? c : o);
    if (o != NOOK_NONE) m->O[o] = nook_store(c);
}

static void set_triangle(nook_mesh *m, uint32_t t, uint32_t v0, uint32_t v1, uint32_t v2) {
    m->V[3u * t] = nook_store(v0);
    m->V[3u * t + 1u] = nook_store(v1);
    m->V[3u * t + 2u] = nook_store(v2);
}

static void tell(const nook_renamer *renamer, nook_kind kind, uint32_t from, uint32_t to) {
    if (renamer != NULL && renamer->renamed != NULL) renamer->renamed(renamer->user, kind, from, to);
}

/* Triangle t is joined to nothing any more: the last one takes its number. */
static void drop_triangle(nook_mesh *m, uint32_t t, const nook_renamer *renamer) {
    uint32_t last = --m->nt, i;
    if (t == last) return;
    for (i = 0; i < 3u; i++) {
        uint32_t from = 3u * last + i, to = 3u * t + i, v = m->V[from];
        m->V[to] = nook_store(v);
        join(m, to, across(m, from));
        if (v < m->nv && m->C[v] == from) m->C[v] = nook_store(to);
    }
    tell(renamer, NOOK_AT_TRIANGLE, last, t);
}

/* Vertex v has no triangle any more: the last one takes its number. */
static void drop_vertex(nook_mesh *m, uint32_t v, const nook_renamer *renamer) {
    nook_view view = nook_view_of(m);
    uint32_t last = --m->nv, c;
    nook_star star;
    if (v == last) return;
    m->G[v] = m->G[last];
    m->C[v] = m->C[last];
    /* Each is renamed when the star has gone on from it. */
    if (nook_star_begin(&star, &view, m->C[v], false) == NOOK_OK) { /* else a vertex of no triangle */
        while ((c = nook_star_next(&star)) != NOOK_NONE) m->V[c] = nook_store(v);
    }
    tell(renamer, NOOK_AT_VERTEX, last, v);
}

static void drop_triangles(nook_mesh *m, uint32_t t, uint32_t u, const nook_renamer *renamer) {
    drop_triangle(m, t > u ? t : u, renamer); /* the other is not the last that moves */
    drop_triangle(m, t > u ? u : t, renamer);
}

/* ---- flip and splits ------------------------------------------------------------------------------- */

nook_status nook_flip(nook_mesh *m, uint32_t c) {
    nook_view view = nook_view_of(m);
    nook_status status = edge_status(m, c);
    uint32_t o, x, y, b, d, n;
    if (status != NOOK_OK) return status;
    if (m->O[c] == c) return NOOK_BORDER_EDGE;
    o = m->O[c];
    n = m->V[nook_prev(c)], b = m->V[nook_prev(o)], d = m->V[o];
    if (d == m->V[c] || is_joined(&view, c, d)) return NOOK_DUPLICATE_EDGE;
    x = across(m, nook_next(o));
    y = across(m, nook_next(c));
    m->V[nook_prev(c)] = nook_store(d);
    m->V[nook_prev(o)] = m->V[c];
    join(m, c, x);
    join(m, o, y);
    join(m, nook_next(c), nook_next(o));
    m->C[n] = nook_store(nook_next(o));
    m->C[b] = nook_store(nook_next(c));
    return NOOK_OK;
}

nook_status nook_split_triangle(nook_mesh *m, uint32_t t, nook_point at) {
    nook_status status = triangle_status(m, 3u * t);
    uint32_t c = 3u * t, q = 3u * m->nt, r = q + 3u, v = m->nv, a, second, third;
    if (t >= m->nt) return NOOK_INDEX_OUT_OF_RANGE;
    if (status != NOOK_OK) return status;
    if (m->nv == m->max_nv || m->max_nt - m->nt < 2u) return NOOK_NO_CAPACITY;
    a = m->V[c];
    second = across(m, c + 1u);
    third = across(m, c + 2u);
    set_triangle(m, m->nt, v, m->V[c + 2u], a);
    set_triangle(m, m->nt + 1u, v, a, m->V[c + 1u]);
    m->V[c] = nook_store(v);
    m->nt += 2u;
    m->nv++;
    join(m, q, second);
    join(m, r, third);
    join(m, c + 1u, q + 2u);
    join(m, c + 2u, r + 1u);
    join(m, q + 1u, r + 2u);
    m->G[v] = at;
    m->C[v] = nook_store(c);
    m->C[a] = nook_store(q + 2u);
    return NOOK_OK;
}

nook_status nook_split_edge(nook_mesh *m, uint32_t c, nook_point at) {
    nook_status status = edge_status(m, c);
    uint32_t o, q = 3u * m->nt, r = q + 3u, v = m->nv, end, y, z;
    if (status != NOOK_OK) return status;
    o = across(m, c);
    if (o != NOOK_NONE && m->V[o] == m->V[c]) return NOOK_DUPLICATE_TRIANGLE;
    if (m->nv == m->max_nv || m->max_nt - m->nt < (o == NOOK_NONE ? 1u : 2u)) return NOOK_NO_CAPACITY;
    end = m->V[nook_prev(c)];
    y = across(m, nook_next(c));
    set_triangle(m, m->nt++, m->V[c], v, end);
    m->V[nook_prev(c)] = nook_store(v);
    join(m, q + 1u, y);
    join(m, nook_next(c), q + 2u);
    join(m, q, NOOK_NONE);
    if (o != NOOK_NONE) {
        z = across(m, nook_prev(o));
        set_triangle(m, m->nt++, m->V[o], end, v);
        m->V[nook_next(o)] = nook_store(v);
        join(m, r + 2u, z);
        join(m, nook_prev(o), r + 1u);
        join(m, q, r);
    }
    m->nv++;
    m->G[v] = at;
    m->C[v] = nook_store(nook_prev(c));
    m->C[end] = nook_store(q + 2u);
    return NOOK_OK;
}

/* ---- collapse -------------------------------------------------------------------------------------- */

/* How many neighbours B and C have in common, from their corners at the edge. */
static uint32_t count_common(const nook_view *m, uint32_t b, uint32_t c) {
    ring one, other;
    uint32_t n = 0, v, w;
    if (begin_ring(&one, m, b) != NOOK_OK) return NOOK_NONE;
    while ((v = next_of_ring(&one)) != NOOK_NONE) {
        if (begin_ring(&other, m, c) != NOOK_OK) return NOOK_NONE;
        while ((w = next_of_ring(&other)) != NOOK_NONE) n += v == w;
    }
    return n;
}

static bool is_at_border(const nook_view *m, uint32_t c) {
    nook_star star;
    return nook_star_begin(&star, m, c, false) == NOOK_OK && star.open;
}

/* Vertex v of the triangle across corner x; NOOK_NONE at a border. */
static uint32_t apex(const nook_mesh *m, uint32_t x) { return m->O[x] == x ? NOOK_NONE : m->V[m->O[x]]; }

static nook_status collapse_status(const nook_mesh *m, uint32_t c) {
    nook_view view = nook_view_of(m);
    nook_status status = edge_status(m, c);
    uint32_t o, n = nook_next(c), p = nook_prev(c), common;
    if (status != NOOK_OK) return status;
    o = across(m, c);
    if (o == NOOK_NONE) {
        if (across(m, n) == NOOK_NONE && across(m, p) == NOOK_NONE) return NOOK_LAST_TRIANGLE;
    } else {
        if (m->V[o] == m->V[c]) return NOOK_DUPLICATE_TRIANGLE;
        if (apex(m, n) == m->V[o] && apex(m, p) == m->V[o]) return NOOK_DUPLICATE_TRIANGLE;
        if (is_at_border(&view, n) && is_at_border(&view, p)) return NOOK_NONMANIFOLD_VERTEX;
    }
    common = count_common(&view, n, p);
    if (common == NOOK_NONE) return NOOK_BAD_OPPOSITE;
    return common == (o == NOOK_NONE ? 1u : 2u) ? NOOK_OK : NOOK_DUPLICATE_EDGE;
}

/* The triangle of c goes: its two other neighbours become neighbours of each other, and its vertices, of which v(n(c))
 * is called by its new name by now, get corners there. */
static void close_gap(nook_mesh *m, uint32_t c) {
    nook_view view = nook_view_of(m);
    uint32_t y = across(m, nook_next(c)), z = across(m, nook_prev(c)), stays = y != NOOK_NONE ? y : z;
    uint32_t a = m->V[c], v = m->V[nook_prev(c)];
    if (y != NOOK_NONE) join(m, y, z);
    if (y == NOOK_NONE) join(m, z, NOOK_NONE);
    m->C[a] = nook_store(nook_corner_in(&view, nook_triangle(stays), a));
    m->C[v] = nook_store(nook_corner_in(&view, nook_triangle(stays), v));
}

nook_status nook_collapse(nook_mesh *m, uint32_t c, nook_point at, const nook_renamer *renamer) {
    nook_view view = nook_view_of(m);
    nook_status status = collapse_status(m, c);
    uint32_t o, gone, kept, x;
    nook_star star;
    if (status != NOOK_OK) return status;
    o = across(m, c);
    gone = m->V[nook_next(c)];
    kept = m->V[nook_prev(c)];
    (void)nook_star_begin(&star, &view, nook_next(c), false);
    while ((x = nook_star_next(&star)) != NOOK_NONE) m->V[x] = nook_store(kept);
    close_gap(m, c);
    if (o != NOOK_NONE) close_gap(m, o);
    m->G[kept] = at;
    if (o != NOOK_NONE) {
        drop_triangles(m, nook_triangle(c), nook_triangle(o), renamer);
    } else {
        drop_triangle(m, nook_triangle(c), renamer);
    }
    drop_vertex(m, gone, renamer);
    return NOOK_OK;
}

nook_status nook_remove_vertex(nook_mesh *m, uint32_t v, const nook_renamer *renamer) {
    nook_view view = nook_view_of(m);
    uint32_t c, q, r, a;
    nook_status status;
    if (v >= m->nv || m->C[v] == NOOK_STORED_NONE) return NOOK_INDEX_OUT_OF_RANGE;
    c = m->C[v];
    status = triangle_status(m, c);
    if (status != NOOK_OK) return status;
    q = nook_turn(&view, c, false);
    r = q == NOOK_NONE ? q : nook_turn(&view, q, false);
    if (r == NOOK_NONE || q == c || nook_turn(&view, r, false) != c) return NOOK_WRONG_VALENCE;
    status = triangle_status(m, q);
    if (status == NOOK_OK) status = triangle_status(m, r);
    if (status != NOOK_OK) return status;
    a = m->V[nook_prev(q)];
    if (apex(m, c) == a) return NOOK_DUPLICATE_TRIANGLE;
    m->V[c] = nook_store(a);
    join(m, nook_next(c), across(m, q));
    join(m, nook_prev(c), across(m, r));
    m->C[a] = nook_store(c);
    m->C[m->V[nook_next(c)]] = nook_store(nook_next(c));
    m->C[m->V[nook_prev(c)]] = nook_store(nook_prev(c));
    drop_triangles(m, nook_triangle(q), nook_triangle(r), renamer);
    drop_vertex(m, v, renamer);
    return NOOK_OK;
}
