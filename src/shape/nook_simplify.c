/* nook_simplify.c -- the choice of edges, and of the points to which they go.
 *
 * Points are taken relative to a vertex of the edge and scaled so that the mesh is about 1024 wide: sixth powers of lengths,
 * which costs are, then stay in range, and a mesh 2^k times as large becomes the same, 2^k times as large. */
#include "shape/nook_simplify.h"

#include "edit/nook_inner.h"
#include "edit/nook_local.h"
#include "shape/nook_deviation.h"

enum { LOOK, DRAW, SWEEP, DONE };
enum {
    DRAWN = 3, /* triangles drawn for an edge to be looked at: the shortest of all theirs */
    FRESH = 2, /* edges looked at for one that goes */
    HELD = 24  /* and where it must be held outside */
};
#define ROUND                                                                                                \
    0x1p-15f /* how much of a sphere every quadric has, so that it has a least place also where all is flat */
#define SHORT                                                                                                \
    0x1p-18f /* how much more an edge costs for its length, so that among those that cost nothing short ones go */

/* ---- what is around an edge ------------------------------------------------------------------------- */

static inline nook_point times(const nook_quadric *a, nook_point v) {
    return nook_make(a->xx * v.x + a->xy * v.y + a->xz * v.z, a->xy * v.x + a->yy * v.y + a->yz * v.z,
                     a->xz * v.x + a->yz * v.y + a->zz * v.z);
}

static inline void add_normal(nook_quadric *a, nook_point n) {
    a->xx += n.x * n.x;
    a->yy += n.y * n.y;
    a->zz += n.z * n.z;
    a->xy += n.x * n.y;
    a->xz += n.x * n.z;
    a->yz += n.y * n.z;
}

/* The square of the area between a place and a border edge, times that of its length. */
static void add_border(nook_quadric *a, nook_point e) {
    float square = nook_dot(e, e);
    a->xx += square * (square - e.x * e.x);
    a->yy += square * (square - e.y * e.y);
    a->zz += square * (square - e.z * e.z);
    a->xy -= square * e.x * e.y;
    a->xz -= square * e.x * e.z;
    a->yz -= square * e.y * e.z;
}

static bool push(nook_edge_ring *r, const nook_mesh *m, uint32_t c) {
    r->c[r->n++] = nook_store(c);
    return m->V[c] < m->nv;
}

/* On from the last corner across e, until e faces stop or a border. */
NOOK_APART static nook_status walk(nook_edge_ring *r, const nook_simplify_state *s, uint32_t chain,
                                   uint32_t e, uint32_t stop) {
    const nook_mesh *m = s->mesh;
    nook_point p = r->p[chain / 2u], u = nook_between(p, m->G[m->V[r->c[r->n - 1u]]], s->scale), v;
    nook_quadric a = r->a[chain / 2u];
    uint32_t n = r->n, corners = 3u * m->nt, o, w;
    if ((chain & 1u) == 0) add_normal(&a, nook_cross(u, nook_between(p, m->G[m->V[r->c[n - 2u]]], s->scale)));
    while ((o = m->O[e]) != stop && o != e) {
        if (o >= corners || (w = m->V[o]) >= m->nv) return NOOK_BAD_OPPOSITE;
        if (n >= NOOK_RING_MOST) return NOOK_TOO_MANY_TRIANGLES;
        r->c[n++] = nook_store(o);
        v = nook_between(p, m->G[w], s->scale);
        add_normal(&a, nook_cross(u, v));
        u = v;
        e = (chain & 1u) != 0 ? nook_prev(o) : nook_next(o);
    }
    r->met = o != stop;
    if (r->met) add_border(&a, u);
    r->a[chain / 2u] = a;
    r->n = n;
    return NOOK_OK;
}

