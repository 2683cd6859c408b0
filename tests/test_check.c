/* test_check.c -- nook_check: for every kind of defect a mesh that must fail with exactly that code and
 * place, and the same mesh without it; tables with flipped bits and with garbage; measures against
 * formulas. */
#include "oracle.h"
#include "rooms.h"

static dice d = {88675123u};

/* The findings of one run: how many, and the last place, of each kind. */
static uint32_t found[NOOK_STATUS_COUNT];
static nook_where place_of[NOOK_STATUS_COUNT];

static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    found[defect]++;
    place_of[defect] = where;
}
static const nook_finder finder = {hear, NULL};

static void forget(void) { memset(found, 0, sizeof found); }

static nook_status check_as_it_is(const nook_report *report) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_check(&view, &b.marks, report, report != NULL ? &b.shells : NULL, &finder, &b.result);
}

static uint32_t all_found(void) {
    uint32_t i, n = 0;
    for (i = 0; i < NOOK_STATUS_COUNT; i++) n += found[i];
    return n;
}

/* Exactly this was found, this often, here. */
static void only(nook_status defect, uint32_t times, nook_kind kind, uint32_t index) {
    CHECK_EQUAL(found[defect], times);
    CHECK_EQUAL(all_found(), times);
    CHECK_EQUAL(place_of[defect].kind, kind);
    CHECK_EQUAL(place_of[defect].index, index);
    CHECK(!nook_is_sound(&b.result));
}

static void is_sound(void) {
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(all_found(), 0);
    CHECK(nook_is_sound(&b.result));
}

static bool close_to(float got, float expected, float relative) {
    float off = got - expected, limit = relative * (expected < 0 ? -expected : expected);
    return off <= limit && off >= -limit;
}

/* ---- one defect each ----------------------------------------------------------------------------- */

static void closed_surfaces_of_any_genus_are_sound(void) {
    tetrahedron();
    is_sound();
    CHECK_EQUAL(b.result.simple, NOOK_YES);
    octahedron();
    is_sound();
    cube();
    is_sound();
    icosphere(2);
    is_sound();
    CHECK_EQUAL(b.result.euler, 2);
}

static void a_missing_triangle_shows_three_border_edges(void) {
    octahedron();
    b.mesh.nt--;
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_BORDER_EDGE], 3);
    CHECK_EQUAL(all_found(), 3);
    CHECK(!nook_is_sound(&b.result));
    CHECK_EQUAL(b.result.watertight, NOOK_NO);
    CHECK_EQUAL(b.result.even, NOOK_NO);
    CHECK_EQUAL(b.result.manifold, NOOK_YES);
    CHECK_EQUAL(b.result.inside_out, NOOK_MAYBE);
}

static void a_turned_triangle_shows_three_incoherent_edges(void) {
    octahedron();
    turn_over(0);
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_INCOHERENT_EDGE], 3);
    CHECK_EQUAL(all_found(), 3);
    CHECK_EQUAL(place_of[NOOK_INCOHERENT_EDGE].index, 2);
    CHECK(!nook_is_sound(&b.result));
    CHECK_EQUAL(b.result.oriented, NOOK_NO);
    CHECK_EQUAL(b.result.watertight, NOOK_YES);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_YES);
    CHECK_EQUAL(b.result.simple, NOOK_YES);
}

static void two_shells_that_touch_at_a_vertex_are_a_nonmanifold_vertex(void) {
    shapes[13].build();
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    only(NOOK_NONMANIFOLD_VERTEX, 1, NOOK_AT_VERTEX, 3);
    CHECK_EQUAL(b.result.edge_manifold, NOOK_YES);
    CHECK_EQUAL(b.result.manifold, NOOK_NO);
    CHECK_EQUAL(b.result.watertight, NOOK_YES);
    shapes[14].build(); /* the same apart from each other */
    is_sound();
}

static void a_third_triangle_on_an_edge_is_not_edge_manifold(void) {
    octahedron();
    b.mesh.nv = 7;
    place(6, 5, 5, 5);
    add(2, 4, 6);
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_NONMANIFOLD_EDGE], 1);
    CHECK_EQUAL(place_of[NOOK_NONMANIFOLD_EDGE].index, 0);
    CHECK_EQUAL(b.result.edge_manifold, NOOK_NO);
    CHECK_EQUAL(b.result.manifold, NOOK_NO);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_MAYBE);
    CHECK_EQUAL(b.result.survey.border_loops, NOOK_UNKNOWN);
    CHECK(!nook_is_sound(&b.result));
}

