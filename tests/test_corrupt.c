/* test_corrupt.c -- tables with any bits in them: what a flash or RAM error leaves behind.
 *
 * Each table ends where an array of its own ends, so that a sanitizer sees the first read beyond it.
 * Every run counts single units against the bound that the header states. What check counts in broken
 * tables is compared with plain loops over V, O and C. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

enum { NV = 12, NT = 12, NC = 3 * NT };

static nook_point all_G[NV];
static nook_index all_V[NC], all_O[NC], all_C[NV], all_component[NT], all_stamp[NV];
static nook_shell all_shells[NT];
static uint8_t all_Mt[NOOK_MT_BYTES(NT)], all_Mv[NOOK_MV_BYTES(NV)];

/* The tables of nt triangles and nv vertices at the ends of those arrays. */
static nook_mesh mesh;
static nook_marks marks;
static nook_shells shells;
static nook_report report;
static nook_check_result result;
static dice d = {2463534242u};

static void begin_tables(uint32_t nv, uint32_t nt) {
    uint32_t v;
    CHECK_EQUAL(nook_mesh_init(&mesh, all_G + NV - nv, all_V + NC - 3 * nt, all_O + NC - 3 * nt,
                               all_C + NV - nv, nv, nt),
                NOOK_OK);
    mesh.nv = nv;
    mesh.nt = nt;
    marks.Mt = all_Mt + sizeof all_Mt - NOOK_MT_BYTES(nt);
    marks.Mv = all_Mv + sizeof all_Mv - NOOK_MV_BYTES(nv);
    marks.max_nt = nt;
    marks.max_nv = nv;
    shells.shell = all_shells;
    shells.component = all_component + NT - nt;
    shells.stamp = all_stamp + NV - nv;
    shells.max_shells = NT;
    shells.count = 0;
    memset(&report, 0, sizeof report);
    report.triangles = nt;
    for (v = 0; v < nv; v++) mesh.G[v] = nook_make((float)v, (float)(v * v % 7), (float)(v % 3));
}

static void set_V(const uint8_t *list) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) mesh.V[c] = list[c];
}

static const uint8_t octahedron[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
/* Nine vertices in rows of three, eight triangles. */
static const uint8_t sheet[] = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7};

/* ---- what is heard ------------------------------------------------------------------------------- */

static uint32_t heard[NOOK_STATUS_COUNT];
static uint8_t corners_heard[NC]; /* of bad opposites */

static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    heard[defect]++;
    if (defect != NOOK_BAD_OPPOSITE) return;
    if (CHECK(where.kind == NOOK_AT_CORNER && where.index < 3 * mesh.nt)) corners_heard[where.index]++;
}
static const nook_finder finder = {hear, NULL};

/* The bounds that nook_survey.h and nook_check.h state. */
static uint32_t survey_bound(void) { return 25 * mesh.nt + 3 * mesh.nv + 19; }
static uint32_t check_bound(void) { return (uint32_t)NOOK_CHECK_UNITS(mesh.nt, mesh.nv, mesh.nt); }

/* Check one unit at a time; change() is called between units. */
static void check_by_units(const nook_report *with, void (*change)(void)) {
    nook_check_state state;
    nook_view view = nook_view_of(&mesh);
    nook_status status;
    uint32_t spent = 0, calls = 0, bound = check_bound();
    memset(heard, 0, sizeof heard);
    memset(corners_heard, 0, sizeof corners_heard);
    CHECK_EQUAL(nook_check_begin(&state, &view, &marks, with, &shells, &finder, &result), NOOK_OK);
    do {
        uint32_t units = 1;
        status = nook_check_step(&state, &units);
        CHECK(units <= 1);
        spent += 1 - units;
        if (change != NULL) change();
    } while (status == NOOK_MORE && ++calls <= bound + 50);
    if (change == NULL) CHECK_EQUAL(status, NOOK_OK);
    CHECK(status != NOOK_MORE);
    CHECK(spent <= bound);
}

static void link_whole(void) { CHECK_EQUAL(nook_link(&mesh, &marks, NULL, NULL, &report, NULL), NOOK_OK); }

/* ---- plain counts of what is broken ------------------------------------------------------------------ */

static uint32_t end_of(uint32_t c, uint32_t turn) { return mesh.V[c - c % 3 + (c + turn) % 3]; }

