/* test_levels.c -- levels of detail: down by every collapse that can be, and up and down again to the last bit.
 *
 * What every level was, tables, C, colors and data beside the mesh, is noted when a mesh comes there first, and must be the same
 * whenever it comes there again, from either side and from a copy that has never been finer. That these levels are right is what
 * test_edit.c and the tables tell: after each step O is what V says. Spoiled records are any: all single bits, and all bits. */
#include <string.h>

#include "lists.h"
#include "rooms.h"

enum { SMALL = NOOK_TEST_RAM < 2000000, ROUNDS = 100, MOST_SPLITS = 40 };

static nook_vertex_split splits[MOST_SPLITS];
static nook_levels levels;
static uint32_t known[MOST_SPLITS + 1], known_digest[MOST_SPLITS + 1];

/* ---- data beside the mesh --------------------------------------------------------------------------- */

static uint8_t color[MOST], of_vertex[MOST], of_triangle[MOST];

static void exchange(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    uint8_t *data = kind == NOOK_AT_VERTEX ? of_vertex : of_triangle, keep = data[from];
    CHECK(user == of_vertex);
    data[from] = data[to];
    data[to] = keep;
}
static const nook_edit exchanging = {.renamed = exchange, .user = of_vertex, .color = color};

static void number_all(void) {
    uint32_t i;
    for (i = 0; i < (uint32_t)MOST; i++) color[i] = of_vertex[i] = of_triangle[i] = (uint8_t)(7 * i + 1);
}

/* ---- what a level is -------------------------------------------------------------------------------- */

static uint32_t mix(uint32_t sum, uint32_t word) { return (sum ^ word) * 16777619u; }

static uint32_t mix_indices(uint32_t sum, const nook_index *at, uint32_t n) {
    for (; n > 0; n--, at++) sum = mix(sum, *at == NOOK_STORED_NONE ? NOOK_NONE : *at);
    return sum;
}

static uint32_t mix_data(uint32_t sum) {
    uint32_t i;
    for (i = 0; i < b.mesh.nv; i++) sum = mix(sum, of_vertex[i]);
    for (i = 0; i < b.mesh.nt; i++) sum = mix(sum, of_triangle[i] + 256u * color[i]);
    return sum;
}

/* All tables, other than nook_digest() C too. */
static uint32_t whole(void) {
    uint32_t sum = mix(mix(2166136261u, b.mesh.nv), b.mesh.nt), v;
    for (v = 0; v < b.mesh.nv; v++) {
        nook_point p = b.mesh.G[v];
        sum = mix(mix(mix(sum, nook_float_bits(p.x)), nook_float_bits(p.y)), nook_float_bits(p.z));
    }
    sum = mix_indices(sum, b.mesh.V, 3 * b.mesh.nt);
    sum = mix_indices(sum, b.mesh.O, 3 * b.mesh.nt);
    return mix_indices(sum, b.mesh.C, b.mesh.nv);
}

static uint32_t digest(void) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_digest(&view);
}

/* C names any corner of each vertex. */
static void throw_corners(dice *d) {
    uint32_t v;
    for (v = 0; v < b.mesh.nv; v++) {
        nook_view view = nook_view_of(&b.mesh);
        uint32_t c = b.mesh.C[v], turns = throw_dice(d, nook_valence(&view, c));
        for (; turns > 0; turns--) c = nook_swing(&view, c);
        if (c < 3 * b.mesh.nt && b.mesh.V[c] == v) b.mesh.C[v] = nook_store(c);
    }
}

/* ---- down ------------------------------------------------------------------------------------------- */

static nook_point half_way(nook_point p, nook_point q) {
    return nook_make((p.x + q.x) * 0.5f, (p.y + q.y) * 0.5f, (p.z + q.z) * 0.5f);
}

static nook_point throw_place(dice *d, uint32_t c) {
    nook_point p = b.mesh.G[b.mesh.V[nook_next(c)]], q = b.mesh.G[b.mesh.V[nook_prev(c)]];
    uint32_t way = throw_dice(d, 3);
    return way == 0 ? p : way == 1 ? q : half_way(p, q);
}

