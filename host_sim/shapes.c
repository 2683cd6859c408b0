/* shapes.c -- tetrahedron, icosphere, box, torus, capsule, pipe, gear, sheet and Moebius strip.
 *
 * Each has a kind of grid of a by b cells and a count of triangles that follows from it; the pair
 * nearest to the number asked for is found by trying. Steps: O(triangles). */
#include "shapes.h"

#include <stdlib.h>

#include "heap.h"

/* ---- drawing ----------------------------------------------------------------------------------- */

uint32_t drawing_vertex(drawing *d, nook_point p) {
    d->G = grow(d->G, &d->room_G, (size_t)d->nv + 1, sizeof *d->G);
    d->G[d->nv] = p;
    return d->nv++;
}

void drawing_triangle(drawing *d, uint32_t a, uint32_t b, uint32_t c) {
    d->V = grow(d->V, &d->room_V, 3 * (size_t)d->nt + 3, sizeof *d->V);
    d->V[3 * (size_t)d->nt] = a;
    d->V[3 * (size_t)d->nt + 1] = b;
    d->V[3 * (size_t)d->nt + 2] = c;
    d->nt++;
}

void drawing_free(drawing *d) {
    free(d->G);
    free(d->V);
    memset(d, 0, sizeof *d);
}

static void triangle(drawing *d, nook_point a, nook_point b, nook_point c) {
    uint32_t v = drawing_vertex(d, a);
    (void)drawing_vertex(d, b);
    (void)drawing_vertex(d, c);
    drawing_triangle(d, v, v + 1u, v + 2u);
}

static void quad(drawing *d, nook_point a, nook_point b, nook_point c, nook_point e) {
    triangle(d, a, b, c);
    triangle(d, a, c, e);
}

static nook_point plus(nook_point a, nook_point b) { return nook_make(a.x + b.x, a.y + b.y, a.z + b.z); }

/* ---- angles ------------------------------------------------------------------------------------ */

typedef struct direction {
    float x, y;
} direction;

/* Sine and cosine of an angle in [0, pi/4] by their series; the rest is below one part in 10^16. */
static void series(double a, double *sine, double *cosine) {
    double square = a * a, s = 0, c = 0;
    int k;
    for (k = 8; k >= 1; k--) {
        s = -(s + 1) * square / (double)(2 * k * (2 * k + 1));
        c = -(c + 1) * square / (double)(2 * k * (2 * k - 1));
    }
    *sine = a * (1 + s);
    *cosine = 1 + c;
}

/* The direction i/n of a turn from the x axis. The eighth of the turn is found in integers, so that
 * the axes are met exactly and the points are symmetric. */
static direction direction_of(uint32_t i, uint32_t n) {
    uint64_t eighths = (uint64_t)8u * (i % n);
    uint32_t octant = (uint32_t)(eighths / n);
    double part = (double)(eighths % n) / (double)n, s, c, swap;
    direction d;
    if (octant & 1u) part = 1 - part;
    series(part * 0.78539816339744830962, &s, &c);
    if (((octant + 1u) & 2u) != 0) {
        swap = s;
        s = c;
        c = swap;
    }
    d.x = (float)(octant >= 2u && octant < 6u ? -c : c);
    d.y = (float)(octant >= 4u ? -s : s);
    return d;
}

/* ---- shapes ------------------------------------------------------------------------------------ */

static void draw_tetrahedron(drawing *d, uint32_t a, uint32_t b) {
    nook_point p = nook_make(1, 1, 1), q = nook_make(1, -1, -1), r = nook_make(-1, 1, -1),
               s = nook_make(-1, -1, 1);
    (void)a;
    (void)b;
    triangle(d, p, q, r);
    triangle(d, p, r, s);
    triangle(d, p, s, q);
    triangle(d, q, s, r);
}

/* The point (i, j) of a face cut into n by n triangles, on the unit sphere. On an edge one of the
 * three terms is zero and the sum of the others does not depend on their order. */
