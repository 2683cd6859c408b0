/* nook_trees.c -- once round every component, along edges and across the tree. */
#include "walk/nook_trees.h"

#include <string.h>

enum { CLEAR, BORDERS, CLOSED, DONE };
enum { ROOT = 4 }; /* the code of a triangle that was entered across no edge */

/* The corner across the edge of c, or NOOK_NONE at a border and where O names none. */
static uint32_t across(const nook_view *m, uint32_t c) {
    uint32_t o = m->O[c];
    return o == c || o >= 3u * m->nt ? NOOK_NONE : o;
}

static uint32_t code_of(const nook_trees *s, uint32_t c) { return nook_code(s->marks.Mt, nook_triangle(c)); }
static uint32_t entry_code(uint32_t c) { return c - 3u * nook_triangle(c) + 1u; }
static bool is_entry(const nook_trees *s, uint32_t c) { return code_of(s, c) == entry_code(c); }

nook_status nook_trees_begin(nook_trees *s, const nook_view *view, const nook_marks *marks, nook_index *up) {
    if (s == NULL || view == NULL || marks == NULL || up == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->Mt == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < view->nt) return NOOK_NO_CAPACITY;
    memset(s, 0, sizeof *s);
    s->view = view;
    s->marks = *marks;
    s->up = up;
    return NOOK_OK;
}

/* Vertex v, if it is new, hangs on the edge that c faces, or is a root and c a corner at it. */
static bool reach(nook_trees *s, uint32_t v, uint32_t c) {
    if (v >= s->view->nv || s->up[v] != NOOK_STORED_NONE) return false;
    s->up[v] = nook_store(c);
    return true;
}

/* The edge of c comes last in its component: where it ends, the way round begins. */
static void begin_component(nook_trees *s, uint32_t c, uint32_t code) {
    nook_set_code(s->marks.Mt, nook_triangle(c), code);
    (void)reach(s, s->view->V[nook_prev(c)], nook_prev(c));
    s->components++;
    s->c = s->first = nook_next(c);
    s->looking = true;
}

/* Along one edge of the polygon, or across: into a new triangle, or back where this one was entered from. */
static void look(nook_trees *s) {
    uint32_t c = s->c, o = across(s->view, c);
    if (o != NOOK_NONE && code_of(s, o) == 0) {
        nook_set_code(s->marks.Mt, nook_triangle(o), entry_code(o));
    } else if (!is_entry(s, c)) {
        s->sides += o == NOOK_NONE ? 2u : 1u;
        if (reach(s, s->view->V[nook_prev(c)], c)) s->sides -= 2u;
        o = NOOK_NONE;
    }
    s->c = nook_next(o == NOOK_NONE ? c : o);
    s->looking = s->c != s->first;
}

/* Holes first: a component with a border is entered from one. */
static void visit(nook_trees *s, uint32_t i) {
    if (s->phase == CLEAR) {
        if (i < NOOK_MT_BYTES(s->view->nt)) s->marks.Mt[i] = 0;
        if (i < s->view->nv) s->up[i] = NOOK_STORED_NONE;
    } else if (s->phase == BORDERS) {
        if (nook_is_border(s->view, i) && code_of(s, i) == 0) begin_component(s, i, entry_code(i));
    } else if (code_of(s, 3u * i) == 0) {
        begin_component(s, 3u * i, ROOT);
    }
}

static uint32_t length(const nook_trees *s) {
    uint32_t mt = (uint32_t)NOOK_MT_BYTES(s->view->nt), nv = s->view->nv;
    if (s->phase == CLEAR) return mt > nv ? mt : nv;
    return s->phase == BORDERS ? 3u * s->view->nt : s->view->nt;
}

nook_status nook_trees_step(nook_trees *s, uint32_t *units) {
    while (s->phase != DONE) {
        if (!s->looking && s->at == length(s)) {
            s->at = 0;
            s->phase++;
            continue;
        }
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (!s->looking) {
            visit(s, s->at++);
        } else if (s->hops == 3u * s->view->nt) {
            return NOOK_BAD_OPPOSITE;
        } else {
            s->hops++;
            look(s);
        }
    }
    s->generators = s->sides / 2u;
    return NOOK_OK;
}

/* ---- asked ------------------------------------------------------------------------------------------ */

bool nook_in_triangle_tree(const nook_trees *s, uint32_t c) {
    uint32_t o = across(s->view, c);
    return is_entry(s, c) || is_entry(s, o == NOOK_NONE ? c : o);
}

/* Whether v hangs on the edge of c. */
static bool hangs(const nook_trees *s, uint32_t v, uint32_t c) {
    return v < s->view->nv && (s->up[v] == c || s->up[v] == s->view->O[c]);
}

bool nook_in_vertex_tree(const nook_trees *s, uint32_t c) {
    return hangs(s, s->view->V[nook_next(c)], c) || hangs(s, s->view->V[nook_prev(c)], c);
}

bool nook_is_generator(const nook_trees *s, uint32_t c) {
    return c <= s->view->O[c] && !nook_in_triangle_tree(s, c) && !nook_in_vertex_tree(s, c);
}

/* ---- loops ------------------------------------------------------------------------------------------ */

nook_status nook_loop_begin(nook_loop *l, const nook_trees *trees, uint32_t c) {
    if (c >= 3u * trees->view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    l->trees = trees;
    l->corner = nook_next(c);
    l->vertex = l->start = trees->view->V[l->corner];
    l->left = 2u * trees->view->nv;
    l->first = c;
    return NOOK_OK;
}

/* The other end of the edge up from v; NOOK_NONE at a root, of which c faces no edge. */
static uint32_t above(const nook_view *m, uint32_t v, uint32_t c) {
    uint32_t a, b;
    if (c >= 3u * m->nt) return NOOK_NONE;
    a = m->V[nook_next(c)];
    b = m->V[nook_prev(c)];
    return v == a ? b : v == b ? a : NOOK_NONE;
}

/* Hang vertex on the edge of corner, which it held up before; beyond the root, the first edge. */
static void turn_over(nook_loop *l) {
    const nook_view *m = l->trees->view;
    nook_index *up = &l->trees->up[l->vertex];
    uint32_t c = *up, next = above(m, l->vertex, c);
    *up = nook_store(l->corner);
    l->corner = c;
    l->vertex = next;
    if (next != NOOK_NONE) return;
    l->corner = l->first;
    l->vertex = m->V[nook_prev(l->first)];
    l->first = NOOK_NONE;
}

nook_status nook_loop_step(nook_loop *l, uint32_t *units) {
    const nook_trees *s = l->trees;
    while (l->first != NOOK_NONE || l->vertex != l->start) {
        bool climbs = l->first == NOOK_NONE;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (l->left == 0 || l->vertex >= s->view->nv) return NOOK_NONMANIFOLD_VERTEX;
        l->left--;
        if (climbs) {
            l->corner = s->up[l->vertex];
            l->vertex = above(s->view, l->vertex, l->corner);
        } else {
            turn_over(l);
        }
        if (l->first == NOOK_NONE) return l->vertex < s->view->nv ? NOOK_TRIANGLE : NOOK_NONMANIFOLD_VERTEX;
    }
    return NOOK_OK;
}
