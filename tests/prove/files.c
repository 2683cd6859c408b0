/* files.c -- walks and edits of whole meshes: the files given, and what kills recursion, a strip and a spiral of 20,480
 * triangles.
 *
 * usage: prove_files [FILE or FOLDER]...
 *
 * Of every mesh: the depth-first search takes 3 hops a triangle and one a component; distances are those of a
 * breadth-first search; loops hold every border edge once; the algebra of half-edges holds. Then its fans are split until
 * it is manifold, it is turned inside out and back, its holes are filled, and it is edited by dice, with checks on the
 * way. Of its vertices the hull is made: a convex shell of some of them, with none outside. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../host_sim/files.h"
#include "../../host_sim/heap.h"
#include "../../host_sim/model.h"
#include "check.h"
#include "nook.h"
#include "prove.h"

static nook_mesh mesh;
static nook_view view;
static nook_marks marks;
static nook_index *component, *distance, *queue;
static nook_report report;
static nook_check_result result;
static uint32_t meshes, holes, filled, edits, splits, refused;
static uint32_t hulls, points_of_hulls, vertices_of_hulls;

static void make_room(uint32_t nv, uint32_t nt) {
    uint32_t max_nv = nv + 4 * nt + 64, max_nt = 4 * nt + 64;
    if (max_nv > NOOK_MAX_VERTICES) max_nv = NOOK_MAX_VERTICES;
    if (max_nt > NOOK_MAX_TRIANGLES) max_nt = NOOK_MAX_TRIANGLES;
    marks.Mt = take(NOOK_MT_BYTES(max_nt), 1);
    marks.Mv = take(NOOK_MV_BYTES(max_nv), 1);
    marks.max_nt = max_nt;
    marks.max_nv = max_nv;
    component = take(max_nt, sizeof *component);
    distance = take(max_nt, sizeof *distance);
    queue = take(max_nt, sizeof *queue);
    CHECK_EQUAL(nook_mesh_init(&mesh, take(max_nv, sizeof(nook_point)), take(3u * max_nt, sizeof(nook_index)),
                               take(3u * max_nt, sizeof(nook_index)), take(max_nv, sizeof(nook_index)),
                               max_nv, max_nt),
                NOOK_OK);
    mesh.nv = nv;
    mesh.nt = nt;
}

static void free_room(void) {
    free(marks.Mt), free(marks.Mv), free(component), free(distance), free(queue);
    free(mesh.G), free(mesh.V), free(mesh.O), free(mesh.C);
}

static void link_and_check(void) {
    CHECK_EQUAL(nook_link(&mesh, &marks, NULL, NULL, &report, NULL), NOOK_OK);
    view = nook_view_of(&mesh);
    CHECK_EQUAL(nook_check(&view, &marks, &report, NULL, NULL, &result), NOOK_OK);
}

/* ---- walks ------------------------------------------------------------------------------------------- */

static void searches_agree(void) {
    nook_flood flood;
    nook_components sets;
    nook_rings rings;
    uint32_t units = UINT32_MAX, entered = 0, c, o;
    nook_status status;
    CHECK_EQUAL(nook_components_begin(&sets, &view, component), NOOK_OK);
    CHECK_EQUAL(nook_components_step(&sets, &units), NOOK_OK);
    CHECK_EQUAL(nook_flood_begin(&flood, &view, &marks, NOOK_NONE), NOOK_OK);
    do {
        units = UINT32_MAX;
        status = nook_flood_step(&flood, &units);
        if (status != NOOK_TRIANGLE) break;
        if (component[flood.corner / 3] != flood.component)
            CHECK_EQUAL(component[flood.corner / 3], flood.component);
        entered++;
    } while (true);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(entered, mesh.nt);
    CHECK_EQUAL(flood.hops, 3 * mesh.nt + sets.count);
    units = UINT32_MAX;
    CHECK_EQUAL(nook_rings_begin(&rings, &view, 0, distance, queue), NOOK_OK);
    CHECK_EQUAL(nook_rings_step(&rings, &units), NOOK_OK);
    for (c = 0; c < 3 * mesh.nt && !test_has_failed(); c++) {
        uint32_t t = c / 3, near = UINT32_MAX, i;
        bool reached = component[t] == component[0];
        CHECK_EQUAL(distance[t] != NOOK_STORED_NONE, reached);
        if (!reached || c % 3 != 0) continue;
        for (i = c; i < c + 3; i++) {
            o = mesh.O[i] / 3u;
            if (o != t && distance[o] < near) near = distance[o];
        }
        CHECK(t == 0 ? distance[t] == 0 : distance[t] == near + 1);
    }
}