NOOK_APART static nook_status gather(nook_edge_ring *r, const nook_simplify_state *s, uint32_t c) {
    const nook_mesh *m = s->mesh;
    uint32_t end, o = nook_across(m, c);
    r->n = 0;
    r->open = false;
    memset(r->a, 0, sizeof r->a);
    for (end = 0; end < 2u; end++) {
        r->v[end] = m->V[end == 0 ? nook_prev(c) : nook_next(c)];
        if (r->v[end] >= m->nv) return NOOK_BAD_OPPOSITE;
        r->p[end] = m->G[r->v[end]];
    }
    if (o == NOOK_NONE) add_border(&r->a[0], nook_between(r->p[0], r->p[1], s->scale));
    for (end = 0; end < 2u; end++) {
        uint32_t x = end == 0 ? c : o, y = end == 0 ? o : c;
        nook_status status = NOOK_OK;
        r->met = true;
        r->start[2u * end] = r->n;
        if (x != NOOK_NONE) {
            if (!push(r, m, nook_next(x)) || !push(r, m, x)) return NOOK_BAD_OPPOSITE;
            status = walk(r, s, 2u * end, nook_next(x), y == NOOK_NONE ? y : nook_prev(y));
        }
        r->start[2u * end + 1u] = r->n;
        r->open = r->open || r->met;
        if (status == NOOK_OK && r->met && y != NOOK_NONE) {
            if (!push(r, m, y)) return NOOK_BAD_OPPOSITE;
            status = walk(r, s, 2u * end + 1u, nook_prev(y), NOOK_NONE);
        }
        if (status != NOOK_OK) return status;
    }
    r->start[4] = r->n;
    return NOOK_OK;
}

/* ---- where the vertex goes --------------------------------------------------------------------------- */

/* Half the edge, from its middle to B, and y A y - 2 g y of places y from its middle; A has trace 1, and so is scaled. */
typedef struct costs {
    nook_quadric a, inverse; /* of A + ROUND */
    nook_point half, g;
    float trace;
} costs;

static void invert(nook_quadric *to, const nook_quadric *a) {
    float xx = a->xx + ROUND, yy = a->yy + ROUND, zz = a->zz + ROUND, by;
    to->xx = yy * zz - a->yz * a->yz, to->xy = a->xz * a->yz - a->xy * zz,
    to->xz = a->xy * a->yz - a->xz * yy;
    to->yy = xx * zz - a->xz * a->xz, to->yz = a->xy * a->xz - xx * a->yz, to->zz = xx * yy - a->xy * a->xy;
    by = 1.0f / (xx * to->xx + a->xy * to->xy + a->xz * to->xz);
    to->xx *= by, to->yy *= by, to->zz *= by, to->xy *= by, to->xz *= by, to->yz *= by;
}

/* About the middle, the sum of both quadrics has half the difference of both at work on the edge as its slope. */
NOOK_APART static void add_up(costs *f, const nook_edge_ring *r, float scale) {
    const nook_quadric *c = &r->a[0], *b = &r->a[1];
    nook_quadric less = {b->xx - c->xx, b->yy - c->yy, b->zz - c->zz,
                         b->xy - c->xy, b->xz - c->xz, b->yz - c->yz};
    float by;
    f->half = nook_between(r->p[0], r->p[1], 0.5f * scale);
    f->trace = b->xx + c->xx + (b->yy + c->yy) + (b->zz + c->zz) + 0x1p-100f;
    by = 1.0f / f->trace;
    f->g = nook_scaled(times(&less, f->half), by);
    f->a.xx = (b->xx + c->xx) * by, f->a.yy = (b->yy + c->yy) * by, f->a.zz = (b->zz + c->zz) * by;
    f->a.xy = (b->xy + c->xy) * by, f->a.xz = (b->xz + c->xz) * by, f->a.yz = (b->yz + c->yz) * by;
    invert(&f->inverse, &f->a);
}

static float cost_at(const costs *f, nook_point y) {
    float sum =
        nook_dot(y, times(&f->a, y)) - 2 * nook_dot(f->g, y) + nook_dot(f->half, times(&f->a, f->half));
    return f->trace * (nook_abs(sum) + SHORT * nook_dot(f->half, f->half));
}

/* Once more on what is left, so that ROUND moves nothing that is not flat. */
static nook_point least_place(const costs *f) {
    nook_point y = times(&f->inverse, f->g), z = times(&f->inverse, nook_sub(f->g, times(&f->a, y)));
    return nook_make(y.x + z.x, y.y + z.y, y.z + z.z);
}

static nook_point from_middle(const nook_simplify_state *s, const nook_edge_ring *r, nook_point y) {
    const nook_point *c = &r->p[0], *b = &r->p[1];
    return nook_make(0.5f * (c->x + b->x) + y.x * s->unit, 0.5f * (c->y + b->y) + y.y * s->unit,
                     0.5f * (c->z + b->z) + y.z * s->unit);
}

/* ---- outside ------------------------------------------------------------------------------------------ */

static bool is_outside(const nook_simplify_state *s, const nook_edge_ring *r, const nook_point *at) {
    const nook_point *t[3];
    uint32_t i;
    for (i = 0; i < r->n; i++) {
        if (nook_ring_face(s->mesh, r, i, t) && nook_orient3d(t[0], t[1], t[2], at) < 0) return false;
    }
    return true;
}

