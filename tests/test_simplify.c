/* test_simplify.c -- fewer triangles: to a count, within a deviation, outside.
 *
 * Of every mesh made here: its tables are whole, and O is what link finds; Euler's number, border loops and components are
 * those from before; no triangle that was sound is degenerate. What deviation says is held against distances both ways. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

enum {
    SMALL = NOOK_TEST_RAM < 2000000,
    RASTER = SMALL ? 2 : 4,
    MOST_KEPT = SMALL ? 128 : 2048,
    KEPT_V = MOST_KEPT + 34
};

static NOOK_MESH_ARRAYS(KEPT_V, MOST_KEPT) kept; /* the mesh before */
static uint32_t kept_nv, kept_nt;
static NOOK_BVH_ARRAYS(MOST_KEPT) tree;
static float deviation[KEPT_V];
static nook_simplify_goal goal;

static uint32_t digest(void) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_digest(&view);
}

static int32_t euler, loops, components;

/* What is there now is what is to be simplified. */
static void keep(void) {
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK(b.mesh.nv <= KEPT_V && b.mesh.nt <= MOST_KEPT);
    kept_nv = b.mesh.nv, kept_nt = b.mesh.nt;
    memcpy(kept.G, b.mesh.G, kept_nv * sizeof *kept.G);
    memcpy(kept.V, b.mesh.V, 3 * kept_nt * sizeof *kept.V);
    memcpy(kept.O, b.mesh.O, 3 * kept_nt * sizeof *kept.O);
    memcpy(kept.C, b.mesh.C, kept_nv * sizeof *kept.C);
    euler = b.result.euler, loops = (int32_t)b.report.survey.border_loops,
    components = (int32_t)b.report.survey.components;
    memset(deviation, 0, sizeof deviation);
    memset(&goal, 0, sizeof goal);
}

static void restore(void) {
    b.mesh.nv = kept_nv, b.mesh.nt = kept_nt;
    memcpy(b.mesh.G, kept.G, kept_nv * sizeof *kept.G);
    memcpy(b.mesh.V, kept.V, 3 * kept_nt * sizeof *kept.V);
    memcpy(b.mesh.O, kept.O, 3 * kept_nt * sizeof *kept.O);
    memcpy(b.mesh.C, kept.C, kept_nv * sizeof *kept.C);
    memset(deviation, 0, sizeof deviation);
}

static nook_simplify_state state;
static nook_status simplify(void) { return nook_simplify(&state, &b.mesh, &goal, NULL); }

