/* spoil.c -- one defect put into a sound drawing, so that every answer of check can be tried. */
#include "shapes.h"

#include <stdlib.h>

#include "heap.h"

const char defect_names[] =
    "hole flipped inside-out duplicate nonmanifold-edge bow-tie crossing isolated degenerate"
    " zero-area unwelded nan";

static void flip(drawing *d, uint32_t t) {
    uint32_t *corner = &d->V[3 * (size_t)t], v = corner[1];
    corner[1] = corner[2];
    corner[2] = v;
}

static void hole(drawing *d) { d->nt--; }

static void flipped(drawing *d) { flip(d, d->nt / 2u); }

static void inside_out(drawing *d) {
    uint32_t t;
    for (t = 0; t < d->nt; t++) flip(d, t);
}

static void duplicate(drawing *d) { drawing_triangle(d, d->V[0], d->V[1], d->V[2]); }

static uint32_t triangles_on(const drawing *d, uint32_t v, uint32_t w) {
    uint32_t i, n = 0;
    for (i = 0; i < 3u * d->nt; i += 3u) {
        const uint32_t *t = d->V + i;
        n += (t[0] == v || t[1] == v || t[2] == v) && (t[0] == w || t[1] == w || t[2] == w);
    }
    return n;
}

/* A third triangle on an edge, standing off the surface like a fin; on a rim two, back to back. */
static void nonmanifold_edge(drawing *d) {
    bool rim = triangles_on(d, d->V[0], d->V[1]) == 1u;
    nook_point a = d->G[d->V[0]], b = d->G[d->V[1]], c = d->G[d->V[2]];
    nook_point normal = nook_cross(nook_sub(b, a), nook_sub(c, a));
    float size = nook_length(nook_sub(b, a)), length = nook_length(normal);
    nook_point tip = nook_scaled(normal, length > 0 ? size / length : 0);
    uint32_t v = drawing_vertex(d, nook_make(a.x + tip.x, a.y + tip.y, a.z + tip.z));
    drawing_triangle(d, d->V[0], d->V[1], v);
    if (rim) drawing_triangle(d, d->V[1], d->V[0], v);
}

/* The only vertex that lies furthest in a direction along which no shape here has a flat side. */
static uint32_t extreme(const drawing *d) {
    nook_point along = nook_make(1.0f, 0.3711f, 0.1137f);
    uint32_t v, best = 0;
    for (v = 1; v < d->nv; v++) {
        if (nook_dot(along, d->G[v]) > nook_dot(along, d->G[best])) best = v;
    }
    return best;
}

/* A second copy, mirrored through an extreme vertex, which both then share and nothing else. */
static void bow_tie(drawing *d) {
    uint32_t centre = extreme(d), v, i, nv = d->nv, nt = d->nt;
    nook_point c = d->G[centre], p;
    uint32_t *copy = take(nv, sizeof *copy);
    for (v = 0; v < nv; v++) {
        p = d->G[v];
        copy[v] = v == centre
                      ? v
                      : drawing_vertex(d, nook_make(c.x + (c.x - p.x), c.y + (c.y - p.y), c.z + (c.z - p.z)));
    }
    for (i = 0; i < 3u * nt; i += 3u)
        drawing_triangle(d, copy[d->V[i]], copy[d->V[i + 2u]], copy[d->V[i + 1u]]);
    free(copy);
}

/* A second copy, moved so that the two run through each other. */
static void crossing(drawing *d) {
    uint32_t v, i, nv = d->nv, nt = d->nt;
    for (v = 0; v < nv; v++)
        (void)drawing_vertex(d, nook_make(d->G[v].x + 0.31f, d->G[v].y + 0.17f, d->G[v].z + 0.07f));
    for (i = 0; i < 3u * nt; i += 3u) drawing_triangle(d, d->V[i] + nv, d->V[i + 1u] + nv, d->V[i + 2u] + nv);
}

static void isolated(drawing *d) { (void)drawing_vertex(d, nook_make(3, 3, 3)); }

static void degenerate(drawing *d) { drawing_triangle(d, d->V[0], d->V[1], d->V[1]); }

/* The nearest multiple of 2^-12, so that the middle of two such is a float. */
static float on_grid(float x) { return (float)(int32_t)(x * 4096.0f) / 4096.0f; }

/* A vertex on the middle of an edge: its first triangle is cut there, and a triangle without area closes the gap to
 * the other. */
static void zero_area(drawing *d) {
    uint32_t a = d->V[0], b = d->V[1], c = d->V[2], i, m;
    for (i = 0; i < 2u; i++) {
        nook_point *p = &d->G[i == 0 ? a : b];
        *p = nook_make(on_grid(p->x), on_grid(p->y), on_grid(p->z));
    }
    m = drawing_vertex(
        d, nook_scaled(nook_make(d->G[a].x + d->G[b].x, d->G[a].y + d->G[b].y, d->G[a].z + d->G[b].z), 0.5f));
    d->V[1] = m;
    drawing_triangle(d, m, b, c);
    drawing_triangle(d, a, b, m);
}

static void unwelded(drawing *d) {
    uint32_t i, nt = d->nt, nv = d->nv;
    for (i = 0; i < 3u * nt; i++) d->V[i] = drawing_vertex(d, d->G[d->V[i]]) - nv;
    memmove(d->G, d->G + nv, 3 * (size_t)nt * sizeof *d->G);
    d->nv = 3u * nt;
}

static void not_a_number(drawing *d) { d->G[d->V[0]].y = nook_float_from(0x7FC00000u); }

static const struct {
    const char *name;
    void (*spoil)(drawing *d);
} defects[] = {
    {"hole", hole},
    {"flipped", flipped},
    {"inside-out", inside_out},
    {"duplicate", duplicate},
    {"nonmanifold-edge", nonmanifold_edge},
    {"bow-tie", bow_tie},
    {"crossing", crossing},
    {"isolated", isolated},
    {"degenerate", degenerate},
    {"zero-area", zero_area},
    {"unwelded", unwelded},
    {"nan", not_a_number},
};

bool spoil(drawing *d, const char *name) {
    size_t i;
    for (i = 0; i < sizeof defects / sizeof defects[0]; i++) {
        if (strcmp(name, defects[i].name) != 0) continue;
        defects[i].spoil(d);
        return true;
    }
    return false;
}
