/* tables.c -- every O table over the corners, the first number beyond them and all bits set, for one and two
 * triangles; every one that pairs corners in any way, for three and four; and a hundred million of the 11^9
 * for three.
 *
 * Proven for each of them: check, survey (with its rings and without) and geometry (as of a closed mesh and
 * of an open one) end within the steps that their headers state, and write neither O nor V nor beyond any
 * array.
 * Check is run without a report, with link's, with one that says of any table that it is closed, and with one
 * forged so that its edges add up for this very table: it calls nothing sound that is not, and its count of
 * bad opposites is that of plain loops, as is what survey refuses.
 *   one triangle   125 O on all 5 patterns of equal and different vertices, and V out of range
 *   two            262,144 O on all 34 patterns of whole triangles, and V out of range
 *   three          2,620 O that pair corners or leave them alone, where walks go far, on all 2,971 patterns
 *                  of whole triangles
 *   four           140,152 such O on a tetrahedron, the same inside out, with a triangle turned over, and on
 *                  two pillows: sound is the one O of the first, and nothing else
 *   three          10^8 of the 2,357,947,691 O on a closed fan, spread over all of them: from one to the next
 *                  every digit moves by a number of its own, and no table comes twice. Here check with the
 *                  forged report, and survey; nothing is sound, since nine corners cannot all be paired
 *
 * usage: tables [small | pairs | large [COUNT]]   all by default; COUNT of the last kind, at most 11^9.
 * `small` is for sanitizers: its arrays end where their heap blocks end. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bounds.h"
#include "check.h"
#include "nook.h"
#include "nook_port.h"
#include "prove.h"

enum { MOST_NT = 4, MOST_NC = 3 * MOST_NT };

static nook_mesh mesh;
static nook_view view;
static nook_marks marks;
static nook_shells shells;
static nook_report linked, forged, as_closed;
static nook_check_result result;
static nook_index *rings, kept_V[MOST_NC], kept_O[MOST_NC];
static uint32_t worst_check, worst_survey, worst_geometry, ended, refused, sound, missed;

static uint32_t nc(void) { return 3 * mesh.nt; }

/* ---- the tables ------------------------------------------------------------------------------------ */

/* A report that says of any table that it is closed. */
static void forge_closed_report(void) {
    as_closed.triangles = mesh.nt;
    as_closed.matched_edges = as_closed.edges = nc() / 2;
}