/* The place of least cost, and by ROUND near the middle, that is a little outside: Hildreth's method, which pushes along
 * one normal after the other, in the measure of the quadric, and takes back what was too much. */
NOOK_APART static nook_point hold_outside(const nook_simplify_state *s, const nook_edge_ring *r,
                                          const costs *f, nook_point y) {
    float pushed[HELD], least = 0x1p-12f * nook_length(f->half);
    nook_point middle = from_middle(s, r, nook_make(0, 0, 0));
    const nook_point *t[3];
    uint32_t i, j;
    bool still = false;
    memset(pushed, 0, sizeof pushed);
    for (j = 0; j < 32u && !still; j++) {
        for (still = true, i = 0; i < r->n; i++) {
            nook_point n, w;
            float by, high, steep;
            if (!nook_ring_face(s->mesh, r, i, t)) continue;
            n = nook_cross(nook_between(*t[0], *t[1], s->scale), nook_between(*t[0], *t[2], s->scale));
            w = times(&f->inverse, n);
            high = least * nook_length(n);
            steep = nook_dot(n, w) + 0x1p-100f;
            by = (nook_dot(n, nook_between(middle, *t[0], s->scale)) - nook_dot(n, y) + high) / steep;
            if (by < -pushed[i]) by = -pushed[i];
            if (nook_abs(by) * steep > 0.5f * high) still = false;
            pushed[i] += by;
            y = nook_make(y.x + by * w.x, y.y + by * w.y, y.z + by * w.z);
        }
    }
    return y;
}

/* The best of both ends and that place. */
NOOK_APART static bool place_outside(const nook_simplify_state *s, const nook_edge_ring *r, const costs *f,
                                     nook_point y, nook_point *at, float *cost) {
    uint32_t i;
    *cost = 0x1p127f;
    if (r->open || r->n > HELD) return false;
    for (i = 0; i < 3u; i++) {
        nook_point place = i == 2u ? hold_outside(s, r, f, y) : nook_scaled(f->half, i == 0 ? -1.0f : 1.0f);
        float less = cost_at(f, place);
        place = i == 2u ? from_middle(s, r, place) : r->p[i];
        if (!(less < *cost * (i == 2u ? 0.75f : 1.0f)) || !is_outside(s, r, &place)) continue;
        *cost = less;
        *at = place;
    }
    return *cost < 0x1p127f;
}

/* ---- what must not happen ----------------------------------------------------------------------------- */

/* Whether a triangle of an end would turn. Where lengths and the cosine, 2^-18 at least, leave no doubt floats do. */
NOOK_APART static bool turns(const nook_simplify_state *s, const nook_edge_ring *r, uint32_t chain,
                             const nook_point *at) {
    static const nook_edit asking = {.no_turn = true};
    const nook_mesh *m = s->mesh;
    const nook_point *p = &r->p[chain / 2u];
    uint32_t i = r->start[chain] + ((chain & 1u) ^ 1u), end = r->start[chain + 1u];
    nook_point u, v, x, y;
    float uu, vv, xx, yy;
    if (i >= end) return false;
    u = nook_between(*p, *nook_ring_point(m, r, i), s->scale);
    x = nook_between(*at, *nook_ring_point(m, r, i), s->scale);
    uu = nook_dot(u, u), xx = nook_dot(x, x);
    for (i++; i < end; i++) {
        const nook_point *w = nook_ring_point(m, r, i - 1u), *z = nook_ring_point(m, r, i);
        const nook_point *const old[4] = {p, w, z, z};
        float cosine;
        bool sure;
        v = nook_between(*p, *z, s->scale);
        y = nook_between(*at, *z, s->scale);
        vv = nook_dot(v, v), yy = nook_dot(y, y);
        cosine = nook_dot(nook_cross(u, v), nook_cross(x, y));
        sure = cosine > 0x1p-40f && cosine * cosine > 0x1p-36f * (uu * vv) * (xx * yy);
        if (!sure && nook_is_turned(&asking, at, w, z, old)) return true;
        u = v, x = y, uu = vv, xx = yy;
    }
    return false;
}

static float more(float a, float b) { return a > b ? a : b; }

/* ---- edges ---------------------------------------------------------------------------------------------- */

typedef struct choice {
    nook_point at;
    float cost, deviation;
} choice;

