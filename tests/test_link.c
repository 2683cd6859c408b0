/* test_link.c -- nook_link and the survey against the oracle: named surfaces, every mix of directions on
 * edges of many triangles, thousands of random soups, hubs; then the rules of the house: exact buffers,
 * units, refusals. */
#include "oracle.h"
#include "rooms.h"

static oracle truth;
static dice d = {2463534242u};

/* What a finder was told, in order: of each edge once, of each triangle as a duplicate, of each component,
 * of each vertex (at most 2 ORACLE_T here). */
enum { MOST_TOLD = 7 * ORACLE_T };
typedef struct told {
    uint32_t count;
    uint8_t defect[MOST_TOLD], kind[MOST_TOLD];
    uint16_t index[MOST_TOLD];
} told;
static told heard;

static void hear(void *user, nook_status defect, nook_where where) {
    told *t = (told *)user;
    if (!CHECK(t->count < MOST_TOLD && where.index <= UINT16_MAX)) return;
    t->defect[t->count] = (uint8_t)defect;
    t->kind[t->count] = (uint8_t)where.kind;
    t->index[t->count++] = (uint16_t)where.index;
}

static const nook_finder finder = {hear, &heard};

static uint32_t times_told(nook_status defect, nook_kind kind, uint32_t index) {
    uint32_t i, n = 0;
    for (i = 0; i < heard.count; i++) {
        n += heard.defect[i] == defect && heard.kind[i] == kind && heard.index[i] == index;
    }
    return n;
}

static uint32_t all_told(nook_status defect) {
    uint32_t i, n = 0;
    for (i = 0; i < heard.count; i++) n += heard.defect[i] == defect;
    return n;
}

static void survey_equals(const nook_survey *got, const nook_survey *expected) {
    CHECK_EQUAL(got->components, expected->components);
    CHECK_EQUAL(got->fans, expected->fans);
    CHECK_EQUAL(got->nonmanifold_vertices, expected->nonmanifold_vertices);
    CHECK_EQUAL(got->border_loops, expected->border_loops);
    CHECK_EQUAL(got->orientable, expected->orientable);
}

static void edges_equal(const nook_report *got, const nook_report *expected) {
    CHECK_EQUAL(got->triangles, expected->triangles);
    CHECK_EQUAL(got->edges, expected->edges);
    CHECK_EQUAL(got->border_edges, expected->border_edges);
    CHECK_EQUAL(got->matched_edges, expected->matched_edges);
    CHECK_EQUAL(got->incoherent_edges, expected->incoherent_edges);
    CHECK_EQUAL(got->nonmanifold_edges, expected->nonmanifold_edges);
    CHECK_EQUAL(got->odd_edges, expected->odd_edges);
}

static void tables_equal(void) {
    uint32_t c, v;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        if (!CHECK_EQUAL(b.mesh.O[c], truth.O[c])) return;
        if (!CHECK_EQUAL(b.mesh.V[c], b.kept[c])) return;
    }
    for (v = 0; v < b.mesh.nv; v++) {
        nook_index at = b.mesh.C[v];
        bool used = false;
        for (c = 0; c < 3 * b.mesh.nt; c++) used = used || b.mesh.V[c] == v;
        if (!CHECK(used ? at < 3 * b.mesh.nt && b.mesh.V[at] == v : at == NOOK_STORED_NONE)) return;
    }
}