static void loops_hold_every_border_edge_once(void) {
    uint32_t c, x, in_loops = 0, border = 0, loops = 0;
    memset(marks.Mt, 0, NOOK_MT_BYTES(mesh.nt));
    for (c = 0; c < 3 * mesh.nt; c++) {
        border += nook_is_border(&view, c);
        if (!nook_is_border(&view, c) || nook_bit(marks.Mt, c)) continue;
        loops++;
        x = c;
        do {
            CHECK(!nook_bit(marks.Mt, x));
            nook_set_bit(marks.Mt, x);
            in_loops++;
            CHECK(nook_border_next(&view, nook_border_next(&view, x, true), false) == x);
            x = nook_border_next(&view, x, true);
        } while (x != c && !test_has_failed());
    }
    CHECK_EQUAL(in_loops, border);
    if (result.manifold == NOOK_YES && report.incoherent_edges == 0)
        CHECK_EQUAL(loops, result.survey.border_loops);
}

/* onext and oprev, lnext and lprev, dnext and dprev, rnext and rprev undo each other, and hang together by the pair. */
static void half_edges_have_their_algebra(void) {
    uint32_t c, side;
    for (c = 0; c < 3 * mesh.nt && !test_has_failed(); c++) {
        for (side = 0; side < 2; side++) {
            uint32_t h = nook_halfedge(&view, c) ^ side;
            if (nook_oprev(&view, nook_onext(&view, h)) != h)
                CHECK_EQUAL(nook_oprev(&view, nook_onext(&view, h)), h);
            if (nook_prev_halfedge(&view, nook_next_halfedge(&view, h)) != h) CHECK(false);
            if (nook_dprev(&view, nook_dnext(&view, h)) != h || nook_rprev(&view, nook_rnext(&view, h)) != h)
                CHECK(false);
            if (nook_onext(&view, h) != nook_pair(nook_prev_halfedge(&view, h))) CHECK(false);
            if (nook_origin(&view, nook_onext(&view, h)) != nook_origin(&view, h)) CHECK(false);
        }
    }
}

/* ---- edits ------------------------------------------------------------------------------------------- */

/* Link pairs what has come apart, so that there may be fans again; each round leaves fewer triangles on an edge. */
static void split_until_manifold(void) {
    uint32_t round;
    for (round = 0; round < 9 && result.survey.nonmanifold_vertices != 0; round++) {
        nook_split_fans state;
        uint32_t units = UINT32_MAX;
        CHECK_EQUAL(nook_split_fans_begin(&state, &mesh, &marks, NULL), NOOK_OK);
        CHECK_EQUAL(nook_split_fans_step(&state, &units), NOOK_OK);
        splits += state.more;
        link_and_check();
    }
    CHECK_EQUAL(result.survey.nonmanifold_vertices, 0);
    CHECK_EQUAL(report.nonmanifold_edges, 0);
}

static void reverse(void) {
    nook_reverse state;
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_reverse_begin(&state, &mesh, NULL, 0, NULL), NOOK_OK);
    CHECK_EQUAL(nook_reverse_step(&state, &units), NOOK_OK);
}

