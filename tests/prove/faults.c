/* faults.c -- a single wrong bit or index anywhere in the tables of a sphere of 320 triangles.
 *
 * Every bit of every entry of V, O and C is flipped, and eight wrong indices in range are put into every
 * entry. Every bit of the marks is flipped at 24 moments of a run that is cut in two there, and every bit of
 * O at one. Check looks at them (with link's report and without), survey (with rings and without), geometry
 * (V in range) and, for V, link.
 *
 * Proven: no run exceeds the steps that its header states; nothing is written but what may be (fences), and
 * nothing read (AddressSanitizer); no wrong entry of V, O or C gets past check, none of V past link: the
 * answer is the very same, or a bad entry is counted, or the mesh is called unsound; and check counts each
 * wrong entry for what it is. Each answer is held against that for the whole mesh:
 *   same       every field is equal
 *   noticed    an error, a bad entry, or an unsound mesh is reported
 *   different  neither. Survey or geometry alone, and any run under which marks or O change, may give such
 *              answers; they are printed, and so are defective meshes that were called sound then */
#include <stdio.h>
#include <string.h>

#include "bounds.h"
#include "check.h"
#include "nook.h"
#include "nook_port.h"
#include "prove.h"

enum { NT = 320, NC = 3 * NT, NV = 162, MOMENTS = 24, INDICES = 8 };

static nook_mesh mesh;
static nook_marks marks;
static nook_shells shells;
static nook_report report;
static nook_index *rings;
static nook_index kept_V[NC], kept_O[NC], kept_C[NV];
static dice d = {2463534242u};

/* ---- the sphere ------------------------------------------------------------------------------------ */

static uint32_t midpoint(uint32_t v, uint32_t w, uint32_t first) {
    nook_point p = nook_make(mesh.G[v].x + mesh.G[w].x, mesh.G[v].y + mesh.G[w].y, mesh.G[v].z + mesh.G[w].z);
    uint32_t i;
    p = nook_scaled(p, 1.0f / nook_length(p));
    for (i = first; i < mesh.nv; i++) {
        if (memcmp(&mesh.G[i], &p, sizeof p) == 0) return i;
    }
    mesh.G[mesh.nv] = p;
    return mesh.nv++;
}

static void divide(void) {
    uint32_t first = mesh.nv, nt = mesh.nt, t, i;
    for (t = 0; t < nt; t++) {
        uint32_t v[3], m[3];
        for (i = 0; i < 3; i++) v[i] = mesh.V[3 * t + i];
        for (i = 0; i < 3; i++) m[i] = midpoint(v[i], v[(i + 1) % 3], first);
        for (i = 0; i < 3; i++) {
            nook_index *made = mesh.V + 3 * mesh.nt++;
            mesh.V[3 * t + i] = nook_store(m[i]);
            made[0] = nook_store(v[i]);
            made[1] = nook_store(m[i]);
            made[2] = nook_store(m[(i + 2) % 3]);
        }
    }
}

