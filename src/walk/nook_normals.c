/* nook_normals.c -- means of normals over fans, and over their parts. */
#include "walk/nook_normals.h"

#include <string.h>

#define NO_CREASE (-2.0f) /* below any cosine: normals need not be looked at */
#define OPEN 2.0f         /* no coordinate of a normal: none has been written yet */

/* Of the triangle of c; 0 if there is none, or no cosine that it could be asked for. */
static nook_point normal_of(const nook_view *m, uint32_t c, float cosine) {
    const nook_index *V = m->V + 3u * nook_triangle(c);
    nook_point p[3];
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        if (cosine < -1.0f || V[i] >= m->nv) return nook_make(0, 0, 0);
        p[i] = m->G[V[i]];
    }
    return nook_normal(p);
}

/* The corner after x, whose triangle has normal *n, unless there is a crease between; *n is then that of its triangle. */
static uint32_t go_on(const nook_view *m, uint32_t x, bool clockwise, float cosine, nook_point *n) {
    uint32_t y = nook_turn(m, x, clockwise);
    nook_point other;
    if (y == NOOK_NONE) return y;
    other = normal_of(m, y, cosine);
    if (nook_dot(*n, other) < cosine) return NOOK_NONE;
    *n = other;
    return y;
}

/* Where the part of the fan that has corner c begins: behind a crease or border, or at c if it comes round. NOOK_NONE where
 * the tables do not hold. */
static uint32_t first_of_part(const nook_view *m, uint32_t c, float cosine) {
    nook_point n = normal_of(m, c, cosine);
    uint32_t x = c, back, steps = m->nt;
    while ((back = go_on(m, x, false, cosine, &n)) != c) {
        if (back == NOOK_NONE) return x;
        if (steps-- == 0) return NOOK_NONE;
        x = back;
    }
    return c;
}

/* A part of a fan: its corners, and the normals added up, each as long as its triangle weighs. */
typedef struct part {
    uint32_t first, count;
    nook_point sum;
    float total;
} part;

static nook_point about_one(nook_point a) {
    return nook_scaled(a, nook_power_of_two(254u - nook_exponent(nook_length(a))));
}

/* By area edges are scaled so that neither the longest nor the shortest that count leave the floats when they are
 * multiplied; by angle each on its own. */
static void count_in(part *p, const nook_view *m, uint32_t c, nook_weight weight) {
    uint32_t v = m->V[c], w = m->V[nook_next(c)], u = m->V[nook_prev(c)];
    bool by_area = weight == NOOK_BY_AREA;
    nook_point a, b, n;
    float length, weighs;
    p->count++;
    if (v >= m->nv || w >= m->nv || u >= m->nv) return;
    a = nook_sub(m->G[w], m->G[v]);
    b = nook_sub(m->G[u], m->G[v]);
    a = by_area ? nook_scaled(a, 0x1p16f) : about_one(a);
    b = by_area ? nook_scaled(b, 0x1p16f) : about_one(b);
    n = nook_cross(a, b);
    length = nook_length(n);
    if (!(length > 0x1p-100f)) return;
    weighs = by_area ? length : nook_angle(length, nook_dot(a, b));
    n = nook_scaled(n, weighs / length);
    p->sum = nook_make(p->sum.x + n.x, p->sum.y + n.y, p->sum.z + n.z);
    p->total += weighs;
}

/* The part that has corner c. NOOK_ZERO_AREA_TRIANGLE: its mean is none, and 0. */
static nook_status part_of(part *p, const nook_view *m, uint32_t c, nook_weight weight, float cosine) {
    bool met = false;
    uint32_t x;
    nook_point n;
    float length;
    memset(p, 0, sizeof *p);
    x = p->first = first_of_part(m, c, cosine);
    if (x == NOOK_NONE) return NOOK_BAD_OPPOSITE;
    n = normal_of(m, x, cosine);
    do {
        met = met || x == c;
        count_in(p, m, x, weight);
        x = go_on(m, x, true, cosine, &n);
    } while (x != NOOK_NONE && x != p->first && p->count < m->nt);
    if (!met) return NOOK_BAD_OPPOSITE;
    length = nook_length(p->sum);
    if (length > 0x1p-16f * p->total + 0x1p-100f) {
        p->sum = nook_scaled(p->sum, 1.0f / length);
        return NOOK_OK;
    }
    p->sum = nook_make(0, 0, 0);
    return NOOK_ZERO_AREA_TRIANGLE;
}

nook_status nook_vertex_normal(const nook_view *view, uint32_t c, nook_weight weight, nook_point *normal) {
    part p;
    nook_status status;
    *normal = nook_make(0, 0, 0);
    if (c >= 3u * view->nt) return NOOK_INDEX_OUT_OF_RANGE;
    status = part_of(&p, view, c, weight, NO_CREASE);
    if (status == NOOK_OK) *normal = p.sum;
    return status;
}

/* ---- creases ---------------------------------------------------------------------------------------- */

nook_status nook_creases_begin(nook_creases *s, const nook_view *view, nook_weight weight, float cosine,
                               float *to, uint32_t width) {
    if (s == NULL || view == NULL || to == NULL) return NOOK_NULL_ARGUMENT;
    if (width < 3u) return NOOK_NO_CAPACITY;
    memset(s, 0, sizeof *s);
    s->view = view;
    s->weight = weight;
    s->cosine = cosine;
    s->to = to;
    s->width = width;
    return NOOK_OK;
}

/* All corners of the part that has corner c. */
static nook_status write_part(nook_creases *s, uint32_t c) {
    part p;
    nook_status status = part_of(&p, s->view, c, s->weight, s->cosine);
    if (status == NOOK_BAD_OPPOSITE) return status;
    if (status != NOOK_OK) s->without += p.count;
    for (c = p.first; p.count > 0; p.count--) {
        memcpy(s->to + (size_t)c * s->width, &p.sum, sizeof p.sum);
        c = nook_turn(s->view, c, true);
    }
    return NOOK_OK;
}

/* Each corner is marked as open before the first is looked at; a part is written when its first corner comes. */
nook_status nook_creases_step(nook_creases *s, uint32_t *units) {
    uint32_t nc = 3u * s->view->nt;
    for (; s->at < 2u * nc; s->at++) {
        nook_status status = NOOK_OK;
        uint32_t c = s->at < nc ? s->at : s->at - nc;
        float *to = s->to + (size_t)c * s->width;
        if (*units == 0) return NOOK_MORE;
        --*units;
        if (s->at < nc) {
            *to = OPEN;
        } else if (*to == OPEN) {
            status = write_part(s, c);
        }
        if (status != NOOK_OK) return status;
    }
    return NOOK_OK;
}
