/* test_sew.c -- edits at the border and of a whole mesh, legal and refused, against what becomes of the list of triangles.
 *
 * The oracle is that of test_edit.c: the list is changed as the header says, without adjacency, and linked anew; the
 * operator must be legal exactly if that is a manifold whose directions agree, and its tables must be those of the list. */
#include <string.h>

#include "lists.h"
#include "rooms.h"

static uint32_t seen[NOOK_STATUS_COUNT];

static bool triangles_repeat(void) {
    uint32_t t, u;
    for (t = 0; t < listed; t++) {
        for (u = 0; u < t; u++) {
            if (list_has(t, list[3 * u]) && list_has(t, list[3 * u + 1]) && list_has(t, list[3 * u + 2]))
                return true;
        }
    }
    return false;
}

/* Legal exactly if the list is a manifold; then the mesh has the triangles of the list. */
static void agrees(nook_status status, bool legal, uint32_t nv) {
    seen[status]++;
    CHECK_EQUAL(status == NOOK_OK, legal);
    if (status != NOOK_OK) {
        is_as_kept();
    } else {
        CHECK_EQUAL(b.mesh.nv, nv);
        same_triangles();
        tables_hold();
    }
}

/* ---- one triangle more or less --------------------------------------------------------------------------- */

static void add_to_list(uint32_t v0, uint32_t v1, uint32_t v2) {
    list[3 * listed] = nook_store(v0);
    list[3 * listed + 1] = nook_store(v1);
    list[3 * listed++ + 2] = nook_store(v2);
}

static void try_to_make(uint32_t v0, uint32_t v1, uint32_t v2) {
    const uint32_t v[3] = {v0, v1, v2};
    uint32_t nv = b.mesh.nv, nt = b.mesh.nt;
    bool legal = v0 != v1 && v1 != v2 && v2 != v0;
    nook_status status;
    take_list();
    add_to_list(v0, v1, v2);
    legal = legal && list_is_manifold(nv) && !triangles_repeat();
    status = nook_make_triangle(&b.mesh, v, NULL);
    agrees(status, legal, nv);
    if (status == NOOK_OK) {
        CHECK_EQUAL(nook_remove_triangle(&b.mesh, nt, NULL), NOOK_OK);
        starts_as_kept(nt);
    }
    restore(nv, nt);
}

/* On every three vertices, one of no triangle among them. */
static void every_triangle_can_be_made_or_not_as_the_list_says(void) {
    static const uint8_t on[] = {0, 1, 2, 6};
    uint32_t i, v0, v1, v2;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < sizeof on && !test_has_failed(); i++) {
        if (!begin_whole(on[i])) continue;
        CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make(9, 9, 9)), NOOK_OK);
        keep();
        for (v0 = 0; v0 < b.mesh.nv && v0 < 9; v0++) {
            for (v1 = 0; v1 < b.mesh.nv && v1 < 9; v1++) {
                for (v2 = 0; v2 < b.mesh.nv; v2++) try_to_make(v0, v1, v2);
            }
        }
    }
    CHECK(seen[NOOK_OK] > 20 && seen[NOOK_REPEATED_VERTEX] > 0 && seen[NOOK_NONMANIFOLD_EDGE] > 0 &&
          seen[NOOK_INCOHERENT_EDGE] > 0 && seen[NOOK_NONMANIFOLD_VERTEX] > 0);
}

static void a_triangle_that_cannot_be_made_says_why(void) {
    const uint32_t front[3] = {0, 1, 2}, back[3] = {0, 2, 1}, beyond[3] = {0, 1, 3};
    const uint32_t first[3] = {3, 1, 0}, second[3] = {1, 3, 0};
    begin_shape(0);
    CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make(0, 0, 0)), NOOK_OK);
    CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make(1, 0, 0)), NOOK_OK);
    CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make(0, 1, 0)), NOOK_OK);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, front, NULL), NOOK_OK);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, front, NULL), NOOK_INCOHERENT_EDGE);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, back, NULL), NOOK_DUPLICATE_TRIANGLE);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, beyond, NULL), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, first, NULL), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, second, NULL), NOOK_INDEX_OUT_OF_RANGE);
    b.mesh.max_nt = 1;
    CHECK_EQUAL(nook_make_triangle(&b.mesh, back, NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nv = 3;
    CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make(0, 0, 0)), NOOK_NO_CAPACITY);
    CHECK_EQUAL(nook_remove_triangle(&b.mesh, 1, NULL), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_remove_triangle(&b.mesh, 0, NULL), NOOK_OK);
    CHECK(b.mesh.nt == 0 && b.mesh.C[0] == NOOK_STORED_NONE && b.mesh.C[2] == NOOK_STORED_NONE);
    CHECK_EQUAL(nook_remove_vertex(&b.mesh, 0, NULL), NOOK_OK);
    CHECK(b.mesh.nv == 2 && b.mesh.G[0].y == 1);
}

