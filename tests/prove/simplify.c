/* simplify.c -- every collapse of many simplifications, held against what doubles say of the mesh before it.
 *
 * The mesh is stepped unit by unit. Of each collapse: the place costs least, of those around it, by the sum of squared
 * volumes and areas written down anew; no triangle that stays has turned over; nothing else has moved. Of each result: edges are
 * run once each way or are of the border, O says which; Euler's number and borders are as before; no place on either surface, of a fine
 * raster, is farther from the other than deviation says; what was inside is inside, by the sum of solid angles. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "nook.h"
#include "prove.h"

enum { MOST_T = 600, MOST_V = 400 };

typedef struct vector {
    double x, y, z;
} vector;

static nook_mesh mesh, before, first;
static float deviation[MOST_V];
static nook_simplify_goal goal;
static uint32_t collapses, kept, gone, name[MOST_T];
static double tightest, loosest;

static vector of(nook_point p) {
    vector v = {(double)p.x, (double)p.y, (double)p.z};
    return v;
}
static vector sum(vector a, vector b, double s) {
    vector c = {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
    return c;
}
static vector less(vector a, vector b) { return sum(a, b, -1); }
static double dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vector across(vector a, vector b) {
    vector n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return n;
}
static vector at(const nook_mesh *m, uint32_t c) { return of(m->G[m->V[c]]); }
static vector normal(const nook_mesh *m, uint32_t t) {
    vector a = at(m, 3 * t);
    return across(less(at(m, 3 * t + 1), a), less(at(m, 3 * t + 2), a));
}

static void make_room(nook_mesh *m) {
    CHECK_EQUAL(nook_mesh_init(m, fenced(MOST_V * sizeof(nook_point)),
                               fenced(3 * MOST_T * sizeof(nook_index)),
                               fenced(3 * MOST_T * sizeof(nook_index)), fenced(MOST_V * sizeof(nook_index)),
                               MOST_V, MOST_T),
                NOOK_OK);
}

static void copy(nook_mesh *to, const nook_mesh *from) {
    to->nv = from->nv, to->nt = from->nt;
    memcpy(to->G, from->G, from->nv * sizeof *to->G);
    memcpy(to->V, from->V, 3 * from->nt * sizeof *to->V);
    memcpy(to->O, from->O, 3 * from->nt * sizeof *to->O);
    memcpy(to->C, from->C, from->nv * sizeof *to->C);
}

/* ---- meshes: sheets, tubes, tori, and spheres as tubes with caps, bent by lot ------------------------------ */

static double lot(dice *d) { return (double)throw_dice(d, 100001) / 50000 - 1; }

static void triangle(uint32_t a, uint32_t b, uint32_t c) {
    nook_index *V = mesh.V + 3 * mesh.nt++;
    V[0] = nook_store(a), V[1] = nook_store(b), V[2] = nook_store(c);
}

static void make_mesh(dice *d, uint32_t kind) {
    uint32_t n = 5 + throw_dice(d, 10), m = 4 + throw_dice(d, 12), wide = kind == 0 ? n + 1 : n,
             high = kind == 2 ? m : m + 1, i, j;
    double bumps = 0.1 * (double)throw_dice(d, 4), phase = lot(d);
    nook_report report;
    mesh.nt = 0;
    mesh.nv = wide * high;
    for (i = 0; i < wide * high; i++) {
        double u = 6.283185307 * (i % wide) / n, v = 6.283185307 * (double)(i / wide) / m;
        double r = kind == 2   ? 2 + cos(v)
                   : kind == 3 ? sin(0.05 + v * 0.45)
                               : 1,
               x = r * cos(u), y = r * sin(u);
        double z = kind == 2 ? sin(v) : kind == 3 ? -cos(0.05 + v * 0.45) : v * 0.5;
        if (kind == 0) x = u, y = v, z = 0.3 * sin(u + phase) * cos(1.5 * v);
        r = 1 + bumps * 0.2 * lot(d) + bumps * sin(3 * x + phase) * sin(2 * y) * cos(4 * z);
        mesh.G[i] = nook_make((float)(x * r), (float)(y * r), (float)(z * r));
    }
    for (j = 0; j < m; j++) {
        for (i = 0; i < n; i++) {
            uint32_t a = j * wide + i, b = j * wide + (i + 1) % wide, c = (j + 1) % high * wide + i,
                     e = (j + 1) % high * wide + (i + 1) % wide;
            if (throw_dice(d, 2) != 0) {
                triangle(a, b, e), triangle(a, e, c);
            } else {
                triangle(a, b, c), triangle(b, e, c);
            }
        }
    }
    if (kind == 3) {
        mesh.G[mesh.nv] = nook_make(0, 0, -1.0f), mesh.G[mesh.nv + 1] = nook_make(0, 0, 1.2f);
        for (i = 0; i < n; i++)
            triangle(mesh.nv, (i + 1) % n, i), triangle(mesh.nv + 1, m * n + i, m * n + (i + 1) % n);
        mesh.nv += 2;
    }
    if (mesh.nt > MOST_T || mesh.nv > MOST_V) CHECK(false);
    CHECK_EQUAL(nook_link(&mesh, NULL, NULL, NULL, &report, NULL), NOOK_OK);
}

