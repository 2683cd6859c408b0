/* nook_fill.c -- the three fillings of nook_fill.h, of which two differ only in which ear is next.
 *
 * The loop that is left is a list of corners that face its edges, first those of the mesh, then also of planned
 * triangles. Cutting an ear puts one corner in the place of two. The plan for a loop of L edges needs 3 (L - 2) entries
 * of V and O. The list stands at the end of those in O: with k triangles planned it has L - k entries and begins at
 * 2 L - 6 + k, and 3 k <= 2 L - 6 + k as long as more than one triangle is to come. */
#include "edit/nook_fill.h"

#include "edit/nook_inner.h"
#include "walk/nook_border.h"

enum { MEASURE, COLLECT, LOOK, INSIDE, ACROSS, CUT, SHIFT, RADIATE, TALLY, HOLD, JOIN, DONE };

/* ---- the loop -------------------------------------------------------------------------------------- */

static uint32_t left_over(const nook_fill *f) { return f->length - f->made; }

static nook_index *entry(const nook_fill *f, uint32_t i) {
    uint32_t size = left_over(f);
    return &f->mesh->O[3u * f->mesh->nt + 2u * f->length - 6u + f->made + (i < size ? i : i - size)];
}

/* The vertex where edge i of the loop begins, as its triangle runs it. */
static uint32_t loop_vertex(const nook_fill *f, uint32_t i) { return f->mesh->V[nook_next(*entry(f, i))]; }

static const nook_point *loop_point(const nook_fill *f, uint32_t i) { return &f->mesh->G[loop_vertex(f, i)]; }

/* Follow the loop; the sums are of points less the first, so that they mean something far from the origin. */
static nook_status measure(nook_fill *f) {
    nook_view view = nook_view_of(f->mesh);
    nook_point first = nook_point_at(&view, nook_next(f->c)), from, to;
    uint32_t end = view.V[nook_prev(f->x)];
    /* The vertex where the edge begins is where the last one ends, or was looked at with c. */
    if (end >= view.nv || view.C[end] >= 3u * view.nt || f->length == 3u * view.nt) return NOOK_BAD_OPPOSITE;
    from = nook_sub(nook_point_at(&view, nook_next(f->x)), first);
    to = nook_sub(nook_point_at(&view, nook_prev(f->x)), first);
    f->centroid = nook_make(f->centroid.x + from.x, f->centroid.y + from.y, f->centroid.z + from.z);
    from = nook_cross(to, from);
    f->normal = nook_make(f->normal.x + from.x, f->normal.y + from.y, f->normal.z + from.z);
    f->length++;
    f->x = nook_border_next(&view, f->x, true);
    return f->x == NOOK_NONE ? NOOK_BAD_OPPOSITE : NOOK_OK;
}

static float size_of(float x) { return x < 0 ? -x : x; }

/* Which way a loop of three faces is known to the last bit. */
static void face_exactly(nook_fill *f) {
    nook_view view = nook_view_of(f->mesh);
    nook_point b0 = nook_point_at(&view, nook_next(f->c)), b1 = nook_point_at(&view, nook_prev(f->c));
    nook_point b2 = nook_point_at(&view, nook_prev(nook_border_next(&view, f->c, true)));
    int side = nook_orient2d(&b2, &b1, &b0, f->axis);
    if (side == 0) side = nook_facing(&b2, &b1, &b0, &f->axis);
    if (side != 0) f->side = side;
}

/* The loop is known: whether there is room, where its middle is, and which way it faces. */
static nook_status prepare(nook_fill *f) {
    const nook_mesh *m = f->mesh;
    bool centroid = f->way == NOOK_FILL_CENTROID;
    nook_view view = nook_view_of(m);
    nook_point first = nook_point_at(&view, nook_next(f->c)), n = f->normal;
    float length = nook_length(n), component;
    if (f->length < 3u) return NOOK_DUPLICATE_EDGE;
    if (m->max_nt - m->nt < (centroid ? f->length : f->length - 2u)) return NOOK_NO_CAPACITY;
    if (centroid && m->nv == m->max_nv) return NOOK_NO_CAPACITY;
    if (f->length == 3u && nook_border_next(&view, f->c, true) == nook_next(f->c) && !centroid) {
        return NOOK_DUPLICATE_TRIANGLE;
    }
    f->centroid = nook_scaled(f->centroid, 1.0f / (float)f->length);
    f->centroid = nook_make(first.x + f->centroid.x, first.y + f->centroid.y, first.z + f->centroid.z);
    f->axis = size_of(n.x) >= size_of(n.y) ? 0 : 1u;
    if (size_of(n.z) > size_of(f->axis == 0 ? n.x : n.y)) f->axis = 2u;
    component = f->axis == 0 ? n.x : f->axis == 1u ? n.y : n.z;
    f->side = component < 0 ? -1 : 1;
    if (f->length == 3u) face_exactly(f);
    if (length > 0) f->normal = nook_scaled(n, 1.0f / length);
    f->phase = centroid ? RADIATE : COLLECT;
    return NOOK_OK;
}

