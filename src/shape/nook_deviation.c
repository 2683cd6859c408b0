/* nook_deviation.c -- the two maps of nook_simplify.h, and which of them moves less. */
#include "shape/nook_deviation.h"

#include "exact/nook_exact.h"

/* A place seen along the vector area of the ring: u, v in a coordinate plane, h across it; and the number there. */
typedef struct seen {
    float u, v, h, e;
} seen;

typedef struct sight {
    const nook_mesh *m;
    const float *deviation;
    float scale;
    const nook_edge_ring *r;
    nook_point at;
    uint32_t axis;
    bool mirrored; /* the ring runs counter-clockwise as seen, else clockwise */
    float u, v;    /* how far one goes sideways, a unit of h */
    float length;  /* and how far in all */
} sight;

static seen look(const sight *l, nook_point p, float e) {
    nook_point d = nook_between(l->at, p, l->scale);
    float h = nook_along(&d, l->axis);
    seen o = {nook_along(&d, nook_after(l->axis)) - h * l->u,
              nook_along(&d, nook_after(nook_after(l->axis))) - h * l->v, h, e};
    return o;
}

static seen look_at_end(const sight *l, uint32_t end) {
    return look(l, l->r->p[end], l->deviation[l->r->v[end]] * l->scale);
}

static seen look_at_ring(const sight *l, uint32_t i) {
    uint32_t v = l->m->V[l->r->c[i]];
    return look(l, l->m->G[v], l->deviation[v] * l->scale);
}

static float cross(seen p, seen q) { return p.u * q.v - p.v * q.u; }

static seen minus(seen p, seen q) {
    seen d = {p.u - q.u, p.v - q.v, p.h - q.h, p.e - q.e};
    return d;
}

/* What the new vertex, seen at 0 with height 0, must have for place p of the old surface, seen at triangle 0 a b of the new: 0 if it
 * is not there. */
static float due_in(const sight *l, seen p, seen a, seen b) {
    float area = cross(a, b), y = cross(p, b) / area, z = cross(a, p) / area, x = 1.0f - y - z;
    if (!(x >= -0x1p-10f && y >= -0x1p-10f && z >= -0x1p-10f)) return 0;
    if (x < 0x1p-10f) return 0x1p100f; /* at the ring */
    return (p.e + l->length * nook_abs(p.h - y * a.h - z * b.h) - y * a.e - z * b.e) / x;
}

/* The same the other way: the new vertex seen at triangle p a b of the old. */
static float due_under(const sight *l, seen p, seen a, seen b) {
    float area = cross(minus(a, p), minus(b, p)), x = cross(a, b) / area, y = cross(b, p) / area,
          z = cross(p, a) / area;
    if (!(x >= -0x1p-10f && y >= -0x1p-10f && z >= -0x1p-10f)) return 0;
    return x * p.e + y * a.e + z * b.e + l->length * nook_abs(x * p.h + y * a.h + z * b.h);
}

/* And for where the old edge p w is seen to cross the new edge to z, which is within the ring but for rounding. */
static float due_across(const sight *l, seen p, seen w, seen z) {
    seen d = minus(w, p);
    float area = cross(d, z), y = -cross(p, z) / area, t = -cross(p, d) / area;
    if (!(y > 0 && y < 1 && t > 0)) return 0;
    return (p.e + y * d.e + l->length * nook_abs(p.h + y * d.h - t * z.h) - t * z.e) / nook_abs(1.0f - t);
}

/* Whether a triangle with that normal faces the way one looks, by a sixteenth of its area at least. */
static bool faces(nook_triple way, float square, nook_triple normal) {
    float d = nook_inner(normal, way);
    return d > 0 && d * d * 256.0f > nook_inner(normal, normal) * square;
}

/* Of a triangle with a corner at p. */
static nook_triple normal_at(const sight *l, const nook_point *p, const nook_point *q, const nook_point *r) {
    nook_triple corner = nook_triple_at(p);
    return nook_outer(nook_by(nook_minus(nook_triple_at(q), corner), l->scale),
                      nook_by(nook_minus(nook_triple_at(r), corner), l->scale));
}