static void every_triangle_can_be_removed_or_not_as_the_list_says(void) {
    uint32_t i, t;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (t = 0; t < b.mesh.nt; t++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt;
            bool legal;
            take_list();
            memmove(list + 3 * t, list + 3 * t + 3, 3 * (listed - t - 1) * sizeof *list);
            listed--;
            legal = listed == 0 || list_is_manifold(nv);
            agrees(nook_remove_triangle(&b.mesh, t, NULL), legal, nv);
            restore(nv, nt);
        }
    }
    CHECK(seen[NOOK_OK] > 50 && seen[NOOK_NONMANIFOLD_VERTEX] > 5);
}

/* From nothing: every mesh can be made a triangle at a time, if each hangs on those before. */
static void a_tetrahedron_can_be_made_from_nothing_and_unmade(void) {
    static const uint32_t face[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    uint32_t i;
    begin_shape(0);
    for (i = 0; i < 4; i++)
        CHECK_EQUAL(nook_make_vertex(&b.mesh, nook_make((float)i, (float)(i * i), 1)), NOOK_OK);
    for (i = 0; i < 4; i++) CHECK_EQUAL(nook_make_triangle(&b.mesh, face[i], NULL), NOOK_OK);
    tables_hold();
    CHECK_EQUAL(list_result.euler, 2);
    CHECK_EQUAL(list_result.survey.border_loops, 0);
    for (i = 0; i < 4; i++) CHECK_EQUAL(nook_remove_triangle(&b.mesh, 0, NULL), NOOK_OK);
    for (i = 0; i < 4; i++) CHECK_EQUAL(nook_remove_vertex(&b.mesh, 0, NULL), NOOK_OK);
    CHECK_EQUAL(b.mesh.nv + b.mesh.nt, 0);
}

/* ---- stitch and cut --------------------------------------------------------------------------------------- */

/* The last vertex of the list takes the number of one that is gone. */
static void list_drops(uint32_t gone, uint32_t *nv) {
    uint32_t i;
    --*nv;
    for (i = 0; i < 3 * listed; i++) {
        if (list[i] == *nv) list[i] = nook_store(gone);
    }
}

/* Legal if no other edges than this pair meet. */
static bool list_stitches(uint32_t c, uint32_t d, uint32_t *nv) {
    uint32_t to_b = list[nook_next(c)], to_e = list[nook_prev(c)], i;
    uint32_t from_b = list[nook_prev(d)], from_e = list[nook_next(d)];
    for (i = 0; i < 3 * listed; i++) {
        if (list[i] == from_b) list[i] = nook_store(to_b);
        if (list[i] == from_e) list[i] = nook_store(to_e);
    }
    for (i = 0; i < 3 * listed; i++) {
        if (list[i] == list[nook_next(i)]) return false;
    }
    if (!list_is_manifold(*nv) || triangles_repeat()) return false;
    for (i = 0; i < 3 * listed; i++) {
        if (list_opposite(i) != (i == c ? d : i == d ? c : b.mesh.O[i])) return false;
    }
    if (from_b != to_b && from_b > from_e) list_drops(from_b, nv);
    if (from_e != to_e) list_drops(from_e, nv);
    if (from_b != to_b && from_b <= from_e) list_drops(from_b, nv);
    return true;
}

static void every_two_border_edges_can_be_stitched_or_not_as_the_list_says(void) {
    uint32_t i, c, d;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < shape_count + 2 && !test_has_failed(); i++) {
        if (i < shape_count) {
            if (!begin_whole(i)) continue;
        } else {
            /* Two triangles apart; a strip of six in which the ends may meet. */
            static const uint8_t apart[] = {0, 1, 2, 3, 4, 5};
            static const uint8_t strip[] = {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4, 4, 5, 6, 5, 7, 6};
            begin_shape(i == shape_count ? 6 : 8);
            add_list(i == shape_count ? apart : strip, i == shape_count ? 2 : 6);
            CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        }
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            for (d = 0; d < 3 * b.mesh.nt; d++) {
                uint32_t nv = b.mesh.nv, was = nv, nt = b.mesh.nt;
                bool legal = b.mesh.O[c] == c && b.mesh.O[d] == d && c != d;
                if (!legal && (c + d) % 16 != 0) continue;
                take_list();
                legal = legal && list_stitches(c, d, &nv);
                agrees(nook_stitch(&b.mesh, c, d, NULL), legal, nv);
                restore(was, nt);
            }
        }
    }
    CHECK(seen[NOOK_OK] > 20 && seen[NOOK_INTERIOR_EDGE] > 0 && seen[NOOK_REPEATED_VERTEX] > 0);
    CHECK(seen[NOOK_DUPLICATE_EDGE] > 0);
    CHECK_EQUAL(nook_stitch(&b.mesh, 3 * b.mesh.nt, 0, NULL), NOOK_INDEX_OUT_OF_RANGE);
}