static void back_to_back_triangles_are_duplicates(void) {
    shapes[11].build();
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_DUPLICATE_TRIANGLE], 1);
    CHECK_EQUAL(place_of[NOOK_DUPLICATE_TRIANGLE].index, 1);
    CHECK_EQUAL(found[NOOK_FOLDED_EDGE], 3);
    CHECK_EQUAL(found[NOOK_FLAT_SHELL], 1);
    CHECK_EQUAL(all_found(), 5);
    CHECK_EQUAL(b.result.manifold, NOOK_YES);
}

static void an_unused_vertex_is_isolated_and_does_not_spoil_the_verdict(void) {
    octahedron();
    b.mesh.nv = 7;
    place(6, 99, 99, 99);
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_ISOLATED_VERTEX], 1);
    CHECK_EQUAL(place_of[NOOK_ISOLATED_VERTEX].index, 6);
    CHECK_EQUAL(all_found(), 1);
    CHECK_EQUAL(b.result.clean, NOOK_NO);
    CHECK_EQUAL(b.result.euler, 2);
    CHECK(b.result.geometry.box_max.x == 1);
    CHECK(nook_is_sound(&b.result));
}

static void a_moebius_strip_is_not_orientable(void) {
    shapes[8].build();
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_NOT_ORIENTABLE], 1);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_NO);
    CHECK_EQUAL(b.result.manifold, NOOK_YES);
    CHECK_EQUAL(b.result.survey.border_loops, 1);
    shapes[7].build(); /* its twin without the twist */
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_NOT_ORIENTABLE], 0);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_YES);
}

static void an_inside_out_shell_has_negative_volume(void) {
    uint32_t t;
    cube();
    for (t = 0; t < b.mesh.nt; t++) turn_over(t);
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    only(NOOK_INSIDE_OUT, 1, NOOK_AT_TRIANGLE, 0);
    CHECK_EQUAL(b.result.inside_out, NOOK_YES);
    CHECK(b.result.geometry.signed_volume == -1.0f);
    CHECK(b.shell[0].signed_volume == -1.0f);
    forget(); /* without shells it is told once for the whole */
    {
        nook_view view = nook_view_of(&b.mesh);
        CHECK_EQUAL(nook_check(&view, &b.marks, &b.report, NULL, &finder, &b.result), NOOK_OK);
    }
    only(NOOK_INSIDE_OUT, 1, NOOK_AT_TRIANGLE, 0);
}

static void a_mesh_without_triangles_is_empty_and_not_sound(void) {
    begin_shape(2);
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(found[NOOK_EMPTY_MESH], 1);
    CHECK_EQUAL(found[NOOK_ISOLATED_VERTEX], 2);
    CHECK_EQUAL(b.result.manifold, NOOK_NO);
    CHECK_EQUAL(b.result.watertight, NOOK_NO);
    CHECK_EQUAL(b.result.edge_manifold, NOOK_YES);
    CHECK_EQUAL(b.result.oriented, NOOK_YES);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_YES);
    CHECK_EQUAL(b.result.survey.border_loops, 0);
    CHECK(b.result.geometry.area == 0);
    CHECK(!nook_is_sound(&b.result));
}

/* ---- numbers and tables that cannot be used -------------------------------------------------------- */

static void a_coordinate_that_is_no_number_names_its_vertex(void) {
    static const uint32_t bits[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u,
                                    0x4E800001u, 0xCE800001u, 0x7F800001u};
    uint32_t i;
    for (i = 0; i < 18; i++) {
        float x = nook_float_from(bits[i / 3]);
        nook_status expected = i / 3 == 3 || i / 3 == 4 ? NOOK_COORDINATE_TOO_LARGE : NOOK_NOT_FINITE;
        octahedron();
        if (i % 3 == 0) b.mesh.G[4].x = x;
        if (i % 3 == 1) b.mesh.G[4].y = x;
        if (i % 3 == 2) b.mesh.G[4].z = x;
        forget();
        CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
        only(expected, 1, NOOK_AT_VERTEX, 4);
        CHECK_EQUAL(b.result.bad_coordinates, 1);
        CHECK_EQUAL(b.result.geometry.known, false);
        CHECK_EQUAL(b.result.manifold, NOOK_YES);
    }
    octahedron();
    b.mesh.G[4].z = NOOK_MAX_COORDINATE;
    is_sound();
}

