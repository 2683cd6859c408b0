/* test_smooth.c -- smoothing, bit for bit against two copies of all points and neighbours looked up in V alone.
 *
 * What is smooth stays, noise goes, borders stay or slide, nothing folds; volumes are those that nook_geometry measures. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

enum { SMALL = NOOK_TEST_RAM < 2000000, MANY = 66 };

static nook_point old[SMALL ? MANY : 700], expected[MANY];
static float next[SMALL ? MANY : 700];
static nook_smoothed told;
static dice d = {47};
static const nook_smoothing laplace = {1, 0.5f, 0, false, NULL};
static const nook_smoothing taubin = {1, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, NULL};

static void linked(void) { CHECK_EQUAL(link_and_check(NULL), NOOK_OK); }
static void keep(void) { memcpy(old, b.mesh.G, b.mesh.nv * sizeof *old); }
static void recall(void) { memcpy(b.mesh.G, old, b.mesh.nv * sizeof *old); }
static bool unchanged(void) { return memcmp(old, b.mesh.G, b.mesh.nv * sizeof *old) == 0; }

static uint32_t digest(void) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_digest(&view);
}

/* With so many units a call, within the bound if nothing is held back. */
static nook_status slice(const nook_smoothing *how, uint32_t cut) {
    nook_smooth_state state;
    uint32_t nv = b.mesh.nv, nt = b.mesh.nt, passes = how->rounds * (how->mu != 0 ? 2 : 1), units;
    uint32_t spent = 0,
             bound = nv + 2 * nt + 3 + passes * (6 * nv + 6 + (how->reference != NULL ? 3 * nt + 3 : 0));
    nook_status status;
    CHECK_EQUAL(nook_smooth_begin(&state, &b.mesh, how, next, &told), NOOK_OK);
    do {
        units = cut;
        status = nook_smooth_step(&state, &units);
        CHECK(status != NOOK_MORE || units == 0);
        spent += cut - units;
    } while (status == NOOK_MORE);
    CHECK(spent <= bound + (told.held > 0 ? 3 * passes * (told.held * nt + told.held) : 0));
    if (status == NOOK_OK && told.held == 0) CHECK_EQUAL(spent, bound);
    return status;
}

static void smooth(const nook_smoothing *how) { CHECK_EQUAL(slice(how, UINT32_MAX), NOOK_OK); }

/* Noise on all points but those of a border, or on them too. */
static void shake(float much) {
    uint32_t v, axis;
    for (v = 0; v < b.mesh.nv; v++) {
        for (axis = 0; axis < 3; axis++)
            *nook_axis(&b.mesh.G[v], axis) += much * ((float)throw_dice(&d, 2001) / 1000 - 1);
    }
}

/* ---- two copies -------------------------------------------------------------------------------------- */

static uint32_t corner_from(uint32_t v, uint32_t to, bool back) {
    uint32_t c;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        if (b.mesh.V[c] == v && b.mesh.V[back ? nook_prev(c) : nook_next(c)] == to) return c;
    }
    return NOOK_NONE;
}

/* Counter-clockwise: each triangle begins where the one before ends. */
static nook_point middle_of(uint32_t v, bool slide) {
    uint32_t c, first = NOOK_NONE, n = 0;
    nook_point sum = {0, 0, 0}, g;
    bool open = false;
    for (c = 3 * b.mesh.nt; c-- > 0;) {
        if (b.mesh.V[c] != v || open) continue;
        first = c;
        open = corner_from(v, b.mesh.V[nook_next(c)], true) == NOOK_NONE;
    }
    if (first == NOOK_NONE || (open && !slide)) return old[v];
    c = first;
    do {
        uint32_t after = corner_from(v, b.mesh.V[nook_prev(c)], false);
        if (!open || c == first) {
            g = old[b.mesh.V[nook_next(c)]];
            sum.x += g.x, sum.y += g.y, sum.z += g.z;
            n++;
        }
        if (after == NOOK_NONE) {
            g = old[b.mesh.V[nook_prev(c)]];
            sum.x += g.x, sum.y += g.y, sum.z += g.z;
            n++;
        }
        c = after;
    } while (c != NOOK_NONE && c != first);
    return nook_make(sum.x / (float)n, sum.y / (float)n, sum.z / (float)n);
}

