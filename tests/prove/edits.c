/* edits.c -- every edit of every small mesh: done exactly if it may be, and then done right.
 *
 * An oracle does to the plain list of triangles what the headers of edit say, by looking edges up in the list, without
 * any adjacency. It judges by definitions whether that may be: no edge is run twice the same way, no two triangles
 * are on the same vertices, the triangles at each vertex are one fan; and, of an operator that keeps the kind of
 * surface, Euler number, border loops, parts and vertices of no triangle are as many as before. The operator must
 * say NOOK_OK exactly then. What it must have made:
 *   - V holds the list: old triangles unturned where they were, or where renamed() says; new ones anywhere behind;
 *   - O is the pairing looked up in V; C names a corner of each vertex, and none of a vertex of no triangle;
 *   - every vertex has its point, and nothing is written beyond the capacity.
 * A refusal must leave every byte as it was (a filling: every byte in use), and give a reason that the list shows.
 * What a header calls an inverse is run, and must bring the tables back.
 *
 * On
 *   - all meshes on 3 to 6 vertices, of any number of triangles: 16,336, without reduction by symmetry; and those on 7
 *     vertices that are numbered by valence, 7,312 (so each at least once, up to names). Some of them also without room,
 *     or with a limit to valence;
 *   - all triangulations of the sphere with up to 12 vertices, reached by flips; those with up to 8 also less two
 *     triangles, with up to 9 less one, or less those of a vertex; of 12, one vertex of each is split;
 *   - all tori with up to 9 vertices, reached by vertex splits and flips, and the same less something;
 *   - and a million edits one after the other, looked at as closely every 64th time.
 * All 1,276,193 lists of up to five triangles on up to 6 vertices, of any kind, are split into fans.
 * That nothing is left out is held against known numbers: of lists, from another program and from worlds.c; of
 * triangulations, A000109 of OEIS, and Sulanke and Lutz 2009. */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "nook.h"
#include "prove.h"

enum { MOST_V = 256, MOST_T = 340 };

static nook_mesh mesh;
static uint32_t room_v, room_t; /* of its arrays; max_nv and max_nt may say less */
static nook_mesh kept;          /* its tables as they were */
static NOOK_MESH_ARRAYS(MOST_V, MOST_T) kept_arrays;
static nook_marks marks;
static nook_report report;

/* ---- lists ----------------------------------------------------------------------------------------- */

typedef struct list {
    uint8_t v[3 * MOST_T];
    uint32_t nt, nv;
} list;