static void an_index_out_of_range_names_its_corner(void) {
    uint32_t c;
    for (c = 0; c < 24; c++) {
        octahedron();
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        b.mesh.V[c] = 6;
        forget();
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
        only(NOOK_INDEX_OUT_OF_RANGE, 1, NOOK_AT_CORNER, c);
        CHECK_EQUAL(b.result.manifold, NOOK_MAYBE);
        CHECK_EQUAL(b.shells.count, 0);
    }
}

static void a_repeated_vertex_names_its_triangle(void) {
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.mesh.V[9] = b.mesh.V[11];
    forget();
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(found[NOOK_REPEATED_VERTEX], 1);
    CHECK_EQUAL(place_of[NOOK_REPEATED_VERTEX].index, 3);
    CHECK_EQUAL(b.result.clean, NOOK_NO);
    CHECK(!nook_is_sound(&b.result));
}

/* Every single bit of a table, one after the other; the report is of the whole table. counter, if
 * given, must say so. */
static void flip_every_bit_of(nook_index *table, uint32_t entries, const uint32_t *counter) {
    uint32_t i, bit;
    for (i = 0; i < entries; i++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit++) {
            nook_index keep = table[i];
            table[i] = (nook_index)(keep ^ (nook_index)((nook_index)1u << bit));
            CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
            CHECK(!nook_is_sound(&b.result));
            CHECK(counter == NULL || *counter > 0);
            CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
            CHECK(!nook_is_sound(&b.result));
            table[i] = keep;
        }
    }
}

static void any_flipped_bit_of_O_is_a_bad_opposite(void) {
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    flip_every_bit_of(b.mesh.O, 24, &b.result.bad_opposites);
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK(nook_is_sound(&b.result));
}

static void a_flipped_bit_of_C_is_a_bad_corner_or_another_corner_of_the_vertex(void) {
    uint32_t v, bit;
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    for (v = 0; v < 6; v++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit++) {
            nook_index keep = b.mesh.C[v], other = (nook_index)(keep ^ (nook_index)((nook_index)1u << bit));
            bool harmless = other < 24 && b.mesh.V[other] == v;
            b.mesh.C[v] = other;
            forget();
            CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
            CHECK_EQUAL(b.result.bad_corners, harmless ? 0 : 1);
            CHECK_EQUAL(nook_is_sound(&b.result), harmless);
            if (!harmless) only(NOOK_BAD_VERTEX_CORNER, 1, NOOK_AT_VERTEX, v);
            b.mesh.C[v] = keep;
        }
        b.mesh.C[v] = NOOK_STORED_NONE; /* hides that the vertex is used */
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
        CHECK_EQUAL(b.result.bad_corners, 1);
        b.mesh.C[v] = nook_store(0);
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
        CHECK_EQUAL(b.result.bad_corners, b.mesh.V[0] != v);
        CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    }
}

static void any_flipped_bit_of_V_spoils_the_verdict(void) {
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    flip_every_bit_of(b.mesh.V, 24, NULL);
}

/* ---- garbage --------------------------------------------------------------------------------------- */

/* Check in small steps what may be anything; it ends within its bound. */
static void ends_in_time(const nook_report *report) {
    nook_check_state state;
    nook_view view = nook_view_of(&b.mesh);
    nook_status status;
    uint32_t spent = 0, units, bound = 60 * view.nt + 20 * view.nv + 200;
    CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, report, &b.shells, NULL, &b.result), NOOK_OK);
    do {
        units = 7;
        status = nook_check_step(&state, &units);
        spent += 7 - units;
    } while (status == NOOK_MORE && spent <= bound);
    CHECK(status == NOOK_OK);
    CHECK(spent <= bound);
}

static void every_O_of_one_triangle_ends_in_time_and_only_the_right_one_is_whole(void) {
    uint32_t i, k, whole = 0;
    begin_shape(3);
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    for (i = 0; i < 125; i++) {
        uint32_t rest = i;
        for (k = 0; k < 3; k++, rest /= 5)
            b.mesh.O[k] = rest % 5 == 4 ? NOOK_STORED_NONE : nook_store(rest % 5);
        ends_in_time(NULL);
        whole += b.result.bad_opposites == 0;
        CHECK(b.result.bad_opposites == 0 || b.result.survey.components == NOOK_UNKNOWN);
    }
    CHECK_EQUAL(whole, 1);
}

