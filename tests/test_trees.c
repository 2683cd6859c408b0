/* test_trees.c -- spanning trees and loops, on surfaces with handles, holes and several components.
 *
 * That trees are trees is seen by uniting sets, edge by edge. How many generators there must be follows from genus and holes
 * as nook_survey counts them. That loops are independent, and are all there are, is seen by elimination: they and the borders
 * of triangles, as sums of edges modulo 2, must make up all cycles. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

enum {
    MANY = 64,
    MANY_C = 3 * MANY,
    ROOM = 132
}; /* for loops; and no shape has more triangles or vertices than that */

static nook_view view;
static nook_trees trees;
static nook_index up[ROOM];
static dice d = {41};

/* ---- surfaces -------------------------------------------------------------------------------------- */

/* A torus of 3 x 3 cells, without its triangle 0 1 4, where the last triangle was. */
static void add_handle(void) {
    const nook_index *rim = b.mesh.V + 3 * --b.mesh.nt;
    uint32_t nv = b.mesh.nv, k;
    const uint32_t name[] = {rim[0], rim[2], nv, nv + 1, rim[1], nv + 2, nv + 3, nv + 4, nv + 5};
    b.mesh.nv += 6;
    for (k = 1; k < 18; k++) {
        uint32_t x = k / 2 % 3, y = k / 6, right = (x + 1) % 3, above = 3 * ((y + 1) % 3);
        add(name[3 * y + x], name[(k % 2 == 0 ? 3 * y : above) + right],
            name[above + (k % 2 == 0 ? right : x)]);
    }
}

static void add_tetrahedron(void) {
    static const uint8_t corners[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    uint32_t i, nv = b.mesh.nv;
    b.mesh.nv += 4;
    for (i = 0; i < 12; i += 3) add(nv + corners[i], nv + corners[i + 1], nv + corners[i + 2]);
}

/* Components with handles, their names mixed, and holes by dice. Whether it is a manifold. */
static bool throw_surface(void) {
    uint32_t parts = 1 + throw_dice(&d, 3), holes = throw_dice(&d, 3) * throw_dice(&d, 5);
    for (begin_shape(0); parts > 0 && b.mesh.nt + 4 <= MANY; parts--) {
        uint32_t handles = throw_dice(&d, 3);
        add_tetrahedron();
        for (; handles > 0 && b.mesh.nt + 16 <= MANY; handles--) add_handle();
    }
    shuffle(&d);
    for (; holes > 0 && b.mesh.nt > 1; holes--) b.mesh.nt--;
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    return b.result.manifold == NOOK_YES;
}

static bool begin(uint32_t i) {
    shapes[i].build();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    return b.result.manifold == NOOK_YES && b.result.oriented == NOOK_YES;
}

/* ---- trees ----------------------------------------------------------------------------------------- */

static nook_status grow(uint32_t cut) {
    uint32_t spent = 0, units;
    nook_status status;
    memset(b.Mt, 0xFF, sizeof b.Mt);
    memset(up, 0x55, sizeof up);
    CHECK_EQUAL(nook_trees_begin(&trees, &view, &b.marks, up), NOOK_OK);
    do {
        units = cut;
        status = nook_trees_step(&trees, &units);
        spent += cut - units;
    } while (status == NOOK_MORE && spent <= 8 * view.nt + view.nv);
    CHECK(spent <= 7 * view.nt + view.nv + 2);
    return status;
}

static nook_index set[ROOM];
static uint32_t sets;

static void begin_sets(uint32_t n) {
    for (sets = 0; sets < n; sets++) set[sets] = nook_store(sets);
}
/* Whether they were apart. */
static bool unite(uint32_t x, uint32_t y) {
    while (set[x] != x) x = set[x];
    while (set[y] != y) y = set[y];
    if (x == y) return false;
    set[x] = nook_store(y);
    sets--;
    return true;
}

/* Both are trees, in each component one, and they share no edge; the first leaves a component with holes once. */
static void both_are_trees(void) {
    uint32_t c, isolated = b.result.isolated_vertices, leaves = 0, bordered = 0, n = 0;
    begin_sets(view.nt);
    for (c = 0; c < 3 * view.nt; c++) {
        if (nook_edge(&view, c) != c || !nook_in_triangle_tree(&trees, c)) continue;
        CHECK(!nook_in_vertex_tree(&trees, c));
        leaves += nook_is_border(&view, c);
        if (!nook_is_border(&view, c)) CHECK(unite(nook_triangle(c), nook_triangle(view.O[c])));
    }
    CHECK_EQUAL(sets, b.result.survey.components);
    begin_sets(view.nv);
    for (c = 0; c < 3 * view.nt; c++) {
        CHECK_EQUAL(nook_in_vertex_tree(&trees, c), nook_in_vertex_tree(&trees, view.O[c]));
        if (nook_edge(&view, c) != c || !nook_in_vertex_tree(&trees, c)) continue;
        CHECK(unite(view.V[nook_next(c)], view.V[nook_prev(c)]));
    }
    CHECK_EQUAL(sets, b.result.survey.components + isolated);
    CHECK_EQUAL(trees.components, b.result.survey.components);
    for (c = 0; c < view.nv; c++) CHECK_EQUAL(up[c] == NOOK_STORED_NONE, view.C[c] == NOOK_STORED_NONE);
    for (c = 0; c < b.shells.count; c++) {
        const nook_shell *s = &b.shell[c];
        bordered += s->border_loops > 0;
        n += 2 * nook_shell_genus(s) + (s->border_loops > 0 ? s->border_loops - 1 : 0);
    }
    CHECK_EQUAL(leaves, bordered);
    CHECK_EQUAL(trees.generators, n);
    for (c = 0; c < 3 * view.nt; c++) n -= nook_is_generator(&trees, c);
    CHECK_EQUAL(n, 0);
}

static void trees_span_triangles_and_vertices_of_named_surfaces(void) {
    uint32_t i, cut;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        for (cut = 1; cut < 40 && begin(i); cut += 19) {
            CHECK_EQUAL(grow(cut), NOOK_OK);
            both_are_trees();
        }
    }
}

