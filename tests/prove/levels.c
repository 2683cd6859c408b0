/* levels.c -- levels of detail, replayed against full copies of the tables; all records of small meshes; records and tables
 * of any bits.
 *
 *   copies   meshes of up to 600 triangles with borders, handles and hubs: at every level all tables are copied when it is
 *            reached first, C named at random before; then steps up and down at random, and now and then another collapse,
 *            which begins other levels. After each step V, O, C, G and colors are compared byte by byte
 *   large    20,000 triangles, down by some 9,000 collapses and 100 times up and down; nook_digest() at both ends and on the way
 *   records  all values of c, o, v, e and f, from 0 to the first beyond and none, on meshes of up to eight triangles, with
 *            any C to restore: how many are accepted is known from V alone (each choice of two edges of a vertex, or of one at
 *            a border, by either side, times the choices of numbers); and of each one that is, nook_levels_coarsen() is the
 *            inverse. As a collapse keeps a mesh manifold only if it was, what was split was
 *   any      records of any bits on tables of any bits, in arrays that end where the tables may: nothing is written beyond
 *            (fences) nor read (AddressSanitizer), and what is refused has changed nothing */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "nook.h"
#include "prove.h"

static nook_mesh mesh;
static nook_levels levels;
static uint8_t *color;
static dice d = {1};

/* ---- meshes ------------------------------------------------------------------------------------------ */

static void make_room(uint32_t nv, uint32_t nt) {
    nook_point *G = fenced(nv * sizeof *G);
    nook_index *V = fenced(3 * nt * sizeof *V), *O = fenced(3 * nt * sizeof *O), *C = fenced(nv * sizeof *C);
    CHECK_EQUAL(nook_mesh_init(&mesh, G, V, O, C, nv, nt), NOOK_OK);
    color = fenced(nt);
}

static void add(uint32_t v, uint32_t w, uint32_t x) {
    nook_index *V = mesh.V + 3 * mesh.nt++;
    V[0] = nook_store(v), V[1] = nook_store(w), V[2] = nook_store(x);
}

static void link_mesh(void) {
    static uint8_t Mt[NOOK_MT_BYTES(21000)], Mv[NOOK_MV_BYTES(21000)];
    nook_marks marks = {Mt, Mv, 21000, 21000};
    nook_report report;
    uint32_t v;
    for (v = 0; v < mesh.nv; v++) mesh.G[v] = nook_make((float)(v % 31), (float)(v * v % 57), (float)v);
    CHECK_EQUAL(nook_link(&mesh, &marks, NULL, NULL, &report, NULL), NOOK_OK);
    CHECK(report.nonmanifold_edges + report.incoherent_edges + report.duplicate_triangles == 0);
}

/* Cells of two triangles, closed in either direction or not, with a hole every so many. */
static void cells(uint32_t columns, uint32_t rows, bool wrap_x, bool wrap_y, uint32_t holes) {
    uint32_t wide = columns + !wrap_x, high = rows + !wrap_y, x, y;
    mesh.nv = wide * high;
    mesh.nt = 0;
    for (y = 0; y < rows; y++) {
        for (x = 0; x < columns; x++) {
            uint32_t a = y * wide + x, b = y * wide + (x + 1) % wide,
                     c = (y + 1) % high * wide + (x + 1) % wide, e = (y + 1) % high * wide + x;
            if (holes != 0 && (y * columns + x) % holes == holes - 1) continue;
            add(a, b, c);
            add(a, c, e);
        }
    }
    link_mesh();
}

/* Two hubs, or one and a border. */
static void cones(uint32_t rim, bool both) {
    uint32_t i;
    mesh.nv = rim + 1 + both;
    mesh.nt = 0;
    for (i = 0; i < rim; i++) add(rim, i, (i + 1) % rim);
    for (i = 0; i < rim && both; i++) add(rim + 1, (i + 1) % rim, i);
    link_mesh();
}

static void make_shape(uint32_t kind) {
    switch (kind) {
    case 0: cells(17, 17, true, true, 0); break;
    case 1: cells(16, 16, false, false, 0); break;
    case 2: cells(16, 18, false, true, 23); break;
    case 3: cells(17, 17, true, true, 29); break;
    case 4: cones(300, true); break;
    default: cones(300, false);
    }
}
enum { KINDS = 6 };