static void every_O_of_two_triangles_ends_in_time(void) {
    uint32_t i, k, whole = 0;
    begin_shape(4);
    add(0, 1, 2);
    add(2, 1, 3);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    for (i = 0; i < 262144; i += NOOK_TEST_RAM < 2000000 ? 61 : 7) {
        uint32_t rest = i;
        for (k = 0; k < 6; k++, rest >>= 3)
            b.mesh.O[k] = rest % 8 == 7 ? NOOK_STORED_NONE : nook_store(rest % 8);
        ends_in_time(NULL);
        whole += b.result.bad_opposites == 0;
        if (test_has_failed()) return;
    }
    CHECK(whole <= 2); /* joined, or not */
}

static void tables_of_garbage_end_in_time(void) {
    uint32_t i, k;
    for (i = 0; i < 4000 && !test_has_failed(); i++) {
        uint32_t nt = 1 + throw_dice(&d, 12), nv = 1 + throw_dice(&d, 9), wild = throw_dice(&d, 3);
        begin_shape(nv);
        b.mesh.nt = nt;
        memset(&b.report, 0, sizeof b.report);
        b.report.triangles = nt;
        for (k = 0; k < 3 * nt; k++) {
            b.mesh.V[k] = nook_store(throw_dice(&d, wild == 1 ? 65536u : nv));
            b.mesh.O[k] = nook_store(throw_dice(&d, wild == 2 ? 65536u : 3 * nt));
        }
        for (k = 0; k < nv; k++) b.mesh.C[k] = nook_store(throw_dice(&d, wild == 0 ? 3 * nt : 65536u));
        ends_in_time(i % 2u ? &b.report : NULL);
        CHECK(!nook_is_sound(&b.result));
    }
}

/* ---- reports ------------------------------------------------------------------------------------------ */

static void without_a_report_what_O_cannot_tell_is_unknown(void) {
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.edges, NOOK_UNKNOWN);
    CHECK_EQUAL(b.result.duplicate_triangles, NOOK_UNKNOWN);
    CHECK_EQUAL(b.result.manifold, NOOK_MAYBE);
    CHECK_EQUAL(b.result.watertight, NOOK_MAYBE);
    CHECK_EQUAL(b.result.oriented, NOOK_MAYBE);
    CHECK_EQUAL(b.result.euler_known, false);
    CHECK_EQUAL(b.result.survey.components, 1);
    CHECK(!nook_is_sound(&b.result));
}

static void a_defective_mesh_linked_without_marks_stays_unknown(void) {
    octahedron();
    turn_over(0);
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(b.result.incoherent_edges, 3);
    CHECK_EQUAL(b.result.survey.components, NOOK_UNKNOWN);
    CHECK_EQUAL(b.result.manifold, NOOK_MAYBE);
    CHECK_EQUAL(b.shells.count, 0);
}

/* The report of a whole tetrahedron, and as many triangles with a hole and one apart. */
static void a_report_that_does_not_fit_the_tables_is_not_believed(void) {
    nook_report whole;
    uint32_t i;
    tetrahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    whole = b.report;
    tetrahedron();
    b.mesh.nv = 7;
    b.mesh.nt = 3;
    add(4, 5, 6);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(&whole), NOOK_OK);
    CHECK_EQUAL(b.result.edges, NOOK_UNKNOWN);
    CHECK(!nook_is_sound(&b.result));
    tetrahedron();
    for (i = 0; i < 6; i++) { /* nor is one of which a single count is off */
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        b.report.edges += i == 0;
        b.report.border_edges += i == 1;
        b.report.matched_edges += i == 2;
        b.report.incoherent_edges += i == 3;
        b.report.nonmanifold_edges += i == 4;
        b.report.odd_edges += i == 5;
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
        CHECK_EQUAL(b.result.manifold, NOOK_MAYBE);
    }
    /* Nor one whose counts add up only because sums wrap around, or that has an edge of no corner. */
    for (i = 0; i < 6; i++) {
        nook_report *r = &b.report;
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        if (i == 1 || i >= 4) r->incoherent_edges = 1;
        if (i == 1) r->border_edges = r->odd_edges = 0u - 2u;
        if (i == 2) r->matched_edges += 0x80000000u;
        if (i == 3) r->incoherent_edges = 0x80000000u;
        if (i == 4) r->nonmanifold_edges = 0xAAAAAAAAu;
        r->edges = r->border_edges + r->matched_edges + r->incoherent_edges + r->nonmanifold_edges;
        if (i == 0) r->edges = NOOK_UNKNOWN;
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
        CHECK_EQUAL(b.result.edges, NOOK_UNKNOWN);
        CHECK_EQUAL(b.result.manifold, NOOK_MAYBE);
    }
}