static void is_whole(void) {
    uint32_t before = digest();
    nook_view view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_check(&view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_OK);
    CHECK_EQUAL(b.result.bad_indices + b.result.bad_opposites + b.result.bad_corners, 0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(digest(), before);
    CHECK_EQUAL(b.result.manifold, NOOK_YES);
    CHECK_EQUAL(
        b.result.isolated_vertices + b.result.geometry.zero_area_triangles + b.result.duplicate_triangles, 0);
    CHECK_EQUAL(b.result.euler, euler);
    CHECK_EQUAL(b.report.survey.border_loops, loops);
    CHECK_EQUAL(b.report.survey.components, components);
}

/* ---- shapes ----------------------------------------------------------------------------------------- */

static void bumpy_sphere(uint32_t levels) {
    uint32_t v;
    icosphere(levels);
    for (v = 0; v < b.mesh.nv; v++) {
        nook_point p = b.mesh.G[v];
        b.mesh.G[v] = nook_scaled(p, 1 + 0.25f * p.x * p.y + 0.125f * p.z * p.z * p.z);
    }
    keep();
}

static void hills(uint32_t columns, uint32_t rows) {
    uint32_t v;
    grid(columns, rows);
    for (v = 0; v < b.mesh.nv; v++) {
        float x = (float)(v % (columns + 1)), y = (float)(v / (columns + 1));
        place(v, x, y, 0.0625f * x * x - 0.03125f * x * y);
    }
    keep();
}

static void ring_of_eight(void) { /* around, and around the tube */
    static const float cosine[] = {1, 0.70710678f, 0, -0.70710678f, -1, -0.70710678f, 0, 0.70710678f};
    uint32_t v;
    torus(8, 8);
    for (v = 0; v < b.mesh.nv; v++) {
        float r = 2 + cosine[v / 8];
        place(v, r * cosine[v % 8], r * cosine[(v + 6) % 8], cosine[(v / 8 + 6) % 8]);
    }
    keep();
}

static void flat_square(uint32_t side) {
    uint32_t v;
    grid(side, side);
    for (v = 0; v < b.mesh.nv; v++) place(v, (float)(v % (side + 1)), (float)(v / (side + 1)), 3);
    keep();
}

/* ---- to a count ---------------------------------------------------------------------------------------- */

static void comes_to(uint32_t triangles, uint32_t expected) {
    goal.triangles = triangles;
    CHECK_EQUAL(simplify(), NOOK_OK);
    CHECK(b.mesh.nt <= triangles && b.mesh.nt + 2 > triangles);
    is_whole();
    if (!CHECK(digest() == expected)) print_hex(digest());
}

static void every_machine_simplifies_alike(void) {
    bumpy_sphere(2);
    comes_to(40, 0x5741F09Eu);
    ring_of_eight();
    comes_to(64, 0x7BDDC291u);
    hills(8, 8);
    comes_to(31, 0x0A65BD72u);
    cube();
    keep();
    comes_to(6, 0xBACFC71Au);
}

static void counts_are_reached_exactly_where_edges_allow(void) {
    uint32_t n;
    for (n = 128; n - 4 <= 124; n -= SMALL ? 31 : n > 12 ? 11 : 1) {
        bumpy_sphere(2);
        goal.triangles = n;
        CHECK_EQUAL(simplify(), NOOK_OK);
        CHECK_EQUAL(b.mesh.nt, n & ~1u); /* two at a time */
        is_whole();
        hills(8, 8);
        goal.triangles = n;
        CHECK_EQUAL(simplify(), NOOK_OK);
        CHECK(b.mesh.nt == n || b.mesh.nt == n - 1);
        is_whole();
    }
    bumpy_sphere(2);
    goal.triangles = 128;
    CHECK_EQUAL(simplify(), NOOK_OK);
    CHECK(memcmp(b.mesh.G, kept.G, kept_nv * sizeof *kept.G) == 0 && b.mesh.nt == 128);
    b.mesh.nt = 0;
    goal.triangles = 0;
    CHECK_EQUAL(simplify(), NOOK_OK);
}

/* With so many units a call; how many in all. */
static uint32_t slice(uint32_t units_a_call, nook_status expected) {
    uint32_t used = 0;
    nook_status status;
    CHECK_EQUAL(nook_simplify_begin(&state, &b.mesh, &goal, NULL), NOOK_OK);
    do {
        uint32_t units = units_a_call;
        status = nook_simplify_step(&state, &units);
        CHECK(status != NOOK_MORE || units == 0);
        used += units_a_call - units;
    } while (status == NOOK_MORE && used < 1000000);
    CHECK_EQUAL(status, expected);
    return used;
}

static void every_slicing_gives_the_same(void) {
    uint32_t units, whole, all;
    CHECK(sizeof state <= 256);
    bumpy_sphere(2);
    goal.triangles = 20;
    all = slice(1000000, NOOK_OK);
    whole = digest();
    CHECK(all < 66 + 60 * 10);
    for (units = 1; units < 40; units += SMALL ? 30 : 6) {
        restore();
        CHECK_EQUAL(slice(units, NOOK_OK), all);
        CHECK_EQUAL(digest(), whole);
    }
    restore();
    CHECK_EQUAL(simplify(), NOOK_OK);
    CHECK_EQUAL(digest(), whole);
}

static void what_is_flat_stays_so_exactly_enough(void) {
    uint32_t v;
    flat_square(8);
    goal.triangles = 2;
    goal.error = 1e-4f;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
    CHECK_EQUAL(b.mesh.nt, 2);
    for (v = 0; v < 4; v++) {
        nook_point p = b.mesh.G[v], q = nook_make(p.x > 4 ? 8.0f : 0, p.y > 4 ? 8.0f : 0, 3);
        CHECK(nook_length(nook_sub(p, q)) < 1e-5f);
    }
    cube();
    keep();
    CHECK_EQUAL(simplify(), NOOK_OK); /* as far as triangles may turn */
    is_whole();
    CHECK(b.mesh.nt < 12 && b.mesh.nt >= 4);
}

/* Costs are compared as numbers: the mesh is brought near one size before. */
static void a_larger_mesh_becomes_the_same_but_larger(void) {
    static const float sizes[] = {0x1p20f, 0x1p-20f, 0x1p-40f, 0x1p28f};
    static nook_point small[130];
    uint32_t i, v, nv;
    bumpy_sphere(2);
    goal.triangles = 50;
    CHECK_EQUAL(simplify(), NOOK_OK);
    nv = b.mesh.nv;
    memcpy(small, b.mesh.G, nv * sizeof *small);
    for (i = SMALL ? 3 : 0; i < 4; i++) {
        restore();
        for (v = 0; v < kept_nv; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], sizes[i]);
        CHECK_EQUAL(simplify(), NOOK_OK);
        CHECK_EQUAL(b.mesh.nv, nv);
        for (v = 0; v < nv; v++) small[v] = nook_scaled(small[v], sizes[i]);
        CHECK(memcmp(small, b.mesh.G, nv * sizeof *small) == 0);
        for (v = 0; v < nv; v++) small[v] = nook_scaled(small[v], 1 / sizes[i]);
    }
    restore(); /* smaller than that costs are 0, and it is still a mesh */
    for (v = 0; v < kept_nv; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], 0x1p-100f);
    (void)simplify();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.euler, 2);
}

