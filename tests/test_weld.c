/* test_weld.c -- equal vertices become one.
 *
 * Every mesh is welded twice: by the library and by a naive search that compares each vertex with all
 * kept before it. Both must agree on the new vertices, their order, the map and every corner. What
 * must not change is compared byte for byte, and all arrays stand between guards. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

#define NV (NOOK_TEST_RAM < 65536 ? 150u : 600u)
#define NT (2u * NV / 3u)
#define GUARD 0xA5u

/* The arrays of one mesh and weld's own, each exactly as large as needed and followed by a guard. */
static struct {
    nook_point G[NV];
    uint8_t g1[16];
    nook_index V[3u * NT];
    uint8_t g2[16];
    nook_index O[3u * NT];
    uint8_t g3[16];
    nook_index C[NV];
    uint8_t g4[16];
} room, before;
static nook_index map[NV + 8u], order[NV + 8u];
static nook_mesh mesh;

/* What the naive weld makes of it. */
static nook_point good_G[NV];
static nook_index good_V[3u * NT], good_map[NV];
static uint32_t good_nv;

static void begin_mesh(uint32_t max_nv, uint32_t max_nt) {
    memset(&room, (int)GUARD, sizeof room);
    memset(map, (int)GUARD, sizeof map);
    memset(order, (int)GUARD, sizeof order);
    CHECK_EQUAL(nook_mesh_init(&mesh, room.G, room.V, room.O, room.C, max_nv, max_nt), NOOK_OK);
}

static void add_vertex(float x, float y, float z) { mesh.G[mesh.nv++] = nook_make(x, y, z); }

static void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
    mesh.V[3u * mesh.nt] = nook_store(a);
    mesh.V[3u * mesh.nt + 1u] = nook_store(b);
    mesh.V[3u * mesh.nt + 2u] = nook_store(c);
    mesh.nt++;
}

static bool all_guard(const void *bytes, size_t n) {
    const uint8_t *b = bytes;
    while (n-- > 0) {
        if (*b++ != GUARD) return false;
    }
    return true;
}

/* Nothing beyond the vertices and triangles given was written, nor O and C. */
static void expect_guards(uint32_t nv, uint32_t nt) {
    CHECK(all_guard(room.G + nv, (NV - nv) * sizeof *room.G));
    CHECK(all_guard(room.V + 3u * nt, (3u * NT - 3u * nt) * sizeof *room.V));
    CHECK(all_guard(room.g1, sizeof room.g1) && all_guard(room.g2, sizeof room.g2));
    CHECK(all_guard(room.g3, sizeof room.g3) && all_guard(room.g4, sizeof room.g4));
    CHECK(all_guard(map + nv, (NV + 8u - nv) * sizeof *map));
    CHECK(all_guard(order + nv, (NV + 8u - nv) * sizeof *order));
}

static bool same_place(nook_point a, nook_point b) {
    return !(a.x < b.x) && !(a.x > b.x) && !(a.y < b.y) && !(a.y > b.y) && !(a.z < b.z) && !(a.z > b.z);
}

static void weld_naively(void) {
    uint32_t v, k, c;
    good_nv = 0;
    for (v = 0; v < mesh.nv; v++) {
        for (k = 0; k < good_nv && !same_place(good_G[k], mesh.G[v]); k++) continue;
        if (k == good_nv) good_G[good_nv++] = mesh.G[v];
        good_map[v] = nook_store(k);
    }
    for (c = 0; c < 3u * mesh.nt; c++) good_V[c] = good_map[mesh.V[c]];
}

static void expect_naive(uint32_t nv, uint32_t nt) {
    uint32_t v;
    CHECK_EQUAL(mesh.nv, good_nv);
    CHECK_EQUAL(mesh.nt, nt);
    CHECK_EQUAL(memcmp(map, good_map, nv * sizeof *map), 0);
    CHECK_EQUAL(memcmp(mesh.V, good_V, 3u * nt * sizeof *mesh.V), 0);
    for (v = 0; v < good_nv && v < mesh.nv; v++) CHECK(same_place(mesh.G[v], good_G[v]));
    expect_guards(nv, nt);
}

