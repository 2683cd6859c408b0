/* fuzz_mesh.c -- any indices, any coordinates, any options, any slices, through weld, drop, link and check.
 *
 * The input begins with the sizes and the options, then come V and G, then what is written over O and C at
 * the end, then the slices. Everything is done twice, in one call and in slices, on tables in heap blocks of
 * exactly their size. Must hold: the statuses are those of the headers; no more units than they state; both
 * runs take the same units and leave the same tables, reports, results, shells and finds; an error leaves
 * the mesh as it was; welded points differ; O pairs corners; report, survey and O are those of the naive
 * oracle of the tests; what is called sound is closed, coherent and of single fans; and nothing is sound once
 * O has been written over, unless with the same again. */
#include "bounds.h"
#include "fuzz.h"
#include "oracle.h"

enum { MOST_FUZZ_V = 48, MOST_FUZZ_T = 40 };

/* ---- the input -------------------------------------------------------------------------------------- */

static struct { const uint8_t *at, *end; } input;

static uint32_t next_byte(void) { return input.at < input.end ? *input.at++ : 0; }

static uint32_t next_word(void) {
    uint32_t i, word = 0;
    for (i = 0; i < 4; i++) word = word << 8 | next_byte();
    return word;
}

enum {
    V_OF_ANY_BITS = 1,
    G_OF_ANY_BITS = 2,
    WITH_WELD = 4,
    SCRATCH_OF_ITS_OWN = 8,
    WITH_MARKS = 16,
    WITH_SHELLS = 32,
    WITH_FINDER = 64,
    WITH_REPORT = 128
};

static struct {
    uint32_t nv, nt, options, max_shells;
    nook_point G[MOST_FUZZ_V];
    nook_index V[3 * MOST_FUZZ_T];
    uint32_t spoiled, place[8]; /* entries of O, then of C, */
    nook_index by[8];           /* and what is written there */
} given;

static bool is_given(uint32_t option) { return (given.options & option) != 0; }

static nook_index next_index(uint32_t end) {
    uint32_t byte = next_byte();
    if (!is_given(V_OF_ANY_BITS)) return nook_store(byte % end);
    return byte == 254 ? NOOK_STORED_NONE : byte == 255 ? (nook_index)next_word() : nook_store(byte);
}

static nook_point next_point(void) {
    uint32_t byte;
    if (is_given(G_OF_ANY_BITS)) {
        float x = nook_float_from(next_word()), y = nook_float_from(next_word());
        return nook_make(x, y, nook_float_from(next_word()));
    }
    byte = next_byte();
    return nook_make((float)(byte & 3u), (float)(byte >> 2 & 3u), (byte >> 4 & 1u) != 0 ? 1.0f : -0.0f);
}

static void read_input(const uint8_t *data, size_t size) {
    uint32_t i;
    input.at = data;
    input.end = data + size;
    given.nv = 1 + next_byte() % MOST_FUZZ_V;
    given.nt = next_byte() % (MOST_FUZZ_T + 1);
    given.options = next_byte();
    given.max_shells = next_byte() % 8 < 4 ? given.nt : next_byte() % 4;
    for (i = 0; i < 3 * given.nt; i++) given.V[i] = next_index(given.nv);
    for (i = 0; i < given.nv; i++) given.G[i] = next_point();
    given.spoiled = next_byte() % 9;
    for (i = 0; i < given.spoiled; i++) {
        given.place[i] = next_byte() + 256 * (next_byte() % 2);
        given.by[i] = next_index(3 * given.nt + 2);
    }
}

/* ---- one run ----------------------------------------------------------------------------------------- */

typedef struct finds {
    uint32_t count, digest, of[NOOK_STATUS_COUNT];
} finds;

/* All that may have been written. */
typedef struct snapshot {
    nook_point G[MOST_FUZZ_V];
    nook_index V[3 * MOST_FUZZ_T], O[3 * MOST_FUZZ_T], C[MOST_FUZZ_V], component[MOST_FUZZ_T];
    nook_shell shell[MOST_FUZZ_T];
    uint32_t nv, nt, shells;
} snapshot;

