/* nook_smooth.c -- pass by pass, axis by axis. */
#include "shape/nook_smooth.h"

#include <string.h>

enum { LOOK, BEFORE, MOVE, TURN, TAKE, AFTER, DONE };

/* ---- the middle of neighbours ------------------------------------------------------------------------ */

/* Where the fan of corner c begins: at the border, or at its smallest corner. NOOK_NONE where the tables do not hold. */
static uint32_t first_of_fan(const nook_view *m, uint32_t c) {
    uint32_t x = c, low = c, back, steps = m->nt;
    while ((back = nook_turn(m, x, true)) != c) {
        if (back == NOOK_NONE) return x;
        if (steps-- == 0) return NOOK_NONE;
        x = back;
        if (x < low) low = x;
    }
    return low;
}

/* The sum over the neighbours of v(first), and how many they are; at the border of the two there, which may be none. */
static nook_status add_up(const nook_smooth_state *s, uint32_t first, float *sum, uint32_t *count) {
    const nook_view *m = &s->view;
    uint32_t x = first, last, v;
    *sum = 0;
    *count = 0;
    do {
        v = m->V[nook_next(x)];
        if (v >= m->nv || *count == m->nt) return NOOK_BAD_OPPOSITE;
        *sum += nook_along(&m->G[v], s->axis);
        ++*count;
        last = x;
        x = nook_turn(m, x, false);
    } while (x != NOOK_NONE && x != first);
    if (x == first) return NOOK_OK;
    v = m->V[nook_prev(last)];
    if (v >= m->nv) return NOOK_BAD_OPPOSITE;
    *sum = nook_along(&m->G[m->V[nook_next(first)]], s->axis) + nook_along(&m->G[v], s->axis);
    *count = s->how.slide ? 2u : 0;
    return NOOK_OK;
}

/* Where v goes along the axis, into next[v]. Who was held back and then went only back would go farther each round. */
static nook_status move(const nook_smooth_state *s, uint32_t v) {
    float at = nook_along(&s->G[v], s->axis), sum;
    bool stays = s->back && s->how.reference != NULL && s->next[v] == at;
    uint32_t c = nook_corner_of(&s->view, v), count;
    nook_status status;
    s->next[v] = at;
    if (c == NOOK_NONE || stays) return NOOK_OK;
    if (c >= 3u * s->view.nt || s->view.V[c] != v) return NOOK_BAD_VERTEX_CORNER;
    c = first_of_fan(&s->view, c);
    if (c == NOOK_NONE) return NOOK_BAD_OPPOSITE;
    status = add_up(s, c, &sum, &count);
    if (status != NOOK_OK || count == 0) return status;
    sum = at + (s->back ? s->how.mu : s->how.lambda) * (sum / (float)count - at);
    if (sum >= -NOOK_MAX_COORDINATE && sum <= NOOK_MAX_COORDINATE) s->next[v] = sum;
    return NOOK_OK;
}

/* ---- triangles --------------------------------------------------------------------------------------- */

static nook_status points_of(const nook_smooth_state *s, uint32_t t, const nook_point *p[4]) {
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        uint32_t v = s->view.V[3u * t + i];
        if (v >= s->view.nv) {
            s->result->where = nook_at(NOOK_AT_CORNER, 3u * t + i);
            return NOOK_INDEX_OUT_OF_RANGE;
        }
        p[i] = &s->G[v];
    }
    p[3] = p[2];
    return NOOK_OK;
}

/* Before, and turned over after: what is left is the difference. */
static nook_status measure(nook_smooth_state *s, uint32_t t) {
    const nook_point *p[4];
    nook_status status = points_of(s, t, p);
    bool before = s->phase == BEFORE;
    if (status == NOOK_OK) nook_volume_add(&s->volume, p[0], p[before ? 1 : 2], p[before ? 2 : 1]);
    return status;
}

/* A triangle that would turn keeps its place along the axis. If it stood well, it has a vertex that would have moved and
 * does so no more: therefore sweeps over all triangles come to an end. */
