/* test_core.c -- corners, marks, meshes, statuses, roots, sums and the digest.
 *
 * The operators are compared with what they mean on three generated meshes: a closed octahedron, an
 * open grid with a hole, and one with an isolated vertex and negative zeros. Opposites come from a
 * search over all pairs of corners, square roots are judged by squares of integers, and the digest by
 * a second CRC-32 that takes bit after bit. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

#define NV 64u
#define NT 80u

static NOOK_MESH_ARRAYS(NV, NT) room;
static nook_mesh mesh;
static nook_view view;

static void begin_mesh(void) {
    memset(&room, 0, sizeof room);
    CHECK_EQUAL(nook_mesh_init(&mesh, room.G, room.V, room.O, room.C, NV, NT), NOOK_OK);
}

static void add_vertex(float x, float y, float z) { mesh.G[mesh.nv++] = nook_make(x, y, z); }

static void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
    mesh.V[3u * mesh.nt] = nook_store(a);
    mesh.V[3u * mesh.nt + 1u] = nook_store(b);
    mesh.V[3u * mesh.nt + 2u] = nook_store(c);
    mesh.nt++;
}

static void link_mesh(void) {
    nook_report report;
    nook_where where;
    CHECK_EQUAL(nook_link(&mesh, NULL, NULL, NULL, &report, &where), NOOK_OK);
    view = nook_view_of(&mesh);
}

/* Vertices 2i and 2i + 1 lie on axis i; 8 triangles, 12 edges. */
static void make_octahedron(void) {
    uint32_t i;
    begin_mesh();
    for (i = 0; i < 6u; i++) {
        float s = (i & 1u) != 0 ? -1.0f : 1.0f;
        add_vertex(i / 2u == 0 ? s : 0.0f, i / 2u == 1u ? s : 0.0f, i / 2u == 2u ? s : 0.0f);
    }
    for (i = 0; i < 8u; i++) {
        uint32_t x = i & 1u, y = 2u + (i >> 1 & 1u), z = 4u + (i >> 2);
        if (((i ^ i >> 1 ^ i >> 2) & 1u) == 0) {
            add_triangle(x, y, z);
        } else {
            add_triangle(x, z, y);
        }
    }
    link_mesh();
}

#define COLUMNS 6u
#define ROWS 5u
/* 6 by 5 cells of two triangles in the plane z = 0, seen counter-clockwise from above; cell (2, 2) is
 * a hole. 42 vertices: 22 on the rim, 4 on the hole, 16 inside. */
static void make_grid(void) {
    uint32_t x, y;
    begin_mesh();
    for (y = 0; y <= ROWS; y++) {
        for (x = 0; x <= COLUMNS; x++) add_vertex((float)x, (float)y, 0.0f);
    }
    for (y = 0; y < ROWS; y++) {
        for (x = 0; x < COLUMNS; x++) {
            uint32_t v = y * (COLUMNS + 1u) + x, up = v + COLUMNS + 1u;
            if (x == 2u && y == 2u) continue;
            add_triangle(v, v + 1u, up + 1u);
            add_triangle(up + 1u, up, v);
        }
    }
    link_mesh();
}

/* Two triangles on one edge, a vertex of none, and zeros of both signs. */
static void make_flap(void) {
    begin_mesh();
    add_vertex(0.0f, -0.0f, 1.0e-40f);
    add_vertex(1.0f, 0.1f, -0.0f);
    add_vertex(-7.5f, 1073741824.0f, 3.0f);
    add_vertex(9.0f, 9.0f, 9.0f);
    add_vertex(0.0f, -1.0f, 0.0f);
    add_triangle(0, 1, 2);
    add_triangle(1, 0, 4);
    link_mesh();
}

static bool on_border(uint32_t v) {
    uint32_t x = v % (COLUMNS + 1u), y = v / (COLUMNS + 1u);
    bool rim = x == 0 || x == COLUMNS || y == 0 || y == ROWS;
    return rim || ((x == 2u || x == 3u) && (y == 2u || y == 3u));
}

/* THE CORNER OPERATORS */

static void a_corner_knows_its_triangle(void) {
    uint32_t c, end = 3u * NOOK_MAX_TRIANGLES, step = end / 65535u;
    for (c = 0; c < end && !test_has_failed(); c += step) CHECK_EQUAL(nook_triangle(c), c / 3u);
    for (c = end - 9u; c < end; c++) CHECK_EQUAL(nook_triangle(c), c / 3u);
}

static void next_goes_round_a_triangle_and_prev_goes_back(void) {
    uint32_t c, k;
    for (k = 0; k < 2u; k++) {
        uint32_t first = k == 0 ? 0 : 3u * NOOK_MAX_TRIANGLES - 300u;
        for (c = first; c < first + 300u; c++) {
            uint32_t n = nook_next(c);
            CHECK_EQUAL(n, c % 3u == 2u ? c - 2u : c + 1u);
            CHECK_EQUAL(nook_triangle(n), nook_triangle(c));
            CHECK_EQUAL(nook_next(nook_next(n)), c);
            CHECK_EQUAL(nook_prev(c), nook_next(n));
            CHECK_EQUAL(nook_prev(n), c);
        }
    }
}

/* The corner that faces the same edge from the other side, by looking at all; c itself if none. */
static uint32_t opposite_by_search(uint32_t c) {
    uint32_t o;
    for (o = 0; o < 3u * view.nt; o++) {
        if (view.V[nook_next(o)] == view.V[nook_prev(c)] && view.V[nook_prev(o)] == view.V[nook_next(c)])
            return o;
    }
    return c;
}

