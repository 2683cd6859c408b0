/* worlds.c -- every choice of one to five directed triangles on three to six vertices, 1,276,193 worlds.
 *
 * Proven for every multiset of directed triangles (one rotation each; the same triangle may come again; a
 * vertex may be left out and is then isolated): every opposite, every corner of a vertex, and every count
 * and truth that link, survey and check give, as a whole and shell by shell, are those of the definitions
 * (truth.json's words). Order and rotation of the triangles differ from world to world.
 *
 * How: the definitions are decided a second time from sets of triangles, one bit each. A pair of vertices
 * has the set of triangles that run it one way and the set that run it the other. Components and fans are
 * closures of sets. A vertex is non-manifold if its link (the edges facing it) is not one simple path or
 * cycle. Orientability tries all 2^t ways to turn triangles over, one bit a way. The library is run
 *   - with marks and shells and nobody listening, the short way that a sound mesh takes;
 *   - with a listener, whose finds are counted by kind; one world of eight by single units, against the
 *     bounds in the headers; one of eight without marks;
 *   - and checked with link's report, and without it against the mesh that O alone shows.
 * That the enumeration is whole is held against binomials, and the oracle against three counts of orientable
 * manifold lists known from another program (1,920, 20,970 and 59,904). */
#include <stdio.h>
#include <string.h>

#include "bounds.h"
#include "check.h"
#include "nook.h"
#include "nook_port.h"
#include "prove.h"

enum { N = 6, T = 5, C = 3 * T, MOST_FANS = 3 * T };

static nook_mesh mesh;
static nook_marks marks;
static nook_shells shells;
static nook_report report;
static nook_check_result result;
static uint32_t world; /* its number on this many vertices */

/* ---- the answers ----------------------------------------------------------------------------------- */

typedef uint32_t set; /* of triangles, of vertices, or of ways to turn the triangles over */

static uint8_t size_of[64]; /* of a set of at most six things */
static set agreeing[T][T];  /* the ways to turn triangles over that treat two of them alike */

static struct {
    set vertices[T], used;
    set up[N][N], down[N][N]; /* who runs the edge from the smaller to the larger vertex, who the other way */
    uint8_t partner[C];       /* the other corner on an edge of two, or the corner itself */
    uint8_t joint[C];         /* the partner across which parts are joined, or the corner itself */
    set piece[T], fan[MOST_FANS];
    uint8_t fan_vertex[MOST_FANS], loop[C];
    uint32_t pieces, fans;
    uint32_t edges, border, matched, incoherent, many, odd, duplicates;
} a;

static uint32_t tip(uint32_t c) { return mesh.V[c]; }
static uint32_t from(uint32_t c) { return mesh.V[c - c % 3 + (c + 1) % 3]; }
static uint32_t to(uint32_t c) { return mesh.V[c - c % 3 + (c + 2) % 3]; }
static uint32_t lower(uint32_t c) { return from(c) < to(c) ? from(c) : to(c); }
static uint32_t upper(uint32_t c) { return from(c) < to(c) ? to(c) : from(c); }
static bool rises(uint32_t c) { return from(c) < to(c); }
static set on_edge(uint32_t c) { return a.up[lower(c)][upper(c)] | a.down[lower(c)][upper(c)]; }
static bool coherent(uint32_t c) { return rises(c) != rises(a.partner[c]); }
static bool has(set s, uint32_t i) { return (s >> i & 1u) != 0; }

static void count_bits(void) {
    uint32_t i, j, way;
    for (i = 0; i < 64; i++) size_of[i] = (uint8_t)((i & 1u) + (i > 1 ? size_of[i / 2] : 0));
    for (i = 0; i < T; i++) {
        for (j = 0; j < T; j++) {
            agreeing[i][j] = 0;
            for (way = 0; way < 1u << T; way++) agreeing[i][j] |= (set)(has(way, i) == has(way, j)) << way;
        }
    }
}

/* The corner of triangle t that faces the edge v w. */
static uint32_t facing(uint32_t t, uint32_t v, uint32_t w) {
    uint32_t c = 3 * t;
    while (tip(c) == v || tip(c) == w) c++;
    return c;
}

static uint32_t other_of(set two, uint32_t t) {
    uint32_t u = 0;
    while (u == t || !has(two, u)) u++;
    return u;
}