/* What of shell k can be told: its corners are those whose component begins with its first triangle. */
static void shell_equals(const nook_shell *shell, uint32_t first) {
    uint32_t c, e, fans = 0, borders = 0, loops = 0, triangles = 0, vertices = 0, incoherent = 0;
    bool nonmanifold = false;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        bool again = false;
        if (truth.component[c / 3] != first) continue;
        for (e = 0; e < c; e++)
            again = again || (truth.component[e / 3] == first && b.mesh.V[e] == b.mesh.V[c]);
        vertices += !again;
        triangles += c % 3 == 0;
        fans += truth.fan[c] == c;
        borders += truth.on_edge[c] == 1;
        loops += truth.on_edge[c] == 1 && truth.loop[c] == c;
        incoherent += truth.on_edge[c] == 2 && truth.leads[c] && truth.O[c] == c;
        nonmanifold = nonmanifold || truth.on_edge[c] > 2;
    }
    CHECK_EQUAL(shell->first_triangle, first);
    CHECK_EQUAL(shell->triangles, triangles);
    CHECK_EQUAL(shell->vertices, vertices);
    CHECK_EQUAL(shell->fans, fans);
    CHECK_EQUAL(shell->has_nonmanifold_edge, nonmanifold);
    if (nonmanifold) {
        CHECK_EQUAL(nook_shell_genus(shell), NOOK_UNKNOWN);
        return;
    }
    CHECK_EQUAL(shell->border_edges, borders);
    CHECK_EQUAL(shell->incoherent_edges, incoherent);
    CHECK_EQUAL(shell->orientable, !truth.conflict[first]);
    CHECK_EQUAL(shell->border_loops, loops);
}

static void shells_equal(void) {
    uint32_t t, k = 0;
    for (t = 0; t < b.mesh.nt; t++) {
        if (truth.component[t] != t) continue;
        if (k < b.shells.max_shells) shell_equals(&b.shell[k], t);
        k++;
    }
    CHECK_EQUAL(b.shells.count, k < b.shells.max_shells ? k : b.shells.max_shells);
    for (t = 0; t < b.mesh.nt && b.shells.count == k; t++) {
        if (!CHECK_EQUAL(b.shell[b.component[t]].first_triangle, truth.component[t])) return;
    }
}

/* Every defect was told once, at its place, and nothing else. */
static void findings_equal(void) {
    uint32_t c;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        bool leads = truth.leads[c];
        bool incoherent = leads && truth.on_edge[c] == 2 && truth.O[c] == c;
        if (!CHECK_EQUAL(times_told(NOOK_BORDER_EDGE, NOOK_AT_CORNER, c), truth.on_edge[c] == 1)) return;
        if (!CHECK_EQUAL(times_told(NOOK_NONMANIFOLD_EDGE, NOOK_AT_CORNER, c), leads && truth.on_edge[c] > 2))
            return;
        if (!CHECK_EQUAL(times_told(NOOK_INCOHERENT_EDGE, NOOK_AT_CORNER, c), incoherent)) return;
        if (!CHECK(times_told(NOOK_DUPLICATE_TRIANGLE, NOOK_AT_TRIANGLE, c / 3) <= 1)) return;
    }
    CHECK_EQUAL(all_told(NOOK_DUPLICATE_TRIANGLE), truth.report.duplicate_triangles);
    CHECK_EQUAL(all_told(NOOK_NONMANIFOLD_VERTEX), truth.report.survey.nonmanifold_vertices);
}

/* Link, check, and hold everything against the oracle; without marks only what can then be known. */
static void agrees_with_the_oracle(void) {
    nook_report without;
    heard.count = 0;
    judge(&truth);
    memcpy(b.kept, b.mesh.V, 3u * b.mesh.nt * sizeof *b.kept);
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &without, NULL), NOOK_OK);
    edges_equal(&without, &truth.report);
    CHECK_EQUAL(without.duplicate_triangles,
                truth.report.nonmanifold_edges ? NOOK_UNKNOWN : truth.report.duplicate_triangles);
    CHECK_EQUAL(without.survey.components, NOOK_UNKNOWN);
    tables_equal();
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    edges_equal(&b.report, &truth.report);
    CHECK_EQUAL(b.report.duplicate_triangles, truth.report.duplicate_triangles);
    if (truth.report.nonmanifold_edges + truth.report.incoherent_edges != 0)
        survey_equals(&b.report.survey, &truth.report.survey);
    survey_equals(&b.result.survey, &truth.report.survey);
    tables_equal();
    shells_equal();
    findings_equal();
}