static nook_point on_sphere(const nook_point corner[3], uint32_t i, uint32_t j, uint32_t n) {
    nook_point p = plus(plus(nook_scaled(corner[1], (float)i), nook_scaled(corner[2], (float)j)),
                        nook_scaled(corner[0], (float)(n - i - j)));
    float length = nook_length(p);
    return nook_make(p.x / length, p.y / length, p.z / length);
}

static void draw_icosphere(drawing *d, uint32_t n, uint32_t b) {
    static const float g = 1.6180339887f; /* the golden ratio */
    static const uint8_t faces[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1},
    };
    const nook_point v[12] = {
        {-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
        {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1},
    };
    uint32_t f, i, j;
    (void)b;
    for (f = 0; f < 20u; f++) {
        nook_point c[3] = {v[faces[f][0]], v[faces[f][1]], v[faces[f][2]]};
        for (i = 0; i < n; i++) {
            for (j = 0; i + j < n; j++) {
                triangle(d, on_sphere(c, i, j, n), on_sphere(c, i + 1u, j, n), on_sphere(c, i, j + 1u, n));
                if (i + j + 1u == n) continue;
                triangle(d, on_sphere(c, i + 1u, j, n), on_sphere(c, i + 1u, j + 1u, n),
                         on_sphere(c, i, j + 1u, n));
            }
        }
    }
}

/* A coordinate of a grid of n cells from -1 to 1. */
static float step_of(uint32_t i, uint32_t n) { return (float)(2.0 * i / n - 1.0); }

static nook_point on_box(uint32_t axis, float side, float u, float v) {
    if (axis == 0) return nook_make(side, u, v);
    return axis == 1u ? nook_make(v, side, u) : nook_make(u, v, side);
}

static void draw_box(drawing *d, uint32_t n, uint32_t b) {
    uint32_t axis, i, j;
    (void)b;
    for (axis = 0; axis < 3u; axis++) {
        for (i = 0; i < n; i++) {
            for (j = 0; j < n; j++) {
                float u = step_of(i, n), w = step_of(i + 1u, n), x = step_of(j, n), y = step_of(j + 1u, n);
                quad(d, on_box(axis, 1, u, x), on_box(axis, 1, w, x), on_box(axis, 1, w, y),
                     on_box(axis, 1, u, y));
                quad(d, on_box(axis, -1, u, x), on_box(axis, -1, u, y), on_box(axis, -1, w, y),
                     on_box(axis, -1, w, x));
            }
        }
    }
}

static nook_point on_torus(uint32_t i, uint32_t a, uint32_t j, uint32_t b) {
    direction around = direction_of(i, a), across = direction_of(j, b);
    float r = 1.0f + 0.4f * across.x;
    return nook_make(r * around.x, r * around.y, 0.4f * across.y);
}

static void draw_torus(drawing *d, uint32_t a, uint32_t b) {
    uint32_t i, j;
    for (i = 0; i < a; i++) {
        for (j = 0; j < b; j++) {
            quad(d, on_torus(i, a, j, b), on_torus(i + 1u, a, j, b), on_torus(i + 1u, a, j + 1u, b),
                 on_torus(i, a, j + 1u, b));
        }
    }
}

/* Ring k of a capsule: 0 is the lower pole, b and b + 1 the two rims of the cylinder, 2 b + 1 the
 * upper pole. */
static nook_point on_capsule(uint32_t i, uint32_t a, uint32_t k, uint32_t b) {
    direction around = direction_of(i, a), up = direction_of(k <= b ? b - k : k - b - 1u, 4u * b);
    return nook_make(up.x * around.x, up.x * around.y, k <= b ? -1.0f - up.y : 1.0f + up.y);
}

static void draw_capsule(drawing *d, uint32_t a, uint32_t b) {
    uint32_t i, k;
    for (i = 0; i < a; i++) {
        triangle(d, on_capsule(0, a, 0, b), on_capsule(i + 1u, a, 1, b), on_capsule(i, a, 1, b));
        for (k = 1; k < 2u * b; k++) {
            quad(d, on_capsule(i, a, k, b), on_capsule(i + 1u, a, k, b), on_capsule(i + 1u, a, k + 1u, b),
                 on_capsule(i, a, k + 1u, b));
        }
        triangle(d, on_capsule(i, a, k, b), on_capsule(i + 1u, a, k, b), on_capsule(0, a, k + 1u, b));
    }
}

