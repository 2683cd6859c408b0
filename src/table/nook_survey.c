/* nook_survey.c -- components, fans and border loops, with marks and no other memory.
 *
 * Components. Depth-first search over triangles; the code of a triangle is 0 before it is entered,
 * then 1 + (which of its corners it was entered by) + 3 * (whether it runs against the first
 * triangle). The way back from entry corner e is O[e], so there is no stack. Every corner but entry
 * corners is looked across once, every triangle is left once: at most 5T hops.
 *
 * An edge with more than two triangles is a ring x -> y -> z -> x in O. Whoever looks across x takes
 * y off the ring: a triangle not yet entered gets its way back written into O[y], any other becomes
 * its own opposite. When two are left the ring opens, x -> z -> z, so that no two of its corners ever
 * name each other, which is how all passes see that the edge is no pair. Each corner is taken off
 * once, so this is linear as well.
 *
 * Fans and loops cross an edge between two triangles whatever their directions: entering by corner
 * y, the walk about v leaves by the corner that is neither y nor at v. Fans mark each corner once,
 * loops turn once through each fan of the border. */
#include "table/nook_survey.h"

#include <string.h>

enum phase { CLEAR, ROOTS, CLEAR_FOR_FANS, FANS, CLEAR_FOR_LOOPS, LOOPS, FINISHED, FAILED };
enum inner { LOOK = FAILED + 1, BACK, FAN, LOOP }; /* inside ROOTS, FANS and LOOPS */

/* O[c], or c itself where the table names no corner: then nothing is mutual, and nothing is read
 * outside the tables whatever O holds. */
static inline uint32_t opposite(const nook_survey_state *s, uint32_t c) {
    uint32_t o = s->view.O[c];
    return o < 3u * s->view.nt ? o : c;
}

/* The corner across the edge that c faces if exactly two triangles share it, else c. */
static inline uint32_t across(const nook_survey_state *s, uint32_t c) {
    uint32_t o = opposite(s, c);
    return s->view.O[o] == c ? o : c;
}

/* The third corner of a triangle, given two: 3t, 3t+1, 3t+2 sum to 9t + 3. */
static inline uint32_t third(uint32_t a, uint32_t b) { return 9u * nook_triangle(a) + 3u - a - b; }

/* The corner at vertex v of the triangle of x, other than x; NOOK_NONE if there is none. */
static inline uint32_t beside(const nook_survey_state *s, uint32_t x, uint32_t v) {
    uint32_t n = nook_next(x), p = nook_prev(x);
    return s->view.V[n] == v ? n : s->view.V[p] == v ? p : NOOK_NONE;
}

static bool runs_against(const nook_survey_state *s, uint32_t c) {
    return nook_code(s->marks.Mt, nook_triangle(c)) > 3u;
}

static bool entered(const nook_survey_state *s, uint32_t c) {
    return nook_code(s->marks.Mt, nook_triangle(c)) != 0;
}

/* The shell of corner c, or null if it is not described. */
static nook_shell *shell_at(const nook_survey_state *s, uint32_t c) {
    return nook_shell_of(s->shells, nook_triangle(c));
}

/* ---- components ------------------------------------------------------------------------------- */

/* Enter the triangle of corner e; against: whether it runs against the component's first. */
static void enter(nook_survey_state *s, uint32_t e, bool against) {
    uint32_t t = nook_triangle(e), i;
    nook_index k = nook_store(s->result->components - 1u);
    nook_shell *shell;
    nook_set_code(s->marks.Mt, t, 1u + (e - 3u * t) + (against ? 3u : 0u));
    s->entry = e;
    s->c = nook_next(e);
    s->phase = LOOK;
    if (s->shells == NULL) return;
    s->shells->component[t] = k;
    shell = shell_at(s, e);
    if (shell != NULL) shell->triangles++;
    for (i = 0; i < 3u; i++) {
        uint32_t v = s->view.V[3u * t + i];
        if (v >= s->view.nv || s->shells->stamp[v] == k) continue;
        s->shells->stamp[v] = k;
        if (shell != NULL) shell->vertices++;
    }
}

static void find_root(nook_survey_state *s, uint32_t t) {
    if (entered(s, 3u * t)) return;
    if (s->shells != NULL && s->result->components < s->shells->max_shells) {
        nook_shell *shell = &s->shells->shell[s->shells->count++];
        memset(shell, 0, sizeof *shell);
        shell->first_triangle = t;
        shell->orientable = true;
        shell->cavity = NOOK_MAYBE;
    }
    s->result->components++;
    s->odd = false;
    s->start = 3u * t + 2u;
    enter(s, s->start, false);
}

/* All edges of c are done: the next corner of its triangle, in the order n(entry), p(entry), and for
 * the first triangle, which was entered by no edge, the entry corner itself. */
