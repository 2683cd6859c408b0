/* test_normals.c -- normals of vertices and of corners, against what symmetry says and against a slow computation in double
 * precision: triangles of a vertex are in one part if they are joined across edges that are no creases, all pairs tried. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

static nook_view view;
enum { ROOM = NOOK_TEST_RAM < 2000000 ? 960 : 2880 }; /* floats */
static float normals[ROOM];
static dice d = {43};

static void linked(void) {
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
}

static nook_creases creases;
static nook_status crease(float cosine, nook_weight weight, uint32_t width, uint32_t cut) {
    uint32_t spent = 0, units;
    nook_status status;
    CHECK_EQUAL(nook_creases_begin(&creases, &view, weight, cosine, normals, width), NOOK_OK);
    do {
        units = cut;
        status = nook_creases_step(&creases, &units);
        spent += cut - units;
    } while (status == NOOK_MORE);
    CHECK(spent <= 6 * view.nt);
    return status;
}

static bool is_near(nook_point n, float x, float y, float z, float within) {
    return nook_abs(n.x - x) <= within && nook_abs(n.y - y) <= within && nook_abs(n.z - z) <= within;
}

/* Of corner c, as it was written. */
static nook_point written(uint32_t c) {
    const float *n = normals + (size_t)creases.width * c;
    return nook_make(n[0], n[1], n[2]);
}

static nook_point vertex_normal(uint32_t v, nook_weight weight) {
    nook_point n;
    CHECK_EQUAL(nook_vertex_normal(&view, nook_corner_of(&view, v), weight, &n), NOOK_OK);
    return n;
}

/* ---- in double precision --------------------------------------------------------------------------- */

typedef struct wide {
    double x, y, z;
} wide;

static wide from(uint32_t c, uint32_t to) {
    nook_point a = view.G[view.V[c]], z = view.G[view.V[to]];
    wide w = {(double)z.x - (double)a.x, (double)z.y - (double)a.y, (double)z.z - (double)a.z};
    return w;
}
static double dot(wide a, wide z) { return a.x * z.x + a.y * z.y + a.z * z.z; }
static double root(double x) { /* Newton, from above */
    double r = x < 1 ? 1 : x, before;
    do {
        before = r;
        r = (r + x / r) / 2;
    } while (r < before);
    return r;
}
static wide scaled(wide a, double s) {
    wide w = {a.x * s, a.y * s, a.z * s};
    return w;
}
static wide cross(wide a, wide z) {
    wide w = {a.y * z.z - a.z * z.y, a.z * z.x - a.x * z.z, a.x * z.y - a.y * z.x};
    return w;
}
static wide area_at(uint32_t c) { return cross(from(c, nook_next(c)), from(c, nook_prev(c))); }
static double length(wide a) { return root(dot(a, a)); }
static wide normal_at(uint32_t c) { return scaled(area_at(c), 1 / length(area_at(c))); }

/* The angle is halved four times, then a few terms of the series. */
static double angle_at(uint32_t c) {
    double y = length(area_at(c)), x = dot(from(c, nook_next(c)), from(c, nook_prev(c)));
    double t = y / (root(x * x + y * y) + x), z;
    int i;
    for (i = 0; i < 3; i++) t /= 1 + root(1 + t * t);
    z = t * t;
    return 16 * t * (1 - z * (1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z / 9))));
}

/* Corners of one vertex that are joined; then the mean over those with c. Whether no edge there is nearly a crease. */
static bool expect(uint32_t c, double cosine, nook_weight weight, wide *mean) {
    static bool in[ROOM / 4];
    bool changed = true, clear = true;
    uint32_t x, nc = 3 * view.nt;
    wide zero = {0, 0, 0};
    memset(in, 0, sizeof in);
    in[c] = true;
    while (changed) {
        changed = false;
        for (x = 0; x < nc; x++) {
            uint32_t left = view.O[nook_prev(x)], y = nook_prev(left);
            double turned;
            if (view.V[x] != view.V[c] || left == nook_prev(x)) continue;
            turned = dot(normal_at(x), normal_at(y)) - cosine;
            clear = clear && (turned > 1e-5 || turned < -1e-5);
            if (in[x] == in[y] || turned < 0) continue;
            in[x] = in[y] = changed = true;
        }
    }
    for (*mean = zero, x = 0; x < nc; x++) {
        wide n = normal_at(x);
        double w = weight == NOOK_BY_AREA ? length(area_at(x)) : angle_at(x);
        if (!in[x]) continue;
        mean->x += n.x * w, mean->y += n.y * w, mean->z += n.z * w;
    }
    if (length(*mean) < 1e-3) return false;
    *mean = scaled(*mean, 1 / length(*mean));
    return clear;
}

