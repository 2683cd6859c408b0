/* nook_hull.c -- quickhull without a stack, a heap or a list of its own; nook_hull.h says why it is right.
 *
 * Where things are while it runs:
 *   V[3 t]        the first vertex of face t, or the first point of its list; C of a point is the next, and where a vertex
 *                 of the hull (its bit in Mv is set) comes, the list has ended, and that is the first vertex of t
 *   C[a], O[o]    of the rim: C of a vertex is the corner o that faces its edge a b from outside, O[o] is b
 *   O[c]          of a face that is gone (its bit in Mt is set), entered by corner c: c of the next one in the queue
 * The corner by which a face was entered leads back to one that is gone already, so nobody misses it. When all neighbours
 * have been looked at, the queue is the list of numbers that are free for new faces. A disk of k faces has a rim of at most
 * k + 2 edges, and all together there are never more than the 2 m - 4 faces of m points. */
#include "shape/nook_hull.h"

#include "edit/nook_inner.h"

enum { LOOK, EMPTY, CHOOSE, SPREAD, BUILD, SHARE, SCAN, FIND, FARTHEST, EXAMINE, JUDGE, FILL };
enum { EMPTY_AGAIN = FILL + 1, USE, MOVE, RENAME, NAME, DONE }; /* passes that make a mesh of it */

enum { LOOKS = 16 }; /* along a list, in a step */

static bool is_on_hull(const nook_hull_state *h, uint32_t v) { return nook_bit(h->marks.Mv, v); }
static bool is_gone(const nook_hull_state *h, uint32_t t) { return nook_bit(h->marks.Mt, t); }

/* Where q is of triangle t, whose first vertex is a: +1 is outside. */
static int side_of(const nook_hull_state *h, uint32_t a, uint32_t t, uint32_t q) {
    const nook_mesh *m = h->mesh;
    return nook_orient3d(&m->G[a], &m->G[m->V[3u * t + 1u]], &m->G[m->V[3u * t + 2u]], &m->G[q]);
}

static void put_on_list(const nook_hull_state *h, uint32_t q, uint32_t t) {
    h->mesh->C[q] = h->mesh->V[3u * t];
    h->mesh->V[3u * t] = nook_store(q);
}

static void set_rim(nook_hull_state *h, uint32_t a, uint32_t o, uint32_t b) {
    h->mesh->C[a] = nook_store(o);
    h->mesh->O[o] = nook_store(b);
    h->rim = h->a = a;
}

/* ---- the first four -------------------------------------------------------------------------------- */

/* Whether v is not the point, or on the line or in the plane of those found. */
static bool is_apart(const nook_hull_state *h, uint32_t v) {
    const nook_point *G = h->mesh->G, *a = &G[h->four[0]], *b = &G[h->four[1]], *p = &G[v];
    uint32_t axis;
    switch (h->found) {
    case 0: return true;
    case 1: return p->x != a->x || p->y != a->y || p->z != a->z;
    case 2: return nook_facing(a, b, p, &axis) != 0;
    default: return nook_orient3d(a, b, &G[h->four[2]], p) != 0;
    }
}

/* A triangle that does not see the fourth point, and that point to be joined to its rim. */
static void begin_hull(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    const uint32_t *v = h->four;
    uint32_t i;
    nook_set_triangle(m, 0, v[0], v[1], v[2]);
    if (side_of(h, v[0], 0, v[3]) > 0) nook_set_triangle(m, 0, v[0], v[2], v[1]);
    for (i = 0; i < 4u; i++) nook_set_bit(h->marks.Mv, v[i]);
    for (i = 0; i < 3u; i++) set_rim(h, m->V[nook_prev(i)], i, m->V[nook_next(i)]);
    nook_clear_bit(h->marks.Mt, 0);
    m->nt = 1;
    h->p = h->waiting = v[3];
    h->at = 0;
    h->phase = SPREAD;
}

/* The first points that will do: what comes before them is in their plane. */
static nook_status choose(nook_hull_state *h) {
    if (h->at == h->nv) {
        h->mesh->nt = 0;
        return NOOK_FLAT_SHELL;
    }
    if (is_apart(h, h->at)) h->four[h->found++] = h->at;
    h->at++;
    if (h->found == 4u) begin_hull(h);
    return NOOK_OK;
}

/* Points outside the first triangle go to its list, all others wait for the faces of the fourth point. */
static void spread(nook_hull_state *h, uint32_t v) {
    if (is_on_hull(h, v)) return;
    if (side_of(h, h->four[0], 0, v) > 0) {
        put_on_list(h, v, 0);
    } else {
        h->mesh->C[v] = nook_store(h->waiting);
        h->waiting = v;
    }
}

/* ---- the farthest point ---------------------------------------------------------------------------- */

static void begin_list(nook_hull_state *h, uint32_t t, uint32_t phase) {
    h->t = t;
    h->last = h->apex = h->mesh->V[3u * t];
    h->phase = phase;
}

/* Whether the end of the list is found. */
static bool follow_list(nook_hull_state *h) {
    uint32_t i;
    for (i = 0; i < LOOKS; i++) {
        if (is_on_hull(h, h->apex)) return true;
        h->last = h->apex;
        h->apex = h->mesh->C[h->apex];
    }
    return false;
}