/* Whether a b c, seen along the loop's axis, runs as a triangle in the hole does. */
static bool faces(const nook_fill *f, const nook_point *a, const nook_point *b, const nook_point *c) {
    return nook_orient2d(a, b, c, f->axis) == f->side;
}

/* O of a planned corner; also of the other, unless that is one of the mesh, whose turn comes in the end. */
static void link_planned(nook_fill *f, uint32_t c, uint32_t o) {
    f->mesh->O[c] = nook_store(o);
    if (o >= 3u * f->mesh->nt) f->mesh->O[o] = nook_store(c);
}

static uint32_t planned(const nook_fill *f) { return 3u * (f->mesh->nt + f->made); }

static void collect(nook_fill *f) {
    nook_view view = nook_view_of(f->mesh);
    *entry(f, f->at++) = nook_store(f->x);
    f->x = nook_border_next(&view, f->x, true);
    if (f->at == f->length) f->phase = LOOK;
}

/* ---- ears ------------------------------------------------------------------------------------------ */

/* Ear i is at the end of edge i: it runs from b2 to b1 to b0, where edge i is b0 b1 and the next b1 b2. */
static float ear_quality(const nook_fill *f) {
    const nook_point *b0 = loop_point(f, f->ear), *b1 = loop_point(f, f->ear + 1u),
                     *b2 = loop_point(f, f->ear + 2u);
    nook_point u = nook_sub(*b1, *b2), v = nook_sub(*b0, *b1), w = nook_sub(*b0, *b2);
    float squares = nook_dot(u, u) + nook_dot(v, v) + nook_dot(w, w);
    return squares > 0 ? nook_dot(nook_cross(u, w), f->normal) / squares : 0;
}

static void next_ear(nook_fill *f) {
    f->ear++;
    f->phase = f->ear < left_over(f) && f->way == NOOK_FILL_EARS ? LOOK : CUT;
}

/* What an ear is worth at most, and if that can be the best so far, a closer look. */
static void look(nook_fill *f) {
    const nook_point *b0 = loop_point(f, f->ear), *b1 = loop_point(f, f->ear + 1u),
                     *b2 = loop_point(f, f->ear + 2u);
    bool good = faces(f, b2, b1, b0);
    f->quality = ear_quality(f) + (good ? 2.0f : 0);
    f->at = f->ear + 3u;
    if (!good && f->edit != NULL && f->edit->no_turn) {
        f->refusal = NOOK_TURNED_TRIANGLE;
        next_ear(f);
    } else if (f->best != NOOK_NONE && f->quality <= f->most) {
        next_ear(f);
    } else {
        f->phase = good && f->way == NOOK_FILL_EARS ? INSIDE : ACROSS;
    }
}

/* One vertex of the rest of the loop: if it lies in the ear, or on it, the ear is as good as one that is not convex. */
static void look_into(nook_fill *f) {
    const nook_point *b0 = loop_point(f, f->ear), *b1 = loop_point(f, f->ear + 1u),
                     *b2 = loop_point(f, f->ear + 2u), *p;
    if (f->at == f->ear + left_over(f)) {
        f->phase = ACROSS;
        return;
    }
    p = loop_point(f, f->at++);
    if (nook_orient2d(b2, b1, p, f->axis) == -f->side || nook_orient2d(b1, b0, p, f->axis) == -f->side ||
        nook_orient2d(b0, b2, p, f->axis) == -f->side) {
        return;
    }
    f->quality -= 2.0f;
    f->phase = ACROSS;
    if (f->best != NOOK_NONE && f->quality <= f->most) next_ear(f);
}