typedef struct outcome {
    nook_status weld, link, check, survey;
    nook_where weld_where, link_where;
    uint32_t dropped, units; /* units: of all calls together, however they were cut */
    snapshot linked, spoiled;
    nook_report report;
    nook_check_result result, spoiled_result;
    nook_survey spoiled_survey;
    finds finds;
} outcome;

static nook_mesh mesh;
static nook_marks marks;
static nook_shells shells;
static outcome *now;
static bool sliced;
static const uint8_t *slice; /* the next slice size; after the last one the first again */

static void hear(void *user, nook_status defect, nook_where where) {
    finds *f = user;
    EXPECT(defect > NOOK_NO_CAPACITY && defect < NOOK_STATUS_COUNT);
    if (where.kind == NOOK_AT_VERTEX) EXPECT(where.index < mesh.nv);
    if (where.kind == NOOK_AT_CORNER) EXPECT(where.index < 3 * mesh.nt);
    if (where.kind == NOOK_AT_TRIANGLE) EXPECT(where.index < mesh.nt);
    f->count++;
    f->of[defect]++;
    f->digest = 31u * (31u * (31u * f->digest + (uint32_t)defect) + (uint32_t)where.kind) + where.index;
}
static nook_finder finder = {hear, NULL};

static uint32_t next_slice(uint32_t bound) {
    if (!sliced) return bound + 1;
    if (slice >= input.end) slice = input.at;
    return slice < input.end ? 1u + *slice++ % 32u : 1u;
}

/* Call step until it is done; more units than stated fail. */
#define STEP_THROUGH(status, step, state, stated)                                                            \
    do {                                                                                                     \
        uint32_t most = (stated), spent = 0, units, slice_units;                                             \
        do {                                                                                                 \
            units = slice_units = next_slice(most);                                                          \
            (status) = step((state), &units);                                                                \
            EXPECT(units <= slice_units);                                                                    \
            spent += slice_units - units;                                                                    \
            EXPECT(spent <= most);                                                                           \
        } while ((status) == NOOK_MORE);                                                                     \
        if ((status) == NOOK_OK) now->units += spent;                                                        \
    } while (0)

static void make_tables(void) {
    nook_point *G = exact(given.G, given.nv * sizeof *G);
    nook_index *V = exact(given.V, 3 * given.nt * sizeof *V), *O = exact(NULL, 3 * given.nt * sizeof *O);
    nook_index *C = exact(NULL, given.nv * sizeof *C);
    EXPECT(nook_mesh_init(&mesh, G, V, O, C, given.nv, given.nt) == NOOK_OK);
    mesh.nv = given.nv;
    mesh.nt = given.nt;
    marks.Mt = exact(NULL, NOOK_MT_BYTES(given.nt));
    marks.Mv = exact(NULL, NOOK_MV_BYTES(given.nv));
    marks.max_nt = given.nt;
    marks.max_nv = given.nv;
    shells.shell = exact(NULL, given.max_shells * sizeof *shells.shell);
    shells.component = exact(NULL, given.nt * sizeof *shells.component);
    shells.stamp = exact(NULL, given.nv * sizeof *shells.stamp);
    shells.max_shells = given.max_shells;
    shells.count = 0;
    finder.user = &now->finds;
}

static void free_tables(void) {
    free(mesh.G);
    free(mesh.V);
    free(mesh.O);
    free(mesh.C);
    free(marks.Mt);
    free(marks.Mv);
    free(shells.shell);
    free(shells.component);
    free(shells.stamp);
}

static nook_shells *the_shells(void) { return is_given(WITH_SHELLS) ? &shells : NULL; }
static const nook_finder *the_finder(void) { return is_given(WITH_FINDER) ? &finder : NULL; }

/* ---- weld and drop ------------------------------------------------------------------------------------- */