/* Look along the vector area. Whether both surfaces lie flat over the ring, and the new once. */
NOOK_APART static bool begin_sight(sight *l) {
    const nook_mesh *m = l->m;
    nook_triple sum = nook_triple_of(0, 0, 0);
    nook_point way;
    const nook_point *t[3];
    uint32_t i, turns_of_ring = 0;
    float by, square;
    for (i = 0; i < l->r->n; i++) {
        if (nook_ring_face(m, l->r, i, t)) sum = nook_plus(sum, normal_at(l, t[0], t[1], t[2]));
    }
    way = nook_point_of(sum);
    square = nook_inner(sum, sum);
    l->axis = nook_abs(way.x) > nook_abs(way.y) ? 0 : 1u;
    if (nook_abs(way.z) > nook_abs(nook_along(&way, l->axis))) l->axis = 2;
    by = 1.0f / nook_along(&way, l->axis);
    l->mirrored = by < 0;
    l->u = nook_along(&way, nook_after(l->axis)) * by;
    l->v = nook_along(&way, nook_after(nook_after(l->axis))) * by;
    l->length = nook_sqrt(1.0f + l->u * l->u + l->v * l->v);
    for (i = 0; i < l->r->n; i++) {
        if (!nook_ring_face(m, l->r, i, t)) continue;
        if (!faces(sum, square, normal_at(l, t[0], t[1], t[2]))) return false;
        if (i == 1u || i == l->r->start[2] + 1u) continue; /* at the edge */
        if (!faces(sum, square, normal_at(l, &l->at, t[1], t[2]))) return false;
        turns_of_ring += (look(l, *t[1], 0).v < 0) != (look(l, *t[2], 0).v < 0);
    }
    return turns_of_ring == 2u;
}

static float more(float a, float b) { return a > b ? a : b; }

/* The ring corner before or after another; A and D come twice. */
static uint32_t beside(const nook_edge_ring *r, uint32_t i, bool before) {
    i = before ? i - 1u : i + 1u;
    if (i == r->start[2]) i = before ? i - 1u : i + 1u;
    return i == 0 ? r->n - 1u : i == r->n ? 1u : i;
}

/* What all places of the edge from an end, seen at p, to ring corner i, seen at w, must have. It crosses new edges one after the
 * other, from the next to w on until they are seen beyond p. */
static float due_along(const sight *l, uint32_t i, seen p, seen w) {
    bool left = cross(w, p) > 0, before = left != l->mirrored;
    uint32_t j, rest = l->r->n;
    float due = 0;
    for (j = beside(l->r, i, before); rest-- > 0; j = beside(l->r, j, before)) {
        seen z = look_at_ring(l, j);
        if (l->m->V[l->r->c[i]] == l->m->V[l->r->c[j]]) continue;
        if ((cross(z, p) > 0) != left) break;
        due = more(due, due_across(l, p, w, z));
    }
    return due;
}

/* By the second map. */
NOOK_APART static float due_straight(const sight *l) {
    seen c = look_at_end(l, 0), b = look_at_end(l, 1), p = c, w = b, z;
    float due = 0, size = nook_abs(c.u) + nook_abs(c.v) + nook_abs(c.h);
    uint32_t i;
    for (i = 1; i < l->r->n; i++) {
        z = w;
        if (i == l->r->start[2]) i++, p = b, z = c;
        w = look_at_ring(l, i);
        size = more(size, nook_abs(w.u) + nook_abs(w.v) + nook_abs(w.h));
        due = more(due, due_across(l, c, b, w));
        due = more(due, due_along(l, i, p, w));
        due = more(due, due_under(l, p, w, z));
        if (i == 1u || i == l->r->start[2] + 1u) continue;
        due = more(due, more(due_in(l, c, w, z), due_in(l, b, w, z)));
    }
    return due + 0x1p-18f * l->length * size;
}

/* Of the new vertex at that place. */
float nook_deviation_at(const nook_mesh *m, const nook_edge_ring *r, const float *deviation, float scale,
                        nook_point at) {
    sight l;
    float due = 0, less;
    uint32_t end;
    l.m = m;
    l.r = r;
    l.deviation = deviation;
    l.scale = scale;
    l.at = at;
    for (end = 0; end < 2u; end++)
        due = more(due, deviation[r->v[end]] * scale + nook_length(nook_between(r->p[end], at, scale)));
    if (!r->open && begin_sight(&l)) {
        less = due_straight(&l);
        if (less < due) due = less;
    }
    return due * (1.0f + 0x1p-20f);
}