static void answer_edges(void) {
    uint32_t c, t, v, w;
    memset(&a, 0, sizeof a);
    for (c = 0; c < 3 * mesh.nt; c++) {
        a.vertices[c / 3] |= 1u << tip(c);
        a.used |= 1u << tip(c);
        *(rises(c) ? &a.up[lower(c)][upper(c)] : &a.down[lower(c)][upper(c)]) |= 1u << c / 3;
    }
    for (v = 0; v < N; v++) {
        for (w = v + 1; w < N; w++) {
            uint32_t up = size_of[a.up[v][w]], down = size_of[a.down[v][w]], n = up + down;
            a.edges += n > 0;
            a.border += n == 1;
            a.matched += n == 2 && up == 1;
            a.incoherent += n == 2 && up != 1;
            a.many += n > 2;
            a.odd += n % 2;
        }
    }
    for (c = 0; c < 3 * mesh.nt; c++) {
        bool two = size_of[on_edge(c)] == 2;
        a.partner[c] = (uint8_t)(two ? facing(other_of(on_edge(c), c / 3), from(c), to(c)) : c);
    }
    for (t = 0; t < mesh.nt; t++) {
        for (v = 0; v < t && a.vertices[v] != a.vertices[t]; v++) {
        }
        a.duplicates += v < t;
    }
}

/* The triangles that t touches: across joints, and across edges of three and more if rings is set. */
static set beside(uint32_t t, bool rings) {
    set all = 1u << t;
    uint32_t c;
    for (c = 3 * t; c < 3 * t + 3; c++) {
        all |= 1u << a.joint[c] / 3u;
        if (rings && size_of[on_edge(c)] > 2) all |= on_edge(c);
    }
    return all;
}

/* The triangles that t touches across a joint whose edge has the vertex v. */
static set beside_at(uint32_t t, uint32_t v) {
    set all = 1u << t;
    uint32_t c;
    for (c = 3 * t; c < 3 * t + 3; c++) {
        if (tip(c) != v) all |= 1u << a.joint[c] / 3u;
    }
    return all;
}

static set all_beside(set s, bool rings) {
    set all = s;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) all |= has(s, t) ? beside(t, rings) : 0;
    return all;
}

static set all_beside_at(set s, uint32_t v) {
    set all = s;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) all |= has(s, t) ? beside_at(t, v) : 0;
    return all;
}

static void answer_pieces(bool rings) {
    set left = (1u << mesh.nt) - 1u, s, more;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) {
        if (!has(left, t)) continue;
        for (s = 1u << t; (more = all_beside(s, rings)) != s; s = more) {
        }
        a.piece[a.pieces++] = s;
        left &= ~s;
    }
}

static set triangles_at(uint32_t v) {
    set s = 0;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) s |= (set)has(a.vertices[t], v) << t;
    return s;
}

static void answer_fans(void) {
    uint32_t v, t;
    set s, more;
    for (v = 0; v < mesh.nv; v++) {
        set left = triangles_at(v);
        for (t = 0; t < mesh.nt; t++) {
            if (!has(left, t)) continue;
            for (s = 1u << t; (more = all_beside_at(s, v)) != s; s = more) {
            }
            a.fan_vertex[a.fans] = (uint8_t)v;
            a.fan[a.fans++] = s;
            left &= ~s;
        }
    }
}

/* Loops: the two free edges at the ends of a fan follow each other. */
static void join_ends(uint32_t f) {
    uint32_t c, d, end[2] = {0, 0}, ends = 0;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (!has(a.fan[f], c / 3) || tip(c) == a.fan_vertex[f] || a.joint[c] != c) continue;
        if (!has(a.vertices[c / 3], a.fan_vertex[f])) continue;
        end[ends++ % 2] = c;
    }
    CHECK(ends == 0 || ends == 2);
    if (ends != 2) return;
    c = a.loop[end[0]];
    d = a.loop[end[1]];
    for (ends = 0; ends < 3 * mesh.nt; ends++) {
        if (a.loop[ends] == c) a.loop[ends] = (uint8_t)d;
    }
}

/* Parts as the library names them: across pairs, coherent or not; or across what O alone shows. */
static void answer_parts(bool O_alone) {
    uint32_t c, f;
    a.pieces = a.fans = 0;
    for (c = 0; c < 3 * mesh.nt; c++) {
        a.joint[c] = (uint8_t)(O_alone && !coherent(c) ? c : a.partner[c]);
        a.loop[c] = (uint8_t)c;
    }
    answer_pieces(!O_alone);
    answer_fans();
    for (f = 0; f < a.fans; f++) join_ends(f);
}