static bool same_point(uint32_t v, uint32_t w) {
    return mesh.G[v].x == mesh.G[w].x && mesh.G[v].y == mesh.G[w].y && mesh.G[v].z == mesh.G[w].z;
}

static void expect_welded(void) {
    uint32_t v, w, c;
    EXPECT(mesh.nv >= 1 && mesh.nv <= given.nv);
    for (v = 0; v < mesh.nv; v++) {
        for (w = 0; w < v; w++) EXPECT(!same_point(v, w));
    }
    for (c = 0; c < 3 * mesh.nt; c++) {
        const nook_point *p = &given.G[given.V[c]], *q = &mesh.G[mesh.V[c]];
        EXPECT(mesh.V[c] < mesh.nv && p->x == q->x && p->y == q->y && p->z == q->z);
    }
}

static void expect_unchanged(void) {
    EXPECT(mesh.nv == given.nv && mesh.nt == given.nt);
    EXPECT(memcmp(mesh.G, given.G, given.nv * sizeof *mesh.G) == 0);
    EXPECT(given.nt == 0 || memcmp(mesh.V, given.V, 3 * given.nt * sizeof *mesh.V) == 0);
}

static void weld(void) {
    bool own = is_given(SCRATCH_OF_ITS_OWN) || given.nv > 3 * given.nt;
    nook_index *map = own ? exact(NULL, given.nv * sizeof *map) : mesh.C;
    nook_index *order = own ? exact(NULL, NOOK_WELD_SCRATCH(given.nv) * sizeof *order) : mesh.O;
    nook_weld_state state;
    EXPECT(nook_weld_begin(&state, &mesh, map, order) == NOOK_OK);
    STEP_THROUGH(now->weld, nook_weld_step, &state, weld_bound(given.nv, given.nt));
    now->weld_where = state.where;
    if (now->weld == NOOK_OK) {
        expect_welded();
    } else {
        EXPECT(now->weld == NOOK_INDEX_OUT_OF_RANGE || now->weld == NOOK_NOT_FINITE ||
               now->weld == NOOK_COORDINATE_TOO_LARGE);
        expect_unchanged();
    }
    if (own) free(map);
    if (own) free(order);
}

static bool is_degenerate(uint32_t t) {
    const nook_index *v = mesh.V + 3 * t;
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
}

static void drop(void) {
    uint32_t t, n = 0, nt = mesh.nt;
    for (t = 0; t < nt; t++) n += is_degenerate(t);
    now->dropped = nook_drop_degenerate(&mesh);
    EXPECT(now->dropped == n && mesh.nt == nt - n);
    for (t = 0; t < mesh.nt; t++) EXPECT(!is_degenerate(t));
}

/* ---- link ---------------------------------------------------------------------------------------------- */

static uint32_t bound_of_link(void) {
    uint32_t at[MOST_FUZZ_V] = {0}, bound = link_bound(mesh.nv, mesh.nt), c, v;
    for (c = 0; c < 3 * mesh.nt; c++) {
        uint32_t a = mesh.V[nook_next(c)], b_end = mesh.V[nook_prev(c)], low = a < b_end ? a : b_end;
        if (low < mesh.nv) at[low]++;
    }
    for (v = 0; v < mesh.nv; v++) bound += at[v] > 16 ? tail_bound(at[v] - 16) : 0;
    return bound + link_bound_of_defects(mesh.nv, mesh.nt, is_given(WITH_MARKS));
}

static void expect_bad_V(void) {
    const nook_where *w = &now->link_where;
    if (now->link == NOOK_INDEX_OUT_OF_RANGE) {
        EXPECT(w->kind == NOOK_AT_CORNER && w->index < 3 * mesh.nt && mesh.V[w->index] >= mesh.nv);
    } else {
        EXPECT(now->link == NOOK_REPEATED_VERTEX && w->kind == NOOK_AT_TRIANGLE && w->index < mesh.nt);
        EXPECT(is_degenerate(w->index));
    }
}

