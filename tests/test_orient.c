/* test_orient.c -- triangles that agree and solids that face outward, whichever way they came.
 *
 * What is expected is known by construction: surfaces are made oriented and then turned over by the dice, shells are nested
 * by the dice, so the depth of each is known. Whether all is well afterwards say nook_link and nook_check. */
#include <string.h>

#include "rooms.h"
#include "shapes.h"

enum { SMALL = NOOK_TEST_RAM < 2000000, MOST_NESTED = SMALL ? 9 : 256 };

static dice d;

/* ---- what a finder hears ---------------------------------------------------------------------------- */

static struct {
    uint32_t count[NOOK_STATUS_COUNT];
    nook_where first[NOOK_STATUS_COUNT];
} heard;

static void hear(void *user, nook_status status, nook_where where) {
    CHECK(user == &heard);
    if (heard.count[status]++ == 0) heard.first[status] = where;
}
static const nook_finder listening = {hear, &heard};

static uint32_t digest(void) {
    nook_view view = nook_view_of(&b.mesh);
    return nook_digest(&view);
}

/* ---- triangles --------------------------------------------------------------------------------------- */

static uint8_t turned[NOOK_MV_BYTES(MOST_T)]; /* which triangles were turned over */

static void turn_some(uint32_t one_in) {
    uint32_t t;
    memset(turned, 0, sizeof turned);
    for (t = 0; t < b.mesh.nt; t++) {
        if (throw_dice(&d, one_in) != 0) continue;
        nook_set_bit(turned, t);
        turn_over(t);
    }
}

static void keep_V(void) { memcpy(b.kept, b.mesh.V, 3 * b.mesh.nt * sizeof *b.kept); }

static bool V_is_kept(void) { return memcmp(b.kept, b.mesh.V, 3 * b.mesh.nt * sizeof *b.kept) == 0; }

static bool is_changed(uint32_t t) {
    const nook_index *is = b.mesh.V + 3 * t, *was = b.kept + 3 * t;
    if (memcmp(is, was, 3 * sizeof *is) == 0) return false;
    CHECK(is[0] == was[0] && is[1] == was[2] && is[2] == was[1]);
    return true;
}

/* Components across edges of two triangles, of a surface as it is made. */
static void label(void) {
    nook_components sets;
    nook_view view = nook_view_of(&b.mesh);
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK_EQUAL(nook_components_begin(&sets, &view, b.component), NOOK_OK);
    CHECK_EQUAL(nook_components_step(&sets, &units), NOOK_OK);
}

/* Each is as it was made, or all the other way: where most of it was turned, or half of it with its first. */
static void each_runs_as_most_of_it_did(void) {
    uint32_t k, t;
    for (k = 0; k < 4; k++) {
        uint32_t with = 0, against = 0, first = NOOK_NONE;
        bool reversed;
        for (t = b.mesh.nt; t-- > 0;) {
            if (b.component[t] != k) continue;
            first = t;
            *(nook_bit(turned, t) ? &against : &with) += 1;
        }
        reversed = against > with || (against == with && first != NOOK_NONE && nook_bit(turned, first));
        for (t = 0; t < b.mesh.nt; t++) {
            if (b.component[t] == k) CHECK_EQUAL(is_changed(t), nook_bit(turned, t) != reversed);
        }
    }
}

static void a_surface_runs_as_most_of_its_triangles_did(void) {
    uint32_t i, round;
    d.state = 1;
    for (i = 0; i < shape_count; i++) {
        for (round = 0; round < 12 && shapes[i].orientable; round++) {
            nook_where where;
            shapes[i].build();
            shuffle(&d);
            label();
            turn_some(1 + round % 4);
            keep_V();
            CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, &listening, &where), NOOK_OK);
            CHECK_EQUAL(where.kind, NOOK_NOWHERE);
            each_runs_as_most_of_it_did();
            CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
            CHECK_EQUAL(b.report.incoherent_edges, 0);
        }
    }
    CHECK_EQUAL(heard.count[NOOK_NOT_ORIENTABLE], 0);
}

static void of_two_halves_the_first_triangle_decides(void) {
    uint32_t turn;
    for (turn = 0; turn < 4; turn++) {
        book(2, turn);
        keep_V();
        CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_OK);
        CHECK(!is_changed(0));
        CHECK_EQUAL(is_changed(1), turn == 0 || turn == 3);
    }
}

/* From where all triangles of the shape can be seen: the corner faces an edge of two of them. */
static void edge_has_two_triangles(uint32_t corner) {
    uint32_t c, v = b.mesh.V[nook_next(corner)], w = b.mesh.V[nook_prev(corner)], count = 0;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        uint32_t x = b.mesh.V[nook_next(c)], y = b.mesh.V[nook_prev(c)];
        count += (x == v && y == w) || (x == w && y == v);
    }
    CHECK_EQUAL(count, 2);
}