/* The link of v is one simple path or cycle: its vertices have at most two edges, and it hangs together. */
static bool is_manifold_at(uint32_t v) {
    set at_v = triangles_at(v), reached, before = 0;
    uint32_t t, w;
    for (w = 0; w < mesh.nv; w++) {
        if (w != v && size_of[triangles_at(w) & at_v] > 2) return false;
    }
    for (reached = at_v & (~at_v + 1u); reached != before;) {
        set vertices = 0;
        before = reached;
        for (t = 0; t < mesh.nt; t++) vertices |= has(reached, t) ? a.vertices[t] & ~(1u << v) : 0;
        for (t = 0; t < mesh.nt; t++) {
            if (has(at_v, t) && (a.vertices[t] & vertices) != 0) reached |= 1u << t;
        }
    }
    return reached == at_v;
}

/* Whether some way to turn its triangles over makes every joint of a piece coherent. */
static bool can_be_oriented(set piece) {
    set ways = UINT32_MAX;
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) {
        uint32_t t = c / 3, u = a.joint[c] / 3u;
        if (!has(piece, t) || a.joint[c] == c) continue;
        ways &= coherent(c) ? agreeing[t][u] : ~agreeing[t][u];
    }
    return ways != 0;
}

/* ---- the comparison -------------------------------------------------------------------------------- */

static uint32_t heard[NOOK_STATUS_COUNT];
static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    (void)where;
    heard[defect]++;
}
static const nook_finder finder = {hear, NULL};

static nook_truth truth(bool yes) { return yes ? NOOK_YES : NOOK_NO; }

static void compare_tables(void) {
    uint32_t c, v;
    for (c = 0; c < 3 * mesh.nt; c++) CHECK_EQUAL(mesh.O[c], coherent(c) ? a.partner[c] : c);
    for (v = 0; v < mesh.nv; v++) {
        if (!has(a.used, v)) {
            CHECK_EQUAL(mesh.C[v], NOOK_STORED_NONE);
        } else if (CHECK(mesh.C[v] < 3 * mesh.nt)) {
            CHECK_EQUAL(tip(mesh.C[v]), v);
        }
    }
}

static void compare_report(const nook_report *r) {
    CHECK_EQUAL(r->triangles, mesh.nt);
    CHECK_EQUAL(r->edges, a.edges);
    CHECK_EQUAL(r->border_edges, a.border);
    CHECK_EQUAL(r->matched_edges, a.matched);
    CHECK_EQUAL(r->incoherent_edges, a.incoherent);
    CHECK_EQUAL(r->nonmanifold_edges, a.many);
    CHECK_EQUAL(r->odd_edges, a.odd);
}

static uint32_t count_nonmanifold(void) {
    uint32_t v, bad = 0;
    for (v = 0; v < mesh.nv; v++) bad += has(a.used, v) && !is_manifold_at(v);
    return bad;
}

static uint32_t loops_of(set piece) {
    uint32_t c, loops = 0;
    for (c = 0; c < 3 * mesh.nt; c++) loops += has(piece, c / 3) && a.joint[c] == c && a.loop[c] == c;
    return loops;
}

static bool is_orientable(void) {
    uint32_t k;
    for (k = 0; k < a.pieces && can_be_oriented(a.piece[k]); k++) {
    }
    return k == a.pieces;
}

static bool is_unknown(const nook_survey *s) {
    return s->components == NOOK_UNKNOWN && s->fans == NOOK_UNKNOWN &&
           s->nonmanifold_vertices == NOOK_UNKNOWN && s->border_loops == NOOK_UNKNOWN &&
           s->orientable == NOOK_MAYBE;
}

static void compare_survey(const nook_survey *s, uint32_t nonmanifold_vertices, bool many) {
    CHECK_EQUAL(s->components, a.pieces);
    CHECK_EQUAL(s->fans, a.fans);
    CHECK_EQUAL(s->nonmanifold_vertices, nonmanifold_vertices);
    CHECK_EQUAL(s->border_loops, many ? NOOK_UNKNOWN : loops_of((1u << mesh.nt) - 1u));
    CHECK_EQUAL(s->orientable, many ? NOOK_MAYBE : truth(is_orientable()));
}

/* Six times the volume of the tetrahedron over three vertices from a fourth, or from the origin; all
 * coordinates are small whole numbers. */
