/* nook_simplify.c -- the choice of edges, and of the points to which they go.
 *
 * Points are taken relative to a vertex of the edge and scaled so that the mesh is about 1024 wide: fourth powers of lengths,
 * which costs are, then stay in range, and a mesh 2^k times as large becomes the same, 2^k times as large. */
#include "shape/nook_simplify.h"

#include "edit/nook_inner.h"
#include "edit/nook_local.h"
#include "shape/nook_deviation.h"

enum { LOOK, DRAW, SWEEP, DONE };
enum {
    FRESH = 2,     /* vertices looked at for an edge that goes */
    PATIENCE = 24, /* and more of them at most */
    LONG = 64,     /* steps without a collapse */
    HELD = 24      /* corners around an edge where the vertex must be held outside */
};
#define ROUND                                                                                                \
    0x1p-15f /* how much of a sphere every quadric has, so that it has a least place also where all is flat */
#define SHORT                                                                                                \
    0x1p-22f /* how much more an edge costs for its length, so that among those that cost nothing short ones go */

/* ---- what is around an edge ------------------------------------------------------------------------- */

static inline nook_triple slope(const nook_quadric *a, nook_triple v) {
    return nook_plus(nook_times(a->square, v),
                     nook_plus(nook_times(a->mixed, nook_yzx(v)), nook_zxy(nook_times(a->mixed, v))));
}

static nook_quadric times(const nook_quadric *a, float by) {
    nook_quadric all = {nook_by(a->square, by), nook_by(a->mixed, by)};
    return all;
}

/* 1 over the square root of a float, at most a thirtieth off: exponent and mantissa are halved as one number. */
static inline float about_inverse_root(float x) {
    return nook_float_from(0x5F3759DFu - (nook_float_bits(x) >> 1));
}

/* The square of the distance from a triangle's plane, times about its area. */
static inline void add_normal(nook_quadric *a, nook_triple n) {
    nook_triple unit = nook_by(n, about_inverse_root(nook_inner(n, n)));
    a->square = nook_plus(a->square, nook_times(n, unit));
    a->mixed = nook_plus(a->mixed, nook_times(n, nook_yzx(unit)));
}

/* The square of the area between a place and a border edge. */
static void add_border(nook_quadric *a, nook_triple e) {
    float square = nook_inner(e, e);
    nook_triple all = nook_triple_of(square, square, square);
    a->square = nook_plus(a->square, nook_minus(all, nook_times(e, e)));
    a->mixed = nook_minus(a->mixed, nook_times(e, nook_yzx(e)));
}

static inline nook_triple from(const nook_simplify_state *s, nook_triple p, const nook_point *q) {
    return nook_by(nook_minus(nook_triple_at(q), p), s->scale);
}

static bool push(nook_edge_ring *r, const nook_mesh *m, uint32_t c) {
    r->c[r->n++] = nook_store(c);
    return m->V[c] < m->nv;
}

/* On from the last corner across e, until e faces stop or a border. */
NOOK_APART static nook_status walk(nook_edge_ring *r, const nook_simplify_state *s, uint32_t chain,
                                   uint32_t e, uint32_t stop, bool close) {
    const nook_mesh *m = s->mesh;
    uint32_t n = r->n, corners = 3u * m->nt, o, w;
    nook_triple p = nook_triple_at(&r->p[chain / 2u]), u = from(s, p, nook_ring_point(m, r, n - 1u)), v;
    nook_quadric a = r->a[chain / 2u];
    if ((chain & 1u) == 0) add_normal(&a, nook_outer(u, from(s, p, nook_ring_point(m, r, n - 2u))));
    while ((o = m->O[e]) != stop && o != e) {
        if (o >= corners || (w = m->V[o]) >= m->nv) return NOOK_BAD_OPPOSITE;
        if (n >= NOOK_RING_MOST) return NOOK_TOO_MANY_TRIANGLES;
        r->c[n++] = nook_store(o);
        v = from(s, p, &m->G[w]);
        add_normal(&a, nook_outer(u, v));
        u = v;
        e = (chain & 1u) != 0 ? nook_prev(o) : nook_next(o);
    }
    r->met = o != stop;
    if (r->met) {
        add_border(&a, u);
    } else if (close) {
        add_normal(&a, nook_outer(u, from(s, p, nook_ring_point(m, r, r->start[chain]))));
    }
    r->a[chain / 2u] = a;
    r->n = n;
    return NOOK_OK;
}