static void link_mesh(void) {
    nook_link_state state;
    nook_index *before = exact(mesh.V, 3 * mesh.nt * sizeof *before);
    EXPECT(nook_link_begin(&state, &mesh, is_given(WITH_MARKS) ? &marks : NULL, the_shells(), the_finder(),
                           &now->report) == NOOK_OK);
    STEP_THROUGH(now->link, nook_link_step, &state, bound_of_link());
    now->link_where = state.where;
    EXPECT(memcmp(before, mesh.V, 3 * mesh.nt * sizeof *before) == 0);
    free(before);
    if (now->link == NOOK_OK) return;
    expect_bad_V();
    memset(&now->report, 0, sizeof now->report); /* how far the count had come depends on the slices */
    now->report.triangles = mesh.nt;
}

static bool pairs_corners(uint32_t c) {
    uint32_t o = mesh.O[c];
    if (o == c) return true;
    return o < 3 * mesh.nt && mesh.O[o] == c && mesh.V[nook_next(c)] == mesh.V[nook_prev(o)] &&
           mesh.V[nook_prev(c)] == mesh.V[nook_next(o)];
}

static oracle judged;

/* The second run must come to the V that was judged in the first. */
static void judge_mesh(void) {
    if (sliced) {
        EXPECT(b.mesh.nt == mesh.nt && b.mesh.nv == mesh.nv);
        EXPECT(memcmp(b.mesh.V, mesh.V, 3 * mesh.nt * sizeof *mesh.V) == 0);
        return;
    }
    begin_shape(mesh.nv);
    memcpy(b.mesh.V, mesh.V, 3 * mesh.nt * sizeof *mesh.V);
    b.mesh.nt = mesh.nt;
    judge(&judged);
}

static void expect_survey(const nook_survey *s) {
    const nook_survey *j = &judged.report.survey;
    EXPECT(s->components == j->components && s->fans == j->fans);
    EXPECT(s->nonmanifold_vertices == j->nonmanifold_vertices && s->border_loops == j->border_loops);
    EXPECT(s->orientable == j->orientable);
}

static void expect_linked(void) {
    const nook_report *r = &now->report, *j = &judged.report;
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) EXPECT(pairs_corners(c) && mesh.O[c] == judged.O[c]);
    EXPECT(r->triangles == mesh.nt && r->edges == j->edges && r->border_edges == j->border_edges);
    EXPECT(r->matched_edges == j->matched_edges && r->incoherent_edges == j->incoherent_edges);
    EXPECT(r->nonmanifold_edges == j->nonmanifold_edges && r->odd_edges == j->odd_edges);
    if (is_given(WITH_MARKS) || r->nonmanifold_edges == 0)
        EXPECT(r->duplicate_triangles == j->duplicate_triangles);
    if (is_given(WITH_MARKS) && r->incoherent_edges + r->nonmanifold_edges != 0) expect_survey(&r->survey);
}

/* ---- check --------------------------------------------------------------------------------------------- */

static void check_mesh(nook_check_result *result) {
    nook_check_state state;
    nook_view view = nook_view_of(&mesh);
    uint32_t bound = check_bound(mesh.nv, mesh.nt, mesh.nt);
    EXPECT(nook_check_begin(&state, &view, &marks, is_given(WITH_REPORT) ? &now->report : NULL, the_shells(),
                            the_finder(), result) == NOOK_OK);
    STEP_THROUGH(now->check, nook_check_step, &state, bound);
    EXPECT(now->check == NOOK_OK);
}

static uint32_t bad_entries(const nook_check_result *r) {
    return r->bad_indices + r->bad_opposites + r->bad_corners + r->repeated_vertex_triangles;
}