static int32_t volume_over(const uint32_t vertex[4]) {
    int32_t p[4][3], sum = 0;
    uint32_t i, j, k;
    for (i = 0; i < 4; i++) {
        nook_point g = vertex[i] < mesh.nv ? mesh.G[vertex[i]] : nook_make(0, 0, 0);
        p[i][0] = (int32_t)g.x;
        p[i][1] = (int32_t)g.y;
        p[i][2] = (int32_t)g.z;
    }
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        k = (i + 2) % 3;
        sum += (p[0][i] - p[3][i]) *
               ((p[1][j] - p[3][j]) * (p[2][k] - p[3][k]) - (p[1][k] - p[3][k]) * (p[2][j] - p[3][j]));
    }
    return sum;
}

/* Above 0 where v lies on the side that triangle t faces; from the origin if there is no such vertex. */
static int32_t above(uint32_t t, uint32_t v) {
    uint32_t vertex[4] = {tip(3 * t), tip(3 * t + 1), tip(3 * t + 2), v};
    return -volume_over(vertex);
}

/* Six times the volume of a piece about the origin. */
static int32_t volume_of(set piece) {
    int32_t sum = 0;
    uint32_t t;
    for (t = 0; t < mesh.nt; t++) sum -= has(piece, t) ? above(t, N) : 0;
    return sum;
}

static bool is_closed_piece(set piece) {
    uint32_t c;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (has(piece, c / 3) && (a.partner[c] == c || !coherent(c))) return false;
    }
    return true;
}

static uint32_t fans_in(set piece) {
    uint32_t f, fans = 0;
    for (f = 0; f < a.fans; f++) fans += (a.fan[f] & piece) != 0;
    return fans;
}

/* What a piece holds: its vertices, and its edges of each kind. */
typedef struct holding {
    set vertices;
    uint32_t edges, border, incoherent, many;
} holding;

static holding hold(set piece, bool O_alone) {
    holding h = {0, 0, 0, 0, 0};
    uint32_t c, t;
    for (t = 0; t < mesh.nt; t++) h.vertices |= has(piece, t) ? a.vertices[t] : 0;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (!has(piece, c / 3)) continue;
        h.edges += O_alone ? a.joint[c] >= c : (on_edge(c) & ((1u << c / 3) - 1u)) == 0;
        h.border += O_alone ? a.joint[c] == c : size_of[on_edge(c)] == 1;
        h.incoherent += a.joint[c] > c && !coherent(c);
        h.many += !O_alone && size_of[on_edge(c)] > 2;
    }
    return h;
}

static void compare_shell(const nook_shell *s, set piece, bool O_alone) {
    holding h = hold(piece, O_alone);
    uint32_t first = 0, genus;
    while (!has(piece, first)) first++;
    CHECK_EQUAL(s->first_triangle, first);
    CHECK_EQUAL(s->triangles, size_of[piece]);
    CHECK_EQUAL(s->vertices, size_of[h.vertices]);
    CHECK_EQUAL(s->fans, fans_in(piece));
    CHECK_EQUAL(s->has_nonmanifold_edge, h.many > 0);
    genus = (2 + h.edges - s->fans - s->triangles - loops_of(piece)) / 2;
    if (h.many > 0 || !can_be_oriented(piece)) genus = NOOK_UNKNOWN;
    CHECK_EQUAL(nook_shell_genus(s), genus);
    if (h.many > 0) return;
    CHECK_EQUAL(s->orientable, can_be_oriented(piece));
    CHECK_EQUAL(s->border_edges, h.border);
    CHECK_EQUAL(s->border_loops, loops_of(piece));
    CHECK_EQUAL(s->incoherent_edges, h.incoherent);
    CHECK(s->signed_volume == (is_closed_piece(piece) ? (float)((double)volume_of(piece) / 6.0) : 0.0f));
}

static void compare_shells(bool O_alone) {
    uint32_t k, t;
    CHECK_EQUAL(shells.count, a.pieces);
    for (k = 0; k < a.pieces && k < shells.count; k++) {
        compare_shell(&shells.shell[k], a.piece[k], O_alone);
        for (t = 0; t < mesh.nt; t++) CHECK_EQUAL(shells.component[t] == k, has(a.piece[k], t));
    }
}