static void pass_of_copies(float by, bool slide) {
    uint32_t v;
    keep();
    for (v = 0; v < b.mesh.nv; v++) {
        nook_point m = middle_of(v, slide), g = old[v];
        b.mesh.G[v] = nook_make(g.x + by * (m.x - g.x), g.y + by * (m.y - g.y), g.z + by * (m.z - g.z));
    }
}

static void all_axes_and_both_passes_are_those_of_two_copies(void) {
    uint32_t i, k, rounds = SMALL ? 8 : 120;
    for (i = 0; i < rounds && !test_has_failed(); i++) {
        nook_smoothing how = {1 + throw_dice(&d, 2), 0.6307f, 0, throw_dice(&d, 2) == 0, NULL};
        if (throw_dice(&d, 2) == 0) how.mu = -0.6732f;
        if (i % 4 == 0) torus(5, 6);
        if (i % 4 == 1) grid(5, 6);
        if (i % 4 == 2) octahedron();
        if (i % 4 == 3) icosphere(1);
        if (i % 4 == 2) b.mesh.nv++; /* of no triangle */
        if (i % 4 == 2) place(6, 3, 4, 5);
        shake(0.3f);
        shuffle(&d);
        linked();
        memcpy(expected, b.mesh.G, b.mesh.nv * sizeof *expected);
        for (k = 0; k < how.rounds; k++) {
            pass_of_copies(how.lambda, how.slide);
            if (how.mu != 0) pass_of_copies(how.mu, how.slide);
        }
        keep(); /* what should come out */
        memcpy(b.mesh.G, expected, b.mesh.nv * sizeof *expected);
        CHECK_EQUAL(slice(&how, 1 + throw_dice(&d, 200)), NOOK_OK);
        CHECK(unchanged());
    }
}

/* ---- what must come out ------------------------------------------------------------------------------ */

static void a_vertex_in_the_middle_stays_and_so_does_a_border(void) {
    static const nook_smoothing long_way = {5, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, old};
    uint32_t v;
    grid(5, 5);
    for (v = 0; v < 36; v++) place(v, (float)(v % 6), (float)(v / 6), (float)(3 * (v % 6)));
    linked();
    keep();
    smooth(&long_way);
    CHECK(unchanged());
    CHECK_EQUAL(told.held, 0);
    for (v = 0; v < 36; v++) place(v, (float)(v % 6), (float)(v / 6), (float)(v * v % 7));
    keep();
    smooth(&long_way);
    CHECK(!unchanged());
    for (v = 0; v < 36; v++) {
        if (v % 6 == 0 || v % 6 == 5 || v < 6 || v >= 30)
            CHECK(memcmp(&old[v], &b.mesh.G[v], sizeof *old) == 0);
    }
}

/* On a straight side it stays on the side, and a corner is rounded off. */
static void a_border_that_slides_keeps_its_straight_sides(void) {
    nook_smoothing how = laplace;
    uint32_t v;
    how.slide = true;
    grid(5, 5);
    for (v = 0; v < 36; v++) place(v, (float)(v % 6) + (v % 6 == 2 ? 0.3f : 0), (float)(v / 6), 0);
    linked();
    smooth(&how);
    CHECK(b.mesh.G[2].x < 2.3f && b.mesh.G[2].x >= 2 && b.mesh.G[2].y == 0);
    CHECK(b.mesh.G[3].y == 0 && b.mesh.G[12].x == 0 && b.mesh.G[17].x == 5 && b.mesh.G[33].y == 5);
    CHECK(b.mesh.G[0].x == 0.25f && b.mesh.G[0].y == 0.25f);
}

static float length_of(uint32_t v) { return nook_length(b.mesh.G[v]); }

/* How far the lengths of points on a unit sphere are from their mean. */
static float roughness(float *mean) {
    uint32_t v;
    float sum = 0, off = 0;
    for (v = 0; v < b.mesh.nv; v++) sum += length_of(v);
    *mean = sum / (float)b.mesh.nv;
    for (v = 0; v < b.mesh.nv; v++) off += (length_of(v) - *mean) * (length_of(v) - *mean);
    return nook_sqrt(off / (float)b.mesh.nv);
}