static void expect_checked(void) {
    const nook_check_result *r = &now->result;
    const nook_report *j = &judged.report;
    uint32_t v, bad = 0;
    bool closed = mesh.nt != 0 && j->border_edges + j->incoherent_edges + j->nonmanifold_edges == 0;
    for (v = 0; v < mesh.nv; v++) bad += nook_point_status(mesh.G[v]) != NOOK_OK;
    EXPECT(bad_entries(r) == 0 && r->bad_coordinates == bad);
    EXPECT(r->isolated_vertices == mesh.nv - judged.used_vertices);
    if (nook_is_sound(r)) EXPECT(closed && bad == 0 && j->survey.nonmanifold_vertices == 0);
    if (!is_given(WITH_REPORT)) {
        EXPECT(!nook_is_sound(r) && r->edges == NOOK_UNKNOWN);
        return;
    }
    EXPECT(r->edges == j->edges && r->border_edges == j->border_edges);
    EXPECT((r->watertight == NOOK_YES) == (mesh.nt != 0 && j->border_edges + j->nonmanifold_edges == 0));
    EXPECT((r->oriented == NOOK_YES) == (j->incoherent_edges == 0));
    if (is_given(WITH_MARKS) || j->incoherent_edges + j->nonmanifold_edges == 0) expect_survey(&r->survey);
}

/* Write over O and C, and look again. */
static void check_spoiled(void) {
    nook_survey_state state;
    nook_view view = nook_view_of(&mesh);
    uint32_t i, all = 3 * mesh.nt + mesh.nv;
    for (i = 0; i < given.spoiled; i++) {
        uint32_t place = given.place[i] % all;
        *(place < 3 * mesh.nt ? &mesh.O[place] : &mesh.C[place - 3 * mesh.nt]) = given.by[i];
    }
    check_mesh(&now->spoiled_result);
    for (i = 0; i < 3 * mesh.nt && mesh.O[i] == judged.O[i]; i++) {
    }
    if (i < 3 * mesh.nt) EXPECT(!nook_is_sound(&now->spoiled_result));
    EXPECT(nook_survey_begin(&state, &view, is_given(WITH_REPORT) ? mesh.O : NULL, &marks, the_shells(),
                             the_finder(), &now->spoiled_survey) == NOOK_OK);
    STEP_THROUGH(now->survey, nook_survey_step, &state, survey_bound(mesh.nv, mesh.nt));
    EXPECT(now->survey == NOOK_OK || now->survey == NOOK_BAD_OPPOSITE);
}

/* ---- both runs ---------------------------------------------------------------------------------------- */

static void keep(snapshot *to) {
    memcpy(to->G, mesh.G, mesh.nv * sizeof *mesh.G);
    memcpy(to->V, mesh.V, 3 * mesh.nt * sizeof *mesh.V);
    memcpy(to->O, mesh.O, 3 * mesh.nt * sizeof *mesh.O);
    memcpy(to->C, mesh.C, mesh.nv * sizeof *mesh.C);
    to->nv = mesh.nv;
    to->nt = mesh.nt;
    if (!is_given(WITH_SHELLS)) return;
    to->shells = shells.count;
    memcpy(to->shell, shells.shell, shells.count * sizeof *shells.shell);
    memcpy(to->component, shells.component, mesh.nt * sizeof *shells.component);
}

static void work(void) {
    if (is_given(WITH_WELD)) weld();
    if (now->weld != NOOK_OK) return;
    drop();
    link_mesh();
    if (now->link == NOOK_OK) {
        judge_mesh();
        expect_linked();
        check_mesh(&now->result);
        expect_checked();
        keep(&now->linked);
        check_spoiled();
        keep(&now->spoiled);
    } else {
        check_mesh(&now->result);
        EXPECT(bad_entries(&now->result) != 0 && !nook_is_sound(&now->result));
    }
}

static void run(outcome *to, bool in_slices) {
    memset(to, 0, sizeof *to);
    now = to;
    sliced = in_slices;
    slice = input.at;
    make_tables();
    work();
    free_tables();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static outcome whole, cut;
    read_input(data, size);
    run(&whole, false);
    run(&cut, true);
    EXPECT(memcmp(&whole, &cut, sizeof whole) == 0);
    return 0;
}
