/* test_worlds.c -- all small worlds: every list of up to four directed triangles on four vertices, and
 * every choice of five on five, where the least Moebius strip lives.
 *
 * Each is linked and checked, and every number, every opposite and every place that a finder is told
 * is compared with answers taken from a table of vertex pairs. Orientability is decided by trying all
 * ways to turn triangles over. Every few worlds the work is cut into single units as well. */
#include "check.h"
#include "rooms.h"

#include <string.h>

#include "nook.h"

enum { N = 5, T = 5, MOST_FINDS = 64 };

static struct {
    nook_point G[N];
    nook_index V[3 * T], O[3 * T], C[N], guard;
} room;
static nook_mesh mesh;
static uint8_t Mt[NOOK_MT_BYTES(T)], Mv[NOOK_MV_BYTES(N)];
static const nook_marks marks = {Mt, Mv, T, N};
static nook_shell shell[T];
static nook_index component[T], stamp[N];
static nook_shells shells = {shell, component, stamp, T, 0};
static nook_report report;
static nook_check_result result;

static struct {
    uint32_t count;
    nook_status defect[MOST_FINDS];
    nook_where where[MOST_FINDS];
} heard;

static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    if (heard.count < MOST_FINDS) {
        heard.defect[heard.count] = defect;
        heard.where[heard.count] = where;
    }
    heard.count++;
}
static const nook_finder finder = {hear, NULL};

/* ---- the answers ------------------------------------------------------------------------------- */

static uint8_t runs[N][N];     /* how many triangles run the edge from one vertex to the other */
static uint8_t partner[3 * T]; /* the other corner on an edge of two, or the corner itself */
static uint8_t on_edge[3 * T]; /* triangles on the edge that a corner faces */
static bool leads[3 * T];      /* no smaller corner faces the same edge */
static uint8_t piece[T];       /* the first triangle of the component */
static uint8_t fan[3 * T];     /* the least corner of the fan */
static uint8_t loop[3 * T];    /* of a corner at a border: the least of its loop */

static uint32_t tip(uint32_t c) { return room.V[c]; }
static uint32_t from(uint32_t c) { return room.V[c - c % 3 + (c + 1) % 3]; }
static uint32_t to(uint32_t c) { return room.V[c - c % 3 + (c + 2) % 3]; }
static bool one_edge(uint32_t c, uint32_t d) {
    return (from(c) == from(d) && to(c) == to(d)) || (from(c) == to(d) && to(c) == from(d));
}
static uint32_t at(uint32_t t, uint32_t v) {
    uint32_t c = 3 * t;
    while (tip(c) != v) c++;
    return c;
}

/* Give everything with one label the other's, the smaller one. */
static void join(uint8_t *label, uint32_t count, uint32_t i, uint32_t j) {
    uint8_t x = label[i], y = label[j], low = x < y ? x : y;
    uint32_t k;
    for (k = 0; k < count; k++) {
        if (label[k] == x || label[k] == y) label[k] = low;
    }
}

static void answer(void) {
    uint32_t c, d, nc = 3 * mesh.nt;
    memset(runs, 0, sizeof runs);
    for (c = 0; c < nc; c++) {
        runs[from(c)][to(c)]++;
        piece[c / 3] = (uint8_t)(c / 3);
        fan[c] = loop[c] = partner[c] = (uint8_t)c;
        leads[c] = true;
    }
    for (c = 0; c < nc; c++) on_edge[c] = (uint8_t)(runs[from(c)][to(c)] + runs[to(c)][from(c)]);
    for (c = 0; c < nc; c++) {
        for (d = 0; d < c; d++) {
            if (!one_edge(c, d)) continue;
            leads[c] = false;
            join(piece, mesh.nt, c / 3, d / 3);
            if (on_edge[c] != 2) continue;
            partner[c] = (uint8_t)d;
            partner[d] = (uint8_t)c;
            join(fan, nc, at(c / 3, from(c)), at(d / 3, from(c)));
            join(fan, nc, at(c / 3, to(c)), at(d / 3, to(c)));
        }
    }
    /* A fan that is not a full turn has two border edges; they follow each other in a loop. */
    for (c = 0; c < nc; c++) {
        for (d = 0; d < c; d++) {
            uint32_t i, j;
            for (i = 1; i < 3 && on_edge[c] == 1 && on_edge[d] == 1; i++) {
                for (j = 1; j < 3; j++) {
                    uint32_t e = c - c % 3 + (c + i) % 3, f = d - d % 3 + (d + j) % 3;
                    if (fan[e] == fan[f]) join(loop, nc, c, d);
                }
            }
        }
    }
}