/* Round and round, until no face has a list. */
static void scan(nook_hull_state *h) {
    uint32_t i;
    for (i = 0; i < LOOKS && h->phase == SCAN; i++) {
        h->scan = h->scan + 1u < h->mesh->nt ? h->scan + 1u : 0;
        if (!is_on_hull(h, h->mesh->V[3u * h->scan])) {
            h->quiet = 0;
            begin_list(h, h->scan, FIND);
        } else if (++h->quiet == h->mesh->nt) {
            h->phase = FILL;
        }
    }
}

static float height(const nook_hull_state *h, uint32_t q) {
    return nook_dot(nook_sub(h->mesh->G[q], h->mesh->G[h->apex]), h->normal);
}

static void begin_farthest(nook_hull_state *h) {
    const nook_mesh *m = h->mesh;
    nook_point a = m->G[h->apex];
    h->normal = nook_cross(nook_sub(m->G[m->V[3u * h->t + 1u]], a), nook_sub(m->G[m->V[3u * h->t + 2u]], a));
    h->last = m->V[3u * h->t];
    h->most = height(h, h->last);
    h->phase = FARTHEST;
}

/* Face h->t is gone, and its list waits. */
static void take_away(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    nook_set_bit(h->marks.Mt, h->t);
    h->spares++;
    if (m->V[3u * h->t] == h->apex) return;
    m->C[h->last] = nook_store(h->waiting);
    h->waiting = m->V[3u * h->t];
    m->V[3u * h->t] = nook_store(h->apex);
}

/* The farthest is first on the list, and leaves it. */
static void begin_search(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    h->p = h->waiting = m->V[3u * h->t];
    m->V[3u * h->t] = m->C[h->p];
    nook_set_bit(h->marks.Mv, h->p);
    take_away(h);
    h->first = h->c = h->x = h->tail = 3u * h->t;
    h->phase = EXAMINE;
}

/* A point that is farther than the first of the list takes its place. */
static void find_farthest(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    uint32_t q = m->C[h->last];
    float far;
    if (q == h->apex) {
        begin_search(h);
        return;
    }
    far = height(h, q);
    if (far > h->most) {
        h->most = far;
        m->C[h->last] = m->C[q];
        put_on_list(h, q, h->t);
    } else {
        h->last = q;
    }
}

/* ---- what it sees ---------------------------------------------------------------------------------- */

/* The next corner whose neighbour is to be looked at: all three of the first face, then those but the one by which a face
 * was entered. */
static void examine_next(nook_hull_state *h) {
    h->phase = EXAMINE;
    if (h->x != nook_prev(h->c)) {
        h->x = nook_next(h->x);
    } else if (h->c != h->tail) {
        h->c = h->mesh->O[h->c];
        h->x = nook_next(h->c);
    } else {
        h->mesh->O[h->tail] = nook_store(h->spare);
        h->spare = h->first;
        h->phase = BUILD;
    }
}

static void examine(nook_hull_state *h) {
    uint32_t t = nook_triangle(h->mesh->O[h->x]);
    if (is_gone(h, t)) {
        examine_next(h);
    } else {
        begin_list(h, t, JUDGE);
    }
}

static void judge(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    uint32_t o = m->O[h->x];
    if (side_of(h, h->apex, h->t, h->p) >= 0) {
        take_away(h);
        m->O[h->tail] = nook_store(o);
        h->tail = o;
    } else {
        set_rim(h, m->V[nook_next(h->x)], o, m->V[nook_prev(h->x)]);
    }
    examine_next(h);
}

/* ---- new faces ------------------------------------------------------------------------------------- */

static uint32_t take_number(nook_hull_state *h) {
    uint32_t t = h->mesh->nt;
    if (h->spares != 0) {
        t = nook_triangle(h->spare);
        h->spare = h->mesh->O[h->spare];
        h->spares--;
    } else {
        h->mesh->nt++;
    }
    nook_clear_bit(h->marks.Mt, t);
    return t;
}

/* The face p a b on edge a b of the rim; it is joined to the one before, the last to the first too. */
static void build(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    uint32_t a = h->a, o = m->C[a], b = m->O[o], t = take_number(h);
    nook_set_triangle(m, t, h->p, a, b);
    nook_join(m, 3u * t, o);
    if (a == h->rim) {
        h->first = t;
    } else {
        nook_join(m, 3u * t + 2u, 3u * h->latest + 1u);
    }
    h->latest = t;
    h->a = b;
    if (b != h->rim) return;
    nook_join(m, 3u * t + 1u, 3u * h->first + 2u);
    h->t = t;
    h->phase = SHARE;
}

/* Hold a waiting point against a new face. Neighbours on a list tend to see the same, so each begins where the one
 * before has ended. */
static void share(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    uint32_t q = h->waiting;
    if (q == h->p) {
        h->phase = SCAN;
    } else if (side_of(h, h->p, h->t, q) > 0) {
        h->waiting = m->C[q];
        put_on_list(h, q, h->t);
        h->latest = h->t;
    } else {
        h->t = nook_triangle(m->O[3u * h->t + 1u]);
        if (h->t == h->latest) h->waiting = m->C[q];
    }
}