static void turned_twice_it_is_as_it_was(void) {
    uint32_t digest = nook_digest(&view);
    reverse();
    CHECK(nook_digest(&view) != digest);
    reverse();
    CHECK_EQUAL(nook_digest(&view), digest);
}

static void fill_all_holes(void) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt && !test_has_failed(); c++) {
        uint32_t way;
        nook_status status = NOOK_OK;
        if (mesh.O[c] != c) continue;
        holes++;
        for (way = NOOK_FILL_EARS; way != UINT32_MAX; way--) {
            if (nook_border_length(&view, c) > 2000 && way == NOOK_FILL_EARS)
                continue; /* n^2 is for firmware's holes */
            status = nook_fill_hole(&mesh, c, (nook_fill_way)way, NULL);
            if (status == NOOK_OK || way == NOOK_FILL_FAN) break;
        }
        view = nook_view_of(&mesh);
        filled += status == NOOK_OK;
        CHECK(status == NOOK_OK || status == NOOK_DUPLICATE_EDGE || status == NOOK_DUPLICATE_TRIANGLE ||
              status == NOOK_NO_CAPACITY);
        if (status == NOOK_NO_CAPACITY) break; /* the next corner is on the same loop */
    }
    CHECK_EQUAL(nook_check(&view, &marks, NULL, NULL, NULL, &result), NOOK_OK);
    CHECK_EQUAL(result.bad_indices + result.bad_opposites + result.bad_corners, 0);
    link_and_check();
    CHECK_EQUAL(result.survey.nonmanifold_vertices, 0);
    CHECK_EQUAL(report.nonmanifold_edges + report.incoherent_edges, 0);
}

static nook_status edit(dice *d) {
    uint32_t what = throw_dice(d, 10), c = throw_dice(d, 3 * mesh.nt), other = throw_dice(d, 3 * mesh.nt);
    nook_point p = nook_point_at(&view, c);
    switch (what) {
    case 0: return nook_flip(&mesh, c, NULL);
    case 1: return nook_split_triangle(&mesh, c / 3, p, NULL);
    case 2: return nook_split_edge(&mesh, c, p, NULL);
    case 3: return nook_split_vertex(&mesh, c, nook_prev(c), p, NULL);
    case 4: return nook_merge_edges(&mesh, c, NULL);
    case 5: return nook_remove_vertex(&mesh, mesh.V[c], NULL);
    case 6: return nook_cut(&mesh, c, NULL);
    case 7: return nook_stitch(&mesh, c, nook_border_next(&view, c, true) % (3 * mesh.nt), NULL);
    case 8: return mesh.nt > 8 ? nook_remove_triangle(&mesh, other / 3, NULL) : NOOK_LAST_TRIANGLE;
    default: return nook_collapse(&mesh, c, p, NULL);
    }
}

static void edit_by_dice(uint32_t times) {
    dice d = {meshes + 1u};
    while (times-- > 0 && mesh.nt > 8 && !test_has_failed()) {
        nook_status status = edit(&d);
        CHECK(status != NOOK_BAD_OPPOSITE);
        view = nook_view_of(&mesh);
        edits += status == NOOK_OK;
        refused += status != NOOK_OK;
        if (times % 5000 != 0) continue;
        CHECK_EQUAL(nook_check(&view, &marks, NULL, NULL, NULL, &result), NOOK_OK);
        CHECK_EQUAL(result.bad_indices + result.bad_opposites + result.bad_corners, 0);
        CHECK_EQUAL(result.survey.nonmanifold_vertices, 0);
    }
    link_and_check();
    CHECK_EQUAL(report.nonmanifold_edges + report.incoherent_edges + report.duplicate_triangles, 0);
    CHECK_EQUAL(result.survey.nonmanifold_vertices, 0);
}

/* ---- hull -------------------------------------------------------------------------------------------- */

static uint32_t *origin; /* which vertex of the mesh one of the hull is */

static void follow(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    CHECK(user == origin && kind == NOOK_AT_VERTEX);
    origin[to] = origin[from];
}

