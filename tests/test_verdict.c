/* test_verdict.c -- what the verdict rests on: each field by itself, shells that face the wrong way,
 * at every scale that coordinates allow, and shells beside others that are worse than they.
 *
 * Sizes are powers of two, so that the area and volume of a scaled cube are exact. */
#include "rooms.h"
#include "shapes.h"

static uint32_t told[NOOK_STATUS_COUNT];
static nook_where last[NOOK_STATUS_COUNT];

static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    told[defect]++;
    last[defect] = where;
}
static const nook_finder finder = {hear, NULL};

static uint32_t all_told(void) {
    uint32_t i, n = 0;
    for (i = 0; i < NOOK_STATUS_COUNT; i++) n += told[i];
    return n;
}

static void examine(void) {
    memset(told, 0, sizeof told);
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
}

static void turn_range_over(uint32_t first, uint32_t end) {
    uint32_t t;
    for (t = first; t < end; t++) {
        nook_index keep = b.mesh.V[3 * t];
        b.mesh.V[3 * t] = b.mesh.V[3 * t + 1];
        b.mesh.V[3 * t + 1] = keep;
    }
}

/* The verdict on b.result as it was spoiled; then it is whole again. */
static bool sound_after(void) {
    bool answer = nook_is_sound(&b.result);
    examine();
    CHECK(nook_is_sound(&b.result));
    return answer;
}

static void every_field_that_decides_can_spoil_the_verdict_alone(void) {
    octahedron();
    examine();
    b.result.bad_indices = 1;
    CHECK(!sound_after());
    b.result.bad_opposites = 1;
    CHECK(!sound_after());
    b.result.bad_corners = 1;
    CHECK(!sound_after());
    b.result.bad_coordinates = 1;
    CHECK(!sound_after());
    b.result.repeated_vertex_triangles = 1;
    CHECK(!sound_after());
    b.result.duplicate_triangles = 1;
    CHECK(!sound_after());
    b.result.duplicate_triangles = NOOK_UNKNOWN;
    CHECK(!sound_after());
    b.result.manifold = NOOK_NO;
    CHECK(!sound_after());
    b.result.manifold = NOOK_MAYBE;
    CHECK(!sound_after());
    b.result.watertight = NOOK_NO;
    CHECK(!sound_after());
    b.result.watertight = NOOK_MAYBE;
    CHECK(!sound_after());
    b.result.oriented = NOOK_NO;
    CHECK(!sound_after());
    b.result.oriented = NOOK_MAYBE;
    CHECK(!sound_after());
    b.result.geometry.known = false;
    CHECK(!sound_after());
    b.result.geometry.volume_sign = 0;
    CHECK(!sound_after());
    b.result.geometry.volume_sign = -1;
    CHECK(!sound_after());
    b.result.geometry.inside_out_shells = 1;
    CHECK(!sound_after());
    b.result.geometry.flat_shells = 1;
    CHECK(!sound_after());
    b.result.geometry.zero_area_triangles = 1;
    CHECK(!sound_after());
    b.result.geometry.folded_edges = 1;
    CHECK(!sound_after());
}

static void fields_that_do_not_decide_leave_the_verdict(void) {
    octahedron();
    examine();
    b.result.isolated_vertices = 9;
    b.result.clean = NOOK_NO;
    b.result.simple = NOOK_NO;
    CHECK(sound_after());
}

/* The unit cube at 2^exponent, about the corner at the origin; turned over or not. */
static void scaled_cube(int32_t exponent, bool over) {
    float size = nook_float_from((uint32_t)(127 + exponent) << 23);
    uint32_t v;
    cube();
    for (v = 0; v < 8; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], size);
    if (over) turn_range_over(0, 12);
    examine();
}