/* A slit that O leaves open between the same two vertices; and the back of a lone triangle. */
static void a_slit_can_be_closed_and_a_lone_triangle_not(void) {
    static const uint8_t pillow[] = {0, 1, 2, 0, 2, 1};
    uint32_t c, o;
    tetrahedron();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    keep();
    c = 4, o = b.mesh.O[c];
    b.mesh.O[c] = nook_store(c);
    b.mesh.O[o] = nook_store(o);
    CHECK_EQUAL(nook_stitch(&b.mesh, c, o, NULL), NOOK_OK);
    is_as_kept();
    begin_shape(3);
    add_list(pillow, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    o = b.mesh.O[0];
    b.mesh.O[0] = 0;
    b.mesh.O[o] = nook_store(o);
    CHECK_EQUAL(nook_stitch(&b.mesh, 0, o, NULL), NOOK_DUPLICATE_TRIANGLE);
}

static uint32_t copies, copied_from[2], copied_to[2];
static void hear_copy(void *user, uint32_t from, uint32_t to) {
    (void)user;
    if (copies < 2) copied_from[copies] = from, copied_to[copies] = to;
    copies++;
}
static const nook_edit listening = {.copied = hear_copy};

/* What was cut is manifold, has as many vertices more as ends at the border, and can be stitched to what it was. */
static void every_edge_can_be_cut_where_it_reaches_the_border_and_stitched_again(void) {
    uint32_t i, c;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            uint32_t nv = b.mesh.nv, nt = b.mesh.nt, o = b.mesh.O[c], ends = 0, x;
            nook_status status;
            for (x = 0; x < 3 * nt; x++) {
                if (b.mesh.O[x] != x || o == c) continue;
                ends += b.mesh.V[nook_next(x)] == b.mesh.V[nook_next(c)];
                ends += b.mesh.V[nook_next(x)] == b.mesh.V[nook_prev(c)];
            }
            copies = 0;
            status = nook_cut(&b.mesh, c, &listening);
            seen[status]++;
            CHECK_EQUAL(status, o == c ? NOOK_BORDER_EDGE : ends == 0 ? NOOK_DUPLICATE_EDGE : NOOK_OK);
            if (status != NOOK_OK) {
                is_as_kept();
                continue;
            }
            CHECK(copies == ends && b.mesh.nv == nv + ends);
            CHECK(copied_to[0] == nv &&
                  memcmp(&b.mesh.G[nv], &b.mesh.G[copied_from[0]], sizeof b.mesh.G[0]) == 0);
            CHECK(b.mesh.O[c] == c && b.mesh.O[o] == o);
            tables_hold();
            CHECK_EQUAL(nook_stitch(&b.mesh, c, o, NULL), NOOK_OK);
            CHECK_EQUAL(b.mesh.nv, nv);
            starts_as_kept(nt);
            tables_hold();
            restore(nv, nt);
        }
    }
    CHECK(seen[NOOK_OK] > 20 && seen[NOOK_DUPLICATE_EDGE] > 20);
    CHECK_EQUAL(nook_cut(&b.mesh, 3 * b.mesh.nt, NULL), NOOK_INDEX_OUT_OF_RANGE);
    begin_whole(6);
    b.mesh.max_nv = b.mesh.nv;
    for (c = 0; b.mesh.O[c] == c || nook_cut(&b.mesh, c, NULL) == NOOK_DUPLICATE_EDGE; c++) {
    }
    CHECK_EQUAL(nook_cut(&b.mesh, c, NULL), NOOK_NO_CAPACITY);
}