/* A tube with n points around and b cells along; teeth make the outside a gear's. */
typedef struct tube {
    uint32_t n, b;
    bool teeth;
} tube;

static nook_point on_tube(const tube *t, uint32_t i, uint32_t k, bool inside) {
    direction around = direction_of(i, t->n);
    float r = inside ? 0.5f : t->teeth && i % 4u >= 2u ? 1.25f : 1.0f;
    return nook_make(r * around.x, r * around.y, (t->teeth ? 0.25f : 1.0f) * step_of(k, t->b));
}

/* The wall between columns i and j; seen from the other side when they are exchanged. */
static void draw_wall(drawing *d, const tube *t, uint32_t i, uint32_t j, bool inside) {
    uint32_t k;
    for (k = 0; k < t->b; k++) {
        quad(d, on_tube(t, i, k, inside), on_tube(t, j, k, inside), on_tube(t, j, k + 1u, inside),
             on_tube(t, i, k + 1u, inside));
    }
}

/* The end at level k between columns i and j. */
static void draw_end(drawing *d, const tube *t, uint32_t i, uint32_t j, uint32_t k) {
    quad(d, on_tube(t, i, k, true), on_tube(t, i, k, false), on_tube(t, j, k, false), on_tube(t, j, k, true));
}

static void draw_tube(drawing *d, const tube *t) {
    uint32_t i, j;
    for (i = 0; i < t->n; i++) {
        j = i + 1u == t->n ? 0 : i + 1u;
        draw_wall(d, t, i, j, false);
        draw_wall(d, t, j, i, true);
        draw_end(d, t, i, j, t->b);
        draw_end(d, t, j, i, 0);
    }
}

static void draw_pipe(drawing *d, uint32_t a, uint32_t b) {
    tube t = {0, 0, false};
    t.n = a;
    t.b = b;
    draw_tube(d, &t);
}

static void draw_gear(drawing *d, uint32_t a, uint32_t b) {
    tube t = {0, 0, true};
    t.n = 4u * a;
    t.b = b;
    draw_tube(d, &t);
}

static nook_point on_sheet(uint32_t i, uint32_t a, uint32_t j, uint32_t b) {
    return nook_make(step_of(i, a), step_of(j, b), 0);
}

static void draw_sheet(drawing *d, uint32_t a, uint32_t b) {
    uint32_t i, j;
    for (i = 0; i < a; i++) {
        for (j = 0; j < b; j++) {
            quad(d, on_sheet(i, a, j, b), on_sheet(i + 1u, a, j, b), on_sheet(i + 1u, a, j + 1u, b),
                 on_sheet(i, a, j + 1u, b));
        }
    }
}

/* A band that makes half a turn on its way round: at the end, row j meets row b - j. */
static nook_point on_moebius(uint32_t i, uint32_t a, uint32_t j, uint32_t b) {
    direction around, half;
    float across, r;
    if (i == a) {
        i = 0;
        j = b - j;
    }
    around = direction_of(i, a);
    half = direction_of(i, 2u * a);
    across = 0.4f * step_of(j, b);
    r = 1.0f + across * half.x;
    return nook_make(r * around.x, r * around.y, across * half.y);
}

static void draw_moebius(drawing *d, uint32_t a, uint32_t b) {
    uint32_t i, j;
    for (i = 0; i < a; i++) {
        for (j = 0; j < b; j++) {
            quad(d, on_moebius(i, a, j, b), on_moebius(i + 1u, a, j, b), on_moebius(i + 1u, a, j + 1u, b),
                 on_moebius(i, a, j + 1u, b));
        }
    }
}

/* ---- the list ---------------------------------------------------------------------------------- */

/* ab a b + a a + nn a^2 + one triangles; b stays 1 where ab is 0. */
typedef struct shape {
    const char *name;
    void (*draw)(drawing *d, uint32_t a, uint32_t b);
    uint32_t ab, a, nn, one;
    uint32_t least_a, least_b;
    uint32_t aspect; /* the a wanted for each b */
} shape;