static void normals_are_those_of_double_precision(void) {
    static const float cosines[] = {-2, -0.3f, 0.5f, 0.866f, 0.99f};
    uint32_t round, c, compared = 0, asked = 0, rounds = NOOK_TEST_RAM < 2000000 ? 3 : 9;
    for (round = 0; round < rounds && !test_has_failed(); round++) {
        float cosine = cosines[throw_dice(&d, 5)];
        nook_weight weight = throw_dice(&d, 2) == 0 ? NOOK_BY_AREA : NOOK_BY_ANGLE;
        if (round % 3 == 0) torus(5, 4);
        if (round % 3 == 1) grid(4, 4);
        if (round % 3 == 2) octahedron();
        for (c = 0; c < b.mesh.nv; c++)
            place(c, (float)throw_dice(&d, 900) / 7, (float)throw_dice(&d, 900) / 7,
                  (float)throw_dice(&d, 900) / 7);
        shuffle(&d);
        linked();
        CHECK_EQUAL(crease(cosine, weight, 4, 1 + throw_dice(&d, 99)), NOOK_OK);
        for (c = 0; c < 3 * view.nt; c++) {
            wide mean;
            asked++;
            if (!expect(c, (double)cosine, weight, &mean)) continue;
            CHECK(is_near(written(c), (float)mean.x, (float)mean.y, (float)mean.z, 1e-4f));
            compared++;
        }
    }
    CHECK(compared > asked / 10 * 9);
}

/* ---- what symmetry says ---------------------------------------------------------------------------- */

static void of_an_octahedron_they_point_along_the_axes(void) {
    uint32_t v;
    octahedron();
    linked();
    for (v = 0; v < 12; v++) {
        nook_point n = vertex_normal(v / 2, v % 2 == 0 ? NOOK_BY_AREA : NOOK_BY_ANGLE), g = view.G[v / 2];
        g = nook_scaled(g, 1 / nook_length(g));
        CHECK(is_near(n, g.x, g.y, g.z, 1e-7f));
    }
}

/* At a corner of a cube each face has a right angle, in one triangle or in two. */
static void by_angle_the_cut_of_a_face_does_not_show_and_by_area_it_does(void) {
    uint32_t v, uneven = 0;
    cube();
    linked();
    for (v = 0; v < 8; v++) {
        nook_point n = vertex_normal(v, NOOK_BY_ANGLE), g = view.G[v];
        const float third = 0.57735027f;
        CHECK(
            is_near(n, g.x > 0 ? third : -third, g.y > 0 ? third : -third, g.z > 0 ? third : -third, 3e-7f));
        n = vertex_normal(v, NOOK_BY_AREA);
        uneven +=
            !is_near(n, n.x > 0 ? third : -third, n.y > 0 ? third : -third, n.z > 0 ? third : -third, 0.1f);
    }
    CHECK(uneven > 0);
}

static void hard_edges_stay_hard(void) {
    uint32_t c;
    cube();
    linked();
    CHECK_EQUAL(crease(0.866f, NOOK_BY_ANGLE, 3, 7), NOOK_OK);
    for (c = 0; c < 36; c++) {
        nook_point p[3] = {view.G[view.V[c / 3 * 3]], view.G[view.V[c / 3 * 3 + 1]],
                           view.G[view.V[c / 3 * 3 + 2]]};
        nook_point n = nook_normal(p);
        CHECK(is_near(written(c), n.x, n.y, n.z, 1e-7f));
    }
    CHECK_EQUAL(creases.without, 0);
    CHECK_EQUAL(crease(-2, NOOK_BY_ANGLE, 3, 1000), NOOK_OK); /* all soft: as of vertices */
    for (c = 0; c < 36; c++) {
        nook_point n = vertex_normal(view.V[c], NOOK_BY_ANGLE);
        CHECK(is_near(written(c), n.x, n.y, n.z, 3e-7f));
    }
}