static void make_sphere(void) {
    static const uint8_t icosahedron[60] = {
        0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
        3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
    const float golden = 1.618034f;
    uint32_t v, c;
    for (v = 0; v < 12; v++) {
        float one = (v & 1u) == 0 ? -1.0f : 1.0f, long_one = (v & 2u) == 0 ? golden : -golden;
        nook_point p = v < 4   ? nook_make(one, long_one, 0)
                       : v < 8 ? nook_make(0, one, long_one)
                               : nook_make(long_one, 0, one);
        mesh.G[v] = nook_scaled(p, 1.0f / nook_length(p));
    }
    mesh.nv = 12;
    mesh.nt = 20;
    for (c = 0; c < 60; c++) mesh.V[c] = icosahedron[c];
    divide();
    divide();
}

static void make_room(void) {
    nook_point *G = fenced(NV * sizeof *G);
    nook_index *V = fenced(NC * sizeof *V), *O = fenced(NC * sizeof *O), *C = fenced(NV * sizeof *C);
    CHECK_EQUAL(nook_mesh_init(&mesh, G, V, O, C, NV, NT), NOOK_OK);
    marks.Mt = fenced(NOOK_MT_BYTES(NT));
    marks.Mv = fenced(NOOK_MV_BYTES(NV));
    marks.max_nt = NT;
    marks.max_nv = NV;
    shells.shell = fenced(NT * sizeof *shells.shell);
    shells.component = fenced(NT * sizeof *shells.component);
    shells.stamp = fenced(NV * sizeof *shells.stamp);
    shells.max_shells = NT;
    rings = fenced(NC * sizeof *rings);
}

/* ---- one fault ------------------------------------------------------------------------------------- */

static struct {
    nook_index *entry, value; /* an entry of V, O or C, and what it becomes; or */
    uint8_t *byte, bits;      /* a byte of the marks, and what flips in it */
    uint32_t moment;          /* after how many units */
} fault;

static void strike(void) {
    if (fault.entry != NULL) *fault.entry = fault.value;
    if (fault.byte != NULL) *fault.byte = (uint8_t)(*fault.byte ^ fault.bits);
}

static void restore_tables(void) {
    memcpy(mesh.V, kept_V, sizeof kept_V);
    memcpy(mesh.O, kept_O, sizeof kept_O);
    memcpy(mesh.C, kept_C, sizeof kept_C);
}

static void keep_tables(void) {
    memcpy(kept_V, mesh.V, sizeof kept_V);
    memcpy(kept_O, mesh.O, sizeof kept_O);
    memcpy(kept_C, mesh.C, sizeof kept_C);
}

/* Whether nothing but the faulty entry differs from what was kept. */
static bool only_the_fault_differs(void) {
    bool same;
    if (fault.entry != NULL && *fault.entry != fault.value) return false;
    if (fault.entry != NULL && fault.entry >= mesh.V && fault.entry < mesh.V + NC)
        *fault.entry = kept_V[fault.entry - mesh.V];
    if (fault.entry != NULL && fault.entry >= mesh.O && fault.entry < mesh.O + NC)
        *fault.entry = kept_O[fault.entry - mesh.O];
    if (fault.entry != NULL && fault.entry >= mesh.C && fault.entry < mesh.C + NV)
        *fault.entry = kept_C[fault.entry - mesh.C];
    same = memcmp(mesh.V, kept_V, sizeof kept_V) == 0 && memcmp(mesh.O, kept_O, sizeof kept_O) == 0 &&
           memcmp(mesh.C, kept_C, sizeof kept_C) == 0;
    strike();
    return same;
}

/* ---- the runs -------------------------------------------------------------------------------------- */

typedef struct answer {
    nook_status status;
    nook_check_result result;
    nook_survey survey;
    nook_geometry geometry;
    nook_report report;
} answer;

static answer now;
static uint32_t spent, bound;

typedef union any_state {
    nook_check_state check;
    nook_survey_state survey;
    nook_geometry_state geometry;
    nook_link_state link;
} any_state;

/* Step until the moment of the fault, then until done or the bound is passed. */
#define RUN_THROUGH(step, state)                                                                             \
    do {                                                                                                     \
        uint32_t units = fault.moment;                                                                       \
        if (units != 0) now.status = step((state), &units);                                                  \
        strike();                                                                                            \
        spent = fault.moment - units;                                                                        \
        units = bound + 1 - spent;                                                                           \
        now.status = step((state), &units);                                                                  \
        spent = bound + 1 - units;                                                                           \
    } while (0)

static any_state state;

static void check_with(const nook_report *given) {
    nook_view view = nook_view_of(&mesh);
    bound = check_bound(NV, NT, 0);
    CHECK_EQUAL(nook_check_begin(&state.check, &view, &marks, given, &shells, NULL, &now.result), NOOK_OK);
    RUN_THROUGH(nook_check_step, &state.check);
    CHECK(now.status == NOOK_OK || (now.status == NOOK_BAD_OPPOSITE && fault.moment != 0));
    CHECK(only_the_fault_differs());
}
static void check_with_report(void) { check_with(&report); }
static void check_alone(void) { check_with(NULL); }

static void survey_O(void) {
    nook_view view = nook_view_of(&mesh);
    bound = survey_bound(NV, NT);
    CHECK_EQUAL(nook_survey_begin(&state.survey, &view, NULL, &marks, &shells, NULL, &now.survey), NOOK_OK);
    RUN_THROUGH(nook_survey_step, &state.survey);
    CHECK(now.status == NOOK_OK || now.status == NOOK_BAD_OPPOSITE);
    CHECK(only_the_fault_differs());
}

static void survey_rings(void) {
    nook_view view = nook_view_of(&mesh);
    bound = survey_bound(NV, NT);
    strike();
    memcpy(rings, mesh.O, NC * sizeof *rings);
    view.O = rings;
    CHECK_EQUAL(nook_survey_begin(&state.survey, &view, rings, &marks, &shells, NULL, &now.survey), NOOK_OK);
    RUN_THROUGH(nook_survey_step, &state.survey);
    CHECK(now.status == NOOK_OK || now.status == NOOK_BAD_OPPOSITE);
}

static void geometry_closed(void) {
    nook_view view = nook_view_of(&mesh);
    bound = geometry_bound(NV, NT, NT);
    CHECK_EQUAL(nook_geometry_begin(&state.geometry, &view, true, &shells, NULL, &now.geometry), NOOK_OK);
    RUN_THROUGH(nook_geometry_step, &state.geometry);
    CHECK_EQUAL(now.status, NOOK_OK);
    CHECK(only_the_fault_differs());
}

/* No vertex has more than 12 edges here, so no list has a tail. */
static void link_V(void) {
    bound = link_bound(NV, NT) + link_bound_of_defects(NV, NT, true);
    memset(mesh.O, 0x55, sizeof kept_O);
    memset(mesh.C, 0x55, sizeof kept_C);
    CHECK_EQUAL(nook_link_begin(&state.link, &mesh, &marks, &shells, NULL, &now.report), NOOK_OK);
    RUN_THROUGH(nook_link_step, &state.link);
}

/* ---- what comes of it ------------------------------------------------------------------------------- */

typedef enum outcome { SAME, NOTICED, DIFFERENT, OUTCOMES } outcome;

static answer whole; /* without a fault */

static bool has_bad_entries(const nook_check_result *r) {
    return r->bad_indices + r->bad_opposites + r->bad_corners + r->repeated_vertex_triangles != 0;
}

static uint32_t defects(const nook_report *r) {
    return r->border_edges + r->incoherent_edges + r->nonmanifold_edges + r->duplicate_triangles;
}

static outcome judge(void) {
    if (memcmp(&now, &whole, sizeof now) == 0) return SAME;
    if (now.status != NOOK_OK || has_bad_entries(&now.result)) return NOTICED;
    if (nook_is_sound(&whole.result) && !nook_is_sound(&now.result)) return NOTICED;
    return defects(&now.report) > defects(&whole.report) ? NOTICED : DIFFERENT;
}

typedef struct run {
    const char *name;
    void (*run)(void);
} run;
static const run check_reported = {"check, report", check_with_report},
                 check_bare = {"check alone", check_alone}, survey_plain = {"survey", survey_O},
                 survey_ringed = {"survey, rings", survey_rings}, measured = {"geometry", geometry_closed},
                 link_whole = {"link", link_V};

static struct { uint32_t faults, count[OUTCOMES], called_sound, most; } row;
static uint32_t all_faults;

static uint32_t begin_row(const run *r) {
    memset(&row, 0, sizeof row);
    memset(&fault, 0, sizeof fault);
    memset(&now, 0, sizeof now);
    restore_tables();
    r->run();
    whole = now;
    row.most = spent;
    return spent;
}

static void try_fault(const run *r) {
    memset(&now, 0, sizeof now);
    r->run();
    row.faults++;
    all_faults++;
    row.count[judge()]++;
    row.called_sound += !nook_is_sound(&whole.result) && nook_is_sound(&now.result);
    if (spent > row.most) row.most = spent;
    CHECK(spent <= bound);
    restore_tables();
}

/* The fault is counted for what it is. */
static void expect_counted(void) {
    const nook_check_result *r = &now.result;
    if (fault.entry >= mesh.V && fault.entry < mesh.V + NC) CHECK_EQUAL(r->bad_indices, fault.value >= NV);
    if (fault.entry >= mesh.O && fault.entry < mesh.O + NC) CHECK(r->bad_opposites > 0);
    if (fault.entry >= mesh.C && fault.entry < mesh.C + NV)
        CHECK_EQUAL(r->bad_corners,
                    fault.value >= NC || mesh.V[fault.value] != (uint32_t)(fault.entry - mesh.C));
}

static void print_head(const char *what) {
    (void)printf("%s\n%-28s%-15s%8s%8s%9s%11s%13s%8s%8s\n", what, "  fault in", "seen by", "faults", "same",
                 "noticed", "different", "called sound", "units", "bound");
}

static void end_row(const char *name, const run *r) {
    (void)printf("  %-26s%-15s%8u%8u%9u%11u%13u%8u%8u\n", name, r->name, (unsigned)row.faults,
                 (unsigned)row.count[SAME], (unsigned)row.count[NOTICED], (unsigned)row.count[DIFFERENT],
                 (unsigned)row.called_sound, (unsigned)row.most, (unsigned)bound);
    CHECK(fences_hold());
}

static bool counts(const run *r) { return r == &check_reported || r == &check_bare; }

/* ---- faults that stay -------------------------------------------------------------------------------- */

static void flip_every_bit(const char *name, nook_index *table, uint32_t entries, const run *r) {
    uint32_t i, bit;
    (void)begin_row(r);
    for (i = 0; i < entries && !test_has_failed(); i++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit++) {
            fault.entry = table + i;
            fault.value = (nook_index)(table[i] ^ (nook_index)((nook_index)1u << bit));
            try_fault(r);
            if (counts(r)) expect_counted();
        }
    }
    end_row(name, r);
}

