/* nook_survey.c -- components, fans and border loops, with marks and no other memory.
 *
 * Components. Depth-first search over triangles; the code of a triangle is 0 before it is entered,
 * then 1 + (which of its corners it was entered by) + 3 * (whether it runs against the first
 * triangle). The way back from entry corner e is O[e], so there is no stack. Every corner but entry
 * corners is looked across once, every triangle is left once: at most 4T hops.
 *
 * An edge with more than two triangles is a list x -> y -> z -> z in O. Whoever looks across x takes
 * y off the list: a triangle not yet entered gets its way back written into O[y], any other becomes
 * its own opposite. Each corner is taken off once, so this is linear as well, and no two corners of
 * such a list ever name each other, which is how the other passes see that the edge is no pair.
 *
 * Fans and loops cross an edge between two triangles whatever their directions: entering by corner
 * y, the walk about v leaves by the corner that is neither y nor at v. */
#include "table/nook_survey.h"

#include <string.h>

enum phase { CLEAR_STAMPS, CLEAR_FOR_SEARCH, ROOTS, LOOK, BACK, CLEAR_FOR_FANS, FANS, FAN, CLEAR_FOR_LOOPS, LOOPS, LOOP, FINISHED, FAILED };

static nook_status fail(nook_survey_state *s)
{
    s->phase = FAILED;
    return NOOK_BAD_OPPOSITE;
}

static void tell(const nook_survey_state *s, nook_status defect, nook_kind kind, uint32_t index)
{
    if (s->finder != NULL && s->finder->found != NULL) {
        s->finder->found(s->finder->user, defect, nook_at(kind, index));
    }
}

/* The shell being described, or the one of triangle t; null if there is none. */
static nook_shell *current_shell(const nook_survey_state *s)
{
    uint32_t k = s->result->components - 1u;
    return s->shells != NULL && k < s->shells->max_shells ? &s->shells->shell[k] : NULL;
}

static nook_shell *shell_of(const nook_survey_state *s, uint32_t t)
{
    return s->shells != NULL && s->shells->component[t] < s->shells->count ? &s->shells->shell[s->shells->component[t]] : NULL;
}

/* The corner across the edge that c faces if exactly two triangles share it, else c. */
static inline uint32_t across(const nook_survey_state *s, uint32_t c)
{
    uint32_t o = s->view.O[c];
    return s->view.O[o] == c ? o : c;
}

/* The third corner of a triangle, given two: ids 3t + {0,1,2} sum to 9t + 3. */
static inline uint32_t third(uint32_t a, uint32_t b)
{
    return 9u * nook_triangle(a) + 3u - a - b;
}

/* The corner at vertex v of the triangle of x, other than x; NOOK_NONE if there is none. */
static inline uint32_t beside(const nook_survey_state *s, uint32_t x, uint32_t v)
{
    uint32_t n = nook_next(x), p = nook_prev(x);
    if (s->view.V[n] == v) return n;
    return s->view.V[p] == v ? p : NOOK_NONE;
}

/* ---- components ---------------------------------------------------------------------------- */

static void note_vertices(nook_survey_state *s, uint32_t t, nook_shell *shell)
{
    nook_index k = nook_store(s->result->components - 1u);
    uint32_t c;
    for (c = 3u * t; c < 3u * t + 3u; c++) {
        uint32_t v = s->view.V[c];
        if (s->shells->stamp[v] == k) continue;
        s->shells->stamp[v] = k;
        if (shell != NULL) shell->vertices++;
    }
}

/* Enter the triangle of corner e; against: whether it runs against the component's first. */
static void enter(nook_survey_state *s, uint32_t e, bool against)
{
    uint32_t t = nook_triangle(e);
    nook_set_code(s->marks.Mt, t, 1u + (e - 3u * t) + (against ? 3u : 0u));
    s->entry = e;
    s->c = nook_next(e);
    s->phase = LOOK;
    if (s->shells != NULL) {
        nook_shell *shell = current_shell(s);
        s->shells->component[t] = nook_store(s->result->components - 1u);
        if (shell != NULL) shell->triangles++;
        note_vertices(s, t, shell);
    }
}