/* Weld the mesh, first in one go, then from the same beginning with one unit at a time. */
static void expect_weld(void) {
    static nook_weld_state state;
    uint32_t nv = mesh.nv, nt = mesh.nt, steps = 0, bound, logarithm = 0;
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    nook_status status;
    before = room;
    weld_naively();
    CHECK_EQUAL(nook_weld(&mesh, map, order, &where), NOOK_OK);
    expect_naive(nv, nt);
    CHECK(all_guard(room.O, sizeof room.O) && all_guard(room.C, sizeof room.C));

    room = before;
    mesh.nv = nv;
    mesh.nt = nt;
    memset(map, (int)GUARD, sizeof map);
    memset(order, (int)GUARD, sizeof order);
    while (1u << logarithm < nv) logarithm++;
    bound = 2u * nv * (logarithm + 4u) + 6u * nt + 16u;
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, map, order), NOOK_OK);
    do {
        uint32_t units = 1;
        status = nook_weld_step(&state, &units);
        CHECK(units <= 1u);
        steps++;
    } while (status == NOOK_MORE && steps <= bound);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK(steps <= bound);
    expect_naive(nv, nt);
}

/* A triangle on every three vertices in turn. */
static void cover_with_triangles(void) {
    uint32_t v;
    for (v = 0; v + 2u < mesh.nv && mesh.nt < mesh.max_nt; v += 2u) add_triangle(v, v + 1u, v + 2u);
}

static void minus_zero_joins_plus_zero(void) {
    uint32_t i;
    begin_mesh(9, 3);
    for (i = 0; i < 8u; i++) {
        add_vertex((i & 1u) != 0 ? -0.0f : 0.0f, (i & 2u) != 0 ? -0.0f : 0.0f, (i & 4u) != 0 ? -0.0f : 0.0f);
    }
    add_vertex(0.0f, 0.0f, 1.0f);
    add_triangle(0, 1, 8);
    add_triangle(2, 8, 7);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 2);
    CHECK_EQUAL(map[7], 0);
    CHECK_EQUAL(map[8], 1);
}

static void nothing_but_equal_coordinates_is_joined(void) {
    begin_mesh(10, 1);
    add_vertex(1.0f, 2.0f, 3.0f);
    add_vertex(nook_float_from(0x3F800001u), 2.0f, 3.0f); /* the next float after 1 */
    add_vertex(1.0f, nook_float_from(0x3FFFFFFFu), 3.0f); /* the last before 2 */
    add_vertex(1.0f, 2.0f, nook_float_from(0x40400001u));
    add_vertex(0.0f, 0.0f, 0.0f);
    add_vertex(nook_float_from(1), 0.0f, 0.0f); /* the least denormals */
    add_vertex(nook_float_from(0x80000001u), 0.0f, 0.0f);
    add_vertex(2.0f, 1.0f, 3.0f);
    add_vertex(-1.0f, -2.0f, -3.0f);
    add_vertex(1.0f, 2.0f, 3.0f);
    add_triangle(9, 8, 7);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 9);
    CHECK_EQUAL(map[9], 0);
    CHECK_EQUAL(mesh.V[0], 0);
}

static void kept_vertices_keep_the_order_of_their_first_occurrence(void) {
    static const float xs[] = {5, 3, 5, 9, 3, 1, 9, 0, 5, 1};
    static const uint32_t expected_map[] = {0, 1, 0, 2, 1, 3, 2, 4, 0, 3};
    static const float kept[] = {5, 3, 9, 1, 0};
    uint32_t i;
    begin_mesh(10, 2);
    for (i = 0; i < 10u; i++) add_vertex(xs[i], 1.0f, -xs[i]);
    add_triangle(9, 0, 1);
    add_triangle(2, 4, 7);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 5);
    for (i = 0; i < 10u; i++) CHECK_EQUAL(map[i], expected_map[i]);
    for (i = 0; i < 5u; i++) CHECK(same_place(mesh.G[i], nook_make(kept[i], 1.0f, -kept[i])));
    CHECK_EQUAL(mesh.V[0], 3);
    CHECK_EQUAL(mesh.V[5], 4);
}

