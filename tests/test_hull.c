/* test_hull.c -- convex hulls: of points whose hull is known, and of any points, held against what a hull is.
 *
 * Of every hull made here: its tables are whole, and O is what link finds; it is one convex shell without flaw; no point
 * that was given is outside any face; every vertex is a point that was given, and renamed() says which. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

enum { SMALL = NOOK_TEST_RAM < 2000000, MOST_GIVEN = SMALL ? 66 : 2000 };

static nook_point given[MOST_GIVEN];
static uint32_t given_count, renames;
static uint16_t origin[MOST_GIVEN]; /* which of them a vertex is */
static uint8_t color[16];
static float attributes[3 * 16];

static void hear(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    CHECK(user == given && kind == NOOK_AT_VERTEX && to < from);
    origin[to] = origin[from];
    renames++;
}
static const nook_edit listening = {.renamed = hear, .user = given, .max_valence = 3, .no_turn = true};

static void give(float x, float y, float z) { given[given_count++] = nook_make(x, y, z); }

static void take_given(void) {
    uint32_t v;
    begin_shape(given_count);
    memcpy(b.mesh.G, given, given_count * sizeof *given);
    for (v = 0; v < given_count; v++) origin[v] = (uint16_t)v;
    renames = 0;
    b.mesh.nt = 5; /* nobody may ask */
    memset(b.Mt, 0xFF, sizeof b.Mt);
    memset(b.Mv, 0xFF, sizeof b.Mv);
}

static uint64_t most_units(uint64_t n) { return n * n * n / 6 + 8 * n * n + 30 * n + 30; }

/* The hull of what was given, with so many units a call. */
static nook_status slice(uint32_t units_a_call) {
    nook_hull_state state;
    uint64_t used = 0;
    nook_status status;
    take_given();
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, &listening), NOOK_OK);
    do {
        uint32_t units = units_a_call;
        status = nook_hull_step(&state, &units);
        CHECK(status != NOOK_MORE || units == 0);
        used += units_a_call - units;
    } while (status == NOOK_MORE && used <= most_units(given_count));
    CHECK(used <= most_units(given_count));
    return status;
}

static bool same_place(const nook_point *p, const nook_point *q) {
    return p->x == q->x && p->y == q->y && p->z == q->z;
}

static uint32_t digest(void) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_digest(&view);
}

static void no_point_is_outside(void) {
    uint32_t t, i;
    for (t = 0; t < b.mesh.nt && !test_has_failed(); t++) {
        const nook_index *V = b.mesh.V + 3 * t;
        for (i = 0; i < given_count; i++) {
            if (nook_orient3d(&b.mesh.G[V[0]], &b.mesh.G[V[1]], &b.mesh.G[V[2]], &given[i]) > 0)
                CHECK_EQUAL(i, NOOK_NONE);
        }
    }
}

static void is_hull(void) {
    uint32_t before = digest(), v;
    nook_view view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_check(&view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_OK);
    CHECK_EQUAL(b.result.bad_indices + b.result.bad_opposites + b.result.bad_corners, 0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(digest(), before);
    CHECK(nook_is_sound(&b.result) && b.result.simple == NOOK_YES && b.result.isolated_vertices == 0);
    CHECK(b.result.geometry.convex == NOOK_YES);
    CHECK_EQUAL(b.mesh.nt, 2 * b.mesh.nv - 4);
    for (v = 0; v < b.mesh.nv; v++) {
        CHECK(same_place(&b.mesh.G[v], &given[origin[v]]));
        if (v > 0) CHECK(origin[v - 1] < origin[v]);
    }
    no_point_is_outside();
}

static void has_hull_of(uint32_t vertices) {
    nook_where where;
    take_given();
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, &listening, &where), NOOK_OK);
    CHECK_EQUAL(where.kind, NOOK_NOWHERE);
    CHECK_EQUAL(b.mesh.nv, vertices);
    is_hull();
}