static void name_corners(void) {
    nook_view view = nook_view_of(&mesh);
    uint32_t v;
    for (v = 0; v < mesh.nv; v++) {
        uint32_t c = mesh.C[v], turns = throw_dice(&d, 8);
        for (; turns > 0; turns--) {
            uint32_t x = nook_turn(&view, c, true);
            c = x == NOOK_NONE ? c : x;
        }
        mesh.C[v] = nook_store(c);
    }
}

static nook_point any_place(uint32_t c) {
    nook_point p = mesh.G[mesh.V[nook_next(c)]], q = mesh.G[mesh.V[nook_prev(c)]];
    float s = (float)throw_dice(&d, 9) * 0.125f;
    return nook_make(p.x * s + q.x * (1 - s), p.y * s + q.y * (1 - s), p.z * s + q.z * (1 - s));
}

static bool collapse_any(uint32_t tries, const nook_edit *edit) {
    for (; tries > 0; tries--) {
        uint32_t c = throw_dice(&d, 3 * mesh.nt);
        if (nook_levels_collapse(&levels, &mesh, c, any_place(c), edit) == NOOK_OK) return true;
    }
    return false;
}

/* ---- copies ------------------------------------------------------------------------------------------ */

enum { COPY_T = 600, COPY_V = 600, COPIES = 330 };
static struct {
    uint32_t nv, nt;
    nook_point G[COPY_V];
    nook_index V[3 * COPY_T], O[3 * COPY_T], C[COPY_V];
    uint8_t color[COPY_T];
} copy[COPIES + 1];

static void copy_level(void) {
    uint32_t i = levels.level;
    copy[i].nv = mesh.nv;
    copy[i].nt = mesh.nt;
    memcpy(copy[i].G, mesh.G, mesh.nv * sizeof *mesh.G);
    memcpy(copy[i].V, mesh.V, 3 * mesh.nt * sizeof *mesh.V);
    memcpy(copy[i].O, mesh.O, 3 * mesh.nt * sizeof *mesh.O);
    memcpy(copy[i].C, mesh.C, mesh.nv * sizeof *mesh.C);
    memcpy(copy[i].color, color, mesh.nt);
}

static bool is_copy(void) {
    uint32_t i = levels.level;
    if (copy[i].nv != mesh.nv || copy[i].nt != mesh.nt) return false;
    return memcmp(copy[i].G, mesh.G, mesh.nv * sizeof *mesh.G) == 0 &&
           memcmp(copy[i].V, mesh.V, 3 * mesh.nt * sizeof *mesh.V) == 0 &&
           memcmp(copy[i].O, mesh.O, 3 * mesh.nt * sizeof *mesh.O) == 0 &&
           memcmp(copy[i].C, mesh.C, mesh.nv * sizeof *mesh.C) == 0 &&
           memcmp(copy[i].color, color, mesh.nt) == 0;
}

static void every_level_is_the_copy_that_was_made_of_it(void) {
    uint32_t kind, i, start = milliseconds(), steps = 0, collapses = 0;
    nook_vertex_split *splits = fenced(COPIES * sizeof *splits);
    nook_edit edit = {.color = NULL};
    for (kind = 0; kind < 4 * KINDS && !test_has_failed(); kind++) {
        make_room(COPY_V, COPY_T);
        make_shape(kind % KINDS);
        name_corners();
        edit.color = color;
        edit.max_valence = kind < KINDS ? 0 : 12;
        for (i = 0; i < mesh.nt; i++) color[i] = (uint8_t)throw_dice(&d, 256);
        levels = nook_levels_in(splits, COPIES);
        copy_level();
        while (collapse_any(100, &edit)) copy_level(), collapses++;
        for (i = 0; i < 8000 && !test_has_failed(); i++) {
            uint32_t goal = throw_dice(&d, 2 * levels.count + 1), ways = throw_dice(&d, 60);
            for (; ways > 0 && is_copy(); ways--, steps++) {
                bool up = goal < levels.level;
                if (!up && levels.level == levels.count) break;
                CHECK_EQUAL(up ? nook_levels_refine(&levels, &mesh, &edit)
                               : nook_levels_coarsen(&levels, &mesh, &edit),
                            NOOK_OK);
            }
            CHECK(is_copy());
            if (i % 100 == 0 && levels.level < COPIES && collapse_any(10, &edit)) {
                copy_level(), collapses++;
                while (throw_dice(&d, 20) != 0 && collapse_any(10, &edit)) copy_level(), collapses++;
            }
        }
        CHECK(fences_hold());
        drop_fences();
        splits = fenced(COPIES * sizeof *splits);
    }
    drop_fences();
    print_figure("steps on meshes of up to 600 triangles", steps, "levels compared with copies", start);
    (void)printf("  %u collapses recorded\n", (unsigned)collapses);
}