/* ---- the mesh -------------------------------------------------------------------------------------- */

/* The last faces take the numbers that are free. */
static void fill(nook_hull_state *h) {
    nook_mesh *m = h->mesh;
    if (h->spares == 0) {
        m->nv = h->at = 0;
        h->phase++;
    } else if (is_gone(h, m->nt - 1u)) {
        m->nt--;
        h->spares--;
    } else if (is_gone(h, h->at)) {
        nook_clear_bit(h->marks.Mt, h->at);
        nook_drop_triangle(m, h->at, NULL);
        h->spares--;
    } else {
        h->at++;
    }
}

/* A vertex of the hull gets the next number, which C of the old one is from then on. */
static void move(const nook_hull_state *h, uint32_t v) {
    nook_mesh *m = h->mesh;
    const nook_edit *edit = h->edit;
    uint32_t to = m->nv;
    if (m->C[v] == NOOK_STORED_NONE) return;
    m->nv++;
    m->C[v] = nook_store(to);
    if (to == v) return;
    m->G[to] = m->G[v];
    if (edit != NULL && edit->renamed != NULL) edit->renamed(edit->user, NOOK_AT_VERTEX, v, to);
}

static nook_status look(nook_hull_state *h, uint32_t v) {
    nook_status status = nook_point_status(h->mesh->G[v]);
    if (status != NOOK_OK) h->where = nook_at(NOOK_AT_VERTEX, v);
    return status;
}

static void visit(nook_hull_state *h, uint32_t i) {
    nook_mesh *m = h->mesh;
    uint32_t c;
    switch (h->phase) {
    case SPREAD: spread(h, i); return;
    case MOVE: move(h, i); return;
    case RENAME:
        for (c = 3u * i; c < 3u * i + 3u; c++) m->V[c] = m->C[m->V[c]];
        return;
    case NAME: nook_new_triangle(i, h->edit); /* fall through */
    case USE:
        for (c = 3u * i; c < 3u * i + 3u; c++) m->C[m->V[c]] = nook_store(c);
        return;
    default: m->C[i] = NOOK_STORED_NONE; nook_clear_bit(h->marks.Mv, i);
    }
}

/* A pass over all vertices, or over all triangles. */
static nook_status pass(nook_hull_state *h) {
    bool of_triangles = h->phase == USE || h->phase == RENAME || h->phase == NAME;
    nook_status status = NOOK_OK;
    if (h->at == (of_triangles ? h->mesh->nt : h->nv)) {
        h->at = 0;
        h->phase++;
        return NOOK_OK;
    }
    if (h->phase == LOOK) {
        status = look(h, h->at);
    } else {
        visit(h, h->at);
    }
    h->at += status == NOOK_OK;
    return status;
}

/* ---- all ------------------------------------------------------------------------------------------- */

nook_status nook_hull_begin(nook_hull_state *h, nook_mesh *mesh, const nook_marks *marks,
                            const nook_edit *edit) {
    if (mesh == NULL || marks == NULL || marks->Mt == NULL || marks->Mv == NULL) return NOOK_NULL_ARGUMENT;
    memset(h, 0, sizeof *h);
    h->mesh = mesh;
    h->edit = edit;
    h->marks = *marks;
    h->nv = mesh->nv;
    h->scan = NOOK_NONE; /* the first to come is 0 */
    if (marks->max_nv < mesh->nv) return NOOK_NO_CAPACITY;
    return 2u * mesh->nv > mesh->max_nt + 4u || 2u * mesh->nv > marks->max_nt + 4u ? NOOK_NO_CAPACITY
                                                                                   : NOOK_OK;
}

static nook_status advance(nook_hull_state *h) {
    switch (h->phase) {
    case CHOOSE: return choose(h);
    case BUILD: build(h); break;
    case SHARE: share(h); break;
    case SCAN: scan(h); break;
    case FIND:
        if (follow_list(h)) begin_farthest(h);
        break;
    case FARTHEST: find_farthest(h); break;
    case EXAMINE: examine(h); break;
    case JUDGE:
        if (follow_list(h)) judge(h);
        break;
    case FILL: fill(h); break;
    default: return pass(h);
    }
    return NOOK_OK;
}

nook_status nook_hull_step(nook_hull_state *h, uint32_t *units) {
    while (h->phase != DONE) {
        nook_status status;
        if (*units == 0) return NOOK_MORE;
        --*units;
        status = advance(h);
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}

nook_status nook_hull(nook_mesh *mesh, const nook_marks *marks, const nook_edit *edit, nook_where *where) {
    nook_hull_state state;
    uint32_t units;
    nook_status status;
    if (where != NULL) *where = nook_at(NOOK_NOWHERE, 0);
    status = nook_hull_begin(&state, mesh, marks, edit);
    if (status != NOOK_OK) return status;
    do {
        units = 64; /* any number gives the same */
        status = nook_hull_step(&state, &units);
    } while (status == NOOK_MORE);
    if (where != NULL) *where = state.where;
    return status;
}