/* A convex shell that has no vertex of the mesh outside. All faces are held against so many vertices, evenly spread,
 * that it does not take for ever: those left out change from face to face. */
static void is_hull(const nook_mesh *hull, const nook_marks *room) {
    nook_report of_link;
    nook_check_result of_check;
    nook_view v = nook_view_of(hull);
    nook_mesh copy = *hull;
    uint32_t before = nook_digest(&v), stride = 1 + (uint32_t)((uint64_t)hull->nt * mesh.nv / 500000u), t, i;
    CHECK_EQUAL(nook_check(&v, room, NULL, NULL, NULL, &of_check), NOOK_OK);
    CHECK_EQUAL(of_check.bad_indices + of_check.bad_opposites + of_check.bad_corners, 0);
    CHECK_EQUAL(nook_link(&copy, room, NULL, NULL, &of_link, NULL), NOOK_OK);
    CHECK_EQUAL(nook_check(&v, room, &of_link, NULL, NULL, &of_check), NOOK_OK);
    CHECK_EQUAL(nook_digest(&v), before);
    CHECK(nook_is_sound(&of_check) && of_check.simple == NOOK_YES && of_check.geometry.convex == NOOK_YES &&
          of_check.isolated_vertices == 0);
    for (i = 0; i < hull->nv; i++) {
        if (memcmp(&hull->G[i], &mesh.G[origin[i]], sizeof *hull->G) != 0) CHECK_EQUAL(i, NOOK_NONE);
    }
    for (t = 0; t < hull->nt && !test_has_failed(); t++) {
        const nook_index *V = hull->V + 3u * t;
        for (i = t % stride; i < mesh.nv; i += stride) {
            if (nook_orient3d(&hull->G[V[0]], &hull->G[V[1]], &hull->G[V[2]], &mesh.G[i]) > 0)
                CHECK_EQUAL(t, NOOK_NONE);
        }
    }
}

static void hull_of_its_vertices(void) {
    const uint32_t nv = mesh.nv, nt = 2 * nv;
    nook_mesh hull;
    nook_marks room = {NULL, NULL, nt, nv};
    nook_edit edit = {.renamed = follow};
    nook_status status;
    if (nv < 4 || nt > NOOK_MAX_TRIANGLES) return;
    CHECK_EQUAL(nook_mesh_init(&hull, take(nv, sizeof(nook_point)), take(3u * nt, sizeof(nook_index)),
                               take(3u * nt, sizeof(nook_index)), take(nv, sizeof(nook_index)), nv, nt),
                NOOK_OK);
    room.Mt = take(NOOK_MT_BYTES(nt), 1);
    room.Mv = take(NOOK_MV_BYTES(nv), 1);
    edit.user = origin = take(nv, sizeof *origin);
    memcpy(hull.G, mesh.G, nv * sizeof *hull.G);
    for (hull.nv = 0; hull.nv < nv; hull.nv++) origin[hull.nv] = hull.nv;
    status = nook_hull(&hull, &room, &edit, NULL);
    CHECK(status == NOOK_OK || status == NOOK_FLAT_SHELL || status == NOOK_NOT_FINITE ||
          status == NOOK_COORDINATE_TOO_LARGE);
    if (status == NOOK_OK) {
        hulls++;
        points_of_hulls += nv;
        vertices_of_hulls += hull.nv;
        is_hull(&hull, &room);
    }
    free(hull.G), free(hull.V), free(hull.O), free(hull.C);
    free(room.Mt), free(room.Mv), free(origin);
}

/* ---- meshes ------------------------------------------------------------------------------------------ */

static void walk_and_edit(void) {
    meshes++;
    hull_of_its_vertices();
    link_and_check();
    searches_agree();
    loops_hold_every_border_edge_once();
    half_edges_have_their_algebra();
    split_until_manifold();
    turned_twice_it_is_as_it_was();
    if (report.incoherent_edges != 0 || report.duplicate_triangles != 0) return;
    fill_all_holes();
    edit_by_dice(20000);
}