static bool coherent(uint32_t c) { return partner[c] != c && from(c) == to(partner[c]); }

/* Whether some choice of triangles turned over makes every pair of the component run opposite ways. */
static bool can_be_oriented(uint32_t first) {
    uint32_t turned, c;
    for (turned = 0; turned < 1u << mesh.nt; turned++) {
        for (c = 0; c < 3 * mesh.nt; c++) {
            uint32_t t = c / 3, u = partner[c] / 3u;
            if (piece[t] != first || t == u) continue;
            if (coherent(c) != ((turned >> t & 1u) == (turned >> u & 1u))) break;
        }
        if (c == 3 * mesh.nt) return true;
    }
    return false;
}

/* ---- the comparison ---------------------------------------------------------------------------- */

static uint32_t told(nook_status defect, nook_kind kind, uint32_t index) {
    uint32_t i, n = 0;
    for (i = 0; i < heard.count && i < MOST_FINDS; i++) {
        n += heard.defect[i] == defect && heard.where[i].kind == kind && heard.where[i].index == index;
    }
    return n;
}
static uint32_t told_in_all(nook_status defect) {
    uint32_t i, n = 0;
    for (i = 0; i < heard.count && i < MOST_FINDS; i++) n += heard.defect[i] == defect;
    return n;
}

static void compare_edges(void) {
    uint32_t c, edges = 0, border = 0, matched = 0, incoherent = 0, many = 0, odd = 0;
    for (c = 0; c < 3 * mesh.nt; c++) {
        bool is_matched = on_edge[c] == 2 && coherent(c);
        CHECK_EQUAL(mesh.O[c], is_matched ? partner[c] : c);
        CHECK_EQUAL(told(NOOK_BORDER_EDGE, NOOK_AT_CORNER, c), leads[c] && on_edge[c] == 1);
        CHECK_EQUAL(told(NOOK_INCOHERENT_EDGE, NOOK_AT_CORNER, c),
                    leads[c] && on_edge[c] == 2 && !is_matched);
        CHECK_EQUAL(told(NOOK_NONMANIFOLD_EDGE, NOOK_AT_CORNER, c), leads[c] && on_edge[c] > 2);
        if (!leads[c]) continue;
        edges++;
        border += on_edge[c] == 1;
        matched += is_matched;
        incoherent += on_edge[c] == 2 && !is_matched;
        many += on_edge[c] > 2;
        odd += on_edge[c] % 2u;
    }
    CHECK_EQUAL(report.edges, edges);
    CHECK_EQUAL(report.border_edges, border);
    CHECK_EQUAL(report.matched_edges, matched);
    CHECK_EQUAL(report.incoherent_edges, incoherent);
    CHECK_EQUAL(report.nonmanifold_edges, many);
    CHECK_EQUAL(report.odd_edges, odd);
    CHECK_EQUAL(result.edges, edges);
    CHECK_EQUAL(result.border_edges, border);
    CHECK_EQUAL(result.matched_edges, matched);
    CHECK_EQUAL(result.incoherent_edges, incoherent);
    CHECK_EQUAL(result.nonmanifold_edges, many);
    CHECK(result.edge_manifold == (many == 0 ? NOOK_YES : NOOK_NO));
    CHECK(result.even == (odd == 0 ? NOOK_YES : NOOK_NO));
    CHECK(result.watertight == (mesh.nt > 0 && border == 0 && many == 0 ? NOOK_YES : NOOK_NO));
    CHECK(result.oriented == (incoherent == 0 ? NOOK_YES : NOOK_NO));
}

static uint32_t set_of(uint32_t t) { return 1u << tip(3 * t) | 1u << tip(3 * t + 1) | 1u << tip(3 * t + 2); }

/* Of the copies of a triangle all but one are named, each once. */
static void compare_duplicates(void) {
    uint32_t t, u, all = 0;
    for (t = 0; t < mesh.nt; t++) {
        uint32_t copies = 0, named = 0;
        bool first = true;
        for (u = 0; u < mesh.nt; u++) {
            uint32_t times = told(NOOK_DUPLICATE_TRIANGLE, NOOK_AT_TRIANGLE, u);
            if (set_of(t) != set_of(u)) continue;
            CHECK(times <= 1);
            copies++;
            named += times;
            if (u < t) first = false;
        }
        CHECK_EQUAL(named, copies - 1);
        if (first) all += copies - 1;
    }
    CHECK_EQUAL(told_in_all(NOOK_DUPLICATE_TRIANGLE), all);
    CHECK_EQUAL(report.duplicate_triangles, all);
    CHECK_EQUAL(result.duplicate_triangles, all);
}