/* Collapse the first edge that can be, from any corner on. */
static bool collapse_one(dice *d, const nook_edit *edit) {
    uint32_t first = throw_dice(d, 3 * b.mesh.nt), i;
    for (i = 0; i < 3 * b.mesh.nt; i++) {
        uint32_t c = (first + i) % (3 * b.mesh.nt);
        if (nook_levels_collapse(&levels, &b.mesh, c, throw_place(d, c), edit) == NOOK_OK) return true;
    }
    return false;
}

static void note_level(void) {
    known[levels.level] = mix_data(whole());
    known_digest[levels.level] = digest();
}

static void go_down(dice *d) {
    levels = nook_levels_in(splits, MOST_SPLITS);
    number_all();
    note_level();
    while (collapse_one(d, &exchanging)) note_level();
    CHECK_EQUAL(levels.count, levels.level);
}

static bool is_known(void) {
    if (mix_data(whole()) == known[levels.level]) return true;
    CHECK_EQUAL(mix_data(whole()), known[levels.level]);
    return false;
}

static void every_level_comes_back_a_hundred_times(void) {
    dice d = {1};
    uint32_t i, round, steps = 0;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        throw_corners(&d);
        go_down(&d);
        tables_hold();
        for (round = 0; round < (uint32_t)ROUNDS && !test_has_failed(); round++) {
            while (levels.level > 0 && is_known()) {
                CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_OK), steps++;
            }
            CHECK(is_known() && digest() == known_digest[0]);
            while (levels.level < levels.count && is_known()) {
                CHECK_EQUAL(nook_levels_coarsen(&levels, &b.mesh, &exchanging), NOOK_OK), steps++;
            }
            CHECK(is_known() && digest() == known_digest[levels.count]);
        }
    }
    CHECK_EQUAL(steps, 200 * 127);
}

static void every_level_of_every_shape_is_whole(void) {
    dice d = {2};
    uint32_t i;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        throw_corners(&d);
        go_down(&d);
        while (levels.level > 0 && !test_has_failed()) {
            CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_OK);
            tables_hold();
            CHECK(digest() == known_digest[levels.level] && is_known());
        }
        CHECK_EQUAL(list_result.euler, shapes[i].euler);
    }
}

/* ---- each collapse alone ------------------------------------------------------------------------------ */

static void all_is_as_kept(uint32_t nv, uint32_t nt, uint32_t before) {
    CHECK(b.mesh.nv == nv && b.mesh.nt == nt);
    CHECK_EQUAL(mix_data(whole()), before);
}

static void every_collapse_is_undone_wherever_corners_are_named(void) {
    dice d = {3};
    uint32_t i, c, undone = 0, refused = 0;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        throw_corners(&d);
        number_all();
        for (c = 0; c < 3 * b.mesh.nt && !test_has_failed(); c++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, before = mix_data(whole()), plain;
            nook_point at = nook_make(1, 2, 3);
            nook_status status;
            keep();
            status = nook_collapse(&b.mesh, c, at, NULL);
            plain = digest();
            restore(nv, nt);
            levels = nook_levels_in(splits, 1);
            CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, c, at, &exchanging), status);
            CHECK_EQUAL(digest(), plain);
            CHECK_EQUAL(levels.level + levels.count, status == NOOK_OK ? 2 : 0);
            if (status == NOOK_OK) CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_OK);
            all_is_as_kept(nv, nt, before);
            undone += status == NOOK_OK;
            refused += status != NOOK_OK;
        }
        if (i < 8) throw_corners(&d);
    }
    CHECK(undone > 500 && refused > 50);
}

/* ---- machines, flash, goals --------------------------------------------------------------------------- */

static void every_machine_comes_to_the_same_levels(void) {
    dice d = {4};
    uint32_t sum = 0, i;
    torus(4, 5);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    go_down(&d);
    for (i = 0; i <= levels.count; i++) sum = mix(sum, known_digest[i]);
    CHECK_EQUAL(levels.count, 12);
    CHECK_EQUAL(sum, 3885234178u);
}