static void expect_opposites(uint32_t borders) {
    uint32_t c, found = 0;
    for (c = 0; c < 3u * view.nt; c++) {
        CHECK_EQUAL(nook_opposite(&view, c), opposite_by_search(c));
        CHECK_EQUAL(nook_opposite(&view, nook_opposite(&view, c)), c);
        CHECK((nook_opposite(&view, c) == c) == nook_is_border(&view, c));
        found += nook_is_border(&view, c);
    }
    CHECK_EQUAL(found, borders);
}

static void opposite_is_an_involution_that_a_border_does_not_move(void) {
    make_octahedron();
    expect_opposites(0);
    make_grid();
    expect_opposites(22 + 4);
    make_flap();
    expect_opposites(4);
}

static bool triangle_has(uint32_t t, uint32_t v) {
    return view.V[3u * t] == v || view.V[3u * t + 1u] == v || view.V[3u * t + 2u] == v;
}

static void left_is_the_opposite_of_prev_and_right_that_of_next(void) {
    uint32_t turn, c;
    for (turn = 0; turn < 2u; turn++) {
        if (turn == 0) {
            make_octahedron();
        } else {
            make_grid();
        }
        for (c = 0; c < 3u * view.nt; c++) {
            uint32_t l = nook_left(&view, c), r = nook_right(&view, c);
            uint32_t n = nook_vertex(&view, nook_next(c)), p = nook_vertex(&view, nook_prev(c));
            CHECK_EQUAL(l, view.O[nook_prev(c)]);
            CHECK_EQUAL(r, view.O[nook_next(c)]);
            CHECK(triangle_has(nook_triangle(l), nook_vertex(&view, c)) && triangle_has(nook_triangle(l), n));
            CHECK(triangle_has(nook_triangle(r), nook_vertex(&view, c)) && triangle_has(nook_triangle(r), p));
        }
    }
    make_octahedron();
    /* triangle 0 is (+x +y +z); across +x +y lies 4 = (+x -z +y), across +x +z lies 2 = (+x +z -y) */
    CHECK_EQUAL(nook_triangle(nook_left(&view, 0)), 4);
    CHECK_EQUAL(nook_triangle(nook_right(&view, 0)), 2);
    CHECK_EQUAL(nook_triangle(nook_opposite(&view, 0)), 1);
}

static void a_vertex_has_its_point(void) {
    make_grid();
    CHECK_EQUAL(nook_vertex(&view, 1), 1);
    CHECK_EQUAL(nook_float_bits(nook_point_at(&view, 2).x), nook_float_bits(1.0f));
    CHECK_EQUAL(nook_float_bits(nook_point_at(&view, 2).y), nook_float_bits(1.0f));
    CHECK_EQUAL(nook_float_bits(nook_point_at(&view, 4).y), nook_float_bits(1.0f));
    CHECK_EQUAL(nook_float_bits(nook_point_at(&view, 4).x), 0);
}

/* Follow the swing through all corners; how many orbits, and how many of them keep one vertex. */
static uint32_t count_orbits(uint32_t *stars) {
    static uint8_t seen[3u * NT];
    uint32_t c, s, orbits = 0, hops = 0;
    memset(seen, 0, sizeof seen);
    *stars = 0;
    for (c = 0; c < 3u * view.nt; c++) {
        bool same = true;
        if (seen[c] != 0) continue;
        s = c;
        do {
            CHECK_EQUAL(seen[s], 0);
            seen[s] = 1;
            same = same && view.V[s] == view.V[c];
            s = nook_swing(&view, s);
        } while (s < 3u * view.nt && seen[s] == 0 && hops++ < 3u * view.nt);
        CHECK_EQUAL(s, c); /* else two corners swing to the same one */
        orbits++;
        *stars += same;
    }
    return orbits;
}

static void on_a_closed_mesh_the_swing_keeps_the_vertex(void) {
    uint32_t c, stars;
    make_octahedron();
    for (c = 0; c < 24u; c++) {
        CHECK_EQUAL(nook_vertex(&view, nook_swing(&view, c)), nook_vertex(&view, c));
        CHECK_EQUAL(nook_swing(&view, c), nook_prev(nook_opposite(&view, nook_prev(c))));
    }
    CHECK_EQUAL(count_orbits(&stars), 6);
    CHECK_EQUAL(stars, 6);
}

static void at_borders_the_swing_has_one_orbit_for_each_loop(void) {
    uint32_t c, stars;
    make_grid();
    CHECK_EQUAL(count_orbits(&stars), 16 + 2);
    CHECK_EQUAL(stars, 16);
    for (c = 0; c < 3u * view.nt; c++) {
        uint32_t s = nook_swing(&view, c);
        if (nook_is_border(&view, nook_prev(c))) {
            CHECK_EQUAL(s, nook_next(c));
            CHECK(on_border(nook_vertex(&view, c)) && on_border(nook_vertex(&view, s)));
        } else {
            CHECK_EQUAL(nook_vertex(&view, s), nook_vertex(&view, c));
        }
    }
    make_flap();
    CHECK_EQUAL(count_orbits(&stars), 1);
}

static nook_point centre_of(uint32_t t) {
    nook_point a = nook_point_at(&view, 3u * t), b = nook_point_at(&view, 3u * t + 1u);
    nook_point c = nook_point_at(&view, 3u * t + 2u);
    return nook_scaled(nook_make(a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z), 0.33f);
}

static void the_swing_turns_clockwise(void) {
    uint32_t c;
    make_grid();
    for (c = 0; c < 3u * view.nt; c++) {
        nook_point at = nook_point_at(&view, c), from, to;
        if (nook_is_border(&view, nook_prev(c))) continue;
        at = nook_scaled(at, 0.99f); /* three times 0.33 */
        from = nook_sub(centre_of(nook_triangle(c)), at);
        to = nook_sub(centre_of(nook_triangle(nook_swing(&view, c))), at);
        CHECK(nook_cross(from, to).z < -0.01f);
    }
}