static void compare_vertices(void) {
    uint32_t v, c, used = 0, fans_in_all = 0, bad = 0;
    for (v = 0; v < mesh.nv; v++) {
        uint32_t fans = 0, corner = NOOK_NONE;
        for (c = 0; c < 3 * mesh.nt; c++) {
            if (tip(c) != v) continue;
            fans += fan[c] == c;
            if (c == mesh.C[v]) corner = c;
        }
        CHECK_EQUAL(told(NOOK_NONMANIFOLD_VERTEX, NOOK_AT_VERTEX, v), fans > 1);
        CHECK_EQUAL(told(NOOK_ISOLATED_VERTEX, NOOK_AT_VERTEX, v), fans == 0);
        CHECK(fans == 0 ? mesh.C[v] == NOOK_STORED_NONE : corner != NOOK_NONE);
        used += fans > 0;
        bad += fans > 1;
        fans_in_all += fans;
    }
    CHECK_EQUAL(result.survey.nonmanifold_vertices, bad);
    CHECK_EQUAL(result.survey.fans, fans_in_all);
    CHECK_EQUAL(result.isolated_vertices, mesh.nv - used);
    CHECK(result.clean == (used == mesh.nv ? NOOK_YES : NOOK_NO));
    CHECK(result.euler_known);
    CHECK(result.euler == (int32_t)used - (int32_t)report.edges + (int32_t)mesh.nt);
    CHECK(result.manifold == (mesh.nt > 0 && bad == 0 && report.nonmanifold_edges == 0 ? NOOK_YES : NOOK_NO));
}

/* Six times the volume of a component; all coordinates are small whole numbers. */
static int32_t volume_of(uint32_t first) {
    int32_t sum = 0;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) {
        int32_t p[3][3];
        uint32_t i;
        if (piece[t] != first) continue;
        for (i = 0; i < 3; i++) {
            p[i][0] = (int32_t)mesh.G[tip(3 * t + i)].x;
            p[i][1] = (int32_t)mesh.G[tip(3 * t + i)].y;
            p[i][2] = (int32_t)mesh.G[tip(3 * t + i)].z;
        }
        for (i = 0; i < 3; i++) {
            const int32_t *a = p[0], *b = p[1], *c = p[2];
            sum += a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]);
        }
    }
    return sum;
}

static void compare_shell(const nook_shell *s, uint32_t first) {
    uint32_t c, v, triangles = 0, vertices = 0, fans = 0, border = 0, loops = 0, incoherent = 0, many = 0,
                   edges = 0;
    bool orientable = can_be_oriented(first), closed;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (piece[c / 3] != first) continue;
        triangles += c % 3 == 0;
        fans += fan[c] == c;
        if (!leads[c]) continue;
        edges++;
        border += on_edge[c] == 1;
        loops += on_edge[c] == 1 && loop[c] == c;
        incoherent += on_edge[c] == 2 && !coherent(c);
        many += on_edge[c] > 2;
    }
    for (v = 0; v < mesh.nv; v++) {
        for (c = 0; c < 3 * mesh.nt && !(tip(c) == v && piece[c / 3] == first); c++) {
        }
        vertices += c < 3 * mesh.nt;
    }
    CHECK_EQUAL(s->first_triangle, first);
    CHECK_EQUAL(s->triangles, triangles);
    CHECK_EQUAL(s->vertices, vertices);
    CHECK_EQUAL(s->fans, fans);
    CHECK_EQUAL(s->has_nonmanifold_edge, many > 0);
    closed = border == 0 && many == 0 && incoherent == 0;
    CHECK_EQUAL(told(NOOK_INSIDE_OUT, NOOK_AT_TRIANGLE, first), closed && volume_of(first) < 0);
    CHECK_EQUAL(told(NOOK_FLAT_SHELL, NOOK_AT_TRIANGLE, first), closed && volume_of(first) == 0);
    if (many > 0) {
        CHECK_EQUAL(nook_shell_genus(s), NOOK_UNKNOWN);
        return;
    }
    CHECK_EQUAL(s->orientable, orientable);
    CHECK_EQUAL(s->border_edges, border);
    CHECK_EQUAL(s->border_loops, loops);
    CHECK_EQUAL(s->incoherent_edges, incoherent);
    CHECK_EQUAL(nook_shell_genus(s), orientable ? (2 + edges - fans - triangles - loops) / 2 : NOOK_UNKNOWN);
    CHECK(s->signed_volume * 6.0f - (closed ? (float)volume_of(first) : 0.0f) < 0.01f);
    CHECK(s->signed_volume * 6.0f - (closed ? (float)volume_of(first) : 0.0f) > -0.01f);
}

