/* query_shapes.c -- the meshes of query_bench: rings of points joined by bands, and triangle soups welded. */
#include "query_bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static void *room(size_t count, size_t size) {
    void *p = calloc(count + 1u, size);
    if (p == NULL) abort();
    return p;
}

static void shape_room(shape *s, uint32_t nv, uint32_t nt) {
    s->G = room(nv + 1u, sizeof *s->G);
    s->V = room(3u * (size_t)nt, sizeof *s->V);
}

static void point(shape *s, double x, double y, double z) {
    const spot p = {(float)x, (float)y, (float)z};
    s->G[s->nv++] = p;
}

static void triangle(shape *s, uint32_t a, uint32_t b, uint32_t c) {
    uint32_t *v = s->V + 3u * s->nt++;
    v[0] = a;
    v[1] = b;
    v[2] = c;
}

/* Quads between two rings of n points, from a to b and then along the rings counter-clockwise. */
static void band(shape *s, uint32_t a, uint32_t b, uint32_t n) {
    for (uint32_t j = 0; j < n; j++) {
        const uint32_t k = (j + 1u) % n;
        triangle(s, a + j, b + j, b + k);
        triangle(s, a + j, b + k, a + k);
    }
}

/* The nv points that are there are rings of n, of which the last is joined with the first. */
static void torus(shape *s, uint32_t n) {
    for (uint32_t a = 0; a < s->nv; a += n) band(s, a, (a + n) % s->nv, n);
}

/* A hollow pipe bent by 120 degrees: there outside, back inside. 4 n (m + 1) triangles. */
static void pipe(shape *s, uint32_t n, uint32_t m) {
    shape_room(s, 2u * n * (m + 1u), 4u * n * (m + 1u));
    for (uint32_t k = 0; k < 2u * (m + 1u); k++) {
        const uint32_t ring = k <= m ? k : 2u * m + 1u - k;
        const double turn = 2 * PI / 3 * ring / m, r = k <= m ? 0.06 : 0.05;
        for (uint32_t j = 0; j < n; j++) {
            const double a = 2 * PI * j / n, x = 0.3 + r * cos(a);
            point(s, x * cos(turn), x * sin(turn), r * sin(a));
        }
    }
    torus(s, n);
}

/* A gear with a bore, four points a tooth: long thin triangles, many in one plane. 32 triangles a tooth. */
static void gear(shape *s, uint32_t teeth) {
    static const double radius[4] = {0.1, 0.1, 0.095, 0.095};
    const uint32_t n = 4u * teeth;
    shape_room(s, 4u * n, 8u * n);
    for (uint32_t k = 0; k < 4u; k++)
        for (uint32_t j = 0; j < n; j++) {
            const double r = k < 2u ? radius[j % 4u] : 0.03, a = 2 * PI * j / n;
            point(s, r * cos(a), r * sin(a), k == 0 || k == 3u ? 0.02 : 0);
        }
    torus(s, n);
}

/* A tube along a trefoil knot; a thick one cuts itself. 2 n m triangles. */
static void knot(shape *s, uint32_t n, uint32_t m, double r) {
    shape_room(s, n * m, 2u * n * m);
    for (uint32_t k = 0; k < m; k++) {
        const double t = 2 * PI * k / m;
        const double c[3] = {sin(t) + 2 * sin(2 * t), cos(t) - 2 * cos(2 * t), -sin(3 * t)};
        const double d[3] = {cos(t) + 4 * cos(2 * t), -sin(t) + 4 * sin(2 * t), -3 * cos(3 * t)};
        const double e[3] = {-sin(t) - 8 * sin(2 * t), -cos(t) + 8 * cos(2 * t), 9 * sin(3 * t)};
        double b[3], o[3], lb = 0, lo = 0;
        for (int i = 0; i < 3; i++) b[i] = d[(i + 1) % 3] * e[(i + 2) % 3] - d[(i + 2) % 3] * e[(i + 1) % 3];
        for (int i = 0; i < 3; i++) o[i] = b[(i + 1) % 3] * d[(i + 2) % 3] - b[(i + 2) % 3] * d[(i + 1) % 3];
        for (int i = 0; i < 3; i++) {
            lb += b[i] * b[i];
            lo += o[i] * o[i];
        }
        for (uint32_t j = 0; j < n; j++) {
            const double u = r * cos(2 * PI * j / n) / sqrt(lb), v = r * sin(2 * PI * j / n) / sqrt(lo);
            point(s, c[0] + u * b[0] + v * o[0], c[1] + u * b[1] + v * o[1], c[2] + u * b[2] + v * o[2]);
        }
    }
    torus(s, n);
}