static uint32_t after(uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
static uint32_t before(uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }
static uint32_t from(const list *l, uint32_t c) { return l->v[after(c)]; }
static uint32_t to(const list *l, uint32_t c) { return l->v[before(c)]; }

static void add(list *l, uint32_t a, uint32_t b, uint32_t c) {
    uint8_t *v = l->v + 3 * l->nt++;
    v[0] = (uint8_t)a;
    v[1] = (uint8_t)b;
    v[2] = (uint8_t)c;
}

static void copy_list(list *l, const list *m) {
    memcpy(l->v, m->v, 3 * m->nt);
    l->nt = m->nt;
    l->nv = m->nv;
}

/* The corner that faces the edge from a to b, or NOOK_NONE. */
static uint32_t facing(const list *l, uint32_t a, uint32_t b) {
    const uint8_t *v = l->v;
    uint32_t c;
    for (c = 0; c < 3 * l->nt; c += 3, v += 3) {
        if (v[0] == a && v[1] == b) return c + 2;
        if (v[1] == a && v[2] == b) return c;
        if (v[2] == a && v[0] == b) return c + 1;
    }
    return NOOK_NONE;
}

/* Another way to look up: 1 + the corner that faces the edge from a to b. All is zero between uses. */
static uint16_t run[MOST_V][MOST_V];

/* Whether no edge is run twice the same way, nor from a vertex to itself. */
static bool lay(const list *l) {
    uint32_t c;
    bool good = true;
    for (c = 0; c < 3 * l->nt; c++) {
        uint16_t *at = &run[from(l, c)][to(l, c)];
        good = good && *at == 0 && from(l, c) != to(l, c);
        *at = (uint16_t)(c + 1);
    }
    return good;
}

static void lift(const list *l) {
    uint32_t c;
    for (c = 0; c < 3 * l->nt; c++) run[from(l, c)][to(l, c)] = 0;
}

/* While l is laid. */
static uint32_t partner(const list *l, uint32_t c) {
    uint32_t o = run[to(l, c)][from(l, c)];
    return o == 0 ? c : o - 1;
}

/* ---- what a list is: of the one that was judged last ------------------------------------------------- */

static uint16_t across[3 * MOST_T];               /* the other corner at an edge, or the corner itself */
static uint8_t corners_at[MOST_V], ahead[MOST_V]; /* of a vertex: corners; next on its border loop */
static bool is_open[MOST_V];                      /* whether it is at the border */
static uint16_t a_corner[MOST_V];

/* How many corners are in the fan of corner c; the walk ends though others may have broken the list. */
static uint32_t fan_length(uint32_t c, uint32_t most) {
    uint32_t x = c, n = 1, e;
    for (e = after(x); across[e] != e; e = after(x)) {
        x = after(across[e]);
        if (x == c || n > most) return n;
        n++;
    }
    for (e = before(c); across[e] != e && n <= most; e = before(x), n++) x = before(across[e]);
    return n;
}

static bool fans_are_single(const list *l) {
    uint32_t c, v;
    memset(corners_at, 0, l->nv);
    for (c = 0; c < 3 * l->nt; c++) {
        corners_at[l->v[c]]++;
        a_corner[l->v[c]] = (uint16_t)c;
    }
    for (v = 0; v < l->nv; v++) {
        if (corners_at[v] != 0 && fan_length(a_corner[v], corners_at[v]) != corners_at[v]) return false;
    }
    return true;
}

/* Whether a list is a coherent manifold without duplicates. */
static bool is_whole(const list *l) {
    bool good = lay(l);
    uint32_t c;
    for (c = 0; c < 3 * l->nt && good; c++) {
        across[c] = (uint16_t)partner(l, c);
        good = across[c] == c || l->v[across[c]] != l->v[c];
    }
    lift(l);
    return good && fans_are_single(l);
}

typedef struct numbers {
    uint32_t used, edges, loops, parts;
    int32_t euler;
} numbers;

static uint32_t root_of(const uint8_t *root, uint32_t v) {
    while (root[v] != v) v = root[v];
    return v;
}

static uint8_t root[MOST_V];
static uint32_t count_parts(const list *l) {
    uint32_t i, v, parts = 0;
    for (v = 0; v < l->nv; v++) root[v] = (uint8_t)v;
    for (i = 0; i < 3 * l->nt; i++) root[root_of(root, l->v[i])] = (uint8_t)root_of(root, l->v[i - i % 3]);
    for (v = 0; v < l->nv; v++) parts += corners_at[v] != 0 && root[v] == v;
    return parts;
}

static uint32_t count_loops(uint32_t nv) {
    static bool new[MOST_V];
    uint32_t v, w, loops = 0;
    memcpy(new, is_open, nv);
    for (v = 0; v < nv; v++) {
        loops += new[v];
        for (w = v; new[w]; w = ahead[w]) new[w] = false;
    }
    return loops;
}

/* Of a list that is whole. */
static numbers count(const list *l) {
    numbers n = {0, 0, 0, 0, 0};
    uint32_t c, v, border = 0;
    memset(is_open, 0, l->nv);
    for (c = 0; c < 3 * l->nt; c++) {
        if (across[c] != c) continue;
        border++;
        is_open[from(l, c)] = true;
        ahead[from(l, c)] = (uint8_t)to(l, c);
    }
    for (v = 0; v < l->nv; v++) n.used += corners_at[v] != 0;
    n.edges = (3 * l->nt + border) / 2;
    n.loops = count_loops(l->nv);
    n.parts = count_parts(l);
    n.euler = (int32_t)n.used + (int32_t)l->nt - (int32_t)n.edges;
    return n;
}

static bool are_on_the_same(const uint8_t *a, const uint8_t *b) {
    uint32_t i, same = 0;
    for (i = 0; i < 9; i++) same += a[i / 3] == b[i % 3];
    return same == 3;
}

static bool has_twins(const list *l) {
    uint32_t t, u;
    for (t = 0; t < l->nt; t++) {
        for (u = 0; u < t; u++) {
            if (are_on_the_same(l->v + 3 * t, l->v + 3 * u)) return true;
        }
    }
    return false;
}

static bool repeats_a_vertex(const list *l) {
    uint32_t c;
    for (c = 0; c < 3 * l->nt && l->v[c] != from(l, c); c++) {
    }
    return c < 3 * l->nt;
}

/* Edges, whoever runs them and how. */
static uint32_t count_edges(const list *l) {
    uint32_t c, edges = 0;
    lay(l);
    for (c = 0; c < 3 * l->nt; c++) {
        uint32_t o = run[to(l, c)][from(l, c)];
        edges += run[from(l, c)][to(l, c)] == c + 1 && (o == 0 || o > c);
    }
    lift(l);
    return edges;
}

/* ---- the mesh as it was, and as it should be ---------------------------------------------------------- */

static list was;
static numbers was_numbers;
static bool was_open[MOST_V];
static uint32_t meshes; /* so many have been taken */

/* Old triangles stand where they were, with new vertices in them; new triangles and vertices behind. */
static list want, left; /* left: without what is dropped */
static bool dropped[MOST_T], gone[MOST_V];
static uint32_t drops, made; /* triangles and vertices */
static nook_point point[MOST_V];
static const nook_point at = {1.5f, -2.25f, 77.0f};

static uint32_t tip(uint32_t c) { return was.v[c]; }
static uint32_t beyond(uint32_t c) { return facing(&was, to(&was, c), from(&was, c)); }
static bool joined(uint32_t a, uint32_t b) {
    return facing(&was, a, b) != NOOK_NONE || facing(&was, b, a) != NOOK_NONE;
}
static bool has_vertex(uint32_t t, uint32_t v) {
    return tip(3 * t) == v || tip(3 * t + 1) == v || tip(3 * t + 2) == v;
}
static uint32_t corner_in(uint32_t t, uint32_t v) {
    return 3 * t + (tip(3 * t) == v ? 0u : tip(3 * t + 1) == v ? 1u : 2u);
}
static uint32_t valence(uint32_t v) {
    uint32_t t, n = 0;
    for (t = 0; t < was.nt; t++) n += has_vertex(t, v);
    return n;
}

static void begin_want(void) {
    copy_list(&want, &was);
    memset(dropped, 0, was.nt);
    memset(gone, 0, was.nv);
    memcpy(point, kept.G, was.nv * sizeof *point);
    drops = made = 0;
}

static void drop(uint32_t t) {
    drops += !dropped[t];
    dropped[t] = true;
}

static void drop_all_at(uint32_t v) {
    uint32_t t;
    for (t = 0; t < was.nt; t++) {
        if (has_vertex(t, v)) drop(t);
    }
}

static uint32_t new_vertex(nook_point p) {
    point[was.nv + made] = p;
    return was.nv + made++;
}

static void squeeze(void) {
    uint32_t t;
    left.nt = 0;
    left.nv = was.nv + made;
    for (t = 0; t < want.nt; t++) {
        if (t < was.nt && dropped[t]) continue;
        memcpy(left.v + 3 * left.nt++, want.v + 3 * t, 3);
    }
}

static bool becomes_whole(numbers *n) {
    squeeze();
    if (!is_whole(&left)) return false;
    *n = count(&left);
    return true;
}

/* Whether it is whole and of the same kind: vertices come and go as said, none is left alone. */
static bool keeps_its_kind(void) {
    numbers n;
    uint32_t v, used = was_numbers.used + made;
    for (v = 0; v < was.nv; v++) used -= gone[v] && valence(v) != 0;
    return becomes_whole(&n) && n.euler == was_numbers.euler && n.loops == was_numbers.loops &&
           n.parts == was_numbers.parts && n.used == used;
}

/* Whether it is whole, and no two edges have become one but those that are meant. */
static bool is_whole_with_edges(uint32_t edges) {
    numbers n;
    return becomes_whole(&n) && n.edges == edges;
}

/* ---- what the operators do to the list ---------------------------------------------------------------- */

static bool foresee_flip(uint32_t c) {
    uint32_t o = beyond(c), a = tip(c), b = from(&was, c), e = to(&was, c);
    if (o == NOOK_NONE) return false;
    drop(c / 3);
    drop(o / 3);
    add(&want, a, b, tip(o));
    add(&want, tip(o), e, a);
    return keeps_its_kind();
}

static bool foresee_split_triangle(uint32_t t) {
    uint32_t v = new_vertex(at), a = tip(3 * t), b = tip(3 * t + 1), c = tip(3 * t + 2);
    want.v[3 * t] = (uint8_t)v;
    add(&want, v, c, a);
    add(&want, v, a, b);
    return keeps_its_kind();
}

static bool foresee_split_edge(uint32_t c) {
    uint32_t v = new_vertex(at), o = beyond(c), b = from(&was, c), e = to(&was, c);
    want.v[before(c)] = (uint8_t)v;
    add(&want, tip(c), v, e);
    if (o != NOOK_NONE) {
        drop(o / 3);
        add(&want, tip(o), v, b);
        add(&want, tip(o), e, v);
    }
    return keeps_its_kind();
}

/* The next corner about the vertex of x, or NOOK_NONE at a border. */
static uint32_t turn(uint32_t x, bool clockwise) {
    uint32_t v = tip(x), c;
    if (clockwise) {
        c = facing(&was, tip(after(x)), v);
        return c == NOOK_NONE ? c : before(c);
    }
    c = facing(&was, v, tip(before(x)));
    return c == NOOK_NONE ? c : after(c);
}

/* The corners from that of c on, counter-clockwise to that of d; how many, 0 if it cannot be. */
static uint32_t find_sector(uint32_t c, uint32_t d, uint16_t *corner) {
    uint32_t last = d == NOOK_NONE ? d : before(d), x = c == NOOK_NONE ? last : after(c), n = 0, first, y;
    if (x == NOOK_NONE || ((c == NOOK_NONE || d == NOOK_NONE) && !was_open[tip(x)])) return 0;
    while (c == NOOK_NONE && (y = turn(x, true)) != NOOK_NONE) x = y;
    for (first = x; x != NOOK_NONE; x = turn(x, false)) {
        if (n > 0 && x == first) return 0;
        corner[n++] = (uint16_t)x;
        if (x == last) return n;
    }
    return d == NOOK_NONE ? n : 0;
}

static bool foresee_split_vertex(uint32_t c, uint32_t d) {
    static uint16_t corner[MOST_T];
    uint32_t n = find_sector(c, d, corner), v, w;
    if (n == 0) return false;
    v = tip(corner[0]);
    w = new_vertex(at);
    while (n-- > 0) want.v[corner[n]] = (uint8_t)w;
    if (c != NOOK_NONE) add(&want, to(&was, c), w, v);
    if (d != NOOK_NONE) add(&want, w, from(&was, d), v);
    return keeps_its_kind();
}

static bool foresee_collapse(uint32_t c) {
    uint32_t b = from(&was, c), e = to(&was, c), t, x;
    for (t = 0; t < was.nt; t++) {
        if (!has_vertex(t, b)) continue;
        if (has_vertex(t, e)) drop(t);
        x = corner_in(t, b);
        want.v[x] = (uint8_t)e;
    }
    gone[b] = true;
    point[e] = at;
    return keeps_its_kind();
}

/* The vertex after v and w in the triangle that runs the edge from v to w. */
static uint32_t third(uint32_t v, uint32_t w) {
    uint32_t c = facing(&was, v, w);
    return c == NOOK_NONE ? c : tip(c);
}

static bool foresee_merge_edges(uint32_t c) {
    uint32_t v = tip(c), n = tip(after(c)), p = tip(before(c)), q, r;
    if (valence(v) != (was_open[v] ? 2 : 4)) return false;
    if (was_open[v] && facing(&was, n, v) != NOOK_NONE) return false;
    q = third(v, p);
    drop_all_at(v);
    gone[v] = true;
    add(&want, n, p, q);
    if (!was_open[v]) {
        r = third(v, q);
        add(&want, n, q, r);
    }
    return keeps_its_kind();
}

static bool foresee_remove_vertex(uint32_t v) {
    uint32_t t, a, b, c;
    gone[v] = true;
    if (valence(v) == 0) return keeps_its_kind();
    if (was_open[v] || valence(v) != 3) return false;
    for (t = 0; !has_vertex(t, v); t++) {
    }
    a = tip(after(corner_in(t, v)));
    b = third(v, a);
    c = third(v, b);
    drop_all_at(v);
    add(&want, a, b, c);
    return keeps_its_kind();
}

static bool foresee_make_triangle(uint32_t a, uint32_t b, uint32_t c) {
    numbers n;
    add(&want, a, b, c);
    return becomes_whole(&n);
}

static bool foresee_remove_triangle(uint32_t t) {
    numbers n;
    drop(t);
    return becomes_whole(&n);
}

static bool foresee_stitch(uint32_t c, uint32_t d) {
    uint32_t b = from(&was, c), e = to(&was, c), e2 = from(&was, d), b2 = to(&was, d), i;
    if (c == d || beyond(c) != NOOK_NONE || beyond(d) != NOOK_NONE) return false;
    for (i = 0; i < 3 * was.nt; i++) {
        if (tip(i) == b2) want.v[i] = (uint8_t)b;
        if (tip(i) == e2) want.v[i] = (uint8_t)e;
    }
    gone[b2] = b2 != b;
    gone[e2] = e2 != e;
    return is_whole_with_edges(was_numbers.edges - 1);
}

/* Corner x and those on from it get a copy of their vertex. */
static void divide(uint32_t x, bool clockwise) {
    uint32_t w = new_vertex(point[tip(x)]);
    for (; x != NOOK_NONE; x = turn(x, clockwise)) want.v[x] = (uint8_t)w;
}

static bool foresee_cut(uint32_t c) {
    uint32_t o = beyond(c), b = from(&was, c), e = to(&was, c);
    if (o == NOOK_NONE || (!was_open[b] && !was_open[e])) return false;
    if (was_open[b]) divide(before(o), true);
    if (was_open[e]) divide(after(o), false);
    return is_whole_with_edges(was_numbers.edges + 1);
}

/* ---- fillings ------------------------------------------------------------------------------------------ */

static uint8_t loop[MOST_V]; /* the vertices of a border loop, from that where the edge of c begins */
static uint32_t loop_length;

static uint32_t next_on_loop(uint32_t v) {
    uint32_t c;
    for (c = 0; from(&was, c) != v || beyond(c) != NOOK_NONE; c++) {
    }
    return to(&was, c);
}

static bool find_loop(uint32_t c) {
    uint32_t v = from(&was, c);
    loop_length = 0;
    if (beyond(c) != NOOK_NONE) return false;
    do {
        loop[loop_length++] = (uint8_t)v;
        v = next_on_loop(v);
    } while (v != loop[0]);
    return true;
}

static bool foresee_fan(uint32_t c) {
    uint32_t i;
    if (!find_loop(c)) return false;
    for (i = 1; i + 1 < loop_length; i++) add(&want, loop[0], loop[i + 1], loop[i]);
    return is_whole_with_edges(was_numbers.edges + loop_length - 3);
}

static bool foresee_centroid(uint32_t c) {
    uint32_t i, w;
    double sum[3] = {0, 0, 0};
    if (!find_loop(c)) return false;
    for (i = 0; i < loop_length; i++) {
        sum[0] += (double)point[loop[i]].x;
        sum[1] += (double)point[loop[i]].y;
        sum[2] += (double)point[loop[i]].z;
    }
    w = new_vertex(nook_make((float)(sum[0] / loop_length), (float)(sum[1] / loop_length),
                             (float)(sum[2] / loop_length)));
    for (i = 0; i < loop_length; i++) add(&want, w, loop[(i + 1) % loop_length], loop[i]);
    return is_whole_with_edges(was_numbers.edges + loop_length);
}

/* Whether the loop can be filled by triangles of its vertices: whether its part from entry i to k can, for all i and k. */
static bool can_be_filled(void) {
    static bool can[MOST_V][MOST_V];
    uint32_t i, j, k, size;
    lay(&was);
    for (i = 0; i + 1 < loop_length; i++) can[i][i + 1] = true;
    for (size = 2; size < loop_length; size++) {
        for (i = 0; (k = i + size) < loop_length; i++) {
            can[i][k] = false;
            if (size + 1 < loop_length && (run[loop[i]][loop[k]] != 0 || run[loop[k]][loop[i]] != 0))
                continue;
            for (j = i + 1; j < k; j++) can[i][k] = can[i][k] || (can[i][j] && can[j][k]);
        }
    }
    lift(&was);
    if (loop_length > 3) return can[0][loop_length - 1];
    add(&want, loop[0], loop[2], loop[1]);
    squeeze();
    want.nt--;
    return !has_twins(&left);
}

static bool foresee_ears(uint32_t c) { return find_loop(c) && can_be_filled(); }

static uint32_t stuck; /* loops of five edges and more that ears did not fill, though it can be done */

/* What ears have made: of the loop's vertices, as many as must be, whole. */
static void take_ears(void) {
    uint32_t c, i;
    for (c = 3 * was.nt; c < 3 * mesh.nt; c++) {
        for (i = 0; i < loop_length && loop[i] != mesh.V[c]; i++) {
        }
        if (!CHECK(i < loop_length)) return;
    }
    CHECK_EQUAL(mesh.nt, was.nt + loop_length - 2);
    for (c = 3 * was.nt; c < 3 * mesh.nt; c += 3) add(&want, mesh.V[c], mesh.V[c + 1], mesh.V[c + 2]);
    CHECK(is_whole_with_edges(was_numbers.edges + loop_length - 3));
}

/* ---- reverse ------------------------------------------------------------------------------------------- */

static nook_index component[MOST_T];
enum { CHOSEN = 7 };

/* A triangle alone, or with all that it hangs together with. */
static void choose(uint32_t t, bool alone) {
    uint32_t u, change = 1;
    for (u = 0; u < was.nt; u++) component[u] = u == t ? CHOSEN : CHOSEN + 1;
    while (!alone && change != 0) {
        for (change = 0, u = 0; u < was.nt; u++) {
            uint32_t c = 3 * u, touches = 0;
            if (component[u] == CHOSEN) continue;
            for (; c < 3 * u + 3; c++) {
                touches += beyond(c) != NOOK_NONE && component[beyond(c) / 3] == CHOSEN;
            }
            if (touches != 0) component[u] = CHOSEN, change = 1;
        }
    }
}

static bool foresee_reverse(uint32_t t, bool alone) {
    uint32_t c;
    bool torn = false;
    if (t != NOOK_NONE) choose(t, alone);
    for (c = 0; c < 3 * was.nt; c++) {
        if (t != NOOK_NONE && component[c / 3] != CHOSEN) continue;
        torn = torn || (t != NOOK_NONE && beyond(c) != NOOK_NONE && component[beyond(c) / 3] != CHOSEN);
        want.v[c] = was.v[c % 3 == 0 ? c : c % 3 == 1 ? c + 1 : c - 1];
    }
    return !torn;
}

static nook_status reverse(uint32_t t) {
    nook_reverse state;
    uint32_t units = 2 * mesh.nt;
    nook_status status = nook_reverse_begin(&state, &mesh, t == NOOK_NONE ? NULL : component, CHOSEN, NULL);
    return status == NOOK_OK ? nook_reverse_step(&state, &units) : status;
}

/* ---- operators by number ------------------------------------------------------------------------------- */

enum op {
    FLIP,
    SPLIT_TRIANGLE,
    SPLIT_EDGE,
    SPLIT_VERTEX,
    COLLAPSE,
    MERGE_EDGES,
    REMOVE_VERTEX,
    MAKE_VERTEX,
    MAKE_TRIANGLE,
    REMOVE_TRIANGLE,
    STITCH,
    CUT,
    FAN,
    CENTROID,
    EARS,
    REVERSE,
    OPS
};
static const char *const op_name[] = {"flip",          "split_triangle",  "split_edge",    "split_vertex",
                                      "collapse",      "merge_edges",     "remove_vertex", "make_vertex",
                                      "make_triangle", "remove_triangle", "stitch",        "cut",
                                      "fill: fan",     "fill: centroid",  "fill: ears",    "reverse"};

static uint32_t said[OPS][NOOK_STATUS_COUNT]; /* how often */
static uint32_t calls;

typedef struct hearing {
    nook_kind kind;
    uint32_t from, to;
} hearing;
static hearing heard[8], copied[8];
static uint32_t hearings, copies;

static void hear(void *user, nook_kind kind, uint32_t old, uint32_t now_called) {
    hearing h;
    (void)user;
    h.kind = kind;
    h.from = old;
    h.to = now_called;
    heard[hearings++ % 8] = h;
}

static void hear_copy(void *user, uint32_t old, uint32_t copy) {
    hearing h = {NOOK_AT_VERTEX, 0, 0};
    (void)user;
    h.from = old;
    h.to = copy;
    copied[copies++ % 8] = h;
}

static nook_edit listening = {.renamed = hear, .copied = hear_copy}; /* max_valence: 0, or a limit to try */

static bool foresee(enum op op, uint32_t x, uint32_t y, uint32_t z) {
    switch (op) {
    case FLIP: return foresee_flip(x);
    case SPLIT_TRIANGLE: return foresee_split_triangle(x);
    case SPLIT_EDGE: return foresee_split_edge(x);
    case SPLIT_VERTEX: return foresee_split_vertex(x, y);
    case COLLAPSE: return foresee_collapse(x);
    case MERGE_EDGES: return foresee_merge_edges(x);
    case REMOVE_VERTEX: return foresee_remove_vertex(x);
    case MAKE_VERTEX: return new_vertex(at) == was.nv;
    case MAKE_TRIANGLE: return foresee_make_triangle(x, y, z);
    case REMOVE_TRIANGLE: return foresee_remove_triangle(x);
    case STITCH: return foresee_stitch(x, y);
    case CUT: return foresee_cut(x);
    case FAN: return foresee_fan(x);
    case CENTROID: return foresee_centroid(x);
    case EARS: return foresee_ears(x);
    default: return foresee_reverse(x, y != 0);
    }
}

/* In slices, against the bounds of the header. */
static nook_status fill(uint32_t c, nook_fill_way way, const nook_edit *edit) {
    nook_view view = nook_view_of(&mesh);
    uint32_t l = nook_border_length(&view, c), cut = 1 + calls % 50, spent = 0, units,
             bound = 10 * l + (way == NOOK_FILL_EARS ? l * (l - 1) + l * l * l / 2 : 0) +
                     (edit != NULL ? 9 * l * l : 0);
    nook_fill state;
    nook_status status = nook_fill_begin(&state, &mesh, c, way, edit);
    while (status == NOOK_OK || status == NOOK_MORE) {
        units = cut;
        status = nook_fill_step(&state, &units);
        spent += cut - units;
        if (status == NOOK_OK) break;
    }
    CHECK(l == 0 || spent < bound);
    return status;
}

static nook_status apply(enum op op, uint32_t x, uint32_t y, uint32_t z) {
    const nook_edit *edit = listening.max_valence != 0 ? &listening : NULL;
    uint32_t v[3] = {x, y, z};
    hearings = copies = 0;
    calls++;
    switch (op) {
    case FLIP: return nook_flip(&mesh, x, edit);
    case SPLIT_TRIANGLE: return nook_split_triangle(&mesh, x, at, edit);
    case SPLIT_EDGE: return nook_split_edge(&mesh, x, at, edit);
    case SPLIT_VERTEX: return nook_split_vertex(&mesh, x, y, at, edit);
    case COLLAPSE: return nook_collapse(&mesh, x, at, &listening);
    case MERGE_EDGES: return nook_merge_edges(&mesh, x, &listening);
    case REMOVE_VERTEX: return nook_remove_vertex(&mesh, x, &listening);
    case MAKE_VERTEX: return nook_make_vertex(&mesh, at);
    case MAKE_TRIANGLE: return nook_make_triangle(&mesh, v, edit);
    case REMOVE_TRIANGLE: return nook_remove_triangle(&mesh, x, &listening);
    case STITCH: return nook_stitch(&mesh, x, y, &listening);
    case CUT: return nook_cut(&mesh, x, &listening);
    case FAN: return fill(x, NOOK_FILL_FAN, edit);
    case CENTROID: return fill(x, NOOK_FILL_CENTROID, edit);
    case EARS: return fill(x, NOOK_FILL_EARS, edit);
    default: return reverse(x);
    }
}

static bool is_filling(enum op op) { return op == FAN || op == CENTROID || op == EARS; }

static void print_operators(void) {
    uint32_t op, s;
    for (op = 0; op < OPS; op++) {
        (void)printf("  %-15s %9u done", op_name[op], (unsigned)said[op][NOOK_OK]);
        for (s = 1; s < NOOK_STATUS_COUNT; s++) {
            if (said[op][s] == 0) continue;
            (void)printf(", %u %s", (unsigned)said[op][s], nook_status_name((nook_status)s));
        }
        (void)printf("\n");
    }
    (void)printf("  ears leave %u loops that can be filled\n", (unsigned)stuck);
    memset(said, 0, sizeof said);
    stuck = 0;
}

/* ---- whether the list shows the reason of a refusal ------------------------------------------------------ */

static bool has_common_neighbour(uint32_t c) {
    uint32_t b = from(&was, c), e = to(&was, c), o = beyond(c), v;
    for (v = 0; v < was.nv; v++) {
        if (v == tip(c) || (o != NOOK_NONE && v == tip(o)) || v == b || v == e) continue;
        if (joined(v, b) && joined(v, e)) return true;
    }
    return false;
}

static bool is_reason_of_collapse(uint32_t c, nook_status status) {
    bool border = beyond(c) == NOOK_NONE;
    switch (status) {
    case NOOK_DUPLICATE_EDGE: return has_common_neighbour(c);
    case NOOK_NONMANIFOLD_VERTEX: return !border && was_open[from(&was, c)] && was_open[to(&was, c)];
    case NOOK_DUPLICATE_TRIANGLE: return has_twins(&left);
    case NOOK_LAST_TRIANGLE: return border && beyond(after(c)) == NOOK_NONE && beyond(before(c)) == NOOK_NONE;
    default: return false;
    }
}

static bool is_reason_of_merge(uint32_t c, nook_status status) {
    bool open = was_open[tip(c)];
    if (status == NOOK_WRONG_VALENCE) return valence(tip(c)) != (open ? 2 : 4);
    if (status == NOOK_INTERIOR_EDGE) return open && beyond(before(c)) != NOOK_NONE;
    return (status == NOOK_DUPLICATE_EDGE || status == NOOK_DUPLICATE_TRIANGLE) &&
           is_reason_of_collapse(before(c), status);
}

static bool is_reason_of_split_vertex(uint32_t c, uint32_t d, nook_status status) {
    static uint16_t corner[MOST_T];
    bool both = c != NOOK_NONE && d != NOOK_NONE;
    switch (status) {
    case NOOK_INDEX_OUT_OF_RANGE: return c == NOOK_NONE && d == NOOK_NONE;
    case NOOK_NONMANIFOLD_VERTEX: return both && find_sector(c, d, corner) == 0;
    case NOOK_INTERIOR_VERTEX: return !both && !was_open[c != NOOK_NONE ? from(&was, c) : to(&was, d)];
    case NOOK_DUPLICATE_TRIANGLE: return both && from(&was, c) == to(&was, d) && to(&was, c) == from(&was, d);
    default: return false;
    }
}

static bool is_reason_of_make(const uint32_t *v, nook_status status) {
    uint32_t i, both = 0, same = 0, alone = 0;
    for (i = 0; i < 3; i++) {
        uint32_t a = v[i], b = v[(i + 1) % 3], c = v[(i + 2) % 3];
        both += facing(&was, a, b) != NOOK_NONE && facing(&was, b, a) != NOOK_NONE;
        same += facing(&was, a, b) != NOOK_NONE;
        alone += valence(a) != 0 && !joined(a, b) && !joined(a, c);
    }
    switch (status) {
    case NOOK_REPEATED_VERTEX: return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    case NOOK_NONMANIFOLD_EDGE: return both > 0;
    case NOOK_INCOHERENT_EDGE: return same > 0;
    case NOOK_NONMANIFOLD_VERTEX: return alone > 0;
    case NOOK_DUPLICATE_TRIANGLE: return has_twins(&left);
    default: return false;
    }
}

static bool is_reason_of_stitch(uint32_t c, uint32_t d, nook_status status) {
    switch (status) {
    case NOOK_INTERIOR_EDGE: return beyond(c) != NOOK_NONE || beyond(d) != NOOK_NONE;
    case NOOK_REPEATED_VERTEX: return c == d || repeats_a_vertex(&left);
    case NOOK_DUPLICATE_EDGE: return count_edges(&left) < was_numbers.edges - 1;
    case NOOK_DUPLICATE_TRIANGLE: return has_twins(&left);
    default: return false;
    }
}

static bool is_reason_of_filling(enum op op, nook_status status) {
    uint32_t i, diagonals = 0;
    if (status == NOOK_INTERIOR_EDGE) return loop_length == 0;
    if (status == NOOK_DUPLICATE_TRIANGLE) return loop_length == 3 && op != CENTROID && has_twins(&left);
    if (status != NOOK_DUPLICATE_EDGE || loop_length < 4) return false;
    for (i = 2; i + 1 < loop_length; i++) diagonals += joined(loop[0], loop[i]);
    return op == EARS || (op == FAN && diagonals > 0);
}

static bool is_reason_of_flip(uint32_t c, nook_status status) {
    uint32_t o = beyond(c);
    if (o == NOOK_NONE) return status == NOOK_BORDER_EDGE;
    return status == NOOK_DUPLICATE_EDGE && joined(tip(c), tip(o));
}

/* Of what was judged last: no vertex has more triangles than allowed. None had before. */
static bool keeps_limit(void) {
    uint32_t v, limit = listening.max_valence;
    for (v = 0; v < left.nv && (limit == 0 || corners_at[v] <= limit); v++) {
    }
    return v == left.nv;
}

static bool has_nothing_to_limit(enum op op) { return op == MAKE_VERTEX || op == REVERSE || op == EARS; }

static bool lacks_room(enum op op) {
    uint32_t nt = want.nt - drops;
    if (op == EARS && loop_length > 2) nt = was.nt + loop_length - 2;
    return was.nv + made > mesh.max_nv || nt > mesh.max_nt;
}

static bool is_reason(enum op op, nook_status status, uint32_t x, uint32_t y, uint32_t z) {
    uint32_t v[3] = {x, y, z};
    if (status == NOOK_NO_CAPACITY) return lacks_room(op);
    switch (op) {
    case FLIP: return is_reason_of_flip(x, status);
    case SPLIT_VERTEX: return is_reason_of_split_vertex(x, y, status);
    case COLLAPSE: return is_reason_of_collapse(x, status);
    case MERGE_EDGES: return is_reason_of_merge(x, status);
    case REMOVE_VERTEX:
        return status == NOOK_WRONG_VALENCE ? valence(x) != 3 || was_open[x]
                                            : status == NOOK_DUPLICATE_TRIANGLE && has_twins(&left);
    case MAKE_TRIANGLE: return is_reason_of_make(v, status);
    case REMOVE_TRIANGLE: return status == NOOK_NONMANIFOLD_VERTEX;
    case STITCH: return is_reason_of_stitch(x, y, status);
    case CUT: return status == (beyond(x) == NOOK_NONE ? NOOK_BORDER_EDGE : NOOK_DUPLICATE_EDGE);
    case FAN:
    case CENTROID:
    case EARS: return is_reason_of_filling(op, status);
    case REVERSE: return status == NOOK_INCOHERENT_EDGE;
    default: return false; /* splits of triangles and edges are never refused */
    }
}

/* ---- the mesh as it is -------------------------------------------------------------------------------------- */

static list now;

static void copy_tables(nook_mesh *to_mesh, const nook_mesh *from_mesh) {
    memcpy(to_mesh->G, from_mesh->G, room_v * sizeof *mesh.G);
    memcpy(to_mesh->V, from_mesh->V, 3 * room_t * sizeof *mesh.V);
    memcpy(to_mesh->O, from_mesh->O, 3 * room_t * sizeof *mesh.O);
    memcpy(to_mesh->C, from_mesh->C, room_v * sizeof *mesh.C);
    to_mesh->nv = from_mesh->nv;
    to_mesh->nt = from_mesh->nt;
}

/* From so many vertices and triangles on. */
static bool rest_is_as_kept(uint32_t v, uint32_t t) {
    uint32_t c = 3 * t;
    return memcmp(mesh.G + v, kept.G + v, (room_v - v) * sizeof *mesh.G) == 0 &&
           memcmp(mesh.V + c, kept.V + c, (3 * room_t - c) * sizeof *mesh.V) == 0 &&
           memcmp(mesh.O + c, kept.O + c, (3 * room_t - c) * sizeof *mesh.O) == 0 &&
           memcmp(mesh.C + v, kept.C + v, (room_v - v) * sizeof *mesh.C) == 0;
}

static bool V_and_O_are_as_kept(void) {
    return mesh.nv == kept.nv && mesh.nt == kept.nt &&
           memcmp(mesh.V, kept.V, 3 * kept.nt * sizeof *mesh.V) == 0 &&
           memcmp(mesh.O, kept.O, 3 * kept.nt * sizeof *mesh.O) == 0;
}

static bool C_and_G_are_as_kept(void) {
    return memcmp(mesh.C, kept.C, room_v * sizeof *mesh.C) == 0 &&
           memcmp(mesh.G, kept.G, room_v * sizeof *mesh.G) == 0;
}

/* A filling plans in the unused ends of V and O. */
static bool is_unchanged(enum op op) {
    if (!is_filling(op)) return mesh.nv == kept.nv && mesh.nt == kept.nt && rest_is_as_kept(0, 0);
    return V_and_O_are_as_kept() && C_and_G_are_as_kept() && rest_is_as_kept(mesh.max_nv, mesh.max_nt);
}

/* The list that V holds; false if it names vertices that do not exist. */
static bool read_mesh(void) {
    uint32_t c;
    now.nt = mesh.nt;
    now.nv = mesh.nv;
    if (mesh.nt > mesh.max_nt || mesh.nv > mesh.max_nv) return false;
    for (c = 0; c < 3 * mesh.nt; c++) {
        if (mesh.V[c] >= mesh.nv) return false;
        now.v[c] = (uint8_t)mesh.V[c];
    }
    return true;
}

/* While now is laid. */
static bool O_is_right(void) {
    uint32_t c;
    for (c = 0; c < 3 * now.nt && mesh.O[c] == partner(&now, c); c++) {
    }
    return c == 3 * now.nt;
}

static bool C_is_right(void) {
    static bool used[MOST_V];
    uint32_t c, v;
    memset(used, 0, now.nv);
    for (c = 0; c < 3 * now.nt; c++) used[now.v[c]] = true;
    for (v = 0; v < now.nv; v++) {
        uint32_t stored = mesh.C[v];
        if (used[v] ? stored >= 3 * now.nt || now.v[stored] != v : stored != NOOK_STORED_NONE) return false;
    }
    return true;
}

static uint32_t name[MOST_V], place[MOST_T]; /* of old and new vertices, of old triangles, after renaming */

/* Whatever goes is filled by what is beyond the end by now. */
static bool follow_names(void) {
    uint32_t i, k;
    bool good = hearings <= 8;
    for (i = 0; i < was.nv + made; i++) name[i] = i;
    for (i = 0; i < was.nt; i++) place[i] = i;
    for (k = 0; k < hearings && good; k++) {
        const hearing *h = &heard[k];
        bool vertex = h->kind == NOOK_AT_VERTEX;
        good = h->from >= (vertex ? mesh.nv : mesh.nt) && h->to < h->from;
        for (i = 0; vertex && i < was.nv; i++) name[i] = name[i] == h->from && !gone[i] ? h->to : name[i];
        for (i = 0; !vertex && i < was.nt; i++)
            place[i] = place[i] == h->from && !dropped[i] ? h->to : place[i];
    }
    for (i = 0; i < was.nv + made; i++) good = good && (gone[i] || name[i] < mesh.nv);
    for (i = 0; i < was.nt; i++) good = good && (dropped[i] || place[i] < mesh.nt);
    return good;
}

/* Whether old triangles are where they should be, as they should be. */
static bool old_triangles_stand(void) {
    uint32_t t, i;
    for (t = 0; t < was.nt; t++) {
        for (i = 0; i < 3 && !dropped[t]; i++) {
            if (now.v[3 * place[t] + i] != name[want.v[3 * t + i]]) return false;
        }
    }
    return true;
}

/* While now is laid. */
static bool new_triangles_are_there(void) {
    uint32_t t, c;
    for (t = was.nt; t < want.nt; t++) {
        const uint8_t *v = want.v + 3 * t;
        c = run[name[v[0]]][name[v[1]]];
        if (c == 0 || now.v[c - 1] != name[v[2]]) return false;
    }
    return true;
}

static bool is_near(float a, float b) { return a - b <= 1e-3f && b - a <= 1e-3f; }

/* Points are exact, but for the mean. */
static bool points_are_right(enum op op) {
    uint32_t v;
    for (v = 0; v < was.nv + made; v++) {
        const nook_point *p = &point[v], *q = &mesh.G[name[v]];
        if (gone[v] || memcmp(p, q, sizeof *p) == 0) continue;
        if (op != CENTROID || v < was.nv || !is_near(p->x, q->x) || !is_near(p->y, q->y) ||
            !is_near(p->z, q->z))
            return false;
    }
    return true;
}

static uint32_t count_gone(void) {
    uint32_t v, n = 0;
    for (v = 0; v < was.nv; v++) n += gone[v];
    return n;
}

/* The list that is wanted is whole, and its triangles are all there: so the mesh is. */
static void compare_with_want(enum op op) {
    bool coherent;
    CHECK_EQUAL(mesh.nt, want.nt - drops);
    CHECK_EQUAL(mesh.nv, was.nv + made - count_gone());
    if (!CHECK(read_mesh()) || !CHECK(follow_names())) return;
    coherent = lay(&now);
    CHECK(coherent && O_is_right());
    CHECK(new_triangles_are_there());
    lift(&now);
    CHECK(old_triangles_stand());
    CHECK(C_is_right());
    CHECK(points_are_right(op));
    CHECK(rest_is_as_kept(mesh.max_nv, mesh.max_nt));
}

/* ---- inverses ------------------------------------------------------------------------------------------------ */

/* The triangles are those that were, in any order and turn, and the tables hold. */
static bool is_as_it_was(void) {
    bool good = mesh.nv == was.nv && mesh.nt == was.nt && read_mesh() && C_is_right();
    uint32_t t;
    if (!good) return false;
    good = lay(&now) && O_is_right();
    for (t = 0; t < was.nt; t++) {
        const uint8_t *v = was.v + 3 * t;
        uint32_t c = run[v[0]][v[1]];
        good = good && c != 0 && now.v[c - 1] == v[2];
    }
    lift(&now);
    return good;
}

/* The same triangles in the same places, though vertices have other names. */
static bool is_as_it_was_renamed(void) {
    uint32_t other[MOST_V], c, v;
    if (mesh.nv != was.nv || mesh.nt != was.nt || !read_mesh() || !C_is_right()) return false;
    for (v = 0; v < was.nv; v++) other[v] = NOOK_NONE;
    for (c = 0; c < 3 * was.nt; c++) {
        if (other[tip(c)] == NOOK_NONE) other[tip(c)] = now.v[c];
        if (other[tip(c)] != now.v[c] || mesh.O[c] != kept.O[c]) return false;
    }
    for (v = 0; v < was.nv * was.nv; v++) {
        uint32_t w = v / was.nv, u = v % was.nv;
        if (w != u && other[w] != NOOK_NONE && other[w] == other[u]) return false;
    }
    return true;
}

static void undo_flip(uint32_t c) {
    CHECK_EQUAL(nook_flip(&mesh, facing(&now, tip(c), tip(beyond(c))), NULL), NOOK_OK);
    CHECK(is_as_it_was());
}

/* By both inverses, of which one has two ways. */
static void undo_split_edge(uint32_t c) {
    uint32_t v = was.nv, to_end = facing(&now, v, to(&was, c)), from_start = facing(&now, from(&was, c), v),
             way = (c + meshes) % 3;
    if (way == 0) {
        CHECK_EQUAL(nook_collapse(&mesh, to_end, kept.G[to(&was, c)], NULL), NOOK_OK);
        CHECK(V_and_O_are_as_kept() && memcmp(mesh.G, kept.G, was.nv * sizeof *mesh.G) == 0);
    } else if (way == 1) {
        CHECK_EQUAL(nook_merge_edges(&mesh, after(to_end), NULL), NOOK_OK);
        CHECK(V_and_O_are_as_kept());
    } else if (beyond(c) != NOOK_NONE) {
        from_start = facing(&now, v, from(&was, c));
        CHECK_EQUAL(nook_merge_edges(&mesh, after(from_start), NULL), NOOK_OK);
        CHECK(is_as_it_was());
    } else {
        CHECK_EQUAL(nook_merge_edges(&mesh, before(from_start), NULL), NOOK_INTERIOR_EDGE);
    }
}

static void undo_split_vertex(void) {
    CHECK_EQUAL(nook_collapse(&mesh, 3 * was.nt, at, NULL), NOOK_OK);
    CHECK(V_and_O_are_as_kept());
}

static void undo_remove_triangle(uint32_t t) {
    uint32_t v[3];
    v[0] = tip(3 * t);
    v[1] = tip(3 * t + 1);
    v[2] = tip(3 * t + 2);
    CHECK_EQUAL(nook_make_triangle(&mesh, v, NULL), NOOK_OK);
    CHECK(is_as_it_was());
}

/* The header says in which order the copies are made. */
static void undo_cut(uint32_t c) {
    uint32_t b = from(&was, c), e = to(&was, c), n = 0;
    if (was_open[b]) CHECK(copied[n].from == b && copied[n].to == was.nv + n), n++;
    if (was_open[e]) CHECK(copied[n].from == e && copied[n].to == was.nv + n), n++;
    CHECK_EQUAL(copies, n);
    CHECK_EQUAL(nook_stitch(&mesh, c, kept.O[c], NULL), NOOK_OK);
    CHECK(V_and_O_are_as_kept());
}

static void undo(enum op op, uint32_t x, uint32_t y) {
    switch (op) {
    case FLIP: undo_flip(x); break;
    case SPLIT_TRIANGLE:
    case MAKE_VERTEX:
        CHECK_EQUAL(nook_remove_vertex(&mesh, was.nv, NULL), NOOK_OK);
        CHECK(V_and_O_are_as_kept());
        break;
    case SPLIT_EDGE: undo_split_edge(x); break;
    case SPLIT_VERTEX: undo_split_vertex(); break;
    case MAKE_TRIANGLE:
        CHECK_EQUAL(nook_remove_triangle(&mesh, was.nt, NULL), NOOK_OK);
        CHECK(V_and_O_are_as_kept());
        break;
    case REMOVE_TRIANGLE: undo_remove_triangle(x); break;
    case STITCH:
        CHECK_EQUAL(nook_cut(&mesh, x, NULL), NOOK_OK);
        CHECK(mesh.O[x] == x && mesh.O[y] == y && is_as_it_was_renamed());
        break;
    case CUT: undo_cut(x); break;
    case REVERSE:
        CHECK_EQUAL(reverse(x), NOOK_OK);
        CHECK(V_and_O_are_as_kept() && C_and_G_are_as_kept());
        break;
    default: break;
    }
}

/* ---- one try --------------------------------------------------------------------------------------------------- */

static void say_list(const list *l) {
    uint32_t c;
    for (c = 0; c < 3 * l->nt; c++) {
        print_text(c % 3 == 0 ? " " : "-");
        print_number(l->v[c]);
    }
    print_text("\n");
}

static void say_try(enum op op, nook_status status, uint32_t x, uint32_t y, uint32_t z) {
    (void)printf("%s of %u %u %u says %s; %u vertices, room for %u and %u triangles;", op_name[op],
                 (unsigned)x, (unsigned)y, (unsigned)z, nook_status_name(status), (unsigned)was.nv,
                 (unsigned)mesh.max_nv, (unsigned)mesh.max_nt);
    (void)fflush(stdout);
    say_list(&was);
}

static void judge_refusal(enum op op, nook_status status, bool legal, uint32_t x, uint32_t y, uint32_t z) {
    bool limited = listening.max_valence != 0;
    if (op == EARS && legal && status == NOOK_DUPLICATE_EDGE && loop_length > 4) {
        stuck++;
        legal = false;
    }
    CHECK(is_unchanged(op));
    if (limited && (!legal || op == EARS) && status == NOOK_TOO_MANY_TRIANGLES) return;
    if (legal) CHECK_EQUAL(status, NOOK_OK);
    if (!legal) CHECK(is_reason(op, status, x, y, z));
}

/* Whatever becomes of it, the mesh is as before then. */
static void attempt(enum op op, uint32_t x, uint32_t y, uint32_t z) {
    bool legal;
    nook_status status;
    if (test_has_failed()) return;
    begin_want();
    legal = foresee(op, x, y, z);
    legal = legal && !lacks_room(op) && (has_nothing_to_limit(op) || keeps_limit());
    status = apply(op, x, y, z);
    said[op][status]++;
    if (status != NOOK_OK) {
        judge_refusal(op, status, legal, x, y, z);
    } else {
        CHECK(legal);
        if (op == EARS) {
            take_ears();
            CHECK(keeps_limit());
        }
        compare_with_want(op);
        if (!test_has_failed()) undo(op, x, y);
    }
    if (test_has_failed()) say_try(op, status, x, y, z);
    if (status == NOOK_OK || is_filling(op)) copy_tables(&mesh, &kept);
}

/* ---- every try on a mesh ----------------------------------------------------------------------------------------- */

/* In general position, in a plane, or all in one place. */
static void scatter(uint32_t nv) {
    uint32_t v, flat = meshes % 8 == 3, none = meshes % 64 == 7;
    for (v = 0; v < nv; v++) {
        uint32_t i = none ? 0 : (v * (meshes % 2 == 0 ? 1u : 5u) + meshes) % 13;
        mesh.G[v] = nook_make((float)i, (float)(i * i), flat ? 0 : (float)(i * i * i % 47));
    }
}

static void take_mesh(void) {
    CHECK(read_mesh() && is_whole(&now));
    copy_list(&was, &now);
    was_numbers = count(&was);
    memcpy(was_open, is_open, sizeof was_open);
    copy_tables(&kept, &mesh);
}

static void begin_mesh(const list *l) {
    uint32_t c;
    meshes++;
    mesh.nv = l->nv;
    mesh.nt = l->nt;
    mesh.max_nv = room_v;
    mesh.max_nt = room_t;
    scatter(l->nv);
    for (c = 0; c < 3 * l->nt; c++) mesh.V[c] = nook_store(l->v[c]);
    CHECK_EQUAL(nook_link(&mesh, &marks, NULL, NULL, &report, NULL), NOOK_OK);
}

static void try_corners(void) {
    static const enum op ops[] = {FLIP, SPLIT_EDGE, COLLAPSE, MERGE_EDGES, CUT, FAN, CENTROID, EARS};
    uint32_t c, k;
    for (c = 0; c < 3 * was.nt && !test_has_failed(); c++) {
        for (k = 0; k < sizeof ops / sizeof *ops; k++) attempt(ops[k], c, 0, 0);
    }
}

static void try_triangles(void) {
    uint32_t t;
    for (t = 0; t < was.nt && !test_has_failed(); t++) {
        attempt(SPLIT_TRIANGLE, t, 0, 0);
        attempt(REMOVE_TRIANGLE, t, 0, 0);
        attempt(REVERSE, t, 1, 0);
        attempt(REVERSE, t, 0, 0);
    }
    attempt(REVERSE, NOOK_NONE, 0, 0);
}

static void try_vertices(void) {
    uint32_t v;
    for (v = 0; v < was.nv && !test_has_failed(); v++) attempt(REMOVE_VERTEX, v, 0, 0);
}

static void try_sectors(void) {
    uint32_t c, d;
    for (c = 0; c <= 3 * was.nt && !test_has_failed(); c++) {
        for (d = 0; d <= 3 * was.nt; d++)
            attempt(SPLIT_VERTEX, c == 3 * was.nt ? NOOK_NONE : c, d == 3 * was.nt ? NOOK_NONE : d, 0);
    }
}

static void try_seams(void) {
    uint32_t c, d;
    for (c = 0; c < 3 * was.nt && !test_has_failed(); c++) {
        for (d = 0; d < 3 * was.nt; d++) attempt(STITCH, c, d, 0);
    }
}

/* The first vertex of a triangle is its smallest. */
static void try_new_triangles(void) {
    uint32_t a, b, c;
    for (a = 0; a < was.nv && !test_has_failed(); a++) {
        for (b = a; b < was.nv; b++) {
            for (c = a; c < was.nv; c++) attempt(MAKE_TRIANGLE, a, b, c);
        }
    }
}

static void try_all_but_new(void) {
    try_corners();
    try_triangles();
    try_vertices();
    try_sectors();
    try_seams();
    attempt(MAKE_VERTEX, 0, 0, 0);
}

/* Every operator with every argument; for new triangles there is one vertex more, of no triangle. */
static void try_mesh(const list *l) {
    begin_mesh(l);
    take_mesh();
    try_all_but_new();
    CHECK_EQUAL(nook_make_vertex(&mesh, at), NOOK_OK);
    take_mesh();
    try_new_triangles();
    if (!test_has_failed()) attempt(REMOVE_VERTEX, was.nv - 1, 0, 0);
}

/* With room for so many vertices and triangles more. */
static void try_mesh_without_room(const list *l, uint32_t vertices, uint32_t triangles) {
    begin_mesh(l);
    mesh.max_nv = mesh.nv + vertices;
    mesh.max_nt = mesh.nt + triangles;
    take_mesh();
    try_all_but_new();
    try_new_triangles();
}

/* No vertex may come to have more than those with the most have, or one or two more. */
static void try_mesh_with_limit(const list *l, uint32_t more) {
    uint32_t v;
    begin_mesh(l);
    take_mesh();
    listening.max_valence = 1;
    for (v = 0; v < was.nv; v++) {
        if (valence(v) > listening.max_valence) listening.max_valence = valence(v);
    }
    listening.max_valence += more;
    try_all_but_new();
    try_new_triangles();
    listening.max_valence = 0;
}

static void begin_room(uint32_t nv, uint32_t nt) {
    nook_point *G = fenced(nv * sizeof *G);
    nook_index *V = fenced(3 * nt * sizeof *V), *O = fenced(3 * nt * sizeof *O), *C = fenced(nv * sizeof *C);
    CHECK_EQUAL(nook_mesh_init(&mesh, G, V, O, C, nv, nt), NOOK_OK);
    CHECK_EQUAL(
        nook_mesh_init(&kept, kept_arrays.G, kept_arrays.V, kept_arrays.O, kept_arrays.C, MOST_V, MOST_T),
        NOOK_OK);
    marks.Mt = fenced(NOOK_MT_BYTES(nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    marks.max_nt = room_t = nt;
    marks.max_nv = room_v = nv;
    calls = meshes = 0;
}

static void end_room(const char *label, uint32_t since) {
    char text[80];
    CHECK(fences_hold());
    drop_fences();
    (void)snprintf(text, sizeof text, "%s: %u tried", label, (unsigned)meshes);
    print_figure(text, calls, "calls", since);
}

/* ---- all meshes of up to seven vertices ---- */

enum { N = 7, MOST_SMALL = 14 };

/* The directed triangles on nv vertices: a < b < c as a b c and as a c b. */
static uint8_t choice[70][3];
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

/* Triangles come in another order, and begin at other corners, from list to list. */
static void set_list(list *l, const uint32_t *chosen, uint32_t nt, uint32_t number) {
    uint32_t t, i;
    l->nt = nt;
    for (t = 0; t < nt; t++) {
        uint32_t pick = chosen[(t + number / 3) % nt], by = pick + t + number;
        for (i = 0; i < 3; i++) l->v[3 * t + i] = choice[pick][(i + by) % 3];
    }
}

/* Triangles that are chosen in rising order, no edge run twice the same way. */
static struct {
    uint32_t nv, choices, nt, chosen[MOST_SMALL];
    bool taken[N][N], by_valence;
    uint32_t valence[N];
    uint32_t lists, whole, of_five;
} g;

static bool *taken_by(uint32_t k, uint32_t i) { return &g.taken[choice[k][i]][choice[k][(i + 1) % 3]]; }

static void set_chosen(uint32_t k, bool is) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        *taken_by(k, i) = is;
        g.valence[choice[k][i]] += is ? 1u : UINT32_MAX;
    }
}

/* Valences fall; those of vertices below v are all there by now. */
static bool valences_can_fall(uint32_t v) {
    uint32_t i, j;
    for (i = 0; i < v; i++) {
        for (j = i + 1; j < g.nv; j++) {
            if (g.valence[j] > g.valence[i]) return false;
        }
    }
    return true;
}

/* Those on seven vertices get new names, as the last vertex is another thing than the first. */
static void try_grown(void) {
    static list l;
    uint32_t c;
    l.nv = g.nv;
    set_list(&l, g.chosen, g.nt, ++g.lists);
    if ((g.by_valence && !valences_can_fall(g.nv)) || !is_whole(&l)) return;
    for (c = 0; g.by_valence && c < 3 * l.nt; c++) l.v[c] = (uint8_t)((3 * l.v[c] + g.whole) % N);
    try_mesh(&l);
    if (g.whole % 4 == 0) try_mesh_without_room(&l, g.whole / 4 % 3, g.whole / 12 % 3);
    if (g.whole % 4 == 2) try_mesh_with_limit(&l, g.whole / 4 % 3);
    g.whole++;
    g.of_five += g.nt <= 5;
}

/* Calls itself once a triangle deep. */
static void grow(uint32_t first) {
    uint32_t k;
    if (g.nt > 0) try_grown();
    for (k = first; k < g.choices && !test_has_failed(); k++) {
        if (*taken_by(k, 0) || *taken_by(k, 1) || *taken_by(k, 2)) continue;
        set_chosen(k, true);
        g.chosen[g.nt++] = k;
        if (!g.by_valence || valences_can_fall(choice[k][0])) grow(k + 1);
        g.nt--;
        set_chosen(k, false);
    }
}

static void grow_on(uint32_t nv, bool by_valence) {
    memset(&g, 0, sizeof g);
    g.nv = nv;
    g.choices = list_choices(nv);
    g.by_valence = by_valence;
    grow(0);
}

static void every_edit_of_every_mesh_of_up_to_seven_vertices_is_right_or_rightly_refused(void) {
    static const uint32_t counts[] = {2, 30, 540, 15764, 7312};
    uint32_t nv, since, of_five = 0;
    for (nv = 3; nv <= N && !test_has_failed(); nv++) {
        char label[40];
        since = milliseconds();
        begin_room(nv + 3, MOST_SMALL + 9);
        grow_on(nv, nv == N);
        CHECK_EQUAL(g.whole, counts[nv - 3]);
        if (nv < N) of_five += g.of_five;
        (void)snprintf(label, sizeof label, "%u vertices, %u meshes", (unsigned)nv, (unsigned)g.whole);
        end_room(label, since);
    }
    CHECK_EQUAL(of_five, 8091 - 85); /* worlds.c, less those with two triangles back to back */
    print_operators();
}

/* ---- fans ------------------------------------------------------------------------------------------------------------- */

enum { T = 5 };

/* All multisets of nt triangles on nv vertices; how many. */
static uint32_t for_all_lists(uint32_t nv, uint32_t nt, void (*try_list)(const list *l)) {
    uint32_t choices = list_choices(nv), i, chosen[T] = {0, 0, 0, 0, 0}, number = 0;
    static list l;
    l.nv = nv;
    while (!test_has_failed()) {
        set_list(&l, chosen, nt, number++);
        try_list(&l);
        for (i = nt; i > 0 && chosen[i - 1] == choices - 1; i--) {
        }
        if (i == 0) break;
        chosen[i - 1]++;
        for (; i < nt; i++) chosen[i] = chosen[i - 1];
    }
    return number;
}

static uint8_t fan_of[3 * T]; /* the first corner in the fan of a corner, by O */

/* Two corners are in one fan if an edge between them is joined. */
static void find_fans(void) {
    uint32_t c, pass, changes = 1;
    for (c = 0; c < 3 * mesh.nt; c++) fan_of[c] = (uint8_t)c;
    while (changes != 0) {
        for (changes = 0, c = 0; c < 6 * mesh.nt; c++) {
            uint32_t e = c / 2, o = mesh.O[e], x, y;
            if (o == e) continue;
            pass = c % 2;
            x = pass == 0 ? after(e) : before(e);
            y = pass == 0 ? before(o) : after(o);
            if (fan_of[x] <= fan_of[y]) continue;
            fan_of[x] = fan_of[y];
            changes = 1;
        }
    }
}

static uint8_t fan_vertex[3 * T];

/* The vertex that each corner should get; how many are new. */
static uint32_t name_fans(void) {
    bool seen[N];
    uint32_t c, more = 0;
    memset(seen, 0, sizeof seen);
    for (c = 0; c < 3 * mesh.nt; c++) {
        uint32_t v = mesh.V[c];
        if (fan_of[c] != c) {
            fan_vertex[c] = fan_vertex[fan_of[c]];
        } else if (seen[v]) {
            fan_vertex[c] = (uint8_t)(mesh.nv + more++);
        } else {
            fan_vertex[c] = (uint8_t)v;
            seen[v] = true;
        }
    }
    return more;
}

static nook_status split_fans(uint32_t *more) {
    nook_split_fans state;
    uint32_t bound = 13 * mesh.nt + mesh.nv / 4 + 8, units = bound;
    nook_status status = nook_split_fans_begin(&state, &mesh, &marks, &listening);
    calls++;
    hearings = copies = 0;
    if (status == NOOK_OK) status = nook_split_fans_step(&state, &units);
    CHECK(units > 0);
    *more = state.more;
    return status;
}

static void compare_fans(uint32_t more) {
    uint32_t c, v, told = 0;
    CHECK(mesh.nt == kept.nt && mesh.nv == kept.nv + more && copies == more && hearings == 0);
    CHECK(memcmp(mesh.O, kept.O, 3 * room_t * sizeof *mesh.O) == 0);
    for (c = 0; c < 3 * mesh.nt; c++) {
        CHECK(mesh.V[c] == fan_vertex[c] && read_mesh());
        CHECK(memcmp(&mesh.G[mesh.V[c]], &kept.G[kept.V[c]], sizeof *mesh.G) == 0);
        for (v = 0; v < copies && v < 8; v++)
            told += copied[v].from == kept.V[c] && copied[v].to == mesh.V[c] && fan_of[c] == c;
    }
    CHECK(told == more || more > 8);
    CHECK(C_is_right());
}

static uint32_t fans_split;

static void try_fans(const list *l) {
    uint32_t more, got;
    begin_mesh(l);
    copy_tables(&kept, &mesh);
    find_fans();
    more = name_fans();
    fans_split += more;
    if (more > 0) {
        mesh.max_nv = mesh.nv + more - 1;
        CHECK_EQUAL(split_fans(&got), NOOK_NO_CAPACITY);
        CHECK(got == more && mesh.nv == kept.nv && rest_is_as_kept(0, 0) && copies == 0);
    }
    mesh.max_nv = mesh.nv + more;
    CHECK_EQUAL(split_fans(&got), NOOK_OK);
    CHECK_EQUAL(got, more);
    compare_fans(more);
    if (test_has_failed()) say_list(l);
}

static void every_list_is_split_into_fans(void) {
    uint32_t nv, nt, all = 0, since = milliseconds();
    char label[80];
    begin_room(3 * T + N, T);
    fans_split = 0;
    for (nv = 3; nv <= 6; nv++) {
        for (nt = 1; nt <= T; nt++) all += for_all_lists(nv, nt, try_fans);
    }
    CHECK_EQUAL(all, 1276193);
    CHECK(fences_hold());
    drop_fences();
    (void)snprintf(label, sizeof label, "fans of %u lists: %u vertices made", (unsigned)all,
                   (unsigned)fans_split);
    print_figure(label, calls, "calls", since);
}

/* ---- all triangulations of a surface ------------------------------------------------------------------------------------ */

/* The triangles in the order of a search from one corner, by new names; the least over all corners and both sides. */
enum { CODE = 60, MOST_KNOWN = 8192, BUCKETS = 16384 };
typedef struct code {
    uint8_t v[CODE];
} code;
static code known[MOST_KNOWN];
static uint32_t knowns;
static uint16_t bucket[BUCKETS]; /* 1 + which */

/* The code of now from corner c, if it is less than best; for a list that was judged last. */
static void lessen(code *best, uint32_t c, bool mirrored) {
    uint8_t called[16], queue[CODE];
    bool met[CODE / 3] = {false}, less = false;
    uint32_t head = 0, tail = 0, names = 0, n = 0, i;
    code k;
    memset(called, 0xFF, sizeof called);
    queue[tail++] = (uint8_t)c;
    met[c / 3] = true;
    memset(&k, 0, sizeof k);
    while (head < tail) {
        uint32_t x = queue[head++], order[3];
        order[0] = x;
        order[1] = mirrored ? before(x) : after(x);
        order[2] = mirrored ? after(x) : before(x);
        for (i = 0; i < 3; i++, n++) {
            uint8_t *v = &called[now.v[order[i]]];
            if (*v == 0xFF) *v = (uint8_t)names++;
            k.v[n] = *v;
            if (!less && k.v[n] > best->v[n]) return;
            less = less || k.v[n] < best->v[n];
        }
        for (i = 0; i < 3; i++) {
            uint32_t o = across[order[i]];
            if (met[o / 3]) continue;
            met[o / 3] = true;
            queue[tail++] = (uint8_t)o;
        }
    }
    if (less) *best = k;
}

static code canonical(void) {
    code best;
    uint32_t c;
    memset(&best, 0xFE, sizeof best);
    CHECK(read_mesh() && is_whole(&now));
    for (c = 0; c < 6 * now.nt; c++) lessen(&best, c / 2, c % 2 == 1);
    return best;
}

/* The mesh is known from now on. */
static void know(void) {
    code k = canonical();
    uint32_t hash = 2166136261u, i;
    for (i = 0; i < CODE; i++) hash = (hash ^ k.v[i]) * 16777619u;
    for (i = (hash ^ hash >> 15) % BUCKETS; bucket[i] != 0; i = (i + 1) % BUCKETS) {
        if (memcmp(&known[bucket[i] - 1u], &k, sizeof k) == 0) return;
    }
    if (!CHECK(knowns < MOST_KNOWN)) return;
    known[knowns++] = k;
    bucket[i] = (uint16_t)knowns;
}

static void forget(void) {
    knowns = 0;
    memset(bucket, 0, sizeof bucket);
}

/* A list from a code, turned and in another order; nt is no multiple of 11. */
static void decode(list *l, const code *k, uint32_t nv, uint32_t nt, uint32_t by) {
    uint32_t t, i;
    l->nv = nv;
    l->nt = nt;
    for (t = 0; t < nt; t++) {
        for (i = 0; i < 3; i++) l->v[3 * ((t * 11 + by) % nt) + (i + by) % 3] = k->v[3 * t + i];
    }
}

static list one;
static void begin_known(uint32_t k, uint32_t nv, uint32_t nt) {
    decode(&one, &known[k], nv, nt, k);
    begin_mesh(&one);
    copy_tables(&kept, &mesh);
}

/* All that flips reach from those that are known. */
static void close_under_flips(uint32_t nv, uint32_t nt) {
    uint32_t k, c;
    for (k = 0; k < knowns && !test_has_failed(); k++) {
        begin_known(k, nv, nt);
        for (c = 0; c < 3 * nt; c++) {
            if (mesh.O[c] < c || nook_flip(&mesh, c, NULL) != NOOK_OK) continue;
            calls++;
            know();
            copy_tables(&mesh, &kept);
        }
    }
}

static void drop_from(list *l, uint32_t t) {
    l->nt--;
    memmove(l->v + 3 * t, l->v + 3 * t + 3, 3 * (l->nt - t));
}

/* The surface less a triangle, and less all triangles of a vertex. */
static void try_less_one(void) {
    static list less;
    uint32_t t, v;
    for (t = 0; t < one.nt; t++) {
        copy_list(&less, &one);
        drop_from(&less, t);
        try_mesh(&less);
    }
    for (v = 0; v < one.nv; v++) {
        copy_list(&less, &one);
        for (t = one.nt; t-- > 0;) {
            if (one.v[3 * t] == v || one.v[3 * t + 1] == v || one.v[3 * t + 2] == v) drop_from(&less, t);
        }
        if (is_whole(&less)) try_mesh(&less);
    }
}

/* Less two triangles, where that is a manifold. */
static void try_less_two(void) {
    static list less;
    uint32_t t, u;
    for (t = 0; t < one.nt; t++) {
        for (u = 0; u < t; u++) {
            copy_list(&less, &one);
            drop_from(&less, t);
            drop_from(&less, u);
            if (is_whole(&less)) try_mesh(&less);
        }
    }
}

/* The largest: less of what a closed mesh refuses anyway, and the sectors of one vertex only. */
static void try_large(const list *l) {
    uint32_t c, d;
    begin_mesh(l);
    take_mesh();
    try_vertices();
    for (c = 0; c < 3 * was.nt && !test_has_failed(); c++) {
        attempt(FLIP, c, 0, 0);
        attempt(SPLIT_EDGE, c, 0, 0);
        attempt(COLLAPSE, c, 0, 0);
        attempt(MERGE_EDGES, c, 0, 0);
        if (c % 3 == 0) attempt(SPLIT_TRIANGLE, c / 3, 0, 0);
        if (c % 3 == 0) attempt(REMOVE_TRIANGLE, c / 3, 0, 0);
        for (d = 0; d < 3 * was.nt && from(&was, c) == meshes % was.nv; d++) attempt(SPLIT_VERTEX, c, d, 0);
    }
}

static void try_all_known(uint32_t nv, uint32_t nt, uint32_t full, uint32_t less_one, uint32_t less_two) {
    uint32_t k;
    for (k = 0; k < knowns && !test_has_failed(); k++) {
        decode(&one, &known[k], nv, nt, k);
        if (nv <= full) try_mesh(&one);
        if (nv <= less_one) try_mesh_with_limit(&one, k % 3);
        if (nv > full) try_large(&one);
        if (nv <= less_one) try_less_one();
        if (nv <= less_two) try_less_two();
    }
}

static void set_tetrahedron(list *l) {
    l->nv = 4;
    l->nt = 0;
    add(l, 0, 2, 1);
    add(l, 0, 1, 3);
    add(l, 1, 2, 3);
    add(l, 2, 0, 3);
}

/* Of seven vertices, each joined to each (Moebius, Csaszar). */
static void set_torus(list *l) {
    uint32_t i;
    l->nv = 7;
    l->nt = 0;
    for (i = 0; i < 7; i++) {
        add(l, i, (i + 1) % 7, (i + 3) % 7);
        add(l, i, (i + 3) % 7, (i + 2) % 7);
    }
}

static void every_edit_of_every_sphere_of_up_to_twelve_vertices_is_right_or_rightly_refused(void) {
    static const uint32_t counts[] = {1, 1, 2, 5, 14, 50, 233, 1249, 7595};
    uint32_t nv, since;
    for (nv = 4; nv <= 12 && !test_has_failed(); nv++) {
        char label[32];
        since = milliseconds();
        begin_room(nv + 3, 3 * nv + 4);
        if (nv == 4) set_tetrahedron(&one);
        if (nv > 4) decode(&one, &known[0], nv - 1, 2 * nv - 6, 0);
        begin_mesh(&one);
        if (nv > 4) CHECK_EQUAL(nook_split_triangle(&mesh, 0, at, NULL), NOOK_OK);
        forget();
        know();
        close_under_flips(nv, 2 * nv - 4);
        CHECK_EQUAL(knowns, counts[nv - 4]);
        (void)snprintf(label, sizeof label, "%u vertices, %u spheres", (unsigned)nv, (unsigned)knowns);
        meshes = 0;
        try_all_known(nv, 2 * nv - 4, 11, 9, 8);
        end_room(label, since);
    }
    print_operators();
}

/* All that vertex splits make of those that are known, and flips of these. */
static void split_all_known(uint32_t nv, uint32_t nt) {
    static code before_that[MOST_KNOWN];
    uint32_t k, c, d, n = knowns;
    static list l;
    memcpy(before_that, known, sizeof known);
    forget();
    for (k = 0; k < n; k++) {
        decode(&l, &before_that[k], nv, nt, 0);
        begin_mesh(&l);
        copy_tables(&kept, &mesh);
        for (c = 0; c < 3 * nt; c++) {
            for (d = 0; d < 3 * nt; d++) {
                if (nook_split_vertex(&mesh, c, d, at, NULL) != NOOK_OK) continue;
                know();
                copy_tables(&mesh, &kept);
            }
        }
    }
    close_under_flips(nv + 1, nt + 2);
}

static void every_edit_of_every_torus_of_up_to_nine_vertices_is_right_or_rightly_refused(void) {
    static const uint32_t counts[] = {1, 7, 112};
    uint32_t nv, since;
    for (nv = 7; nv <= 9 && !test_has_failed(); nv++) {
        char label[32];
        since = milliseconds();
        begin_room(nv + 3, 3 * nv + 4);
        if (nv == 7) {
            set_torus(&one);
            begin_mesh(&one);
            forget();
            know();
            close_under_flips(7, 14);
        } else {
            split_all_known(nv - 1, 2 * nv - 2);
        }
        CHECK_EQUAL(knowns, counts[nv - 7]);
        (void)snprintf(label, sizeof label, "%u vertices, %u tori", (unsigned)nv, (unsigned)knowns);
        meshes = 0;
        try_all_known(nv, 2 * nv, 9, 9, 8);
        end_room(label, since);
    }
    print_operators();
}

/* ---- a million, one after the other ------------------------------------------------------------------------------------- */

/* Joins a torus to the list at its last triangle: one handle more. */
static void add_handle(list *l) {
    static list torus;
    uint32_t t, i, names[7], v[3];
    const uint8_t *gap = l->v + 3 * --l->nt;
    set_torus(&torus);
    for (i = 0; i < 7; i++) names[i] = i < 2 || i == 3 ? 0 : l->nv++;
    names[0] = gap[0];
    names[1] = gap[2];
    names[3] = gap[1];
    for (t = 1; t < torus.nt; t++) {
        for (i = 0; i < 3; i++) v[i] = names[torus.v[3 * t + i]];
        add(l, v[0], v[1], v[2]);
    }
}

/* Rows of six round a cylinder. */
static void set_cylinder(list *l, uint32_t rows) {
    uint32_t i, j;
    l->nv = 6 * rows + 6;
    l->nt = 0;
    for (j = 0; j < rows; j++) {
        for (i = 0; i < 6; i++) {
            uint32_t a = 6 * j + i, b = 6 * j + (i + 1) % 6;
            add(l, a, b, a + 6);
            add(l, b, b + 6, a + 6);
        }
    }
}

static void set_disk(list *l) {
    uint32_t i;
    l->nv = 8;
    l->nt = 0;
    for (i = 0; i < 7; i++) add(l, 7, i, (i + 1) % 7);
}

static void set_surface(list *l, uint32_t kind) {
    if (kind == 0) set_tetrahedron(l);
    if (kind == 1 || kind == 4) set_torus(l);
    if (kind == 2) set_disk(l);
    if (kind == 3) set_cylinder(l, 3);
    if (kind == 4) add_handle(l), add_handle(l);
}

static dice fortune;
static uint32_t throw(uint32_t sides) { return throw_dice(&fortune, sides); }

/* A border edge, if one is found soon. */
static uint32_t throw_border(void) {
    uint32_t i, c = throw(3 * mesh.nt);
    for (i = 0; i < 20 && mesh.O[c] != c; i++) c = throw(3 * mesh.nt);
    return c;
}

/* The last corner of a sector that begins with that of c. */
static uint32_t throw_sector(uint32_t c) {
    nook_view view = nook_view_of(&mesh);
    uint32_t x = after(c), y = x, n = throw(6);
    while (n-- > 0 && (y = nook_turn(&view, x, false)) != NOOK_NONE) x = y;
    return after(x);
}

static uint32_t throw_vertex(void) {
    uint32_t i, v = throw(mesh.nv), alone = throw(2);
    for (i = 0; i < 20 && alone != 0 && mesh.C[v] != NOOK_STORED_NONE; i++) v = throw(mesh.nv);
    return v;
}

/* Two corners of a border, or any three vertices. */
static void throw_triangle(uint32_t *a) {
    nook_view view = nook_view_of(&mesh);
    uint32_t c = mesh.nt == 0 ? NOOK_NONE : throw_border(), d = NOOK_NONE;
    a[0] = throw_vertex();
    a[1] = throw_vertex();
    a[2] = throw_vertex();
    if (c != NOOK_NONE) d = nook_border_next(&view, c, true);
    if (d == NOOK_NONE) return;
    a[0] = mesh.V[before(c)];
    a[1] = mesh.V[after(c)];
    if (throw(2) == 0) a[2] = mesh.V[before(d)];
}

static void throw_arguments(enum op op, uint32_t *a) {
    a[0] = mesh.nt == 0 ? 0 : throw(3 * mesh.nt);
    a[1] = a[2] = 0;
    if (op == SPLIT_TRIANGLE || op == REMOVE_TRIANGLE) a[0] /= 3;
    if (op == REMOVE_VERTEX) a[0] = throw_vertex();
    if (op == REVERSE) a[0] = NOOK_NONE;
    if (op == STITCH || is_filling(op)) a[0] = throw_border();
    if (op == STITCH) a[1] = throw_border();
    if (op == MAKE_TRIANGLE) throw_triangle(a);
    if (op != SPLIT_VERTEX) return;
    a[1] = throw_sector(a[0]);
    if (throw(4) == 0) a[throw(2)] = NOOK_NONE;
}

/* Up and down between few triangles and all that there is room for. */
static uint32_t aim;
static enum op throw_op(bool any) {
    enum op op = (enum op) throw(any ? OPS : REMOVE_VERTEX + 1);
    bool grows = op == SPLIT_TRIANGLE || op == SPLIT_EDGE || op == SPLIT_VERTEX || op == CENTROID;
    if (mesh.nt == 0 || mesh.nv == 0) return mesh.nv < 3 ? MAKE_VERTEX : MAKE_TRIANGLE;
    if (throw(500) == 0) aim = 4 + throw(mesh.max_nt);
    if (grows && mesh.nt > aim && throw(4) != 0) return COLLAPSE;
    if ((op == COLLAPSE || op == REMOVE_TRIANGLE) && mesh.nt < aim && throw(3) == 0) return SPLIT_VERTEX;
    return op;
}

static void look_closely(bool any, const numbers *first) {
    uint32_t a[3];
    enum op op = throw_op(any);
    bool coherent;
    take_mesh();
    coherent = lay(&now);
    CHECK(coherent && O_is_right());
    lift(&now);
    CHECK(C_is_right());
    if (!any) {
        CHECK(was_numbers.euler == first->euler && was_numbers.loops == first->loops &&
              was_numbers.parts == first->parts && was_numbers.used == was.nv);
    }
    if (test_has_failed()) return;
    throw_arguments(op, a);
    attempt(op, a[0], a[1], a[2]);
}

static uint32_t edits;

static void wander(const list *start, uint32_t room, bool any) {
    uint32_t a[3], done = 0, tries;
    numbers first;
    begin_mesh(start);
    mesh.max_nv = room * 5 / 8;
    mesh.max_nt = aim = room;
    take_mesh();
    first = was_numbers;
    for (tries = 0; done < 5000 && !test_has_failed(); tries++) {
        enum op op = throw_op(any);
        nook_status status;
        throw_arguments(op, a);
        status = apply(op, a[0], a[1], a[2]);
        said[op][status]++;
        done += status == NOOK_OK;
        CHECK(status != NOOK_BAD_OPPOSITE && tries < 200000);
        if (tries % 64 == 0) look_closely(any, &first);
    }
    look_closely(any, &first);
    edits += done;
}

static void a_million_edits_keep_meshes_whole(void) {
    static list start;
    uint32_t round, since = milliseconds();
    begin_room(150, 200);
    fortune.state = 20261127u;
    edits = 0;
    for (round = 0; round < 200 && !test_has_failed(); round++) {
        set_surface(&start, round % 5);
        wander(&start, 64 + round / 10 % 5 * 34, round / 5 % 2 == 1);
    }
    (void)printf("one after the other: %u edits done\n", (unsigned)edits);
    end_room("one after the other", since);
    print_operators();
}

static const test tests[] = {
    TEST(every_edit_of_every_mesh_of_up_to_seven_vertices_is_right_or_rightly_refused),
    TEST(every_list_is_split_into_fans),
    TEST(every_edit_of_every_sphere_of_up_to_twelve_vertices_is_right_or_rightly_refused),
    TEST(every_edit_of_every_torus_of_up_to_nine_vertices_is_right_or_rightly_refused),
    TEST(a_million_edits_keep_meshes_whole),
};

int main(void) {
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