/* What check says of the tables themselves, with or without a report. */
static void compare_whole(void) {
    const nook_check_result *r = &result;
    uint32_t isolated = mesh.nv - size_of[a.used];
    CHECK_EQUAL(r->bad_indices + r->bad_opposites + r->bad_corners + r->bad_coordinates, 0);
    CHECK_EQUAL(r->repeated_vertex_triangles, 0);
    CHECK_EQUAL(r->isolated_vertices, isolated);
    CHECK_EQUAL(r->vertices, mesh.nv);
    CHECK_EQUAL(r->triangles, mesh.nt);
    CHECK_EQUAL(r->clean, truth(isolated == 0));
}

static void compare_result(uint32_t nonmanifold_vertices) {
    const nook_check_result *r = &result;
    bool watertight = a.border == 0 && a.many == 0, is_manifold = a.many == 0 && nonmanifold_vertices == 0;
    int32_t euler = (int32_t)size_of[a.used] - (int32_t)a.edges + (int32_t)mesh.nt;
    compare_whole();
    CHECK_EQUAL(r->edges, a.edges);
    CHECK_EQUAL(r->border_edges, a.border);
    CHECK_EQUAL(r->matched_edges, a.matched);
    CHECK_EQUAL(r->incoherent_edges, a.incoherent);
    CHECK_EQUAL(r->nonmanifold_edges, a.many);
    CHECK_EQUAL(r->duplicate_triangles, a.duplicates);
    CHECK(r->euler_known);
    CHECK_EQUAL(r->euler, euler);
    CHECK_EQUAL(r->edge_manifold, truth(a.many == 0));
    CHECK_EQUAL(r->manifold, truth(is_manifold));
    CHECK_EQUAL(r->even, truth(a.odd == 0));
    CHECK_EQUAL(r->watertight, truth(watertight));
    CHECK_EQUAL(r->oriented, truth(a.incoherent == 0));
    CHECK_EQUAL(r->simple,
                truth(watertight && is_manifold && a.pieces == 1 && is_orientable() && euler == 2));
}

/* Each edge between two triangles by where the far corner lies; no four vertices lie in a plane, so one that
 * is in it is a corner of both, and they lie on each other. */
static void compare_edges(int facing) {
    const nook_geometry *g = &result.geometry;
    uint32_t c, concave = 0, convex = 0, folded = 0;
    for (c = 0; c < 3 * mesh.nt; c++) {
        int32_t side = above(c / 3, tip(a.partner[c])) * facing;
        if (a.partner[c] <= c || !coherent(c)) continue;
        concave += side > 0;
        convex += side < 0;
        folded += side == 0;
    }
    CHECK_EQUAL(g->concave_edges, concave);
    CHECK_EQUAL(g->convex_edges, convex);
    CHECK_EQUAL(g->folded_edges, folded);
    CHECK_EQUAL(g->flat_edges, 0);
    CHECK_EQUAL(g->zero_area_triangles, 0);
}

/* No vertex of a triangle is outside the plane of a triangle. */
static bool nothing_is_outside(int facing) {
    uint32_t t, v;
    for (t = 0; t < mesh.nt; t++) {
        for (v = 0; v < mesh.nv; v++) {
            if (has(a.used, v) && above(t, v) * facing > 0) return false;
        }
    }
    return true;
}

static void compare_witness(int facing) {
    const nook_geometry *g = &result.geometry;
    if (g->witness_vertex == NOOK_NONE) return;
    CHECK(g->convex == NOOK_NO);
    if (CHECK(g->witness_vertex < mesh.nv && g->witness_triangle < mesh.nt))
        CHECK(has(a.used, g->witness_vertex) && above(g->witness_triangle, g->witness_vertex) * facing > 0);
}

static bool is_closed(void) { return is_closed_piece((1u << mesh.nt) - 1u); }

/* The mesh has a volume if it is closed; the shells that are closed have theirs in any case. */
static void compare_geometry(void) {
    bool closed = is_closed();
    const nook_geometry *g = &result.geometry;
    int32_t volume = closed ? volume_of((1u << mesh.nt) - 1u) : 0;
    int sign = volume > 0 ? 1 : volume < 0 ? -1 : 0, facing = sign < 0 ? -1 : 1;
    uint32_t k, inside_out = 0, flat = 0;
    for (k = 0; k < a.pieces; k++) {
        inside_out += is_closed_piece(a.piece[k]) && volume_of(a.piece[k]) < 0;
        flat += is_closed_piece(a.piece[k]) && volume_of(a.piece[k]) == 0;
    }
    CHECK(g->known);
    CHECK_EQUAL(g->inside_out_shells, inside_out);
    CHECK_EQUAL(g->flat_shells, flat);
    CHECK_EQUAL(g->volume_sign, sign);
    CHECK_EQUAL(nook_volume_sign(&g->volume), sign);
    CHECK(g->signed_volume == (float)((double)volume / 6.0));
    compare_edges(facing);
    compare_witness(facing);
    CHECK_EQUAL(g->convex,
                closed ? truth(sign != 0 && a.pieces == 1 && nothing_is_outside(facing)) : NOOK_MAYBE);
}