/* A link of a robot: a pipe of 10 sectors with flat lids. The side is smooth, the rims are not. */
static void a_pipe_is_smooth_but_for_its_rims(void) {
    enum { SECTORS = 10 };
    uint32_t rings = NOOK_TEST_RAM < 2000000 ? 5 : 15, r, k, c, last;
    static const float turn[2] = {0.80901699f, 0.58778525f}; /* of 36 degrees */
    begin_shape(SECTORS * rings + 2);
    for (r = 0; r < rings; r++) {
        float x = 1, y = 0;
        for (k = 0; k < SECTORS; k++) {
            float keep = x;
            place(r * SECTORS + k, x, y, (float)r);
            x = x * turn[0] - y * turn[1];
            y = keep * turn[1] + y * turn[0];
        }
    }
    last = SECTORS * (rings - 1);
    place(last + SECTORS, 0, 0, 0);
    place(last + SECTORS + 1, 0, 0, (float)(rings - 1));
    for (k = 0; k < SECTORS; k++) {
        uint32_t j = (k + 1) % SECTORS;
        for (r = 0; r < last; r += SECTORS) {
            add(r + k, r + j, r + SECTORS + j);
            add(r + k, r + SECTORS + j, r + SECTORS + k);
        }
        add(last + SECTORS, j, k);
        add(last + SECTORS + 1, last + k, last + j);
    }
    linked();
    CHECK(nook_is_sound(&b.result));
    CHECK_EQUAL(crease(0.5f, NOOK_BY_ANGLE, 3, UINT32_MAX), NOOK_OK);
    for (c = 0; c < 3 * view.nt; c++) {
        nook_point g = view.G[view.V[c]];
        bool lid = c / 3 % (2 * rings) >= 2 * rings - 2;
        float up = c / 3 % 2 == 0 ? -1.0f : 1.0f;
        CHECK(is_near(written(c), lid ? 0 : g.x, lid ? 0 : g.y, lid ? up : 0, 1e-5f));
    }
}

/* ---- no normal ------------------------------------------------------------------------------------- */

static void is_none(uint32_t c) {
    nook_point n = nook_make(7, 7, 7);
    CHECK_EQUAL(nook_vertex_normal(&view, c, NOOK_BY_AREA, &n), NOOK_ZERO_AREA_TRIANGLE);
    CHECK(n.x == 0 && n.y == 0 && n.z == 0);
    CHECK_EQUAL(nook_vertex_normal(&view, c, NOOK_BY_ANGLE, &n), NOOK_ZERO_AREA_TRIANGLE);
    CHECK(n.x == 0 && n.y == 0 && n.z == 0);
}

static void fans_without_area_or_folded_onto_themselves_have_none(void) {
    static const float size[] = {1, 0.1f, 3e-30f, 1e-41f, NOOK_MAX_COORDINATE};
    uint32_t i, c;
    for (i = 0; i < 5; i++) {
        begin_shape(3); /* both sides of a triangle */
        place(0, 0, 0, 0), place(1, size[i], 0, 0.3f * size[i]), place(2, 0.7f * size[i], size[i], 0);
        add(0, 1, 2), add(0, 2, 1);
        linked();
        for (c = 0; c < 6; c++) is_none(c);
        CHECK_EQUAL(crease(-2, NOOK_BY_ANGLE, 3, 9), NOOK_OK);
        CHECK_EQUAL(creases.without, 6);
        place(2, 2 * size[i], 0, 0.6f * size[i]); /* on a line */
        for (c = 0; c < 6; c++) is_none(c);
    }
}

