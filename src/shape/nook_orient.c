/* nook_orient.c -- two searches without a stack; signs of volumes and parities of crossings. */
#include "shape/nook_orient.h"

#include "edit/nook_inner.h"
#include "query/nook_pair.h"

/* ---- triangles -------------------------------------------------------------------------------------
 *
 * O holds the edges as rings (nook_link_rings_begin). Codes of triangles in Mt: 1 to 3 for the corner by which one was
 * entered, 3 more if it runs against the first; 7 for the first, and for those that are done with. Where the corner across
 * is the one by which its triangle was entered, there is the way into it: so the second search finds the ways of the first. It
 * turns a triangle over when it leaves it for good. Both come to every corner once: 3 hops a triangle. */

enum { RINGS, CLEAR, ROOTS, LEARN, TURN, AGREED };
enum { FIRST = 7 };

static uint32_t code_of(const nook_orient_state *s, uint32_t c) {
    return nook_code(s->link.marks.Mt, nook_triangle(c));
}

static bool runs_against(const nook_orient_state *s, uint32_t c) {
    uint32_t code = code_of(s, c);
    return code > 3u && code != FIRST;
}

/* Whether its triangle was entered by c. */
static bool is_entry(const nook_orient_state *s, uint32_t c) {
    uint32_t code = code_of(s, c), corner = c - 3u * nook_triangle(c);
    return code == corner + 1u || code == corner + 4u;
}

/* The only other corner on the edge of c, or NOOK_NONE. */
static uint32_t across(const nook_orient_state *s, uint32_t c) {
    const nook_mesh *m = s->link.mesh;
    uint32_t o = m->O[c];
    return o != c && o < 3u * m->nt && m->O[o] == c ? o : NOOK_NONE;
}

/* Whether the triangle of o runs against the first if it agrees with that of c. */
static bool should_run_against(const nook_orient_state *s, uint32_t c, uint32_t o) {
    const nook_index *V = s->link.mesh->V;
    return runs_against(s, c) == (V[nook_next(c)] == V[nook_prev(o)]);
}

static void enter(nook_orient_state *s, uint32_t c, uint32_t o) {
    bool against = should_run_against(s, c, o);
    nook_set_code(s->link.marks.Mt, nook_triangle(o), o - 3u * nook_triangle(o) + (against ? 4u : 1u));
    s->mixed = s->mixed || against;
    s->balance += against ? -1 : 1;
}

static void compare(nook_orient_state *s, uint32_t c, uint32_t o) {
    if (s->odd || runs_against(s, o) == should_run_against(s, c, o)) return;
    s->odd = true;
    nook_tell(s->link.finder, NOOK_NOT_ORIENTABLE, NOOK_AT_CORNER, c);
    if (s->link.where.kind == NOOK_NOWHERE) s->link.where = nook_at(NOOK_AT_CORNER, c);
}

/* Triangle t is left for good, and runs as most do from now on. */
static void settle(nook_orient_state *s, uint32_t t) {
    nook_index *V = s->link.mesh->V + (size_t)3u * t, keep = V[1];
    bool turn = runs_against(s, 3u * t) == (s->balance >= 0);
    nook_set_code(s->link.marks.Mt, t, FIRST);
    if (!turn) return;
    V[1] = V[2];
    V[2] = keep;
    nook_swap_attributes(s->edit, 3u * t + 1u, 3u * t + 2u);
    s->turned++;
}

/* The search is back at the first triangle's first corner. */
static void end_search(nook_orient_state *s) {
    bool more = s->phase == LEARN && s->mixed && !s->odd;
    if (s->phase == TURN) settle(s, s->at);
    s->phase = more ? TURN : ROOTS;
}

/* Back across the edge by which the triangle was entered, or across another into one, or on to the next corner. */
static bool hop(nook_orient_state *s) {
    bool learns = s->phase == LEARN;
    uint32_t c = s->c, o = across(s, c);
    if (s->left-- == 0) return false;
    if (is_entry(s, c)) {
        if (o == NOOK_NONE) return false;
        if (!learns) settle(s, nook_triangle(c));
    } else if (o != NOOK_NONE && (learns ? code_of(s, o) == 0 : is_entry(s, o))) {
        if (learns) enter(s, c, o);
    } else {
        if (learns && o != NOOK_NONE) compare(s, c, o);
        o = c;
    }
    s->c = nook_next(o);
    if (s->c == 3u * s->at) end_search(s);
    return true;
}

static void try_root(nook_orient_state *s) {
    if (s->at == s->link.mesh->nt) {
        s->phase = AGREED;
    } else if (code_of(s, 3u * s->at) != 0) {
        s->at++;
    } else {
        nook_set_code(s->link.marks.Mt, s->at, FIRST);
        s->balance = 1;
        s->mixed = s->odd = false;
        s->c = 3u * s->at;
        s->phase = LEARN;
    }
}

static void clear(nook_orient_state *s) {
    s->link.marks.Mt[s->at++] = 0;
    if (s->at < NOOK_MT_BYTES(s->link.mesh->nt)) return;
    s->at = 0;
    s->phase = ROOTS;
}