/* Of the tables nothing is left but the coarsest mesh. */
static void lose_the_rest(void) {
    uint32_t nv = b.mesh.nv, nt = b.mesh.nt;
    memset(b.mesh.G + nv, 0xFF, (MOST_V - nv) * sizeof *b.mesh.G);
    memset(b.mesh.C + nv, 0xFF, (MOST_V - nv) * sizeof *b.mesh.C);
    memset(b.mesh.V + 3 * nt, 0xFF, 3 * (MOST_T - nt) * sizeof *b.mesh.V);
    memset(b.mesh.O + 3 * nt, 0xFF, 3 * (MOST_T - nt) * sizeof *b.mesh.O);
}

static void the_coarsest_mesh_and_the_record_are_enough(void) {
    dice d = {5};
    uint32_t i, k;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        go_down(&d);
        lose_the_rest();
        levels = nook_levels_of(splits, levels.count);
        CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 0, b.mesh.G[0], NULL), NOOK_NO_CAPACITY);
        for (k = 0; levels.level > 0 && !test_has_failed(); k++) {
            CHECK(is_known());
            CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_OK);
        }
        CHECK(is_known() && k == levels.count);
        CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_INDEX_OUT_OF_RANGE);
    }
}

/* The level that a goal means, looked up in the numbers of triangles. */
static uint32_t level_of(const uint8_t *nt, uint32_t goal) {
    uint32_t level = 0;
    while (level < levels.count && nt[level] > goal) level++;
    return level;
}

static void a_goal_is_reached_from_anywhere_in_any_slices(void) {
    dice d = {6};
    uint32_t i, k, units;
    uint8_t nt[MOST_SPLITS + 1];
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        levels = nook_levels_in(splits, MOST_SPLITS);
        number_all();
        do {
            nt[levels.level] = (uint8_t)b.mesh.nt;
            note_level();
        } while (collapse_one(&d, &exchanging));
        for (k = 0; k < 100; k++) {
            uint32_t goal = throw_dice(&d, 64), slice = 1 + throw_dice(&d, 9), from = levels.level, used = 0;
            uint32_t to = level_of(nt, goal);
            nook_status status;
            if (k == 50) goal = NOOK_NONE, to = 0;
            do {
                units = slice;
                status = nook_levels_step(&levels, &b.mesh, goal, &exchanging, &units);
                CHECK(status != NOOK_MORE || units == 0);
                used += slice - units;
            } while (status == NOOK_MORE && used < 100);
            CHECK_EQUAL(status, NOOK_OK);
            CHECK_EQUAL(levels.level, to);
            CHECK_EQUAL(used, from > to ? from - to : to - from);
            CHECK(is_known());
        }
    }
}

static void a_new_collapse_forgets_the_levels_beyond(void) {
    dice d = {7};
    uint32_t count, level;
    icosphere(0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    go_down(&d);
    count = levels.count;
    CHECK(count > 1);
    while (levels.level > 0) CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), NOOK_OK);
    CHECK(collapse_one(&d, &exchanging));
    CHECK_EQUAL(levels.count, 1);
    CHECK_EQUAL(nook_levels_coarsen(&levels, &b.mesh, NULL), NOOK_INDEX_OUT_OF_RANGE);
    for (level = 1; collapse_one(&d, &exchanging); level++) note_level();
    CHECK_EQUAL(levels.count, level);
    levels.max = level;
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 0, b.mesh.G[0], NULL), NOOK_NO_CAPACITY);
}

/* Whether the triangle of corner c is found there. */
static bool is_in_tree(const nook_bvh *bvh, uint32_t c) {
    nook_point p = b.mesh.G[b.mesh.V[c]];
    nook_overlap found;
    uint32_t units = 1000;
    CHECK_EQUAL(nook_overlap_begin(&found, bvh, p, p), NOOK_OK);
    while (nook_overlap_step(&found, &units) == NOOK_TRIANGLE) {
        if (found.t == c / 3) return true;
    }
    return false;
}

static nook_boxes tree_boxes[NOOK_BVH_GROUPS(32)];