/* ---- fill -------------------------------------------------------------------------------------------------- */

/* L - 2 or L triangles, by single units; the loop is gone, and the others are as they were. */
static nook_status fill_slowly(uint32_t c, nook_fill_way way, uint32_t *steps) {
    nook_fill fill;
    nook_status status = nook_fill_begin(&fill, &b.mesh, c, way, NULL);
    CHECK(sizeof fill <= 256);
    for (*steps = 0; status == NOOK_OK || status == NOOK_MORE; ++*steps) {
        uint32_t units = 1;
        status = nook_fill_step(&fill, &units);
        if (status == NOOK_OK) return NOOK_OK;
    }
    return status;
}

static void every_hole_can_be_filled_in_three_ways(void) {
    uint32_t i, c, filled = 0;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        uint32_t way;
        if (!begin_whole(i)) continue;
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            for (way = 0; way < 3; way++) {
                nook_view view = nook_view_of(&b.mesh);
                uint32_t nv = b.mesh.nv, nt = b.mesh.nt, length = nook_border_length(&view, c), steps;
                nook_check_result before = list_result;
                nook_status status;
                if (length == 0 || nt + length > MOST) continue;
                status = fill_slowly(c, (nook_fill_way)way, &steps);
                if (status != NOOK_OK) {
                    CHECK_EQUAL(status,
                                length == 3 && nt == 1 ? NOOK_DUPLICATE_TRIANGLE : NOOK_DUPLICATE_EDGE);
                    CHECK(way != NOOK_FILL_CENTROID);
                    starts_as_kept(nt);
                    continue;
                }
                CHECK_EQUAL(b.mesh.nt, nt + length - (way == NOOK_FILL_CENTROID ? 0 : 2));
                CHECK_EQUAL(b.mesh.nv, nv + (way == NOOK_FILL_CENTROID));
                CHECK(memcmp(b.mesh.V, kept_V(), 3 * nt * sizeof(nook_index)) == 0);
                CHECK(steps < 10 * length + (way == NOOK_FILL_EARS ? length * length * length / 2 : 0));
                tables_hold();
                CHECK_EQUAL(list_result.survey.border_loops, before.survey.border_loops - 1);
                CHECK_EQUAL(list_result.euler, before.euler + 1);
                filled++;
                restore(nv, nt);
                take_list();
                CHECK(list_is_manifold(nv));
            }
        }
    }
    CHECK(filled > 50);
}

/* All at one point: any ear is as good as another. */
static void a_hole_of_no_size_is_filled_all_the_same(void) {
    uint32_t c, v, way;
    for (way = 0; way < 3; way++) {
        begin_whole(6);
        for (v = 0; v < b.mesh.nv; v++) place(v, 1, 2, 3);
        for (c = 0; b.mesh.O[c] != c; c++) {
        }
        CHECK_EQUAL(nook_fill_hole(&b.mesh, c, (nook_fill_way)way, NULL), NOOK_OK);
        tables_hold();
    }
}