static void a_one_sided_surface_is_named_and_left_as_it_came(void) {
    uint32_t i, round, tried = 0;
    d.state = 2;
    for (i = 0; i < shape_count; i++) {
        for (round = 0; round < 6 && !shapes[i].orientable; round++, tried++) {
            nook_where where;
            shapes[i].build();
            shuffle(&d);
            turn_some(2);
            keep_V();
            memset(&heard, 0, sizeof heard);
            CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, &listening, &where), NOOK_NOT_ORIENTABLE);
            CHECK(V_is_kept());
            CHECK(where.kind == NOOK_AT_CORNER && where.index < 3 * b.mesh.nt);
            CHECK_EQUAL(heard.count[NOOK_NOT_ORIENTABLE], 1);
            CHECK_EQUAL(heard.first[NOOK_NOT_ORIENTABLE].index, where.index);
            edge_has_two_triangles(where.index);
        }
    }
    CHECK_EQUAL(tried, 18); /* the Moebius strip, the Klein bottle, the projective plane */
}

/* A strip of 5 triangles whose ends are joined turned over. */
static void add_strip(uint32_t v) {
    uint32_t i;
    for (i = 0; i < 5; i++) add(v + i, v + (i + 1) % 5, v + (i + 2) % 5);
}

static void what_can_be_oriented_is_beside_what_cannot(void) {
    nook_where where;
    uint32_t t;
    octahedron();
    b.mesh.nv = 16;
    add_strip(6);
    add_strip(11);
    for (t = 1; t < 18; t += 3) turn_over(t);
    keep_V();
    memset(&heard, 0, sizeof heard);
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, &listening, &where), NOOK_NOT_ORIENTABLE);
    CHECK_EQUAL(heard.count[NOOK_NOT_ORIENTABLE], 2);
    CHECK(where.index >= 3 * 8 && where.index < 3 * 13);
    for (t = 0; t < 18; t++) CHECK_EQUAL(is_changed(t), t < 8 && t % 3 == 1);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(b.result.survey.orientable, NOOK_NO);
    CHECK(b.shell[0].incoherent_edges == 0 && b.shell[1].incoherent_edges > 0);
}

static void an_edge_of_three_triangles_binds_nobody(void) {
    /* Two tetrahedra on a common edge 0-1, and a page more. */
    static const uint8_t list[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 5, 1, 0, 1, 4, 1, 5, 4, 5, 0, 4};
    uint32_t t, pages;
    for (pages = 3; pages < 6; pages++) {
        book(pages, 6);
        keep_V();
        CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_OK);
        CHECK(V_is_kept());
    }
    begin_shape(7);
    add_list(list, 8);
    add(0, 1, 6);
    for (t = 0; t < 9; t += 4) turn_over(t);
    keep_V();
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_OK);
    for (t = 0; t < 9; t++) CHECK_EQUAL(is_changed(t), t == 0 || t == 4);
}

static void attributes_follow_their_corners(void) {
    static float attributes[3 * 8 * 2];
    const nook_edit edit = {.attributes = attributes, .width = 2};
    uint32_t c;
    octahedron();
    turn_over(3);
    turn_over(6);
    for (c = 0; c < 24; c++) attributes[2 * c] = (float)b.mesh.V[c], attributes[2 * c + 1] = 7;
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, &edit, NULL, NULL), NOOK_OK);
    for (c = 0; c < 24; c++) CHECK(attributes[2 * c] == (float)b.mesh.V[c] && attributes[2 * c + 1] == 7);
}

/* With so many units a call. */
static uint32_t slice(uint32_t units_a_call) {
    nook_orient_state state;
    nook_status status;
    uint32_t used = 0, most = b.mesh.nv + 12 * b.mesh.nt + 16, with_hub = 2 * b.mesh.nt * 16;
    CHECK_EQUAL(nook_orient_begin(&state, &b.mesh, &b.marks, NULL, NULL), NOOK_OK);
    do {
        uint32_t units = units_a_call;
        status = nook_orient_step(&state, &units);
        CHECK(status != NOOK_MORE || units == 0);
        used += units_a_call - units;
    } while (status == NOOK_MORE && used <= most + with_hub);
    CHECK(status == NOOK_OK || status == NOOK_NOT_ORIENTABLE);
    CHECK(used <= most || b.mesh.nv == 41);
    return state.turned;
}

static void every_slicing_turns_the_same_triangles(void) {
    uint32_t i, units, t, count;
    d.state = 3;
    for (i = 0; i < shape_count; i++) {
        shapes[i].build();
        turn_some(3);
        keep_V();
        CHECK(slice(UINT32_MAX) <= b.mesh.nt / 2);
        memset(turned, 0, sizeof turned);
        for (count = t = 0; t < b.mesh.nt; t++) {
            if (is_changed(t)) nook_set_bit(turned, t), count++;
        }
        for (units = 1; units < 40; units += 1 + units / 4) {
            memcpy(b.mesh.V, b.kept, 3 * b.mesh.nt * sizeof *b.kept);
            CHECK_EQUAL(slice(units), count);
            for (t = 0; t < b.mesh.nt; t++) CHECK_EQUAL(is_changed(t), nook_bit(turned, t));
        }
    }
}

