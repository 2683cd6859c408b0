/* nook_levels.c -- vertex splits that undo collapses to the last bit.
 *
 * nook_collapse() closes the gaps of two triangles, gives their numbers and that of the vertex to the last of each kind, and
 * moves C of vertices that had their corner there. Undone in reverse: the last get their numbers back, each by one move; then
 * the gaps at two edges of a vertex are opened. Which triangles change hands need not be recorded: those between the two
 * edges on one side; or if that leads to a border, all from either edge to it. */
#include "shape/nook_levels.h"

#include "edit/nook_inner.h"

enum { A_HAD_C = 1, D_HAD_O = 2, C_HAD_P = 4, C_HAD_N = 8, PLACE = 16, MOST = 4095 };

/* ---- the triangles that change hands ---------------------------------------------------------------- */

/* The corners that face edges A C and D C from the triangles that B gets, and from those that C keeps; none at a border.
 *
 *             A
 *     a_inner | a_outer
 *   ... ------C------ ...
 *     d_inner | d_outer
 *             D                 */
typedef struct opening {
    uint32_t a_inner, a_outer, d_inner, d_outer;
    uint32_t a, c, d;
} opening;

typedef struct sector {
    nook_view view;
    uint32_t first, last, left; /* left: how many may still come; 0: they do not end */
    bool clockwise;
} sector;

static uint32_t sector_begin(sector *s, const nook_mesh *m, const opening *gap) {
    s->view = nook_view_of(m);
    s->last = gap->d_inner == NOOK_NONE ? NOOK_NONE : nook_prev(gap->d_inner);
    s->clockwise = gap->a_inner == NOOK_NONE;
    s->first = s->clockwise ? s->last : nook_next(gap->a_inner);
    s->left = MOST;
    return s->first;
}

/* The corner of B after x: counter-clockwise from A to D, or else to the border and then clockwise from D to it. */
static uint32_t sector_next(sector *s, uint32_t x) {
    if (--s->left == 0) return NOOK_NONE;
    if (x == s->last && !s->clockwise) return NOOK_NONE;
    x = nook_turn(&s->view, x, s->clockwise);
    if (x == NOOK_NONE && !s->clockwise) {
        s->clockwise = true;
        x = s->last;
    }
    if (x != s->first) return x;
    s->left = 0;
    return NOOK_NONE;
}

/* The place of corner y among them, from 1; MOST if it is none of them. 0: they do not end, or are too many. */
NOOK_APART static uint32_t find_place(const nook_mesh *m, const opening *gap, uint32_t y) {
    sector way;
    uint32_t n, x = sector_begin(&way, m, gap), place = MOST;
    for (n = 1; x != NOOK_NONE; n++, x = sector_next(&way, x)) {
        if (x == y) place = n;
    }
    return way.left == 0 ? 0 : place;
}

/* ---- the two edges ---------------------------------------------------------------------------------- */

/* In the finer mesh, where B is still between them. */
static void look_at_edge(const nook_mesh *m, uint32_t c, opening *gap) {
    uint32_t o = nook_across(m, c);
    gap->a_inner = nook_across(m, nook_prev(c));
    gap->a_outer = nook_across(m, nook_next(c));
    gap->d_inner = o == NOOK_NONE ? o : nook_across(m, nook_next(o));
    gap->d_outer = o == NOOK_NONE ? o : nook_across(m, nook_prev(o));
    gap->a = m->V[c];
    gap->c = m->V[nook_prev(c)];
    gap->d = o == NOOK_NONE ? o : m->V[o];
}

/* In the coarser mesh, by corners that face them; whether they have one vertex in common. */
NOOK_APART static bool find_opening(const nook_mesh *m, uint32_t e, uint32_t f, bool border, opening *gap) {
    uint32_t n = m->V[nook_next(e)], p = m->V[nook_prev(e)], fn = NOOK_NONE, fp = NOOK_NONE;
    bool inner;
    if (!border) fn = m->V[nook_next(f)], fp = m->V[nook_prev(f)];
    inner = n == fn || n == fp;
    if (border) inner = f == nook_next(e);
    gap->a = inner ? p : n;
    gap->c = inner ? n : p;
    gap->a_inner = inner ? e : nook_across(m, e);
    gap->a_outer = inner ? nook_across(m, e) : e;
    gap->d = gap->d_inner = gap->d_outer = NOOK_NONE;
    if (border) return true;
    inner = fp == gap->c;
    gap->d = inner ? fn : fp;
    gap->d_inner = inner ? f : nook_across(m, f);
    gap->d_outer = inner ? nook_across(m, f) : f;
    if (!inner && fn != gap->c) return false;
    return gap->a != gap->d;
}

static uint32_t corner_or_none(nook_index c) { return c == NOOK_STORED_NONE ? NOOK_NONE : c; }

/* The corner that x becomes when triangle from is called to. */
static nook_index renamed(uint32_t x, uint32_t from, uint32_t to) {
    return nook_store(nook_triangle(x) == from ? x - 3u * from + 3u * to : x);
}