/* A hole in the plane, of any outline, is filled by ears that do not overlap: their areas add up to that of the outline. */
static void ears_of_a_flat_hole_do_not_overlap(void) {
    static const int8_t outline[12][2] = {{0, 0}, {6, 0}, {6, 5},  {4, 5},  {4, 2},  {2, 2},
                                          {2, 5}, {0, 5}, {-1, 5}, {-1, 7}, {-2, 7}, {-2, 0}};
    uint32_t i, n = 12, steps;
    float area = 0, whole = 0;
    begin_shape(2 * n);
    for (i = 0; i < n; i++) {
        uint32_t j = (i + 1) % n;
        float x = outline[i][0], y = outline[i][1];
        place(i, x, y, 0);
        place(n + i, x * 2 - 2, y * 2 - 3, 0);
        add(i, n + i, n + j);
        add(i, n + j, j);
        whole += x * (float)outline[j][1] - y * (float)outline[j][0];
    }
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    for (i = 0; b.mesh.O[i] != i || b.mesh.V[nook_next(i)] >= n; i++) {
    }
    CHECK_EQUAL(fill_slowly(i, NOOK_FILL_EARS, &steps), NOOK_OK);
    for (i = 2 * n; i < b.mesh.nt; i++) {
        const nook_index *v = b.mesh.V + 3 * i;
        nook_point p = b.mesh.G[v[0]], a = nook_sub(b.mesh.G[v[1]], p), o = nook_sub(b.mesh.G[v[2]], p);
        float twice = a.x * o.y - a.y * o.x;
        CHECK(twice > 0);
        area += twice;
    }
    CHECK(b.mesh.nt == 2 * n + n - 2 && area == whole);
    tables_hold();
}

static void a_hole_that_cannot_be_filled_says_why(void) {
    uint32_t c, steps, v, nt;
    begin_whole(0); /* a tetrahedron without its last triangle */
    for (c = 0; b.mesh.O[c] != c; c++) {
    }
    CHECK_EQUAL(fill_slowly(b.mesh.nt * 3, NOOK_FILL_FAN, &steps), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_fill_hole(&b.mesh, b.mesh.O[nook_next(c)], NOOK_FILL_FAN, NULL), NOOK_INTERIOR_EDGE);
    b.mesh.max_nt = 3;
    CHECK_EQUAL(nook_fill_hole(&b.mesh, c, NOOK_FILL_FAN, NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nt = 6, v = b.mesh.max_nv, b.mesh.max_nv = b.mesh.nv;
    CHECK_EQUAL(nook_fill_hole(&b.mesh, c, NOOK_FILL_CENTROID, NULL), NOOK_NO_CAPACITY);
    b.mesh.max_nv = v;
    CHECK_EQUAL(nook_fill_hole(&b.mesh, c, NOOK_FILL_CENTROID, NULL), NOOK_OK);
    tables_hold();
    begin_shape(3);
    add(0, 1, 2);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    CHECK_EQUAL(nook_fill_hole(&b.mesh, 1, NOOK_FILL_EARS, NULL), NOOK_DUPLICATE_TRIANGLE);
    CHECK_EQUAL(nook_fill_hole(&b.mesh, 1, NOOK_FILL_CENTROID, NULL), NOOK_OK);
    tables_hold();
    CHECK_EQUAL(list_result.euler, 2);
    begin_whole(1); /* a slit has only two edges */
    c = b.mesh.O[0], nt = b.mesh.nt;
    b.mesh.O[0] = 0;
    b.mesh.O[c] = nook_store(c);
    keep();
    CHECK_EQUAL(nook_fill_hole(&b.mesh, 0, NOOK_FILL_FAN, NULL), NOOK_DUPLICATE_EDGE);
    starts_as_kept(nt);
}

/* ---- of a whole mesh ---------------------------------------------------------------------------------------- */

static nook_status reverse(const nook_index *component, uint32_t which) {
    nook_reverse state;
    nook_status status = nook_reverse_begin(&state, &b.mesh, component, which, NULL);
    uint32_t units = 2, steps = 0;
    while (status == NOOK_OK) {
        status = nook_reverse_step(&state, &units);
        steps += 2 - units;
        if (status == NOOK_OK) break;
        if (status == NOOK_MORE) status = NOOK_OK;
        units = 2;
    }
    CHECK(steps <= 2 * b.mesh.nt);
    return status;
}

static void a_mesh_reversed_twice_is_as_it_was(void) {
    uint32_t i, c;
    nook_reverse state;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        uint32_t volume_signs = 0;
        if (!begin_whole(i)) continue;
        keep();
        CHECK_EQUAL(reverse(NULL, 0), NOOK_OK);
        for (c = 0; c < 3 * b.mesh.nt; c += 3) {
            CHECK(list[c] == b.mesh.V[c] && list[c + 1] == b.mesh.V[c + 2] && list[c + 2] == b.mesh.V[c + 1]);
            volume_signs++;
        }
        CHECK(volume_signs == b.mesh.nt);
        tables_hold();
        CHECK_EQUAL(reverse(NULL, 0), NOOK_OK);
        is_as_kept();
    }
    CHECK_EQUAL(nook_reverse_begin(&state, NULL, NULL, 0, NULL), NOOK_NULL_ARGUMENT);
}

static void one_of_two_shells_is_reversed_alone(void) {
    uint32_t t, c;
    nook_index half[MOST];
    for (t = 0; t < shape_count && strcmp(shapes[t].name, "two shells") != 0; t++) {
    }
    CHECK(begin_whole(t));
    keep();
    CHECK_EQUAL(reverse(b.component, b.component[0]), NOOK_OK);
    tables_hold();
    for (t = 0; t < b.mesh.nt; t++) {
        bool one = b.component[t] == b.component[0];
        CHECK_EQUAL(b.mesh.V[3 * t + 1] == kept_V()[3 * t + 2], one);
    }
    for (t = 0; t < b.mesh.nt; t++) half[t] = t == 0;
    keep();
    CHECK_EQUAL(reverse(half, 1), NOOK_INCOHERENT_EDGE);
    is_as_kept();
    c = b.mesh.O[5];
    b.mesh.O[5] = nook_store(3 * b.mesh.nt);
    keep();
    CHECK_EQUAL(reverse(NULL, 0), NOOK_BAD_OPPOSITE);
    is_as_kept();
    b.mesh.O[5] = nook_store(c);
}

static nook_status split_fans(uint32_t *more, uint32_t *steps) {
    nook_split_fans state;
    nook_status status = nook_split_fans_begin(&state, &b.mesh, &b.marks, &listening);
    uint32_t units;
    for (*steps = 0; status == NOOK_OK || status == NOOK_MORE; ++*steps) {
        units = 1;
        status = nook_split_fans_step(&state, &units);
        if (status == NOOK_OK) break;
    }
    *more = state.more;
    return status;
}

/* Corners that are the smallest of their fans. */
static uint32_t count_fans(void) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t c, x, fans = 0;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        nook_star star;
        bool smallest = true;
        CHECK_EQUAL(nook_star_begin(&star, &view, c, false), NOOK_OK);
        while ((x = nook_star_next(&star)) != NOOK_NONE) smallest = smallest && x >= c;
        fans += smallest;
    }
    return fans;
}