static void no_vertex_goes_beyond_the_largest_coordinate(void) {
    uint32_t v;
    icosphere(2);
    for (v = 0; v < b.mesh.nv; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], NOOK_MAX_COORDINATE);
    keep();
    goal.triangles = 60;
    CHECK_EQUAL(nook_simplify(&state, &b.mesh, &goal, NULL), NOOK_OK);
    CHECK_EQUAL(state.where.kind, NOOK_NOWHERE);
    is_whole();
    for (v = 0; v < b.mesh.nv; v++) CHECK_EQUAL(nook_point_status(b.mesh.G[v]), NOOK_OK);
    (void)simplify();
    goal.triangles = 4; /* until all are tried */
    (void)simplify();
    is_whole();
}

/* ---- deviation ------------------------------------------------------------------------------------------- */

static void plant(nook_bvh *bvh, nook_view *view) {
    CHECK_EQUAL(nook_bvh_build(bvh, view, tree.boxes, tree.order, NULL), NOOK_OK);
}

/* The farthest that corners and places within triangles of one are from the other. */
static float farthest(nook_view *from, nook_view *to) {
    nook_bvh bvh;
    nook_closest closest;
    float most = 0;
    uint32_t t, i, j;
    plant(&bvh, to);
    for (t = 0; t < from->nt; t++) {
        const nook_index *V = from->V + 3 * t;
        for (i = 0; i <= (uint32_t)RASTER; i++) {
            for (j = 0; i + j <= (uint32_t)RASTER; j++) {
                float x = (float)i / (float)RASTER, y = (float)j / (float)RASTER, z = 1 - x - y;
                nook_point p = from->G[V[0]], q = from->G[V[1]], r = from->G[V[2]];
                p = nook_make(x * p.x + y * q.x + z * r.x, x * p.y + y * q.y + z * r.y,
                              x * p.z + y * q.z + z * r.z);
                CHECK_EQUAL(nook_closest_point(&closest, &bvh, p), NOOK_OK);
                if (closest.distance_min > most) most = closest.distance_min;
            }
        }
    }
    return most;
}

static float largest(void) {
    float most = 0;
    uint32_t v;
    for (v = 0; v < b.mesh.nv; v++) {
        CHECK(deviation[v] >= 0);
        if (deviation[v] > most) most = deviation[v];
    }
    return most;
}

static void deviates_no_more_than_it_says(float error) {
    nook_view view, before;
    float most, way;
    goal.deviation = deviation;
    goal.error = error;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_view_init(&before, kept.G, kept.V, kept.O, kept.C, kept_nv, kept_nt), NOOK_OK);
    most = largest();
    CHECK(most <= error);
    way = farthest(&view, &before);
    CHECK(way <= most);
    CHECK(farthest(&before, &view) <= most);
}