/* Where the vertex goes, for what. */
NOOK_APART static nook_status place(const nook_simplify_state *s, const nook_edge_ring *r, choice *to) {
    costs f;
    nook_point y;
    add_up(&f, r, s->scale);
    y = least_place(&f);
    if (s->goal->outside) return place_outside(s, r, &f, y, &to->at, &to->cost) ? NOOK_OK : NOOK_NO_PLACE;
    to->at = from_middle(s, r, y);
    to->cost = cost_at(&f, y);
    return NOOK_OK;
}

/* The same of the edge of c; with all conditions, or only those that come by the way. */
NOOK_APART static nook_status judge(const nook_simplify_state *s, uint32_t c, bool wholly, choice *to) {
    nook_edge_ring r;
    uint32_t i;
    nook_status status = gather(&r, s, c);
    memset(to, 0, sizeof *to);
    if (status == NOOK_OK) status = place(s, &r, to);
    if (status != NOOK_OK || !wholly) return status;
    for (i = 0; i < 4u; i++) {
        if (turns(s, &r, i, &to->at)) return NOOK_TURNED_TRIANGLE;
    }
    if (nook_point_status(to->at) != NOOK_OK) return NOOK_NO_PLACE;
    if (s->goal->deviation == NULL) return NOOK_OK;
    to->deviation = nook_deviation_at(s->mesh, &r, s->goal->deviation, s->scale, to->at) * s->unit;
    return to->deviation <= s->goal->error ? NOOK_OK : NOOK_NO_PLACE;
}

/* All collapses are made here. */
static nook_status collapse(nook_simplify_state *s, uint32_t c, const choice *to) {
    nook_mesh *m = s->mesh;
    nook_edit edit = {.no_turn = false}; /* it has been asked */
    uint32_t kept = m->V[nook_prev(c)], gone = m->V[nook_next(c)], last = m->nv - 1u;
    float *deviation = s->goal->deviation;
    nook_status status;
    if (s->edit != NULL) edit = *s->edit;
    edit.no_turn = false;
    if (s->goal->levels != NULL) {
        status = nook_levels_collapse(s->goal->levels, m, c, to->at, &edit);
    } else {
        status = nook_collapse(m, c, to->at, &edit);
    }
    if (status != NOOK_OK || deviation == NULL) return status;
    deviation[kept] = to->deviation;
    deviation[gone] = deviation[last];
    return NOOK_OK;
}

/* With all conditions; what stands in the way is kept. */
static bool try_edge(nook_simplify_state *s, uint32_t c, const choice *to, nook_status status) {
    if (status == NOOK_OK) status = collapse(s, c, to);
    if (status == NOOK_OK) {
        s->idle = s->fresh = 0;
        return true;
    }
    s->refused = status;
    s->where = nook_at(NOOK_AT_CORNER, c);
    return false;
}

/* ---- the choice ------------------------------------------------------------------------------------------ */

static uint32_t draw_corner(nook_simplify_state *s) {
    s->dice ^= s->dice << 13;
    s->dice ^= s->dice >> 17;
    s->dice ^= s->dice << 5;
    return (uint32_t)((uint64_t)s->dice * (3u * s->mesh->nt) >> 32);
}

/* The shortest edge of a triangle, if it is shorter than what was found before; of what is no triangle one that is found out
 * when it is looked at. */
static void shortest_of(const nook_mesh *m, uint32_t t, uint32_t *best, float *least) {
    const nook_index *V = m->V + 3u * t;
    nook_point p, q;
    uint32_t i, last = V[2];
    if (V[0] >= m->nv || V[1] >= m->nv || last >= m->nv) return;
    for (p = m->G[last], i = 0; i < 3u; i++, p = q) {
        nook_point d = nook_sub(q = m->G[V[i]], p);
        float square = nook_dot(d, d);
        if (square < *least) *least = square, *best = 3u * t + (i == 2u ? 0 : i + 1u);
    }
}

/* The shortest edge of some triangles; any, where none has gone for long. */
static uint32_t draw_edge(nook_simplify_state *s) {
    uint32_t best = draw_corner(s), c = best, n;
    float least = 0x1p127f;
    for (n = 0; n < (uint32_t)DRAWN && s->idle <= 64u; n++) {
        shortest_of(s->mesh, nook_triangle(c), &best, &least);
        c = draw_corner(s);
    }
    return best;
}