static void shuffle_given(dice *d) {
    uint32_t i, k;
    for (i = given_count; i > 1; i--) {
        nook_point keep = given[i - 1];
        k = throw_dice(d, i);
        given[i - 1] = given[k];
        given[k] = keep;
    }
}

/* ---- known hulls ----------------------------------------------------------------------------------- */

static void give_grid(uint32_t x_most, uint32_t y_most, uint32_t z_most) {
    uint32_t x, y, z;
    given_count = 0;
    for (x = 0; x <= x_most; x++) {
        for (y = 0; y <= y_most; y++) {
            for (z = 0; z <= z_most; z++) give((float)x, (float)y, (float)z);
        }
    }
}

static void of_a_grid_only_the_corners_are_left(void) {
    dice d = {7};
    uint32_t i;
    for (i = 0; i < 20; i++) {
        give_grid(1 + i % 3, 3, 2);
        if (i > 2) shuffle_given(&d);
        has_hull_of(8);
        CHECK_EQUAL(b.mesh.nt, 12);
        CHECK(b.result.geometry.signed_volume == 6.0f * (float)(1 + i % 3));
        CHECK_EQUAL(b.result.geometry.flat_edges, 6);
    }
}

static void four_points_are_a_tetrahedron_whichever_way_they_come(void) {
    static const uint8_t order[24][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                         {0, 3, 2, 1}, {1, 0, 2, 3}, {1, 0, 3, 2}, {1, 2, 0, 3}, {1, 2, 3, 0},
                                         {1, 3, 0, 2}, {1, 3, 2, 0}, {2, 0, 1, 3}, {2, 0, 3, 1}, {2, 1, 0, 3},
                                         {2, 1, 3, 0}, {2, 3, 0, 1}, {2, 3, 1, 0}, {3, 0, 1, 2}, {3, 0, 2, 1},
                                         {3, 1, 0, 2}, {3, 1, 2, 0}, {3, 2, 0, 1}, {3, 2, 1, 0}};
    uint32_t i, k;
    for (i = 0; i < 24; i++) {
        for (given_count = 0, k = 0; k < 4; k++) {
            give(order[i][k] == 0, 2 * (order[i][k] == 1), 3 * (order[i][k] == 2));
        }
        has_hull_of(4);
        CHECK_EQUAL(renames, 0);
        CHECK(b.result.geometry.signed_volume == 1.0f);
    }
}

static void points_of_a_convex_shape_are_all_left_as_they_were(void) {
    uint32_t nv, nt;
    icosphere(1);
    nv = given_count = b.mesh.nv;
    nt = b.mesh.nt;
    memcpy(given, b.mesh.G, nv * sizeof *given);
    has_hull_of(nv);
    CHECK_EQUAL(b.mesh.nt, nt);
    CHECK_EQUAL(renames, 0);
    CHECK(memcmp(given, b.mesh.G, nv * sizeof *given) == 0);
}

static void of_points_that_are_equal_one_is_left(void) {
    uint32_t i, v;
    dice d = {3};
    octahedron();
    for (given_count = 0, i = 0; i < 3; i++) {
        for (v = 0; v < 6; v++) give(b.mesh.G[v].x, b.mesh.G[v].y, b.mesh.G[v].z);
        give(0, 0, -0.0f);
    }
    for (i = 0; i < 10; i++) {
        has_hull_of(6);
        CHECK_EQUAL(b.mesh.nt, 8);
        shuffle_given(&d);
    }
}

/* The top and the bottom have as many vertices as fit. */
static void flat_faces_of_many_vertices_stay_convex(void) {
    uint32_t i, wide = MOST_GIVEN / 2 > 200 ? 200 : MOST_GIVEN / 2;
    dice d = {11};
    for (given_count = 0, i = 0; i < wide; i++) {
        give((float)i, (float)(i * i), 0);
        give((float)i, (float)(i * i), 1);
    }
    has_hull_of(2 * wide);
    shuffle_given(&d);
    has_hull_of(2 * wide);
    CHECK(b.result.geometry.flat_edges >= 2 * (wide - 3));
    CHECK_EQUAL(b.result.geometry.convex_edges + b.result.geometry.flat_edges, 6 * wide - 6);
}