static void compare_shells(void) {
    uint32_t t, c, components = 0, twisted = 0, loops = 0, handles = 0;
    for (t = 0; t < mesh.nt; t++) {
        if (piece[t] == t) {
            if (components < shells.count) compare_shell(&shell[components], t);
            handles += nook_shell_genus(&shell[components]);
            components++;
            if (!can_be_oriented(t)) twisted++;
        }
        for (c = 0; c < shells.count && shell[c].first_triangle != piece[t]; c++) {
        }
        CHECK_EQUAL(component[t], c);
    }
    for (c = 0; c < 3 * mesh.nt; c++) loops += on_edge[c] == 1 && loop[c] == c;
    CHECK_EQUAL(shells.count, components);
    CHECK_EQUAL(result.survey.components, components);
    if (report.nonmanifold_edges == 0) {
        CHECK_EQUAL(told_in_all(NOOK_NOT_ORIENTABLE), twisted);
        CHECK_EQUAL(result.survey.border_loops, loops);
        CHECK(result.survey.orientable == (twisted == 0 ? NOOK_YES : NOOK_NO));
        CHECK_EQUAL(result.handles, twisted == 0 ? handles : NOOK_UNKNOWN);
        CHECK_EQUAL(result.patch, twisted == 0 && handles == 0 && components == 1 && loops == 1 &&
                                      result.survey.nonmanifold_vertices == 0);
        CHECK(result.simple == (mesh.nt > 0 && components == 1 && report.border_edges == 0 && twisted == 0 &&
                                        result.survey.nonmanifold_vertices == 0 && result.euler == 2
                                    ? NOOK_YES
                                    : NOOK_NO));
    } else {
        CHECK(told_in_all(NOOK_NOT_ORIENTABLE) <= components);
        CHECK_EQUAL(result.survey.border_loops, NOOK_UNKNOWN);
        CHECK(result.survey.orientable == NOOK_MAYBE);
        CHECK(result.simple == NOOK_NO && result.patch == NOOK_NO && result.handles == NOOK_UNKNOWN);
    }
}

static void compare_verdict(void) {
    bool closed = result.watertight == NOOK_YES && result.oriented == NOOK_YES;
    bool positive = true;
    int32_t volume = 0;
    uint32_t t, named;
    for (t = 0; t < mesh.nt; t++) {
        volume += piece[t] == t ? volume_of(t) : 0;
        positive = positive && volume_of(piece[t]) > 0;
    }
    if (!closed) CHECK(result.inside_out == NOOK_MAYBE);
    if (closed) CHECK((result.inside_out == NOOK_YES) == (volume < 0) && result.inside_out != NOOK_MAYBE);
    CHECK_EQUAL(nook_is_sound(&result), closed && result.manifold == NOOK_YES && positive &&
                                            report.duplicate_triangles == 0 &&
                                            told_in_all(NOOK_FOLDED_EDGE) == 0);
    named =
        report.border_edges + report.incoherent_edges + report.nonmanifold_edges + report.duplicate_triangles;
    named += result.survey.nonmanifold_vertices + result.isolated_vertices + told_in_all(NOOK_NOT_ORIENTABLE);
    named += told_in_all(NOOK_INSIDE_OUT) + told_in_all(NOOK_FLAT_SHELL) + told_in_all(NOOK_EMPTY_MESH);
    named += result.geometry.folded_edges + result.geometry.zero_area_triangles;
    CHECK_EQUAL(heard.count, named);
    CHECK_EQUAL(told_in_all(NOOK_EMPTY_MESH), mesh.nt == 0);
    CHECK_EQUAL(result.bad_indices + result.bad_opposites + result.bad_corners + result.bad_coordinates, 0);
    CHECK_EQUAL(result.repeated_vertex_triangles, 0);
}

/* ---- all worlds -------------------------------------------------------------------------------- */