/* ---- surfaces with known answers --------------------------------------------------------------- */

static void named_surfaces_have_the_numbers_of_their_topology(void) {
    uint32_t i;
    for (i = 0; i < shape_count; i++) {
        const shape *s = &shapes[i];
        s->build();
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK_EQUAL(b.result.euler, s->euler);
        CHECK_EQUAL(b.result.survey.components, s->components);
        CHECK_EQUAL(b.result.survey.border_loops, s->border_loops);
        CHECK_EQUAL(b.result.survey.nonmanifold_vertices, s->nonmanifold_vertices);
        CHECK_EQUAL(b.result.survey.orientable, s->orientable);
        CHECK_EQUAL(b.report.nonmanifold_edges, 0);
        CHECK_EQUAL(nook_shell_genus(&b.shell[0]), s->genus);
        CHECK_EQUAL(b.result.handles, s->genus);
        CHECK_EQUAL(b.result.patch, s->genus == 0 && s->components == 1 && s->border_loops == 1);
        if (test_has_failed()) {
            print_text(s->name);
            print_text("\n");
        }
    }
}

static void named_surfaces_and_their_shuffles_agree_with_the_oracle(void) {
    uint32_t i, j;
    for (i = 0; i < shape_count; i++) {
        for (j = 0; j < 4; j++) {
            shapes[i].build();
            if (j > 0) shuffle(&d);
            if (j > 1) { /* and with some triangles turned over */
                turn_over(throw_dice(&d, b.mesh.nt));
            }
            agrees_with_the_oracle();
            if (test_has_failed()) return;
        }
    }
}

/* ---- edges of many triangles ------------------------------------------------------------------- */

static void edges_of_three_to_six_triangles_in_every_mix_of_directions(void) {
    uint32_t pages, turned;
    for (pages = 1; pages <= 6; pages++) {
        for (turned = 0; turned < 1u << pages; turned++) {
            book(pages, turned);
            agrees_with_the_oracle();
            if (test_has_failed()) return;
        }
    }
}

static void third_triangle_on_an_edge_is_reported_with_its_smallest_corner(void) {
    heard.count = 0;
    octahedron();
    b.mesh.nv = 7;
    place(6, 5, 5, 5);
    add(2, 4, 6); /* the edge 2-4 is faced by corner 0 of triangle 0 */
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
    CHECK_EQUAL(b.report.nonmanifold_edges, 1);
    CHECK_EQUAL(b.report.border_edges, 2);
    CHECK_EQUAL(times_told(NOOK_NONMANIFOLD_EDGE, NOOK_AT_CORNER, 0), 1);
    CHECK_EQUAL(times_told(NOOK_NONMANIFOLD_VERTEX, NOOK_AT_VERTEX, 2), 1);
    CHECK_EQUAL(times_told(NOOK_NONMANIFOLD_VERTEX, NOOK_AT_VERTEX, 4), 1);
    CHECK_EQUAL(all_told(NOOK_NONMANIFOLD_VERTEX), 2);
}

static void an_edge_of_three_triangles_is_one_odd_edge(void) {
    book(3, 0);
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(b.report.odd_edges, 1 + 6);
    book(4, 5);
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(b.report.odd_edges, 8);
}

static void link_describes_no_shells_of_an_earlier_mesh(void) {
    tetrahedron();
    b.shells.count = 5;
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, &b.shells, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(b.shells.count, 0);
}

static void two_coherent_pairs_on_one_edge_are_a_nonmanifold_edge(void) {
    static const uint8_t list[] = {0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5};
    begin_shape(6);
    add_list(list, 4);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.report.nonmanifold_edges, 1);
    CHECK_EQUAL(b.report.matched_edges, 0);
    CHECK_EQUAL(b.report.odd_edges, 8);
    CHECK_EQUAL(b.mesh.O[2], 2);
    agrees_with_the_oracle();
}