/* Every corner has its point still, every vertex one fan, and all fans their own vertex. */
static void every_fan_gets_a_vertex_of_its_own(void) {
    uint32_t i, c, split = 0;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        uint32_t nv, nt, more, steps, bound, v, fans;
        nook_status linked;
        shapes[i].build();
        if (b.mesh.nt > MOST || b.mesh.nv > MOST) continue;
        linked = link_and_check(NULL);
        CHECK_EQUAL(linked, NOOK_OK);
        nv = b.mesh.nv, nt = b.mesh.nt;
        keep();
        copies = 0;
        fans = count_fans();
        CHECK_EQUAL(split_fans(&more, &steps), NOOK_OK);
        bound = 13 * nt + nv / 4 + 8;
        CHECK(steps < bound);
        CHECK(more == copies && b.mesh.nv == nv + more);
        CHECK_EQUAL(more, fans + b.result.isolated_vertices - nv);
        for (c = 0; c < 3 * nt; c++) {
            nook_point p = b.mesh.G[b.mesh.V[c]], q = b.mesh.G[kept_V()[c]];
            CHECK(p.x == q.x && p.y == q.y && p.z == q.z);
        }
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        CHECK_EQUAL(b.result.survey.nonmanifold_vertices, 0);
        for (v = 0; v < b.mesh.nv; v++) CHECK(b.mesh.C[v] == NOOK_STORED_NONE || b.mesh.V[b.mesh.C[v]] == v);
        split += more;
    }
    CHECK(split > 1);
}