static bool opposite_is_bad(uint32_t c) {
    uint32_t o = mesh.O[c];
    if (o == c) return false;
    if (o >= 3 * mesh.nt || mesh.O[o] != c) return true;
    return end_of(c, 1) != end_of(o, 2) || end_of(c, 2) != end_of(o, 1);
}

/* Two corners that name each other and whose edge runs the same way twice: not ruled by the header. */
static bool pairs_an_incoherent_edge(void) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) {
        uint32_t o = mesh.O[c];
        if (o == c || o >= 3 * mesh.nt || mesh.O[o] != c) continue;
        if (end_of(c, 1) == end_of(o, 1) && end_of(c, 2) == end_of(o, 2)) return true;
    }
    return false;
}

static bool is_used(uint32_t v) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (mesh.V[c] == v) return true;
    }
    return false;
}

static bool corner_is_bad(uint32_t v) {
    if (mesh.C[v] == NOOK_STORED_NONE) return is_used(v);
    return mesh.C[v] >= 3 * mesh.nt || mesh.V[mesh.C[v]] != v;
}

static bool is_repeated(uint32_t t) {
    const nook_index *v = mesh.V + 3 * t;
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
}

static void compare_with_plain_counts(void) {
    uint32_t c, v, t, indices = 0, opposites = 0, corners = 0, repeated = 0;
    for (c = 0; c < 3 * mesh.nt; c++) indices += mesh.V[c] >= mesh.nv;
    CHECK_EQUAL(result.bad_indices, indices);
    CHECK_EQUAL(heard[NOOK_INDEX_OUT_OF_RANGE], indices);
    CHECK_EQUAL(result.triangles, mesh.nt);
    CHECK_EQUAL(result.vertices, mesh.nv);
    CHECK(!nook_is_sound(&result));
    if (indices != 0) {
        CHECK(result.manifold != NOOK_YES);
        CHECK(!result.geometry.known);
        return;
    }
    for (t = 0; t < mesh.nt; t++) repeated += is_repeated(t);
    CHECK_EQUAL(result.repeated_vertex_triangles, repeated);
    CHECK_EQUAL(heard[NOOK_REPEATED_VERTEX], repeated);
    for (v = 0; v < mesh.nv; v++) corners += corner_is_bad(v);
    CHECK_EQUAL(result.bad_corners, corners);
    CHECK_EQUAL(heard[NOOK_BAD_VERTEX_CORNER], corners);
    if (pairs_an_incoherent_edge() || repeated != 0) return;
    for (c = 0; c < 3 * mesh.nt; c++) {
        opposites += opposite_is_bad(c);
        CHECK_EQUAL(corners_heard[c], opposite_is_bad(c));
    }
    CHECK_EQUAL(result.bad_opposites, opposites);
    if (opposites != 0) CHECK_EQUAL(result.survey.components, NOOK_UNKNOWN);
}

/* ---- single bits ----------------------------------------------------------------------------------------- */

static void flip_bits_of(nook_index *table, uint32_t entries, bool with_report) {
    uint32_t i, bit;
    for (i = 0; i < entries && !test_has_failed(); i++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit++) {
            nook_index keep = table[i];
            table[i] = (nook_index)(keep ^ (nook_index)((nook_index)1u << bit));
            check_by_units(with_report ? &report : NULL, NULL);
            if (table == mesh.O) CHECK(result.bad_opposites > 0);
            if (table == mesh.O || !with_report) compare_with_plain_counts();
            table[i] = keep;
        }
    }
}

static void every_flipped_bit_is_counted_where_it_is(void) {
    uint32_t k;
    for (k = 0; k < 4; k++) {
        begin_tables(k < 2 ? 6 : 9, 8);
        set_V(k < 2 ? octahedron : sheet);
        link_whole();
        flip_bits_of(mesh.O, 24, k % 2 != 0);
        flip_bits_of(mesh.C, mesh.nv, false);
        flip_bits_of(mesh.V, 24, false);
    }
}