static void repeated_triangles_are_counted_whatever_their_direction(void) {
    uint32_t copies, mix, i;
    for (copies = 2; copies <= 5; copies++) {
        for (mix = 0; mix < 1u << copies; mix++) {
            begin_shape(3);
            for (i = 0; i < copies; i++) {
                if (mix >> i & 1u) {
                    add(0, 2, 1);
                } else {
                    add(1, 2, 0);
                }
            }
            agrees_with_the_oracle();
            CHECK_EQUAL(b.report.duplicate_triangles, copies - 1);
        }
    }
}

/* ---- many small worlds ------------------------------------------------------------------------- */

static void random_soup(uint32_t nv, uint32_t nt, bool hub) {
    uint32_t t;
    begin_shape(nv);
    for (t = 0; t < nt; t++) {
        uint32_t v[3];
        v[0] = hub ? 0 : throw_dice(&d, nv);
        do v[1] = throw_dice(&d, nv);
        while (v[1] == v[0]);
        do v[2] = throw_dice(&d, nv);
        while (v[2] == v[0] || v[2] == v[1]);
        add(v[0], v[1], v[2]);
    }
}

static void thousands_of_random_soups_agree_with_the_oracle(void) {
    uint32_t i;
    for (i = 0; i < 3000 && !test_has_failed(); i++) {
        random_soup(3 + throw_dice(&d, 5), throw_dice(&d, 9), throw_dice(&d, 4) == 0);
        agrees_with_the_oracle();
    }
    for (i = 0; i < 40 && !test_has_failed(); i++) {
        random_soup(8 + throw_dice(&d, 30), 20 + throw_dice(&d, 40), throw_dice(&d, 3) == 0);
        agrees_with_the_oracle();
    }
}

/* ---- hubs --------------------------------------------------------------------------------------- */

static void hub_counts(uint32_t valence, bool first) {
    nook_link_state state;
    nook_status status;
    uint32_t spent = 0, units, levels;
    hub_fan(valence, first);
    CHECK_EQUAL(nook_link_begin(&state, &b.mesh, &b.marks, NULL, NULL, &b.report), NOOK_OK);
    do {
        units = 1000;
        status = nook_link_step(&state, &units);
        spent += 1000 - units;
    } while (status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(b.report.edges, 2 * valence);
    CHECK_EQUAL(b.report.matched_edges, valence);
    CHECK_EQUAL(b.report.border_edges, valence);
    /* Heads, triangles and corners once; each of the 2 d edges of the hub at most 1.5 times in each of the
     * log2(2 d) passes of the sort (half of them are also counted off), and once to look and to split. */
    for (levels = 0; 1u << levels < 2 * valence; levels++) {
    }
    CHECK(spent <= 8 * valence + 2 * valence * (3 * (levels + 1) / 2 + 2));
}

static void hubs_of_any_valence_and_label_are_linked_in_few_steps(void) {
    hub_counts(MOST_T, true);
    hub_counts(MOST_T, false);
    hub_counts(16, true);
    hub_counts(17, true);
}

static void as_many_triangles_as_fit_are_linked_in_one_call(void) {
    hub_fan(MOST_T, true);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.edges, 2 * MOST_T);
    CHECK_EQUAL(b.result.survey.components, 1);
    CHECK_EQUAL(b.result.survey.border_loops, 1);
    CHECK_EQUAL(b.result.euler, 1);
}

/* ---- the rules of the house ---------------------------------------------------------------------- */