static void an_empty_mesh_stays_empty(void) {
    nook_mesh none;
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    begin_mesh(4, 2);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 0);
    begin_mesh(3, 0);
    add_vertex(1.0f, 1.0f, 1.0f);
    add_vertex(1.0f, 1.0f, 1.0f);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 1);
    CHECK_EQUAL(nook_mesh_init(&none, NULL, NULL, NULL, NULL, 0, 0), NOOK_OK);
    CHECK_EQUAL(nook_weld(&none, map, order, &where), NOOK_OK);
    CHECK_EQUAL(none.nv, 0);
}

static void vertices_that_are_all_equal_become_one(void) {
    static const uint32_t counts[] = {1, 2, 3, 64, 65, NV > 511u ? 511 : 127, NV};
    size_t i;
    for (i = 0; i < sizeof counts / sizeof *counts; i++) {
        uint32_t v;
        begin_mesh(NV, NT);
        for (v = 0; v < counts[i]; v++) add_vertex(-1.5f, 1073741824.0f, 2.5e-40f);
        cover_with_triangles();
        expect_weld();
        CHECK_EQUAL(mesh.nv, 1);
    }
}

static void vertices_that_all_differ_stay_as_they_are(void) {
    uint32_t turn, v;
    for (turn = 0; turn < 4u; turn++) {
        begin_mesh(NV, NT);
        for (v = 0; v < NV; v++) {
            uint32_t i = turn == 1u ? NV - v : turn == 2u ? v * 7919u % 601u : v;
            if (turn == 3u) {
                add_vertex(0.0f, 0.0f, (float)(i ^ 1u) - 300.0f);
            } else {
                add_vertex((float)i - 300.0f, 1.0f, 2.0f);
            }
        }
        cover_with_triangles();
        expect_weld();
        CHECK_EQUAL(mesh.nv, NV);
        CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    }
}

static void sorted_reversed_and_shuffled_grids_are_welded_alike(void) {
    dice d = {271828u};
    uint32_t turn, v, i;
    for (turn = 0; turn < 24u && !test_has_failed(); turn++) {
        uint32_t n = turn < 3u ? NV : 1u + throw_dice(&d, NV), side = 1u + throw_dice(&d, 9);
        begin_mesh(NV, NT);
        for (v = 0; v < n; v++) {
            i = turn == 0 ? v / 2u : turn == 1u ? (NV - v) / 3u : throw_dice(&d, side * side * side);
            add_vertex((float)(i % side) - 1.0f, (float)(i / side % side) * -0.5f,
                       (float)(i / side / side) * 0.1f);
        }
        for (i = throw_dice(&d, NT); i > 0; i--) {
            add_triangle(throw_dice(&d, n), throw_dice(&d, n), throw_dice(&d, n));
        }
        expect_weld();
    }
}

static void isolated_vertices_are_welded_too(void) {
    begin_mesh(6, 1);
    add_vertex(4.0f, 4.0f, 4.0f);
    add_vertex(0.0f, 0.0f, 0.0f);
    add_vertex(4.0f, 4.0f, 4.0f);
    add_vertex(1.0f, 0.0f, 0.0f);
    add_vertex(0.0f, 1.0f, 0.0f);
    add_vertex(4.0f, 4.0f, 4.0f);
    add_triangle(1, 3, 4);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 4);
    CHECK_EQUAL(mesh.V[0], 1);
    CHECK_EQUAL(mesh.V[2], 3);
}

static void a_weld_again_changes_nothing(void) {
    dice d = {1618u};
    uint32_t v, nv;
    begin_mesh(NV, NT);
    for (v = 0; v < NV; v++) add_vertex((float)throw_dice(&d, 8), (float)throw_dice(&d, 8), 0.0f);
    cover_with_triangles();
    expect_weld();
    nv = mesh.nv;
    begin_mesh(NV, NT);
    for (v = 0; v < good_nv; v++) add_vertex(good_G[v].x, good_G[v].y, good_G[v].z);
    cover_with_triangles();
    expect_weld();
    CHECK_EQUAL(mesh.nv, nv);
    for (v = 0; v < nv; v++) CHECK_EQUAL(map[v], v);
}