static void put_wrong_indices(const char *name, nook_index *table, uint32_t entries, uint32_t end,
                              const run *r) {
    uint32_t i, k;
    (void)begin_row(r);
    for (i = 0; i < entries && !test_has_failed(); i++) {
        for (k = 0; k < INDICES; k++) {
            fault.entry = table + i;
            fault.value = nook_store((table[i] + 1u + throw_dice(&d, end - 1u)) % end);
            try_fault(r);
            if (counts(r)) expect_counted();
        }
    }
    end_row(name, r);
}

/* Both kinds; whether a different answer is allowed. */
static void spoil(const char *name, nook_index *table, uint32_t entries, uint32_t end, const run *r,
                  bool may) {
    char label[40];
    (void)snprintf(label, sizeof label, "%s, one bit", name);
    flip_every_bit(label, table, entries, r);
    if (!may) CHECK_EQUAL(row.count[DIFFERENT], 0);
    (void)snprintf(label, sizeof label, "%s, wrong index in range", name);
    put_wrong_indices(label, table, entries, end, r);
    if (!may) CHECK_EQUAL(row.count[DIFFERENT], 0);
}

static void build(uint32_t merged, uint32_t turned) {
    uint32_t c;
    make_sphere();
    CHECK(mesh.nt == NT && mesh.nv == NV);
    for (c = 0; c < NC && merged != 0; c++) {
        if (mesh.V[c] == 0) mesh.V[c] = nook_store(merged);
    }
    if (merged != 0) mesh.nv = NV;
    if (turned != 0) {
        nook_index keep = mesh.V[3 * turned];
        mesh.V[3 * turned] = mesh.V[3 * turned + 1];
        mesh.V[3 * turned + 1] = keep;
    }
    CHECK_EQUAL(nook_link(&mesh, &marks, &shells, NULL, &report, NULL), NOOK_OK);
    keep_tables();
}