static void nvat_is_the_vertex_after_v_in_t(void) {
    uint32_t t, v, k;
    make_grid();
    for (t = 0; t < view.nt; t++) {
        for (v = 0; v < view.nv; v++) {
            uint32_t corner = NOOK_NONE, next = NOOK_NONE;
            for (k = 0; k < 3u; k++) {
                if (view.V[3u * t + k] != v) continue;
                corner = 3u * t + k;
                next = view.V[3u * t + (k + 1u) % 3u];
            }
            CHECK_EQUAL(nook_corner_in(&view, t, v), corner);
            CHECK_EQUAL(nook_nvat(&view, v, t), next);
            if (corner == NOOK_NONE) CHECK_EQUAL(nook_ntav(&view, t, v), NOOK_NONE);
        }
    }
}

static void ntav_visits_all_triangles_of_a_vertex(void) {
    uint32_t t, v;
    make_grid();
    for (v = 0; v < view.nv; v++) {
        uint32_t valence = 0, ends = 0;
        for (t = 0; t < view.nt; t++) {
            uint32_t next;
            if (!triangle_has(t, v)) continue;
            valence++;
            next = nook_ntav(&view, t, v);
            if (next == NOOK_NONE) {
                ends++;
            } else {
                CHECK(next != t && triangle_has(next, v) && triangle_has(next, nook_nvat(&view, v, t)));
            }
        }
        CHECK(valence > 0);
        CHECK_EQUAL(ends, on_border(v) ? 1 : 0);
        if (!on_border(v)) {
            uint32_t first = nook_triangle(nook_corner_of(&view, v)), turns = 0;
            t = first;
            do {
                t = nook_ntav(&view, t, v);
                turns++;
            } while (t != first && t != NOOK_NONE && turns < 20u);
            CHECK_EQUAL(t, first);
            CHECK_EQUAL(turns, valence);
        }
    }
}

static void a_vertex_has_a_corner_unless_it_has_no_triangle(void) {
    uint32_t v;
    make_grid();
    for (v = 0; v < view.nv; v++) {
        uint32_t c = nook_corner_of(&view, v);
        CHECK(c < 3u * view.nt && nook_vertex(&view, c) == v);
    }
    make_flap();
    for (v = 0; v < view.nv; v++) CHECK((nook_corner_of(&view, v) == NOOK_NONE) == (v == 3u));
}

/* MARKS */

#define MARKED 67u
static uint8_t marks[NOOK_MT_BYTES(MARKED) + 16u];

static void codes_and_bits_do_not_disturb_their_neighbours(void) {
    static uint8_t model[MARKED];
    dice d = {365u};
    uint32_t n, i, k;
    for (n = 1; n <= MARKED; n++) {
        /* the buffer ends where the array ends; what lies before it is guard */
        uint8_t *Mt = marks + sizeof marks - NOOK_MT_BYTES(n);
        uint32_t last = 3u * (n - 1u) / 8u + 1u; /* the second byte read for the last triangle */
        CHECK(NOOK_MT_BYTES(n) > last && NOOK_MT_BYTES(n) <= last + 2u);
        memset(marks, 0x5A, sizeof marks);
        for (i = 0; i < n; i++) {
            nook_set_code(Mt, i, 0);
            model[i] = 0;
        }
        for (k = 0; k < 200u; k++) {
            uint32_t t = throw_dice(&d, n), code = throw_dice(&d, 8), c = throw_dice(&d, 3u * n);
            nook_set_code(Mt, t, code);
            model[t] = (uint8_t)code;
            if ((k & 1u) != 0) {
                nook_set_bit(Mt, c);
                model[c / 3u] = (uint8_t)(model[c / 3u] | 1u << c % 3u);
            } else {
                nook_clear_bit(Mt, c);
                model[c / 3u] = (uint8_t)(model[c / 3u] & ~(1u << c % 3u));
            }
        }
        for (i = 0; i < n; i++) {
            CHECK_EQUAL(nook_code(Mt, i), model[i]);
            for (k = 0; k < 3u; k++) CHECK_EQUAL(nook_bit(Mt, 3u * i + k), (uint32_t)model[i] >> k & 1u);
        }
        for (i = 0; marks + i < Mt; i++) CHECK_EQUAL(marks[i], 0x5A);
    }
}

static void a_bit_for_each_vertex_fits_exactly(void) {
    uint32_t n, i, k;
    CHECK_EQUAL(NOOK_MV_BYTES(0), 0);
    for (n = 1; n <= 8u * 16u; n++) {
        uint8_t *Mv = marks + sizeof marks - NOOK_MV_BYTES(n);
        CHECK_EQUAL(NOOK_MV_BYTES(n), (n + 7u) / 8u);
        memset(marks, 0, sizeof marks);
        nook_set_bit(Mv, n - 1u);
        for (i = 0; i < n; i++) CHECK_EQUAL(nook_bit(Mv, i), i == n - 1u);
        for (i = 0, k = 0; i < sizeof marks; i++) k += marks[i] != 0;
        CHECK_EQUAL(k, 1);
        memset(marks, 0xFF, sizeof marks);
        nook_clear_bit(Mv, n - 1u);
        for (i = 0; i < n; i++) CHECK_EQUAL(nook_bit(Mv, i), i != n - 1u);
    }
}

static void marks_take_less_than_0_45_bytes_a_triangle(void) {
    uint32_t t;
    for (t = 1000; t <= 21844u; t += 2u) {
        CHECK(100u * (NOOK_MT_BYTES(t) + NOOK_MV_BYTES(t / 2u)) <= 45u * t);
        if (test_has_failed()) break;
    }
}