static void every_flipped_bit_of_a_coordinate_is_judged_alone(void) {
    uint32_t v, k, bit;
    begin_tables(6, 8);
    set_V(octahedron);
    link_whole();
    for (v = 0; v < 6; v++) {
        for (k = 0; k < 3; k++) {
            for (bit = 0; bit < 32; bit++) {
                nook_point keep = mesh.G[v];
                float *x = k == 0 ? &mesh.G[v].x : k == 1 ? &mesh.G[v].y : &mesh.G[v].z;
                uint32_t bits = nook_float_bits(*x) ^ (uint32_t)1 << bit, size = bits & 0x7FFFFFFFu;
                *x = nook_float_from(bits);
                check_by_units(&report, NULL);
                CHECK_EQUAL(result.bad_coordinates, size > 0x4E800000u); /* 2^30 */
                CHECK_EQUAL(heard[NOOK_NOT_FINITE], size >= 0x7F800000u);
                CHECK_EQUAL(heard[NOOK_COORDINATE_TOO_LARGE], size > 0x4E800000u && size < 0x7F800000u);
                CHECK_EQUAL(result.geometry.known, size <= 0x4E800000u);
                CHECK(result.manifold == NOOK_YES);
                mesh.G[v] = keep;
            }
        }
    }
}

/* ---- any bits ---------------------------------------------------------------------------------------------- */

/* Mostly in range, sometimes the first beyond, sometimes anything. */
static nook_index any_index(uint32_t end) {
    uint32_t kind = throw_dice(&d, 40);
    if (kind == 0) return nook_store(end);
    if (kind == 1) return NOOK_STORED_NONE;
    if (kind == 2) return (nook_index)throw_dice(&d, UINT32_MAX);
    return nook_store(throw_dice(&d, end));
}

static void tables_of_any_bits_are_counted_as_by_plain_loops(void) {
    uint32_t k, i, j;
    for (k = 0; k < 6000 && !test_has_failed(); k++) {
        uint32_t nt = 1 + throw_dice(&d, NT), nv = 1 + throw_dice(&d, NV);
        begin_tables(nv, nt);
        for (i = 0; i < 3 * nt; i++) {
            mesh.V[i] = k % 2 == 0 ? any_index(nv) : nook_store(throw_dice(&d, nv));
            mesh.O[i] = any_index(3 * nt);
        }
        for (i = 0; i < 3 * nt && k % 3 == 0; i++) { /* many that name each other */
            j = throw_dice(&d, 3 * nt);
            mesh.O[i] = nook_store(j);
            mesh.O[j] = nook_store(i);
        }
        for (i = 0; i < nv; i++) mesh.C[i] = any_index(3 * nt);
        check_by_units(k % 5 == 0 ? &report : NULL, NULL);
        compare_with_plain_counts();
    }
}

/* A whole mesh, with a few entries written over. */
static void a_few_wrong_entries_are_counted_as_by_plain_loops(void) {
    uint32_t k, i, c;
    for (k = 0; k < 3000 && !test_has_failed(); k++) {
        begin_tables(k % 2 ? 6 : 9, 8);
        set_V(k % 2 ? octahedron : sheet);
        link_whole();
        c = throw_dice(&d, 24);
        for (i = 1 + throw_dice(&d, 3); i > 0; i--) {
            mesh.O[throw_dice(&d, 24)] = any_index(24);
            if (throw_dice(&d, 3) == 0) mesh.C[throw_dice(&d, mesh.nv)] = any_index(24);
        }
        mesh.O[c] = nook_store((c + 1) % 24);
        check_by_units(k % 3 ? &report : NULL, NULL);
        compare_with_plain_counts();
    }
}

static void write_somewhere(void) {
    uint32_t c = throw_dice(&d, 3 * mesh.nt);
    if (throw_dice(&d, 4) == 0) mesh.O[c] = any_index(3 * mesh.nt);
}

static void a_check_ends_though_O_changes_under_it(void) {
    uint32_t k;
    for (k = 0; k < 1500 && !test_has_failed(); k++) {
        begin_tables(k % 2 ? 6 : 9, 8);
        set_V(k % 2 ? octahedron : sheet);
        link_whole();
        check_by_units(&report, write_somewhere);
    }
}

static void a_survey_of_a_false_O_ends_and_says_so(void) {
    uint32_t k, i, refused = 0;
    for (k = 0; k < 6000 && !test_has_failed(); k++) {
        nook_survey_state state;
        nook_survey survey;
        nook_view view;
        nook_status status;
        uint32_t spent = 0, bound, units;
        begin_tables(k % 2 ? 6 : 9, 8);
        set_V(k % 2 ? octahedron : sheet);
        link_whole();
        for (i = 0; i <= k % 7; i++) {
            mesh.O[throw_dice(&d, 24)] = k % 4 == 0 ? any_index(24) : nook_store(throw_dice(&d, 24));
        }
        view = nook_view_of(&mesh);
        bound = survey_bound();
        CHECK_EQUAL(
            nook_survey_begin(&state, &view, k % 3 == 0 ? mesh.O : NULL, &marks, &shells, &finder, &survey),
            NOOK_OK);
        do {
            units = 1;
            status = nook_survey_step(&state, &units);
            spent += 1 - units;
        } while (status == NOOK_MORE && spent <= bound);
        CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
        CHECK(spent <= bound);
        refused += status == NOOK_BAD_OPPOSITE;
    }
    CHECK(refused > 0);
}