static void no_wrong_entry_of_a_closed_mesh_gets_past_check_or_link(void) {
    uint32_t since = milliseconds();
    build(0, 0);
    (void)begin_row(&check_reported);
    CHECK(nook_is_sound(&whole.result));
    print_head("a sphere, an entry wrong from the start");
    spoil("O", mesh.O, NC, NC, &check_reported, false);
    spoil("O", mesh.O, NC, NC, &check_bare, false);
    spoil("O", mesh.O, NC, NC, &survey_plain, true);
    spoil("O", mesh.O, NC, NC, &survey_ringed, true);
    spoil("O", mesh.O, NC, NC, &measured, true);
    spoil("V", mesh.V, NC, NV, &check_reported, false);
    spoil("V", mesh.V, NC, NV, &check_bare, false);
    spoil("V", mesh.V, NC, NV, &link_whole, false);
    spoil("V", mesh.V, NC, NV, &survey_plain, true);
    put_wrong_indices("V, wrong index in range", mesh.V, NC, NV, &measured);
    spoil("C", mesh.C, NV, NC, &check_reported, false);
    spoil("C", mesh.C, NV, NC, &check_bare, false);
    spoil("C", mesh.C, NV, NC, &survey_plain, true);
    print_figure("  all of these", all_faults, "faults", since);
}