static void put(nook_simplify_state *s, uint32_t c, float cost) {
    uint32_t i;
    if (s->pooled == NOOK_SIMPLIFY_POOL) {
        if (!(cost < s->pool[0].cost)) return;
        for (i = 0; i + 1u < s->pooled && s->pool[i + 1u].cost > cost; i++) s->pool[i] = s->pool[i + 1u];
    } else {
        for (i = s->pooled++; i > 0 && s->pool[i - 1u].cost < cost; i--) s->pool[i] = s->pool[i - 1u];
    }
    s->pool[i].cost = cost;
    s->pool[i].c = c;
}

static void draw(nook_simplify_state *s) {
    uint32_t c = draw_edge(s);
    choice to;
    nook_status status = judge(s, c, false, &to);
    s->fresh++;
    s->idle++;
    if (status == NOOK_OK) {
        put(s, c, to.cost);
    } else {
        (void)try_edge(s, c, &to, status);
    }
}

/* The best of the pool, unless it has become worse since than the next. */
static void take(nook_simplify_state *s) {
    uint32_t c = s->pool[--s->pooled].c;
    nook_status status;
    choice to;
    if (c >= 3u * s->mesh->nt) return;
    status = judge(s, c, true, &to);
    if (status == NOOK_OK && s->pooled != 0 && to.cost > s->pool[s->pooled - 1u].cost) {
        put(s, c, to.cost);
    } else {
        (void)try_edge(s, c, &to, status);
    }
}

/* One edge after the other, until none has gone in a whole round. */
static void sweep(nook_simplify_state *s) {
    uint32_t c = s->at < 3u * s->mesh->nt ? s->at : 0;
    choice to;
    s->at = c + 1u;
    if (s->mesh->O[c] >= c) {
        nook_status status = judge(s, c, true, &to);
        if (try_edge(s, c, &to, status)) return;
    }
    if (++s->idle > 3u * s->mesh->nt) s->phase = DONE;
}

/* A vertex, once; then a draw, or what was drawn. */
static nook_status advance(nook_simplify_state *s) {
    const nook_mesh *m = s->mesh;
    if (s->phase == LOOK) {
        nook_status status = s->at < m->nv ? nook_point_status(m->G[s->at]) : NOOK_OK;
        nook_point d;
        uint32_t exponent;
        if (status != NOOK_OK) {
            s->where = nook_at(NOOK_AT_VERTEX, s->at);
            return status;
        }
        if (s->at < m->nv) {
            d = nook_sub(m->G[s->at++], m->G[0]);
            s->extent = more(s->extent, more(nook_abs(d.x), more(nook_abs(d.y), nook_abs(d.z))));
            return NOOK_OK;
        }
        exponent = nook_exponent(s->extent);
        if (exponent < 40u) exponent = 40;
        s->scale = nook_power_of_two(264u - exponent);
        s->unit = nook_power_of_two(exponent - 10u);
        s->phase = DRAW;
    } else if (m->nt <= s->goal->triangles) {
        s->refused = NOOK_OK;
        s->where = nook_at(NOOK_NOWHERE, 0);
        s->phase = DONE;
    } else if (s->phase == SWEEP) {
        sweep(s);
    } else if (s->fresh < (uint32_t)FRESH || s->pooled == 0) {
        draw(s);
        if (s->idle > 8u * m->nt + 64u) s->phase = SWEEP, s->idle = s->at = 0;
    } else {
        take(s);
    }
    return NOOK_OK;
}

nook_status nook_simplify_begin(nook_simplify_state *s, nook_mesh *mesh, const nook_simplify_goal *goal,
                                const nook_edit *edit) {
    if (s == NULL || mesh == NULL || goal == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->mesh = mesh;
    s->goal = goal;
    s->edit = edit;
    s->dice = 0x9E3779B9u;
    return NOOK_OK;
}

nook_status nook_simplify_step(nook_simplify_state *s, uint32_t *units) {
    while (s->phase != DONE) {
        nook_status status;
        if (*units == 0) return NOOK_MORE;
        --*units;
        status = advance(s);
        if (status != NOOK_OK) return status;
    }
    return s->goal->triangles == 0 ? NOOK_OK : s->refused;
}

nook_status nook_simplify(nook_simplify_state *s, nook_mesh *mesh, const nook_simplify_goal *goal,
                          const nook_edit *edit) {
    uint32_t units;
    nook_status status = nook_simplify_begin(s, mesh, goal, edit);
    if (status != NOOK_OK) return status;
    do {
        units = 64; /* any number gives the same */
        status = nook_simplify_step(s, &units);
    } while (status == NOOK_MORE);
    return status;
}