/* ---- a survey of tables that change under it -------------------------------------------------------------- */

static const uint8_t strip[] = {0, 1, 2, 2, 1, 3};
static const uint8_t cap[] = {0, 1, 3, 1, 2, 3, 2, 0, 3};
static const uint8_t pillow[] = {0, 1, 2, 0, 2, 1};
static const uint8_t three_pages[] = {0, 1, 2, 0, 1, 3, 0, 1, 4};
static nook_index whole_V[NC], whole_O[NC];

/* Three corners on one edge, in a ring as link leaves them to the survey. */
static void ring_of_pages(void) {
    uint32_t t;
    for (t = 0; t < 3; t++) mesh.O[3 * t + 2] = nook_store((3 * t + 5) % 9);
}

static void keep_whole(void) {
    memcpy(whole_V, mesh.V, 3 * mesh.nt * sizeof *whole_V);
    memcpy(whole_O, mesh.O, 3 * mesh.nt * sizeof *whole_O);
}

static void restore(void) {
    memcpy(mesh.V, whole_V, 3 * mesh.nt * sizeof *whole_V);
    memcpy(mesh.O, whole_O, 3 * mesh.nt * sizeof *whole_O);
}

/* Survey the whole tables, in which *first becomes `value` (and *second `other`) after that many units. */
static nook_status survey_changed(bool rings, uint32_t after, nook_index *first, nook_index value,
                                  nook_index *second, nook_index other) {
    nook_survey_state state;
    nook_survey survey;
    nook_view view = nook_view_of(&mesh);
    nook_status status = NOOK_MORE;
    uint32_t spent = 0, units;
    restore();
    CHECK_EQUAL(nook_survey_begin(&state, &view, rings ? mesh.O : NULL, &marks, &shells, &finder, &survey),
                NOOK_OK);
    for (; status == NOOK_MORE && spent <= survey_bound(); spent += 1 - units) {
        if (spent == after) {
            *first = value;
            *second = other;
        }
        units = 1;
        status = nook_survey_step(&state, &units);
    }
    CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    CHECK(spent <= survey_bound());
    CHECK(survey.components <= mesh.nt && survey.fans <= 3 * mesh.nt);
    CHECK(rings || survey.border_loops <= 3 * mesh.nt);
    restore();
    return status;
}

/* Any one entry of V or O takes any value of interest before any unit. */
static void change_any_entry(bool rings) {
    uint32_t after, i, k, refused = 0, nc = 3 * mesh.nt;
    keep_whole();
    for (after = 0; after <= survey_bound() && !test_has_failed(); after++) {
        for (i = 0; i < nc; i++) {
            for (k = 0; k <= nc + 1; k++) {
                nook_index value = k > nc ? NOOK_STORED_NONE : nook_store(k);
                nook_index *O = &mesh.O[i], *V = &mesh.V[i];
                refused += survey_changed(rings, after, O, value, O, value) != NOOK_OK;
                if (k <= mesh.nv) refused += survey_changed(rings, after, V, value, V, value) != NOOK_OK;
            }
        }
    }
    CHECK(refused > 0);
}

static void a_survey_ends_whichever_entry_changes_and_whenever(void) {
    begin_tables(4, 2);
    set_V(strip);
    link_whole();
    change_any_entry(false);
    begin_tables(4, 3);
    set_V(cap);
    link_whole();
    change_any_entry(false);
    begin_tables(5, 3);
    set_V(three_pages);
    link_whole();
    ring_of_pages();
    change_any_entry(true);
}

/* Two triangles back to back, open at one edge: when that closes while the border is being followed, the
 * walk about its end never comes to a border again. */
static void a_walk_that_a_change_makes_endless_is_ended(void) {
    uint32_t after, refused = 0;
    begin_tables(3, 2);
    set_V(pillow);
    link_whole();
    CHECK_EQUAL(mesh.O[0], 3);
    mesh.O[0] = 0;
    mesh.O[3] = 3;
    keep_whole();
    for (after = 0; after <= survey_bound(); after++) {
        refused += survey_changed(false, after, &mesh.O[0], 3, &mesh.O[3], 0) == NOOK_BAD_OPPOSITE;
    }
    CHECK(refused > 0);
}