/* One triangle: three corners alone are too few for a border edge and an edge of three. */
static void a_report_with_more_edges_than_lone_corners_is_not_believed(void) {
    begin_shape(3);
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    b.report.border_edges = b.report.nonmanifold_edges = 1;
    b.report.edges = b.report.odd_edges = 2;
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(b.result.edges, NOOK_UNKNOWN);
}

/* A sphere and a torus have the Euler number of one sphere. */
static void a_sphere_beside_a_torus_is_not_simple(void) {
    static const uint8_t list[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    uint32_t i, first;
    torus(5, 6);
    first = b.mesh.nv;
    b.mesh.nv += 4;
    for (i = 0; i < 12; i += 3) add(first + list[i], first + list[i + 1], first + list[i + 2]);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.euler, 2);
    CHECK_EQUAL(b.result.manifold, NOOK_YES);
    CHECK_EQUAL(b.result.simple, NOOK_NO);
    CHECK_EQUAL(b.result.handles, 1);
}

static void numbers_of_no_surface_give_no_handles(void) {
    octahedron();
    turn_over(0); /* then what the triangles form is taken from the report */
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.handles, 0);
    b.report.survey.fans--;
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(b.result.handles, NOOK_UNKNOWN);
    b.report.survey.fans += 3;
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(b.result.handles, NOOK_UNKNOWN);
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.handles, NOOK_UNKNOWN);
    CHECK_EQUAL(b.result.patch, NOOK_MAYBE);
}

/* A count of shells larger than their room, as a flipped bit makes it. */
static void shells_beyond_their_room_are_not_touched(void) {
    begin_shape(6);
    add(0, 1, 2);
    add(0, 1, 2);
    add(3, 4, 5);
    b.shells.max_shells = 1;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    memset(&b.shell[1], 0x77, sizeof b.shell[1]);
    b.shells.count = 2;
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK_EQUAL(b.shells.count, 1);
    CHECK_EQUAL(b.shell[1].volume.word[0], 0x77777777u);
}

static void shells_one_by_one_must_not_be_inside_out(void) {
    uint32_t t;
    shapes[14].build();
    for (t = 0; t < 4; t++) turn_over(t); /* the smaller of the two */
    forget();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    only(NOOK_INSIDE_OUT, 1, NOOK_AT_TRIANGLE, 0);
    CHECK_EQUAL(b.result.inside_out, NOOK_NO);
    CHECK_EQUAL(b.result.geometry.inside_out_shells, 1);
    b.shells.count = 1000; /* garbage from the caller */
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    CHECK(b.shells.count <= b.shells.max_shells);
}

static void a_volume_of_nothing_is_flat_and_not_inside_out(void) {
    nook_view view;
    shapes[11].build(); /* two triangles back to back */
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    forget();
    CHECK_EQUAL(nook_check(&view, &b.marks, &b.report, NULL, &finder, &b.result), NOOK_OK);
    CHECK(b.result.geometry.signed_volume == 0);
    CHECK_EQUAL(b.result.inside_out, NOOK_NO);
    CHECK_EQUAL(found[NOOK_FLAT_SHELL], 1);
    CHECK_EQUAL(found[NOOK_FOLDED_EDGE], 3);
    CHECK_EQUAL(all_found(), 4);
}

/* O alone: where every corner is paired there is a volume; what kind of edges there are stays unknown. */
static void without_a_report_a_whole_O_has_a_volume_and_no_more(void) {
    cube();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK(b.result.geometry.signed_volume == 1);
    CHECK_EQUAL(b.result.geometry.convex, NOOK_YES);
    CHECK_EQUAL(b.result.inside_out, NOOK_MAYBE);
    CHECK_EQUAL(b.result.watertight, NOOK_MAYBE);
    CHECK(!nook_is_sound(&b.result));
    b.mesh.nt = 11; /* the hole is all that the last one leaves */
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.geometry.volume_sign, 0);
    CHECK_EQUAL(nook_volume_sign(&b.result.geometry.volume), 0);
    CHECK_EQUAL(b.result.geometry.convex, NOOK_MAYBE);
    b.mesh.nt = 0;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.geometry.convex, NOOK_MAYBE);
}