static void signs_of_the_smallest_and_of_the_largest_coordinates_are_exact(void) {
    static const float size[] = {1e-45f, 3e-39f, 1e-30f, 1.0f, NOOK_MAX_COORDINATE};
    uint32_t i, v;
    for (i = 0; i < 5; i++) {
        for (given_count = 0, v = 0; v < 8; v++) {
            give(v & 1u ? size[i] : 0, v & 2u ? size[i] : -size[i], v & 4u ? size[i] : 0);
            give(v & 1u ? size[i] : 0, 0, v & 4u ? size[i] : 0); /* on the edge, four of them twice */
        }
        has_hull_of(8);
        CHECK_EQUAL(b.mesh.nt, 12);
    }
    /* A point less than a rounding outside the others, and one just inside. */
    give_grid(1, 1, 1);
    give(0.5f, 0.5f, nook_float_from(0x3F800001u));
    give(0.5f, nook_float_from(0x3F7FFFFFu), 0.25f);
    has_hull_of(9);
    CHECK_EQUAL(origin[8], 8);
    /* One that is far away. */
    give(NOOK_MAX_COORDINATE, NOOK_MAX_COORDINATE, NOOK_MAX_COORDINATE);
    has_hull_of(8);
}

/* ---- any points ------------------------------------------------------------------------------------ */

static void give_by_dice(dice *d, uint32_t n, uint32_t sides) {
    for (given_count = 0; given_count < n;) {
        float x = (float)throw_dice(d, sides), y = (float)throw_dice(d, sides);
        give(x, y, (float)throw_dice(d, sides));
    }
}

/* As the dice of small sides give many points on lines, in planes and at one place. */
static void any_points_have_a_hull_or_are_flat(void) {
    dice d = {5};
    uint32_t i, flat = 0, whole = 0;
    for (i = 0; i < (SMALL ? 150 : 1500) && !test_has_failed(); i++) {
        nook_status status;
        give_by_dice(&d, 3 + throw_dice(&d, 40), 2 + throw_dice(&d, 9));
        status = slice(UINT32_MAX);
        flat += status == NOOK_FLAT_SHELL;
        if (status == NOOK_FLAT_SHELL) continue;
        CHECK_EQUAL(status, NOOK_OK);
        is_hull();
        whole++;
    }
    CHECK(whole > 10 * flat && flat > 0);
}

static void throw_ball(dice *d, uint32_t n, bool sphere) {
    for (given_count = 0; given_count < n;) {
        float x = (float)throw_dice(d, 4001) - 2000, y = (float)throw_dice(d, 4001) - 2000;
        nook_point p = nook_make(x, y, (float)throw_dice(d, 4001) - 2000);
        float length = nook_length(p);
        if (length > 2000 || length < 1) continue;
        given[given_count++] = sphere ? nook_scaled(p, 1.0f / length) : p;
    }
}

static void every_machine_makes_the_same_hull(void) {
    dice d = {17};
    throw_ball(&d, 66, true);
    has_hull_of(66);
    CHECK_EQUAL(digest(), 0xF42A72E7u);
    throw_ball(&d, 66, false);
    CHECK_EQUAL(slice(UINT32_MAX), NOOK_OK);
    is_hull();
    CHECK_EQUAL(digest(), 0xE90C0EC0u);
}

static void large_hulls_are_hulls(void) {
    dice d = {23};
    if (SMALL) {
        skip_test("the points do not fit");
        return;
    }
    throw_ball(&d, MOST_GIVEN, false);
    CHECK_EQUAL(slice(UINT32_MAX), NOOK_OK);
    is_hull();
    throw_ball(&d, MOST_GIVEN, true);
    CHECK_EQUAL(slice(UINT32_MAX), NOOK_OK);
    is_hull();
    CHECK(b.mesh.nv > MOST_GIVEN - 20);
}