/* Fitted to each level, it has what is in the next. */
static void a_tree_follows_the_levels(void) {
    dice d = {8};
    nook_guard guard;
    const nook_edit watched = {.guard = &guard};
    uint32_t c;
    torus(4, 4);
    b.mesh.max_nt = 32;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    levels = nook_levels_in(splits, MOST_SPLITS);
    while (collapse_one(&d, NULL)) {
    }
    CHECK(levels.count > 2);
    CHECK_EQUAL(nook_guard_begin(&guard, &b.mesh, tree_boxes), NOOK_OK);
    while (levels.level > 0 && !test_has_failed()) {
        CHECK_EQUAL(nook_bvh_refit(&guard.bvh, tree_boxes, NULL), NOOK_OK);
        CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &watched), NOOK_OK);
        for (c = 0; c < 3 * b.mesh.nt; c++) CHECK(is_in_tree(&guard.bvh, c));
    }
}

/* ---- what is refused ---------------------------------------------------------------------------------- */

static void refuses_to_refine(nook_status expected) {
    uint32_t level = levels.level;
    keep();
    CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, &exchanging), expected);
    CHECK_EQUAL(levels.level, level);
    is_as_kept();
}

static void refuses_to_coarsen(nook_status expected) {
    uint32_t level = levels.level;
    keep();
    CHECK_EQUAL(nook_levels_coarsen(&levels, &b.mesh, &exchanging), expected);
    CHECK_EQUAL(levels.level, level);
    is_as_kept();
}

static void refuses_to_step(nook_status expected) {
    uint32_t units = 5;
    keep();
    CHECK_EQUAL(nook_levels_step(&levels, &b.mesh, 8, &exchanging, &units), expected);
    CHECK_EQUAL(units, 4);
    is_as_kept();
}

#define WITH(entry, value, refuses, status)                                                                  \
    do {                                                                                                     \
        const nook_vertex_split good = *s;                                                                   \
        (entry) = (value);                                                                                   \
        refuses(status);                                                                                     \
        *s = good;                                                                                           \
    } while (0)

static void a_record_that_does_not_fit_says_how(void) {
    nook_vertex_split *s = splits;
    nook_index big, keep_v;
    CHECK_EQUAL(sizeof *s, NOOK_INDEX_BITS == 16 ? 48 : 60);
    octahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    levels = nook_levels_in(splits, 1);
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 24, b.mesh.G[0], NULL), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 0, b.mesh.G[0], NULL), NOOK_OK);
    big = nook_store(3 * b.mesh.nt);
    WITH(s->c, 24, refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->o, 24, refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->o, s->c, refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->v, nook_store(b.mesh.nv + 1), refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->e, big, refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->f, big, refuses_to_refine, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->f, s->e, refuses_to_refine, NOOK_BAD_OPPOSITE);
    WITH(s->gone.x, NOOK_MAX_COORDINATE * 2, refuses_to_refine, NOOK_COORDINATE_TOO_LARGE);
    WITH(s->kept.y, NOOK_MAX_COORDINATE * 2, refuses_to_refine, NOOK_COORDINATE_TOO_LARGE);
    WITH(s->at.z, 7, refuses_to_refine, NOOK_BAD_OPPOSITE);
    WITH(s->at.z, 7, refuses_to_step, NOOK_BAD_OPPOSITE);
    WITH(s->o, NOOK_STORED_NONE, refuses_to_refine, NOOK_BAD_OPPOSITE); /* C is not at a border */
    WITH(b.mesh.max_nv, b.mesh.nv, refuses_to_refine, NOOK_NO_CAPACITY);
    b.mesh.max_nv = MOST_V;
    WITH(b.mesh.max_nt, b.mesh.nt + 1, refuses_to_refine, NOOK_NO_CAPACITY);
    b.mesh.max_nt = MOST_T;
    refuses_to_coarsen(NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, NULL), NOOK_OK);
    refuses_to_refine(NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->c, 24, refuses_to_coarsen, NOOK_INDEX_OUT_OF_RANGE);
    WITH(s->o, NOOK_STORED_NONE, refuses_to_coarsen, NOOK_BAD_OPPOSITE);
    WITH(s->v, nook_store(s->v + 1u), refuses_to_coarsen, NOOK_BAD_OPPOSITE);
    WITH(s->gone.x, 7, refuses_to_coarsen, NOOK_BAD_OPPOSITE);
    WITH(s->kept.x, 7, refuses_to_coarsen, NOOK_BAD_OPPOSITE);
    WITH(s->at.x, -2 * NOOK_MAX_COORDINATE, refuses_to_coarsen, NOOK_COORDINATE_TOO_LARGE);
    keep_v = b.mesh.V[0];
    b.mesh.V[0] = NOOK_STORED_NONE;
    WITH(s->c, 0, refuses_to_coarsen, NOOK_BAD_OPPOSITE);
    b.mesh.V[0] = keep_v;
    CHECK_EQUAL(nook_levels_coarsen(&levels, &b.mesh, NULL), NOOK_OK);
}