static void in_a_simple_mesh_the_trees_are_all_edges(void) {
    uint32_t c;
    icosphere(2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
    for (c = 0; c < 3 * view.nt; c++)
        CHECK(nook_in_triangle_tree(&trees, c) != nook_in_vertex_tree(&trees, c));
    CHECK_EQUAL(trees.generators, 0);
}

/* ---- loops ----------------------------------------------------------------------------------------- */

static uint8_t used[(MANY_C + 7) / 8], seen[(MANY_C + 7) / 8]; /* edges of any loop; vertices of one */
static uint32_t row[MANY_C / 32], basis[MANY_C][MANY_C / 32], rank;

/* Elimination modulo 2: whether row is none of the sums so far. Row k of the basis, if there is one, begins with bit k. */
static bool is_new(void) {
    uint32_t k, i;
    for (k = 0; k < MANY_C; k++) {
        if ((row[k / 32] >> k % 32 & 1u) == 0) continue;
        if ((basis[k][k / 32] >> k % 32 & 1u) == 0) {
            memcpy(basis[k], row, sizeof row);
            rank++;
            return true;
        }
        for (i = 0; i < MANY_C / 32; i++) row[i] ^= basis[k][i];
    }
    return false;
}

static void flip_edge(uint32_t c) {
    c = nook_edge(&view, c);
    row[c / 32] ^= 1u << c % 32;
}

/* It closes, comes to no vertex twice, and but for its first edge runs along the vertices' tree. */
static void follow(uint32_t generator, uint32_t cut) {
    nook_loop loop;
    nook_status status;
    uint32_t at = view.V[nook_next(generator)], edges = 0, spent = 0, units;
    memset(seen, 0, sizeof seen);
    memset(row, 0, sizeof row);
    CHECK_EQUAL(nook_loop_begin(&loop, &trees, generator), NOOK_OK);
    do {
        uint32_t a, z;
        units = cut;
        status = nook_loop_step(&loop, &units);
        spent += cut - units;
        if (status != NOOK_TRIANGLE) continue;
        a = view.V[nook_next(loop.corner)], z = view.V[nook_prev(loop.corner)];
        CHECK((a == at && z == loop.vertex) || (z == at && a == loop.vertex));
        CHECK(edges == 0 ? loop.corner == generator : nook_in_vertex_tree(&trees, loop.corner));
        CHECK(!nook_in_triangle_tree(&trees, loop.corner));
        at = loop.vertex;
        CHECK(!nook_bit(seen, at));
        nook_set_bit(seen, at);
        nook_set_bit(used, nook_edge(&view, loop.corner));
        flip_edge(loop.corner);
        edges++;
    } while (status == NOOK_TRIANGLE || status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(at, view.V[nook_next(generator)]);
    CHECK(edges >= 3 && spent <= 2 * view.nv);
    CHECK_EQUAL(nook_loop_step(&loop, &units), NOOK_OK);
}

/* In one piece when cut along all loops; and no loop is a sum of others and of borders of triangles, but all cycles are:
 * there are e - v + s that are independent. */
static void loops_are_a_basis_and_cut_nothing_off(uint32_t cut) {
    uint32_t c, edges = 0;
    memset(used, 0, sizeof used);
    memset(basis, 0, sizeof basis);
    rank = 0;
    for (c = 0; c < 3 * view.nt; c += 3) {
        memset(row, 0, sizeof row);
        flip_edge(c), flip_edge(c + 1), flip_edge(c + 2);
        (void)is_new();
    }
    for (c = 0; c < 3 * view.nt && !test_has_failed(); c++) {
        edges += nook_edge(&view, c) == c;
        if (!nook_is_generator(&trees, c)) continue;
        follow(c, cut);
        CHECK(is_new());
    }
    CHECK_EQUAL(rank, edges - view.nv + b.result.isolated_vertices + b.result.survey.components);
    begin_sets(view.nt);
    for (c = 0; c < 3 * view.nt; c++) {
        if (!nook_bit(used, nook_edge(&view, c))) (void)unite(nook_triangle(c), nook_triangle(view.O[c]));
    }
    CHECK_EQUAL(sets, b.result.survey.components);
    both_are_trees(); /* as before: loops hang them up elsewhere, and no more */
}

static void loops_of_named_surfaces_are_a_basis(void) {
    uint32_t i, handles;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin(i) || view.nt > MANY) continue;
        CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
        loops_are_a_basis_and_cut_nothing_off(UINT32_MAX);
    }
    for (handles = 0, tetrahedron(); handles < 3; handles++) { /* and one, two, three handles */
        add_handle();
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK(b.result.manifold == NOOK_YES && b.result.watertight == NOOK_YES);
        CHECK_EQUAL(b.result.handles, handles + 1);
        view = nook_view_of(&b.mesh);
        CHECK_EQUAL(grow(3), NOOK_OK);
        CHECK_EQUAL(trees.generators, 2 * handles + 2);
        both_are_trees();
        loops_are_a_basis_and_cut_nothing_off(1);
    }
}