static void noise_on_a_sphere_goes_and_with_taubin_the_volume_stays(void) {
    nook_smoothing how = taubin;
    float before, after, mean, gained;
    uint32_t v;
    icosphere(SMALL ? 2 : 3);
    for (v = 0; v < b.mesh.nv; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], 1 / length_of(v));
    shake(0.05f);
    linked();
    keep();
    before = roughness(&mean);
    how.rounds = 10;
    smooth(&how);
    after = roughness(&mean);
    CHECK(after < (SMALL ? 1 : 0.5f) * before); /* few vertices have waves that are as long as the noise is */
    CHECK(mean > 0.98f && mean < 1.02f);
    gained = nook_abs(told.gained / told.volume);
    CHECK(gained < 0.05f);
    recall();
    how.lambda = 0.5f, how.mu = 0, how.rounds = 20;
    smooth(&how);
    (void)roughness(&mean);
    CHECK(-told.gained / told.volume > 10 * gained && mean < 0.8f);
}

static void volumes_are_those_that_geometry_measures(void) {
    uint32_t i;
    for (i = 0; i < 4; i++) {
        nook_smoothing how = i % 2 == 0 ? laplace : taubin;
        float before, off;
        torus(6, 5 + i % 2);
        shake(2);
        linked();
        before = b.result.geometry.signed_volume;
        smooth(&how);
        CHECK(told.volume == before);
        linked();
        off = before + told.gained - b.result.geometry.signed_volume;
        CHECK(nook_abs(off) <= 1e-6f * (nook_abs(before) + nook_abs(told.gained)));
        CHECK(told.gained != 0);
        how.rounds = 0;
        keep();
        smooth(&how);
        CHECK(unchanged());
        CHECK(told.gained == 0 && told.volume == b.result.geometry.signed_volume);
    }
}

/* ---- nothing folds ----------------------------------------------------------------------------------- */

static uint32_t turned_over(void) {
    uint32_t t, n = 0;
    for (t = 0; t < b.mesh.nt; t++) {
        const nook_index *V = b.mesh.V + 3 * t;
        n += nook_orient2d(&b.mesh.G[V[0]], &b.mesh.G[V[1]], &b.mesh.G[V[2]], 2) <= 0;
    }
    return n;
}

/* Far more than the whole way to the middle, and back. */
static void a_flat_mesh_never_folds(void) {
    nook_smoothing how = {4, 1.7f, -0.9f, true, NULL};
    uint32_t i, v, folded = 0, held = 0;
    for (i = 0; i < (SMALL ? 4u : 100u) && !test_has_failed(); i++) {
        do {
            grid(4, 4);
            for (v = 0; v < 25; v++)
                place(v, (float)(v % 5) + (float)throw_dice(&d, 100) / 180,
                      (float)(v / 5) + (float)throw_dice(&d, 100) / 180, 1);
        } while (turned_over() > 0);
        shuffle(&d);
        linked();
        keep();
        how.reference = NULL;
        smooth(&how);
        folded += turned_over() > 0;
        for (v = 0; v < 2; v++) {
            recall();
            how.reference = v == 0 ? old : b.mesh.G;
            smooth(&how);
            CHECK_EQUAL(turned_over(), 0);
            held += told.held > 0;
            CHECK(!unchanged());
        }
    }
    CHECK(folded > i / 2 && held > i);
}

/* Once by Taubin, whose way back would carry off what was held on the way there. */
static void no_triangle_turns_over_and_nothing_is_carried_off(void) {
    nook_smoothing how = {40, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, old};
    uint32_t i, t, v, k, held = 0;
    for (i = 0; i < (SMALL ? 3u : 60u) && !test_has_failed(); i++) {
        torus(5, 5 + i % 2);
        for (v = 0; v < b.mesh.nv; v++) place(v, 0, 0, 0);
        shake(1);
        linked();
        keep();
        smooth(&how);
        held += told.held > 0;
        for (t = 0; t < b.mesh.nt; t++) {
            const nook_point *p[4], *q[4];
            for (k = 0; k < 4; k++) {
                v = b.mesh.V[3 * t + (k < 3 ? k : 2)];
                p[k] = &old[v];
                q[k] = &b.mesh.G[v];
            }
            CHECK_EQUAL(nook_compare_normals(p, q), 1);
        }
        for (v = 0; v < b.mesh.nv; v++) CHECK(length_of(v) < 2.2f);
    }
    CHECK(held > i / 2);
}