static void begin_tables(uint32_t nv, uint32_t nt) {
    nook_point *G = fenced(nv * sizeof *G);
    nook_index *V = fenced(3 * nt * sizeof *V), *O = fenced(3 * nt * sizeof *O), *C = fenced(nv * sizeof *C);
    uint32_t v;
    CHECK_EQUAL(nook_mesh_init(&mesh, G, V, O, C, nv, nt), NOOK_OK);
    mesh.nv = nv;
    mesh.nt = nt;
    marks.Mt = fenced(NOOK_MT_BYTES(nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    marks.max_nt = nt;
    marks.max_nv = nv;
    shells.shell = fenced(nt * sizeof *shells.shell);
    shells.component = fenced(nt * sizeof *shells.component);
    shells.stamp = fenced(nv * sizeof *shells.stamp);
    shells.max_shells = nt;
    rings = fenced(3 * nt * sizeof *rings);
    for (v = 0; v < nv; v++) G[v] = nook_make((float)v, (float)(v * v), (float)(v * v * v));
    view = nook_view_of(&mesh);
    forge_closed_report();
}

/* V from a list of digits; C names the last corner of each vertex. Link's report, where it makes one. */
static void set_V(const uint8_t *vertices) {
    uint32_t c;
    memset(mesh.C, 0xFF, mesh.nv * sizeof *mesh.C);
    for (c = 0; c < nc(); c++) {
        mesh.V[c] = kept_V[c] = vertices[c];
    }
    memset(&linked, 0, sizeof linked);
    if (nook_link(&mesh, &marks, NULL, NULL, &linked, NULL) != NOOK_OK) linked.triangles = mesh.nt;
    memset(mesh.C, 0xFF, mesh.nv * sizeof *mesh.C);
    for (c = 0; c < nc(); c++) {
        if (mesh.V[c] < mesh.nv) mesh.C[mesh.V[c]] = nook_store(c);
    }
}

static nook_index entry(uint32_t digit) { return digit <= nc() ? nook_store(digit) : NOOK_STORED_NONE; }

/* The table of this number: its digits to the base 3 nt + 2, the lowest at corner 0. */
static uint8_t digit[MOST_NC];
static void first_table(uint64_t number) {
    uint32_t c;
    for (c = 0; c < nc(); c++, number /= nc() + 2) {
        digit[c] = (uint8_t)(number % (nc() + 2));
        mesh.O[c] = kept_O[c] = entry(digit[c]);
    }
}

static void next_table(void) {
    uint32_t c = 0;
    for (; c < nc() && digit[c] == nc() + 1; c++) {
        digit[c] = 0;
        mesh.O[c] = kept_O[c] = 0;
    }
    if (c == nc()) return;
    digit[c]++;
    mesh.O[c] = kept_O[c] = entry(digit[c]);
}

static uint32_t number_of_tables(void) {
    uint32_t c, n = 1;
    for (c = 0; c < nc(); c++) n *= nc() + 2;
    return n;
}

/* A report that adds up with this table: what its corners have left alone is border. */
static void forge_report(void) {
    uint32_t c, loose = 0;
    for (c = 0; c < nc(); c++) loose += mesh.O[c] == c;
    forged.triangles = mesh.nt;
    forged.border_edges = forged.odd_edges = loose;
    forged.matched_edges = (nc() - loose) / 2;
    forged.edges = loose + forged.matched_edges;
}

/* ---- plain loops ----------------------------------------------------------------------------------- */

static uint32_t end_of(uint32_t c, uint32_t turn) { return mesh.V[c - c % 3 + (c + turn) % 3]; }
static bool opposite_ways(uint32_t c, uint32_t o) {
    return end_of(c, 1) == end_of(o, 2) && end_of(c, 2) == end_of(o, 1);
}
static bool same_way(uint32_t c, uint32_t o) {
    return end_of(c, 1) == end_of(o, 1) && end_of(c, 2) == end_of(o, 2);
}

static bool is_mutual(uint32_t c) { return mesh.O[c] < nc() && mesh.O[mesh.O[c]] == c; }

static bool V_is_whole(void) {
    uint32_t c;
    for (c = 0; c < nc(); c++) {
        if (mesh.V[c] >= mesh.nv || mesh.V[c] == end_of(c, 1)) return false;
    }
    return true;
}

/* How many opposites are bad. Two corners that run one edge the same way and name each other are not ruled
 * by the header: then none is counted. */
static bool count_bad(uint32_t *bad) {
    uint32_t c;
    *bad = 0;
    for (c = 0; c < nc(); c++) {
        if (mesh.O[c] == c) continue;
        *bad += !is_mutual(c) || !opposite_ways(c, mesh.O[c]);
        if (is_mutual(c) && same_way(c, mesh.O[c])) return false;
    }
    return true;
}

static bool turns_through_all(uint32_t c) {
    uint32_t d, at_v = 0, turned = 0, e = c;
    for (d = 0; d < nc(); d++) at_v += mesh.V[d] == mesh.V[c];
    do {
        e = mesh.O[e - e % 3 + (e + 2) % 3];
        e = e - e % 3 + (e + 2) % 3;
    } while (++turned < at_v && e != c);
    return turned == at_v && e == c;
}

/* Six times the volume; coordinates are small whole numbers. */
static int32_t volume(void) {
    int32_t p[3][3], sum = 0;
    uint32_t t, i;
    for (t = 0; t < mesh.nt; t++) {
        for (i = 0; i < 3; i++) {
            p[i][0] = (int32_t)mesh.G[mesh.V[3 * t + i]].x;
            p[i][1] = (int32_t)mesh.G[mesh.V[3 * t + i]].y;
            p[i][2] = (int32_t)mesh.G[mesh.V[3 * t + i]].z;
        }
        for (i = 0; i < 3; i++) {
            uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
            sum += p[0][i] * (p[1][j] * p[2][k] - p[1][k] * p[2][j]);
        }
    }
    return sum;
}

/* Closed, coherent, manifold, with this O and a volume. */
static bool is_sound(void) {
    uint32_t c, d, on_edge;
    if (!V_is_whole() || volume() <= 0) return false;
    for (c = 0; c < nc(); c++) {
        if (mesh.O[c] == c || !is_mutual(c) || !opposite_ways(c, mesh.O[c])) return false;
        for (d = on_edge = 0; d < nc(); d++) on_edge += same_way(c, d) || opposite_ways(c, d);
        if (on_edge != 2) return false;
    }
    for (c = 0; c < nc() && turns_through_all(c); c++) {
    }
    return c == nc();
}

/* ---- the library on one table ---------------------------------------------------------------------- */

/* Only tables that pass all of check's looks have a geometry; any triangle of these may be doubtful. */
static uint32_t bound_of_check(void) { return check_bound(mesh.nv, mesh.nt, mesh.nt); }

static bool tables_are_as_before(void) {
    return memcmp(mesh.O, kept_O, nc() * sizeof *mesh.O) == 0 &&
           memcmp(mesh.V, kept_V, nc() * sizeof *mesh.V) == 0;
}

static void run_check(const nook_report *with, nook_shells *described) {
    nook_check_state state;
    uint32_t bound = bound_of_check(), units = bound + 1;
    nook_status status = nook_check_begin(&state, &view, &marks, with, described, NULL, &result);
    if (status == NOOK_OK) status = nook_check_step(&state, &units);
    if (status != NOOK_OK) missed++;
    if (bound + 1 - units > worst_check) worst_check = bound + 1 - units;
}

static nook_status run_survey(nook_index *O) {
    nook_survey_state state;
    nook_survey survey;
    nook_view of = view;
    uint32_t bound = survey_bound(mesh.nv, mesh.nt), units = bound + 1;
    nook_status status;
    of.O = O != NULL ? O : view.O;
    status = nook_survey_begin(&state, &of, O, &marks, &shells, NULL, &survey);
    if (status == NOOK_OK) status = nook_survey_step(&state, &units);
    ended += status == NOOK_OK;
    refused += status == NOOK_BAD_OPPOSITE;
    missed += status != NOOK_OK && status != NOOK_BAD_OPPOSITE;
    if (bound + 1 - units > worst_survey) worst_survey = bound + 1 - units;
    return status;
}

static void run_geometry(bool closed, nook_shells *described) {
    nook_geometry_state state;
    nook_geometry geometry;
    uint32_t bound = geometry_bound(mesh.nv, mesh.nt, closed ? mesh.nt : 0), units = bound + 1;
    nook_status status = nook_geometry_begin(&state, &view, closed, described, NULL, &geometry);
    if (status == NOOK_OK) status = nook_geometry_step(&state, &units);
    missed += status != NOOK_OK;
    if (bound + 1 - units > worst_geometry) worst_geometry = bound + 1 - units;
}

static void say_table(void) {
    uint32_t c;
    print_text("V");
    for (c = 0; c < nc(); c++) (void)printf(" %u", (unsigned)mesh.V[c]);
    print_text(", O");
    for (c = 0; c < nc(); c++) (void)printf(" %u", (unsigned)kept_O[c]);
    print_text("\n");
}

static void compare_with_plain_loops(void) {
    uint32_t bad;
    if (V_is_whole() && count_bad(&bad)) CHECK_EQUAL(result.bad_opposites, bad);
    CHECK_EQUAL(nook_is_sound(&result), is_sound());
    sound += nook_is_sound(&result);
}

/* Without rings a survey ends well where O pairs corners on the same edge, and only there. */
static void compare_survey(nook_status status) {
    uint32_t c;
    if (!V_is_whole()) return;
    for (c = 0; c < nc(); c++) {
        uint32_t o = mesh.O[c];
        if (o != c && (!is_mutual(c) || !(same_way(c, o) || opposite_ways(c, o)))) break;
    }
    CHECK_EQUAL(status, c == nc() ? NOOK_OK : NOOK_BAD_OPPOSITE);
}

static void try_table(void) {
    run_check(NULL, NULL);
    CHECK(!nook_is_sound(&result));
    run_check(&linked, &shells);
    CHECK_EQUAL(nook_is_sound(&result), is_sound());
    run_check(&as_closed, NULL);
    CHECK_EQUAL(nook_is_sound(&result), is_sound());
    forge_report();
    run_check(&forged, &shells);
    compare_with_plain_loops();
    compare_survey(run_survey(NULL));
    CHECK(tables_are_as_before());
    memcpy(rings, mesh.O, nc() * sizeof *rings);
    (void)run_survey(rings);
    CHECK(tables_are_as_before());
}

/* Geometry never follows O further than one corner; V must be in range. */
static void try_geometry(void) {
    uint32_t c;
    for (c = 0; c < nc() && mesh.V[c] < mesh.nv; c++) {
    }
    if (c < nc()) return;
    run_geometry(true, &shells);
    run_geometry(false, NULL);
    CHECK(tables_are_as_before());
}

static void begin_count(void) {
    worst_check = worst_survey = worst_geometry = ended = refused = sound = missed = 0;
}

static void end_count(const char *label, uint32_t tables, uint32_t since) {
    CHECK_EQUAL(missed, 0);
    CHECK(worst_check <= bound_of_check());
    CHECK(worst_survey <= survey_bound(mesh.nv, mesh.nt));
    print_figure(label, tables, "tables", since);
    (void)printf("  at most %u units of check (stated: %u), %u of survey (%u), %u of geometry (%u)\n",
                 (unsigned)worst_check, (unsigned)bound_of_check(), (unsigned)worst_survey,
                 (unsigned)survey_bound(mesh.nv, mesh.nt), (unsigned)worst_geometry,
                 (unsigned)geometry_bound(mesh.nv, mesh.nt, mesh.nt));
    (void)printf("  surveys: %u ended, %u refused; %u tables sound\n", (unsigned)ended, (unsigned)refused,
                 (unsigned)sound);
}

/* ---- one and two triangles -------------------------------------------------------------------------- */

static uint32_t try_every_O(const uint8_t *vertices) {
    uint32_t k, n = number_of_tables();
    set_V(vertices);
    first_table(0);
    for (k = 0; k < n && !test_has_failed(); k++) {
        try_table();
        if (k % 4 == 0) try_geometry();
        if (test_has_failed()) say_table();
        next_table();
    }
    CHECK(missed == 0 && worst_check <= bound_of_check() && worst_survey <= survey_bound(mesh.nv, mesh.nt));
    if (test_has_failed()) say_table();
    CHECK(fences_hold());
    return k;
}

/* The next pattern of equal and different entries: each at most one more than the greatest before it. */
static bool next_pattern(uint8_t *list, uint32_t n) {
    uint32_t i, k, greatest;
    for (i = n; i-- > 1;) {
        for (k = greatest = 0; k < i; k++) greatest = list[k] > greatest ? list[k] : greatest;
        if (list[i] > greatest) continue;
        list[i]++;
        memset(list + i + 1, 0, n - i - 1);
        return true;
    }
    return false;
}

static bool is_repeated(const uint8_t *v) { return v[0] == v[1] || v[1] == v[2] || v[2] == v[0]; }

/* Patterns of whole triangles, or also those in which a triangle repeats a vertex. */
static uint32_t try_patterns(bool repeated, uint32_t *patterns) {
    uint8_t list[MOST_NC] = {0};
    uint32_t t, tables = 0;
    do {
        bool is = false;
        for (t = 0; t < mesh.nt; t++) is = is || is_repeated(list + 3 * t);
        if (is != repeated) continue;
        ++*patterns;
        tables += try_every_O(list);
    } while (!test_has_failed() && next_pattern(list, nc()));
    return tables;
}

static void every_O_of_one_triangle_is_judged_within_its_bounds(void) {
    static const uint8_t outside[][3] = {{0, 1, 3}, {3, 3, 3}, {4, 0, 1}};
    uint32_t tables, patterns = 3, i, since = milliseconds();
    begin_tables(3, 1);
    begin_count();
    tables = try_patterns(false, &patterns) + try_patterns(true, &patterns);
    for (i = 0; i < 3; i++) tables += try_every_O(outside[i]);
    CHECK_EQUAL(patterns, 5 + 3);
    end_count("one triangle, 125 O for 8 V", tables, since);
    drop_fences();
}

static void every_O_of_two_triangles_is_judged_within_its_bounds(void) {
    static const uint8_t outside[][6] = {{0, 1, 2, 2, 1, 6}, {0, 1, 2, 200, 1, 0}};
    uint32_t tables, patterns = 0, i, since = milliseconds();
    begin_tables(6, 2);
    begin_count();
    tables = try_patterns(false, &patterns);
    for (i = 0; i < 2; i++) tables += try_every_O(outside[i]);
    CHECK_EQUAL(patterns, 34);
    CHECK_EQUAL(sound, 0); /* two triangles have no volume */
    end_count("two triangles, 262144 O for 36 V", tables, since);
    drop_fences();
}

/* ---- three and four triangles ------------------------------------------------------------------------ */

/* The ways to pair 9 or 12 corners, or to leave some alone. */
enum { PAIRINGS_OF_9 = 2620, PAIRINGS_OF_12 = 140152 };
static uint8_t pairing[PAIRINGS_OF_12][MOST_NC];
static uint32_t pairings;

/* All of them; corner c and all before it are decided. Calls itself once a corner deep. */
static void list_pairings(uint8_t *O, uint32_t c) {
    uint32_t d;
    while (c < nc() && O[c] != c) c++;
    if (c == nc()) {
        if (CHECK(pairings < PAIRINGS_OF_12)) memcpy(pairing[pairings++], O, MOST_NC);
        return;
    }
    list_pairings(O, c + 1);
    for (d = c + 1; d < nc(); d++) {
        if (O[d] != d) continue;
        O[c] = (uint8_t)d;
        O[d] = (uint8_t)c;
        list_pairings(O, c + 1);
        O[c] = (uint8_t)c;
        O[d] = (uint8_t)d;
    }
}

static void begin_pairings(uint32_t nv, uint32_t nt) {
    uint8_t O[MOST_NC] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    begin_tables(nv, nt);
    begin_count();
    pairings = 0;
    list_pairings(O, 0);
    CHECK_EQUAL(pairings, nt == 3 ? PAIRINGS_OF_9 : PAIRINGS_OF_12);
}

static uint32_t try_every_pairing(const uint8_t *vertices) {
    uint32_t k, c;
    set_V(vertices);
    for (k = 0; k < pairings && !test_has_failed(); k++) {
        for (c = 0; c < nc(); c++) mesh.O[c] = kept_O[c] = pairing[k][c];
        try_table();
        if (k % 16 == 0) try_geometry();
        if (test_has_failed()) say_table();
    }
    CHECK(missed == 0 && fences_hold());
    return k;
}

static void every_pairing_of_three_triangles_is_judged_within_its_bounds(void) {
    uint8_t list[MOST_NC] = {0};
    uint32_t tables = 0, patterns = 0, since = milliseconds();
    begin_pairings(9, 3);
    do {
        if (is_repeated(list) || is_repeated(list + 3) || is_repeated(list + 6)) continue;
        patterns++;
        tables += try_every_pairing(list);
    } while (!test_has_failed() && next_pattern(list, nc()));
    CHECK_EQUAL(patterns, 2971);
    CHECK_EQUAL(sound, 0);
    end_count("three triangles, 2620 pairings for 2971 V", tables, since);
    drop_fences();
}

static void only_the_right_pairing_of_a_tetrahedron_is_sound(void) {
    static const uint8_t V[][12] = {{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                    {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0},
                                    {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 2, 3},
                                    {0, 1, 2, 0, 2, 1, 0, 1, 3, 3, 1, 0}};
    uint32_t k, tables = 0, since = milliseconds();
    begin_pairings(4, 4);
    for (k = 0; k < sizeof V / sizeof *V; k++) tables += try_every_pairing(V[k]);
    CHECK_EQUAL(sound, 1);
    end_count("four triangles, 140152 pairings for 4 V", tables, since);
    drop_fences();
}

static uint32_t wanted = 100000000u;

/* Every digit moves on by its own number, with carry: the lowest number is no multiple of the base, so all
 * tables are met before one comes again. */
static void next_spread_table(void) {
    static const uint8_t move[MOST_NC] = {5, 3, 8, 1, 10, 4, 7, 2, 6};
    uint32_t c, carry = 0, base = nc() + 2;
    for (c = 0; c < nc(); c++) {
        uint32_t to = digit[c] + move[c] + carry;
        carry = to >= base;
        digit[c] = (uint8_t)(carry != 0 ? to - base : to);
        mesh.O[c] = kept_O[c] = entry(digit[c]);
    }
}

static void O_tables_of_three_triangles_are_judged_within_their_bounds(void) {
    static const uint8_t fan[] = {0, 1, 2, 0, 2, 3, 0, 3, 1};
    uint32_t k, since = milliseconds(), called_sound = 0, changed = 0;
    begin_tables(4, 3);
    begin_count();
    set_V(fan);
    first_table(0);
    for (k = 0; k < wanted; k++) {
        forge_report();
        run_check(&forged, NULL);
        called_sound += nook_is_sound(&result);
        (void)run_survey(NULL);
        memcpy(rings, mesh.O, nc() * sizeof *rings);
        (void)run_survey(rings);
        changed += !tables_are_as_before();
        next_spread_table();
    }
    CHECK_EQUAL(called_sound, 0); /* nine corners cannot all be matched */
    CHECK_EQUAL(changed, 0);
    CHECK(fences_hold());
    end_count("three triangles, spread", k, since);
    drop_fences();
}

static const test small[] = {
    TEST(every_O_of_one_triangle_is_judged_within_its_bounds),
    TEST(every_O_of_two_triangles_is_judged_within_its_bounds),
};
static const test pairs[] = {
    TEST(every_pairing_of_three_triangles_is_judged_within_its_bounds),
    TEST(only_the_right_pairing_of_a_tetrahedron_is_sound),
};
static const test large[] = {TEST(O_tables_of_three_triangles_are_judged_within_their_bounds)};

int main(int argc, char **argv) {
    const char *part = argc > 1 ? argv[1] : "";
    if (argc > 2) wanted = (uint32_t)strtoul(argv[2], NULL, 10);
    if (*part == 0 || strcmp(part, "small") == 0) run_tests(small, sizeof small / sizeof *small);
    if (*part == 0 || strcmp(part, "pairs") == 0) run_tests(pairs, sizeof pairs / sizeof *pairs);
    if (*part == 0 || strcmp(part, "large") == 0) run_tests(large, sizeof large / sizeof *large);
    return finish_tests();
}