/* Link and check with `cut` units at a time. */
static void work(uint32_t cut) {
    nook_link_state linking;
    nook_check_state checking;
    nook_view view;
    nook_status status;
    uint32_t units, calls = 0, spent = 0, bound = 4 * mesh.nt + mesh.nv;
    CHECK_EQUAL(nook_link_begin(&linking, &mesh, &marks, &shells, &finder, &report), NOOK_OK);
    do {
        units = cut;
        status = nook_link_step(&linking, &units);
        spent += cut - units;
        calls++;
    } while (status == NOOK_MORE && calls < 4000);
    CHECK_EQUAL(status, NOOK_OK);
    /* As nook_link.h states it: less for a sound mesh, and a survey only for the worst. */
    if (report.matched_edges < report.edges || report.duplicate_triangles > 0)
        bound += 15 * mesh.nt + mesh.nv;
    if (report.incoherent_edges + report.nonmanifold_edges > 0) bound += 25 * mesh.nt + 3 * mesh.nv + 20;
    CHECK(spent <= bound);
    spent = 0;
    view = nook_view_of(&mesh);
    CHECK_EQUAL(nook_check_begin(&checking, &view, &marks, &report, &shells, &finder, &result), NOOK_OK);
    do {
        units = cut;
        status = nook_check_step(&checking, &units);
        spent += cut - units;
        calls++;
    } while (status == NOOK_MORE && calls < 4000);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK(spent <= NOOK_CHECK_UNITS(mesh.nt, mesh.nv, mesh.nt));
}

static uint32_t worlds;

static void try_world(void) {
    heard.count = 0;
    memset(room.O, 0x77, sizeof room.O);
    memset(room.C, 0x77, sizeof room.C);
    work(worlds++ % 8 == 0 ? 1 : 100000);
    answer();
    compare_edges();
    compare_duplicates();
    compare_vertices();
    compare_shells();
    compare_verdict();
    if (test_has_failed()) {
        uint32_t c;
        print_text("in the world");
        for (c = 0; c < 3 * mesh.nt; c++) {
            print_text(c % 3 == 0 ? " " : "-");
            print_number(tip(c));
        }
        print_text("\n");
    }
}

static void begin_world(uint32_t nv) {
    uint32_t v;
    CHECK_EQUAL(nook_mesh_init(&mesh, room.G, room.V, room.O, room.C, N, T), NOOK_OK);
    mesh.nv = nv;
    /* On the curve (v, v^2, v^3) no four points lie in a plane. */
    for (v = 0; v < nv; v++) room.G[v] = nook_make((float)v, (float)(v * v), (float)(v * v * v));
    room.guard = 0x5A5A;
    worlds = 0;
}

/* The directed triangles on nv vertices, each set twice: a < b < c as a b c and as a c b. */
static uint8_t choice[20][3];
static uint32_t list_choices(uint32_t nv) {
    uint32_t a, b, c, n = 0, way;
    for (a = 0; a < nv; a++) {
        for (b = a + 1; b < nv; b++) {
            for (c = b + 1; c < nv; c++) {
                for (way = 0; way < 2; way++, n++) {
                    choice[n][0] = (uint8_t)a;
                    choice[n][1] = (uint8_t)(way == 0 ? b : c);
                    choice[n][2] = (uint8_t)(way == 0 ? c : b);
                }
            }
        }
    }
    return n;
}

/* The corners of the triangles are turned differently from world to world. */
static void set_triangle(uint32_t t, uint32_t chosen) {
    uint32_t i, turn = (chosen + t + worlds) % 3;
    for (i = 0; i < 3; i++) room.V[3 * t + i] = choice[chosen][(i + turn) % 3];
}

static void every_list_of_up_to_four_triangles_on_four_vertices(void) {
    uint32_t choices = list_choices(4), nt, k, t, lists = 1;
    begin_world(4);
    for (nt = 0; nt <= 4; nt++, lists *= choices) {
        for (k = 0; k < lists && !test_has_failed(); k++) {
            uint32_t rest = k;
            mesh.nt = nt;
            for (t = 0; t < nt; t++, rest /= choices) set_triangle(t, rest % choices);
            try_world();
        }
    }
    CHECK_EQUAL(worlds, 1 + 8 + 64 + 512 + 4096);
    CHECK_EQUAL(room.guard, 0x5A5A);
}

static void every_choice_of_five_triangles_on_five_vertices(void) {
    uint32_t choices = list_choices(5), i, chosen[5] = {0, 0, 0, 0, 0};
    begin_world(5);
    mesh.nt = 5;
    while (!test_has_failed()) {
        for (i = 0; i < 5; i++) set_triangle(i, chosen[i]);
        try_world();
        for (i = 5; i > 0 && chosen[i - 1] == choices - 1; i--) {
        }
        if (i == 0) break;
        chosen[i - 1]++;
        for (; i < 5; i++) chosen[i] = chosen[i - 1];
    }
    CHECK_EQUAL(worlds, 42504); /* 24 over 5 */
    CHECK_EQUAL(room.guard, 0x5A5A);
}

static const test tests[] = {
    TEST(every_list_of_up_to_four_triangles_on_four_vertices),
    TEST(every_choice_of_five_triangles_on_five_vertices),
};

void test_worlds(void) { run_tests(tests, sizeof tests / sizeof *tests); }