/* The last look: the new edge must not be there yet. The last ear has none. */
static void look_across(nook_fill *f) {
    nook_view view = nook_view_of(f->mesh);
    uint32_t c = view.C[loop_vertex(f, f->ear)];
    if (left_over(f) > 3u && nook_is_joined(&view, c, loop_vertex(f, f->ear + 2u))) {
        f->refusal = NOOK_DUPLICATE_EDGE;
    } else {
        f->most = f->quality;
        f->best = f->ear;
    }
    next_ear(f);
}

/* The best ear becomes a triangle b2 b1 b0, whose middle corner faces the edge that is new in the loop. That corner
 * takes the place of the second of two; or of the first, where the second is at the beginning of the list and goes with
 * the next triangle. */
static nook_status cut(nook_fill *f) {
    uint32_t e = f->best, last = left_over(f) - 1u;
    if (e == NOOK_NONE) return f->refusal;
    nook_set_triangle(f->mesh, f->mesh->nt + f->made, loop_vertex(f, e + 2u), loop_vertex(f, e + 1u),
                      loop_vertex(f, e));
    f->x = *entry(f, e);
    f->at = *entry(f, e + 1u);
    f->ear = *entry(f, e + 2u);
    if (last > 2u) *entry(f, e == last ? e : e + 1u) = nook_store(planned(f) + 1u);
    f->other = e == last ? 0 : e;
    f->phase = SHIFT;
    return NOOK_OK;
}

/* The entries before the ear move up, one a step; then the triangle is planned. */
static void shift(nook_fill *f) {
    uint32_t q = planned(f);
    if (f->other > 0) {
        *entry(f, f->other) = *entry(f, f->other - 1u);
        f->other--;
        return;
    }
    link_planned(f, q, f->x);
    link_planned(f, q + 2u, f->at);
    if (left_over(f) == 3u) link_planned(f, q + 1u, f->ear);
    f->made++;
    f->ear = 0;
    f->best = NOOK_NONE;
    f->phase = LOOK;
    if (left_over(f) == 2u) f->at = f->other = 0, f->phase = TALLY;
}

/* ---- centroid -------------------------------------------------------------------------------------- */

/* A triangle of the centroid, b1 and b0, where the loop's edge is b0 b1. The one before it has b0 as its second. */
static nook_status radiate(nook_fill *f) {
    nook_mesh *m = f->mesh;
    nook_view view = nook_view_of(m);
    uint32_t q = planned(f), b0 = m->V[nook_next(f->x)], b1 = m->V[nook_prev(f->x)];
    if (f->edit != NULL && f->edit->no_turn && !faces(f, &f->centroid, &m->G[b1], &m->G[b0]))
        return NOOK_TURNED_TRIANGLE;
    if (f->made == 0) nook_new_triangle(m->nt, f->edit);
    nook_add_attributes(f->edit, 3u * m->nt, nook_next(f->x), 1.0f / (float)f->length);
    nook_set_triangle(m, m->nt + f->made, m->nv, b1, b0);
    link_planned(f, q, f->x);
    if (f->made > 0) link_planned(f, q + 1u, q - 1u);
    f->x = nook_border_next(&view, f->x, true);
    if (++f->made == f->length) {
        link_planned(f, q + 2u, 3u * m->nt + 1u);
        f->at = f->other = 0;
        f->phase = TALLY;
    }
    return NOOK_OK;
}

/* ---- the end --------------------------------------------------------------------------------------- */

/* How many of the planned corners are at the vertex of one of them; and whether it has room for them. */
static nook_status tally(nook_fill *f) {
    const nook_mesh *m = f->mesh;
    nook_view view = nook_view_of(m);
    uint32_t v;
    if (f->edit == NULL || f->edit->max_valence == 0 || f->at == 3u * f->made) {
        f->at = f->other = 0;
        f->phase = nook_is_guarded(f->edit) ? HOLD : JOIN;
        return NOOK_OK;
    }
    v = m->V[3u * m->nt + f->at];
    if (f->other == 0) f->ear = 0;
    f->ear += m->V[3u * m->nt + f->other] == v;
    if (++f->other < 3u * f->made) return NOOK_OK;
    f->other = 0;
    f->at++;
    if (v == m->nv) return f->ear > f->edit->max_valence ? NOOK_TOO_MANY_TRIANGLES : NOOK_OK;
    return nook_has_room(&view, m->C[v], f->ear, f->edit) ? NOOK_OK : NOOK_TOO_MANY_TRIANGLES;
}