/* ---- large ------------------------------------------------------------------------------------------- */

enum { LARGE = 9900, EVERY = 500, ROUNDS = 100 };

static uint32_t digest(void) {
    nook_view view = nook_view_of(&mesh);
    return nook_digest(&view);
}

static void a_large_mesh_is_the_same_after_a_hundred_rounds(void) {
    static uint32_t known[LARGE + 1];
    nook_vertex_split *splits = fenced(LARGE * sizeof *splits);
    const nook_edit edit = {.max_valence = 20};
    uint32_t start = milliseconds(), steps = 0, round;
    make_room(10000, 20000);
    cells(100, 100, true, true, 0);
    name_corners();
    levels = nook_levels_in(splits, LARGE);
    known[0] = digest();
    while (levels.level < LARGE && collapse_any(1000, &edit)) {
        if (levels.level % EVERY == 0) known[levels.level] = digest();
    }
    known[levels.level] = digest();
    print_figure("a torus of 20,000 triangles", levels.level, "collapses", start);
    start = milliseconds();
    for (round = 0; round < 2 * ROUNDS && !test_has_failed(); round++) {
        bool up = round % 2 == 0;
        while (up ? levels.level > 0 : levels.level < levels.count) {
            if (up) CHECK_EQUAL(nook_levels_refine(&levels, &mesh, NULL), NOOK_OK);
            if (!up) CHECK_EQUAL(nook_levels_coarsen(&levels, &mesh, NULL), NOOK_OK);
            if ((levels.level + round) % EVERY == 0 && known[levels.level] != 0)
                CHECK_EQUAL(digest(), known[levels.level]);
            steps++;
        }
        CHECK_EQUAL(digest(), known[levels.level]);
    }
    CHECK(fences_hold());
    drop_fences();
    print_figure("100 times up and down", steps, "steps", start);
}

/* ---- all records ------------------------------------------------------------------------------------- */

enum { SMALL_T = 12, SMALL_V = 16 };
static struct {
    nook_point G[SMALL_V];
    nook_index V[3 * SMALL_T], O[3 * SMALL_T], C[SMALL_V];
} kept;

static void keep(uint32_t nv, uint32_t nt) {
    memcpy(kept.G, mesh.G, nv * sizeof *kept.G);
    memcpy(kept.V, mesh.V, 3 * nt * sizeof *kept.V);
    memcpy(kept.O, mesh.O, 3 * nt * sizeof *kept.O);
    memcpy(kept.C, mesh.C, nv * sizeof *kept.C);
}

static bool is_kept(uint32_t nv, uint32_t nt) {
    return memcmp(kept.G, mesh.G, nv * sizeof *kept.G) == 0 &&
           memcmp(kept.V, mesh.V, 3 * nt * sizeof *kept.V) == 0 &&
           memcmp(kept.O, mesh.O, 3 * nt * sizeof *kept.O) == 0;
}

static bool corners_hold(void) {
    uint32_t v;
    for (v = 0; v < mesh.nv; v++) {
        if (mesh.C[v] >= 3 * mesh.nt || mesh.V[mesh.C[v]] != v) return false;
    }
    return true;
}