static const shape shapes[] = {
    {"tetrahedron", draw_tetrahedron, 0, 0, 0, 4, 1, 1, 1},
    {"icosphere", draw_icosphere, 0, 0, 20, 0, 1, 1, 1},
    {"box", draw_box, 0, 0, 12, 0, 1, 1, 1},
    {"torus", draw_torus, 2, 0, 0, 0, 3, 3, 2},
    {"capsule", draw_capsule, 4, 0, 0, 0, 3, 1, 4},
    {"pipe", draw_pipe, 4, 4, 0, 0, 3, 1, 4},
    {"gear", draw_gear, 16, 16, 0, 0, 3, 1, 12},
    {"sheet", draw_sheet, 2, 0, 0, 0, 1, 1, 1},
    {"moebius", draw_moebius, 2, 0, 0, 0, 5, 1, 10},
};

const char shape_names[] = "tetrahedron icosphere box torus capsule pipe gear sheet moebius";

static uint64_t triangles_of(const shape *s, uint64_t a, uint64_t b) {
    return s->ab * a * b + s->a * a + s->nn * a * a + s->one;
}

static uint64_t apart(uint64_t x, uint64_t y) { return x < y ? y - x : x - y; }

/* Of all grids at most twice as long or as wide as the shape wants, the one nearest in triangles;
 * among equals the best proportioned. */
static void choose_grid(const shape *s, uint64_t wanted, uint32_t *best_a, uint32_t *best_b) {
    uint64_t best = UINT64_MAX, best_shape = UINT64_MAX, a, b;
    *best_a = s->least_a;
    *best_b = s->least_b;
    for (b = s->least_b; b == s->least_b || triangles_of(s, s->least_a, b) <= 2 * wanted; b++) {
        for (a = s->least_a; a <= 2 * s->aspect * b || s->ab == 0; a++) {
            uint64_t n = triangles_of(s, a, b), off = apart(n, wanted), uneven = apart(a, s->aspect * b);
            bool proportioned = s->ab == 0 || 2 * a >= s->aspect * b || a == s->least_a;
            if (n <= SHAPE_MOST && proportioned && (off < best || (off == best && uneven < best_shape))) {
                best = off;
                best_shape = uneven;
                *best_a = (uint32_t)a;
                *best_b = (uint32_t)b;
            }
            if (n > 2 * wanted || s->one != 0) break;
        }
        if (s->ab == 0) break;
    }
}

/* Join equal points by the library's weld. */
static void join(drawing *d) {
    nook_mesh mesh;
    nook_where where;
    nook_index *V = take(3 * (size_t)d->nt, sizeof *V), *O = take(3 * (size_t)d->nt, sizeof *O),
               *C = take(d->nv, sizeof *C);
    nook_index *map = take(d->nv, sizeof *map), *order = take(NOOK_WELD_SCRATCH(d->nv), sizeof *order);
    uint32_t i;
    for (i = 0; i < 3u * d->nt; i++) V[i] = nook_store(d->V[i]);
    if (nook_mesh_init(&mesh, d->G, V, O, C, d->nv, d->nt) == NOOK_OK) {
        mesh.nv = d->nv;
        mesh.nt = d->nt;
        (void)nook_weld(&mesh, map, order, &where);
        d->nv = mesh.nv;
        for (i = 0; i < 3u * d->nt; i++) d->V[i] = V[i];
    }
    free(V);
    free(O);
    free(C);
    free(map);
    free(order);
}

bool draw_shape(drawing *d, const char *name, uint32_t triangles) {
    uint32_t a, b;
    size_t i;
    memset(d, 0, sizeof *d);
    for (i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
        if (strcmp(name, shapes[i].name) != 0) continue;
        choose_grid(&shapes[i], triangles < SHAPE_MOST ? triangles : SHAPE_MOST, &a, &b);
        shapes[i].draw(d, a, b);
        join(d);
        return true;
    }
    return false;
}