static char **given;
static int givens;

static void every_file_can_be_walked_and_edited(void) {
    files list = {0};
    size_t i;
    int k;
    failure f;
    for (k = 0; k < givens; k++) CHECK(files_add(&list, given[k], &f));
    for (i = 0; i < list.count && !test_has_failed(); i++) {
        const load_options options = {WELD_DEFAULT, 1.0f};
        model m;
        if (model_load(&m, list.path[i], &options, 0, &f) && m.mesh.nt > 0) {
            make_room(m.mesh.nv, m.mesh.nt);
            memcpy(mesh.G, m.mesh.G, m.mesh.nv * sizeof *mesh.G);
            memcpy(mesh.V, m.mesh.V, 3 * m.mesh.nt * sizeof *mesh.V);
            walk_and_edit();
            if (test_has_failed()) (void)printf("%s\n", list.path[i]);
            free_room();
        }
        model_free(&m);
    }
    files_free(&list);
}

static void add(uint32_t v0, uint32_t v1, uint32_t v2) {
    mesh.V[3 * mesh.nt] = nook_store(v0);
    mesh.V[3 * mesh.nt + 1] = nook_store(v1);
    mesh.V[3 * mesh.nt++ + 2] = nook_store(v2);
}

enum { LONG = 20480 };

static void a_strip_can_be_walked_and_edited(void) {
    uint32_t t;
    make_room(LONG + 2, LONG);
    for (t = 0; t < LONG + 2; t++) mesh.G[t] = nook_make((float)(t / 2), (float)(t % 2), 0);
    for (mesh.nt = t = 0; t < LONG; t++) add(t, t % 2 == 0 ? t + 2 : t + 1, t % 2 == 0 ? t + 1 : t + 2);
    walk_and_edit();
    free_room();
}

/* A strip wound up in a square: cells of a grid in the order of a spiral, joined to the next only. */
static void a_spiral_can_be_walked_and_edited(void) {
    static const int8_t step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    uint32_t cell, left = 101, way = 0, sides = 0, run = 101;
    float x = 0, y = 0;
    make_room(LONG + 2, LONG);
    mesh.nt = 0;
    for (cell = 0; cell <= LONG / 2; cell++) {
        mesh.G[2 * cell] = nook_make(x, y, 0);
        mesh.G[2 * cell + 1] =
            nook_make(x + 0.5f * (float)step[(way + 1) % 4][0], y + 0.5f * (float)step[(way + 1) % 4][1], 0);
        x += (float)step[way][0];
        y += (float)step[way][1];
        if (--left == 0) {
            way = (way + 1) % 4;
            if (++sides % 2 == 0 && run > 1) run--;
            left = run;
        }
        if (cell == 0) continue;
        add(2 * cell - 2, 2 * cell, 2 * cell + 1);
        add(2 * cell - 2, 2 * cell + 1, 2 * cell - 1);
    }
    walk_and_edit();
    free_room();
}

int main(int argc, char **argv) {
    static const test tests[] = {TEST(a_strip_can_be_walked_and_edited),
                                 TEST(a_spiral_can_be_walked_and_edited),
                                 TEST(every_file_can_be_walked_and_edited)};
    uint32_t start = milliseconds();
    given = argv + 1;
    givens = argc - 1;
    run_tests(tests, sizeof tests / sizeof *tests);
    print_figure("walks and edits", meshes, "meshes", start);
    (void)printf("%u vertices split off, %u of %u holes filled, %u edits made and %u refused\n",
                 (unsigned)splits, (unsigned)filled, (unsigned)holes, (unsigned)edits, (unsigned)refused);
    (void)printf("%u hulls of %u points with %u vertices\n", (unsigned)hulls, (unsigned)points_of_hulls,
                 (unsigned)vertices_of_hulls);
    return finish_tests();
}