static nook_status hold(nook_smooth_state *s, uint32_t t) {
    const nook_index *V = s->view.V + 3u * t;
    const nook_point *p[4], *q[4], *r[4];
    nook_point to[3];
    uint32_t i;
    nook_status status = points_of(s, t, p);
    if (status != NOOK_OK) return status;
    for (i = 0; i < 3u; i++) {
        to[i] = *p[i];
        *nook_axis(&to[i], s->axis) = s->next[V[i]];
        q[i] = &to[i];
        r[i] = &s->how.reference[V[i]];
    }
    q[3] = q[2];
    r[3] = r[2];
    if (nook_compare_normals(r, q) > 0 || nook_compare_normals(r, p) <= 0) return NOOK_OK;
    for (i = 0; i < 3u; i++) s->next[V[i]] = nook_along(p[i], s->axis);
    s->held = true;
    s->result->held++;
    return NOOK_OK;
}

/* The old coordinate stays in next, so that the way back sees who went. */
static void take(nook_smooth_state *s, uint32_t v) {
    float *at = nook_axis(&s->G[v], s->axis), old = *at;
    *at = s->next[v];
    s->next[v] = old;
}

/* ---- passes ------------------------------------------------------------------------------------------ */

static nook_status visit(nook_smooth_state *s, uint32_t i) {
    nook_status status = NOOK_OK;
    switch (s->phase) {
    case LOOK: status = nook_point_status(s->G[i]); /* fall through */
    case MOVE:
        if (status == NOOK_OK) status = move(s, i);
        if (status != NOOK_OK) s->result->where = nook_at(NOOK_AT_VERTEX, i);
        return status;
    case TURN: return hold(s, i);
    case TAKE: take(s, i); return NOOK_OK;
    default: return measure(s, i);
    }
}

/* The way back along the axis, the next axis, or the next round. */
static uint32_t phase_after_pass(nook_smooth_state *s) {
    s->back = !s->back && s->how.mu != 0;
    if (s->back) return MOVE;
    s->axis = nook_after(s->axis);
    if (s->axis == 0) s->round++;
    return s->round < s->how.rounds ? MOVE : AFTER;
}

static uint32_t next_phase(nook_smooth_state *s) {
    bool held = s->held;
    s->held = false;
    switch (s->phase) {
    case LOOK: return BEFORE;
    case BEFORE: s->result->volume = nook_volume_value(&s->volume); return s->how.rounds != 0 ? MOVE : AFTER;
    case MOVE: return s->how.reference != NULL ? TURN : TAKE;
    case TURN: return held ? TURN : TAKE;
    case TAKE: return phase_after_pass(s);
    default: s->result->gained = 0.0f - nook_volume_value(&s->volume); return DONE;
    }
}

nook_status nook_smooth_begin(nook_smooth_state *s, nook_mesh *mesh, const nook_smoothing *how, float *next,
                              nook_smoothed *result) {
    if (s == NULL || mesh == NULL || how == NULL || next == NULL || result == NULL) return NOOK_NULL_ARGUMENT;
    memset(s, 0, sizeof *s);
    memset(result, 0, sizeof *result);
    s->view = nook_view_of(mesh);
    s->G = mesh->G;
    s->how = *how;
    s->next = next;
    s->result = result;
    nook_volume_clear(&s->volume);
    return NOOK_OK;
}

nook_status nook_smooth_step(nook_smooth_state *s, uint32_t *units) {
    while (s->phase != DONE) {
        bool of_triangles = s->phase == BEFORE || s->phase == TURN || s->phase == AFTER;
        nook_status status;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->at == (of_triangles ? s->view.nt : s->view.nv)) {
            s->at = 0;
            s->phase = next_phase(s);
            continue;
        }
        status = visit(s, s->at);
        if (status != NOOK_OK) return status;
        s->at++;
    }
    return NOOK_OK;
}

nook_status nook_smooth(nook_mesh *mesh, const nook_smoothing *how, float *next, nook_smoothed *result) {
    nook_smooth_state state;
    uint32_t units;
    nook_status status = nook_smooth_begin(&state, mesh, how, next, result);
    if (status != NOOK_OK) return status;
    do {
        units = 64; /* any number gives the same */
        status = nook_smooth_step(&state, &units);
    } while (status == NOOK_MORE);
    return status;
}