static void next_corner(nook_survey_state *s) {
    if (s->c == s->entry) {
        s->phase = ROOTS;
    } else if (s->c == nook_next(s->entry) || s->entry == s->start) {
        s->c = nook_next(s->c);
    } else {
        s->phase = BACK;
    }
}

/* Look across c at o, the only other corner on the edge. */
static void look_at_pair(nook_survey_state *s, uint32_t o) {
    bool coherent = s->view.V[nook_next(s->c)] == s->view.V[nook_prev(o)];
    bool against = runs_against(s, s->c) == coherent, first = !entered(s, o);
    nook_shell *shell = shell_at(s, s->c);
    if (!coherent && shell != NULL) shell->incoherent_edges += first || s->c < o;
    if (first) {
        enter(s, o, against);
        return;
    }
    if (runs_against(s, o) != against) {
        if (shell != NULL) shell->orientable = false;
        if (!s->odd && s->rings == NULL) nook_tell(s->finder, NOOK_NOT_ORIENTABLE, NOOK_AT_CORNER, s->c);
        s->odd = true;
        if (s->rings == NULL) s->result->orientable = NOOK_NO;
    }
    next_corner(s);
}

/* Look across c at y, the next on the ring of an edge with more than two triangles. */
static bool look_at_ring(nook_survey_state *s, uint32_t y) {
    nook_index *O = s->rings;
    uint32_t x = s->c, next = O[y];
    nook_shell *shell = shell_at(s, x);
    if (next >= 3u * s->view.nt) return false;
    if (shell != NULL) shell->has_nonmanifold_edge = true;
    O[x] = nook_store(next == y ? x : next);
    if (O[next] == x) O[next] = nook_store(next);
    O[y] = nook_store(entered(s, y) ? y : s->c);
    if (!entered(s, y)) enter(s, y, false);
    return true;
}

static bool look(nook_survey_state *s) {
    uint32_t o = s->view.O[s->c];
    nook_shell *shell = shell_at(s, s->c);
    if (o >= 3u * s->view.nt) return false;
    if (o != s->c && s->view.O[o] != s->c) return s->rings != NULL && look_at_ring(s, o);
    if (o != s->c) {
        look_at_pair(s, o);
    } else {
        if (shell != NULL) shell->border_edges++;
        next_corner(s);
    }
    return true;
}

/* The triangle entered by s->entry is done: back across that edge. A ring may have more. */
static bool back(nook_survey_state *s) {
    uint32_t e = s->entry, t, k;
    s->c = opposite(s, e);
    t = nook_triangle(s->c);
    k = nook_code(s->marks.Mt, t);
    if (k == 0 || k == 7u) return false;
    s->entry = 3u * t + (k > 3u ? k - 4u : k - 1u);
    s->phase = LOOK;
    if (s->view.O[s->c] == e) next_corner(s);
    return true;
}

/* ---- fans ------------------------------------------------------------------------------------- */

static bool find_fan(nook_survey_state *s, uint32_t c) {
    nook_shell *shell = shell_at(s, c);
    if (nook_bit(s->marks.Mt, c)) return true;
    s->v = s->view.V[c];
    if (s->v >= s->view.nv) return false;
    nook_set_bit(s->marks.Mt, c);
    s->result->fans++;
    if (shell != NULL) shell->fans++;
    s->home = s->view.C[s->v] == c ? NOOK_NONE : s->view.C[s->v];
    s->start = c;
    s->c = nook_prev(c);
    s->other_way = false;
    s->phase = FAN;
    return true;
}

/* The fan is complete. If it misses the corner that C names, its vertex has another fan. */
static bool end_fan(nook_survey_state *s) {
    s->phase = FANS;
    if (s->home == NOOK_NONE || nook_bit(s->marks.Mv, s->v)) return true;
    nook_set_bit(s->marks.Mv, s->v);
    s->result->nonmanifold_vertices++;
    nook_tell(s->finder, NOOK_NONMANIFOLD_VERTEX, NOOK_AT_VERTEX, s->v);
    return true;
}

/* Cross the edge that s->c faces, turning about s->v; both ways from the first corner, unless the
 * first way comes round. */
static bool turn(nook_survey_state *s) {
    uint32_t o = across(s, s->c), at_v;
    if (o == s->c) {
        if (s->other_way) return end_fan(s);
        s->other_way = true;
        s->c = nook_next(s->start);
        return true;
    }
    at_v = beside(s, o, s->v);
    if (at_v == s->start) return end_fan(s);
    if (at_v == NOOK_NONE || nook_bit(s->marks.Mt, at_v)) return false;
    nook_set_bit(s->marks.Mt, at_v);
    if (at_v == s->home) s->home = NOOK_NONE;
    s->c = third(o, at_v);
    return true;
}