static void one_unit_at_a_time_gives_the_same_as_one_call(void) {
    uint32_t i, c, units;
    static nook_index O[ORACLE_C];
    for (i = 0; i < 200 && !test_has_failed(); i++) {
        nook_link_state state;
        nook_report cut;
        nook_status status;
        random_soup(4 + throw_dice(&d, 8), 1 + throw_dice(&d, 40), true);
        judge(&truth);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        memcpy(O, b.mesh.O, 3u * b.mesh.nt * sizeof *O);
        CHECK_EQUAL(nook_link_begin(&state, &b.mesh, &b.marks, NULL, NULL, &cut), NOOK_OK);
        units = 0;
        CHECK_EQUAL(nook_link_step(&state, &units), NOOK_MORE);
        do {
            units = 1;
            status = nook_link_step(&state, &units);
        } while (status == NOOK_MORE);
        CHECK_EQUAL(status, NOOK_OK);
        edges_equal(&cut, &b.report);
        CHECK_EQUAL(cut.duplicate_triangles, b.report.duplicate_triangles);
        survey_equals(&cut.survey, &b.report.survey);
        for (c = 0; c < 3 * b.mesh.nt; c++) CHECK_EQUAL(b.mesh.O[c], O[c]);
        units = 5;
        CHECK_EQUAL(nook_link_step(&state, &units), NOOK_OK);
        CHECK_EQUAL(units, 5);
    }
}

static void nothing_beyond_the_exact_arrays_is_touched(void) {
    enum { NV = 12, NT = 40 };
    static struct {
        nook_point G[NV];
        uint32_t after_G;
        nook_index V[3 * NT], after_V, O[3 * NT], after_O, C[NV], after_C;
        uint8_t Mt[NOOK_MT_BYTES(NT)], after_Mt, Mv[NOOK_MV_BYTES(NV)], after_Mv;
    } exact;
    const nook_marks marks = {exact.Mt, exact.Mv, NT, NV};
    uint32_t i;
    for (i = 0; i < 200; i++) {
        nook_mesh mesh;
        nook_report report;
        nook_check_result result;
        nook_view view;
        memset(&exact, 0x5A, sizeof exact);
        random_soup(NV, NT, i % 2u == 0);
        memcpy(exact.G, b.mesh.G, sizeof exact.G);
        memcpy(exact.V, b.mesh.V, sizeof exact.V);
        CHECK_EQUAL(nook_mesh_init(&mesh, exact.G, exact.V, exact.O, exact.C, NV, NT), NOOK_OK);
        mesh.nv = NV;
        mesh.nt = NT;
        CHECK_EQUAL(nook_link(&mesh, &marks, NULL, NULL, &report, NULL), NOOK_OK);
        view = nook_view_of(&mesh);
        CHECK_EQUAL(nook_check(&view, &marks, &report, NULL, NULL, &result), NOOK_OK);
        CHECK_EQUAL(exact.after_G, 0x5A5A5A5Au);
        CHECK_EQUAL(exact.after_V & 0xFFFFu, 0x5A5Au);
        CHECK_EQUAL(exact.after_O & 0xFFFFu, 0x5A5Au);
        CHECK_EQUAL(exact.after_C & 0xFFFFu, 0x5A5Au);
        CHECK_EQUAL(exact.after_Mt, 0x5Au);
        CHECK_EQUAL(exact.after_Mv, 0x5Au);
        CHECK(memcmp(exact.G, b.mesh.G, sizeof exact.G) == 0 &&
              memcmp(exact.V, b.mesh.V, sizeof exact.V) == 0);
    }
}

static void marks_one_short_and_null_arguments_are_refused(void) {
    nook_link_state state;
    uint32_t units = 9;
    octahedron();
    b.marks.max_nt = b.mesh.nt - 1;
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_NO_CAPACITY);
    b.marks.max_nt = b.mesh.nt;
    b.marks.max_nv = b.mesh.nv - 1;
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_NO_CAPACITY);
    b.marks.max_nv = b.mesh.nv;
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(nook_link(NULL, &b.marks, NULL, NULL, &b.report, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_link_begin(NULL, &b.mesh, &b.marks, NULL, NULL, &b.report), NOOK_NULL_ARGUMENT);
    b.marks.Mv = NULL;
    CHECK_EQUAL(nook_link_begin(&state, &b.mesh, &b.marks, NULL, NULL, &b.report), NOOK_NULL_ARGUMENT);
    b.marks.Mv = b.Mv;
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_link_begin(&state, &b.mesh, &b.marks, NULL, NULL, &b.report), NOOK_NULL_ARGUMENT);
    CHECK(nook_link_step(&state, &units) != NOOK_OK);
}