/* STATUSES */

static void every_status_has_a_name_and_a_text_of_its_own(void) {
    uint32_t i, k;
    for (i = 0; i < NOOK_STATUS_COUNT; i++) {
        const char *name = nook_status_name((nook_status)i), *text = nook_status_text((nook_status)i);
        if (!CHECK(name != NULL && text != NULL)) return;
        CHECK(name[0] != '\0' && text[0] != '\0');
        CHECK(strcmp(name, "unknown_status") != 0);
        for (k = 0; name[k] != '\0'; k++) CHECK((name[k] >= 'a' && name[k] <= 'z') || name[k] == '_');
        for (k = 0; k < i; k++) {
            CHECK(strcmp(name, nook_status_name((nook_status)k)) != 0);
            CHECK(strcmp(text, nook_status_text((nook_status)k)) != 0);
        }
    }
    CHECK(strcmp(nook_status_name(NOOK_BORDER_EDGE), "border_edge") == 0);
    CHECK(strcmp(nook_status_text(NOOK_BORDER_EDGE), "edge with a single triangle") == 0);
    CHECK(strcmp(nook_status_text(NOOK_EMPTY_MESH), "no triangles, or no tree over them") == 0);
    CHECK(strcmp(nook_status_name(NOOK_UNKNOWN_FORMAT), "unknown_format") == 0);
    CHECK_EQUAL(NOOK_OK, 0);
}

static void other_numbers_are_unknown_statuses(void) {
    /* as few as eight bits may hold a status */
    static const uint32_t numbers[] = {NOOK_STATUS_COUNT, NOOK_STATUS_COUNT + 1u, 100u, 127u, 255u};
    size_t i;
    for (i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        CHECK(strcmp(nook_status_name((nook_status)numbers[i]), "unknown_status") == 0);
        CHECK(nook_status_text((nook_status)numbers[i]) != NULL);
    }
}

/* MESHES AND VIEWS */

static uint32_t words[16];

static void *odd_place(size_t offset) { return (uint8_t *)words + offset; }

static nook_status init(void *G, void *V, void *O, void *C, uint32_t max_nv, uint32_t max_nt) {
    nook_view v;
    nook_status status, viewed;
    memset(&mesh, 0x77, sizeof mesh);
    status = nook_mesh_init(&mesh, G, V, O, C, max_nv, max_nt);
    viewed = nook_view_init(&v, G, V, O, C, max_nv, max_nt);
    CHECK_EQUAL(viewed, status);
    CHECK(mesh.nv == 0 && mesh.nt == 0);
    if (status == NOOK_OK) {
        CHECK(mesh.G == G && mesh.V == V && mesh.O == O && mesh.C == C);
        CHECK(v.G == G && v.V == V && v.O == O && v.C == C);
        CHECK_EQUAL(mesh.max_nv, max_nv);
        CHECK_EQUAL(mesh.max_nt, max_nt);
        CHECK_EQUAL(v.nv, max_nv);
        CHECK_EQUAL(v.nt, max_nt);
    } else {
        CHECK(mesh.max_nv == 0 && mesh.max_nt == 0);
    }
    return status;
}

static void a_mesh_may_be_as_large_as_its_indices_allow_and_no_larger(void) {
    void *w = words;
    CHECK_EQUAL(init(w, w, w, w, 1, 1), NOOK_OK);
    CHECK_EQUAL(init(w, w, w, w, NOOK_MAX_VERTICES, NOOK_MAX_TRIANGLES), NOOK_OK);
    CHECK_EQUAL(init(w, w, w, w, NOOK_MAX_VERTICES + 1u, 1), NOOK_NO_CAPACITY);
    CHECK_EQUAL(init(w, w, w, w, 1, NOOK_MAX_TRIANGLES + 1u), NOOK_NO_CAPACITY);
    CHECK_EQUAL(init(w, w, w, w, UINT32_MAX, UINT32_MAX), NOOK_NO_CAPACITY);
    CHECK_EQUAL(init(w, w, w, w, 0, UINT32_MAX), NOOK_NO_CAPACITY);
    /* no corner and no vertex is ever "none" */
    CHECK(3u * NOOK_MAX_TRIANGLES - 1u < NOOK_STORED_NONE);
    CHECK(NOOK_MAX_VERTICES - 1u < NOOK_STORED_NONE);
    CHECK_EQUAL(sizeof(nook_index) * 8u, NOOK_INDEX_BITS);
}