static bool is_elsewhere(const nook_point *p, const nook_point *q) {
    return nook_bits_that_differ(p, q) != 0;
}

/* ---- collapse --------------------------------------------------------------------------------------- */

/* Everything but e and f in the numbers of the coarser mesh. */
NOOK_APART static nook_status describe(const nook_mesh *m, uint32_t c, nook_point at, nook_vertex_split *s) {
    nook_status status = nook_edge_status(m, c);
    opening gap;
    uint32_t o, b, place;
    if (status != NOOK_OK) return status;
    look_at_edge(m, c, &gap);
    o = nook_across(m, c);
    b = m->V[nook_next(c)];
    place = find_place(m, &gap, m->C[b]);
    if (place == 0) return NOOK_TOO_MANY_TRIANGLES;
    if (m->C[b] == nook_next(c)) place = 0;
    s->gone = m->G[b];
    s->kept = m->G[gap.c];
    s->at = at;
    s->c = nook_store(c);
    s->o = nook_store(o);
    s->v = nook_store(b);
    s->e = nook_store(gap.a_inner != NOOK_NONE ? gap.a_inner : gap.a_outer);
    s->f = nook_store(gap.d_inner != NOOK_NONE ? gap.d_inner : gap.d_outer);
    if (o == NOOK_NONE) s->f = nook_store(s->e == gap.a_inner ? nook_next(s->e) : nook_prev(s->e));
    place *= PLACE;
    if (m->C[gap.a] == c) place |= A_HAD_C;
    if (m->C[gap.c] == nook_prev(c)) place |= C_HAD_P;
    if (o != NOOK_NONE && m->C[gap.d] == o) place |= D_HAD_O;
    if (o != NOOK_NONE && m->C[gap.c] == nook_next(o)) place |= C_HAD_N;
    s->table = nook_store(place);
    return NOOK_OK;
}

static void rename_both(nook_vertex_split *s, uint32_t from, uint32_t to) {
    s->e = renamed(s->e, from, to);
    s->f = renamed(s->f, from, to);
}

nook_status nook_levels_collapse(nook_levels *levels, nook_mesh *m, uint32_t c, nook_point at,
                                 const nook_edit *edit) {
    nook_vertex_split s;
    nook_status status;
    uint32_t t, u;
    if (levels->level >= levels->max) return NOOK_NO_CAPACITY;
    status = describe(m, c, at, &s);
    if (status == NOOK_OK) status = nook_collapse(m, c, at, edit);
    if (status != NOOK_OK) return status;
    t = nook_triangle(c);
    u = s.o == NOOK_STORED_NONE ? t : nook_triangle(s.o);
    if (t != u) rename_both(&s, m->nt + 1u, t > u ? t : u);
    rename_both(&s, m->nt, t > u ? u : t);
    levels->room[levels->level++] = s;
    levels->count = levels->level;
    return NOOK_OK;
}

nook_status nook_levels_coarsen(nook_levels *levels, nook_mesh *m, const nook_edit *edit) {
    const nook_vertex_split *s = levels->split + levels->level;
    nook_status status;
    uint32_t o;
    if (levels->level >= levels->count) return NOOK_INDEX_OUT_OF_RANGE;
    status = nook_edge_status(m, s->c);
    if (status == NOOK_OK) status = nook_point_status(s->at);
    if (status != NOOK_OK) return status;
    o = nook_across(m, s->c);
    if (m->V[nook_next(s->c)] != s->v || o != corner_or_none(s->o)) return NOOK_BAD_OPPOSITE;
    if (is_elsewhere(&m->G[s->v], &s->gone) || is_elsewhere(&m->G[m->V[nook_prev(s->c)]], &s->kept))
        return NOOK_BAD_OPPOSITE;
    status = nook_collapse(m, s->c, s->at, edit);
    levels->level += status == NOOK_OK;
    return status;
}

/* ---- split ------------------------------------------------------------------------------------------ */

/* Whether the split exists, and there is room for it. */
static nook_status numbers_status(const nook_mesh *m, const nook_vertex_split *s) {
    bool border = s->o == NOOK_STORED_NONE;
    uint32_t nt = m->nt + (border ? 1u : 2u);
    if (m->nv >= m->max_nv || nt > m->max_nt) return NOOK_NO_CAPACITY;
    if (s->v > m->nv || s->c >= 3u * nt) return NOOK_INDEX_OUT_OF_RANGE;
    if (border) return NOOK_OK;
    return s->o >= 3u * nt || nook_triangle(s->c) == nook_triangle(s->o) ? NOOK_INDEX_OUT_OF_RANGE : NOOK_OK;
}