/* A capsule of 2 m rings along x, of 4 n m triangles. */
static void capsule(shape *s, uint32_t n, uint32_t m) {
    const uint32_t cap = m / 2u, rings = 2u * m;
    shape_room(s, n * rings + 2u, 2u * n * rings);
    for (uint32_t k = 0; k < rings; k++) {
        double x, r = 0.05;
        if (k < cap || k >= rings - cap) {
            const double a = PI / 2 * (k < cap ? k + 1u : rings - k) / (cap + 1u);
            x = (k < cap ? -0.05 * cos(a) : 0.2 + 0.05 * cos(a));
            r *= sin(a);
        } else {
            x = 0.2 * (k - cap) / (rings - 2u * cap - 1u);
        }
        for (uint32_t j = 0; j < n; j++) point(s, x, r * cos(2 * PI * j / n), -r * sin(2 * PI * j / n));
    }
    point(s, -0.05, 0, 0);
    point(s, 0.25, 0, 0);
    for (uint32_t a = 0; a + n < n * rings; a += n) band(s, a, a + n, n);
    for (uint32_t j = 0; j < n; j++) {
        const uint32_t k = (j + 1u) % n, last = n * (rings - 1u);
        triangle(s, n * rings, j, k);
        triangle(s, n * rings + 1u, last + k, last + j);
    }
}

/* ---- soups ------------------------------------------------------------------------------------------- */
typedef struct corner {
    spot p;
    uint32_t c;
} corner;

static int by_point(const void *a, const void *b) {
    const spot *p = &((const corner *)a)->p, *q = &((const corner *)b)->p;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    if (p->y != q->y) return p->y < q->y ? -1 : 1;
    return p->z < q->z ? -1 : p->z > q->z;
}

static void weld(shape *s, const spot *soup, uint32_t nt) {
    corner *sorted = room(3u * (size_t)nt, sizeof *sorted);
    uint32_t *v = room(3u * (size_t)nt, sizeof *v), i;
    shape_room(s, 3u * nt, nt);
    for (i = 0; i < 3u * nt; i++) {
        sorted[i].p = soup[i];
        sorted[i].c = i;
    }
    qsort(sorted, 3u * (size_t)nt, sizeof *sorted, by_point);
    for (i = 0; i < 3u * nt; i++) {
        if (i == 0 || by_point(&sorted[i - 1u], &sorted[i]) != 0) s->G[s->nv++] = sorted[i].p;
        v[sorted[i].c] = s->nv - 1u;
    }
    for (i = 0; i < 3u * nt; i += 3u)
        if (v[i] != v[i + 1u] && v[i + 1u] != v[i + 2u] && v[i + 2u] != v[i])
            triangle(s, v[i], v[i + 1u], v[i + 2u]);
    free(sorted);
    free(v);
}

static spot between(spot p, spot q) {
    spot m = {p.x + q.x, p.y + q.y, p.z + q.z};
    const float length = sqrtf(m.x * m.x + m.y * m.y + m.z * m.z);
    m.x /= length;
    m.y /= length;
    m.z /= length;
    return m;
}

/* 20 4^levels triangles. */
static void icosphere(shape *s, uint32_t levels) {
    static const float X = 0.525731112f, Z = 0.850650808f;
    static const uint8_t faces[60] = {0,  4, 1, 0, 9, 4, 9, 5,  4, 4, 5,  8,  4,  8, 1, 8,  10, 1,  8, 3,
                                      10, 5, 3, 8, 5, 2, 3, 2,  7, 3, 7,  10, 3,  7, 6, 10, 7,  11, 6, 11,
                                      0,  6, 0, 1, 6, 6, 1, 10, 9, 0, 11, 9,  11, 2, 9, 2,  5,  7,  2, 11};
    const spot at[12] = {{-X, 0, Z}, {X, 0, Z},   {-X, 0, -Z}, {X, 0, -Z}, {0, Z, X},  {0, Z, -X},
                         {0, -Z, X}, {0, -Z, -X}, {Z, X, 0},   {-Z, X, 0}, {Z, -X, 0}, {-Z, -X, 0}};
    const uint32_t nt = 20u << 2u * levels;
    spot *soup = room(3u * (size_t)nt, sizeof *soup);
    uint32_t i, t, n = 20;
    for (i = 0; i < 60; i++) soup[i] = at[faces[i]];
    for (; n < nt; n *= 4u)
        for (t = n; t-- > 0;) {
            const spot a = soup[3u * t], b = soup[3u * t + 1u], c = soup[3u * t + 2u];
            const spot ab = between(a, b), bc = between(b, c), ca = between(c, a);
            const spot four[12] = {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca};
            memcpy(soup + 12u * (size_t)t, four, sizeof four);
        }
    weld(s, soup, nt);
    free(soup);
}

/* The same with bumps; and a sheet of 2 n n triangles with waves and a border. */
static void bumpy(shape *s, uint32_t levels) {
    icosphere(s, levels);
    for (uint32_t v = 0; v < s->nv; v++) {
        spot *p = s->G + v;
        const double r =
            1 + 0.1 * sin(6.0 * (double)p->x) * sin(6.0 * (double)p->y + 1) * sin(6.0 * (double)p->z + 2);
        const spot at = {(float)((double)p->x * r), (float)((double)p->y * r), (float)((double)p->z * r)};
        *p = at;
    }
}