/* The torus with the fewest vertices (Moebius, Csaszar): every two are joined. */
static void the_torus_of_seven_vertices_has_two_loops(void) {
    uint32_t i, k;
    for (k = 0; k < 20 && !test_has_failed(); k++) {
        begin_shape(7);
        for (i = 0; i < 7; i++) {
            add(i, (i + 1) % 7, (i + 3) % 7);
            add(i, (i + 3) % 7, (i + 2) % 7);
        }
        shuffle(&d);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        view = nook_view_of(&b.mesh);
        CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
        CHECK_EQUAL(trees.generators, 2);
        both_are_trees();
        loops_are_a_basis_and_cut_nothing_off(2);
    }
}

/* From one torus of nine vertices to another by flips: there are 112. */
static void every_torus_of_nine_vertices_that_flips_lead_to_has_two_loops(void) {
    uint32_t i, flips, done = 0, rounds = NOOK_TEST_RAM < 2000000 ? 40 : 2000;
    torus(3, 3);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    for (i = 0; i < rounds && !test_has_failed(); i++) {
        for (flips = 0; flips < 20; flips++)
            done += nook_flip(&b.mesh, throw_dice(&d, 3 * view.nt), NULL) == NOOK_OK;
        CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
        both_are_trees();
        loops_are_a_basis_and_cut_nothing_off(UINT32_MAX);
    }
    CHECK(done > rounds);
}

static void any_surface_has_two_loops_a_handle_and_one_a_further_hole(void) {
    uint32_t i, whole = 0, rounds = NOOK_TEST_RAM < 2000000 ? 60 : 1500;
    for (i = 0; i < rounds && !test_has_failed(); i++) {
        bool manifold = throw_surface();
        CHECK_EQUAL(grow(1 + throw_dice(&d, 50)), NOOK_OK);
        if (!manifold) continue;
        both_are_trees();
        loops_are_a_basis_and_cut_nothing_off(1 + throw_dice(&d, 4));
        whole++;
    }
    CHECK(whole > rounds / 3);
}

/* ---- other tables ---------------------------------------------------------------------------------- */

/* Loops end, however they do; which ones lead back. */
static uint32_t follow_all(void) {
    uint32_t c, units, closed = 0;
    for (c = 0; c < 3 * view.nt; c++) {
        nook_loop loop;
        nook_status status;
        (void)nook_in_triangle_tree(&trees, c);
        (void)nook_in_vertex_tree(&trees, c);
        if (!nook_is_generator(&trees, c) && c % 5 != 0) continue;
        CHECK_EQUAL(nook_loop_begin(&loop, &trees, c), NOOK_OK);
        units = 2 * view.nv + 1; /* one to find that it does not lead back */
        do {
            status = nook_loop_step(&loop, &units);
            CHECK(status != NOOK_TRIANGLE || (loop.corner < 3 * view.nt && loop.vertex < view.nv));
        } while (status == NOOK_TRIANGLE);
        CHECK(status == NOOK_OK ? loop.vertex == loop.start : status == NOOK_NONMANIFOLD_VERTEX);
        units = 1;
        if (status != NOOK_OK) CHECK_EQUAL(nook_loop_step(&loop, &units), NOOK_NONMANIFOLD_VERTEX);
        closed += status == NOOK_OK && nook_is_generator(&trees, c);
    }
    return closed;
}