static void a_triangle_without_area_counts_for_nothing(void) {
    uint32_t weight;
    grid(2, 2);
    for (weight = 0; weight < 9; weight++) place(weight, (float)(weight % 3), (float)(weight / 3), 0);
    place(0, 1, 0.5f, 0); /* between its neighbours 1 and 4: the triangle 0 1 4 has no area, 0 4 3 has */
    linked();
    for (weight = 0; weight < 2; weight++) {
        nook_point n = vertex_normal(4, (nook_weight)weight);
        CHECK(is_near(n, 0, 0, 1, 1e-7f));
    }
    CHECK_EQUAL(crease(0.9f, NOOK_BY_AREA, 3, 100), NOOK_OK);
    CHECK_EQUAL(creases.without, 3);
    CHECK(is_near(written(0), 0, 0, 0, 0) && is_near(written(3), 0, 0, 1, 1e-7f));
}

static void sizes_from_tiny_to_huge_have_the_same_normals(void) {
    static const float size[] = {1e-15f, 0x1p-10f, 0x1p30f};
    uint32_t i, v;
    for (i = 0; i < 3; i++) {
        octahedron();
        for (v = 0; v < 6; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], size[i] / nook_length(b.mesh.G[v]));
        linked();
        for (v = 0; v < 6; v++) {
            nook_point g = nook_scaled(view.G[v], 1 / size[i]), n = vertex_normal(v, NOOK_BY_AREA);
            CHECK(is_near(n, g.x, g.y, g.z, 1e-6f));
            n = vertex_normal(v, NOOK_BY_ANGLE);
            CHECK(is_near(n, g.x, g.y, g.z, 1e-6f));
        }
    }
}

/* ---- other numbers and tables ------------------------------------------------------------------------ */

static uint32_t digest(uint32_t floats) {
    uint32_t i, h = 2166136261u;
    for (i = 0; i < floats; i++) h = (h ^ nook_float_bits(normals[i] + 0.0f)) * 16777619u;
    return h;
}

static void every_machine_and_every_slicing_gives_the_same_bits(void) {
    uint32_t cut, v;
    torus(6, 5);
    for (v = 0; v < 30; v++) place(v, (float)(v % 7) * 0.37f, (float)(v * v % 11) * 0.61f, (float)v * 0.143f);
    linked();
    for (cut = 1; cut < 400; cut = 19 * cut + 1) {
        CHECK_EQUAL(crease(0.5f, NOOK_BY_ANGLE, 3, cut), NOOK_OK);
        CHECK_EQUAL(digest(9 * view.nt), 2853842504u);
        CHECK_EQUAL(crease(0.5f, NOOK_BY_AREA, 3, cut), NOOK_OK);
        CHECK_EQUAL(digest(9 * view.nt), 956285477u);
    }
}

static void only_three_floats_of_a_corner_are_written(void) {
    uint32_t i;
    octahedron();
    linked();
    for (i = 0; i < 24 * 4; i++) normals[i] = 7;
    CHECK_EQUAL(crease(0.5f, NOOK_BY_ANGLE, 4, 50), NOOK_OK);
    for (i = 0; i < 24 * 4; i++) CHECK((normals[i] == 7) == (i % 4 == 3));
}

static void any_bits_do_no_harm_and_make_no_nan(void) {
    uint32_t i, k, bad = 0, rounds = NOOK_TEST_RAM < 2000000 ? 24 : 300;
    for (i = 0; i < rounds; i++) {
        nook_weight weight = i % 2 == 0 ? NOOK_BY_AREA : NOOK_BY_ANGLE;
        nook_status status;
        nook_point n;
        if (i % 4 == 0) torus(4, 3 + i % 2);
        if (i % 4 == 0) linked();
        for (k = throw_dice(&d, 3); k < 3; k++) {
            uint32_t at = throw_dice(&d, 3 * view.nt),
                     to = throw_dice(&d, 4) == 0 ? 0xFFF0 : throw_dice(&d, 80);
            uint32_t bits = throw_dice(&d, 65536) << 16 | throw_dice(&d, 65536);
            (throw_dice(&d, 2) == 0 ? b.mesh.V : b.mesh.O)[at] = nook_store(to);
            *nook_axis(&b.mesh.G[throw_dice(&d, 12)], k) = nook_float_from(bits);
        }
        status = crease(i % 3 == 0 ? nook_float_from(0x7FC00000u) : 0.3f, weight, 3, 40);
        CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
        bad += status == NOOK_BAD_OPPOSITE;
        for (k = 0; k < 9 * view.nt && status == NOOK_OK; k++)
            CHECK(normals[k] >= -1.1f && normals[k] <= 1.1f);
        for (k = 0; k < 3 * view.nt; k++) {
            status = nook_vertex_normal(&view, k, weight, &n);
            CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE || status == NOOK_ZERO_AREA_TRIANGLE);
            CHECK(is_near(n, 0, 0, 0, 1.1f));
        }
    }
    CHECK(bad > rounds / 5 && bad < rounds);
}