static void no_place_is_farther_away_than_deviation_says(void) {
    uint32_t i, last[3] = {129, 129, 129};
    for (i = SMALL ? 2 : 0; i < 4; i++) {
        float error = 0.02f * (float)(1u << 2 * i);
        bumpy_sphere(2);
        deviates_no_more_than_it_says(error);
        CHECK(b.mesh.nt < last[0]);
        last[0] = b.mesh.nt;
        hills(8, 8);
        deviates_no_more_than_it_says(error);
        CHECK(b.mesh.nt < last[1]);
        last[1] = b.mesh.nt;
        ring_of_eight();
        deviates_no_more_than_it_says(error);
        CHECK(b.mesh.nt <= last[2]);
        last[2] = b.mesh.nt;
    }
    CHECK(last[0] < 32 && last[1] < 100 && last[2] < 100);
}

static void on_flat_faces_nothing_deviates(void) {
    uint32_t v;
    bumpy_sphere(2); /* made a box */
    for (v = 0; v < b.mesh.nv; v++) {
        nook_point p = b.mesh.G[v];
        float x = nook_abs(p.x), y = nook_abs(p.y), most = x > y ? x : y;
        if (nook_abs(p.z) > most) most = nook_abs(p.z);
        b.mesh.G[v] = nook_scaled(p, 1 / most);
    }
    keep();
    deviates_no_more_than_it_says(0.001f);
    CHECK(b.mesh.nt < 100);
}

/* A plain with grains of sand: all of its flat parts go before the first of them. */
static void what_deviates_least_goes_first(void) {
    uint32_t v;
    flat_square(8);
    for (v = 20; v < 60; v += 13) b.mesh.G[v].z += 0.004f;
    keep();
    memset(deviation, 0, sizeof deviation);
    goal.deviation = deviation;
    goal.error = 10;
    goal.triangles = 90;
    CHECK_EQUAL(simplify(), NOOK_OK);
    for (v = 0; v < b.mesh.nv; v++) CHECK(deviation[v] < 0.0025f);
}

/* Their numbers were dealt out, and are kept by all that no edge was collapsed to. */
static void deviation_stays_with_its_vertex(void) {
    uint32_t v, w, stayed = 0;
    bumpy_sphere(2);
    for (v = 0; v < kept_nv; v++) deviation[v] = 0.001f * (float)v;
    goal.deviation = deviation;
    goal.error = 10;
    goal.triangles = 90;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
    for (v = 0; v < b.mesh.nv; v++) {
        for (w = 0; w < kept_nv; w++) {
            if (memcmp(&b.mesh.G[v], &kept.G[w], sizeof *kept.G) != 0) continue;
            CHECK(deviation[v] == 0.001f * (float)w);
            stayed++;
        }
    }
    CHECK(stayed > 20 && stayed < b.mesh.nv);
    restore();
    for (v = 0; v < kept_nv; v++) deviation[v] = nook_float_from(0x7FC00000u);
    CHECK_EQUAL(simplify(), NOOK_NO_PLACE);
    CHECK_EQUAL(b.mesh.nt, kept_nt);
}

/* ---- outside ----------------------------------------------------------------------------------------------- */

static void nothing_comes_to_be_outside(void) {
    nook_view view = nook_view_of(&b.mesh);
    nook_bvh bvh;
    uint32_t v;
    plant(&bvh, &view);
    for (v = 0; v < kept_nv; v++) {
        nook_inside inside;
        uint32_t units = 100000;
        CHECK_EQUAL(nook_inside_begin(&inside, &bvh, kept.G[v]), NOOK_OK);
        CHECK_EQUAL(nook_inside_step(&inside, &units), NOOK_OK);
        CHECK(inside.on != NOOK_NONE || inside.winding >= 1);
    }
}

static void what_was_inside_is_inside(void) {
    uint32_t n;
    for (n = 100; n > (SMALL ? 80 : 20); n -= 20) {
        bumpy_sphere(2);
        goal.triangles = n;
        goal.outside = true;
        CHECK_EQUAL(simplify(), NOOK_OK);
        is_whole();
        nothing_comes_to_be_outside();
        ring_of_eight();
        goal.triangles = n;
        goal.outside = true;
        CHECK(simplify() == NOOK_OK || n < 60);
        is_whole();
        nothing_comes_to_be_outside();
    }
    cube();
    keep();
    goal.outside = true;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
    nothing_comes_to_be_outside();
}