static void every_slicing_makes_the_same_hull(void) {
    dice d = {29};
    uint32_t units, uncut;
    throw_ball(&d, 40, false);
    CHECK_EQUAL(slice(UINT32_MAX), NOOK_OK);
    uncut = digest();
    for (units = 1; units < 100; units += 1 + units / 8) {
        CHECK_EQUAL(slice(units), NOOK_OK);
        CHECK_EQUAL(digest(), uncut);
    }
    is_hull();
    take_given();
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(digest(), uncut);
}

static void the_order_of_points_changes_nothing_but_names(void) {
    dice d = {31};
    uint32_t i, vertices = 0;
    float volume = 0;
    throw_ball(&d, 50, false);
    for (i = 0; i < 8; i++) {
        CHECK_EQUAL(slice(UINT32_MAX), NOOK_OK);
        is_hull();
        if (i == 0) volume = b.result.geometry.signed_volume, vertices = b.mesh.nv;
        CHECK(b.result.geometry.signed_volume == volume);
        CHECK_EQUAL(b.mesh.nv, vertices);
        shuffle_given(&d);
    }
}

static void colors_and_attributes_are_those_of_new_triangles(void) {
    const nook_edit edit = {.color = color, .attributes = attributes, .width = 1};
    uint32_t i;
    give_grid(2, 2, 2);
    take_given();
    memset(color, 7, sizeof color);
    for (i = 0; i < 40; i++) attributes[i] = 7;
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, &edit, NULL), NOOK_OK);
    for (i = 0; i < 12; i++) CHECK_EQUAL(color[i], 1);
    for (i = 0; i < 36; i++) CHECK(attributes[i] == 0);
    CHECK(color[12] == 7 && attributes[36] == 7);
}

/* ---- no hull --------------------------------------------------------------------------------------- */

static void is_flat(void) {
    uint32_t v;
    nook_where where;
    take_given();
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, &listening, &where), NOOK_FLAT_SHELL);
    CHECK(where.kind == NOOK_NOWHERE);
    CHECK(b.mesh.nt == 0 && b.mesh.nv == given_count && renames == 0);
    CHECK(memcmp(b.mesh.G, given, given_count * sizeof *given) == 0);
    for (v = 0; v < given_count; v++) CHECK(b.mesh.C[v] == NOOK_STORED_NONE);
}

static void points_that_span_no_volume_are_left_without_triangles(void) {
    uint32_t i;
    for (i = 0; i < 3; i++) { /* a plane across each axis, and a line along it */
        give_grid(i == 0 ? 0 : 4, i == 1 ? 0 : 4, i == 2 ? 0 : 4);
        is_flat();
        give_grid(i == 0 ? 9 : 0, i == 1 ? 9 : 0, i == 2 ? 9 : 0);
        is_flat();
    }
    for (given_count = 0; given_count < 30;) give((float)given_count, 3, (float)(given_count % 5) - 3);
    for (i = 0; i < 30; i++) given[i].y += given[i].x + 2 * given[i].z; /* slanting */
    is_flat();
    for (i = 0; i < 30; i++) given[i] = nook_make(1e-45f, 0.1f, NOOK_MAX_COORDINATE);
    is_flat();
    give_grid(0, 0, 0);
    is_flat();
    give_grid(1, 1, 0);
    for (given_count = 3; given_count > 0; given_count--) is_flat();
    is_flat();
}