nook_status nook_orient_step(nook_orient_state *s, uint32_t *units) {
    while (s->phase != AGREED) {
        nook_status status = s->phase == RINGS ? nook_link_step(&s->link, units) : NOOK_OK;
        if (status != NOOK_OK) return status;
        if (s->phase == RINGS) s->phase = CLEAR;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->phase == CLEAR) {
            clear(s);
        } else if (s->phase == ROOTS) {
            try_root(s);
        } else if (!hop(s)) {
            s->left = 0;
            return NOOK_BAD_OPPOSITE;
        }
    }
    return s->link.where.kind == NOOK_NOWHERE ? NOOK_OK : NOOK_NOT_ORIENTABLE;
}

nook_status nook_orient_begin(nook_orient_state *s, nook_mesh *mesh, const nook_marks *marks,
                              const nook_edit *edit, const nook_finder *finder) {
    if (s == NULL || mesh == NULL || marks == NULL || marks->Mt == NULL) return NOOK_NULL_ARGUMENT;
    if (marks->max_nt < mesh->nt) return NOOK_NO_CAPACITY;
    memset(s, 0, sizeof *s);
    s->edit = edit;
    s->left = 6u * mesh->nt;
    (void)nook_link_rings_begin(&s->link, mesh);
    s->link.marks = *marks;
    s->link.finder = finder;
    return NOOK_OK;
}

nook_status nook_orient(nook_mesh *mesh, const nook_marks *marks, const nook_edit *edit,
                        const nook_finder *finder, nook_where *where) {
    nook_orient_state state;
    uint32_t units;
    nook_status status = nook_orient_begin(&state, mesh, marks, edit, finder);
    if (where != NULL) *where = nook_at(NOOK_NOWHERE, 0);
    if (status != NOOK_OK) return status;
    do {
        units = 1u << 8; /* any number gives the same */
        status = nook_orient_step(&state, &units);
    } while (status == NOOK_MORE);
    if (where != NULL) *where = state.link.where;
    return status;
}

/* ---- shells ----------------------------------------------------------------------------------------- */

enum { TRIANGLES, PAIRS, CORNERS, KNOWN, REVERSE, DONE, FAILED };
enum { ASK = FAILED + 1 }; /* inside CORNERS */

/* Can the triangle be turned over, and is its shell closed and oriented? */
static nook_status look_at_triangle(nook_orient_shells_state *s, uint32_t t) {
    nook_shell *shell = nook_shell_of(s->shells, t);
    if (shell == NULL) return NOOK_NO_CAPACITY;
    shell->cavity = NOOK_MAYBE;
    if (shell->has_nonmanifold_edge) return NOOK_NONMANIFOLD_EDGE;
    if (shell->border_edges != 0) return NOOK_BORDER_EDGE;
    if (shell->incoherent_edges != 0) return NOOK_INCOHERENT_EDGE;
    return s->mesh != NULL ? nook_triangle_status(s->mesh, 3u * t) : NOOK_OK;
}

/* Whether corner c lies on triangle t, and its own triangle meets t nowhere else. Seen from c, t is three triangles that
 * share that corner and no other; those without area are part of the others. */
static bool stands_on(const nook_view *m, uint32_t c, uint32_t t) {
    const nook_index *T = m->V + (size_t)3u * t;
    nook_index V[6] = {m->V[c], 0, 0, m->V[c], m->V[nook_next(c)], m->V[nook_prev(c)]};
    const nook_point *point[3], *triangle[3];
    nook_view two = *m;
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        if (T[i] == V[4] || T[i] == V[5]) return false;
        point[i] = &m->G[V[0]];
        triangle[i] = &m->G[T[i]];
    }
    if (!nook_triangles_meet(point, triangle)) return false;
    two.V = V;
    for (i = 0; i < 3u; i++) {
        V[1] = T[i];
        V[2] = T[nook_after(i)];
        if (nook_triangles_intersect(&two, 0, 1)) return false;
    }
    return true;
}

/* Triangles t and u meet: do they only touch? */
static bool touch(const nook_view *m, uint32_t t, uint32_t u) {
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        if (stands_on(m, 3u * t + i, u) || stands_on(m, 3u * u + i, t)) return true;
    }
    return false;
}

static nook_status look_at_pairs(nook_orient_shells_state *s, uint32_t *units) {
    const nook_index *component = s->shells->component;
    for (;;) {
        nook_status status = nook_intersections_step(&s->in.pairs, units);
        uint32_t t = s->in.pairs.t, u = s->in.pairs.u;
        if (status == NOOK_OK) s->at = 3u * s->bvh->view.nt;
        if (status != NOOK_TRIANGLE) return status;
        if (component[t] == component[u]) continue;
        s->at = 3u * t;
        if (!touch(&s->bvh->view, t, u)) return NOOK_SELF_INTERSECTION;
        nook_tell(s->finder, NOOK_SELF_INTERSECTION, NOOK_AT_TRIANGLE, t);
        *units -= *units != 0;
        if (*units == 0) return NOOK_MORE; /* one leaf against another has up to 16 pairs */
    }
}