static void a_null_array_is_refused_unless_it_holds_nothing(void) {
    void *w = words;
    nook_view v;
    CHECK_EQUAL(init(NULL, w, w, w, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(init(w, NULL, w, w, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(init(w, w, NULL, w, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(init(w, w, w, NULL, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(init(NULL, NULL, NULL, NULL, 0, 0), NOOK_OK);
    CHECK_EQUAL(init(NULL, w, w, NULL, 0, 1), NOOK_OK);
    CHECK_EQUAL(init(w, NULL, NULL, w, 1, 0), NOOK_OK);
    CHECK_EQUAL(init(NULL, w, w, w, 1, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(init(w, w, NULL, w, 0, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_mesh_init(NULL, w, w, w, w, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_view_init(NULL, w, w, w, w, 1, 1), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_view_init(&v, NULL, NULL, NULL, NULL, 0, 0), NOOK_OK);
}

static void a_misaligned_array_is_refused(void) {
    void *w = words;
    size_t offset;
    for (offset = 0; offset < 8u; offset++) {
        void *p = odd_place(offset);
        nook_status of_index = offset % sizeof(nook_index) == 0 ? NOOK_OK : NOOK_MISALIGNED;
        CHECK_EQUAL(init(p, w, w, w, 1, 1), offset % 4u == 0 ? NOOK_OK : NOOK_MISALIGNED);
        CHECK_EQUAL(init(w, p, w, w, 1, 1), of_index);
        CHECK_EQUAL(init(w, w, p, w, 1, 1), of_index);
        CHECK_EQUAL(init(w, w, w, p, 1, 1), of_index);
    }
}

static uint64_t bytes_by_hand(uint32_t nv, uint32_t nt) {
    return (uint64_t)nv * (12u + NOOK_INDEX_BITS / 8u) + (uint64_t)nt * 6u * (NOOK_INDEX_BITS / 8u);
}

static void bytes_of_a_mesh_are_told_by_macro_and_function_alike(void) {
    static const uint32_t sizes[][2] = {{0, 0}, {1, 0},           {0, 1},    {500, 1000},
                                        {1, 1}, {65535u, 21845u}, {3, 10000}};
    size_t i;
    for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        CHECK_EQUAL(NOOK_MESH_BYTES(sizes[i][0], sizes[i][1]), bytes_by_hand(sizes[i][0], sizes[i][1]));
        CHECK_EQUAL(nook_mesh_bytes(sizes[i][0], sizes[i][1]), bytes_by_hand(sizes[i][0], sizes[i][1]));
    }
    {
        struct {
            NOOK_MESH_ARRAYS(500, 1000) a;
        } *none = NULL;
        CHECK_EQUAL(sizeof none->a, NOOK_MESH_BYTES(500, 1000));
    }
}

static void bytes_beyond_the_limits_are_0(void) {
    static const uint32_t big[][2] = {{NOOK_MAX_VERTICES, NOOK_MAX_TRIANGLES},
                                      {NOOK_MAX_VERTICES, 0},
                                      {0, NOOK_MAX_TRIANGLES},
                                      {NOOK_MAX_VERTICES / 4u + 1u, 0},
                                      {NOOK_MAX_VERTICES / 4u + 1000u, NOOK_MAX_TRIANGLES / 2u}};
    size_t i;
    for (i = 0; i < sizeof big / sizeof *big; i++) {
        /* a mesh may have legal indices and yet not fit a 32-bit address space */
        uint64_t expected = bytes_by_hand(big[i][0], big[i][1]), told = nook_mesh_bytes(big[i][0], big[i][1]);
        if (expected > SIZE_MAX) expected = 0;
        CHECK(told == expected);
    }
    CHECK_EQUAL(nook_mesh_bytes(NOOK_MAX_VERTICES + 1u, 1), 0);
    CHECK_EQUAL(nook_mesh_bytes(1, NOOK_MAX_TRIANGLES + 1u), 0);
    CHECK_EQUAL(nook_mesh_bytes(UINT32_MAX, UINT32_MAX), 0);
}

static void a_closed_mesh_takes_19_bytes_a_triangle_or_32(void) {
    uint32_t t;
    for (t = 2; t <= 21844u; t += 2u) {
        CHECK_EQUAL(NOOK_MESH_BYTES(t / 2u, t), (NOOK_INDEX_BITS == 16 ? 19u : 32u) * t);
        if (test_has_failed()) break;
    }
}

/* Append triangles until one is refused; it must have been the one after `room_for`. */
static void expect_room_for(uint32_t room_for, uint32_t max_nv, uint32_t max_nt) {
    static NOOK_MESH_ARRAYS(NV, NT) before;
    nook_mesh last;
    nook_point corners[3];
    uint32_t i, t;
    memset(&room, 0xC3, sizeof room);
    CHECK_EQUAL(nook_mesh_init(&mesh, room.G, room.V, room.O, room.C, max_nv, max_nt), NOOK_OK);
    for (t = 0; t <= room_for; t++) {
        for (i = 0; i < 3u; i++) corners[i] = nook_make((float)t, (float)i, -0.0f);
        memcpy(&before, &room, sizeof room);
        last = mesh;
        if (t == room_for) break;
        CHECK_EQUAL(nook_mesh_append(&mesh, corners), NOOK_OK);
        CHECK_EQUAL(mesh.nt, t + 1u);
        CHECK_EQUAL(mesh.nv, 3u * t + 3u);
    }
    CHECK_EQUAL(nook_mesh_append(&mesh, corners), NOOK_NO_CAPACITY);
    CHECK_EQUAL(memcmp(&room, &before, sizeof room), 0);
    CHECK_EQUAL(mesh.nv, last.nv);
    CHECK_EQUAL(mesh.nt, last.nt);
    for (i = 0; i < 3u * room_for; i++) {
        nook_point expected = nook_make((float)(i / 3u), (float)(i % 3u), -0.0f);
        CHECK_EQUAL(mesh.V[i], i);
        CHECK_EQUAL(memcmp(&mesh.G[i], &expected, sizeof expected), 0);
    }
    for (i = 3u * room_for; i < 3u * NT; i++) CHECK_EQUAL(((uint8_t *)room.V)[i * sizeof *room.V], 0xC3);
    for (i = 3u * room_for; i < NV; i++) CHECK_EQUAL(((uint8_t *)room.G)[i * sizeof *room.G], 0xC3);
}

static void append_fills_a_mesh_to_the_last_place_and_then_refuses(void) {
    expect_room_for(2, 6, 2);
    expect_room_for(2, 6, 20);
    expect_room_for(2, 20, 2);
    expect_room_for(1, 5, 2);
    expect_room_for(1, 6, 1);
    expect_room_for(0, 2, 2);
    expect_room_for(0, 0, 0);
    expect_room_for(21, 63, 21);
}

static void a_point_is_usable_up_to_2_to_the_30(void) {
    static const struct {
        uint32_t bits;
        nook_status status;
    } cases[] = {
        {0, NOOK_OK},
        {0x80000000u, NOOK_OK},
        {1, NOOK_OK},
        {0x807FFFFFu, NOOK_OK},
        {0x3F800000u, NOOK_OK},
        {0x4E7FFFFFu, NOOK_OK},
        {0x4E800000u, NOOK_OK}, /* 2^30 */
        {0xCE800000u, NOOK_OK},
        {0x4E800001u, NOOK_COORDINATE_TOO_LARGE},
        {0xCE800001u, NOOK_COORDINATE_TOO_LARGE},
        {0x7F7FFFFFu, NOOK_COORDINATE_TOO_LARGE},
        {0xFF7FFFFFu, NOOK_COORDINATE_TOO_LARGE},
        {0x7F800000u, NOOK_NOT_FINITE},
        {0xFF800000u, NOOK_NOT_FINITE},
        {0x7F800001u, NOOK_NOT_FINITE},
        {0x7FC00000u, NOOK_NOT_FINITE},
        {0xFFFFFFFFu, NOOK_NOT_FINITE},
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        float x = nook_float_from(cases[i].bits);
        CHECK_EQUAL(nook_point_status(nook_make(x, 1.0f, 2.0f)), cases[i].status);
        CHECK_EQUAL(nook_point_status(nook_make(1.0f, x, 2.0f)), cases[i].status);
        CHECK_EQUAL(nook_point_status(nook_make(1.0f, 2.0f, x)), cases[i].status);
    }
}

/* SQUARE ROOTS AND SUMS */

static bool is_nan(float x) { return (nook_float_bits(x) & 0x7FFFFFFFu) > 0x7F800000u; }

/* |float| = m * 2^e */
static uint32_t mantissa(uint32_t bits, int32_t *e) {
    uint32_t exponent = bits >> 23 & 0xFFu;
    *e = exponent == 0 ? -149 : (int32_t)exponent - 150;
    return (bits & 0x7FFFFFu) | (exponent == 0 ? 0 : 0x800000u);
}

/* Whether root is the float nearest to the square root of x > 0: x lies between the squares of the
 * midpoints on both sides, all as integers of at most 54 bits. */
static bool is_nearest_root(uint32_t x, uint32_t root) {
    int32_t e, q, shift;
    uint64_t m = mantissa(x, &e), r = mantissa(root, &q), below, above;
    if (root < 0x00800000u || root >= 0x7F800000u) return false;
    shift = e - 2 * q + 4; /* x and the squares in units of a quarter step, squared */
    if (shift < 0 || shift > 63 || (m << shift) >> shift != m) return false;
    m <<= shift;
    above = 4u * r + 2u;
    below = r == 0x800000u ? 4u * r - 1u : 4u * r - 2u; /* below a power of two, steps are half as wide */
    return below * below < m && m < above * above;
}

static void a_square_root_by_integers_is_correctly_rounded(void) {
    dice d = {1414u};
    uint32_t i, bits;
    for (i = 0; i < 12000u && !test_has_failed(); i++) {
        float x;
        bits = throw_dice(&d, 0xFFFFFFFFu) >> 1;
        if (i % 4u == 0) bits &= 0x00FFFFFFu;                      /* denormals and the least normals */
        if (i % 4u == 1u) bits = (bits & 0x7F800007u) | 0x7FFFF8u; /* just below a power of two */
        if (i % 4u == 2u) bits &= 0x7F80000Fu;                     /* and just above */
        if (i < 300u) bits = i + 1u;
        if (bits >= 0x7F800000u) bits -= 0x7F000000u;
        if (bits == 0) continue;
        x = nook_float_from(bits);
        CHECK(is_nearest_root(bits, nook_float_bits(nook_sqrt_by_integers(x))));
        CHECK_EQUAL(nook_float_bits(nook_sqrt_by_integers(x)), nook_float_bits(nook_sqrt(x)));
        CHECK(is_nan(nook_sqrt_by_integers(nook_float_from(bits | 0x80000000u))));
        CHECK(is_nan(nook_sqrt(nook_float_from(bits | 0x80000000u))));
    }
}

static void the_root_of_a_square_is_exact(void) {
    uint32_t i;
    for (i = 1; i <= 4096u; i++) {
        float x = (float)i;
        CHECK_EQUAL(nook_float_bits(nook_sqrt_by_integers(x * x)), nook_float_bits(x));
        if (test_has_failed()) break;
    }
}

static void roots_of_zeros_infinities_and_nans(void) {
    static const uint32_t same[] = {0, 0x80000000u, 0x7F800000u};
    static const uint32_t none[] = {0xFF800000u, 0xFF7FFFFFu, 0x80000001u,
                                    0xBF800000u, 0x7FC00000u, 0xFFC12345u};
    size_t i;
    for (i = 0; i < sizeof same / sizeof *same; i++) {
        CHECK_EQUAL(nook_float_bits(nook_sqrt_by_integers(nook_float_from(same[i]))), same[i]);
        CHECK_EQUAL(nook_float_bits(nook_sqrt(nook_float_from(same[i]))), same[i]);
    }
    for (i = 0; i < sizeof none / sizeof *none; i++) {
        CHECK(is_nan(nook_sqrt_by_integers(nook_float_from(none[i]))));
        CHECK(is_nan(nook_sqrt(nook_float_from(none[i]))));
    }
    CHECK_EQUAL(nook_float_bits(nook_sqrt_by_integers(nook_float_from(0x7F7FFFFFu))), 0x5F7FFFFFu);
    CHECK_EQUAL(nook_float_bits(nook_sqrt_by_integers(2.0f)), 0x3FB504F3u);
}

static void vectors_follow_the_right_hand(void) {
    nook_point a = nook_make(1.0f, 2.0f, 3.0f), b = nook_make(-4.0f, 0.5f, 2.0f), c = nook_cross(a, b);
    CHECK_EQUAL(nook_float_bits(c.x), nook_float_bits(2.5f));
    CHECK_EQUAL(nook_float_bits(c.y), nook_float_bits(-14.0f));
    CHECK_EQUAL(nook_float_bits(c.z), nook_float_bits(8.5f));
    CHECK_EQUAL(nook_float_bits(nook_dot(a, b)), nook_float_bits(3.0f));
    CHECK_EQUAL(nook_float_bits(nook_sub(a, b).x), nook_float_bits(5.0f));
    CHECK_EQUAL(nook_float_bits(nook_scaled(a, -2.0f).z), nook_float_bits(-6.0f));
}

static void a_length_neither_overflows_nor_underflows(void) {
    static const uint8_t exact[][4] = {{3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7},   {1, 4, 8, 9},
                                       {4, 4, 7, 9}, {0, 0, 1, 1}, {8, 9, 12, 17}, {0, 5, 12, 13}};
    static const float huge = 3.4028234663852886e38f;
    int32_t power;
    size_t i;
    for (power = -149; power <= 123; power++) {
        float unit = nook_float_from(power < -126 ? 1u << (power + 149) : (uint32_t)(power + 127) << 23);
        for (i = 0; i < sizeof exact / sizeof *exact; i++) {
            nook_point p =
                nook_make((float)exact[i][0] * unit, -(float)exact[i][1] * unit, (float)exact[i][2] * unit);
            CHECK_EQUAL(nook_float_bits(nook_length(p)), nook_float_bits((float)exact[i][3] * unit));
            p = nook_make(p.z, p.x, p.y);
            CHECK_EQUAL(nook_float_bits(nook_length(p)), nook_float_bits((float)exact[i][3] * unit));
            if (test_has_failed()) return;
        }
    }
    CHECK_EQUAL(nook_float_bits(nook_length(nook_make(0.0f, -0.0f, 0.0f))), 0);
    CHECK_EQUAL(nook_float_bits(nook_length(nook_make(0.0f, -huge, 0.0f))), nook_float_bits(huge));
    CHECK(nook_length(nook_make(huge / 2.0f, huge / 2.0f, huge / 2.0f)) > huge / 1.16f);
    CHECK(nook_length(nook_make(huge / 2.0f, huge / 2.0f, huge / 2.0f)) < huge / 1.15f);
    CHECK_EQUAL(nook_float_bits(nook_length(nook_make(huge, 1.0e-45f, 1.0f))), nook_float_bits(huge));
}

static void a_length_is_right_to_three_steps(void) {
    dice d = {3141u};
    uint32_t i;
    for (i = 0; i < 2000u && !test_has_failed(); i++) {
        uint32_t range = 2u << throw_dice(&d, 20), bits;
        uint32_t x = 1u + throw_dice(&d, range), y = throw_dice(&d, range), z = throw_dice(&d, range);
        uint64_t square = (uint64_t)x * x + (uint64_t)y * y + (uint64_t)z * z, r;
        int32_t q;
        bits = nook_float_bits(nook_length(nook_make((float)x, (float)y, -(float)z)));
        r = mantissa(bits, &q);
        if (!CHECK(q <= 0 && q >= -23)) continue;
        square <<= -2 * q;
        CHECK((r - 3u) * (r - 3u) <= square && square <= (r + 3u) * (r + 3u));
    }
}

static void a_sum_keeps_what_rounding_would_lose(void) {
    nook_sum sum = {0.0f, 0.0f};
    uint32_t i;
    nook_add(&sum, 1.0e8f);
    for (i = 0; i < 10000u; i++) nook_add(&sum, 1.0f);
    nook_add(&sum, -1.0e8f);
    CHECK_EQUAL(nook_float_bits(nook_sum_value(&sum)), nook_float_bits(10000.0f));
}

static void a_sum_bears_a_term_larger_than_all_before(void) {
    nook_sum sum = {0.0f, 0.0f};
    uint32_t i;
    nook_add(&sum, 1.0f);
    nook_add(&sum, 1.0e20f);
    nook_add(&sum, 1.0f);
    nook_add(&sum, -1.0e20f);
    CHECK_EQUAL(nook_float_bits(nook_sum_value(&sum)), nook_float_bits(2.0f));

    /* 10,000 times the float 13421773 / 2^27 is 1000.0000149, and 1000 is the nearest float */
    sum.total = sum.lost = 0.0f;
    for (i = 0; i < 10000u; i++) nook_add(&sum, 0.1f);
    CHECK_EQUAL(nook_float_bits(nook_sum_value(&sum)), nook_float_bits(1000.0f));
}

static void random_terms_that_cancel_leave_an_exact_rest(void) {
    static float terms[200];
    dice d = {867u};
    uint32_t turn, i, k;
    for (turn = 0; turn < 50u && !test_has_failed(); turn++) {
        nook_sum sum = {0.0f, 0.0f};
        int32_t rest = 0;
        for (i = 0; i < 200u; i += 2u) {
            int32_t small = (int32_t)throw_dice(&d, 2001) - 1000;
            if (i < 100u) {
                terms[i] = (float)(1u + throw_dice(&d, 4000)) * 1048576.0f;
                terms[i + 1u] = -terms[i];
            } else {
                terms[i] = (float)small;
                terms[i + 1u] = 1.0f;
                rest += small + 1;
            }
        }
        for (i = 199; i > 0; i--) {
            float swapped = terms[i];
            k = throw_dice(&d, i + 1u);
            terms[i] = terms[k];
            terms[k] = swapped;
        }
        for (i = 0; i < 200u; i++) nook_add(&sum, terms[i]);
        CHECK_EQUAL(nook_float_bits(nook_sum_value(&sum) + 0.0f), nook_float_bits((float)rest));
    }
}

/* THE DIGEST */

static uint32_t crc_word(uint32_t crc, uint32_t word) {
    uint32_t i, k;
    for (i = 0; i < 4u; i++) {
        crc ^= word >> 8u * i & 0xFFu;
        for (k = 0; k < 8u; k++) crc = (crc & 1u) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return crc;
}

static uint32_t crc_float(uint32_t crc, float x) {
    uint32_t bits = nook_float_bits(x);
    return crc_word(crc, bits == 0x80000000u ? 0 : bits);
}

static uint32_t digest_by_hand(void) {
    uint32_t crc = 0xFFFFFFFFu, i;
    crc = crc_word(crc, view.nv);
    crc = crc_word(crc, view.nt);
    for (i = 0; i < view.nv; i++) {
        crc = crc_float(crc, view.G[i].x);
        crc = crc_float(crc, view.G[i].y);
        crc = crc_float(crc, view.G[i].z);
    }
    for (i = 0; i < 3u * view.nt; i++) crc = crc_word(crc, view.V[i]);
    for (i = 0; i < 3u * view.nt; i++) crc = crc_word(crc, view.O[i]);
    return ~crc;
}

static void a_digest_is_the_crc_of_the_tables_at_either_width(void) {
    make_octahedron();
    CHECK_EQUAL(nook_digest(&view), digest_by_hand());
    CHECK_EQUAL(nook_digest(&view), 0x404EF142u);
    make_grid();
    CHECK_EQUAL(nook_digest(&view), digest_by_hand());
    CHECK_EQUAL(nook_digest(&view), 0xC987F499u);
    make_flap();
    CHECK_EQUAL(nook_digest(&view), digest_by_hand());
    CHECK_EQUAL(nook_digest(&view), 0xAC6140F0u);
    begin_mesh();
    view = nook_view_of(&mesh);
    CHECK_EQUAL(nook_digest(&view), 0x6522DF69u); /* the CRC-32 of eight zero bytes */
}

static void a_digest_sees_every_change_but_the_sign_of_zero(void) {
    uint32_t digest, i;
    make_octahedron();
    digest = nook_digest(&view);
    mesh.G[0].y = -0.0f;
    CHECK_EQUAL(nook_digest(&view), digest);
    mesh.C[3] = nook_store(nook_swing(&view, mesh.C[3])); /* which corner C names says nothing */
    CHECK_EQUAL(nook_digest(&view), digest);
    for (i = 0; i < 24u; i++) {
        nook_index v = mesh.V[i], o = mesh.O[i];
        mesh.V[i] = nook_store(v ^ 1u);
        CHECK(nook_digest(&view) != digest);
        mesh.V[i] = v;
        mesh.O[i] = nook_store(o + 1u);
        CHECK(nook_digest(&view) != digest);
        mesh.O[i] = o;
    }
    for (i = 0; i < 6u; i++) {
        float z = mesh.G[i].z;
        mesh.G[i].z = nook_float_from(nook_float_bits(z) ^ 1u);
        CHECK(nook_digest(&view) != digest);
        mesh.G[i].z = z;
    }
    CHECK_EQUAL(nook_digest(&view), digest);
}

static const test tests[] = {
    TEST(a_corner_knows_its_triangle),
    TEST(next_goes_round_a_triangle_and_prev_goes_back),
    TEST(opposite_is_an_involution_that_a_border_does_not_move),
    TEST(left_is_the_opposite_of_prev_and_right_that_of_next),
    TEST(a_vertex_has_its_point),
    TEST(on_a_closed_mesh_the_swing_keeps_the_vertex),
    TEST(at_borders_the_swing_has_one_orbit_for_each_loop),
    TEST(the_swing_turns_clockwise),
    TEST(nvat_is_the_vertex_after_v_in_t),
    TEST(ntav_visits_all_triangles_of_a_vertex),
    TEST(a_vertex_has_a_corner_unless_it_has_no_triangle),
    TEST(codes_and_bits_do_not_disturb_their_neighbours),
    TEST(a_bit_for_each_vertex_fits_exactly),
    TEST(marks_take_less_than_0_45_bytes_a_triangle),
    TEST(every_status_has_a_name_and_a_text_of_its_own),
    TEST(other_numbers_are_unknown_statuses),
    TEST(a_mesh_may_be_as_large_as_its_indices_allow_and_no_larger),
    TEST(a_null_array_is_refused_unless_it_holds_nothing),
    TEST(a_misaligned_array_is_refused),
    TEST(bytes_of_a_mesh_are_told_by_macro_and_function_alike),
    TEST(bytes_beyond_the_limits_are_0),
    TEST(a_closed_mesh_takes_19_bytes_a_triangle_or_32),
    TEST(append_fills_a_mesh_to_the_last_place_and_then_refuses),
    TEST(a_point_is_usable_up_to_2_to_the_30),
    TEST(a_square_root_by_integers_is_correctly_rounded),
    TEST(the_root_of_a_square_is_exact),
    TEST(roots_of_zeros_infinities_and_nans),
    TEST(vectors_follow_the_right_hand),
    TEST(a_length_neither_overflows_nor_underflows),
    TEST(a_length_is_right_to_three_steps),
    TEST(a_sum_keeps_what_rounding_would_lose),
    TEST(a_sum_bears_a_term_larger_than_all_before),
    TEST(random_terms_that_cancel_leave_an_exact_rest),
    TEST(a_digest_is_the_crc_of_the_tables_at_either_width),
    TEST(a_digest_sees_every_change_but_the_sign_of_zero),
};

void test_core(void) { run_tests(tests, sizeof tests / sizeof *tests); }