static void a_triangle_without_area_may_move_and_get_one(void) {
    nook_smoothing how = laplace;
    uint32_t v;
    how.reference = b.mesh.G;
    grid(3, 3);
    for (v = 0; v < 16; v++) place(v, (float)(v % 4), (float)(v / 4), 0);
    place(5, 2, 1, 0); /* at the place of 6 */
    linked();
    smooth(&how);
    CHECK(b.mesh.G[5].x < b.mesh.G[6].x);
}

/* ---- the same everywhere ----------------------------------------------------------------------------- */

static void lumpy_torus(void) {
    uint32_t v;
    torus(6, 5);
    for (v = 0; v < 30; v++) place(v, (float)(v % 7) * 0.37f, (float)(v * v % 11) * 0.61f, (float)v * 0.143f);
    linked();
    keep();
}

static void every_machine_slicing_and_corner_of_a_vertex_gives_the_same(void) {
    nook_smoothing how = {3, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, old};
    uint32_t cut, c;
    lumpy_torus();
    for (cut = 1; cut < 3000; cut = 6 * cut + 1) {
        recall();
        CHECK_EQUAL(slice(&how, cut), NOOK_OK);
        CHECK_EQUAL(digest(), 1174702818u);
        CHECK_EQUAL(nook_float_bits(told.gained), 1060316989u);
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            if (throw_dice(&d, 3) == 0) b.mesh.C[b.mesh.V[c]] = nook_store(c);
        }
    }
    recall();
    CHECK_EQUAL(nook_smooth(&b.mesh, &how, next, &told), NOOK_OK);
    CHECK_EQUAL(digest(), 1174702818u);
}

/* ---- other numbers and tables ------------------------------------------------------------------------ */

static void coordinates_stay_in_their_range(void) {
    static const float ways[] = {0.6307f, -30, 1e30f, 3e38f, -3e38f};
    uint32_t i, v, bits;
    for (i = 0; i < 10; i++) {
        nook_smoothing how = {3, i < 5 ? ways[i] : 1, i < 5 ? -1 : ways[i - 5], false,
                              i % 2 == 0 ? b.mesh.G : NULL};
        if (i == 2) how.lambda = nook_float_from(0x7FC00000u);
        octahedron();
        for (v = 0; v < 6; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], NOOK_MAX_COORDINATE / length_of(v));
        shake(1e6f);
        for (v = 0; v < 6; v++) {
            for (bits = 0; bits < 3; bits++) {
                float *x = nook_axis(&b.mesh.G[v], bits);
                *x = *x > NOOK_MAX_COORDINATE    ? NOOK_MAX_COORDINATE
                     : *x < -NOOK_MAX_COORDINATE ? -NOOK_MAX_COORDINATE
                                                 : *x;
            }
        }
        linked();
        smooth(&how);
        for (v = 0; v < 6; v++) CHECK_EQUAL(nook_point_status(b.mesh.G[v]), NOOK_OK);
    }
}

static void is_refused(nook_status status, nook_kind kind, uint32_t index) {
    nook_smoothing how = taubin;
    uint32_t before = digest();
    CHECK_EQUAL(nook_smooth(&b.mesh, &how, next, &told), status);
    CHECK(told.where.kind == kind && told.where.index == index);
    CHECK_EQUAL(digest(), before);
}

static void what_cannot_be_smoothed_is_named_and_nothing_changed(void) {
    octahedron();
    linked();
    b.mesh.G[4].y = nook_float_from(0xFF800000u);
    is_refused(NOOK_NOT_FINITE, NOOK_AT_VERTEX, 4);
    b.mesh.G[4].y = 2 * NOOK_MAX_COORDINATE;
    is_refused(NOOK_COORDINATE_TOO_LARGE, NOOK_AT_VERTEX, 4);
    octahedron();
    linked();
    b.mesh.C[2] = 24; /* as if there were one triangle more */
    b.mesh.V[24] = 2, b.mesh.V[25] = 0, b.mesh.V[26] = 1;
    b.mesh.O[24] = 24, b.mesh.O[25] = 25, b.mesh.O[26] = 26;
    is_refused(NOOK_BAD_VERTEX_CORNER, NOOK_AT_VERTEX, 2);
    b.mesh.C[2] = b.mesh.C[3];
    is_refused(NOOK_BAD_VERTEX_CORNER, NOOK_AT_VERTEX, 2);
    linked();
    b.mesh.V[5] = 6; /* seen from one of the others of the triangle */
    is_refused(NOOK_BAD_OPPOSITE, NOOK_AT_VERTEX, b.mesh.V[3] < b.mesh.V[4] ? b.mesh.V[3] : b.mesh.V[4]);
    begin_shape(7);
    add(0, 1, 2), add(0, 3, 4);
    linked();
    for (b.mesh.C[0] = 0; b.mesh.V[0] != 0; b.mesh.C[0]++) continue;
    b.mesh.C[3] = b.mesh.C[4] = NOOK_STORED_NONE;
    b.mesh.V[4] = 7; /* of a triangle that no fan shows */
    is_refused(NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, 4);
}