/* Marks that change while a check runs: any answer, but in time and in bounds. */
static void marks_spoiled_on_the_way_end_in_time(void) {
    uint32_t i;
    for (i = 0; i < 400 && !test_has_failed(); i++) {
        nook_check_state state;
        nook_view view;
        nook_status status;
        uint32_t units, steps = 0;
        icosphere(1);
        CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_OK);
        view = nook_view_of(&b.mesh);
        CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, &b.report, &b.shells, NULL, &b.result),
                    NOOK_OK);
        do {
            units = 3;
            status = nook_check_step(&state, &units);
            b.Mt[throw_dice(&d, (uint32_t)NOOK_MT_BYTES(32))] =
                (uint8_t)(i % 4u == 0    ? 0
                          : i % 4u == 1u ? 0xFF
                                         : throw_dice(&d, 256));
        } while (status == NOOK_MORE && ++steps < 2000);
        CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    }
}

static void a_report_of_another_mesh_and_missing_arguments_are_refused(void) {
    nook_check_state state;
    nook_view view;
    uint32_t units = 9;
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    b.report.triangles++;
    CHECK_EQUAL(check_as_it_is(&b.report), NOOK_NO_CAPACITY);
    b.marks.max_nv = 5;
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_NO_CAPACITY);
    b.marks.max_nv = 6;
    b.marks.max_nt = 7;
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_NO_CAPACITY);
    b.marks.max_nt = 8;
    CHECK_EQUAL(check_as_it_is(NULL), NOOK_OK);
    CHECK_EQUAL(nook_check_begin(&state, NULL, &b.marks, NULL, NULL, NULL, &b.result), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_check_begin(&state, &view, NULL, NULL, NULL, NULL, &b.result), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, NULL, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_check_begin(NULL, &view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_NULL_ARGUMENT);
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_NULL_ARGUMENT);
    b.marks.Mt = b.Mt;
    b.marks.Mv = NULL;
    CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, NULL, NULL, NULL, &b.result), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_check_step(&state, &units), NOOK_BAD_OPPOSITE);
    CHECK_EQUAL(units, 9);
}

/* ---- truth values on every surface --------------------------------------------------------------------- */

static oracle expected;

static void derived_properties_follow_the_oracle_on_all_surfaces(void) {
    uint32_t i;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        const nook_report *r = &expected.report;
        bool closed, manifold;
        shapes[i].build();
        if (i % 2u) b.mesh.nv++; /* an isolated vertex more */
        judge(&expected);
        closed = r->border_edges == 0 && r->nonmanifold_edges == 0;
        manifold = r->nonmanifold_edges == 0 && r->survey.nonmanifold_vertices == 0;
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK_EQUAL(b.result.edge_manifold, r->nonmanifold_edges == 0);
        CHECK_EQUAL(b.result.manifold, manifold);
        CHECK_EQUAL(b.result.watertight, closed);
        CHECK_EQUAL(b.result.even, r->odd_edges == 0);
        CHECK_EQUAL(b.result.oriented, r->incoherent_edges == 0);
        CHECK_EQUAL(b.result.clean, i % 2u == 0);
        CHECK_EQUAL(b.result.isolated_vertices, i % 2u);
        CHECK_EQUAL(b.result.euler, expected.used_vertices - r->edges + r->triangles);
        CHECK_EQUAL(b.result.simple, closed && manifold && r->survey.orientable == NOOK_YES &&
                                         r->survey.components == 1 && b.result.euler == 2);
        CHECK_EQUAL(b.result.inside_out == NOOK_MAYBE, !(closed && r->incoherent_edges == 0));
        CHECK_EQUAL(b.result.bad_indices + b.result.bad_opposites + b.result.bad_corners +
                        b.result.bad_coordinates,
                    0);
    }
}

/* ---- measures -------------------------------------------------------------------------------------------- */

static void move_cube(float size, float x, float y, float z) {
    uint32_t v;
    cube();
    for (v = 0; v < 8; v++) {
        nook_point p = b.mesh.G[v];
        place(v, p.x * size + x, p.y * size + y, p.z * size + z);
    }
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
}