static void fans_that_touch_hang_together(void) {
    (void)begin(
        12); /* two triangles at a vertex: the tree of the second hangs on that of the first, or has its own root */
    CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
    (void)follow_all();
    begin_shape(6); /* two fans at vertex 0, in one strip */
    add(0, 1, 2), add(2, 1, 3), add(3, 1, 4), add(3, 4, 5), add(5, 4, 0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.survey.nonmanifold_vertices, 1);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
    CHECK_EQUAL(trees.generators, 1); /* e - f - v + 2 = 11 - 5 - 6 + 2, less the edge by which it is left */
    CHECK_EQUAL(follow_all(), 1);
}

static void tables_of_any_bits_are_searched_to_an_end(void) {
    uint32_t i, k, bad = 0;
    for (i = 0; i < (NOOK_TEST_RAM < 2000000 ? 400u : 3000u); i++) {
        nook_status status;
        if (i % 3 == 0) (void)throw_surface();
        for (k = throw_dice(&d, 3); k < 3; k++) {
            uint32_t at = throw_dice(&d, 3 * view.nt), to = throw_dice(&d, 4) == 0   ? 0xFFF0
                                                            : throw_dice(&d, 4) == 0 ? view.nv
                                                                                     : throw_dice(&d, 200);
            (throw_dice(&d, 2) == 0 ? b.mesh.V : b.mesh.O)[at] = nook_store(to);
        }
        status = grow(1 + throw_dice(&d, 99));
        CHECK(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
        bad += status == NOOK_BAD_OPPOSITE;
        for (k = 0; k < throw_dice(&d, 3); k++) up[throw_dice(&d, view.nv)] = nook_store(throw_dice(&d, 300));
        (void)follow_all();
        CHECK_EQUAL(up[view.nv], (nook_index)0x55555555u);
    }
    CHECK(bad > 0);
}

static void a_call_that_cannot_be_carried_out_says_why(void) {
    nook_loop loop;
    uint32_t units = 1000;
    (void)begin(1);
    CHECK(sizeof trees <= 256 && sizeof loop <= 256);
    CHECK_EQUAL(nook_trees_begin(NULL, &view, &b.marks, up), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_trees_begin(&trees, NULL, &b.marks, up), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_trees_begin(&trees, &view, NULL, up), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_trees_begin(&trees, &view, &b.marks, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_trees_begin(&trees, &view, &b.marks, up), NOOK_NULL_ARGUMENT);
    b.marks.Mt = b.Mt, b.marks.max_nt = 3;
    CHECK_EQUAL(nook_trees_begin(&trees, &view, &b.marks, up), NOOK_NO_CAPACITY);
    b.marks.max_nt = 4;
    CHECK_EQUAL(nook_trees_begin(&trees, &view, &b.marks, up), NOOK_OK);
    CHECK_EQUAL(nook_trees_step(&trees, &units), NOOK_OK);
    CHECK_EQUAL(nook_trees_step(&trees, &units), NOOK_OK);
    CHECK_EQUAL(nook_loop_begin(&loop, &trees, 12), NOOK_INDEX_OUT_OF_RANGE);
    view.nt = view.nv = 0;
    CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
    CHECK_EQUAL(trees.components, 0);
    view.nt = 4, view.nv = 1; /* less than marks are to be cleared */
    CHECK_EQUAL(grow(UINT32_MAX), NOOK_OK);
    CHECK_EQUAL(up[1], (nook_index)0x55555555u);
    CHECK_EQUAL(trees.components, 1);
}

static const test tests[] = {
    TEST(trees_span_triangles_and_vertices_of_named_surfaces),
    TEST(in_a_simple_mesh_the_trees_are_all_edges),
    TEST(loops_of_named_surfaces_are_a_basis),
    TEST(the_torus_of_seven_vertices_has_two_loops),
    TEST(every_torus_of_nine_vertices_that_flips_lead_to_has_two_loops),
    TEST(any_surface_has_two_loops_a_handle_and_one_a_further_hole),
    TEST(fans_that_touch_hang_together),
    TEST(tables_of_any_bits_are_searched_to_an_end),
    TEST(a_call_that_cannot_be_carried_out_says_why),
};

void test_trees(void) { run_tests(tests, sizeof tests / sizeof *tests); }