static void find_root(nook_survey_state *s)
{
    uint32_t t = s->at++;
    nook_shell *shell;
    if (nook_code(s->marks.Mt, t) != 0) return;
    s->result->components++;
    s->odd = false;
    shell = current_shell(s);
    if (shell != NULL) {
        memset(shell, 0, sizeof *shell);
        shell->first_triangle = t;
        shell->orientable = true;
        s->shells->count = s->result->components;
    }
    s->start = 3u * t + 2u;
    enter(s, s->start, false);
}

/* All edges of c are done: the next corner of its triangle, in the order n(entry), p(entry), and for
 * the first triangle, which was entered by no edge, the entry corner itself. */
static void next_corner(nook_survey_state *s)
{
    if (s->c == s->entry) {
        s->phase = ROOTS;
    } else if (s->c == nook_next(s->entry) || s->entry == s->start) {
        s->c = nook_next(s->c);
    } else {
        s->phase = BACK;
    }
}

static bool runs_against(const nook_survey_state *s, uint32_t c)
{
    return nook_code(s->marks.Mt, nook_triangle(c)) > 3u;
}

/* Look across c at o, the only other corner on the edge. */
static void look_at_pair(nook_survey_state *s, uint32_t o)
{
    bool coherent = s->view.V[nook_next(s->c)] == s->view.V[nook_prev(o)];
    bool against = runs_against(s, s->c) == coherent;
    bool entered = nook_code(s->marks.Mt, nook_triangle(o)) != 0;
    nook_shell *shell = current_shell(s);
    if (!coherent && shell != NULL) shell->incoherent_edges += !entered || s->c < o;
    if (!entered) {
        enter(s, o, against);
        return;
    }
    if (runs_against(s, o) != against) {
        if (shell != NULL) shell->orientable = false;
        if (!s->odd && s->lists == NULL) tell(s, NOOK_NOT_ORIENTABLE, NOOK_AT_CORNER, s->c);
        s->odd = true;
        s->result->orientable = NOOK_NO;
    }
    next_corner(s);
}

/* Look across c at y, the next on the list of an edge with more than two triangles. */
static void look_at_list(nook_survey_state *s, uint32_t y)
{
    nook_index *O = s->lists;
    nook_shell *shell = current_shell(s);
    if (shell != NULL) shell->has_nonmanifold_edge = true;
    O[s->c] = O[y] == y ? nook_store(s->c) : O[y];
    if (nook_code(s->marks.Mt, nook_triangle(y)) != 0) {
        O[y] = nook_store(y);
        return;
    }
    O[y] = nook_store(s->c);
    enter(s, y, false);
}

static nook_status look(nook_survey_state *s)
{
    uint32_t c = s->c, o = s->view.O[c];
    if (o == c) {
        nook_shell *shell = current_shell(s);
        if (shell != NULL) shell->border_edges++;
        next_corner(s);
    } else if (s->view.O[o] == c) {
        look_at_pair(s, o);
    } else if (s->lists != NULL) {
        look_at_list(s, o);
    } else {
        return fail(s);
    }
    return NOOK_OK;
}

/* The triangle entered by s->entry is done: back across that edge. A list may have more. */
static void back(nook_survey_state *s)
{
    uint32_t e = s->entry, t;
    s->c = s->view.O[e];
    t = nook_triangle(s->c);
    s->entry = 3u * t + (nook_code(s->marks.Mt, t) - 1u) % 3u;
    s->phase = LOOK;
    if (s->view.O[s->c] == e) next_corner(s);
}

/* ---- fans ---------------------------------------------------------------------------------- */