static void a_hub_can_stay_but_not_go(void) {
    uint32_t before;
    if (SMALL) {
        skip_test("no room for a hub of 4,097 triangles");
        return;
    }
    hub_fan(4097, true);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    levels = nook_levels_in(splits, 1);
    before = whole();
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 5, b.mesh.G[0], NULL), NOOK_TOO_MANY_TRIANGLES);
    CHECK_EQUAL(whole(), before);
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, b.mesh.O[5], b.mesh.G[0], NULL), NOOK_OK);
    CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, NULL), NOOK_OK);
    CHECK_EQUAL(whole(), before);
    hub_fan(4096, true); /* 4,094 are left to the other end */
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    before = whole();
    levels = nook_levels_in(splits, 1);
    CHECK_EQUAL(nook_levels_collapse(&levels, &b.mesh, 5, b.mesh.G[0], NULL), NOOK_OK);
    CHECK_EQUAL(nook_levels_refine(&levels, &b.mesh, NULL), NOOK_OK);
    CHECK_EQUAL(whole(), before);
}

/* Up and down as far as it goes, from the coarsest; each step is done on a whole mesh, or is refused and changes nothing. */
static void replay_spoiled(void) {
    uint32_t step, before;
    bool up = true;
    for (step = 0; step < 2 * levels.count && !test_has_failed(); step++) {
        nook_status status;
        before = whole();
        status = up ? nook_levels_refine(&levels, &b.mesh, &exchanging)
                    : nook_levels_coarsen(&levels, &b.mesh, &exchanging);
        CHECK(b.mesh.nv <= b.mesh.max_nv && b.mesh.nt <= b.mesh.max_nt);
        if (status != NOOK_OK) CHECK_EQUAL(whole(), before);
        if (status != NOOK_OK && !up) break;
        up = up && status == NOOK_OK && levels.level > 0;
    }
    tables_hold();
}

static void every_spoiled_bit_ends_well(void) {
    static const uint8_t chosen[] = {0, 2, 6, 7};
    dice d = {8};
    uint32_t i, k, bit, count;
    for (i = 0; i < sizeof chosen && !test_has_failed(); i++) {
        CHECK(begin_whole(chosen[i]));
        throw_corners(&d);
        go_down(&d);
        keep();
        count = levels.count;
        for (k = 0; k < count; k++) {
            uint8_t *bytes = (uint8_t *)&splits[k];
            for (bit = 0; bit < 8 * sizeof *splits; bit += SMALL ? 37 : 1) {
                uint32_t nv = b.mesh.nv, nt = b.mesh.nt;
                bytes[bit / 8] = (uint8_t)(bytes[bit / 8] ^ 1u << bit % 8);
                replay_spoiled();
                bytes[bit / 8] = (uint8_t)(bytes[bit / 8] ^ 1u << bit % 8);
                restore(nv, nt);
                levels.level = count;
                if (test_has_failed()) return;
            }
        }
    }
}

static const test tests[] = {
    TEST(every_level_comes_back_a_hundred_times),
    TEST(every_level_of_every_shape_is_whole),
    TEST(every_collapse_is_undone_wherever_corners_are_named),
    TEST(every_machine_comes_to_the_same_levels),
    TEST(the_coarsest_mesh_and_the_record_are_enough),
    TEST(a_goal_is_reached_from_anywhere_in_any_slices),
    TEST(a_new_collapse_forgets_the_levels_beyond),
    TEST(a_tree_follows_the_levels),
    TEST(a_record_that_does_not_fit_says_how),
    TEST(a_hub_can_stay_but_not_go),
    TEST(every_spoiled_bit_ends_well),
};

void test_levels(void) { run_tests(tests, sizeof tests / sizeof *tests); }