static void hull_of_kept_is_convex(void) {
    uint32_t t, v;
    CHECK_EQUAL(b.result.geometry.convex, NOOK_YES);
    for (t = 0; t < b.mesh.nt; t++) {
        const nook_index *V = b.mesh.V + 3 * t;
        for (v = 0; v < kept_nv; v++)
            CHECK(nook_orient3d(&b.mesh.G[V[0]], &b.mesh.G[V[1]], &b.mesh.G[V[2]], &kept.G[v]) <= 0);
    }
}

static void the_hull_of_what_is_outside_a_convex_mesh_has_no_more_triangles(void) {
    uint32_t n;
    for (n = 100; n > (SMALL ? 80 : 10); n -= 15) {
        icosphere(2);
        CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, NULL), NOOK_OK);
        keep();
        goal.triangles = n;
        goal.outside = true;
        CHECK(simplify() == NOOK_OK || n < 60);
        is_whole();
        CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, NULL), NOOK_OK);
        CHECK(b.mesh.nt <= n);
        is_whole();
        hull_of_kept_is_convex();
    }
    CHECK(b.mesh.nt < 60 || SMALL);
}

static void borders_stay_as_they_are_where_outside_is_asked(void) {
    uint32_t v, w, found = 0;
    hills(8, 8);
    goal.outside = true;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
    for (v = 0; v < kept_nv; v++) {
        if (v % 9 != 0 && v % 9 != 8 && v >= 9 && v < 72) continue;
        for (w = 0; w < b.mesh.nv; w++) found += memcmp(&b.mesh.G[w], &kept.G[v], sizeof *kept.G) == 0;
    }
    CHECK_EQUAL(found, 32);
}

/* ---- where it ends ------------------------------------------------------------------------------------------ */

static void ends_for(nook_status reason, uint32_t triangles) {
    goal.triangles = 1;
    CHECK_EQUAL(nook_simplify(&state, &b.mesh, &goal, NULL), reason);
    CHECK(state.where.kind == NOOK_AT_CORNER && state.where.index < 3 * b.mesh.nt);
    CHECK_EQUAL(b.mesh.nt, triangles);
    is_whole();
}

static void a_count_that_cannot_be_reached_is_told_with_the_reason(void) {
    tetrahedron();
    keep();
    ends_for(NOOK_DUPLICATE_TRIANGLE, 4);
    bumpy_sphere(2);
    goal.deviation = deviation;
    ends_for(NOOK_NO_PLACE, 128); /* no deviation at all */
    hub_fan(70, true);            /* the hub has too many to be moved at first, its rim does not */
    keep();
    goal.triangles = 6;
    CHECK_EQUAL(simplify(), NOOK_OK);
    is_whole();
}

static void no_vertex_gets_more_triangles_than_allowed(void) {
    nook_edit edit = {.max_valence = 6};
    nook_view view;
    uint32_t c;
    bumpy_sphere(2);
    CHECK(nook_simplify(&state, &b.mesh, &goal, &edit) == NOOK_OK);
    is_whole();
    view = nook_view_of(&b.mesh);
    for (c = 0; c < 3 * b.mesh.nt; c++) CHECK(nook_valence(&view, c) <= 6);
    CHECK(b.mesh.nt < 128);
}

