/* solids.c -- generators, in whole numbers; outward is counter-clockwise. */
#include "solids.h"

#include "prove.h"

#include <string.h>

world here;

/* ---- in whole numbers ----------------------------------------------------------------------------- */

typedef struct whole {
    int32_t at[3];
} whole;

static whole P[MOST_NV];
static uint32_t T[MOST_NT][3], nv, nt;
static dice d;

static void begin(void) {
    nv = nt = 0;
    d.state = 4711u;
}

static uint32_t point(int32_t x, int32_t y, int32_t z) {
    P[nv].at[0] = 6 * x;
    P[nv].at[1] = 6 * y;
    P[nv].at[2] = 6 * z;
    return nv++;
}

static void triangle(uint32_t a, uint32_t b, uint32_t c) {
    T[nt][0] = a;
    T[nt][1] = b;
    T[nt++][2] = c;
}

static void square(uint32_t a, uint32_t b, uint32_t c, uint32_t e) {
    triangle(a, b, c);
    triangle(a, c, e);
}

static int32_t rounded(float x) { return x < 0 ? -(int32_t)(0.5f - x) : (int32_t)(x + 0.5f); }

/* From -x -y -z to x y z; inside out if it is a cavity. */
static void add_box(int32_t x, int32_t y, int32_t z, bool cavity) {
    static const uint8_t list[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    uint32_t v, t, first = nv;
    for (v = 0; v < 8; v++) (void)point(v & 1 ? x : -x, v & 2 ? y : -y, v & 4 ? z : -z);
    for (t = 0; t < 12; t++) {
        triangle(first + list[t][0], first + list[t][cavity ? 2 : 1], first + list[t][cavity ? 1 : 2]);
    }
}

static void box(void) { add_box(5000, 3000, 4000, false); }
static void boxes_in_boxes(void) {
    add_box(5000, 5000, 5000, false);
    add_box(4000, 4500, 4900, true);
    add_box(3000, 4400, 800, false);
    add_box(100, 200, 300, true);
}

/* A vertex at a place, found if it is there since first. */
static uint32_t point_at(int32_t x, int32_t y, int32_t z, uint32_t first) {
    uint32_t v;
    for (v = first; v < nv; v++) {
        if (P[v].at[0] == 6 * x && P[v].at[1] == 6 * y && P[v].at[2] == 6 * z) return v;
    }
    return point(x, y, z);
}

static uint32_t onto_sphere(nook_point p, int32_t radius, const int32_t *centre, uint32_t first) {
    float s = (float)radius / nook_length(p);
    return point_at(centre[0] + rounded(p.x * s), centre[1] + rounded(p.y * s), centre[2] + rounded(p.z * s),
                    first);
}

/* Each face of an octahedron in n x n triangles. */
static void add_sphere(int32_t n, int32_t radius, int32_t x, int32_t y, int32_t z) {
    const int32_t centre[3] = {x, y, z};
    uint32_t face, first = nv, k;
    int32_t i, j;
    for (face = 0; face < 8; face++) {
        float a = face & 1 ? -1.0f : 1.0f, b = face & 2 ? -1.0f : 1.0f, c = face & 4 ? -1.0f : 1.0f;
        bool over = a * b * c < 0;
        for (i = 0; i < n; i++) {
            for (j = 0; j < n - i; j++) {
                uint32_t v[4];
                for (k = 0; k < 4; k++) {
                    int32_t u = i + (k & 1 ? 1 : 0), w = j + (k & 2 ? 1 : 0);
                    if (u + w > n) u = w = 0; /* not used */
                    v[k] = onto_sphere(nook_make(a * (float)u, b * (float)w, c * (float)(n - u - w)), radius,
                                       centre, first);
                }
                triangle(v[0], v[over ? 2 : 1], v[over ? 1 : 2]);
                if (i + j + 2 <= n) triangle(v[1], v[over ? 2 : 3], v[over ? 3 : 2]);
            }
        }
    }
}

static void sphere(void) { add_sphere(5, 5000, 0, 0, 0); }
static void two_spheres(void) {
    add_sphere(3, 4000, 0, 0, 0);
    add_sphere(3, 4000, 3000, 1000, 500);
}

/* A circle of n points: sine and cosine by turning; n is 12 or 24. */
static void turned(uint32_t k, uint32_t n, float *c, float *s) {
    static const float step[2][2] = {{0.8660254f, 0.5f}, {0.9659258f, 0.2588190f}};
    const float *by = step[n == 24];
    float x = 1, y = 0;
    while (k-- > 0) {
        float keep = x * by[0] - y * by[1];
        y = x * by[1] + y * by[0];
        x = keep;
    }
    *c = x;
    *s = y;
}

static void torus(void) {
    uint32_t i, j;
    for (i = 0; i < 12; i++) {
        for (j = 0; j < 12; j++) {
            float c, s, u, w;
            turned(i, 12, &c, &s);
            turned(j, 12, &u, &w);
            (void)point(rounded((3500 + 1500 * u) * c), rounded((3500 + 1500 * u) * s), rounded(1500 * w));
        }
    }
    for (i = 0; i < 12; i++) {
        for (j = 0; j < 12; j++) {
            uint32_t k = (i + 1) % 12, l = (j + 1) % 12;
            square(12 * i + j, 12 * k + j, 12 * k + l, 12 * i + l);
        }
    }
}

/* 10,000 times as wide as thick; each of the two large faces has 4 x 4 squares. */
static void thin_plate(void) {
    uint32_t top, x, y;
    for (top = 0; top < 2; top++) {
        for (y = 0; y < 5; y++) {
            for (x = 0; x < 5; x++)
                (void)point(2500 * (int32_t)x - 5000, 2500 * (int32_t)y - 5000, (int32_t)top);
        }
    }
    for (y = 0; y < 4; y++) {
        for (x = 0; x < 4; x++) {
            uint32_t v = 5 * y + x;
            square(25 + v, 26 + v, 31 + v, 30 + v);
            square(v, v + 5, v + 6, v + 1);
        }
        square(y, y + 1, y + 26, y + 25);
        square(21 + y, 20 + y, 45 + y, 46 + y);
        square(5 * y + 5, 5 * y, 25 + 5 * y, 30 + 5 * y);
        square(5 * y + 4, 5 * y + 9, 5 * y + 34, 5 * y + 29);
    }
}

/* 24 teeth; both ends are fans of long thin triangles round a hub. */
static void gear(void) {
    uint32_t k, end, hub[2];
    for (end = 0; end < 2; end++) {
        int32_t z = end == 0 ? -200 : 200;
        hub[end] = point(0, 0, z);
        for (k = 0; k < 48; k++) {
            float c, s, r = k % 2 ? 5000.0f : 4800.0f;
            turned(k / 2, 24, &c, &s);
            (void)point(rounded(r * c) + (k % 2 ? -rounded(60 * s) : 0),
                        rounded(r * s) + (k % 2 ? rounded(60 * c) : 0), z);
        }
    }
    for (k = 0; k < 48; k++) {
        uint32_t a = 1 + k, b = 1 + (k + 1) % 48;
        triangle(hub[0], b, a);
        triangle(hub[1], 49 + a, 49 + b);
        square(a, b, 49 + b, 49 + a);
    }
}

static void sheet(void) {
    uint32_t x, y;
    for (y = 0; y < 9; y++) {
        for (x = 0; x < 9; x++) {
            int32_t z = (int32_t)throw_dice(&d, 300);
            (void)point(1000 * (int32_t)x - 4000, 1000 * (int32_t)y - 4000, z);
        }
    }
    for (y = 0; y < 8; y++) {
        for (x = 0; x < 8; x++) square(9 * y + x, 9 * y + x + 1, 9 * y + x + 10, 9 * y + x + 9);
    }
}

static void bowl(void) {
    add_sphere(4, 5000, 0, 0, 0);
    nt = nt * 5 / 8;
}

/* A strip that is folded upon itself, in one plane, at every fourth edge, and crosses itself. */
static void folded_strip(void) {
    static const int32_t x[] = {0, 900, 1700, 800, 1600, 2500, 1200, 300, -400, 2000, 2600, 3000};
    uint32_t i;
    for (i = 0; i < 12; i++) {
        (void)point(x[i], i % 2 ? 1000 : 0, i > 9 ? 500 : 0);
    }
    for (i = 0; i + 2 < 12; i++) triangle(i, i + 1 + i % 2, i + 2 - i % 2);
    (void)point(1000, 500, -300);
    (void)point(1000, 500, 300);
    (void)point(1100, 800, 300);
    triangle(12, 13, 14);
}

/* Two strips side by side with no vertex in common, one with a vertex more on each edge of the seam but
 * the last; and one that stands a hand's breadth off. */
static void seam(void) {
    int32_t i;
    for (i = 0; i < 6; i++) {
        (void)point(1000, 1600 * i, 0);
        (void)point(0, 1600 * i, 0);
    }
    for (i = 0; i < 5; i++)
        square(2 * (uint32_t)i, 2 * (uint32_t)i + 2, 2 * (uint32_t)i + 3, 2 * (uint32_t)i + 1);
    for (i = 0; i < 10; i++) {
        (void)point(1000, 800 * i, 0);
        (void)point(2000, 800 * i, i == 3 ? 1 : 0);
    }
    for (i = 0; i < 9; i++)
        square(12 + 2 * (uint32_t)i, 13 + 2 * (uint32_t)i, 15 + 2 * (uint32_t)i, 14 + 2 * (uint32_t)i);
    (void)point(-1, 2000, 0);
    (void)point(-900, 2000, 300);
    (void)point(-900, 2600, 300);
    triangle(32, 33, 34);
    (void)point(5, 5, 5); /* of no triangle */
    (void)point(0, 2400, 0);
}

static void soup_of(uint32_t count) {
    uint32_t t, k;
    for (t = 0; t < count; t++) {
        int32_t c[3];
        for (k = 0; k < 3; k++) c[k] = (int32_t)throw_dice(&d, 8001) - 4000;
        for (k = 0; k < 3; k++) {
            int32_t x = (int32_t)throw_dice(&d, 1601), y = (int32_t)throw_dice(&d, 1601);
            (void)point(c[0] + x, c[1] + y, c[2] + (int32_t)throw_dice(&d, 1601));
        }
        triangle(3 * t, 3 * t + 1, 3 * t + 2);
        if (t % 10 == 9) P[3 * t + 2] = P[3 * t + t % 20 / 10]; /* a segment */
    }
}

static void soup(void) { soup_of(150); }

/* In a plane of zero extent; every triangle twice, and some of it four times. */
static void flat(void) {
    uint32_t y, z, t, times;
    for (z = 0; z < 4; z++) {
        for (y = 0; y < 4; y++) (void)point(1000, 1000 * (int32_t)y - 700, 900 * (int32_t)z);
    }
    for (z = 0; z < 3; z++) {
        for (y = 0; y < 3; y++) square(4 * z + y, 4 * z + y + 1, 4 * z + y + 5, 4 * z + y + 4);
    }
    for (times = 0; times < 2; times++) {
        for (t = 0; t < (times == 0 ? 18u : 12u); t++) triangle(T[t][0], T[t][1], T[t][2]);
    }
}

/* No area anywhere: points, and segments that cross. */
static void hairs(void) {
    int32_t i;
    for (i = 0; i < 10; i++) {
        uint32_t a = point(100 * i, 500, 3 * i), b = point(900 - 100 * i, -500, 3 * i),
                 c = point(450, 0, 3 * i);
        if (i % 3 == 0) triangle(a, b, c);
        if (i % 3 == 1) triangle(a, a, b);
        if (i % 3 == 2) triangle(c, c, c);
    }
}

/* Coordinates of all magnitudes. */
static void wild(void) {
    uint32_t i;
    for (i = 0; i < 180; i++) {
        uint32_t axis;
        for (axis = 0; axis < 3; axis++) {
            int32_t x = (int32_t)throw_dice(&d, 1u << (1u + throw_dice(&d, 15)));
            P[nv].at[axis] = throw_dice(&d, 2) ? x : -x;
        }
        nv++;
    }
    for (i = 0; i < 60; i++) triangle(3 * i, 3 * i + 1, 3 * i + 2);
}

const solid solids[] = {
    {"box", box, true},
    {"boxes in boxes", boxes_in_boxes, true},
    {"sphere", sphere, true},
    {"torus", torus, true},
    {"thin plate", thin_plate, true},
    {"gear", gear, true},
    {"two spheres", two_spheres, true},
    {"sheet", sheet, false},
    {"bowl", bowl, false},
    {"folded strip", folded_strip, false},
    {"seam", seam, false},
    {"soup", soup, false},
    {"flat", flat, false},
    {"hairs", hairs, false},
    {"wild", wild, false},
};
const uint32_t solid_count = sizeof solids / sizeof *solids;

/* Sizes of 2 mm and 2 km beside 2 m, if a unit of length is a metre; moved; skewed; very small and as
 * large as can be (queries go 30 times as far, and 2^30 is the end). */
const variant variants[] = {
    {-25, 0, false},        {-15, 0, false},     {-5, 0, false},  {-15, 6 * 600000, false},
    {-24, 6 * 12345, true}, {-2, 6 * 777, true}, {-50, 0, false}, {9, 0, false},
};
const uint32_t variant_count = sizeof variants / sizeof *variants;

/* ---- as a mesh ------------------------------------------------------------------------------------ */

static float unit_of(const variant *v) {
    return nook_power_of_two((uint32_t)(127 + v->place / 2)) *
           nook_power_of_two((uint32_t)(127 + v->place - v->place / 2));
}

static nook_point placed(const whole *p, const variant *v) {
    float unit = unit_of(v);
    float x = (float)p->at[0], y = (float)p->at[1], z = (float)p->at[2], o = (float)v->offset;
    if (!v->skew) return nook_make((x + o) * unit, (y - o) * unit, (z + o) * unit);
    return nook_make(((0.8f * x - 0.6f * y) * 0.93f + o) * unit,
                     ((0.48f * x + 0.64f * y - 0.6f * z) * 0.93f - o) * unit,
                     ((0.36f * x + 0.48f * y + 0.8f * z) * 0.93f + o) * unit);
}

/* The corner that faces the same edge, if there is exactly one more. */
static uint32_t opposite(uint32_t c) {
    uint32_t n = c % 3 == 2 ? c - 2 : c + 1, p = c % 3 == 0 ? c + 2 : c - 1, e, found = c, many = 0;
    for (e = 0; e < 3 * nt; e++) {
        uint32_t a = T[e / 3][(e + 1) % 3], b = T[e / 3][(e + 2) % 3];
        uint32_t s = T[n / 3][n % 3], t = T[p / 3][p % 3];
        if (e == c) continue;
        if ((a != s || b != t) && (a != t || b != s)) continue;
        found = e;
        many++;
    }
    return many == 1 ? found : c;
}

static float larger(float a, float b) { return a > b ? a : b; }

static float magnitude(float x) { return x < 0 ? -x : x; }

void measure_world(void) {
    uint32_t v;
    nook_point far = {0, 0, 0};
    for (v = 0; v < here.view.nv; v++) {
        const nook_point *p = &here.G[v];
        far.x = larger(far.x, larger(magnitude(p->x), larger(magnitude(p->y), magnitude(p->z))));
    }
    far.x *= 4096;
    here.lattice = lattice_of(&far, 1);
    for (v = 0; v < here.view.nv; v++) {
        here.G[v] = to_lattice(here.lattice, here.G[v]);
        here.at[v] = take_point(here.lattice, here.G[v]);
    }
}

static void make_world(const variant *v, bool closed) {
    uint32_t i;
    here.closed = closed;
    here.G = fenced(nv * sizeof *here.G);
    here.V = fenced(3 * nt * sizeof *here.V);
    here.O = fenced(3 * nt * sizeof *here.O);
    here.C = fenced(nv * sizeof *here.C);
    for (i = 0; i < nv; i++) {
        here.G[i] = placed(&P[i], v);
        here.C[i] = NOOK_STORED_NONE;
    }
    for (i = 0; i < 3 * nt; i++) {
        here.V[i] = nook_store(T[i / 3][i % 3]);
        here.O[i] = nook_store(nv == 3 * nt ? i : opposite(i));
        here.C[T[i / 3][i % 3]] = nook_store(i);
    }
    here.boxes = fenced(NOOK_BVH_GROUPS(nt) * sizeof *here.boxes);
    here.order = fenced(nt * sizeof *here.order);
    here.boxes_of_one = fenced(nt * NOOK_BVH_GROUPS(1) * sizeof *here.boxes_of_one);
    here.size = 30000.0f * unit_of(v);
    CHECK_EQUAL(nook_view_init(&here.view, here.G, here.V, here.O, here.C, nv, nt), NOOK_OK);
    measure_world();
}

void make_solid(const solid *s, const variant *v) {
    begin();
    s->make();
    make_world(v, s->closed);
}

void make_soup(uint32_t count, const variant *v) {
    begin();
    soup_of(count);
    make_world(v, false);
}

static void build_alone(uint32_t t) {
    nook_view one = here.view;
    one.V += 3 * t;
    one.O = NULL;
    one.C = NULL;
    one.nt = 1;
    CHECK_EQUAL(nook_bvh_build(&here.alone[t], &one, here.boxes_of_one + t * NOOK_BVH_GROUPS(1), NULL, NULL),
                NOOK_OK);
}

void build_trees(void) {
    uint32_t t;
    CHECK_EQUAL(nook_bvh_build(&here.bvh, &here.view, here.boxes, here.order, NULL), NOOK_OK);
    for (t = 0; t < here.view.nt; t++) build_alone(t);
}

void drop_world(void) {
    CHECK(fences_hold());
    drop_fences();
}

void take_triangle(uint32_t t, vector p[3]) {
    uint32_t k;
    for (k = 0; k < 3; k++) p[k] = here.at[here.V[3 * t + k]];
}

nook_point between(nook_point a, nook_point b, float s) {
    return nook_make(b.x + (a.x - b.x) * s, b.y + (a.y - b.y) * s, b.z + (a.z - b.z) * s);
}

nook_point centre_of(uint32_t t) {
    const nook_point *a = &here.G[here.V[3 * t]], *b = &here.G[here.V[3 * t + 1]],
                     *c = &here.G[here.V[3 * t + 2]];
    nook_point u = nook_sub(*b, *a), v = nook_sub(*c, *a);
    return nook_make(a->x + (u.x + v.x) / 3.0f, a->y + (u.y + v.y) / 3.0f, a->z + (u.z + v.z) / 3.0f);
}

float throw_unit(dice *from) { return (float)throw_dice(from, 0x1000000u) * 0x1p-23f - 1.0f; }