/* ---- loops ------------------------------------------------------------------------------------ */

static void find_loop(nook_survey_state *s, uint32_t c) {
    nook_shell *shell = shell_at(s, c);
    if (across(s, c) != c || nook_bit(s->marks.Mt, c)) return;
    nook_set_bit(s->marks.Mt, c);
    s->result->border_loops++;
    if (shell != NULL) shell->border_loops++;
    s->start = s->c = c;
    s->v = s->view.V[nook_prev(c)];
    s->phase = LOOP;
}

/* In the triangle of s->c, which was entered across the edge that s->c faces, or faces the border
 * edge that ends at s->v: on to the other edge at s->v. */
static bool follow(nook_survey_state *s) {
    uint32_t at_v = beside(s, s->c, s->v), x, o;
    if (at_v == NOOK_NONE) return false;
    x = third(s->c, at_v);
    o = across(s, x);
    if (o != x) {
        s->c = o;
    } else if (x == s->start) {
        s->phase = LOOPS;
    } else {
        if (nook_bit(s->marks.Mt, x)) return false;
        nook_set_bit(s->marks.Mt, x);
        s->v = s->view.V[s->c]; /* the border edge that x faces runs from v to the vertex of s->c */
        s->c = x;
    }
    return true;
}

/* ---- passes ----------------------------------------------------------------------------------- */

/* The next item of a pass of n, or NOOK_NONE and on to the next pass. */
static uint32_t item(nook_survey_state *s, uint32_t n) {
    if (s->at < n) return s->at++;
    s->at = 0;
    s->hops = 11u * s->view.nt + 8u; /* more than a pass needs on tables that hold still */
    s->phase++;
    if (s->phase == FINISHED && s->rings != NULL) s->result->border_loops = NOOK_UNKNOWN;
    return NOOK_NONE;
}

static void clear(nook_survey_state *s) {
    uint32_t mt = (uint32_t)NOOK_MT_BYTES(s->view.nt), i = item(s, mt > s->view.nv ? mt : s->view.nv);
    s->hops++;
    if (i < mt) s->marks.Mt[i] = 0;
    if (i < NOOK_MV_BYTES(s->view.nv)) s->marks.Mv[i] = 0;
    if (i < s->view.nv && s->shells != NULL && s->phase == CLEAR) s->shells->stamp[i] = NOOK_STORED_NONE;
}

static bool hop(nook_survey_state *s) {
    uint32_t i;
    switch (s->phase) {
    case LOOK: return look(s);
    case BACK: return back(s);
    case FAN: return turn(s);
    case LOOP: return follow(s);
    case ROOTS:
        i = item(s, s->view.nt);
        if (i != NOOK_NONE) find_root(s, i);
        return true;
    case FANS: i = item(s, 3u * s->view.nt); return i == NOOK_NONE || find_fan(s, i);
    case LOOPS:
        i = item(s, 3u * s->view.nt);
        if (i != NOOK_NONE) find_loop(s, i);
        return true;
    default: clear(s); return true;
    }
}

nook_status nook_survey_step(nook_survey_state *s, uint32_t *units) {
    while (s->phase != FINISHED) {
        if (s->phase == FAILED) return NOOK_BAD_OPPOSITE;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->hops-- == 0 || !hop(s)) s->phase = FAILED;
    }
    return NOOK_OK;
}

nook_status nook_survey_begin(nook_survey_state *s, const nook_view *view, nook_index *rings,
                              const nook_marks *marks, nook_shells *shells, const nook_finder *finder,
                              nook_survey *result) {
    if (s == NULL || view == NULL || marks == NULL || result == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->phase = FAILED;
    if (marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt || marks->max_nv < view->nv) return NOOK_NO_CAPACITY;
    if (nook_shells_status(shells, view->nt) != NOOK_OK) return NOOK_NULL_ARGUMENT;
    memset(result, 0, sizeof *result);
    result->orientable = rings != NULL ? NOOK_MAYBE : NOOK_YES;
    if (shells != NULL) shells->count = 0;
    s->view = *view;
    s->rings = rings;
    s->marks = *marks;
    s->shells = shells;
    s->finder = finder;
    s->result = result;
    s->hops = 1;
    s->phase = CLEAR;
    return NOOK_OK;
}

uint32_t nook_shell_genus(const nook_shell *shell) {
    /* fans - edges + triangles = 2 - 2g - loops, with 2 edges = 3 triangles + border edges */
    int64_t four_g = 4 + (int64_t)shell->triangles + shell->border_edges;
    four_g -= 2 * ((int64_t)shell->border_loops + shell->fans);
    if (!shell->orientable || shell->has_nonmanifold_edge || four_g < 0 || four_g % 4 != 0)
        return NOOK_UNKNOWN;
    return (uint32_t)(four_g / 4);
}