/* WHAT IS REFUSED */

static void expect_refusal(nook_status expected, nook_kind kind, uint32_t index) {
    static nook_weld_state state;
    uint32_t nv = mesh.nv, nt = mesh.nt, steps = 0;
    nook_where where = nook_at(NOOK_NOWHERE, 77);
    nook_status status;
    before = room;
    CHECK_EQUAL(nook_weld(&mesh, map, order, &where), expected);
    CHECK_EQUAL(where.kind, kind);
    CHECK_EQUAL(where.index, index);
    CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    CHECK(mesh.nv == nv && mesh.nt == nt);

    status = nook_weld_begin(&state, &mesh, map, order);
    while ((status == NOOK_OK || status == NOOK_MORE) && steps++ < 20000u) {
        uint32_t units = 1;
        status = nook_weld_step(&state, &units);
        if (status == NOOK_OK) break;
    }
    CHECK_EQUAL(status, expected);
    CHECK_EQUAL(state.where.kind, kind);
    CHECK_EQUAL(state.where.index, index);
    CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    CHECK(mesh.nv == nv && mesh.nt == nt);
}

static void make_strip(void) {
    uint32_t v;
    begin_mesh(NV, NT);
    for (v = 0; v < 50u; v++) add_vertex((float)(v / 4u), 0.0f, (float)(v % 2u));
    cover_with_triangles();
}

static void an_index_out_of_range_is_refused_and_nothing_changed(void) {
    uint32_t c;
    for (c = 0; c < 72u; c++) {
        make_strip();
        mesh.V[c] = nook_store(c % 3u == 0 ? mesh.nv : c % 3u == 1u ? NOOK_NONE : mesh.nv + 1u);
        expect_refusal(NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
        if (test_has_failed()) break;
    }
}

static void a_bad_coordinate_is_refused_and_nothing_changed(void) {
    static const uint32_t bad[] = {0x7FC00000u, 0xFF800001u, 0x7F800000u, 0xFF800000u,
                                   0x4E800001u, 0xCE800001u, 0x7F7FFFFFu};
    uint32_t i;
    for (i = 0; i < 7u * 21u && !test_has_failed(); i++) {
        uint32_t bits = bad[i % 7u], axis = i % 3u, v = i / 3u;
        float x = nook_float_from(bits);
        make_strip();
        if (axis == 0) mesh.G[v].x = x;
        if (axis == 1u) mesh.G[v].y = x;
        if (axis == 2u) mesh.G[v].z = x;
        expect_refusal(i % 7u < 4u ? NOOK_NOT_FINITE : NOOK_COORDINATE_TOO_LARGE, NOOK_AT_VERTEX, v);
    }
}

static void the_vertex_of_no_triangle_is_examined_too(void) {
    begin_mesh(4, 1);
    add_vertex(0.0f, 0.0f, 0.0f);
    add_vertex(1.0f, 0.0f, 0.0f);
    add_vertex(0.0f, 1.0f, 0.0f);
    add_vertex(0.0f, nook_float_from(0x7FC00000u), 0.0f);
    add_triangle(0, 1, 2);
    expect_refusal(NOOK_NOT_FINITE, NOOK_AT_VERTEX, 3);
}

static void null_arguments_are_refused(void) {
    static nook_weld_state state;
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    make_strip();
    before = room;
    CHECK_EQUAL(nook_weld(NULL, map, order, &where), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld(&mesh, NULL, order, &where), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld(&mesh, map, NULL, &where), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld_begin(NULL, &mesh, map, order), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld_begin(&state, NULL, map, order), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, NULL, order), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, map, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    CHECK_EQUAL(nook_weld(&mesh, map, order, NULL), NOOK_OK);
}

/* UNITS */

static void units_left_over_are_handed_back(void) {
    static nook_weld_state state;
    uint32_t units = 1000000, used, some, total = 0;
    nook_status status;
    make_strip();
    before = room;
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, map, order), NOOK_OK);
    CHECK_EQUAL(nook_weld_step(&state, &units), NOOK_OK);
    used = 1000000u - units;
    CHECK(used > 0 && used <= 1000000u);

    room = before;
    mesh.nv = 50;
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, map, order), NOOK_OK);
    do {
        some = 7;
        status = nook_weld_step(&state, &some);
        total += 7u - some;
        if (status == NOOK_MORE) CHECK_EQUAL(some, 0);
    } while (status == NOOK_MORE && total < 100000u);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(total, used);
}