/* ---- one collapse ------------------------------------------------------------------------------------------- */

static void hear(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    (void)user;
    if (kind == NOOK_AT_VERTEX) gone = to;
    if (kind == NOOK_AT_TRIANGLE) name[to] = name[from];
}
static const nook_edit listening = {.renamed = hear};

static bool same(nook_point p, nook_point q) { return memcmp(&p, &q, sizeof p) == 0; }

static double square(double x) { return x * x; }

/* 1 over the area of a triangle, twice, as nearly as nook_simplify has it: a thirtieth off. */
static double by_area(vector normal) {
    return nook_float_from(0x5F3759DFu - (nook_float_bits((float)dot(normal, normal)) >> 1));
}

/* What it costs to put both ends at x. */
static double cost(vector x) {
    double all = 0;
    uint32_t c;
    for (c = 0; c < 3 * before.nt; c++) {
        uint32_t v = before.V[nook_next(c)], w = before.V[nook_prev(c)];
        vector p = of(before.G[v]), q = of(before.G[w]);
        bool touches = v == kept || v == gone || w == kept || w == gone;
        if (c % 3 == 0 && (touches || before.V[c] == kept || before.V[c] == gone))
            all += square(dot(normal(&before, c / 3), less(x, p))) * by_area(normal(&before, c / 3));
        if (before.O[c] == c && touches) {
            vector n = across(less(x, p), less(q, p));
            all += dot(n, n) * ((v == kept || v == gone) && (w == kept || w == gone) ? 2 : 1);
        }
    }
    return all;
}

static void costs_least(vector x) {
    vector edge = less(of(before.G[kept]), of(before.G[gone])), step = {0, 0, 0};
    double length = sqrt(dot(edge, edge)), least = cost(x), lower = least, scale = 0;
    uint32_t i;
    for (i = 0; i < 6; i++) {
        double more;
        step.x = i / 2 == 0 ? 1 : 0, step.y = i / 2 == 1 ? 1 : 0, step.z = i / 2 == 2 ? 1 : 0;
        more = cost(sum(x, step, (i % 2 == 0 ? 0.05 : -0.05) * length));
        if (more > scale) scale = more;
        if (more < lower) lower = more;
    }
    /* 2^-15 of a sphere, which every quadric has besides, is as much as 2^-9 of what a twentieth of the edge costs. */
    if (least > lower + 1e-4 * cost(of(before.G[kept])) + 0x1p-9 * scale + 1e-9) CHECK(false);
}

static void nothing_turns(void) {
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) {
        vector n = normal(&mesh, t), o = normal(&before, name[t]);
        if (dot(n, o) < -1e-7 * sqrt(dot(n, n) * dot(o, o))) CHECK(false);
    }
}

static void see_collapse(void) {
    uint32_t v, last = before.nv - 1, moved = 0;
    if (gone == NOOK_NONE) gone = last;
    for (v = 0; v < mesh.nv; v++) {
        uint32_t was = v == gone ? last : v;
        if (!same(mesh.G[v], before.G[was])) kept = was, moved++;
    }
    if (moved > 1 || before.nv != mesh.nv + 1) CHECK(false);
    if (before.nt - mesh.nt != 1 && before.nt - mesh.nt != 2) CHECK(false);
    if (moved == 1 && !goal.outside) costs_least(of(mesh.G[kept == last ? gone : kept]));
    nothing_turns();
    collapses++;
}

/* ---- results -------------------------------------------------------------------------------------------------- */

static int32_t euler_of(const nook_mesh *m, uint32_t *borders) {
    uint32_t c, d, edges = 0, used = 0, v;
    *borders = 0;
    for (c = 0; c < 3 * m->nt; c++) {
        uint32_t there = NOOK_NONE;
        for (d = 0; d < 3 * m->nt; d++) {
            if (m->V[nook_next(c)] == m->V[nook_prev(d)] && m->V[nook_prev(c)] == m->V[nook_next(d)])
                there = d;
            if (c != d && m->V[nook_next(c)] == m->V[nook_next(d)] &&
                m->V[nook_prev(c)] == m->V[nook_prev(d)])
                CHECK(false);
        }
        if (m->O[c] != (there == NOOK_NONE ? c : there)) CHECK(false);
        edges += there == NOOK_NONE || c < there;
        *borders += there == NOOK_NONE;
    }
    for (v = 0; v < m->nv; v++) {
        if (m->C[v] >= 3 * m->nt || m->V[m->C[v]] != v) CHECK(false);
        used++;
    }
    return (int32_t)used - (int32_t)edges + (int32_t)m->nt;
}