static void begin_fan(nook_survey_state *s)
{
    uint32_t c = s->at++;
    nook_shell *shell;
    if (nook_bit(s->marks.Mt, c)) return;
    nook_set_bit(s->marks.Mt, c);
    s->result->fans++;
    shell = shell_of(s, nook_triangle(c));
    if (shell != NULL) shell->fans++;
    s->v = s->view.V[c];
    s->home = s->view.C[s->v] == c ? NOOK_NONE : s->view.C[s->v];
    s->start = c;
    s->c = nook_prev(c);
    s->other_way = false;
    s->phase = FAN;
}

/* The fan is complete. If it misses the corner that C names, its vertex has another fan. */
static void end_fan(nook_survey_state *s)
{
    s->phase = FANS;
    if (s->home == NOOK_NONE || nook_bit(s->marks.Mv, s->v)) return;
    nook_set_bit(s->marks.Mv, s->v);
    s->result->nonmanifold_vertices++;
    tell(s, NOOK_NONMANIFOLD_VERTEX, NOOK_AT_VERTEX, s->v);
}

/* Cross the edge that s->c faces, turning about s->v; both ways from the first corner, unless the
 * first way comes round. */
static nook_status turn(nook_survey_state *s)
{
    uint32_t o = across(s, s->c), at_v;
    if (o == s->c) {
        if (s->other_way) {
            end_fan(s);
        } else {
            s->other_way = true;
            s->c = nook_next(s->start);
        }
        return NOOK_OK;
    }
    at_v = beside(s, o, s->v);
    if (at_v == s->start) {
        end_fan(s);
        return NOOK_OK;
    }
    if (at_v == NOOK_NONE || nook_bit(s->marks.Mt, at_v)) return fail(s);
    nook_set_bit(s->marks.Mt, at_v);
    if (at_v == s->home) s->home = NOOK_NONE;
    s->c = third(o, at_v);
    return NOOK_OK;
}

/* ---- loops --------------------------------------------------------------------------------- */

static void begin_loop(nook_survey_state *s)
{
    uint32_t c = s->at++;
    nook_shell *shell;
    if (s->view.O[c] != c || nook_bit(s->marks.Mt, c)) return;
    nook_set_bit(s->marks.Mt, c);
    s->result->border_loops++;
    shell = shell_of(s, nook_triangle(c));
    if (shell != NULL) shell->border_loops++;
    s->start = s->c = c;
    s->v = s->view.V[nook_prev(c)];
    s->phase = LOOP;
}

/* In the triangle of s->c, which was entered across the edge that s->c faces, or faces the border
 * edge that ends at s->v: on to the other edge at s->v. */
static nook_status follow(nook_survey_state *s)
{
    uint32_t at_v = beside(s, s->c, s->v), x, o;
    if (at_v == NOOK_NONE) return fail(s);
    x = third(s->c, at_v);
    o = across(s, x);
    if (o != x) {
        s->c = o;
        return NOOK_OK;
    }
    if (x == s->start) {
        s->phase = LOOPS;
        return NOOK_OK;
    }
    if (nook_bit(s->marks.Mt, x)) return fail(s);
    nook_set_bit(s->marks.Mt, x);
    s->v = s->view.V[s->c]; /* the border edge faced by x runs from v to the vertex of s->c */
    s->c = x;
    return NOOK_OK;
}

/* ---- passes -------------------------------------------------------------------------------- */

static uint32_t length(const nook_survey_state *s)
{
    switch (s->phase) {
    case CLEAR_STAMPS:
        return s->shells != NULL ? s->view.nv : 0;
    case CLEAR_FOR_SEARCH:
    case CLEAR_FOR_LOOPS:
        return (uint32_t)NOOK_MT_BYTES(s->view.nt);
    case CLEAR_FOR_FANS:
        return (uint32_t)(NOOK_MT_BYTES(s->view.nt) + NOOK_MV_BYTES(s->view.nv));
    case ROOTS:
        return s->view.nt;
    case FANS:
    case LOOPS:
        return 3u * s->view.nt;
    default:
        return NOOK_NONE;
    }
}