static void sheet(shape *s, uint32_t n) {
    shape_room(s, (n + 1u) * (n + 1u), 2u * n * n);
    for (uint32_t i = 0; i < (n + 1u) * (n + 1u); i++) {
        const double x = 2.0 * (i % (n + 1u)) / n - 1, y = 2.0 * (i / (n + 1u)) / n - 1;
        point(s, x, y, 0.1 * sin(5 * x) * cos(4 * y));
    }
    for (uint32_t i = 0; i < n * (n + 1u); i++) {
        if (i % (n + 1u) == n) continue;
        triangle(s, i, i + 1u, i + n + 2u);
        triangle(s, i, i + n + 2u, i + n + 1u);
    }
}

/* ---- all --------------------------------------------------------------------------------------------- */
typedef struct side {
    uint32_t low, high;
    int direction;
} side;

static int by_side(const void *a, const void *b) {
    const side *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    if (p->high != q->high) return p->high < q->high ? -1 : 1;
    return p->direction - q->direction;
}

static void finish(shape *s) {
    const uint32_t n = 3u * s->nt;
    side *sides = room(n, sizeof *sides);
    for (uint32_t c = 0; c < n; c++) {
        const uint32_t a = s->V[c], b = s->V[c - c % 3u + (c + 1u) % 3u];
        const side one = {a < b ? a : b, a < b ? b : a, a < b ? 1 : -1};
        sides[c] = one;
    }
    qsort(sides, n, sizeof *sides, by_side);
    s->closed = n % 2u == 0;
    for (uint32_t c = 0; c < n && s->closed; c++) {
        const bool same = c % 2u == 1u,
                   next = c > 0 && sides[c].low == sides[c - 1u].low && sides[c].high == sides[c - 1u].high;
        if (same != next || sides[c].direction != (same ? 1 : -1)) s->closed = false;
    }
    free(sides);
    s->low = s->high = s->G[0];
    for (uint32_t v = 0; v < s->nv; v++) {
        const spot p = s->G[v];
        s->low.x = fminf(s->low.x, p.x);
        s->low.y = fminf(s->low.y, p.y);
        s->low.z = fminf(s->low.z, p.z);
        s->high.x = fmaxf(s->high.x, p.x);
        s->high.y = fmaxf(s->high.y, p.y);
        s->high.z = fmaxf(s->high.z, p.z);
    }
    s->size = hypotf(hypotf(s->high.x - s->low.x, s->high.y - s->low.y), s->high.z - s->low.z);
}

bool shape_make(shape *s, const char *name) {
    memset(s, 0, sizeof *s);
    snprintf(s->name, sizeof s->name, "%s", name);
    if (strcmp(name, "pipe1k") == 0)
        pipe(s, 12, 20);
    else if (strcmp(name, "pipe20k") == 0)
        pipe(s, 50, 99);
    else if (strcmp(name, "pipe100k") == 0)
        pipe(s, 112, 222);
    else if (strcmp(name, "gear5k") == 0)
        gear(s, 156);
    else if (strcmp(name, "gear20k") == 0)
        gear(s, 625);
    else if (strcmp(name, "knot20k") == 0)
        knot(s, 20, 500, 0.3);
    else if (strcmp(name, "thick20k") == 0)
        knot(s, 20, 500, 1.1);
    else if (strcmp(name, "capsule20k") == 0)
        capsule(s, 100, 50);
    else if (strcmp(name, "sphere20k") == 0)
        icosphere(s, 5);
    else if (strcmp(name, "bumpy20k") == 0)
        bumpy(s, 5);
    else if (strcmp(name, "sheet20k") == 0)
        sheet(s, 100);
    else
        return false;
    finish(s);
    return true;
}

bool shape_read(shape *s, const char *path) {
    FILE *f = fopen(path, "rb");
    const char *base = strrchr(path, '/');
    unsigned char head[84], facet[50];
    uint32_t nt = 0, t = 0;
    spot *soup;
    memset(s, 0, sizeof *s);
    if (f == NULL) return false;
    if (fread(head, 1, sizeof head, f) == sizeof head) memcpy(&nt, head + 80, sizeof nt);
    if (nt > 10000000u) nt = 0;
    soup = room(3u * (size_t)nt, sizeof *soup);
    while (t < nt && fread(facet, 1, sizeof facet, f) == sizeof facet)
        memcpy(soup + 3u * (size_t)t++, facet + 12, 36);
    fclose(f);
    snprintf(s->name, sizeof s->name, "%.*s", (int)sizeof s->name - 1, base == NULL ? path : base + 1);
    weld(s, soup, t);
    free(soup);
    for (uint32_t v = 0; v < s->nv; v++)
        if (!isfinite(s->G[v].x) || !isfinite(s->G[v].y) || !isfinite(s->G[v].z)) s->nt = 0;
    if (t != nt || s->nt == 0) {
        shape_free(s);
        return false;
    }
    finish(s);
    return true;
}

void shape_free(shape *s) {
    free(s->G);
    free(s->V);
}