/* From a volume of 2^-147, a denormal, to one of 2^90. */
static void a_cube_of_any_size_knows_its_inside(void) {
    int32_t exponent;
    for (exponent = -49; exponent <= 30; exponent++) {
        uint32_t volume =
            exponent < -42 ? (uint32_t)1 << (149 + 3 * exponent) : (uint32_t)(127 + 3 * exponent) << 23;
        scaled_cube(exponent, false);
        CHECK(nook_is_sound(&b.result));
        CHECK_EQUAL(all_told(), 0);
        CHECK_EQUAL(nook_float_bits(b.result.geometry.signed_volume), volume);
        CHECK(b.result.geometry.area == 6.0f * nook_float_from((uint32_t)(127 + 2 * exponent) << 23));
        scaled_cube(exponent, true);
        CHECK(!nook_is_sound(&b.result));
        CHECK(b.result.inside_out == NOOK_YES);
        CHECK_EQUAL(told[NOOK_INSIDE_OUT], 1);
        CHECK_EQUAL(all_told(), 1);
        if (test_has_failed()) break;
    }
}

/* A tetrahedron of three unit edges on the axes, `size` times, at x. */
static void add_tetrahedron(float size, float x) {
    static const uint8_t list[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    uint32_t first = b.mesh.nv, t;
    b.mesh.nv += 4;
    place(first, x, 0, 0);
    place(first + 1, x + size, 0, 0);
    place(first + 2, x, size, 0);
    place(first + 3, x, 0, size);
    for (t = 0; t < 4; t++) add(first + list[t][0], first + list[t][1], first + list[t][2]);
}

static void one_shell_inside_out_is_named_beside_a_larger_one(void) {
    begin_shape(0);
    add_tetrahedron(4, 0);
    add_tetrahedron(1, 10);
    examine();
    CHECK_EQUAL(all_told(), 0);
    CHECK(nook_is_sound(&b.result));
    turn_range_over(4, 8);
    examine();
    CHECK_EQUAL(told[NOOK_INSIDE_OUT], 1);
    CHECK_EQUAL(all_told(), 1);
    CHECK_EQUAL(last[NOOK_INSIDE_OUT].kind, NOOK_AT_TRIANGLE);
    CHECK_EQUAL(last[NOOK_INSIDE_OUT].index, 4);
    CHECK(b.result.inside_out == NOOK_NO); /* the whole is positive: 64 - 1 sixths */
    CHECK(b.shell[1].signed_volume < 0);
}

static void a_small_shell_far_from_a_large_one_keeps_its_sign(void) {
    begin_shape(0);
    add_tetrahedron(1024, -1000000);
    add_tetrahedron(0.5f, 1000000);
    turn_range_over(4, 8);
    examine();
    CHECK_EQUAL(told[NOOK_INSIDE_OUT], 1);
    CHECK_EQUAL(last[NOOK_INSIDE_OUT].index, 4);
    /* -1/48, but about the middle of the box it is what is left of terms near 250,000 */
    CHECK(b.shell[1].signed_volume < -0.015f && b.shell[1].signed_volume > -0.03f);
}

/* A ring of squares, cut in triangles: fans - edges + triangles = 0 and two loops, so genus 0. */
static void add_cylinder(uint32_t columns) {
    uint32_t first = b.mesh.nv, x;
    b.mesh.nv += 2 * columns;
    for (x = 0; x < 2 * columns; x++) place(first + x, (float)(x % 5), (float)(x % 3), (float)x);
    for (x = 0; x < columns; x++) {
        uint32_t low = first + x, next = first + (x + 1) % columns;
        add(low, next, next + columns);
        add(low, next + columns, low + columns);
    }
}

static void a_shell_beside_a_nonmanifold_one_keeps_its_own_loops_and_genus(void) {
    book(3, 0);
    add_cylinder(5);
    examine();
    CHECK_EQUAL(b.shells.count, 2);
    CHECK(b.shell[0].has_nonmanifold_edge);
    CHECK(!b.shell[1].has_nonmanifold_edge);
    CHECK_EQUAL(b.shell[1].border_edges, 10);
    CHECK_EQUAL(b.shell[1].border_loops, 2);
    CHECK_EQUAL(nook_shell_genus(&b.shell[1]), 0);
    CHECK_EQUAL(b.result.survey.border_loops, NOOK_UNKNOWN);
    begin_shape(0);
    add_cylinder(5);
    examine();
    CHECK_EQUAL(b.shell[0].border_loops, 2);
    CHECK_EQUAL(nook_shell_genus(&b.shell[0]), 0);
}

/* Five triangles i, i+1, i+2 around five vertices: the least Moebius strip. */
static void add_moebius_strip(void) {
    uint32_t first = b.mesh.nv, i;
    b.mesh.nv += 5;
    for (i = 0; i < 5; i++) {
        place(first + i, (float)i, (float)(i * i), 1);
        add(first + i, first + (i + 1) % 5, first + (i + 2) % 5);
    }
}

/* The finder hears of every one-sided component. */
static void each_one_sided_component_is_told(void) {
    uint32_t n;
    for (n = 1; n <= 3; n++) {
        uint32_t i;
        begin_shape(0);
        for (i = 0; i < n; i++) add_moebius_strip();
        examine();
        CHECK_EQUAL(told[NOOK_NOT_ORIENTABLE], n);
    }
}

static void a_strip_beside_a_nonmanifold_shell_is_still_not_orientable(void) {
    uint32_t beside;
    for (beside = 0; beside < 2; beside++) {
        const nook_shell *strip = &b.shell[beside];
        if (beside) {
            book(3, 0);
        } else {
            begin_shape(0);
        }
        add_moebius_strip();
        examine();
        CHECK_EQUAL(b.shells.count, 1 + beside);
        CHECK(!strip->has_nonmanifold_edge);
        CHECK(!strip->orientable);
        CHECK_EQUAL(strip->border_edges, 5);
        CHECK_EQUAL(strip->border_loops, 1);
        CHECK_EQUAL(nook_shell_genus(strip), NOOK_UNKNOWN);
    }
}

static void no_room_for_shells_is_room_for_none(void) {
    begin_shape(0);
    add_tetrahedron(1, 0);
    add_tetrahedron(1, 5);
    b.shells.max_shells = 0;
    b.shell[0].triangles = 99;
    examine();
    CHECK_EQUAL(b.shells.count, 0);
    CHECK_EQUAL(b.result.survey.components, 2);
    CHECK_EQUAL(b.shell[0].triangles, 99);
    CHECK(nook_shell_of(&b.shells, 0) == NULL);
    CHECK(nook_shell_of(NULL, 0) == NULL);
    CHECK(nook_is_sound(&b.result));
}

static void the_box_holds_what_triangles_use_and_nothing_else(void) {
    octahedron();
    b.mesh.nv = 8;
    place(6, -50, 70, 1000000);
    place(7, 3, -3, -3);
    examine();
    CHECK(b.result.geometry.box_min.x == -1 && b.result.geometry.box_min.y == -1 &&
          b.result.geometry.box_min.z == -1);
    CHECK(b.result.geometry.box_max.x == 1 && b.result.geometry.box_max.y == 1 &&
          b.result.geometry.box_max.z == 1);
    CHECK_EQUAL(told[NOOK_ISOLATED_VERTEX], 2);
}

static void a_shuffled_surface_keeps_its_verdict_area_and_volume(void) {
    dice d = {1597463007u};
    uint32_t i;
    float area, volume;
    cube();
    examine();
    area = b.result.geometry.area;
    volume = b.result.geometry.signed_volume;
    for (i = 0; i < 50; i++) {
        shuffle(&d);
        examine();
        CHECK(nook_is_sound(&b.result));
        CHECK(b.result.geometry.area == area &&
              b.result.geometry.signed_volume == volume); /* sums of halves: exact */
    }
}

static const test tests[] = {
    TEST(every_field_that_decides_can_spoil_the_verdict_alone),
    TEST(fields_that_do_not_decide_leave_the_verdict),
    TEST(a_cube_of_any_size_knows_its_inside),
    TEST(one_shell_inside_out_is_named_beside_a_larger_one),
    TEST(a_small_shell_far_from_a_large_one_keeps_its_sign),
    TEST(a_shell_beside_a_nonmanifold_one_keeps_its_own_loops_and_genus),
    TEST(a_strip_beside_a_nonmanifold_shell_is_still_not_orientable),
    TEST(each_one_sided_component_is_told),
    TEST(no_room_for_shells_is_room_for_none),
    TEST(the_box_holds_what_triangles_use_and_nothing_else),
    TEST(a_shuffled_surface_keeps_its_verdict_area_and_volume),
};

void test_verdict(void) { run_tests(tests, sizeof tests / sizeof *tests); }