/* All around both ends, or around C alone; then its quadric has the triangle across c too. */
NOOK_APART static nook_status gather(nook_edge_ring *r, const nook_simplify_state *s, uint32_t c,
                                     uint32_t ends) {
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
    for (end = 0; end < ends; end++) {
        uint32_t x = end == 0 ? c : o, y = end == 0 ? o : c;
        nook_status status = NOOK_OK;
        r->met = true;
        if (o == NOOK_NONE) add_border(&r->a[end], from(s, nook_triple_at(&r->p[0]), &r->p[1]));
        r->start[2u * end] = r->n;
        if (x != NOOK_NONE) {
            if (!push(r, m, nook_next(x)) || !push(r, m, x)) return NOOK_BAD_OPPOSITE;
            status = walk(r, s, 2u * end, nook_next(x), y == NOOK_NONE ? y : nook_prev(y), ends == 1u);
        }
        r->start[2u * end + 1u] = r->n;
        r->open = r->open || r->met;
        if (status == NOOK_OK && r->met && y != NOOK_NONE) {
            if (!push(r, m, y)) return NOOK_BAD_OPPOSITE;
            status = walk(r, s, 2u * end + 1u, nook_prev(y), NOOK_NONE, false);
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
    nook_triple half, g;
    float trace;
} costs;

static void invert(nook_quadric *to, const nook_quadric *a) {
    nook_triple all = nook_plus(a->square, nook_triple_of(ROUND, ROUND, ROUND)), next = nook_yzx(a->mixed);
    to->square = nook_minus(nook_times(nook_yzx(all), nook_zxy(all)), nook_times(next, next));
    to->mixed = nook_minus(nook_times(next, nook_zxy(a->mixed)), nook_times(a->mixed, nook_zxy(all)));
    *to = times(to, 3.0f / (nook_inner(all, to->square) + 2 * nook_inner(a->mixed, to->mixed)));
}

/* About the middle, the sum of both quadrics has half the difference of both at work on the edge as its slope. */
NOOK_APART static void add_up(costs *f, const nook_edge_ring *r, float scale) {
    const nook_quadric *c = &r->a[0], *b = &r->a[1];
    nook_quadric less = {nook_minus(b->square, c->square), nook_minus(b->mixed, c->mixed)};
    f->a.square = nook_plus(b->square, c->square);
    f->a.mixed = nook_plus(b->mixed, c->mixed);
    f->trace = nook_sum(f->a.square) + 0x1p-100f;
    f->half = nook_by(nook_minus(nook_triple_at(&r->p[1]), nook_triple_at(&r->p[0])), 0.5f * scale);
    f->g = nook_by(slope(&less, f->half), 1.0f / f->trace);
    f->a = times(&f->a, 1.0f / f->trace);
    invert(&f->inverse, &f->a);
}

static float cost_at(const costs *f, nook_triple y) {
    float sum =
        nook_inner(y, slope(&f->a, y)) - 2 * nook_inner(f->g, y) + nook_inner(f->half, slope(&f->a, f->half));
    return f->trace * (nook_abs(sum) + SHORT * nook_inner(f->half, f->half));
}

/* Once more on what is left, so that ROUND moves nothing that is not flat. */
static nook_triple least_place(const costs *f) {
    nook_triple y = slope(&f->inverse, f->g);
    return nook_plus(y, slope(&f->inverse, nook_minus(f->g, slope(&f->a, y))));
}

static nook_point from_middle(const nook_simplify_state *s, const nook_edge_ring *r, nook_triple y) {
    nook_triple middle = nook_plus(nook_triple_at(&r->p[0]), nook_triple_at(&r->p[1]));
    return nook_point_of(nook_plus(nook_by(middle, 0.5f), nook_by(y, s->unit)));
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
NOOK_APART static nook_triple hold_outside(const nook_simplify_state *s, const nook_edge_ring *r,
                                           const costs *f, nook_triple y) {
    float pushed[HELD], least = 0x1p-12f * nook_sqrt(nook_inner(f->half, f->half));
    nook_point middle = from_middle(s, r, nook_triple_of(0, 0, 0));
    const nook_point *t[3];
    uint32_t i, j;
    bool still = false;
    memset(pushed, 0, sizeof pushed);
    for (j = 0; j < 32u && !still; j++) {
        for (still = true, i = 0; i < r->n; i++) {
            nook_triple n, w, corner;
            float by, high, steep;
            if (!nook_ring_face(s->mesh, r, i, t)) continue;
            corner = nook_triple_at(t[0]);
            n = nook_outer(from(s, corner, t[1]), from(s, corner, t[2]));
            w = slope(&f->inverse, n);
            high = least * nook_sqrt(nook_inner(n, n));
            steep = nook_inner(n, w) + 0x1p-100f;
            by = (high - nook_inner(n, nook_plus(y, from(s, corner, &middle)))) / steep;
            if (by < -pushed[i]) by = -pushed[i];
            if (nook_abs(by) * steep > 0.5f * high) still = false;
            pushed[i] += by;
            y = nook_plus(y, nook_by(w, by));
        }
    }
    return y;
}

/* The best of both ends and that place. */
NOOK_APART static bool place_outside(const nook_simplify_state *s, const nook_edge_ring *r, const costs *f,
                                     nook_triple y, nook_point *at, float *cost) {
    uint32_t i;
    *cost = 0x1p127f;
    if (r->open || r->n > HELD) return false;
    for (i = 0; i < 3u; i++) {
        nook_triple y2 = i == 2u ? hold_outside(s, r, f, y) : nook_by(f->half, i == 0 ? -1.0f : 1.0f);
        float less = cost_at(f, y2);
        nook_point place = i == 2u ? from_middle(s, r, y2) : r->p[i];
        if (!(less < *cost * (i == 2u ? 0.5f : 1.0f)) || !is_outside(s, r, &place)) continue;
        *cost = less;
        *at = place;
    }
    return *cost < 0x1p127f;
}

/* ---- what must not happen ----------------------------------------------------------------------------- */

NOOK_APART static bool turns_exactly(const nook_point *p, const nook_point *at, const nook_point *w,
                                     const nook_point *z) {
    static const nook_edit asking = {.no_turn = true};
    const nook_point *const old[4] = {p, w, z, z};
    return nook_is_turned(&asking, at, w, z, old);
}

/* Whether a triangle of an end would turn. Where lengths and the cosine, 2^-18 at least, leave no doubt floats do. */
NOOK_APART static bool turns(const nook_simplify_state *s, const nook_edge_ring *r, uint32_t chain,
                             const nook_point *at) {
    const nook_mesh *m = s->mesh;
    const nook_point *p = &r->p[chain / 2u], *w, *z;
    uint32_t i = r->start[chain] + ((chain & 1u) ^ 1u), end = r->start[chain + 1u];
    nook_triple old = nook_triple_at(p), now = nook_triple_at(at), u, v, x, y;
    float uu, vv, xx, yy;
    if (i >= end) return false;
    w = nook_ring_point(m, r, i);
    u = from(s, old, w), x = from(s, now, w);
    uu = nook_inner(u, u), xx = nook_inner(x, x);
    for (i++; i < end; i++) {
        float cosine;
        bool sure;
        z = nook_ring_point(m, r, i);
        v = from(s, old, z), y = from(s, now, z);
        vv = nook_inner(v, v), yy = nook_inner(y, y);
        cosine = nook_inner(nook_outer(u, v), nook_outer(x, y));
        sure = cosine > 0x1p-40f && cosine * cosine > 0x1p-36f * (uu * vv) * (xx * yy);
        if (!sure && turns_exactly(p, at, w, z)) return true;
        w = z, u = v, x = y, uu = vv, xx = yy;
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
    nook_triple y;
    add_up(&f, r, s->scale);
    y = least_place(&f);
    if (s->goal->outside) return place_outside(s, r, &f, y, &to->at, &to->cost) ? NOOK_OK : NOOK_NO_PLACE;
    to->at = from_middle(s, r, y);
    to->cost = cost_at(&f, y);
    return NOOK_OK;
}

/* The same of the edge of c, with all conditions; NOOK_MORE where it costs more than that. */
NOOK_APART static nook_status judge(const nook_simplify_state *s, uint32_t c, float limit, choice *to) {
    nook_edge_ring r;
    uint32_t i;
    nook_status status = gather(&r, s, c, 2);
    memset(to, 0, sizeof *to);
    if (status == NOOK_OK) status = place(s, &r, to);
    if (status != NOOK_OK) return status;
    if (to->cost > limit) return NOOK_MORE;
    for (i = 0; i < 4u; i++) {
        if (turns(s, &r, i, &to->at)) return NOOK_TURNED_TRIANGLE;
    }
    if (nook_point_status(to->at) != NOOK_OK) return NOOK_NO_PLACE;
    if (s->goal->deviation == NULL) return NOOK_OK;
    to->deviation = nook_deviation_at(s->mesh, &r, s->goal->deviation, s->scale, to->at) * s->unit;
    return to->deviation <= s->allowed ? NOOK_OK : NOOK_NO_PLACE;
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

/* What stands in the way is kept. */
static void refuse(nook_simplify_state *s, uint32_t c, nook_status status) {
    s->refused = status;
    s->where = nook_at(NOOK_AT_CORNER, c);
}

/* With all conditions. */
static bool try_edge(nook_simplify_state *s, uint32_t c, const choice *to, nook_status status) {
    if (status == NOOK_OK) status = collapse(s, c, to);
    if (status == NOOK_OK) {
        s->usual *= to->cost > s->usual ? 1.125f : 0.96875f;
        if (s->fresh >= (uint32_t)(FRESH + PATIENCE)) s->usual = more(s->usual, 0.25f * to->cost);
        s->idle = s->fresh = 0;
        return true;
    }
    refuse(s, c, status);
    return false;
}

/* ---- the choice ------------------------------------------------------------------------------------------ */

static uint32_t draw_corner(nook_simplify_state *s) {
    s->dice ^= s->dice << 13;
    s->dice ^= s->dice >> 17;
    s->dice ^= s->dice << 5;
    return (uint32_t)((uint64_t)s->dice * (3u * s->mesh->nt) >> 32);
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

/* The edge of C along which its quadric grows least; the first, where none has gone for long. */
static uint32_t easiest(const nook_simplify_state *s, const nook_edge_ring *r, float *least) {
    nook_quadric a = r->a[0];
    float length = SHORT * nook_sum(a.square);
    nook_triple p = nook_triple_at(&r->p[0]);
    uint32_t i, best = 0, n = s->idle > (uint32_t)LONG ? 1 : r->n;
    a.square = nook_plus(a.square, nook_triple_of(length, length, length));
    *least = 0x1p127f;
    for (i = 0; i < n; i++) {
        nook_triple e = from(s, p, nook_ring_point(s->mesh, r, i));
        float cost = nook_inner(e, slope(&a, e));
        if (cost < *least) *least = cost, best = i;
    }
    i = r->c[best];
    return best == 0 || best >= r->start[1] ? nook_prev(i) : nook_next(i);
}

/* Until it is looked at from both ends, an edge is taken to cost half of what it would if C went all the way to B. */
NOOK_APART static void draw(nook_simplify_state *s) {
    nook_edge_ring r = {0};
    uint32_t c = draw_corner(s);
    float cost;
    nook_status status = gather(&r, s, c, 1);
    s->fresh++;
    if (status == NOOK_OK) {
        c = easiest(s, &r, &cost);
        put(s, c, 0.5f * cost);
    } else {
        refuse(s, c, status);
    }
}

/* The best of the pool, unless it costs more than was thought and than the next. */
static void take(nook_simplify_state *s) {
    uint32_t c = s->pool[--s->pooled].c;
    nook_status status;
    choice to;
    if (c >= 3u * s->mesh->nt) return;
    status = judge(s, c, s->pooled != 0 ? s->pool[s->pooled - 1u].cost : 0x1p127f, &to);
    if (status == NOOK_MORE) {
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
        nook_status status = judge(s, c, 0x1p127f, &to);
        if (try_edge(s, c, &to, status)) return;
    }
    if (++s->idle > 3u * s->mesh->nt) s->phase = DONE;
}

/* How many vertices must be drawn before the best of the pool goes: more, where that costs four times the usual. */
static uint32_t enough(const nook_simplify_state *s) {
    uint32_t best = nook_exponent(s->pool[s->pooled - 1u].cost), usual = nook_exponent(s->usual) + 2u,
             longer = best > usual ? 4u * (best - usual) : 0;
    return FRESH + (longer < (uint32_t)PATIENCE ? longer : (uint32_t)PATIENCE);
}

static void allow(nook_simplify_state *s, float deviation) {
    s->allowed = deviation < s->goal->error ? deviation : s->goal->error;
}

/* A vertex, once; then a draw, or what was drawn; where none has gone for long, with a larger deviation; at last a sweep. */
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
        s->allowed = s->goal->error;
        if (s->goal->deviation != NULL) {
            allow(s, (s->goal->error < s->extent ? s->goal->error : s->extent) * 0x1p-12f + 0x1p-126f);
        }
        s->phase = DRAW;
    } else if (m->nt <= s->goal->triangles) {
        s->refused = NOOK_OK;
        s->where = nook_at(NOOK_NOWHERE, 0);
        s->phase = DONE;
    } else if (s->phase == SWEEP) {
        sweep(s);
    } else if (++s->idle > (uint32_t)LONG && s->allowed < s->goal->error) {
        allow(s, s->allowed > s->extent ? s->goal->error : 2 * s->allowed);
        s->idle = 0;
    } else if (s->idle > 8u * m->nt + 64u) {
        s->phase = SWEEP;
        s->idle = s->at = 0;
    } else if (s->pooled == 0 || s->fresh < enough(s)) {
        draw(s);
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