static void make_small(uint32_t which) {
    uint32_t i;
    mesh.nt = 0;
    switch (which) {
    case 0: mesh.nv = 3, add(0, 1, 2); break;
    case 1: mesh.nv = 4, add(0, 1, 2), add(2, 1, 3); break;
    case 2: mesh.nv = 4, add(0, 1, 2), add(0, 2, 3), add(0, 3, 1); break;
    case 3: mesh.nv = 4, add(0, 2, 1), add(0, 1, 3), add(1, 2, 3), add(2, 0, 3); break;
    case 4: mesh.nv = 6, add(0, 1, 2), add(0, 2, 3), add(0, 3, 4), add(0, 4, 5); break;
    case 5: mesh.nv = 6, add(0, 1, 2), add(1, 3, 4), add(1, 4, 2), add(2, 4, 5); break;
    default:
        for (mesh.nv = 6, i = 0; i < 8; i++)
            add(i / 4 ? 5 : 4, i / 4 ? (i + 1) % 4 : i, i / 4 ? i - 4 : (i + 1) % 4);
    }
    link_mesh();
    for (i = 0; i < mesh.nv; i++) mesh.G[i] = nook_make(1, 2, 3);
}
enum { SMALLS = 7 };

static bool is_at_border(uint32_t v) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (mesh.O[c] == c && (mesh.V[nook_next(c)] == v || mesh.V[nook_prev(c)] == v)) return true;
    }
    return false;
}

/* How many records are splits. */
static uint64_t count_splits(void) {
    uint64_t pairs = 0, borders = 0, nt = mesh.nt, nv = mesh.nv;
    uint32_t e, f;
    for (e = 0; e < 3 * mesh.nt; e++) {
        uint32_t a = mesh.V[nook_next(e)], b = mesh.V[nook_prev(e)];
        for (f = 0; f < 3 * mesh.nt; f++) {
            uint32_t x = mesh.V[nook_next(f)], y = mesh.V[nook_prev(f)];
            pairs += (a == x) + (a == y) + (b == x) + (b == y) == 1;
        }
        borders += (uint64_t)is_at_border(a) + (3 * nt - 1) * is_at_border(b);
    }
    return pairs * (nv + 1) * 3 * (nt + 2) * 3 * (nt + 1) + borders * (nv + 1) * 3 * (nt + 1);
}

static uint32_t value(uint32_t i, uint32_t most) { return i > most ? NOOK_NONE : i; }

static bool try_record(nook_vertex_split *s, uint32_t nv, uint32_t nt) {
    levels = nook_levels_of(s, 1);
    if (nook_levels_refine(&levels, &mesh, NULL) != NOOK_OK) {
        if (mesh.nv != nv || mesh.nt != nt || !is_kept(nv, nt)) CHECK(false);
        return false;
    }
    if (mesh.nv != nv + 1 || mesh.nt != nt + (s->o == NOOK_STORED_NONE ? 1 : 2)) CHECK(false);
    if (!corners_hold() || mesh.G[s->v].x != 5) CHECK(false);
    CHECK_EQUAL(nook_levels_coarsen(&levels, &mesh, NULL), NOOK_OK);
    if (mesh.nv != nv || mesh.nt != nt || !is_kept(nv, nt) || !corners_hold()) CHECK(false);
    memcpy(mesh.C, kept.C, nv * sizeof *kept.C);
    return true;
}

static void every_record_is_a_split_or_refused(void) {
    uint32_t which, tried = 0, start = milliseconds(), c, o, v, e, f;
    uint64_t all = 0;
    for (which = 0; which < SMALLS && !test_has_failed(); which++) {
        uint64_t accepted = 0;
        uint32_t nv, nt;
        nook_vertex_split s;
        make_room(SMALL_V, SMALL_T);
        make_small(which);
        name_corners();
        nv = mesh.nv, nt = mesh.nt;
        keep(nv, nt);
        s.gone = nook_make(5, 5, 5), s.kept = nook_make(6, 6, 6), s.at = nook_make(1, 2, 3);
        for (c = 0; c <= 3 * nt + 7 && !test_has_failed(); c++) {
            for (o = 0; o <= 3 * nt + 7; o++) {
                for (v = 0; v <= nv + 2; v++) {
                    for (e = 0; e <= 3 * nt + 1; e++) {
                        for (f = 0; f <= 3 * nt + 1 && !test_has_failed(); f++) {
                            s.c = nook_store(value(c, 3 * nt + 6)), s.o = nook_store(value(o, 3 * nt + 6));
                            s.v = nook_store(value(v, nv + 1));
                            s.e = nook_store(value(e, 3 * nt)), s.f = nook_store(value(f, 3 * nt));
                            s.table = nook_store(throw_dice(&d, 16u * 8u));
                            accepted += try_record(&s, nv, nt);
                            tried++;
                        }
                    }
                }
            }
        }
        CHECK(accepted == count_splits());
        CHECK(fences_hold());
        all += accepted;
        drop_fences();
    }
    print_figure("all records on 7 meshes of 1 to 8 triangles", tried, "records", start);
    (void)printf("  %u of them are splits\n", (unsigned)all);
}