static void no_units_do_no_work(void) {
    static nook_weld_state state;
    uint32_t units = 0, i;
    make_strip();
    before = room;
    CHECK_EQUAL(nook_weld_begin(&state, &mesh, map, order), NOOK_OK);
    for (i = 0; i < 5u; i++) CHECK_EQUAL(nook_weld_step(&state, &units), NOOK_MORE);
    CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    CHECK_EQUAL(mesh.nv, 50);
}

static void the_state_of_a_weld_is_at_most_256_bytes(void) {
    CHECK(sizeof(nook_weld_state) <= 256u);
    CHECK_EQUAL(NOOK_WELD_SCRATCH(123), 123);
}

/* DEGENERATE TRIANGLES */

static void triangles_with_a_repeated_vertex_are_dropped_and_the_others_keep_their_order(void) {
    static const uint32_t given[9][3] = {{0, 0, 1}, {0, 1, 2}, {3, 1, 3}, {2, 2, 2}, {2, 1, 0},
                                         {4, 3, 2}, {5, 4, 4}, {5, 4, 3}, {1, 1, 0}};
    static const uint32_t kept[] = {1, 4, 5, 7};
    uint32_t t, i;
    begin_mesh(6, 9);
    for (i = 0; i < 6u; i++) add_vertex((float)i, 0.0f, 0.0f);
    for (t = 0; t < 9u; t++) add_triangle(given[t][0], given[t][1], given[t][2]);
    before = room;
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 5);
    CHECK_EQUAL(mesh.nt, 4);
    CHECK_EQUAL(mesh.nv, 6);
    for (t = 0; t < 4u; t++) {
        for (i = 0; i < 3u; i++) CHECK_EQUAL(mesh.V[3u * t + i], given[kept[t]][i]);
    }
    CHECK_EQUAL(memcmp(room.G, before.G, sizeof room.G), 0);
    CHECK(all_guard(room.V + 27, 16) && all_guard(room.O, sizeof room.O) && all_guard(room.C, sizeof room.C));
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 0);
    CHECK_EQUAL(mesh.nt, 4);
}

static void a_mesh_may_lose_all_its_triangles_or_have_none(void) {
    uint32_t t;
    begin_mesh(2, 5);
    add_vertex(0.0f, 0.0f, 0.0f);
    add_vertex(1.0f, 0.0f, 0.0f);
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 0);
    for (t = 0; t < 5u; t++) add_triangle(t & 1u, 1, 1u - (t & 1u));
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 5);
    CHECK_EQUAL(mesh.nt, 0);
    CHECK_EQUAL(mesh.nv, 2);
}

static void random_triangles_are_dropped_as_a_plain_loop_would(void) {
    dice d = {60221u};
    uint32_t turn, t, i, kept;
    for (turn = 0; turn < 20u && !test_has_failed(); turn++) {
        begin_mesh(NV, NT);
        for (i = 0; i < 5u; i++) add_vertex((float)i, 0.0f, 0.0f);
        kept = 0;
        for (t = throw_dice(&d, NT + 1u); t > 0; t--) {
            uint32_t a = throw_dice(&d, 5), b = throw_dice(&d, 5), c = throw_dice(&d, 5);
            add_triangle(a, b, c);
            if (a == b || b == c || c == a) continue;
            good_V[kept++] = nook_store(a);
            good_V[kept++] = nook_store(b);
            good_V[kept++] = nook_store(c);
        }
        t = mesh.nt;
        CHECK_EQUAL(nook_drop_degenerate(&mesh), t - kept / 3u);
        CHECK_EQUAL(3u * mesh.nt, kept);
        CHECK_EQUAL(memcmp(mesh.V, good_V, kept * sizeof *good_V), 0);
    }
}

/* FROM SOUP TO MESH */