static void a_mesh_of_mostly_lonely_vertices_has_its_marks_cleared(void) {
    uint32_t more, steps;
    begin_shape(60);
    add(57, 58, 59);
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    memset(b.Mv, 0xFF, 8);
    memset(b.Mt, 0xFF, 3);
    CHECK_EQUAL(split_fans(&more, &steps), NOOK_OK);
    CHECK(more == 0 && b.mesh.nv == 60 && b.mesh.C[0] == NOOK_STORED_NONE && b.mesh.C[57] == 0);
}

static void fans_stay_together_where_there_is_no_room(void) {
    uint32_t i, more, steps;
    nook_split_fans state;
    for (i = 0; i < shape_count && strcmp(shapes[i].name, "closed bow-tie") != 0; i++) {
    }
    shapes[i].build();
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    keep();
    b.mesh.max_nv = b.mesh.nv;
    CHECK_EQUAL(split_fans(&more, &steps), NOOK_NO_CAPACITY);
    CHECK_EQUAL(more, 1);
    is_as_kept();
    b.mesh.max_nv = b.mesh.nv + 1;
    b.mesh.V[4] = nook_store(b.mesh.nv);
    CHECK_EQUAL(split_fans(&more, &steps), NOOK_INDEX_OUT_OF_RANGE);
    b.marks.max_nt = b.mesh.nt - 1;
    CHECK_EQUAL(nook_split_fans_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NO_CAPACITY);
    b.marks.max_nt = b.mesh.nt, b.marks.max_nv = b.mesh.nv - 1;
    CHECK_EQUAL(nook_split_fans_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NO_CAPACITY);
    CHECK_EQUAL(nook_split_fans_begin(&state, &b.mesh, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_split_fans_begin(&state, NULL, &b.marks, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mv = NULL;
    CHECK_EQUAL(nook_split_fans_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NULL_ARGUMENT);
    b.marks.Mt = NULL;
    CHECK_EQUAL(nook_split_fans_begin(&state, &b.mesh, &b.marks, NULL), NOOK_NULL_ARGUMENT);
}

static nook_status reorder(nook_index *order, const nook_edit *edit) {
    nook_reorder state;
    nook_status status = nook_reorder_begin(&state, &b.mesh, order, edit);
    uint32_t steps = 0;
    while (status == NOOK_OK || status == NOOK_MORE) {
        uint32_t units = 1;
        status = nook_reorder_step(&state, &units);
        if (status == NOOK_OK) break;
        steps++;
    }
    CHECK(steps <= 2 * b.mesh.nt);
    return status;
}

/* Corner c of the mesh as it was, when triangle order[t] has become t. */
static uint32_t after_order(const nook_index *order, uint32_t c) {
    uint32_t t = 0;
    while (order[t] != c / 3) t++;
    return 3 * t + c % 3;
}

static void triangles_take_any_order_with_all_that_is_theirs(void) {
    nook_index order[MOST], whole[MOST], O[3 * MOST], C[MOST];
    uint8_t color[MOST];
    float attribute[3 * MOST];
    const nook_edit along = {.color = color, .attributes = attribute, .width = 1};
    dice d = {7};
    uint32_t i, t, c, v;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        if (!begin_whole(i)) continue;
        keep();
        memcpy(O, b.mesh.O, 3 * b.mesh.nt * sizeof *O);
        memcpy(C, b.mesh.C, b.mesh.nv * sizeof *C);
        for (t = 0; t < b.mesh.nt; t++) {
            uint32_t other = throw_dice(&d, t + 1);
            order[t] = order[other];
            order[other] = nook_store(t);
            color[t] = (uint8_t)t;
            for (c = 3 * t; c < 3 * t + 3; c++) attribute[c] = (float)c;
        }
        memcpy(whole, order, sizeof whole);
        CHECK_EQUAL(reorder(order, i % 2 == 0 ? &along : NULL), NOOK_OK);
        tables_hold();
        for (t = 0; t < b.mesh.nt; t++) {
            CHECK_EQUAL(order[t], t);
            if (i % 2 == 0) CHECK_EQUAL(color[t], whole[t]);
            for (c = 0; c < 3; c++) {
                uint32_t was = 3u * whole[t] + c;
                CHECK(b.mesh.V[3 * t + c] == kept_V()[was] &&
                      b.mesh.O[3 * t + c] == after_order(whole, O[was]));
                if (i % 2 == 0) CHECK(attribute[3 * t + c] == (float)was);
            }
        }
        for (v = 0; v < b.mesh.nv; v++) {
            if (C[v] != NOOK_STORED_NONE) CHECK_EQUAL(b.mesh.C[v], after_order(whole, C[v]));
        }
    }
}

/* Whatever stands in the order, there is a mesh of the same triangles in the end. */
static void an_order_of_any_numbers_leaves_a_mesh(void) {
    nook_index order[MOST];
    nook_reorder state;
    dice d = {8};
    uint32_t round, t, refused = 0;
    for (round = 0; round < 200 && !test_has_failed(); round++) {
        nook_status status;
        if (!begin_whole(throw_dice(&d, shape_count))) continue;
        take_list();
        for (t = 0; t < b.mesh.nt; t++) order[t] = nook_store(throw_dice(&d, b.mesh.nt + 1));
        status = reorder(order, NULL);
        refused += status == NOOK_INDEX_OUT_OF_RANGE;
        tables_hold();
        same_triangles();
    }
    CHECK(refused > 20);
    begin_whole(1);
    for (t = 0; t < b.mesh.nt; t++) order[t] = nook_store(b.mesh.nt - 1 - t);
    b.mesh.O[0] = b.mesh.V[2] = b.mesh.C[0] =
        NOOK_STORED_NONE; /* nor do tables of any bits lead out of them */
    (void)reorder(order, NULL);
    CHECK_EQUAL(nook_reorder_begin(&state, NULL, order, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_reorder_begin(&state, &b.mesh, NULL, NULL), NOOK_NULL_ARGUMENT);
}

/* The tree of a mesh in its order, without the order, is the tree. */
static void a_mesh_in_the_order_of_its_tree_needs_none(void) {
    static nook_boxes boxes[NOOK_BVH_GROUPS(MOST)], again[NOOK_BVH_GROUPS(MOST)];
    nook_index order[MOST];
    uint32_t i;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        nook_view view;
        nook_bvh bvh, other;
        if (!begin_whole(i)) continue;
        view = nook_view_of(&b.mesh);
        CHECK_EQUAL(nook_bvh_build(&bvh, &view, boxes, order, NULL), NOOK_OK);
        CHECK_EQUAL(reorder(order, NULL), NOOK_OK);
        CHECK_EQUAL(nook_bvh_build(&other, &view, again, NULL, NULL), NOOK_OK);
        CHECK(memcmp(boxes, again, (bvh.base[bvh.levels] + 1u) * sizeof *boxes) == 0);
    }
}

static const test tests[] = {
    TEST(every_triangle_can_be_made_or_not_as_the_list_says),
    TEST(a_triangle_that_cannot_be_made_says_why),
    TEST(every_triangle_can_be_removed_or_not_as_the_list_says),
    TEST(a_tetrahedron_can_be_made_from_nothing_and_unmade),
    TEST(every_two_border_edges_can_be_stitched_or_not_as_the_list_says),
    TEST(a_slit_can_be_closed_and_a_lone_triangle_not),
    TEST(every_edge_can_be_cut_where_it_reaches_the_border_and_stitched_again),
    TEST(every_hole_can_be_filled_in_three_ways),
    TEST(a_hole_of_no_size_is_filled_all_the_same),
    TEST(ears_of_a_flat_hole_do_not_overlap),
    TEST(a_hole_that_cannot_be_filled_says_why),
    TEST(a_mesh_reversed_twice_is_as_it_was),
    TEST(one_of_two_shells_is_reversed_alone),
    TEST(every_fan_gets_a_vertex_of_its_own),
    TEST(a_mesh_of_mostly_lonely_vertices_has_its_marks_cleared),
    TEST(fans_stay_together_where_there_is_no_room),
    TEST(triangles_take_any_order_with_all_that_is_theirs),
    TEST(an_order_of_any_numbers_leaves_a_mesh),
    TEST(a_mesh_in_the_order_of_its_tree_needs_none),
};

void test_sew(void) { run_tests(tests, sizeof tests / sizeof *tests); }