/* If it is not known where the shell of corner c is, ask there. */
static nook_status look_at_corner(nook_orient_shells_state *s, uint32_t c) {
    uint32_t t = nook_triangle(c);
    const nook_point *p[3];
    nook_status status;
    if (nook_shell_of(s->shells, t)->cavity != NOOK_MAYBE) {
        s->at++;
        return NOOK_OK;
    }
    if (!nook_points_of(s->bvh, t, p)) return NOOK_INDEX_OUT_OF_RANGE;
    status = nook_inside_begin(&s->in.inside, s->bvh, *p[c - 3u * t]);
    s->in.inside.component = s->shells->component;
    s->in.inside.skip = s->shells->component[t];
    s->phase = ASK;
    return status;
}

static nook_status ask(nook_orient_shells_state *s, uint32_t *units) {
    nook_status status = nook_inside_step(&s->in.inside, units);
    int side = nook_inside_side(&s->in.inside);
    if (status != NOOK_OK) return status;
    if (side != 0) nook_shell_of(s->shells, nook_triangle(s->at))->cavity = side < 0 ? NOOK_YES : NOOK_NO;
    s->phase = CORNERS;
    s->at++;
    return NOOK_OK;
}

static void reverse(nook_orient_shells_state *s, uint32_t t) {
    const nook_shell *shell = nook_shell_of(s->shells, t);
    int sign = nook_volume_sign(&shell->volume);
    bool is_first = shell->first_triangle == t;
    s->flat += is_first && sign == 0;
    if (sign == (shell->cavity == NOOK_YES ? -1 : 1) || sign == 0) return;
    if (s->mesh != NULL) nook_turn_over(s->mesh, t, s->edit);
    s->inside_out += is_first;
    if (is_first) nook_tell(s->finder, NOOK_INSIDE_OUT, NOOK_AT_TRIANGLE, t);
}

static void next_pass(nook_orient_shells_state *s) {
    s->at = 0;
    s->phase++;
    if (s->phase != PAIRS) return;
    (void)nook_intersections_begin(&s->in.pairs, s->bvh);
    if (s->shells->count < 2u) s->phase = CORNERS;
}

/* at is a corner, of triangles the first. */
static nook_status advance(nook_orient_shells_state *s, uint32_t *units) {
    uint32_t c = s->at, t = nook_triangle(c);
    nook_status status = NOOK_OK;
    if (s->phase == PAIRS) return look_at_pairs(s, units);
    if (s->phase == ASK) return ask(s, units);
    --*units;
    switch (s->phase) {
    case TRIANGLES: status = look_at_triangle(s, t); break;
    case CORNERS: return look_at_corner(s, c);
    case KNOWN:
        if (nook_shell_of(s->shells, t)->cavity == NOOK_MAYBE) status = NOOK_SELF_INTERSECTION;
        break;
    default: reverse(s, t);
    }
    if (status == NOOK_OK) s->at += 3u;
    return status;
}

nook_status nook_orient_shells_step(nook_orient_shells_state *s, uint32_t *units) {
    while (s->phase != DONE) {
        nook_status status;
        if (s->phase == FAILED) return (nook_status)s->at;
        if (s->at == 3u * s->bvh->view.nt) {
            next_pass(s);
            continue;
        }
        if (*units == 0) return NOOK_MORE;
        status = advance(s, units);
        if (status == NOOK_MORE) return status;
        if (status == NOOK_OK) continue;
        s->where = nook_at(NOOK_AT_TRIANGLE, nook_triangle(s->at));
        s->at = (uint32_t)status;
        s->phase = FAILED;
    }
    return NOOK_OK;
}

nook_status nook_orient_shells_begin(nook_orient_shells_state *s, nook_mesh *mesh, const nook_bvh *bvh,
                                     nook_shells *shells, const nook_edit *edit, const nook_finder *finder) {
    nook_status status = nook_bvh_status(bvh);
    if (s == NULL || shells == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    if (status == NOOK_OK) status = nook_shells_status(shells, bvh->view.nt);
    if (status != NOOK_OK) return status;
    if (mesh != NULL && (mesh->nt != bvh->view.nt || mesh->nv != bvh->view.nv)) return NOOK_NO_CAPACITY;
    s->mesh = mesh;
    s->bvh = bvh;
    s->shells = shells;
    s->edit = edit;
    s->finder = finder;
    return NOOK_OK;
}

nook_status nook_orient_shells(nook_orient_shells_state *state, nook_mesh *mesh, const nook_bvh *bvh,
                               nook_shells *shells, const nook_edit *edit, const nook_finder *finder) {
    uint32_t units;
    nook_status status = nook_orient_shells_begin(state, mesh, bvh, shells, edit, finder);
    if (status != NOOK_OK) return status;
    do {
        units = 64; /* any number gives the same */
        status = nook_orient_shells_step(state, &units);
    } while (status == NOOK_MORE);
    return status;
}