static void clear(nook_survey_state *s)
{
    uint32_t i = s->at++, bytes = (uint32_t)NOOK_MT_BYTES(s->view.nt);
    if (s->phase == CLEAR_STAMPS) {
        s->shells->stamp[i] = NOOK_STORED_NONE;
    } else if (i < bytes) {
        s->marks.Mt[i] = 0;
    } else {
        s->marks.Mv[i - bytes] = 0;
    }
}

static void next_pass(nook_survey_state *s)
{
    nook_survey *r = s->result;
    s->at = 0;
    s->hops = 11u * s->view.nt + 8u; /* more than any pass needs on tables that hold still */
    switch (s->phase) {
    case CLEAR_STAMPS:
        s->phase = CLEAR_FOR_SEARCH;
        return;
    case CLEAR_FOR_SEARCH:
        s->phase = ROOTS;
        return;
    case ROOTS:
        s->phase = CLEAR_FOR_FANS;
        if (s->lists != NULL) r->orientable = NOOK_MAYBE;
        return;
    case CLEAR_FOR_FANS:
        s->phase = FANS;
        return;
    case FANS:
        s->phase = s->lists != NULL ? FINISHED : CLEAR_FOR_LOOPS;
        if (s->lists == NULL) r->border_loops = 0;
        return;
    case CLEAR_FOR_LOOPS:
        s->phase = LOOPS;
        return;
    default:
        s->phase = FINISHED;
        return;
    }
}

static nook_status hop(nook_survey_state *s)
{
    if (s->hops-- == 0) return fail(s);
    switch (s->phase) {
    case ROOTS:
        find_root(s);
        return NOOK_OK;
    case LOOK:
        return look(s);
    case BACK:
        back(s);
        return NOOK_OK;
    case FANS:
        begin_fan(s);
        return NOOK_OK;
    case FAN:
        return turn(s);
    case LOOPS:
        begin_loop(s);
        return NOOK_OK;
    case LOOP:
        return follow(s);
    default:
        s->hops++;
        clear(s);
        return NOOK_OK;
    }
}

nook_status nook_survey_step(nook_survey_state *s, uint32_t *units)
{
    while (s->phase < FINISHED) {
        if (s->at == length(s)) {
            next_pass(s);
            continue;
        }
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (hop(s) != NOOK_OK) break;
    }
    return s->phase == FINISHED ? NOOK_OK : NOOK_BAD_OPPOSITE;
}

nook_status nook_survey_begin(nook_survey_state *s, const nook_view *view, nook_index *lists,
                              const nook_marks *marks, nook_shells *shells, const nook_finder *finder,
                              nook_survey *result)
{
    if (s == NULL || view == NULL || marks == NULL || result == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->phase = FAILED;
    if (marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
    if (shells != NULL && view->nt != 0 && (shells->component == NULL || shells->stamp == NULL)) return NOOK_NULL_ARGUMENT;
    if (shells != NULL && shells->max_shells != 0 && shells->shell == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt || marks->max_nv < view->nv) return NOOK_NO_CAPACITY;
    memset(result, 0, sizeof *result);
    result->border_loops = NOOK_UNKNOWN;
    result->orientable = NOOK_YES;
    s->view = *view;
    s->lists = lists;
    s->marks = *marks;
    s->shells = shells;
    if (shells != NULL) shells->count = 0;
    s->finder = finder;
    s->result = result;
    s->hops = 1; /* clearing counts none */
    s->phase = CLEAR_STAMPS;
    return NOOK_OK;
}

uint32_t nook_shell_genus(const nook_shell *shell)
{
    /* fans - edges + triangles = 2 - 2g - loops, with 2 edges = 3 triangles + border edges */
    int64_t twice;
    if (!shell->orientable || shell->has_nonmanifold_edge) return NOOK_UNKNOWN;
    twice = 4 - 2 * (int64_t)shell->border_loops - 2 * (int64_t)shell->fans + (int64_t)shell->triangles + (int64_t)shell->border_edges;
    return twice < 0 || twice % 4 != 0 ? NOOK_UNKNOWN : (uint32_t)(twice / 4);
}