static void shells_without_their_arrays_are_refused_when_a_survey_needs_them(void) {
    nook_survey_state state;
    nook_survey survey;
    nook_view view;
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    b.shells.component = NULL;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, &b.shells, NULL, &survey),
                NOOK_NULL_ARGUMENT);
    b.shells.component = b.component;
    b.shells.stamp = NULL;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, &b.shells, NULL, &survey),
                NOOK_NULL_ARGUMENT);
    b.shells.stamp = b.stamp;
    b.shells.shell = NULL;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, &b.shells, NULL, &survey),
                NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, &b.shells, NULL, &b.report, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_check(&view, &b.marks, NULL, &b.shells, NULL, &b.result), NOOK_NULL_ARGUMENT);
}

static void a_survey_without_its_arguments_is_refused(void) {
    nook_survey_state state;
    nook_survey survey;
    nook_view view;
    uint32_t units = 9;
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_survey_begin(NULL, &view, NULL, &b.marks, NULL, NULL, &survey), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_survey_begin(&state, NULL, NULL, &b.marks, NULL, NULL, &survey), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, NULL, NULL, NULL, &survey), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    b.marks.max_nv = b.mesh.nv - 1;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, NULL, NULL, &survey), NOOK_NO_CAPACITY);
    b.marks.max_nv = b.mesh.nv;
    b.marks.max_nt = b.mesh.nt - 1;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, NULL, NULL, &survey), NOOK_NO_CAPACITY);
    b.marks.max_nt = b.mesh.nt;
    b.marks.Mv = NULL;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, NULL, NULL, &survey), NOOK_NULL_ARGUMENT);
    b.marks.Mv = b.Mv;
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_survey_begin(&state, &view, NULL, &b.marks, NULL, NULL, &survey), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_survey_step(&state, &units), NOOK_BAD_OPPOSITE);
}

static void counts_that_no_shell_has_give_no_genus(void) {
    nook_shell shell;
    memset(&shell, 0, sizeof shell);
    shell.orientable = true;
    shell.triangles = 4;
    shell.fans = 4;
    CHECK_EQUAL(nook_shell_genus(&shell), 0);
    shell.fans = 5;
    CHECK_EQUAL(nook_shell_genus(&shell), NOOK_UNKNOWN);
    for (shell.fans = 4, shell.triangles = 5; shell.triangles < 8; shell.triangles++)
        CHECK_EQUAL(nook_shell_genus(&shell), NOOK_UNKNOWN);
    CHECK_EQUAL(nook_shell_genus((shell.triangles = 8, &shell)), 1);
}

/* Two triangles that run their edge the same way, and a vertex of none. */
static void a_finder_without_a_function_hears_nothing_and_changes_nothing(void) {
    static const nook_finder silent = {NULL, NULL}, *const finders[] = {NULL, &silent, &finder};
    nook_link_state state;
    nook_report report;
    uint32_t i, left[3];
    heard.count = 0;
    begin_shape(5);
    add(0, 1, 2);
    add(0, 1, 3);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    report = b.report;
    CHECK_EQUAL(link_and_check(&silent), NOOK_OK);
    edges_equal(&b.report, &report);
    CHECK_EQUAL(b.report.incoherent_edges, 1);
    CHECK_EQUAL(b.report.border_edges, 4);
    CHECK_EQUAL(b.result.isolated_vertices, 1);
    b.mesh.nt = 1; /* borders alone take no unit more, as nobody is told of them */
    for (i = 0; i < 3; i++) {
        CHECK_EQUAL(nook_link_begin(&state, &b.mesh, &b.marks, NULL, finders[i], &report), NOOK_OK);
        left[i] = 1000;
        CHECK_EQUAL(nook_link_step(&state, &left[i]), NOOK_OK);
        CHECK_EQUAL(report.border_edges, 3);
    }
    CHECK_EQUAL(left[1], left[0]);
    CHECK(left[2] < left[0]);
}