static void a_triangle_that_names_no_vertex_counts_for_nothing(void) {
    uint32_t i, k;
    octahedron();
    linked();
    for (i = 0; i < 6; i++) {
        uint32_t c = view.C[0], x = nook_turn(&view, c, true) / 3 * 3 + i % 3;
        nook_index keep = view.V[x];
        nook_weight weight = i < 3 ? NOOK_BY_AREA : NOOK_BY_ANGLE;
        nook_point n, far, at_crease;
        b.mesh.G[view.nv] = nook_scaled(view.G[keep], 1.5f); /* behind the end */
        b.mesh.V[x] = nook_store(view.nv);
        CHECK_EQUAL(nook_vertex_normal(&view, x, weight, &n), NOOK_ZERO_AREA_TRIANGLE);
        CHECK_EQUAL(nook_vertex_normal(&view, c, weight, &n), NOOK_OK);
        CHECK_EQUAL(crease(0.1f, weight, 3, 100), NOOK_OK);
        at_crease = written(c);
        for (k = x / 3 * 3; k < x / 3 * 3 + 3; k++) CHECK(is_near(written(k), 0, 0, 0, 0));
        b.mesh.V[x] = NOOK_STORED_NONE;
        CHECK_EQUAL(nook_vertex_normal(&view, c, weight, &far), NOOK_OK);
        CHECK(is_near(n, far.x, far.y, far.z, 0));
        CHECK_EQUAL(crease(0.1f, weight, 3, 100), NOOK_OK);
        far = written(c);
        CHECK(is_near(at_crease, far.x, far.y, far.z, 0));
        b.mesh.V[x] = keep;
    }
}

static void a_call_that_cannot_be_carried_out_says_why(void) {
    nook_point n;
    uint32_t units = 9;
    octahedron();
    linked();
    CHECK(sizeof creases <= 256);
    CHECK_EQUAL(nook_vertex_normal(&view, 24, NOOK_BY_AREA, &n), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_creases_begin(NULL, &view, NOOK_BY_AREA, 0, normals, 3), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_creases_begin(&creases, NULL, NOOK_BY_AREA, 0, normals, 3), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_creases_begin(&creases, &view, NOOK_BY_AREA, 0, NULL, 3), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_creases_begin(&creases, &view, NOOK_BY_AREA, 0, normals, 2), NOOK_NO_CAPACITY);
    view.nt = 0;
    CHECK_EQUAL(nook_creases_begin(&creases, &view, NOOK_BY_AREA, 0, normals, 3), NOOK_OK);
    CHECK_EQUAL(nook_creases_step(&creases, &units), NOOK_OK);
    CHECK_EQUAL(units, 9);
}

static const test tests[] = {
    TEST(normals_are_those_of_double_precision),
    TEST(of_an_octahedron_they_point_along_the_axes),
    TEST(by_angle_the_cut_of_a_face_does_not_show_and_by_area_it_does),
    TEST(hard_edges_stay_hard),
    TEST(a_pipe_is_smooth_but_for_its_rims),
    TEST(fans_without_area_or_folded_onto_themselves_have_none),
    TEST(a_triangle_without_area_counts_for_nothing),
    TEST(sizes_from_tiny_to_huge_have_the_same_normals),
    TEST(every_machine_and_every_slicing_gives_the_same_bits),
    TEST(only_three_floats_of_a_corner_are_written),
    TEST(any_bits_do_no_harm_and_make_no_nan),
    TEST(a_triangle_that_names_no_vertex_counts_for_nothing),
    TEST(a_call_that_cannot_be_carried_out_says_why),
};

void test_normals(void) { run_tests(tests, sizeof tests / sizeof *tests); }