static void tables_of_any_bits_are_smoothed_or_refused(void) {
    uint32_t i, k, refused = 0, rounds = SMALL ? 30 : 3000;
    for (i = 0; i < rounds; i++) {
        const nook_smoothing how = {1, 0.7f, i % 2 == 0 ? 0 : -0.7f, i % 3 == 0, i % 5 == 0 ? old : NULL};
        nook_smooth_state state;
        nook_status status;
        if (i % 4 == 0) torus(4, 3 + i % 3);
        if (i % 4 == 0) linked();
        CHECK_EQUAL(nook_smooth_begin(&state, &b.mesh, &how, next, &told), NOOK_OK);
        do {
            uint32_t units = throw_dice(&d, 300);
            status = nook_smooth_step(&state, &units);
            for (k = throw_dice(&d, 5); k < 2; k++) { /* also between two steps */
                uint32_t at = throw_dice(&d, 3 * b.mesh.nt),
                         to = throw_dice(&d, 4) == 0 ? 0xFFF0 : throw_dice(&d, 80);
                (throw_dice(&d, 2) == 0 ? b.mesh.V : b.mesh.O)[at] = nook_store(to);
            }
        } while (status == NOOK_MORE);
        CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE || status == NOOK_BAD_VERTEX_CORNER ||
              status == NOOK_INDEX_OUT_OF_RANGE);
        refused += status != NOOK_OK;
        for (k = 0; k < b.mesh.nv; k++) CHECK_EQUAL(nook_point_status(b.mesh.G[k]), NOOK_OK);
    }
    CHECK(refused > rounds / 5 && refused < rounds);
}

static void a_call_that_cannot_be_carried_out_says_why(void) {
    nook_smooth_state state;
    CHECK(sizeof state <= 256);
    octahedron();
    linked();
    CHECK_EQUAL(nook_smooth_begin(NULL, &b.mesh, &taubin, next, &told), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_smooth_begin(&state, NULL, &taubin, next, &told), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_smooth_begin(&state, &b.mesh, NULL, next, &told), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_smooth_begin(&state, &b.mesh, &taubin, NULL, &told), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_smooth(&b.mesh, &taubin, next, NULL), NOOK_NULL_ARGUMENT);
    b.mesh.nt = b.mesh.nv = 0;
    smooth(&taubin);
    CHECK(told.volume == 0 && told.gained == 0);
}

static const test tests[] = {
    TEST(all_axes_and_both_passes_are_those_of_two_copies),
    TEST(a_vertex_in_the_middle_stays_and_so_does_a_border),
    TEST(a_border_that_slides_keeps_its_straight_sides),
    TEST(noise_on_a_sphere_goes_and_with_taubin_the_volume_stays),
    TEST(volumes_are_those_that_geometry_measures),
    TEST(a_flat_mesh_never_folds),
    TEST(no_triangle_turns_over_and_nothing_is_carried_off),
    TEST(a_triangle_without_area_may_move_and_get_one),
    TEST(every_machine_slicing_and_corner_of_a_vertex_gives_the_same),
    TEST(coordinates_stay_in_their_range),
    TEST(what_cannot_be_smoothed_is_named_and_nothing_changed),
    TEST(tables_of_any_bits_are_smoothed_or_refused),
    TEST(a_call_that_cannot_be_carried_out_says_why),
};

void test_smooth(void) { run_tests(tests, sizeof tests / sizeof *tests); }