static void compare_verdict(uint32_t nonmanifold_vertices) {
    const nook_geometry *g = &result.geometry;
    int32_t volume = volume_of((1u << mesh.nt) - 1u);
    compare_geometry();
    CHECK_EQUAL(result.inside_out, is_closed() ? truth(volume < 0) : NOOK_MAYBE);
    CHECK_EQUAL(nook_is_sound(&result), is_closed() && nonmanifold_vertices == 0 && a.duplicates == 0 &&
                                            volume > 0 && g->inside_out_shells == 0 && g->flat_shells == 0);
}

static void compare_unknown(void) {
    const nook_check_result *r = &result;
    compare_whole();
    compare_geometry(); /* a mesh whose corners O pairs, all of them, has an inside, though nobody says so */
    CHECK_EQUAL(r->edges, NOOK_UNKNOWN);
    CHECK_EQUAL(r->border_edges, NOOK_UNKNOWN);
    CHECK_EQUAL(r->matched_edges, NOOK_UNKNOWN);
    CHECK_EQUAL(r->incoherent_edges, NOOK_UNKNOWN);
    CHECK_EQUAL(r->nonmanifold_edges, NOOK_UNKNOWN);
    CHECK_EQUAL(r->duplicate_triangles, NOOK_UNKNOWN);
    CHECK(!r->euler_known);
    CHECK(r->edge_manifold == NOOK_MAYBE && r->manifold == NOOK_MAYBE && r->even == NOOK_MAYBE);
    CHECK(r->watertight == NOOK_MAYBE && r->oriented == NOOK_MAYBE && r->simple == NOOK_MAYBE);
    CHECK(r->inside_out == NOOK_MAYBE && !nook_is_sound(r));
}

static void compare_heard(uint32_t nonmanifold_vertices) {
    CHECK_EQUAL(heard[NOOK_BORDER_EDGE], a.border);
    CHECK_EQUAL(heard[NOOK_INCOHERENT_EDGE], a.incoherent);
    CHECK_EQUAL(heard[NOOK_NONMANIFOLD_EDGE], a.many);
    CHECK_EQUAL(heard[NOOK_DUPLICATE_TRIANGLE], a.duplicates);
    CHECK_EQUAL(heard[NOOK_NONMANIFOLD_VERTEX], nonmanifold_vertices);
    CHECK_EQUAL(heard[NOOK_ISOLATED_VERTEX], mesh.nv - size_of[a.used]);
    CHECK_EQUAL(heard[NOOK_INSIDE_OUT], result.geometry.inside_out_shells);
    CHECK_EQUAL(heard[NOOK_FLAT_SHELL], result.geometry.flat_shells);
    CHECK_EQUAL(heard[NOOK_FOLDED_EDGE], result.geometry.folded_edges);
    CHECK_EQUAL(heard[NOOK_ZERO_AREA_TRIANGLE], 0);
    if (a.many == 0) CHECK_EQUAL(heard[NOOK_NOT_ORIENTABLE] > 0, !is_orientable());
}

/* ---- the library's runs ---------------------------------------------------------------------------- */

/* Link in slices of cut units; the bound that nook_link.h states for this mesh. */
static void link_in_slices(uint32_t cut, nook_report *to) {
    nook_link_state state;
    nook_status status;
    uint32_t units, spent = 0, bound = link_bound(mesh.nv, mesh.nt);
    CHECK_EQUAL(nook_link_begin(&state, &mesh, &marks, &shells, &finder, to), NOOK_OK);
    do {
        units = cut;
        status = nook_link_step(&state, &units);
        spent += cut - units;
    } while (status == NOOK_MORE && spent < 4000);
    CHECK_EQUAL(status, NOOK_OK);
    if (a.matched < a.edges || a.duplicates > 0)
        bound += link_bound_of_defects(mesh.nv, mesh.nt, a.incoherent + a.many > 0);
    CHECK(spent <= bound);
}