static void what_cannot_be_looked_at_is_named_and_nothing_turned(void) {
    nook_orient_state state;
    nook_where where = nook_at(NOOK_AT_BYTE, 1);
    uint32_t units = UINT32_MAX;
    CHECK(sizeof state <= 256);
    octahedron();
    turn_over(0);
    b.marks.max_nt = 8;
    CHECK_EQUAL(nook_orient_begin(NULL, &b.mesh, &b.marks, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_orient_begin(&state, NULL, &b.marks, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_orient_begin(&state, &b.mesh, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_orient_begin(&state, &b.mesh, &b.marks, NULL, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mt = b.Mt;
    b.marks.max_nt = 7;
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_NO_CAPACITY);
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, &where), NOOK_NO_CAPACITY);
    CHECK_EQUAL(where.kind, NOOK_NOWHERE);
    b.marks.max_nt = 8;
    b.mesh.V[13] = 6;
    keep_V();
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, &where), NOOK_INDEX_OUT_OF_RANGE);
    CHECK(V_is_kept() && where.kind == NOOK_AT_CORNER && where.index == 13);
    b.mesh.V[13] = b.mesh.V[14];
    keep_V();
    CHECK_EQUAL(nook_orient_begin(&state, &b.mesh, &b.marks, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(nook_orient_step(&state, &units), NOOK_REPEATED_VERTEX);
    CHECK_EQUAL(nook_orient_step(&state, &units), NOOK_REPEATED_VERTEX);
    CHECK(V_is_kept() && state.link.where.kind == NOOK_AT_TRIANGLE && state.link.where.index == 4);
    CHECK_EQUAL(nook_link_rings_begin(NULL, &b.mesh), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_link_rings_begin(&state.link, NULL), NOOK_NULL_ARGUMENT);
    begin_shape(0);
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_OK);
}

/* O and marks of any bits on the way: an end, and no access outside, which the sanitizers see. */
static void tables_spoiled_on_the_way_end_the_search(void) {
    uint32_t i, k, bad = 0, good = 0;
    d.state = 5;
    for (i = 0; i < (SMALL ? 300 : 3000); i++) {
        nook_orient_state state;
        nook_status status;
        uint32_t used = 0;
        icosphere(1);
        turn_some(2);
        CHECK_EQUAL(nook_orient_begin(&state, &b.mesh, &b.marks, NULL, NULL), NOOK_OK);
        do {
            uint32_t units = 1 + throw_dice(&d, 40);
            used += units;
            status = nook_orient_step(&state, &units);
            if (used < 140) continue; /* while the edges are found O must hold still */
            for (k = throw_dice(&d, 4); k > 0; k--) {
                b.mesh.O[throw_dice(&d, 96)] =
                    nook_store(throw_dice(&d, i % 2 ? 97 : NOOK_INDEX_BITS * 4000));
            }
            if (i % 3 == 0) b.marks.Mt[throw_dice(&d, NOOK_MT_BYTES(32))] = (uint8_t)throw_dice(&d, 256);
        } while (status == NOOK_MORE && used < 1000);
        CHECK(status != NOOK_MORE && status != NOOK_INDEX_OUT_OF_RANGE);
        bad += status == NOOK_BAD_OPPOSITE;
        good += status != NOOK_BAD_OPPOSITE;
        if (status == NOOK_BAD_OPPOSITE) {
            uint32_t units = 1;
            CHECK_EQUAL(nook_orient_step(&state, &units), NOOK_BAD_OPPOSITE);
        }
    }
    CHECK(bad > 10 && good > 10);
}

static void every_machine_orients_the_same_way(void) {
    d.state = 6;
    icosphere(1);
    shuffle(&d);
    turn_some(2);
    CHECK_EQUAL(nook_orient(&b.mesh, &b.marks, NULL, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(digest(), 0x146CFCE7u);
}

/* ---- shells ------------------------------------------------------------------------------------------ */

static nook_shell nested[MOST_NESTED];
enum { MOST_OF_SOLID = MOST_T < 6000 ? MOST_T : 6000 };
static NOOK_BVH_ARRAYS(MOST_OF_SOLID) tree;
static nook_bvh bvh;
static struct {
    nook_point at[MOST_NESTED]; /* a corner of a shell that is in no other */
    uint8_t depth[MOST_NESTED];
    uint32_t count;
} placed;

static void begin_solid(void) {
    begin_shape(0);
    b.shells.shell = nested;
    b.shells.max_shells = MOST_NESTED;
    placed.count = 0;
}

/* Vertices mesh.nv on are to be a shell of triangles between them. */
static void add_shell(const uint8_t *list, uint32_t triangles, uint32_t vertices, uint32_t depth) {
    uint32_t t, v = b.mesh.nv;
    for (t = 0; t < triangles; t++, list += 3) add(v + list[0], v + list[1], v + list[2]);
    placed.at[placed.count] = b.mesh.G[v];
    placed.depth[placed.count++] = (uint8_t)depth;
    b.mesh.nv += vertices;
}

typedef struct box {
    float low[3], high[3];
} box;

static const uint8_t box_list[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

static void add_box(box at, uint32_t depth) {
    uint32_t i;
    for (i = 0; i < 8; i++) {
        place(b.mesh.nv + i, i & 1 ? at.high[0] : at.low[0], i & 2 ? at.high[1] : at.low[1],
              i & 4 ? at.high[2] : at.low[2]);
    }
    add_shell(box_list, 12, 8, depth);
}

static box cube_of(float low, float high) {
    box at = {{low, low, low}, {high, high, high}};
    return at;
}

static const uint8_t octahedron_list[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                          2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

/* Its corners are the middles of the faces of a box. */
static void add_octahedron(box at, uint32_t depth) {
    float middle[3];
    uint32_t i;
    for (i = 0; i < 3; i++) middle[i] = 0.5f * (at.low[i] + at.high[i]);
    for (i = 0; i < 6; i++) {
        float x[3];
        memcpy(x, middle, sizeof x);
        x[i / 2] = i % 2 ? at.low[i / 2] : at.high[i / 2];
        place(b.mesh.nv + i, x[0], x[1], x[2]);
    }
    add_shell(octahedron_list, 8, 6, depth);
}

static void add_tetrahedron(nook_point p, nook_point q, nook_point r, nook_point s, uint32_t depth) {
    static const uint8_t list[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    nook_point *to = b.mesh.G + b.mesh.nv;
    to[0] = p, to[1] = q, to[2] = r, to[3] = s;
    add_shell(list, 4, 4, depth);
}

/* What is out is in here afterwards. */
static nook_orient_shells_state asked;
static nook_status orient_shells(nook_mesh *mesh, const nook_edit *edit, const nook_finder *finder) {
    return nook_orient_shells(&asked, mesh, &bvh, &b.shells, edit, finder);
}

static void build_tree(void) {
    nook_view view = nook_view_of(&b.mesh);
    if (!CHECK(view.nt <= MOST_OF_SOLID)) return;
    CHECK_EQUAL(nook_bvh_build(&bvh, &view, tree.boxes, tree.order, NULL), NOOK_OK);
}

/* Shells and triangles in any order, each shell turned over or not by the dice; linked, checked, and with a tree. */
static void prepare(void) {
    uint32_t k, t;
    label();
    for (k = 0; k < placed.count; k++) {
        bool turn = throw_dice(&d, 2) == 0;
        for (t = 0; t < b.mesh.nt; t++) {
            if (turn && b.component[t] == k) turn_over(t);
        }
    }
    shuffle(&d);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK(b.result.watertight == NOOK_YES && b.result.oriented == NOOK_YES);
    CHECK_EQUAL(b.result.survey.components, placed.count);
    build_tree();
    memset(&heard, 0, sizeof heard);
}

static const nook_shell *shell_of_placed(uint32_t k) {
    uint32_t v;
    for (v = 0; v < b.mesh.nv; v++) {
        const nook_point *p = &b.mesh.G[v], *q = &placed.at[k];
        if (p->x == q->x && p->y == q->y && p->z == q->z)
            return &nested[b.component[nook_triangle(b.mesh.C[v])]];
    }
    CHECK(false);
    return nested;
}

/* How many shells run the wrong way; checks that those who say so, and who lies where, are right. */
static uint32_t count_wrong(bool cavities_are_known) {
    uint32_t k, wrong = 0;
    for (k = 0; k < placed.count; k++) {
        const nook_shell *shell = shell_of_placed(k);
        bool odd = placed.depth[k] % 2 != 0;
        if (cavities_are_known) CHECK_EQUAL(shell->cavity, odd ? NOOK_YES : NOOK_NO);
        wrong += nook_volume_sign(&shell->volume) != (odd ? -1 : 1);
    }
    return wrong;
}

/* First only asked, then done, then asked again. */
static void are_oriented(void) {
    nook_orient_shells_state state;
    uint32_t before, wrong, units = UINT32_MAX;
    prepare();
    before = digest();
    wrong = count_wrong(false);
    CHECK_EQUAL(orient_shells(NULL, NULL, &listening), NOOK_OK);
    CHECK_EQUAL(asked.where.kind, NOOK_NOWHERE);
    CHECK_EQUAL(digest(), before);
    CHECK_EQUAL(heard.count[NOOK_INSIDE_OUT], wrong);
    CHECK_EQUAL(asked.inside_out, wrong);
    CHECK_EQUAL(count_wrong(true), wrong);
    CHECK_EQUAL(orient_shells(&b.mesh, NULL, NULL), NOOK_OK);
    before = digest();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(digest(), before); /* O is what link finds */
    CHECK_EQUAL(count_wrong(false), 0);
    CHECK_EQUAL(nook_orient_shells_begin(&state, NULL, &bvh, &b.shells, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(nook_orient_shells_step(&state, &units), NOOK_OK);
    CHECK(state.inside_out == 0 && state.flat == 0);
}

static void boxes_in_boxes_to_depth_6_are_oriented(void) {
    uint32_t i, depth;
    d.state = 11;
    for (i = 0; i < 20; i++) {
        begin_solid();
        for (depth = 0; depth <= 6; depth++) {
            float low = (float)depth + 0.25f * (float)throw_dice(&d, 4), high = 20 - (float)depth;
            box at = cube_of(low, high);
            at.low[throw_dice(&d, 3)] = (float)depth;
            add_box(at, depth);
        }
        are_oriented();
    }
}

static void shells_side_by_side_are_oriented(void) {
    uint32_t i, sides = SMALL ? 9 : 200;
    d.state = 12;
    begin_solid();
    for (i = 0; i < sides; i++) {
        box at = cube_of(0, 1);
        float x = (float)(i % 7), y = (float)(i / 7 % 7), z = (float)(i / 49);
        at.low[0] += 2 * x, at.high[0] += 2 * x;
        at.low[1] += 1.5f * y, at.high[1] += 1.5f * y;
        at.low[2] += 3 * z, at.high[2] += 3 * z;
        add_box(at, 0);
    }
    are_oriented();
}

/* A square frame in the plane of two axes, about a middle. */
static void add_frame(uint32_t u, uint32_t v, const float middle[3], uint32_t depth) {
    static const int8_t side[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    uint8_t list[96], n = 0;
    uint32_t i, j, w = 3 - u - v;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            float x[3], far = j == 0 || j == 3 ? 4.0f : 2.0f;
            uint8_t k = (uint8_t)((i + 1) % 4 * 4), l = (uint8_t)((j + 1) % 4), a = (uint8_t)(4 * i);
            x[u] = middle[u] + far * (float)side[i][0];
            x[v] = middle[v] + far * (float)side[i][1];
            x[w] = middle[w] + (j < 2 ? 1.0f : -1.0f);
            place(b.mesh.nv + 4 * i + j, x[0], x[1], x[2]);
            list[n++] = (uint8_t)(a + j), list[n++] = (uint8_t)(k + j), list[n++] = (uint8_t)(k + l);
            list[n++] = (uint8_t)(a + j), list[n++] = (uint8_t)(k + l), list[n++] = (uint8_t)(a + l);
        }
    }
    add_shell(list, 32, 16, depth);
}

static void linked_tori_are_outside_each_other(void) {
    static const float here[3] = {0, 0, 0}, there[3] = {3, 0, 0};
    uint32_t i;
    d.state = 13;
    for (i = 0; i < 8; i++) {
        begin_solid();
        add_frame(0, 1, here, i % 2);
        add_frame(0, 2, there, i % 2);
        if (i % 2 != 0) add_box(cube_of(-20, 20), 0);
        are_oriented();
        CHECK_EQUAL(nook_shell_genus(shell_of_placed(0)), 1);
    }
}

/* A volume as floats have it. */
static float float_volume(uint32_t t, uint32_t end) {
    float sum = 0;
    nook_view view = nook_view_of(&b.mesh);
    for (; t < end; t++) {
        nook_point p = nook_point_at(&view, 3 * t), q = nook_point_at(&view, 3 * t + 1);
        sum += nook_dot(p, nook_cross(q, nook_point_at(&view, 3 * t + 2)));
    }
    return sum;
}

static nook_point throw_point(uint32_t sides) {
    float x = (float)throw_dice(&d, sides), y = (float)throw_dice(&d, sides);
    return nook_make(x, y, (float)throw_dice(&d, sides));
}

static void thin_shells_of_which_floats_have_the_wrong_sign_are_oriented(void) {
    uint32_t i, fooled = 0;
    d.state = 14;
    for (i = 0; fooled < (SMALL ? 4 : 40) && i < 4000; i++) {
        nook_point p = throw_point(1u << 22), q = throw_point(1u << 22), r = throw_point(1u << 22), s;
        float volume;
        int sign;
        s = nook_make(p.x + q.x - r.x + 1, p.y + q.y - r.y, p.z + q.z - r.z);
        sign = nook_orient3d(&p, &q, &r, &s);
        begin_solid();
        add_tetrahedron(p, q, r, s, i % 2);
        volume = float_volume(0, 4);
        if (sign == 0 || volume * (float)sign > 0) continue;
        fooled++;
        if (i % 2 != 0) add_box(cube_of(-0x1p24f, 0x1p24f), 0);
        are_oriented();
    }
    CHECK_EQUAL(fooled, SMALL ? 4 : 40);
}

/* ---- touching ---------------------------------------------------------------------------------------- */

static void a_cavity_that_touches_its_outer_shell_at_a_corner_is_a_cavity(void) {
    /* within a face, on the edge of two triangles of it, on an edge, and at a corner of the box */
    static const nook_point corner[] = {{0, 3, 5}, {0, 6, 6}, {0, 0, 5}, {0, 0, 0}};
    uint32_t i;
    d.state = 15;
    for (i = 0; i < 16; i++) {
        begin_solid();
        add_tetrahedron(nook_make(4, 3, 3), nook_make(7, 3, 4), nook_make(4, 8, 4), corner[i % 4], 1);
        add_box(cube_of(0, 12), 0);
        placed.at[1] = nook_make(12, 12, 12);
        are_oriented();
        CHECK(heard.count[NOOK_SELF_INTERSECTION] != 0);
        CHECK_EQUAL(heard.first[NOOK_SELF_INTERSECTION].kind, NOOK_AT_TRIANGLE);
    }
}

static void shells_may_share_a_vertex(void) {
    uint32_t i, t;
    d.state = 16;
    for (i = 0; i < 8; i++) {
        begin_solid();
        add_box(cube_of(0, 12), 0);
        add_tetrahedron(nook_make(3, 2, 4), nook_make(5, 2, 3), nook_make(3, 5, 2), nook_make(0, 0, 0), 1);
        placed.at[0] = nook_make(12, 12, 12);
        for (t = 12; t < 16; t++) {
            uint32_t c = 3 * t;
            for (; c < 3 * t + 3; c++) b.mesh.V[c] = nook_store(b.mesh.V[c] == 11 ? 0 : b.mesh.V[c]);
        }
        b.mesh.nv--;
        are_oriented();
        CHECK_EQUAL(b.result.survey.nonmanifold_vertices, 1);
        CHECK_EQUAL(heard.count[NOOK_SELF_INTERSECTION], 0);
    }
}

/* Planes of either cut the other, which no plane parts from it alone; and corner on corner in one plane. */
static void corner_to_corner_shells_are_outside_each_other(void) {
    uint32_t i;
    d.state = 17;
    for (i = 0; i < 8; i++) {
        begin_solid();
        add_box(cube_of(0, 12), 0);
        add_tetrahedron(nook_make(13, 6, 20), nook_make(20, 13, 6), nook_make(6, 20, 13),
                        nook_make(12, 12, 12), 0);
        are_oriented();
        begin_solid();
        add_box(cube_of(0, 2), 0);
        add_box(cube_of(2, 3), 0);
        placed.at[1] = nook_make(3, 3, 3);
        are_oriented();
    }
}

static void a_unit_looks_at_one_pair_that_touches(void) {
    nook_orient_shells_state state;
    nook_status status;
    d.state = 21;
    begin_solid();
    add_box(cube_of(0, 2), 0);
    add_box(cube_of(2, 3), 0);
    prepare();
    CHECK_EQUAL(nook_orient_shells_begin(&state, NULL, &bvh, &b.shells, NULL, &listening), NOOK_OK);
    do {
        uint32_t units = 1, before = heard.count[NOOK_SELF_INTERSECTION];
        status = nook_orient_shells_step(&state, &units);
        CHECK(heard.count[NOOK_SELF_INTERSECTION] <= before + 1u);
    } while (status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(heard.count[NOOK_SELF_INTERSECTION], 3 * 3);
}

static void is_refused(nook_status status) {
    uint32_t before;
    prepare();
    before = digest();
    CHECK_EQUAL(orient_shells(&b.mesh, NULL, &listening), status);
    CHECK(asked.where.kind == NOOK_AT_TRIANGLE && asked.where.index < b.mesh.nt);
    CHECK_EQUAL(digest(), before);
    CHECK_EQUAL(heard.count[NOOK_INSIDE_OUT], 0);
}

/* The triangle that was named meets one of another shell. */
static void is_refused_where_they_meet(void) {
    uint32_t t, u, met = 0;
    is_refused(NOOK_SELF_INTERSECTION);
    for (t = asked.where.index, u = 0; u < b.mesh.nt; u++) {
        met += b.component[t] != b.component[u] && nook_triangles_intersect(&bvh.view, t, u);
    }
    CHECK(met != 0);
}

static void shells_that_cross_or_share_more_than_corners_are_refused(void) {
    static const box other[] = {
        {{6, 6, 6}, {20, 20, 20}}, /* a corner in the other */
        {{6, -1, 6}, {8, 20, 8}},  /* through it, no corner of either in the other */
        {{12, 3, 3}, {15, 5, 5}},  /* face to face, */
        {{12, 0, 0}, {15, 12, 12}}, {{12, 12, 3}, {15, 15, 6}}, /* edge to edge */
        {{0, 0, 0}, {12, 12, 12}},                              /* the same again */
        {{0, 3, 3}, {5, 5, 5}},                                 /* within, face to face */
    };
    uint32_t i;
    d.state = 18;
    for (i = 0; i < 7; i++) {
        begin_solid();
        add_box(cube_of(0, 12), 0);
        add_box(other[i], 0);
        is_refused_where_they_meet();
    }
    begin_solid(); /* they share vertex 3, and from there a part of an edge */
    add_tetrahedron(nook_make(0, 0, 2), nook_make(1, 2, 2), nook_make(0, 2, 2), nook_make(0, 2, 0), 0);
    add_tetrahedron(nook_make(0, 1, 1), nook_make(1, 0, 2), nook_make(0, 0, 1), nook_make(0, 2, 0), 0);
    for (i = 12; i < 24; i++) b.mesh.V[i] = nook_store(b.mesh.V[i] == 7 ? 3 : b.mesh.V[i]);
    b.mesh.nv--;
    is_refused_where_they_meet();
    begin_solid(); /* an edge across an edge */
    add_tetrahedron(nook_make(0, 0, 0), nook_make(4, 0, 0), nook_make(2, 1, -3), nook_make(2, -1, -3), 0);
    add_tetrahedron(nook_make(2, 2, 0), nook_make(2, -2, 0), nook_make(3, 0, 3), nook_make(1, 0, 3), 0);
    is_refused_where_they_meet();
}

static void a_shell_with_all_corners_on_others_is_refused(void) {
    d.state = 19;
    begin_solid();
    add_box(cube_of(0, 12), 0);
    add_octahedron(cube_of(0, 12), 1);
    is_refused(NOOK_SELF_INTERSECTION);
    CHECK(heard.count[NOOK_SELF_INTERSECTION] >= 6 * 4);
    begin_solid(); /* one corner is enough */
    add_box(cube_of(0, 12), 0);
    add_octahedron(cube_of(0, 12), 1);
    b.mesh.G[13].z = 1;
    placed.at[1] = b.mesh.G[13];
    are_oriented();
}

/* ---- what is refused or told --------------------------------------------------------------------------- */

static void shells_that_are_not_closed_or_not_oriented_are_refused(void) {
    static const nook_status status[] = {NOOK_BORDER_EDGE, NOOK_INCOHERENT_EDGE, NOOK_NONMANIFOLD_EDGE};
    uint32_t i;
    for (i = 0; i < 3; i++) {
        begin_solid();
        add_box(cube_of(0, 1), 0);
        add_box(cube_of(2, 3), 0);
        if (i == 0) b.mesh.nt--;
        if (i == 1) turn_over(20);
        if (i == 2) add(8, 9, 0);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        build_tree();
        CHECK_EQUAL(orient_shells(&b.mesh, NULL, NULL), status[i]);
        CHECK(asked.where.kind == NOOK_AT_TRIANGLE && asked.where.index == 12);
    }
}

static void a_flat_shell_is_counted_and_left_alone(void) {
    nook_orient_shells_state state;
    uint32_t units = UINT32_MAX, before;
    begin_solid();
    add_box(cube_of(0, 12), 0);
    add_tetrahedron(nook_make(1, 1, 1), nook_make(5, 1, 1), nook_make(1, 5, 1), nook_make(2, 2, 1), 1);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    build_tree();
    before = digest();
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &bvh, &b.shells, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(nook_orient_shells_step(&state, &units), NOOK_OK);
    CHECK(state.flat == 1 && state.inside_out == 0 && nested[1].cavity == NOOK_YES);
    CHECK_EQUAL(digest(), before);
}

static void attributes_follow_the_corners_of_shells(void) {
    static float attributes[3 * 24];
    const nook_edit edit = {.attributes = attributes, .width = 1};
    uint32_t c;
    begin_solid();
    add_box(cube_of(0, 12), 0);
    add_box(cube_of(1, 11), 1);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    build_tree();
    for (c = 0; c < 72; c++) attributes[c] = (float)b.mesh.V[c];
    keep_V();
    CHECK_EQUAL(orient_shells(&b.mesh, &edit, NULL), NOOK_OK);
    for (c = 0; c < 72; c++) CHECK(attributes[c] == (float)b.mesh.V[c]);
    for (c = 0; c < 24; c++) CHECK_EQUAL(is_changed(c), c >= 12);
}

static void every_slicing_turns_the_same_shells(void) {
    uint32_t units_a_call, depth, uncut = 0, i;
    d.state = 20;
    for (units_a_call = 1; units_a_call < 60; units_a_call += 1 + units_a_call / 3) {
        nook_orient_shells_state state;
        nook_status status;
        uint32_t used = 0;
        begin_solid();
        for (depth = 0; depth < 4; depth++) {
            add_box(cube_of((float)depth, 20 - (float)depth), depth);
            for (i = 0; i < 12 && depth % 3 == 0; i++) turn_over(12 * depth + i);
        }
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        build_tree();
        CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &bvh, &b.shells, NULL, NULL), NOOK_OK);
        do {
            uint32_t units = units_a_call;
            status = nook_orient_shells_step(&state, &units);
            CHECK(status != NOOK_MORE || units == 0);
            used += units_a_call - units;
        } while (status == NOOK_MORE && used < 2000);
        CHECK_EQUAL(status, NOOK_OK);
        CHECK_EQUAL(state.inside_out, 2);
        CHECK(used <= 6 * b.mesh.nt + 4 * (b.mesh.nt / 3 + 10) + b.mesh.nt * b.mesh.nt / 20 + 3 * b.mesh.nt);
        if (units_a_call == 1) uncut = digest();
        CHECK_EQUAL(digest(), uncut);
    }
    CHECK_EQUAL(uncut, 0xE9224197u);
}

static void a_call_that_cannot_be_carried_out_says_why(void) {
    nook_orient_shells_state state;
    nook_bvh empty;
    memset(&empty, 0, sizeof empty);
    CHECK(sizeof state <= 256);
    begin_solid();
    add_box(cube_of(0, 1), 0);
    add_box(cube_of(2, 3), 0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    build_tree();
    CHECK_EQUAL(nook_orient_shells_begin(NULL, &b.mesh, &bvh, &b.shells, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, NULL, &b.shells, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &empty, &b.shells, NULL, NULL), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &bvh, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    b.shells.component = NULL;
    CHECK_EQUAL(orient_shells(&b.mesh, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(asked.where.kind, NOOK_NOWHERE);
    b.shells.component = b.component;
    b.mesh.nt--;
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &bvh, &b.shells, NULL, NULL), NOOK_NO_CAPACITY);
    b.mesh.nt++, b.mesh.nv--;
    CHECK_EQUAL(nook_orient_shells_begin(&state, &b.mesh, &bvh, &b.shells, NULL, NULL), NOOK_NO_CAPACITY);
    b.mesh.nv++;
    b.shells.count = 1;
    CHECK_EQUAL(orient_shells(&b.mesh, NULL, NULL), NOOK_NO_CAPACITY);
    CHECK(asked.where.kind == NOOK_AT_TRIANGLE && asked.where.index == 12);
}

static void tables_that_do_not_hold_are_refused(void) {
    nook_orient_shells_state state;
    uint32_t i, units;
    for (i = 0; i < 5; i++) {
        bool asks = i > 1;
        nook_status status = i == 0   ? NOOK_BAD_OPPOSITE
                             : i == 2 ? NOOK_NOT_FINITE
                             : i == 3 ? NOOK_COORDINATE_TOO_LARGE
                                      : NOOK_INDEX_OUT_OF_RANGE;
        begin_solid();
        add_box(cube_of(0, 1), 0);
        if (i == 4) add_box(cube_of(2, 3), 0);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        build_tree();
        if (i == 0) b.mesh.O[5] = nook_store(3 * b.mesh.nt);
        if (i == 1) b.mesh.V[1] = nook_store(b.mesh.nv);
        if (i == 2) b.mesh.G[0].y = nook_float_from(0x7FC00000u);
        if (i == 3) b.mesh.G[0].y = 0x1p31f;
        if (i == 4) b.mesh.V[20] = nook_store(b.mesh.nv);
        CHECK_EQUAL(orient_shells(asks ? NULL : &b.mesh, NULL, NULL), i == 1 ? NOOK_BAD_OPPOSITE : status);
        CHECK_EQUAL(asked.where.kind, NOOK_AT_TRIANGLE);
        if (i == 1) CHECK_EQUAL(orient_shells(NULL, NULL, NULL), NOOK_INDEX_OUT_OF_RANGE);
        units = UINT32_MAX;
        CHECK_EQUAL(nook_orient_shells_begin(&state, asks ? NULL : &b.mesh, &bvh, &b.shells, NULL, NULL),
                    NOOK_OK);
        CHECK(nook_orient_shells_step(&state, &units) == nook_orient_shells_step(&state, &units));
    }
}

/* After all pairs were looked at, while it is asked who is inside whom. */
static void tables_that_change_are_refused(void) {
    enum { CORNERS = 2 };
    nook_orient_shells_state state;
    uint32_t units, c;
    begin_solid();
    add_box(cube_of(1, 2), 1);
    add_box(cube_of(0, 3), 0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    build_tree();
    CHECK_EQUAL(nook_orient_shells_begin(&state, NULL, &bvh, &b.shells, NULL, NULL), NOOK_OK);
    do {
        units = 1;
        CHECK_EQUAL(nook_orient_shells_step(&state, &units), NOOK_MORE);
    } while (state.phase < CORNERS);
    for (c = 36; c < 72; c++) b.mesh.V[c] = nook_store(b.mesh.nv);
    units = 1000;
    CHECK_EQUAL(nook_orient_shells_step(&state, &units), NOOK_INDEX_OUT_OF_RANGE);
    CHECK(state.where.kind == NOOK_AT_TRIANGLE && state.where.index < 12);
}

static const test tests[] = {
    TEST(a_surface_runs_as_most_of_its_triangles_did),
    TEST(of_two_halves_the_first_triangle_decides),
    TEST(a_one_sided_surface_is_named_and_left_as_it_came),
    TEST(what_can_be_oriented_is_beside_what_cannot),
    TEST(an_edge_of_three_triangles_binds_nobody),
    TEST(attributes_follow_their_corners),
    TEST(every_slicing_turns_the_same_triangles),
    TEST(what_cannot_be_looked_at_is_named_and_nothing_turned),
    TEST(tables_spoiled_on_the_way_end_the_search),
    TEST(every_machine_orients_the_same_way),
    TEST(boxes_in_boxes_to_depth_6_are_oriented),
    TEST(shells_side_by_side_are_oriented),
    TEST(linked_tori_are_outside_each_other),
    TEST(thin_shells_of_which_floats_have_the_wrong_sign_are_oriented),
    TEST(a_cavity_that_touches_its_outer_shell_at_a_corner_is_a_cavity),
    TEST(shells_may_share_a_vertex),
    TEST(corner_to_corner_shells_are_outside_each_other),
    TEST(a_unit_looks_at_one_pair_that_touches),
    TEST(shells_that_cross_or_share_more_than_corners_are_refused),
    TEST(a_shell_with_all_corners_on_others_is_refused),
    TEST(shells_that_are_not_closed_or_not_oriented_are_refused),
    TEST(a_flat_shell_is_counted_and_left_alone),
    TEST(attributes_follow_the_corners_of_shells),
    TEST(every_slicing_turns_the_same_shells),
    TEST(a_call_that_cannot_be_carried_out_says_why),
    TEST(tables_that_do_not_hold_are_refused),
    TEST(tables_that_change_are_refused),
};

void test_orient(void) { run_tests(tests, sizeof tests / sizeof *tests); }