/* ---- any bits ---------------------------------------------------------------------------------------- */

static nook_index any_index(uint32_t most) {
    return nook_store(throw_dice(&d, 20) == 0 ? throw_dice(&d, 2) == 0 ? NOOK_NONE : d.state
                                              : throw_dice(&d, most + 1));
}

static void throw_record(nook_vertex_split *s) {
    uint32_t nc = 3 * mesh.nt;
    s->gone = s->kept = s->at = mesh.G[0];
    if (throw_dice(&d, 10) == 0) s->kept.y = (float)throw_dice(&d, 3) * 1e9f;
    s->c = any_index(nc + 5);
    s->o = throw_dice(&d, 3) == 0 ? NOOK_STORED_NONE : any_index(nc + 5);
    s->v = any_index(mesh.nv);
    s->e = any_index(nc);
    s->f = any_index(nc);
    if (throw_dice(&d, 3) == 0 && s->e < nc) s->f = nook_store(nook_next(s->e));
    s->table = any_index(127);
}

static void spoil_tables(void) {
    uint32_t n = throw_dice(&d, 4), nc = 3 * mesh.nt;
    for (; n > 0; n--) {
        mesh.O[throw_dice(&d, nc)] = any_index(nc);
        if (throw_dice(&d, 2) == 0) mesh.V[throw_dice(&d, nc)] = any_index(mesh.nv);
        if (throw_dice(&d, 2) == 0) mesh.C[throw_dice(&d, mesh.nv)] = any_index(nc);
    }
}

static void any_record_on_any_tables_ends_well(void) {
    uint32_t i, k, steps = 0, done = 0, start = milliseconds();
    for (i = 0; i < 300000 && !test_has_failed(); i++) {
        nook_vertex_split s[4];
        uint32_t more = throw_dice(&d, 5);
        make_room(6 + more / 2, 8 + more);
        make_small(i % SMALLS);
        mesh.max_nv = mesh.nv + more / 2 <= mesh.max_nv ? mesh.nv + more / 2 : mesh.max_nv;
        spoil_tables();
        for (k = 0; k < 4; k++) throw_record(&s[k]);
        levels = nook_levels_of(s, 4);
        levels.level = throw_dice(&d, 5);
        for (k = 0; k < 8; k++, steps++) {
            uint32_t nv = mesh.nv, nt = mesh.nt, units = 3;
            nook_status status;
            keep(nv, nt);
            status = throw_dice(&d, 2) == 0 ? nook_levels_refine(&levels, &mesh, NULL)
                     : throw_dice(&d, 2) == 0
                         ? nook_levels_coarsen(&levels, &mesh, NULL)
                         : nook_levels_step(&levels, &mesh, throw_dice(&d, 12), NULL, &units);
            done += status == NOOK_OK;
            if (mesh.nv > mesh.max_nv || mesh.nt > mesh.max_nt || levels.level > 4) CHECK(false);
            if (status != NOOK_OK && units == 3 && (nv != mesh.nv || nt != mesh.nt || !is_kept(nv, nt)))
                CHECK(false);
        }
        CHECK(fences_hold());
        drop_fences();
    }
    print_figure("any records on spoiled tables", steps, "steps", start);
    (void)printf("  %u of them carried out\n", (unsigned)done);
}

int main(void) {
    static const test tests[] = {
        TEST(every_level_is_the_copy_that_was_made_of_it),
        TEST(a_large_mesh_is_the_same_after_a_hundred_rounds),
        TEST(every_record_is_a_split_or_refused),
        TEST(any_record_on_any_tables_ends_well),
    };
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