static void a_point_that_cannot_be_used_is_named_and_nothing_changed(void) {
    bumpy_sphere(2);
    b.mesh.G[7].y = nook_float_from(0x7F800000u);
    CHECK_EQUAL(nook_simplify(&state, &b.mesh, &goal, NULL), NOOK_NOT_FINITE);
    CHECK(state.where.kind == NOOK_AT_VERTEX && state.where.index == 7);
    b.mesh.G[7].y = -0x1p31f;
    CHECK_EQUAL(nook_simplify(&state, &b.mesh, &goal, NULL), NOOK_COORDINATE_TOO_LARGE);
    CHECK(memcmp(b.mesh.V, kept.V, 3 * kept_nt * sizeof *kept.V) == 0);
    CHECK_EQUAL(nook_simplify(&state, NULL, &goal, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_simplify(&state, &b.mesh, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_simplify(NULL, &b.mesh, &goal, NULL), NOOK_NULL_ARGUMENT);
}

/* Tables of other bits, from the start or between two steps: it ends, within its bound, and within the arrays. */
static void spoiled_tables_end(void) {
    dice d = {77};
    uint32_t i, k;
    for (i = 0; i < (SMALL ? 10 : 400); i++) {
        uint32_t limit = 0;
        nook_status status;
        if (i % 2 == 0) {
            bumpy_sphere(i % 3 == 0 ? 1 : 2);
        } else {
            hills(4, 4 + i % 5);
        }
        goal.outside = i % 5 == 0;
        goal.error = 1;
        if (i % 3 == 0) goal.deviation = deviation;
        CHECK_EQUAL(nook_simplify_begin(&state, &b.mesh, &goal, NULL), NOOK_OK);
        do {
            uint32_t units = 50;
            for (k = 0; k < 1 + i % 4; k++) {
                nook_index *table = throw_dice(&d, 3) != 0 ? b.mesh.O : b.mesh.V;
                table[throw_dice(&d, 3 * b.mesh.nt)] =
                    nook_store(throw_dice(&d, i % 7 == 0 ? 65536 : 3 * b.mesh.nt));
                b.mesh.C[throw_dice(&d, b.mesh.nv)] = nook_store(throw_dice(&d, 3 * b.mesh.nt));
            }
            if (limit > 20)
                b.mesh.G[throw_dice(&d, b.mesh.nv)].x = nook_float_from(0x7FC00000u + 0x400000u * (i & 1u));
            status = nook_simplify_step(&state, &units);
        } while (status == NOOK_MORE && ++limit < 4000);
        CHECK(limit < 4000);
    }
}

/* The same mesh with a record as without; back to the first, and forth again. */
static void a_record_takes_every_collapse_back(void) {
    static nook_vertex_split split[SMALL ? 10 : 150];
    nook_levels levels = nook_levels_in(split, sizeof split / sizeof *split);
    uint32_t fine, coarse, units = 1000;
    bumpy_sphere(SMALL ? 1 : 2);
    fine = digest();
    goal.triangles = b.mesh.nt - (SMALL ? 20 : 300);
    CHECK_EQUAL(simplify(), NOOK_OK);
    coarse = digest();
    restore();
    goal.levels = &levels;
    CHECK_EQUAL(simplify(), NOOK_OK);
    CHECK_EQUAL(digest(), coarse);
    CHECK_EQUAL(nook_levels_step(&levels, &b.mesh, kept_nt, NULL, &units), NOOK_OK);
    CHECK_EQUAL(digest(), fine);
    CHECK_EQUAL(nook_levels_step(&levels, &b.mesh, goal.triangles, NULL, &units), NOOK_OK);
    CHECK_EQUAL(digest(), coarse);
    levels = nook_levels_in(split, 2);
    goal.triangles = 0;
    CHECK_EQUAL(simplify(), NOOK_OK); /* as few as can be, with a record of two */
    CHECK_EQUAL(levels.level, 2);
    goal.triangles = 4;
    CHECK_EQUAL(simplify(), NOOK_NO_CAPACITY);
}

static const test tests[] = {
    TEST(every_machine_simplifies_alike),
    TEST(counts_are_reached_exactly_where_edges_allow),
    TEST(every_slicing_gives_the_same),
    TEST(what_is_flat_stays_so_exactly_enough),
    TEST(a_larger_mesh_becomes_the_same_but_larger),
    TEST(no_vertex_goes_beyond_the_largest_coordinate),
    TEST(no_place_is_farther_away_than_deviation_says),
    TEST(on_flat_faces_nothing_deviates),
    TEST(what_deviates_least_goes_first),
    TEST(deviation_stays_with_its_vertex),
    TEST(what_was_inside_is_inside),
    TEST(the_hull_of_what_is_outside_a_convex_mesh_has_no_more_triangles),
    TEST(borders_stay_as_they_are_where_outside_is_asked),
    TEST(a_count_that_cannot_be_reached_is_told_with_the_reason),
    TEST(no_vertex_gets_more_triangles_than_allowed),
    TEST(a_point_that_cannot_be_used_is_named_and_nothing_changed),
    TEST(a_record_takes_every_collapse_back),
    TEST(spoiled_tables_end),
};

void test_simplify(void) { run_tests(tests, sizeof tests / sizeof *tests); }