static void a_cube_has_six_sides_and_one_volume_wherever_it_stands(void) {
    move_cube(1, 0, 0, 0);
    CHECK(b.result.geometry.area == 6);
    CHECK(b.result.geometry.signed_volume == 1);
    CHECK(b.result.geometry.box_min.x == 0 && b.result.geometry.box_max.z == 1);
    CHECK(b.shell[0].signed_volume == 1);
    move_cube(1, 1000000, -2000000, 500000);
    CHECK(b.result.geometry.area == 6);
    CHECK(b.result.geometry.signed_volume == 1);
    move_cube(1048576, 0, 0, -1048576.0f * 1023);
    CHECK(b.result.geometry.signed_volume == 1048576.0f * 1048576.0f * 1048576.0f);
    move_cube(2 * NOOK_MAX_COORDINATE, -NOOK_MAX_COORDINATE, -NOOK_MAX_COORDINATE, -NOOK_MAX_COORDINATE);
    CHECK(close_to(b.result.geometry.area, 24 * NOOK_MAX_COORDINATE * NOOK_MAX_COORDINATE, 1e-6f));
    CHECK_EQUAL(b.result.inside_out, NOOK_NO);
}

static void a_tiny_cube_keeps_its_area_and_the_sign_of_its_volume(void) {
    move_cube(1e-12f, 0, 0, 0);
    CHECK(close_to(b.result.geometry.area, 6e-24f, 1e-6f));
    CHECK(close_to(b.result.geometry.signed_volume, 1e-36f, 1e-6f));
    move_cube(1e-15f, 0, 0, 0);
    CHECK(close_to(b.result.geometry.area, 6e-30f, 1e-6f));
}

static void a_cube_too_small_for_its_volume_still_shows_that_it_is_inside_out(void) {
    uint32_t t, k;
    for (k = 0; k < 2; k++) {
        move_cube(1e-20f, 0, 0, 0);
        for (t = 0; t < b.mesh.nt && k == 1; t++) turn_over(t);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK_EQUAL(b.result.inside_out, k);
    }
}

static void an_octahedron_has_the_area_and_volume_of_the_formula(void) {
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK(close_to(b.result.geometry.area, 6.92820323f, 2e-7f)); /* 4 sqrt 3 */
    CHECK(close_to(b.result.geometry.signed_volume, 1.33333333f, 2e-7f));
}