static void check_in_slices(uint32_t cut, const nook_report *given, const nook_finder *told) {
    nook_check_state state;
    nook_status status;
    nook_view view = nook_view_of(&mesh);
    uint32_t units, spent = 0;
    CHECK_EQUAL(nook_check_begin(&state, &view, &marks, given, &shells, told, &result), NOOK_OK);
    do {
        units = cut;
        status = nook_check_step(&state, &units);
        spent += cut - units;
    } while (status == NOOK_MORE && spent < 4000);
    CHECK_EQUAL(status, NOOK_OK);
    CHECK(spent <= check_bound(mesh.nv, mesh.nt, 0));
}

static void spoil_tables(void) {
    memset(mesh.O, 0x77, 3 * mesh.nt * sizeof *mesh.O);
    memset(mesh.C, 0x77, mesh.nv * sizeof *mesh.C);
}

/* With nobody listening; what the survey is, link says only where O cannot show it. */
static void try_alone(uint32_t bad) {
    spoil_tables();
    CHECK_EQUAL(nook_link(&mesh, &marks, &shells, NULL, &report, NULL), NOOK_OK);
    compare_tables();
    compare_report(&report);
    CHECK_EQUAL(report.duplicate_triangles, a.duplicates);
    if (a.incoherent + a.many == 0) {
        CHECK(is_unknown(&report.survey));
    } else {
        compare_survey(&report.survey, bad, a.many > 0);
    }
    check_in_slices(UINT32_MAX, &report, NULL);
    compare_result(bad);
    compare_survey(&result.survey, bad, a.many > 0);
    compare_shells(false);
    compare_verdict(bad);
}

static void try_listening(uint32_t bad) {
    uint32_t cut = world % 8 == 0 ? 1 : 100000;
    nook_report second;
    memset(heard, 0, sizeof heard);
    spoil_tables();
    link_in_slices(cut, &second);
    compare_tables();
    CHECK(memcmp(&second, &report, sizeof report) == 0);
    check_in_slices(cut, &second, &finder);
    compare_result(bad);
    compare_heard(bad);
    compare_shells(false);
}

/* Without marks the edges are counted all the same, and what needs marks is unknown. */
static void try_without_marks(void) {
    spoil_tables();
    CHECK_EQUAL(nook_link(&mesh, NULL, NULL, NULL, &report, NULL), NOOK_OK);
    compare_tables();
    compare_report(&report);
    CHECK_EQUAL(report.duplicate_triangles, a.many > 0 ? NOOK_UNKNOWN : a.duplicates);
    CHECK(is_unknown(&report.survey));
}

static void try_O_alone(void) {
    uint32_t v, f, fans, bad = 0;
    answer_parts(true);
    for (v = 0; v < mesh.nv; v++) {
        for (f = fans = 0; f < a.fans; f++) fans += a.fan_vertex[f] == v;
        bad += fans > 1;
    }
    check_in_slices(UINT32_MAX, NULL, NULL);
    compare_unknown();
    compare_survey(&result.survey, bad, false);
    compare_shells(true);
}

static uint32_t manifold, orientable_manifold, coherent_manifold, sound;

static void tally(uint32_t bad) {
    bool good = a.many == 0 && bad == 0;
    manifold += good;
    orientable_manifold += good && is_orientable();
    coherent_manifold += good && a.incoherent == 0;
    sound += nook_is_sound(&result);
}

static void say_world(void) {
    uint32_t c;
    print_text("in the world");
    for (c = 0; c < 3 * mesh.nt; c++) {
        print_text(c % 3 == 0 ? " " : "-");
        print_number(tip(c));
    }
    print_text("\n");
}

static void try_world(void) {
    uint32_t bad;
    answer_edges();
    answer_parts(false);
    bad = count_nonmanifold();
    try_alone(bad);
    tally(bad);
    try_listening(bad);
    if (world % 8 == 1) try_without_marks();
    try_O_alone();
    CHECK(fences_hold());
    if (test_has_failed()) say_world();
    world++;
}

/* ---- all worlds ------------------------------------------------------------------------------------ */