static void an_octahedron_given_as_soup_has_six_vertices_again(void) {
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    uint32_t i, k;
    begin_mesh(24, 8);
    for (i = 0; i < 8u; i++) {
        float x = (i & 1u) != 0 ? -1.0f : 1.0f, y = (i & 2u) != 0 ? -1.0f : 1.0f;
        float z = (i & 4u) != 0 ? -1.0f : 1.0f;
        nook_point corners[3];
        bool even = x * y * z > 0.0f; /* an odd number of mirrors turns a triangle round */
        corners[0] = nook_make(x, 0.0f, 0.0f);
        corners[even ? 1 : 2] = nook_make(0.0f * x, y, 0.0f);
        corners[even ? 2 : 1] = nook_make(0.0f, 0.0f * y, z);
        CHECK_EQUAL(nook_mesh_append(&mesh, corners), NOOK_OK);
    }
    CHECK_EQUAL(mesh.nv, 24);
    expect_weld();
    CHECK_EQUAL(mesh.nv, 6);
    CHECK_EQUAL(mesh.nt, 8);
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 0);
    {
        nook_report report;
        CHECK_EQUAL(nook_link(&mesh, NULL, NULL, NULL, &report, &where), NOOK_OK);
        CHECK_EQUAL(report.matched_edges, 12);
        CHECK_EQUAL(report.edges, 12);
    }
    for (i = 0; i < 6u; i++) {
        for (k = 0; k < i; k++) CHECK(!same_place(mesh.G[i], mesh.G[k]));
    }
}

static void a_triangle_that_shrinks_to_an_edge_is_dropped_after_the_weld(void) {
    static const nook_point whole[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const nook_point thin[3] = {{1, 0, 0}, {0, 1, 0}, {1, -0.0f, 0}};
    nook_where where = nook_at(NOOK_NOWHERE, 0);
    begin_mesh(9, 3);
    CHECK_EQUAL(nook_mesh_append(&mesh, thin), NOOK_OK);
    CHECK_EQUAL(nook_mesh_append(&mesh, whole), NOOK_OK);
    CHECK_EQUAL(nook_mesh_append(&mesh, thin), NOOK_OK);
    CHECK_EQUAL(nook_weld(&mesh, map, order, &where), NOOK_OK);
    CHECK_EQUAL(mesh.nv, 3);
    CHECK_EQUAL(mesh.nt, 3);
    CHECK_EQUAL(nook_drop_degenerate(&mesh), 2);
    CHECK_EQUAL(mesh.nt, 1);
    CHECK(mesh.V[0] == 2u && mesh.V[1] == 0 && mesh.V[2] == 1u);
}

static const test tests[] = {
    TEST(minus_zero_joins_plus_zero),
    TEST(nothing_but_equal_coordinates_is_joined),
    TEST(kept_vertices_keep_the_order_of_their_first_occurrence),
    TEST(an_empty_mesh_stays_empty),
    TEST(vertices_that_are_all_equal_become_one),
    TEST(vertices_that_all_differ_stay_as_they_are),
    TEST(sorted_reversed_and_shuffled_grids_are_welded_alike),
    TEST(isolated_vertices_are_welded_too),
    TEST(a_weld_again_changes_nothing),
    TEST(an_index_out_of_range_is_refused_and_nothing_changed),
    TEST(a_bad_coordinate_is_refused_and_nothing_changed),
    TEST(the_vertex_of_no_triangle_is_examined_too),
    TEST(null_arguments_are_refused),
    TEST(units_left_over_are_handed_back),
    TEST(no_units_do_no_work),
    TEST(the_state_of_a_weld_is_at_most_256_bytes),
    TEST(triangles_with_a_repeated_vertex_are_dropped_and_the_others_keep_their_order),
    TEST(a_mesh_may_lose_all_its_triangles_or_have_none),
    TEST(random_triangles_are_dropped_as_a_plain_loop_would),
    TEST(an_octahedron_given_as_soup_has_six_vertices_again),
    TEST(a_triangle_that_shrinks_to_an_edge_is_dropped_after_the_weld),
};

void test_weld(void) { run_tests(tests, sizeof tests / sizeof *tests); }