/* The corners of a planned triangle. */
static void plan(const nook_fill *f, uint32_t i, const nook_point *p[3]) {
    uint32_t k;
    for (k = 0; k < 3u; k++) {
        uint32_t v = f->mesh->V[3u * (f->mesh->nt + i) + k];
        p[k] = v == f->mesh->nv ? &f->centroid : &f->mesh->G[v];
    }
}

/* A planned triangle is held against the tree, which has boxes for it from now on, then against each of those after it. */
NOOK_APART static nook_status hold(nook_fill *f) {
    nook_change change;
    nook_status status = NOOK_OK;
    const nook_point *p[3], *q[3];
    plan(f, f->at, p);
    plan(f, f->other, q);
    if (f->other == f->at) {
        nook_change_begin(&change, f->mesh, NOOK_NONE, NOOK_NONE);
        nook_change_make(&change, p[0], p[1], p[2]);
        status = f->edit->guard->look(f->edit->guard, &change);
        f->edit->guard->widen(f->edit->guard, f->mesh->nt + f->at, p);
    } else if (f->edit->guard->intersect(p, q)) {
        status = NOOK_SELF_INTERSECTION;
    }
    if (++f->other == f->made) f->other = ++f->at;
    if (f->at == f->made) f->at = 0, f->phase = JOIN;
    return status;
}

/* A planned corner is joined to the mesh; after the last all are the mesh's. */
static void join_planned(nook_fill *f) {
    nook_mesh *m = f->mesh;
    uint32_t c = 3u * m->nt + f->at, v = m->V[c];
    if (m->O[c] < 3u * m->nt) m->O[m->O[c]] = nook_store(c);
    if (f->at % 3u == 0) nook_copy_color(f->edit, nook_triangle(c), nook_triangle(f->c));
    nook_copy_attributes(f->edit, c, v == m->nv ? 3u * m->nt : m->C[v]);
    if (++f->at < 3u * f->made) return;
    if (f->way == NOOK_FILL_CENTROID) nook_add_vertex(m, f->centroid, 3u * m->nt, f->edit);
    m->nt += f->made;
    nook_follow(m, f->edit);
    f->phase = DONE;
}

nook_status nook_fill_begin(nook_fill *f, nook_mesh *mesh, uint32_t c, nook_fill_way way,
                            const nook_edit *edit) {
    nook_status status = nook_triangle_status(mesh, c);
    memset(f, 0, sizeof *f);
    f->mesh = mesh;
    f->edit = edit;
    f->way = way;
    f->c = f->x = c;
    f->best = NOOK_NONE;
    if (status == NOOK_OK && mesh->O[c] != c) status = NOOK_INTERIOR_EDGE;
    return status;
}

static nook_status advance(nook_fill *f) {
    nook_status status = NOOK_OK;
    switch (f->phase) {
    case MEASURE:
        status = measure(f);
        if (status == NOOK_OK && f->x == f->c) status = prepare(f);
        break;
    case COLLECT: collect(f); break;
    case LOOK: look(f); break;
    case INSIDE: look_into(f); break;
    case ACROSS: look_across(f); break;
    case CUT: status = cut(f); break;
    case SHIFT: shift(f); break;
    case RADIATE: status = radiate(f); break;
    case TALLY: status = tally(f); break;
    case HOLD: status = hold(f); break;
    default: join_planned(f); break;
    }
    return status;
}

nook_status nook_fill_step(nook_fill *f, uint32_t *units) {
    while (f->phase != DONE) {
        nook_status status;
        if (*units == 0) return NOOK_MORE;
        --*units;
        status = advance(f);
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}

nook_status nook_fill_hole(nook_mesh *mesh, uint32_t c, nook_fill_way way, const nook_edit *edit) {
    nook_fill fill;
    uint32_t units;
    nook_status status = nook_fill_begin(&fill, mesh, c, way, edit);
    if (status != NOOK_OK) return status;
    do {
        units = 64; /* any number gives the same */
        status = nook_fill_step(&fill, &units);
    } while (status == NOOK_MORE);
    return status;
}