/* The directed triangles on nv vertices: a < b < c as a b c and as a c b. */
static uint8_t choice[40][3];
static uint32_t list_choices(uint32_t nv) {
    uint32_t i, j, k, n = 0;
    for (i = 0; i < nv; i++) {
        for (j = i + 1; j < nv; j++) {
            for (k = j + 1; k < nv; k++, n += 2) {
                choice[n][0] = choice[n + 1][0] = (uint8_t)i;
                choice[n][1] = choice[n + 1][2] = (uint8_t)j;
                choice[n][2] = choice[n + 1][1] = (uint8_t)k;
            }
        }
    }
    return n;
}

/* Triangles come in another order, and begin at other corners, from world to world. */
static void set_world(const uint32_t *chosen) {
    uint32_t t, i;
    for (t = 0; t < mesh.nt; t++) {
        uint32_t pick = chosen[(t + world / 3) % mesh.nt], turn = (pick + t + world) % 3;
        for (i = 0; i < 3; i++) mesh.V[3 * t + i] = choice[pick][(i + turn) % 3];
    }
}

static void begin_worlds(uint32_t nv, uint32_t nt) {
    nook_point *G = fenced(nv * sizeof *G);
    nook_index *V = fenced(3 * nt * sizeof *V), *O = fenced(3 * nt * sizeof *O),
               *at = fenced(nv * sizeof *at);
    uint32_t v;
    CHECK_EQUAL(nook_mesh_init(&mesh, G, V, O, at, nv, nt), NOOK_OK);
    mesh.nv = nv;
    mesh.nt = nt;
    marks.Mt = fenced(NOOK_MT_BYTES(nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    marks.max_nt = nt;
    marks.max_nv = nv;
    shells.shell = fenced(nt * sizeof *shells.shell);
    shells.component = fenced(nt * sizeof *shells.component);
    shells.stamp = fenced(nv * sizeof *shells.stamp);
    shells.max_shells = nt;
    /* On the curve (v, v^2, v^3) no four points lie in a plane. */
    for (v = 0; v < nv; v++) G[v] = nook_make((float)v, (float)(v * v), (float)(v * v * v));
    world = manifold = orientable_manifold = coherent_manifold = sound = 0;
}

static uint32_t multisets(uint32_t kinds, uint32_t size) {
    uint64_t n = 1, i;
    for (i = 0; i < size; i++) n = n * (kinds + i) / (i + 1);
    return (uint32_t)n;
}

static void print_worlds(uint32_t since) {
    char label[120];
    (void)snprintf(label, sizeof label,
                   "n=%u t=%u: %6u manifold, %6u of them orientable, %5u coherent; %2u sound",
                   (unsigned)mesh.nv, (unsigned)mesh.nt, (unsigned)manifold, (unsigned)orientable_manifold,
                   (unsigned)coherent_manifold, (unsigned)sound);
    print_figure(label, world, "lists", since);
}

static void try_all_worlds(uint32_t nv, uint32_t nt) {
    uint32_t choices = list_choices(nv), i, chosen[T] = {0, 0, 0, 0, 0}, since = milliseconds();
    begin_worlds(nv, nt);
    while (!test_has_failed()) {
        set_world(chosen);
        try_world();
        for (i = nt; i > 0 && chosen[i - 1] == choices - 1; i--) {
        }
        if (i == 0) break;
        chosen[i - 1]++;
        for (; i < nt; i++) chosen[i] = chosen[i - 1];
    }
    CHECK_EQUAL(world, multisets(choices, nt));
    print_worlds(since);
    drop_fences();
}

static void compare_with_known_count(uint32_t nv, uint32_t nt) {
    if (nv == 5 && nt == 5) CHECK_EQUAL(orientable_manifold, 1920);
    if (nv == 6 && nt == 4) CHECK_EQUAL(orientable_manifold, 20970);
    if (nv == 6 && nt == 5) CHECK_EQUAL(orientable_manifold, 59904);
}

static void every_world_of_up_to_five_triangles_is_linked_and_checked_as_defined(void) {
    uint32_t nv, nt, all = 0, since = milliseconds();
    count_bits();
    for (nv = 3; nv <= N; nv++) {
        for (nt = 1; nt <= T; nt++) {
            try_all_worlds(nv, nt);
            compare_with_known_count(nv, nt);
            all += world;
        }
    }
    CHECK_EQUAL(all, 1276193);
    print_figure("all worlds", all, "lists", since);
}

static const test tests[] = {TEST(every_world_of_up_to_five_triangles_is_linked_and_checked_as_defined)};

int main(void) {
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