static void an_index_out_of_range_names_its_corner(void) {
    uint32_t c;
    nook_where where;
    for (c = 0; c < 24; c++) {
        octahedron();
        b.mesh.V[c] = 6;
        CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, &where), NOOK_INDEX_OUT_OF_RANGE);
        CHECK_EQUAL(where.kind, NOOK_AT_CORNER);
        CHECK_EQUAL(where.index, c);
    }
}

static void a_repeated_vertex_names_its_triangle(void) {
    uint32_t c;
    nook_where where;
    for (c = 0; c < 24; c++) {
        octahedron();
        b.mesh.V[c] = b.mesh.V[3 * (c / 3) + (c + 1) % 3];
        CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, &where), NOOK_REPEATED_VERTEX);
        CHECK_EQUAL(where.kind, NOOK_AT_TRIANGLE);
        CHECK_EQUAL(where.index, c / 3);
    }
}

static void more_shells_than_room_are_counted_but_not_described(void) {
    uint32_t t;
    begin_shape(30);
    for (t = 0; t < 10; t++) add(3 * t, 3 * t + 1, 3 * t + 2);
    add(0, 1, 2); /* an incoherent pair, so that link surveys */
    b.shells.max_shells = 4;
    b.shell[4].triangles = 77;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.survey.components, 10);
    CHECK_EQUAL(b.shells.count, 4);
    CHECK_EQUAL(b.shell[3].first_triangle, 3);
    CHECK_EQUAL(b.shell[4].triangles, 77);
    CHECK_EQUAL(b.component[9], 9);
}

static void a_mesh_without_triangles_links_to_nothing(void) {
    begin_shape(3);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.report.edges, 0);
    CHECK_EQUAL(b.mesh.C[1], NOOK_STORED_NONE);
    begin_shape(0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
}

static void states_fit_in_256_bytes(void) {
    CHECK(sizeof(nook_link_state) <= 256);
    CHECK(sizeof(nook_survey_state) <= 256);
    CHECK(sizeof(nook_check_state) <= 256);
    CHECK(sizeof(nook_weld_state) <= 256);
    CHECK(sizeof(nook_stl) <= 256);
}

static const test tests[] = {
    TEST(named_surfaces_have_the_numbers_of_their_topology),
    TEST(named_surfaces_and_their_shuffles_agree_with_the_oracle),
    TEST(edges_of_three_to_six_triangles_in_every_mix_of_directions),
    TEST(third_triangle_on_an_edge_is_reported_with_its_smallest_corner),
    TEST(an_edge_of_three_triangles_is_one_odd_edge),
    TEST(link_describes_no_shells_of_an_earlier_mesh),
    TEST(two_coherent_pairs_on_one_edge_are_a_nonmanifold_edge),
    TEST(repeated_triangles_are_counted_whatever_their_direction),
    TEST(thousands_of_random_soups_agree_with_the_oracle),
    TEST(hubs_of_any_valence_and_label_are_linked_in_few_steps),
    TEST(as_many_triangles_as_fit_are_linked_in_one_call),
    TEST(one_unit_at_a_time_gives_the_same_as_one_call),
    TEST(nothing_beyond_the_exact_arrays_is_touched),
    TEST(marks_one_short_and_null_arguments_are_refused),
    TEST(shells_without_their_arrays_are_refused_when_a_survey_needs_them),
    TEST(a_survey_without_its_arguments_is_refused),
    TEST(counts_that_no_shell_has_give_no_genus),
    TEST(a_finder_without_a_function_hears_nothing_and_changes_nothing),
    TEST(an_index_out_of_range_names_its_corner),
    TEST(a_repeated_vertex_names_its_triangle),
    TEST(more_shells_than_room_are_counted_but_not_described),
    TEST(a_mesh_without_triangles_links_to_nothing),
    TEST(states_fit_in_256_bytes),
};

void test_link(void) { run_tests(tests, sizeof tests / sizeof *tests); }