static double clamp(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

static double from_segment(vector p, vector a, vector b) {
    vector d = less(b, a), q;
    double l = dot(d, d);
    q = less(p, sum(a, d, l > 0 ? clamp(dot(less(p, a), d) / l) : 0));
    return dot(q, q);
}

static double from_surface(const nook_mesh *m, vector p) {
    double least = 1e30, d;
    uint32_t t, i;
    for (t = 0; t < m->nt; t++) {
        vector a[3], n = normal(m, t);
        double l = dot(n, n);
        bool within = l > 0;
        for (i = 0; i < 3; i++) a[i] = at(m, 3 * t + i);
        for (i = 0; i < 3; i++) {
            d = from_segment(p, a[i], a[(i + 1) % 3]);
            if (d < least) least = d;
            if (dot(across(less(a[(i + 1) % 3], a[i]), less(p, a[i])), n) < 0) within = false;
        }
        d = dot(less(p, a[0]), n);
        if (within && d * d / l < least) least = d * d / l;
    }
    return sqrt(least);
}

static double farthest(const nook_mesh *from, const nook_mesh *to, uint32_t raster) {
    double most = 0, d;
    uint32_t t, i, j;
    for (t = 0; t < from->nt; t++) {
        vector a = at(from, 3 * t), b = less(at(from, 3 * t + 1), a), c = less(at(from, 3 * t + 2), a);
        for (i = 0; i <= raster; i++) {
            for (j = 0; i + j <= raster; j++) {
                d = from_surface(to, sum(sum(a, b, (double)i / raster), c, (double)j / raster));
                if (d > most) most = d;
            }
        }
    }
    return most;
}

static double winding(const nook_mesh *m, vector p) {
    double all = 0;
    uint32_t t;
    for (t = 0; t < m->nt; t++) {
        vector a = less(at(m, 3 * t), p), b = less(at(m, 3 * t + 1), p), c = less(at(m, 3 * t + 2), p);
        double x = sqrt(dot(a, a)), y = sqrt(dot(b, b)), z = sqrt(dot(c, c));
        all += atan2(dot(a, across(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
    }
    return all / 6.283185307179586;
}

static void nothing_is_outside(void) {
    uint32_t v;
    for (v = 0; v < first.nv; v++) {
        vector p = of(first.G[v]);
        if (from_surface(&mesh, p) > 1e-6 && winding(&mesh, p) < 0.5) CHECK(false);
    }
}

static void deviates_no_more(void) {
    double most = 0, way, other;
    uint32_t v;
    for (v = 0; v < mesh.nv; v++) {
        if ((double)deviation[v] > most) most = (double)deviation[v];
    }
    if (most > (double)goal.error) CHECK(false);
    way = farthest(&first, &mesh, 3);
    other = farthest(&mesh, &first, 6);
    if (other > way) way = other;
    if (way > most + 1e-9) CHECK(false);
    if (most > 0 && way / most > tightest) tightest = way / most;
    if (most > 0) loosest += way / most;
}

static void simplify(dice *d, uint32_t kind) {
    nook_simplify_state state;
    nook_status status;
    uint32_t borders, left, t, n;
    int32_t euler;
    make_mesh(d, kind);
    copy(&first, &mesh);
    n = mesh.nt;
    euler = euler_of(&mesh, &borders);
    memset(&goal, 0, sizeof goal);
    memset(deviation, 0, sizeof deviation);
    goal.deviation = deviation;
    goal.error = throw_dice(d, 3) == 0 ? 1e30f : 0.01f * (float)(1 + throw_dice(d, 20));
    goal.triangles = throw_dice(d, 2) == 0 ? 0 : 4 + throw_dice(d, n / 2);
    goal.outside = kind >= 2 && throw_dice(d, 2) == 0;
    CHECK_EQUAL(nook_simplify_begin(&state, &mesh, &goal, &listening), NOOK_OK);
    do {
        uint32_t unit = 1;
        copy(&before, &mesh);
        for (t = 0; t < before.nt; t++) name[t] = t;
        gone = NOOK_NONE;
        status = nook_simplify_step(&state, &unit);
        if (mesh.nt != before.nt) see_collapse();
    } while (status == NOOK_MORE && !test_has_failed());
    if (status == NOOK_OK && goal.triangles != 0 &&
        (mesh.nt > goal.triangles || mesh.nt + 1 < goal.triangles))
        CHECK(false);
    CHECK_EQUAL(euler_of(&mesh, &left), euler);
    CHECK((left == 0) == (borders == 0));
    deviates_no_more();
    if (goal.outside) nothing_is_outside();
}

static void collapses_are_the_best_and_results_within_what_was_asked(void) {
    dice d = {1};
    uint32_t i, start = milliseconds(), meshes = 240;
    char text[80];
    make_room(&mesh);
    make_room(&before);
    make_room(&first);
    for (i = 0; i < meshes && !test_has_failed(); i++) simplify(&d, i % 4);
    CHECK(fences_hold());
    CHECK(collapses > 10000);
    CHECK(tightest > 0.5);
    (void)snprintf(text, sizeof text, "distances %.2f of what deviation says, %.2f at most", loosest / meshes,
                   tightest);
    print_figure("collapses", collapses, text, start);
    drop_fences();
}

static const test tests[] = {
    TEST(collapses_are_the_best_and_results_within_what_was_asked),
};

int main(void) {
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