NOOK_APART static nook_status refine_status(const nook_mesh *m, const nook_vertex_split *s) {
    nook_status status = numbers_status(m, s);
    opening gap;
    if (status == NOOK_OK) status = nook_edge_status(m, s->e);
    if (status == NOOK_OK) status = nook_edge_status(m, s->f);
    if (status == NOOK_OK) status = nook_point_status(s->gone);
    if (status == NOOK_OK) status = nook_point_status(s->kept);
    if (status != NOOK_OK) return status;
    if (!find_opening(m, s->e, s->f, s->o == NOOK_STORED_NONE, &gap)) return NOOK_BAD_OPPOSITE;
    return find_place(m, &gap, NOOK_NONE) == 0 || is_elsewhere(&m->G[gap.c], &s->at) ? NOOK_BAD_OPPOSITE
                                                                                     : NOOK_OK;
}

/* Triangle t gives its number up, and is the last. */
static void leave(nook_mesh *m, uint32_t t, const nook_edit *edit, nook_vertex_split *s) {
    uint32_t last = m->nt++; /* before it is moved there, for a tree follows */
    nook_move_triangle(m, t, last, edit);
    rename_both(s, t, last);
}

/* B gets its triangles and its corner. */
NOOK_APART static void give_to_new(nook_mesh *m, const opening *gap, const nook_vertex_split *s) {
    sector way;
    uint32_t x, next, place = s->table / PLACE;
    m->C[s->v] = nook_store(place == 0 || s->o == NOOK_STORED_NONE ? nook_next(s->c) : nook_prev(s->o));
    for (x = sector_begin(&way, m, gap); x != NOOK_NONE; x = next) {
        next = sector_next(&way, x);
        m->V[x] = s->v;
        if (--place == 0) m->C[s->v] = nook_store(x);
        if (m->C[gap->c] == x) m->C[gap->c] = nook_store(nook_prev(s->c)); /* only of a spoiled record */
    }
}

/* The triangle of corner x, which is at a, and its neighbours; then follow v and w. */
static void put_triangle(nook_mesh *m, uint32_t x, uint32_t a, uint32_t v, uint32_t w, uint32_t across_v,
                         uint32_t across_w) {
    m->V[x] = nook_store(a);
    m->V[nook_next(x)] = nook_store(v);
    m->V[nook_prev(x)] = nook_store(w);
    nook_join(m, nook_next(x), across_v);
    nook_join(m, nook_prev(x), across_w);
}

NOOK_APART static void split(nook_mesh *m, nook_vertex_split *s, const nook_edit *edit) {
    uint32_t c = s->c, o = corner_or_none(s->o), t = nook_triangle(c),
             u = o == NOOK_NONE ? t : nook_triangle(o);
    opening gap;
    m->nv++;
    nook_move_vertex(m, s->v, m->nv - 1u, edit);
    leave(m, t < u ? t : u, edit, s);
    if (t != u) leave(m, t < u ? u : t, edit, s);
    (void)find_opening(m, s->e, s->f, o == NOOK_NONE, &gap);
    give_to_new(m, &gap, s);
    m->G[s->v] = s->gone;
    m->G[gap.c] = s->kept;
    put_triangle(m, c, gap.a, s->v, gap.c, gap.a_outer, gap.a_inner);
    if (o != NOOK_NONE) put_triangle(m, o, gap.d, gap.c, s->v, gap.d_inner, gap.d_outer);
    nook_join(m, c, o);
    if ((s->table & A_HAD_C) != 0) m->C[gap.a] = nook_store(c);
    if ((s->table & C_HAD_P) != 0) m->C[gap.c] = nook_store(nook_prev(c));
    if (o == NOOK_NONE) return;
    if ((s->table & D_HAD_O) != 0) m->C[gap.d] = nook_store(o);
    if ((s->table & C_HAD_N) != 0) m->C[gap.c] = nook_store(nook_next(o));
}

nook_status nook_levels_refine(nook_levels *levels, nook_mesh *m, const nook_edit *edit) {
    nook_vertex_split s;
    nook_status status;
    if (levels->level == 0) return NOOK_INDEX_OUT_OF_RANGE;
    s = levels->split[levels->level - 1u];
    status = refine_status(m, &s);
    if (status != NOOK_OK) return status;
    split(m, &s, edit);
    nook_follow_fan(m, nook_next(s.c), edit);
    nook_follow_fan(m, nook_prev(s.c), edit);
    levels->level--;
    return NOOK_OK;
}

/* ---- many ------------------------------------------------------------------------------------------- */

/* Whether a level finer there are at most nt triangles. */
static bool can_refine(const nook_levels *levels, const nook_mesh *m, uint32_t nt) {
    if (levels->level == 0 || m->nt >= nt) return false;
    return levels->split[levels->level - 1u].o == NOOK_STORED_NONE || nt - m->nt >= 2u;
}

nook_status nook_levels_step(nook_levels *levels, nook_mesh *m, uint32_t nt, const nook_edit *edit,
                             uint32_t *units) {
    nook_status status = NOOK_OK;
    while (status == NOOK_OK) {
        bool down = m->nt > nt && levels->level < levels->count;
        if (!down && !can_refine(levels, m, nt)) return NOOK_OK;
        if (*units == 0) return NOOK_MORE;
        --*units;
        status = down ? nook_levels_coarsen(levels, m, edit) : nook_levels_refine(levels, m, edit);
    }
    return status;
}