static void a_fine_sphere_comes_close_to_a_ball(void) {
    icosphere(2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK(b.result.geometry.area < 12.56637f && b.result.geometry.area > 11.0f);
    CHECK(b.result.geometry.signed_volume < 4.18879f && b.result.geometry.signed_volume > 3.4f);
}

/* Shuffled spheres, link, roots and sums: a PC, cores with an FPU and without, and both widths of indices
 * must agree to the bit. The largest is left out where it has no room. */
static void spheres_have_the_same_bits_on_every_machine(void) {
    static const struct {
        uint32_t levels, digest, area, volume;
    } known[] = {
        {1, 0xFEE2C992u, 0x4126AF1Cu, 0x403C56FBu},
        {2, 0xC308D1F2u, 0x413F473Cu, 0x407455AEu},
        {5, 0x30B73952u, 0x4148E6EAu, 0x4085D811u},
    };
    uint32_t i;
    for (i = 0; i < 3 && 8u << 2 * known[i].levels <= MOST_T; i++) {
        dice fixed = {2166136261u};
        nook_view view;
        icosphere(known[i].levels);
        shuffle(&fixed);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK(nook_is_sound(&b.result));
        view = nook_view_of(&b.mesh);
        CHECK_EQUAL(nook_digest(&view), known[i].digest);
        CHECK_EQUAL(nook_float_bits(b.result.geometry.area), known[i].area);
        CHECK_EQUAL(nook_float_bits(b.result.geometry.signed_volume), known[i].volume);
    }
}

static void shells_have_volumes_of_their_own_and_keep_them_when_checked_again(void) {
    uint32_t i;
    shapes[14].build();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    for (i = 0; i < 2; i++) {
        CHECK_EQUAL(b.shells.count, 2);
        CHECK(close_to(b.shell[0].signed_volume, 1.0f / 6, 1e-5f));
        CHECK(close_to(b.shell[1].signed_volume, 8.0f / 6, 1e-5f));
        CHECK(close_to(b.result.geometry.signed_volume, 1.5f, 1e-6f));
        CHECK_EQUAL(check_as_it_is(&b.report), NOOK_OK);
    }
}

static void one_unit_at_a_time_gives_the_same_as_one_call(void) {
    uint32_t i, units;
    for (i = 0; i < shape_count; i++) {
        nook_check_state state;
        nook_check_result whole;
        nook_view view;
        nook_status status;
        shapes[i].build();
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        whole = b.result;
        view = nook_view_of(&b.mesh);
        memset(&b.result, 0, sizeof b.result);
        CHECK_EQUAL(nook_check_begin(&state, &view, &b.marks, &b.report, &b.shells, NULL, &b.result),
                    NOOK_OK);
        units = 0;
        CHECK_EQUAL(nook_check_step(&state, &units), NOOK_MORE);
        do {
            units = 1;
            status = nook_check_step(&state, &units);
        } while (status == NOOK_MORE);
        CHECK_EQUAL(status, NOOK_OK);
        CHECK(whole.geometry.area == b.result.geometry.area &&
              whole.geometry.signed_volume == b.result.geometry.signed_volume);
        CHECK_EQUAL(whole.euler, b.result.euler);
        CHECK_EQUAL(whole.manifold, b.result.manifold);
        CHECK_EQUAL(whole.survey.fans, b.result.survey.fans);
        CHECK_EQUAL(nook_is_sound(&whole), nook_is_sound(&b.result));
    }
}

static const test tests[] = {
    TEST(closed_surfaces_of_any_genus_are_sound),
    TEST(a_missing_triangle_shows_three_border_edges),
    TEST(a_turned_triangle_shows_three_incoherent_edges),
    TEST(two_shells_that_touch_at_a_vertex_are_a_nonmanifold_vertex),
    TEST(a_third_triangle_on_an_edge_is_not_edge_manifold),
    TEST(back_to_back_triangles_are_duplicates),
    TEST(an_unused_vertex_is_isolated_and_does_not_spoil_the_verdict),
    TEST(a_moebius_strip_is_not_orientable),
    TEST(an_inside_out_shell_has_negative_volume),
    TEST(a_mesh_without_triangles_is_empty_and_not_sound),
    TEST(a_coordinate_that_is_no_number_names_its_vertex),
    TEST(an_index_out_of_range_names_its_corner),
    TEST(a_repeated_vertex_names_its_triangle),
    TEST(any_flipped_bit_of_O_is_a_bad_opposite),
    TEST(a_flipped_bit_of_C_is_a_bad_corner_or_another_corner_of_the_vertex),
    TEST(any_flipped_bit_of_V_spoils_the_verdict),
    TEST(every_O_of_one_triangle_ends_in_time_and_only_the_right_one_is_whole),
    TEST(every_O_of_two_triangles_ends_in_time),
    TEST(tables_of_garbage_end_in_time),
    TEST(without_a_report_what_O_cannot_tell_is_unknown),
    TEST(a_defective_mesh_linked_without_marks_stays_unknown),
    TEST(a_report_that_does_not_fit_the_tables_is_not_believed),
    TEST(a_report_with_more_edges_than_lone_corners_is_not_believed),
    TEST(a_sphere_beside_a_torus_is_not_simple),
    TEST(numbers_of_no_surface_give_no_handles),
    TEST(shells_beyond_their_room_are_not_touched),
    TEST(shells_one_by_one_must_not_be_inside_out),
    TEST(without_a_report_a_whole_O_has_a_volume_and_no_more),
    TEST(a_volume_of_nothing_is_flat_and_not_inside_out),
    TEST(marks_spoiled_on_the_way_end_in_time),
    TEST(a_report_of_another_mesh_and_missing_arguments_are_refused),
    TEST(derived_properties_follow_the_oracle_on_all_surfaces),
    TEST(a_cube_has_six_sides_and_one_volume_wherever_it_stands),
    TEST(a_tiny_cube_keeps_its_area_and_the_sign_of_its_volume),
    TEST(a_cube_too_small_for_its_volume_still_shows_that_it_is_inside_out),
    TEST(an_octahedron_has_the_area_and_volume_of_the_formula),
    TEST(a_fine_sphere_comes_close_to_a_ball),
    TEST(spheres_have_the_same_bits_on_every_machine),
    TEST(shells_have_volumes_of_their_own_and_keep_them_when_checked_again),
    TEST(one_unit_at_a_time_gives_the_same_as_one_call),
};

void test_check(void) { run_tests(tests, sizeof tests / sizeof *tests); }