static void a_point_that_cannot_be_used_is_named_and_nothing_changed(void) {
    static const uint32_t bits[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x4E800001u, 0xCE800001u};
    static NOOK_MESH_ARRAYS(8, 12) kept;
    uint32_t i, v;
    for (i = 0; i < 15; i++) {
        nook_where where;
        v = i % 8;
        give_grid(1, 1, 1);
        if (i % 3 == 0) given[v].x = nook_float_from(bits[i / 3]);
        if (i % 3 == 1) given[v].y = nook_float_from(bits[i / 3]);
        if (i % 3 == 2) given[v].z = nook_float_from(bits[i / 3]);
        cube();
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        memcpy(b.mesh.G, given, sizeof kept.G);
        memcpy(kept.V, b.mesh.V, sizeof kept.V);
        memcpy(kept.O, b.mesh.O, sizeof kept.O);
        memcpy(kept.C, b.mesh.C, sizeof kept.C);
        CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, &where),
                    i < 9 ? NOOK_NOT_FINITE : NOOK_COORDINATE_TOO_LARGE);
        CHECK(where.kind == NOOK_AT_VERTEX && where.index == v);
        CHECK(b.mesh.nv == 8 && b.mesh.nt == 12 && memcmp(b.mesh.G, given, sizeof kept.G) == 0);
        CHECK(memcmp(kept.V, b.mesh.V, sizeof kept.V) == 0 && memcmp(kept.O, b.mesh.O, sizeof kept.O) == 0 &&
              memcmp(kept.C, b.mesh.C, sizeof kept.C) == 0);
    }
}

static void a_call_that_cannot_be_carried_out_says_why(void) {
    nook_hull_state state;
    nook_where where = nook_at(NOOK_AT_BYTE, 1);
    CHECK(sizeof state <= 256);
    cube();
    b.mesh.max_nt = b.marks.max_nt = 12;
    b.marks.max_nv = 8;
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, NULL), NOOK_OK);
    CHECK_EQUAL(nook_hull_begin(&state, NULL, &b.marks, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, NULL, NULL), NOOK_NULL_ARGUMENT);
    b.mesh.max_nt = 11;
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nt = 12, b.marks.max_nt = 11;
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NO_CAPACITY);
    b.marks.max_nt = 12, b.marks.max_nv = 7;
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, NULL), NOOK_NO_CAPACITY);
    CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, NULL, &where), NOOK_NO_CAPACITY);
    CHECK(where.kind == NOOK_NOWHERE);
    b.marks.Mv = NULL;
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mv = b.Mv, b.marks.Mt = NULL;
    CHECK_EQUAL(nook_hull_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NULL_ARGUMENT);
}

static void two_triangles_less_than_twice_the_points_are_room_enough(void) {
    dice d = {37};
    uint32_t i;
    for (i = 0; i < 20; i++) {
        throw_ball(&d, 4 + i, i % 2 == 0);
        take_given();
        b.mesh.max_nt = b.marks.max_nt = 2 * given_count - 4;
        b.mesh.max_nv = b.marks.max_nv = given_count;
        b.mesh.V[3 * b.mesh.max_nt] = b.mesh.O[3 * b.mesh.max_nt] = b.mesh.C[given_count] = 7;
        CHECK_EQUAL(nook_hull(&b.mesh, &b.marks, &listening, NULL), NOOK_OK);
        CHECK(b.mesh.V[3 * b.mesh.max_nt] == 7 && b.mesh.O[3 * b.mesh.max_nt] == 7 &&
              b.mesh.C[given_count] == 7);
        is_hull();
    }
}

static const test tests[] = {
    TEST(of_a_grid_only_the_corners_are_left),
    TEST(four_points_are_a_tetrahedron_whichever_way_they_come),
    TEST(points_of_a_convex_shape_are_all_left_as_they_were),
    TEST(of_points_that_are_equal_one_is_left),
    TEST(flat_faces_of_many_vertices_stay_convex),
    TEST(signs_of_the_smallest_and_of_the_largest_coordinates_are_exact),
    TEST(any_points_have_a_hull_or_are_flat),
    TEST(every_machine_makes_the_same_hull),
    TEST(large_hulls_are_hulls),
    TEST(every_slicing_makes_the_same_hull),
    TEST(the_order_of_points_changes_nothing_but_names),
    TEST(colors_and_attributes_are_those_of_new_triangles),
    TEST(points_that_span_no_volume_are_left_without_triangles),
    TEST(a_point_that_cannot_be_used_is_named_and_nothing_changed),
    TEST(a_call_that_cannot_be_carried_out_says_why),
    TEST(two_triangles_less_than_twice_the_points_are_room_enough),
};

void test_hull(void) { run_tests(tests, sizeof tests / sizeof *tests); }