/* ---- faults that come while a run is under way -------------------------------------------------------- */

static void flip_marks(const char *name, uint8_t *bits, size_t bytes, const run *r) {
    uint32_t units = begin_row(r), in_use = 24 * NT + 6 * NV, k; /* geometry, which follows, has no marks */
    size_t i;
    if (units > in_use) units = in_use;
    for (i = 0; i < 8 * bytes && !test_has_failed(); i++) {
        for (k = 0; k < MOMENTS; k++) {
            fault.byte = bits + i / 8;
            fault.bits = (uint8_t)(1u << i % 8);
            fault.moment = 1u + (units - 1u) * k / MOMENTS + throw_dice(&d, units / MOMENTS);
            try_fault(r);
        }
    }
    end_row(name, r);
}

static void flip_marks_in(const run *r) {
    flip_marks("Mt, one bit", marks.Mt, NOOK_MT_BYTES(NT), r);
    flip_marks("Mv, one bit", marks.Mv, NOOK_MV_BYTES(NV), r);
}

static void flip_O_in(const run *r) {
    uint32_t units = begin_row(r), i, bit;
    for (i = 0; i < NC && !test_has_failed(); i++) {
        for (bit = 0; bit < NOOK_INDEX_BITS; bit++) {
            fault.entry = mesh.O + i;
            fault.value = (nook_index)(mesh.O[i] ^ (nook_index)((nook_index)1u << bit));
            fault.moment = 1u + throw_dice(&d, units - 1u);
            try_fault(r);
        }
    }
    end_row("O, one bit", r);
}

static void marks_that_change_underneath_neither_hold_a_run_nor_lead_it_astray(void) {
    build(0, 0);
    print_head("a sphere, a bit changes between two steps");
    flip_marks_in(&check_reported);
    flip_marks_in(&survey_plain);
    flip_O_in(&check_reported);
    flip_O_in(&survey_plain);
    build(3, 0); /* two vertices far from each other become one: a non-manifold vertex */
    print_head("a pinched sphere, a bit changes between two steps");
    flip_marks_in(&check_reported);
    build(0, 7);
    print_head("a sphere with one triangle turned over, a bit changes between two steps");
    flip_marks_in(&link_whole);
    flip_marks_in(&survey_ringed);
}

static const test tests[] = {
    TEST(no_wrong_entry_of_a_closed_mesh_gets_past_check_or_link),
    TEST(marks_that_change_underneath_neither_hold_a_run_nor_lead_it_astray),
};

int main(void) {
    make_room();
    run_tests(tests, sizeof tests / sizeof *tests);
    drop_fences();
    return finish_tests();
}