static void a_vertex_out_of_range_ends_the_survey(void) {
    uint32_t c;
    begin_tables(6, 8);
    set_V(octahedron);
    link_whole();
    keep_whole();
    CHECK_EQUAL(survey_changed(false, 0, &mesh.V[0], 0, &mesh.V[0], 0), NOOK_OK);
    for (c = 0; c < 24; c++) {
        CHECK_EQUAL(survey_changed(false, 0, &mesh.V[c], 6, &mesh.V[c], 6), NOOK_BAD_OPPOSITE);
    }
}

/* ---- link on any bits ----------------------------------------------------------------------------------- */

static void link_takes_any_V_and_names_what_is_wrong(void) {
    static nook_index before[NC];
    uint32_t k, c, t;
    for (k = 0; k < 4000 && !test_has_failed(); k++) {
        uint32_t nt = throw_dice(&d, NT + 1), nv = 1 + throw_dice(&d, NV);
        bool out_of_range = false, repeated = false;
        nook_where where = {NOOK_NOWHERE, 0};
        nook_status status;
        begin_tables(nv, nt);
        for (c = 0; c < 3 * nt; c++) mesh.V[c] = k % 3 == 0 ? any_index(nv) : nook_store(throw_dice(&d, nv));
        for (c = 0; c < 3 * nt; c++) out_of_range |= mesh.V[c] >= nv;
        for (t = 0; t < nt; t++) repeated |= is_repeated(t);
        memcpy(before, mesh.V, 3 * nt * sizeof *before);
        status = nook_link(&mesh, k % 2 ? &marks : NULL, &shells, NULL, &report, &where);
        CHECK(memcmp(before, mesh.V, 3 * nt * sizeof *before) == 0);
        CHECK((status == NOOK_OK) == (!out_of_range && !repeated));
        if (status == NOOK_OK) continue;
        if (status == NOOK_INDEX_OUT_OF_RANGE) {
            CHECK(where.kind == NOOK_AT_CORNER && where.index < 3 * nt && mesh.V[where.index] >= nv);
        } else {
            CHECK_EQUAL(status, NOOK_REPEATED_VERTEX);
            CHECK(where.kind == NOOK_AT_TRIANGLE && where.index < nt && is_repeated(where.index));
        }
    }
}

/* Three pages are surveyed inside link, and then no entry of O names a corner. */
static void link_says_so_when_its_survey_finds_O_spoiled(void) {
    nook_link_state state;
    nook_status status = NOOK_MORE;
    uint32_t calls, units;
    begin_tables(5, 3);
    set_V(three_pages);
    CHECK_EQUAL(nook_link_begin(&state, &mesh, &marks, &shells, NULL, &report), NOOK_OK);
    for (calls = 0; status == NOOK_MORE && calls < 500; calls++) {
        units = 1;
        status = nook_link_step(&state, &units);
        if (shells.count != 0) memset(mesh.O, 0xFF, 9 * sizeof *mesh.O); /* the first triangle is entered */
    }
    CHECK_EQUAL(status, NOOK_BAD_OPPOSITE);
    CHECK_EQUAL(state.where.kind, NOOK_NOWHERE);
    CHECK_EQUAL(nook_link_step(&state, &units), NOOK_BAD_OPPOSITE);
}

static const test tests[] = {
    TEST(every_flipped_bit_is_counted_where_it_is),
    TEST(every_flipped_bit_of_a_coordinate_is_judged_alone),
    TEST(tables_of_any_bits_are_counted_as_by_plain_loops),
    TEST(a_few_wrong_entries_are_counted_as_by_plain_loops),
    TEST(a_check_ends_though_O_changes_under_it),
    TEST(a_survey_of_a_false_O_ends_and_says_so),
    TEST(a_survey_ends_whichever_entry_changes_and_whenever),
    TEST(a_walk_that_a_change_makes_endless_is_ended),
    TEST(a_vertex_out_of_range_ends_the_survey),
    TEST(link_takes_any_V_and_names_what_is_wrong),
    TEST(link_says_so_when_its_survey_finds_O_spoiled),
};

void test_corrupt(void) { run_tests(tests, sizeof tests / sizeof *tests); }
