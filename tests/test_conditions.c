/* test_conditions.c -- what edits respect beyond topology, and what goes along with them.
 *
 * Each operator is first done without conditions, on tables that are put back. Whether it should be refused is then read
 * off the two meshes, before and after, by the definitions of the headers: normals in big integers, valences by
 * counting, attributes as a function of the place, and identities by coordinates that no two vertices share. */
#include <string.h>

#include "big.h"
#include "rooms.h"
#include "shapes.h"

enum { SMALL = NOOK_TEST_RAM < 2000000, ROOM_T = 48, ROOM_V = 36, WIDE = 3 };

/* The mesh before an edit, and what goes along with b.mesh. */
static NOOK_MESH_ARRAYS(ROOM_V, ROOM_T) kept;
static uint32_t kept_nv, kept_nt;
static union {
    float attribute[3 * ROOM_T * WIDE];
    NOOK_BVH_ARRAYS(ROOM_T) fresh;
} beside;
static uint8_t color[ROOM_T];

static void keep(void) {
    kept_nv = b.mesh.nv;
    kept_nt = b.mesh.nt;
    memcpy(kept.G, b.mesh.G, sizeof kept.G);
    memcpy(kept.V, b.mesh.V, sizeof kept.V);
    memcpy(kept.O, b.mesh.O, sizeof kept.O);
    memcpy(kept.C, b.mesh.C, sizeof kept.C);
}

static void restore(void) {
    b.mesh.nv = kept_nv;
    b.mesh.nt = kept_nt;
    memcpy(b.mesh.G, kept.G, sizeof kept.G);
    memcpy(b.mesh.V, kept.V, sizeof kept.V);
    memcpy(b.mesh.O, kept.O, sizeof kept.O);
    memcpy(b.mesh.C, kept.C, sizeof kept.C);
}

/* A filling is planned in the unused ends of V and O, so only what is in use must be as it was. */
static void is_as_kept(bool whole) {
    size_t corners = whole ? sizeof kept.V : 3 * kept_nt * sizeof *kept.V;
    CHECK(b.mesh.nv == kept_nv && b.mesh.nt == kept_nt);
    CHECK(memcmp(b.mesh.V, kept.V, corners) == 0 && memcmp(b.mesh.O, kept.O, corners) == 0);
    CHECK(memcmp(b.mesh.C, kept.C, sizeof kept.C) == 0 && memcmp(b.mesh.G, kept.G, sizeof kept.G) == 0);
}

static uint32_t hash(uint32_t sum, const void *bytes, size_t n) {
    const uint8_t *at = bytes;
    while (n-- > 0) sum = (sum ^ *at++) * 16777619u;
    return sum;
}

static uint32_t hash_of_mesh(void) {
    uint32_t sum = hash(b.mesh.nv << 16 | b.mesh.nt, b.mesh.G, b.mesh.nv * sizeof *b.mesh.G);
    sum = hash(sum, b.mesh.C, b.mesh.nv * sizeof *b.mesh.C);
    sum = hash(sum, b.mesh.V, 3 * b.mesh.nt * sizeof *b.mesh.V);
    return hash(sum, b.mesh.O, 3 * b.mesh.nt * sizeof *b.mesh.O);
}

static uint32_t hash_of_data(void) {
    uint32_t sum = hash(1, beside.attribute, 3 * b.mesh.nt * WIDE * sizeof *beside.attribute);
    return hash(sum, color, b.mesh.nt);
}

/* The triangles of b.mesh are joined, and there is as much room as the copies have. */
static void link_shape(void) {
    CHECK_EQUAL(nook_link(&b.mesh, NULL, NULL, NULL, &b.report, NULL), NOOK_OK);
    CHECK(b.mesh.nv <= ROOM_V && b.mesh.nt <= ROOM_T);
    b.mesh.max_nv = ROOM_V;
    b.mesh.max_nt = ROOM_T;
}

/* The corner that faces the edge from v to w. */
static uint32_t facing(uint32_t v, uint32_t w) {
    uint32_t c = 0;
    while (c < 3 * b.mesh.nt && (b.mesh.V[nook_next(c)] != v || b.mesh.V[nook_prev(c)] != w)) c++;
    CHECK(c < 3 * b.mesh.nt);
    return c;
}

static nook_point middle(nook_point p, nook_point q) {
    return nook_make((p.x + q.x) * 0.5f, (p.y + q.y) * 0.5f, (p.z + q.z) * 0.5f);
}

/* ---- attempts ------------------------------------------------------------------------------------------ */

enum {
    FLIP,
    SPLIT_TRIANGLE,
    SPLIT_EDGE,
    SPLIT_VERTEX,
    COLLAPSE,
    MERGE,
    REMOVE_VERTEX,
    MAKE_TRIANGLE,
    STITCH,
    FILL_FAN,
    FILL_CENTROID,
    FILL_EARS,
    CONDITIONED, /* those before can be asked to respect something */
    REMOVE_TRIANGLE = CONDITIONED,
    CUT,
    OPERATORS
};

typedef struct attempt {
    uint32_t what, c, d, v[3];
    nook_point at;
} attempt;

static nook_status carry_out(const attempt *a, const nook_edit *edit) {
    nook_mesh *m = &b.mesh;
    switch (a->what) {
    case FLIP: return nook_flip(m, a->c, edit);
    case SPLIT_TRIANGLE: return nook_split_triangle(m, nook_triangle(a->c), a->at, edit);
    case SPLIT_EDGE: return nook_split_edge(m, a->c, a->at, edit);
    case SPLIT_VERTEX: return nook_split_vertex(m, a->c, a->d, a->at, edit);
    case COLLAPSE: return nook_collapse(m, a->c, a->at, edit);
    case MERGE: return nook_merge_edges(m, a->c, edit);
    case REMOVE_VERTEX: return nook_remove_vertex(m, m->V[a->c], edit);
    case MAKE_TRIANGLE: return nook_make_triangle(m, a->v, edit);
    case STITCH: return nook_stitch(m, a->c, a->d, edit);
    case REMOVE_TRIANGLE: return nook_remove_triangle(m, nook_triangle(a->c), edit);
    case CUT: return nook_cut(m, a->c, edit);
    default: return nook_fill_hole(m, a->c, (nook_fill_way)(a->what - FILL_FAN), edit);
    }
}

static bool is_filling(uint32_t what) { return what >= FILL_FAN && what <= FILL_EARS; }

/* Whether corner c is one that the operator can be hoped to accept. */
static bool suits(uint32_t what, uint32_t c) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t n = nook_valence(&view, c);
    nook_star star;
    switch (what) {
    case CUT:
        return !nook_is_border(&view, c) && nook_star_begin(&star, &view, nook_next(c), true) == NOOK_OK &&
               star.open;
    case MERGE: return n == 4 || n == 2;
    case REMOVE_VERTEX: return n == 3;
    case MAKE_TRIANGLE:
    case STITCH:
    case FILL_FAN:
    case FILL_CENTROID:
    case FILL_EARS: return nook_is_border(&view, c);
    default: return true;
    }
}

static uint32_t throw_corner(dice *d, uint32_t what) {
    uint32_t c = throw_dice(d, 3 * b.mesh.nt), i;
    for (i = 0; i < 3 * b.mesh.nt && !suits(what, c); i++) c = c + 1 == 3 * b.mesh.nt ? 0 : c + 1;
    return c;
}

/* The corner of the border edge whose ends are nearest to those of the edge of c, in the other order. */
static uint32_t nearest_edge(uint32_t c) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t d, best = c;
    float least = 0;
    for (d = 0; d < 3 * b.mesh.nt; d++) {
        float far =
            nook_length(nook_sub(nook_point_at(&view, nook_next(c)), nook_point_at(&view, nook_prev(d)))) +
            nook_length(nook_sub(nook_point_at(&view, nook_prev(c)), nook_point_at(&view, nook_next(d))));
        if (d == c || !nook_is_border(&view, d) || (best != c && far >= least)) continue;
        best = d;
        least = far;
    }
    return best;
}

/* The other corner of a stitch, often one that is near; of a vertex split, after some turning. */
static uint32_t throw_other(dice *d, const attempt *a) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t turns, x = nook_next(a->c), y;
    if (a->what == STITCH && throw_dice(d, 3) != 0) return nearest_edge(a->c);
    if (a->what != SPLIT_VERTEX) return throw_corner(d, a->what);
    for (turns = throw_dice(d, 4); turns > 0; turns--) {
        y = nook_turn(&view, x, false);
        if (y != NOOK_NONE) x = y;
    }
    return throw_dice(d, 6) == 0 ? NOOK_NONE : nook_next(x);
}

static attempt throw_attempt(dice *d, uint32_t what) {
    nook_view view = nook_view_of(&b.mesh);
    attempt a;
    uint32_t x;
    memset(&a, 0, sizeof a);
    a.what = what;
    a.c = throw_corner(d, what);
    a.d = throw_other(d, &a);
    a.v[0] = b.mesh.V[nook_prev(a.c)];
    a.v[1] = b.mesh.V[nook_next(a.c)];
    a.v[2] = throw_dice(d, b.mesh.nv);
    x = nook_border_next(&view, a.c, true);
    if (throw_dice(d, 2) == 0 && x != NOOK_NONE) a.v[2] = b.mesh.V[nook_prev(x)];
    if (what == SPLIT_VERTEX && a.d != NOOK_NONE && throw_dice(d, 8) == 0) a.c = NOOK_NONE;
    return a;
}

/* ---- scenes -------------------------------------------------------------------------------------------- */

enum { AS_IT_IS, FAR_OFF, LAST_PLACE, FINISHES };
static uint32_t finish;

static float last_place(dice *d, float x) {
    uint32_t bits = nook_float_bits(x), throw = throw_dice(d, 3);
    return (bits & 0x7FFFFFFFu) < 2u ? x : nook_float_from(bits + throw -1u);
}

/* Far from the origin; or on a slope, up to a last place. */
static nook_point finished(dice *d, nook_point p) {
    if (finish == FAR_OFF) return nook_make(p.x + 1048576.0f, p.y + 2097152.0f, p.z - 1048576.0f);
    if (finish == AS_IT_IS) return p;
    p.z += p.x * 0.5f + p.y * 0.25f;
    p.x = last_place(d, p.x);
    p.y = last_place(d, p.y);
    p.z = last_place(d, p.z);
    return p;
}

static nook_point throw_grid_point(dice *d, uint32_t sides, bool flat) {
    float x = (float)throw_dice(d, sides), y = (float)throw_dice(d, sides);
    return nook_make(x, y, flat ? 0 : (float)throw_dice(d, 3));
}

/* Where something new might go: somewhere about the triangle of c, or anywhere. */
static nook_point throw_place(dice *d, uint32_t c, bool flat) {
    nook_point p = b.mesh.G[b.mesh.V[c]], q = b.mesh.G[b.mesh.V[nook_next(c)]],
               r = b.mesh.G[b.mesh.V[nook_prev(c)]];
    switch (throw_dice(d, 6)) {
    case 0: return middle(middle(p, q), middle(p, r));
    case 1:
    case 2: return middle(q, r);
    case 3: return r;
    case 4: return middle(middle(p, q), b.mesh.G[throw_dice(d, b.mesh.nv)]);
    default: return finished(d, throw_grid_point(d, 13, flat));
    }
}

static void throw_at(dice *d, attempt *a, bool flat) {
    a->at = throw_place(d, a->c == NOOK_NONE ? a->d : a->c, flat);
    if (finish == LAST_PLACE) a->at.x = last_place(d, a->at.x);
}

/* Some edits, so that there are vertices of all valences, and holes; for an operator, so that it has something to do. */
static void prepare(dice *d, uint32_t what, const nook_edit *edit) {
    uint32_t n = 1 + throw_dice(d, 8);
    while (n-- > 0) {
        attempt a = throw_attempt(d, n == 0 && what == STITCH ? CUT : throw_dice(d, OPERATORS));
        throw_at(d, &a, true);
        (void)carry_out(&a, edit);
        if (b.mesh.nt < 2) return;
    }
}

/* A disk whose triangles all face up, or some shape whose vertices are anywhere; with heights or all in a plane. */
static bool begin_scene(dice *d, uint32_t what) {
    static void (*const build[])(void) = {tetrahedron, octahedron, cube};
    static const nook_edit careful = {.no_turn = true};
    uint32_t kind = throw_dice(d, 6), v;
    bool disk = kind > 2, flat = throw_dice(d, 2) == 0;
    finish = AS_IT_IS;
    if (disk) {
        grid(3, kind - 1);
        for (v = 0; v < b.mesh.nv; v++) place(v, 4.0f * (float)(v % 4), 4.0f * (float)(v / 4), 0);
    } else {
        build[kind]();
    }
    link_shape();
    prepare(d, what, disk ? &careful : NULL);
    finish = throw_dice(d, FINISHES);
    for (v = 0; v < b.mesh.nv; v++) {
        nook_point p = throw_grid_point(d, 4, flat);
        if (disk) p.x = b.mesh.G[v].x, p.y = b.mesh.G[v].y;
        b.mesh.G[v] = finished(d, p);
    }
    return flat;
}

/* ---- which way it faces ---------------------------------------------------------------------------------- */

/* Whether a triangle has area and faces the way of the piece that was there. A piece without area faces every way. */
static bool faces(nook_point p, nook_point q, nook_point r, const nook_point was[4]) {
    nook_point both[8];
    both[4] = p, both[5] = q, both[6] = both[7] = r;
    memcpy(both, was, 4 * sizeof *was);
    if (big_compare_normals(both) > 0) return true;
    memcpy(both + 4, was, 4 * sizeof *was);
    if (big_compare_normals(both) != 0) return false;
    both[4] = p, both[5] = q, both[6] = both[7] = r;
    memcpy(both, both + 4, 4 * sizeof *was);
    return big_compare_normals(both) > 0;
}

static bool has_area(nook_point p, nook_point q, nook_point r) {
    const nook_point nothing[4] = {p, p, p, p};
    return faces(p, q, r, nothing);
}

/* Before the edit. */
static nook_point old(uint32_t c) { return kept.G[kept.V[c]]; }
static uint32_t old_across(uint32_t c) { return kept.O[c] == c ? NOOK_NONE : kept.O[c]; }

static void old_triangle(uint32_t t, nook_point p[4]) {
    uint32_t i;
    for (i = 0; i < 4; i++) p[i] = old(3 * t + (i == 3 ? 2 : i));
}

/* Whether old triangle t with vertices v and w in another place faces its way; or stays where it is, area or not. */
static bool moved_faces(uint32_t t, uint32_t v, nook_point to, uint32_t w, nook_point also) {
    nook_point was[4], now[3];
    uint32_t i;
    old_triangle(t, was);
    memcpy(now, was, sizeof now);
    for (i = 0; i < 3; i++) {
        if (kept.V[3 * t + i] == v) now[i] = to;
        if (kept.V[3 * t + i] == w) now[i] = also;
    }
    return memcmp(now, was, sizeof now) == 0 || faces(now[0], now[1], now[2], was);
}

/* The two new triangles face the quadrilateral, as one piece. */
static bool flip_faces(const attempt *a) {
    uint32_t c = a->c, o = kept.O[c];
    const nook_point q[4] = {old(c), old(nook_next(c)), old(o), old(nook_prev(c))};
    return faces(q[0], q[1], q[2], q) && faces(q[0], q[2], q[3], q);
}

/* Each part faces the triangle it is cut from. */
static bool split_triangle_faces(const attempt *a) {
    uint32_t t = nook_triangle(a->c), i;
    for (i = 0; i < 3; i++) {
        if (!moved_faces(t, kept.V[3 * t + i], a->at, NOOK_NONE, a->at)) return false;
    }
    return true;
}

static bool split_edge_faces(const attempt *a) {
    uint32_t n = kept.V[nook_next(a->c)], p = kept.V[nook_prev(a->c)], o = old_across(a->c), side;
    for (side = 0; side < 2; side++) {
        uint32_t x = side == 0 ? a->c : o;
        if (x == NOOK_NONE) break;
        if (!moved_faces(nook_triangle(x), n, a->at, NOOK_NONE, a->at)) return false;
        if (!moved_faces(nook_triangle(x), p, a->at, NOOK_NONE, a->at)) return false;
    }
    return true;
}

/* New triangle t faces both triangles that were at the edge of c. */
static bool wedge_faces(uint32_t t, uint32_t c) {
    nook_point was[4], p[3];
    uint32_t i, o = old_across(c);
    for (i = 0; i < 3; i++) p[i] = b.mesh.G[b.mesh.V[3 * t + i]];
    old_triangle(nook_triangle(c), was);
    if (!faces(p[0], p[1], p[2], was)) return false;
    if (o == NOOK_NONE) return true;
    old_triangle(nook_triangle(o), was);
    return faces(p[0], p[1], p[2], was);
}

/* The triangles that have the new vertex in place of the old one face their way, and so does what fills the gaps. */
static bool split_vertex_faces(const attempt *a) {
    uint32_t c, t = kept_nt;
    for (c = 0; c < 3 * kept_nt; c++) {
        if (b.mesh.V[c] == kept.V[c]) continue;
        if (!moved_faces(nook_triangle(c), kept.V[c], a->at, NOOK_NONE, a->at)) return false;
    }
    if (a->c != NOOK_NONE && !wedge_faces(t++, a->c)) return false;
    return a->d == NOOK_NONE || wedge_faces(t, a->d);
}

/* All triangles with one of two vertices face their way when both are moved; those with both are gone. */
static bool pair_faces(uint32_t v, nook_point to, uint32_t w, nook_point also, bool gone) {
    uint32_t t, i;
    for (t = 0; t < kept_nt; t++) {
        uint32_t one = 0, other = 0;
        for (i = 3 * t; i < 3 * t + 3; i++) one += kept.V[i] == v, other += kept.V[i] == w;
        if (one + other == 0 || (gone && one + other == 2)) continue;
        if (!moved_faces(t, v, to, w, also)) return false;
    }
    return true;
}

static bool collapse_faces(const attempt *a) {
    uint32_t c = a->what == MERGE ? nook_prev(a->c) : a->c;
    nook_point at = a->what == MERGE ? old(nook_prev(c)) : a->at;
    return pair_faces(kept.V[nook_next(c)], at, kept.V[nook_prev(c)], at, true);
}

/* The vertices of the second edge go to those of the first; an end that is shared stays as it is. */
static bool stitch_faces(const attempt *a) {
    uint32_t c = a->c, d = a->d, v = kept.V[nook_prev(d)], w = kept.V[nook_next(d)];
    nook_point to = old(nook_next(c)), also = old(nook_prev(c));
    if (v == kept.V[nook_next(c)]) v = NOOK_NONE;
    if (w == kept.V[nook_prev(c)]) w = NOOK_NONE;
    return pair_faces(v, to, w, also, false);
}

/* What stays of three triangles has area: it faces the way of the three together if it does. */
static bool removal_leaves_area(const attempt *a) {
    uint32_t v = kept.V[a->c], c, n = 0;
    nook_point ring[3];
    for (c = 0; c < 3 * kept_nt; c++) {
        if (kept.V[c] == v && n < 3) ring[n++] = old(nook_next(c));
    }
    return n == 0 || has_area(ring[0], ring[1], ring[2]);
}

/* ---- which way a loop faces ------------------------------------------------------------------------------ */

static bool is_even; /* all coordinates are eighths, so that sums of floats are exact */

static int64_t eighths(float x) {
    int32_t n = (int32_t)(x * 8.0f);
    if ((float)n != x * 8.0f) is_even = false;
    return n;
}

static void difference(nook_point p, nook_point from, int64_t to[3]) {
    to[0] = eighths(p.x) - eighths(from.x);
    to[1] = eighths(p.y) - eighths(from.y);
    to[2] = eighths(p.z) - eighths(from.z);
}

/* The border of the new triangles, as they run it, and the vector area that it encloses. */
static void loop_normal(int64_t n[3]) {
    nook_point first = b.mesh.G[b.mesh.V[3 * kept_nt + 1]];
    uint32_t c, i;
    n[0] = n[1] = n[2] = 0;
    for (c = 3 * kept_nt; c < 3 * b.mesh.nt; c++) {
        int64_t p[3], q[3];
        if (b.mesh.O[c] >= 3 * kept_nt) continue;
        difference(b.mesh.G[b.mesh.V[nook_next(c)]], first, p);
        difference(b.mesh.G[b.mesh.V[nook_prev(c)]], first, q);
        for (i = 0; i < 3; i++) n[i] += p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }
}

static int64_t size_of(int64_t x) { return x < 0 ? -x : x; }

/* The axis, the first of the largest components, and the side; false where rounding may decide, or the loop faces no way. */
static bool loop_axis(uint32_t *axis, int *side) {
    int64_t n[3], largest, second = 0;
    uint32_t i;
    is_even = true;
    loop_normal(n);
    *axis = size_of(n[0]) >= size_of(n[1]) ? 0 : 1;
    if (size_of(n[2]) > size_of(n[*axis])) *axis = 2;
    *side = n[*axis] < 0 ? -1 : 1;
    largest = size_of(n[*axis]);
    for (i = 0; i < 3; i++) {
        if (i != *axis && size_of(n[i]) > second) second = size_of(n[i]);
    }
    return largest > 0 && (is_even || largest > 500 + second + second / 4);
}

/* Whether all new triangles face the loop's way on its axis. */
static bool filling_faces(uint32_t axis, int side) {
    uint32_t t, i;
    for (t = kept_nt; t < b.mesh.nt; t++) {
        nook_point p[3];
        for (i = 0; i < 3; i++) p[i] = b.mesh.G[b.mesh.V[3 * t + i]];
        if (big_orient2d(p, axis) != side) return false;
    }
    return true;
}

/* ---- no triangle turns over -------------------------------------------------------------------------------- */

static uint32_t allowed, turned, left_open;

/* By the meshes before and after; the answer is left open where the definitions leave it. */
static bool may_be_done(const attempt *a, bool *open) {
    uint32_t axis;
    int side;
    switch (a->what) {
    case FLIP: return flip_faces(a);
    case SPLIT_TRIANGLE: return split_triangle_faces(a);
    case SPLIT_EDGE: return split_edge_faces(a);
    case SPLIT_VERTEX: return split_vertex_faces(a);
    case COLLAPSE:
    case MERGE: return collapse_faces(a);
    case REMOVE_VERTEX: return removal_leaves_area(a);
    case MAKE_TRIANGLE: return has_area(kept.G[a->v[0]], kept.G[a->v[1]], kept.G[a->v[2]]);
    case STITCH: return stitch_faces(a);
    default: *open = !loop_axis(&axis, &side); return *open || filling_faces(axis, side);
    }
}

static const nook_edit strict = {
    .no_turn = true, .color = color, .attributes = beside.attribute, .width = WIDE};

/* Done without conditions and put back, then with them. Ears may find another way when the first is refused. */
static void judge(const attempt *a) {
    bool open = false, good, again;
    uint32_t sum, data;
    nook_status status = carry_out(a, NULL);
    good = status == NOOK_OK && may_be_done(a, &open);
    sum = hash_of_mesh();
    restore();
    data = hash_of_data();
    again = carry_out(a, &strict) == NOOK_OK;
    if (!again) is_as_kept(!is_filling(a->what));
    if (!again) CHECK_EQUAL(hash_of_data(), data);
    if (status == NOOK_OK && open) {
        left_open++;
    } else if (a->what == FILL_EARS && !good) {
        uint32_t axis;
        int side;
        if (again && loop_axis(&axis, &side)) CHECK(filling_faces(axis, side));
        turned += status == NOOK_OK && !again;
    } else {
        CHECK_EQUAL(again, good);
        if (again) CHECK_EQUAL(hash_of_mesh(), sum);
        allowed += again;
        turned += status == NOOK_OK && !good;
    }
    restore();
}

/* An operator in many scenes. */
static void try_operator(uint32_t what) {
    dice d = {20261125u + what};
    uint32_t round, turn, rounds = SMALL ? 12 : 1500;
    allowed = turned = left_open = 0;
    for (round = 0; round < rounds && !test_has_failed(); round++) {
        bool flat = begin_scene(&d, what);
        keep();
        for (turn = 0; turn < 6 && !test_has_failed(); turn++) {
            attempt a = throw_attempt(&d, what);
            throw_at(&d, &a, flat);
            judge(&a);
        }
    }
    CHECK(SMALL || (allowed > 200 && turned > 200));
}

static void a_flip_is_done_exactly_if_both_new_triangles_face_the_quadrilateral(void) { try_operator(FLIP); }

static void a_split_is_done_exactly_if_every_part_faces_what_it_is_cut_from(void) {
    try_operator(SPLIT_TRIANGLE);
    try_operator(SPLIT_EDGE);
}

static void a_vertex_is_split_exactly_if_what_moves_and_what_fills_the_gap_face_their_way(void) {
    try_operator(SPLIT_VERTEX);
}

static void an_edge_collapses_exactly_if_every_triangle_at_its_ends_faces_its_way(void) {
    try_operator(COLLAPSE);
    try_operator(MERGE);
}

static void a_vertex_is_removed_or_a_triangle_made_exactly_if_the_triangle_has_area(void) {
    try_operator(REMOVE_VERTEX);
    try_operator(MAKE_TRIANGLE);
}

static void edges_are_stitched_exactly_if_every_triangle_that_moves_faces_its_way(void) {
    try_operator(STITCH);
}

static void a_hole_is_filled_exactly_if_every_triangle_faces_its_way(void) {
    try_operator(FILL_FAN);
    try_operator(FILL_CENTROID);
    try_operator(FILL_EARS);
}

/* ---- drawn cases ------------------------------------------------------------------------------------------- */

static const nook_edit no_turn = {.no_turn = true};

/* Points in the plane, by twos, and triangles. */
static void draw(const float *xy, uint32_t nv, const uint8_t *list, uint32_t nt) {
    uint32_t v;
    begin_shape(nv);
    for (v = 0; v < nv; v++) place(v, xy[2 * v], xy[2 * v + 1], 0);
    add_list(list, nt);
    link_shape();
    keep();
}

/* What the operator says with the condition; the mesh is as it was afterwards. */
static nook_status asked(const attempt *a) {
    nook_status status = carry_out(a, &no_turn);
    if (status != NOOK_OK) is_as_kept(!is_filling(a->what));
    restore();
    return status;
}

static nook_status ask_flip(uint32_t c) {
    attempt a = {.what = FLIP};
    a.c = c;
    return asked(&a);
}

static nook_status ask_collapse(uint32_t c, float x, float y) {
    attempt a = {.what = COLLAPSE};
    a.c = c;
    a.at = nook_make(x, y, 0);
    return asked(&a);
}

/*     A(0)
 *    /    \         D goes to and fro, or A does; the edge is B C.
 *  B(1) - C(2)
 *    \    /
 *     D(3)          */
static const uint8_t two[] = {0, 1, 2, 3, 2, 1};

static void a_convex_quadrilateral_can_be_flipped_and_a_concave_one_not(void) {
    static const float xy[] = {0, 2, -2, 0, 2, 0, 0, -2};
    float x;
    for (x = -8; x <= 8; x += 0.5f) {
        draw(xy, 4, two, 2);
        place(3, x, -2, 0); /* A, C and D are on a line at 4, A, B and D at -4 */
        keep();
        CHECK_EQUAL(ask_flip(0), x > -4 && x < 4 ? NOOK_OK : NOOK_TURNED_TRIANGLE);
    }
}

/* As when A is pulled down past B C, or past D: both new triangles face the way of both old ones together. */
static void a_flip_may_turn_a_turned_triangle_back(void) {
    static const float xy[] = {0, -1, -2, 0, 2, 0, 0, -2};
    float y;
    for (y = -3; y <= 2; y += 0.25f) {
        draw(xy, 4, two, 2);
        place(0, 0, y, 0);
        keep();
        CHECK_EQUAL(ask_flip(0), y != -2 ? NOOK_OK : NOOK_TURNED_TRIANGLE);
    }
}

static void a_last_place_decides_whether_a_flip_turns_a_triangle(void) {
    static const float xy[] = {0, 2, -2, 0, 2, 0, 4, -2};
    draw(xy, 4, two, 2);
    CHECK_EQUAL(ask_flip(0), NOOK_TURNED_TRIANGLE);
    place(3, nook_float_from(nook_float_bits(4) - 1), -2, 0);
    keep();
    CHECK_EQUAL(ask_flip(0), NOOK_OK);
    place(3, 4, -2, nook_float_from(1)); /* less than a right angle by the square of the least float */
    keep();
    CHECK_EQUAL(ask_flip(0), NOOK_OK);
}

static void a_vertex_of_a_flat_grid_can_be_taken_anywhere_within_its_star(void) {
    float little = nook_power_of_two(107);
    uint32_t v, c;
    grid(4, 4);
    for (v = 0; v < b.mesh.nv; v++) place(v, (float)(v % 5), (float)(v / 5), 0);
    link_shape();
    keep();
    c = facing(12, 6); /* from (2, 2) to (1, 1), whose stars reach to 0 and to 3 */
    CHECK_EQUAL(ask_collapse(c, 1, 1), NOOK_OK);
    CHECK_EQUAL(ask_collapse(c, 1.5f, 1.5f), NOOK_OK);
    CHECK_EQUAL(ask_collapse(c, 2, 2), NOOK_OK);
    CHECK_EQUAL(ask_collapse(c, little, 0.5f), NOOK_OK);
    CHECK_EQUAL(ask_collapse(c, 0, 0.5f), NOOK_TURNED_TRIANGLE);
    CHECK_EQUAL(ask_collapse(c, -little, 0.5f), NOOK_TURNED_TRIANGLE);
    CHECK_EQUAL(ask_collapse(c, 0, 0), NOOK_TURNED_TRIANGLE);
    CHECK_EQUAL(ask_collapse(c, 3, 3), NOOK_TURNED_TRIANGLE);
    CHECK_EQUAL(ask_collapse(c, 3, 0), NOOK_TURNED_TRIANGLE);
    CHECK_EQUAL(ask_collapse(c, 4, 4), NOOK_TURNED_TRIANGLE);
}

/*  d(2)
 *  |  \          Without v the border is a d: a triangle between it and b is as it was only if b is beyond.
 *  |   b(3)
 *  v(0)---a(1)   */
static void a_fold_over_a_reflex_border_is_refused(void) {
    static const uint8_t list[] = {0, 1, 3, 0, 3, 2};
    static const float xy[] = {0, 0, 2, 0, 0, 2, 0, 0};
    attempt merge = {.what = MERGE};
    uint32_t k;
    for (k = 1; k <= 7; k++) {
        float at = (float)k * 0.25f;
        nook_status expected = k > 4 ? NOOK_OK : NOOK_TURNED_TRIANGLE;
        draw(xy, 4, list, 2);
        place(3, at, at, 0);
        keep();
        merge.c = nook_next(facing(0, 1)); /* v, whose next is a */
        CHECK_EQUAL(asked(&merge), expected);
        CHECK_EQUAL(ask_collapse(facing(0, 1), 2, 0), expected);
        CHECK_EQUAL(ask_collapse(facing(2, 0), 0, 2), expected);
        CHECK_EQUAL(ask_collapse(facing(0, 1), 0, 0), NOOK_OK);
    }
}

/* A roof of two triangles whose ridge moves to where one of them would stand upright. */
static void a_right_angle_is_one_turn_too_many(void) {
    static const uint8_t list[] = {0, 1, 2, 0, 2, 3};
    static const float xy[] = {0, 0, 1, 0, 1, 1, 0, 1};
    attempt a = {.what = COLLAPSE};
    draw(xy, 4, list, 2);
    a.c = facing(1, 2); /* 0 2 3 moves with it */
    a.at = nook_make(0, 0.5f, 1);
    CHECK_EQUAL(asked(&a), NOOK_TURNED_TRIANGLE);
    a.at.x = nook_power_of_two(67);
    CHECK_EQUAL(asked(&a), NOOK_OK);
    a.at.x = -a.at.x;
    CHECK_EQUAL(asked(&a), NOOK_TURNED_TRIANGLE);
}

/*  4 ----- 5       The triangle 0 1 2 has no area.
 *  | \   / |
 *  0 - 2 - 1
 *    \   /
 *      3          */
static const uint8_t over_a_sliver[] = {0, 1, 2, 1, 0, 3, 0, 2, 4, 2, 1, 5, 2, 5, 4};
static const float sliver_places[] = {0, 0, 2, 0, 1, 0, 1, -2, 0, 2, 2, 2};

static void a_triangle_without_area_can_be_edited_away(void) {
    attempt a = {.what = SPLIT_EDGE};
    draw(sliver_places, 6, over_a_sliver, 5);
    CHECK_EQUAL(ask_flip(facing(0, 1)), NOOK_OK);
    CHECK_EQUAL(ask_flip(facing(0, 2)), NOOK_TURNED_TRIANGLE); /* 4 0 1 2 is not convex at 2 */
    CHECK_EQUAL(ask_collapse(facing(0, 2), 0, 0), NOOK_OK);
    CHECK_EQUAL(ask_collapse(facing(2, 1), 2, 0), NOOK_OK);
    /* It faces every way: moved, it may come to face up or down, but not have no area again. */
    CHECK_EQUAL(ask_collapse(facing(4, 2), 1, 1), NOOK_OK);
    CHECK_EQUAL(ask_collapse(facing(4, 2), 1, -1), NOOK_OK);
    CHECK_EQUAL(ask_collapse(facing(4, 2), 0.5f, 0), NOOK_TURNED_TRIANGLE);
    a.c = facing(0, 1);
    a.at = nook_make(1, -1, 0);
    CHECK_EQUAL(asked(&a), NOOK_OK);
    a.at = nook_make(1, 0, 0);
    CHECK_EQUAL(asked(&a), NOOK_TURNED_TRIANGLE);
}

static void a_triangle_without_area_that_an_edit_leaves_alone_is_not_in_its_way(void) {
    attempt merge = {.what = MERGE};
    draw(sliver_places, 6, over_a_sliver, 5);
    /* 4 goes to the place of 0, or 3 does; 0 1 2 keeps all its vertices, and they their places. */
    merge.c = nook_next(facing(4, 0));
    CHECK_EQUAL(asked(&merge), NOOK_OK);
    CHECK_EQUAL(ask_collapse(facing(4, 0), 0, 0), NOOK_OK);
    CHECK_EQUAL(ask_collapse(facing(0, 3), 0, 0), NOOK_OK);
}

/* ---- flat holes ---------------------------------------------------------------------------------------------- */

/* Twice the area that the loop of c encloses, seen from above, as triangles in the hole would run it. */
static float enclosed(uint32_t c) {
    nook_view view = nook_view_of(&b.mesh);
    float sum = 0;
    uint32_t x = c;
    do {
        nook_point p = nook_point_at(&view, nook_prev(x)), q = nook_point_at(&view, nook_next(x));
        sum += p.x * q.y - p.y * q.x;
        x = nook_border_next(&view, x, true);
    } while (x != c && x != NOOK_NONE);
    return sum;
}

/* Every polygon has two ears (Meisters 1975), also one with points on a line, and an ear of a hole in a flat mesh is not
 * joined across. The outer border is the same polygon as the mesh, and so may be. */
static void every_hole_of_a_flat_mesh_is_filled_by_ears_that_face_up(void) {
    dice d = {20261126u};
    uint32_t round, c, v, n, holes = 0, rounds = SMALL ? 6 : 600;
    attempt a = {.what = FILL_EARS};
    for (round = 0; round < rounds && !test_has_failed(); round++) {
        grid(4, 5);
        for (v = 0; v < b.mesh.nv; v++) place(v, 2.0f * (float)(v % 5), 2.0f * (float)(v / 5), 0);
        link_shape();
        for (n = throw_dice(&d, 20); n > 0; n--)
            (void)nook_remove_triangle(&b.mesh, throw_dice(&d, b.mesh.nt), NULL);
        keep();
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            bool hole = b.mesh.O[c] == c && enclosed(c) > 0;
            nook_status status;
            a.c = c;
            if (b.mesh.O[c] != c) continue;
            status = carry_out(&a, &no_turn);
            CHECK(status == NOOK_OK || status == NOOK_NO_CAPACITY ||
                  (!hole && (status == NOOK_DUPLICATE_EDGE || status == NOOK_TURNED_TRIANGLE)));
            if (status == NOOK_OK) CHECK(filling_faces(2, hole ? 1 : -1));
            holes += hole && status == NOOK_OK;
            restore();
        }
    }
    CHECK(holes > rounds);
}

/* A ring of triangles about a hole of three edges, 0 1 2. */
static const uint8_t ring[] = {1, 0, 3, 2, 1, 4, 0, 2, 5, 3, 0, 5, 4, 1, 3, 5, 2, 4};

/* It can only be filled the way that it faces, however thin it is. Floats do not see this area, which is
 * 8191 * 4097 - 8193 * 4096 = -1. */
static void a_hole_of_three_edges_is_filled_if_it_has_area(void) {
    static const float xy[] = {0, 0, 8191, 8193, 4096, 4097, 8191, 0, 8191, 8195, 0, 8195};
    attempt a = {.what = FILL_FAN};
    draw(xy, 6, ring, 6);
    a.c = facing(1, 0);
    for (; a.what <= FILL_EARS; a.what += FILL_EARS - FILL_FAN) CHECK_EQUAL(asked(&a), NOOK_OK);
}

/* Seen along x this one has hardly any area, and rounding takes the centroid out of it. */
static void a_hole_is_seen_along_the_axis_that_it_mostly_faces(void) {
    static const float xy[] = {0, 8, 0x1.fffffep1f, 0x1.000002p3f, 4, 12, 9, 0, 9, 9, -9, 9};
    attempt a = {.what = FILL_CENTROID};
    draw(xy, 6, ring, 6);
    b.mesh.G[0].z = 0x1.fffffep1f;
    b.mesh.G[1].z = 0x1.000002p2f;
    b.mesh.G[2].z = 0x1.400002p2f;
    keep();
    a.c = facing(1, 0);
    CHECK_EQUAL(asked(&a), NOOK_OK);
}

/* ---- valence -------------------------------------------------------------------------------------------------- */

static uint32_t valence_in(const nook_index *V, uint32_t nt, uint32_t v) {
    uint32_t c, n = 0;
    for (c = 0; c < 3 * nt; c++) n += V[c] == v;
    return n;
}

/* Who vertex v was before: x is its number and one more. NOOK_NONE if it is new. */
static uint32_t formerly(uint32_t v) {
    float x = b.mesh.G[v].x;
    if (v == kept_nv || !(x >= 1 && x <= (float)kept_nv)) return NOOK_NONE;
    return (uint32_t)x - 1;
}

/* The most triangles of a vertex that the edit gives some; and of these and a vertex made of two, or into two. */
static uint32_t most_raised, most_formed;

static void compare_valences(const attempt *a) {
    uint32_t v, split = NOOK_NONE, merged = NOOK_NONE;
    if (a->what == SPLIT_VERTEX) split = kept.V[a->c == NOOK_NONE ? nook_prev(a->d) : nook_next(a->c)];
    if (a->what == COLLAPSE) merged = kept.V[nook_prev(a->c)];
    if (a->what == MERGE) merged = kept.V[nook_next(a->c)];
    most_raised = most_formed = 0;
    for (v = 0; v < b.mesh.nv; v++) {
        uint32_t n = valence_in(b.mesh.V, b.mesh.nt, v), who = formerly(v);
        uint32_t before = who == NOOK_NONE ? 0 : valence_in(kept.V, kept_nt, who);
        if (n > before && n > most_raised) most_raised = n;
        if ((n > before || (who != NOOK_NONE && (who == split || who == merged))) && n > most_formed)
            most_formed = n;
    }
}

/* All limits, of an edit that is possible without one. */
static void judge_limits(const attempt *a) {
    nook_edit limited = {.color = color, .attributes = beside.attribute, .width = WIDE};
    uint32_t sum = hash_of_mesh(), data = 0;
    restore();
    for (limited.max_valence = 1; limited.max_valence < 16; limited.max_valence++) {
        nook_status status;
        data = hash_of_data();
        status = carry_out(a, &limited);
        if (status == NOOK_OK) {
            CHECK(most_raised <= limited.max_valence);
            CHECK_EQUAL(hash_of_mesh(), sum);
            allowed++;
        } else {
            CHECK_EQUAL(status, NOOK_TOO_MANY_TRIANGLES);
            CHECK(most_formed > limited.max_valence);
            if (most_raised <= limited.max_valence) left_open++;
            is_as_kept(!is_filling(a->what));
            CHECK_EQUAL(hash_of_data(), data);
            turned++;
        }
        restore();
    }
}

static void no_vertex_comes_to_have_more_triangles_than_the_limit(void) {
    dice d = {20261128u};
    uint32_t what, round, v, rounds = SMALL ? 8 : 400;
    for (what = 0; what < CONDITIONED && !test_has_failed(); what++) {
        allowed = turned = left_open = 0;
        for (round = 0; round < rounds && !test_has_failed(); round++) {
            attempt a;
            (void)begin_scene(&d, what);
            for (v = 0; v < b.mesh.nv; v++) place(v, (float)(v + 1), (float)(v * v % 17), 0);
            a = throw_attempt(&d, what);
            a.at = what == COLLAPSE ? b.mesh.G[b.mesh.V[nook_prev(a.c)]] : nook_make(1000, 0, 0);
            keep();
            if (carry_out(&a, NULL) == NOOK_OK) {
                compare_valences(&a);
                judge_limits(&a);
            }
            restore();
        }
        CHECK(SMALL || (allowed > 200 && (turned > 200 || what == REMOVE_VERTEX)));
    }
}

static void a_limit_holds_for_the_new_vertex_of_a_split_as_well(void) {
    static const float xy[] = {0, 2, -2, 0, 2, 0, 0, -2};
    nook_edit limited = {.max_valence = 3};
    draw(xy, 4, two, 2); /* the new vertex has four triangles, and no other more than two */
    CHECK_EQUAL(nook_split_edge(&b.mesh, 0, nook_make(0, 0, 0), &limited), NOOK_TOO_MANY_TRIANGLES);
    restore();
    draw(xy, 3, two, 1); /* it has three */
    limited.max_valence = 2;
    CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, nook_make(0, 1, 0), &limited), NOOK_TOO_MANY_TRIANGLES);
    restore();
    limited.max_valence = 3;
    CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, nook_make(0, 1, 0), &limited), NOOK_OK);
}

/* ---- attributes ------------------------------------------------------------------------------------------------ */

static uint32_t width;
static nook_edit with_data(void) {
    nook_edit edit = {.no_turn = true, .color = color, .attributes = beside.attribute};
    edit.width = width;
    return edit;
}

/* The attributes of a place are a function of it, one for triangles of color 1 and another for those of color 2; these
 * differ by 600 and more wherever a vertex can be. */
static float value(uint32_t side, uint32_t i, nook_point p) {
    static const float grow[2][WIDE][3] = {{{1, 2, 5}, {-3, 1, 0}, {2, -1, 7}},
                                           {{0, 3, 900}, {-2, 2, 900}, {4, 0, 900}}};
    const float *g = grow[side == 2][i];
    return g[0] * p.x + g[1] * p.y + g[2];
}

/* Where vertex v of the sheet is: on a grid that is not regular, so that new vertices do not fall on old ones. */
static nook_point place_in_sheet(uint32_t v) {
    return nook_make((float)(16 * (v % 5) + v * v % 7), (float)(16 * (v / 5) + v * v % 5), 0);
}

static bool is_of_sheet(nook_point p) {
    uint32_t v;
    for (v = 0; v < 20; v++) {
        nook_point q = place_in_sheet(v);
        if (p.x == q.x && p.y == q.y) return true;
    }
    return false;
}

/* A flat sheet of 4 by 3 cells; if creased, from the second row on it has color 2. */
static void begin_sheet(bool creased) {
    uint32_t v, c, i;
    grid(4, 3);
    for (v = 0; v < b.mesh.nv; v++) b.mesh.G[v] = place_in_sheet(v);
    link_shape();
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        color[c / 3] = creased && c / 3 >= 8 ? 2 : 1;
        for (i = 0; i < width; i++)
            beside.attribute[c * width + i] = value(color[c / 3], i, b.mesh.G[b.mesh.V[c]]);
    }
}

/* Exact at the places of the sheet, as these are only copied. */
static void attributes_are_of_their_place(void) {
    uint32_t c, i;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        nook_point p = b.mesh.G[b.mesh.V[c]];
        float most = is_of_sheet(p) ? 0 : 0.02f;
        CHECK(color[c / 3] == 1 || color[c / 3] == 2);
        for (i = 0; i < width; i++) {
            float off = beside.attribute[c * width + i] - value(color[c / 3], i, p);
            CHECK(off <= most && off >= -most);
        }
    }
}

/* The color of all triangles at vertex v; 0 if they have two, or there are none. */
static uint32_t color_at(uint32_t v) {
    uint32_t c, found = 0;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        if (b.mesh.V[c] != v) continue;
        if (found != 0 && found != color[c / 3]) return 0;
        found = color[c / 3];
    }
    return found;
}

/* All vertices of the loop of c have one color. */
static bool loop_has_one_color(uint32_t c) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t x = c;
    do {
        if (color_at(b.mesh.V[nook_next(x)]) != color[c / 3]) return false;
        x = nook_border_next(&view, x, true);
    } while (x != c && x != NOOK_NONE);
    return true;
}

/* Vertices that leave the crease, or enter it, can only do so at its places. */
static bool collapse_keeps_crease(attempt *a) {
    uint32_t x = a->what == MERGE ? nook_prev(a->c) : a->c, o = b.mesh.O[x];
    uint32_t n = b.mesh.V[nook_next(x)], p = b.mesh.V[nook_prev(x)];
    if (color[x / 3] != color[o / 3]) return true;
    if (color_at(n) == 0 && (color_at(p) == 0 || a->what == MERGE)) return false;
    if (color_at(n) == 0) a->at = b.mesh.G[n];
    if (color_at(p) == 0) a->at = b.mesh.G[p];
    return true;
}

/* Whether no triangle at vertex v is so thin that floats hardly know what is inside. */
static bool has_good_triangles(uint32_t v) {
    uint32_t c;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        nook_point p = b.mesh.G[v], q, r;
        if (b.mesh.V[c] != v) continue;
        q = nook_sub(b.mesh.G[b.mesh.V[nook_next(c)]], p);
        r = nook_sub(b.mesh.G[b.mesh.V[nook_prev(c)]], p);
        if (nook_length(nook_cross(q, r)) < 0.01f * (nook_dot(q, q) + nook_dot(r, r))) return false;
    }
    return true;
}

static bool same_place(uint32_t c, uint32_t d) {
    return memcmp(&b.mesh.G[b.mesh.V[c]], &b.mesh.G[b.mesh.V[d]], sizeof(nook_point)) == 0;
}

/* Whether the attributes that are there decide what the new ones are. */
static bool keeps_crease(attempt *a) {
    uint32_t first = color_at(a->v[0]), n = b.mesh.V[nook_next(a->c)];
    switch (a->what) {
    case FLIP: return color[a->c / 3] == color[b.mesh.O[a->c] / 3];
    case SPLIT_TRIANGLE: return has_good_triangles(n);
    case SPLIT_VERTEX: return color_at(n) != 0 && has_good_triangles(n);
    case COLLAPSE:
    case MERGE: return collapse_keeps_crease(a);
    case REMOVE_VERTEX: return color_at(b.mesh.V[a->c]) != 0;
    case MAKE_TRIANGLE: return first != 0 && color_at(a->v[1]) == first && color_at(a->v[2]) == first;
    case STITCH:
        return same_place(nook_next(a->c), nook_prev(a->d)) && same_place(nook_prev(a->c), nook_next(a->d));
    case FILL_FAN:
    case FILL_CENTROID:
    case FILL_EARS: return b.mesh.O[a->c] == a->c && loop_has_one_color(a->c);
    default: return true;
    }
}

/* A place in the triangle of c, near the vertex that is to be split; or on the edge that it faces. */
static nook_point throw_place_of_sheet(dice *d, const attempt *a) {
    nook_point p = b.mesh.G[b.mesh.V[a->c]], q = b.mesh.G[b.mesh.V[nook_next(a->c)]],
               r = b.mesh.G[b.mesh.V[nook_prev(a->c)]];
    uint32_t s = throw_dice(d, 4);
    if (a->what == SPLIT_VERTEX) return middle(q, middle(q, middle(p, r)));
    if (a->what == SPLIT_TRIANGLE) return s == 0 ? middle(middle(p, q), r) : middle(middle(q, r), p);
    if (a->what == COLLAPSE && s == 0) return throw_dice(d, 2) == 0 ? q : r;
    return s == 1 ? middle(q, middle(q, r)) : middle(q, r);
}

static attempt throw_attempt_on_sheet(dice *d) {
    nook_view view = nook_view_of(&b.mesh);
    attempt a = throw_attempt(d, throw_dice(d, OPERATORS));
    if (a.c == NOOK_NONE) a.c = a.d;
    a.at = throw_place_of_sheet(d, &a);
    if (a.what == STITCH && nook_is_border(&view, a.c)) a.d = nearest_edge(a.c);
    return a;
}

static void reverse_all(const nook_edit *edit) {
    nook_reverse reverse;
    nook_status status = nook_reverse_begin(&reverse, &b.mesh, NULL, 0, edit);
    while (status == NOOK_OK) {
        uint32_t units = 7;
        status = nook_reverse_step(&reverse, &units);
        if (status == NOOK_OK) return;
        if (status == NOOK_MORE) status = NOOK_OK;
    }
    CHECK_EQUAL(status, NOOK_OK);
}

static void attributes_stay_a_function_of_the_place(void) {
    dice d = {20261129u};
    uint32_t round, turn, done[OPERATORS], what;
    memset(done, 0, sizeof done);
    for (round = 0; round < (SMALL ? 6u : 240u) && !test_has_failed(); round++) {
        nook_edit edit;
        width = 1 + round / 2 % 3;
        edit = with_data();
        begin_sheet(round % 2 == 1);
        attributes_are_of_their_place();
        for (turn = 0; turn < 80 && !test_has_failed(); turn++) {
            attempt a;
            if (turn % 16 == 15) reverse_all(&edit);
            a = throw_attempt_on_sheet(&d);
            if (!keeps_crease(&a) || carry_out(&a, &edit) != NOOK_OK) continue;
            done[a.what]++;
            attributes_are_of_their_place();
        }
    }
    if (SMALL || test_has_failed()) return;
    for (what = 0; what < OPERATORS; what++) CHECK(done[what] > 40);
}

/* A fan of three triangles about 0, in any order, with any of its corners first in each. */
static void begin_fan(uint32_t first, uint32_t turn) {
    static const uint8_t fan[] = {0, 1, 2, 0, 2, 3, 0, 3, 4};
    static const float xy[] = {0, 0, 8, 0, 6, 6, -6, 6, -8, 0};
    uint32_t i;
    begin_shape(5);
    for (i = 0; i < 5; i++) place(i, xy[2 * i], xy[2 * i + 1], 0);
    for (i = 0; i < 3; i++) {
        const uint8_t *v = fan + 3 * ((i + first) % 3);
        add(v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]);
    }
    link_shape();
    for (i = 0; i < 9; i++) color[i / 3] = 1, beside.attribute[i] = value(1, 0, b.mesh.G[b.mesh.V[i]]);
}

/* Whichever number it has. */
static void a_collapse_at_the_border_brings_every_corner_along(void) {
    nook_edit edit;
    uint32_t order, c, x;
    width = 1;
    edit = with_data();
    for (order = 0; order < 9; order++) {
        for (c = 0; c < 9; c++) {
            nook_point at;
            begin_fan(order / 3, order % 3);
            at = middle(b.mesh.G[b.mesh.V[nook_next(c)]], b.mesh.G[b.mesh.V[nook_prev(c)]]);
            if (b.mesh.O[c] != c || nook_collapse(&b.mesh, c, at, &edit) != NOOK_OK) continue;
            for (x = 0; x < 3 * b.mesh.nt; x++)
                CHECK(beside.attribute[x] == value(1, 0, b.mesh.G[b.mesh.V[x]]));
        }
    }
}

/* A sheet whose vertices have each some attribute. */
static void begin_colorful_sheet(dice *d) {
    float of_vertex[ROOM_V] = {0};
    uint32_t i;
    begin_sheet(false);
    for (i = 0; i < b.mesh.nv; i++) of_vertex[i] = (float)(1 + throw_dice(d, 99999)) * 0.003f;
    for (i = 0; i < 3 * b.mesh.nt; i++) beside.attribute[i] = of_vertex[b.mesh.V[i]];
}

static void attributes_agree_at(nook_point at) {
    float found = 0;
    uint32_t c;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        nook_point p = b.mesh.G[b.mesh.V[c]];
        if (p.x != at.x || p.y != at.y) continue;
        if (found == 0) found = beside.attribute[c];
        CHECK(beside.attribute[c] == found);
    }
    CHECK(found != 0);
}

/* To the last bit: else it would be a crease from then on. */
static void a_new_place_on_an_edge_has_the_same_attributes_on_both_sides(void) {
    dice d = {20261130u};
    uint32_t round;
    nook_edit edit;
    width = 1;
    edit = with_data();
    edit.no_turn = false;
    for (round = 0; round < (SMALL ? 100u : 4000u) && !test_has_failed(); round++) {
        attempt a = {.what = round % 2 == 0 ? SPLIT_EDGE : COLLAPSE};
        float s = (float)(1 + throw_dice(&d, 998)) * 0.001f;
        nook_point p, q;
        begin_colorful_sheet(&d);
        a.c = throw_dice(&d, 3 * b.mesh.nt);
        p = b.mesh.G[b.mesh.V[nook_next(a.c)]];
        q = b.mesh.G[b.mesh.V[nook_prev(a.c)]];
        a.at = nook_make(p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), 0);
        if (carry_out(&a, &edit) == NOOK_OK) attributes_agree_at(a.at);
    }
}

/* Beside an edge they are those of the foot, beyond it of the nearer end; half and half where both ends are in one place. */
static void attributes_of_a_place_off_the_edge_are_of_the_nearest_on_it(void) {
    static const float xy[] = {0, 2, -2, 0, 2, 0, 0, -2};
    static const float x[] = {-9, -2, -1, 1, 2, 9}, expected[] = {10, 10, 12.5f, 17.5f, 20, 20};
    const nook_edit edit = {.attributes = beside.attribute, .width = 1};
    uint32_t i, c;
    for (i = 0; i < 7; i++) {
        draw(xy, 4, two, 2);
        for (c = 0; c < 6; c++) beside.attribute[c] = b.mesh.V[c] == 1 ? 10 : b.mesh.V[c] == 2 ? 20 : 77;
        if (i == 6) b.mesh.G[2] = b.mesh.G[1];
        CHECK_EQUAL(nook_split_edge(&b.mesh, 0, nook_make(i == 6 ? 5 : x[i], 3, 0), &edit), NOOK_OK);
        for (c = 0; c < 3 * b.mesh.nt; c++) {
            if (b.mesh.V[c] == 4) CHECK(beside.attribute[c] == (i == 6 ? 15 : expected[i]));
        }
    }
}

/* A triangle on v, in any turn, which meets the triangle of color 10 at vertices up to 3, or that of color 20. */
static void make_and_look(const uint32_t v[3], uint32_t turn, uint8_t met) {
    const nook_edit edit = {.color = color, .attributes = beside.attribute, .width = 1};
    uint32_t turned_v[3], i, t = b.mesh.nt;
    for (i = 0; i < 3; i++) turned_v[i] = v[(i + turn) % 3];
    CHECK_EQUAL(nook_make_triangle(&b.mesh, turned_v, &edit), NOOK_OK);
    CHECK_EQUAL(color[t], met);
    for (i = 0; i < 3; i++) {
        uint32_t expected = met == 1 || turned_v[i] > 3 ? 0 : met + turned_v[i];
        CHECK(beside.attribute[3 * t + i] == (float)expected);
    }
}

/*   4 - 3 - 2
 *     \ | / |      Between 0 1 2 and 0 2 3 there is a crease; 0 3 4 is to be joined to the second, 1 0 5 to the first.
 *       0 - 1      Whatever corner C names at 0.
 *        \ /
 *         5        */
static void a_made_triangle_takes_the_attributes_of_the_corners_it_meets(void) {
    static const uint8_t list[] = {0, 1, 2, 0, 2, 3};
    static const float xy[] = {0, 0, 9, 0, 9, 9, 0, 9, -9, 9, 9, -9};
    static const uint32_t second[3] = {0, 3, 4}, first[3] = {1, 0, 5}, alone[3] = {3, 4, 5};
    uint32_t turn, c;
    for (turn = 0; turn < 12; turn++) {
        draw(xy, 6, list, 2);
        b.mesh.C[0] = nook_store(turn < 6 ? 0 : 3);
        color[0] = 10, color[1] = 20;
        for (c = 0; c < 6; c++) beside.attribute[c] = (float)(color[c / 3] + b.mesh.V[c]);
        make_and_look(turn % 2 == 0 ? first : second, turn % 3, turn % 2 == 0 ? 10 : 20);
        make_and_look(turn % 2 == 0 ? second : first, turn % 3, turn % 2 == 0 ? 20 : 10);
    }
    draw(xy, 6, list, 1); /* joined to nothing it has color 1 and no attributes */
    make_and_look(alone, 0, 1);
}

/* As the header of nook_edit says of every new vertex. */
static void the_new_vertex_of_a_vertex_split_has_the_attributes_of_its_place(void) {
    nook_edit edit;
    uint32_t kind;
    for (kind = 0; kind < 4; kind++) {
        attempt a = {.what = SPLIT_VERTEX};
        width = 1 + kind % 3;
        edit = with_data();
        begin_sheet(false);
        a.c = facing(6, 12); /* up and right of 6 */
        a.d = facing(0, 6);  /* down and left */
        a.at = nook_make(b.mesh.G[6].x - (float)kind, b.mesh.G[6].y + (float)kind, 0);
        edit.no_turn = kind > 0;
        CHECK_EQUAL(carry_out(&a, &edit), NOOK_OK);
        attributes_are_of_their_place();
    }
}

/* On a crease the corners of the side where it is go along; those of the other side stay as they were. */
static void a_vertex_split_on_a_crease_changes_one_side(void) {
    attempt a = {.what = SPLIT_VERTEX};
    uint32_t c, sides = 0;
    nook_point place;
    nook_edit edit;
    width = 1;
    edit = with_data();
    begin_sheet(true);
    place = b.mesh.G[6];
    a.c = facing(6, 12);
    a.d = facing(0, 6);
    a.at = nook_make(place.x - 1, place.y + 1, 0);
    edit.no_turn = false;
    CHECK_EQUAL(carry_out(&a, &edit), NOOK_OK);
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        nook_point p = b.mesh.G[b.mesh.V[c]];
        bool moved = false;
        if (p.x != a.at.x || p.y != a.at.y) continue;
        moved = beside.attribute[c] - value(color[c / 3], 0, p) < 0.02f &&
                value(color[c / 3], 0, p) - beside.attribute[c] < 0.02f;
        if (!moved) CHECK(beside.attribute[c] == value(color[c / 3], 0, place));
        sides |= moved ? 1u : 2u;
    }
    CHECK_EQUAL(sides, 3);
}

/* ---- barycentric coordinates ------------------------------------------------------------------------------------ */

static float size_of_float(float x) { return x < 0 ? -x : x; }
static bool is_near(float x, float y, float most) { return size_of_float(x - y) <= most; }

static nook_point weighted(const nook_point p[3], const float w[3]) {
    nook_point q = nook_scaled(p[0], w[0]), r = nook_scaled(p[1], w[1]), s = nook_scaled(p[2], w[2]);
    return nook_make(q.x + r.x + s.x, q.y + r.y + s.y, q.z + r.z + s.z);
}

static float throw_part(dice *d) { return (float)throw_dice(d, 2001) * 0.001f - 1.0f; }

static void throw_triangle(dice *d, nook_point p[3]) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        p[i].x = throw_part(d);
        p[i].y = throw_part(d);
        p[i].z = throw_part(d);
    }
}

/* From 1e-15 to 2^30. */
static void barycentric_coordinates_give_the_point_back_at_any_scale(void) {
    dice d = {20261201u};
    uint32_t round, tried = 0;
    for (round = 0; round < (SMALL ? 200u : 20000u) && !test_has_failed(); round++) {
        float scale = nook_power_of_two(77 + throw_dice(&d, 80)), given[3], w[3];
        nook_point p[3], n, at, back;
        uint32_t i;
        throw_triangle(&d, p);
        n = nook_cross(nook_sub(p[1], p[0]), nook_sub(p[2], p[0]));
        given[1] = 2 * throw_part(&d);
        given[2] = 2 * throw_part(&d);
        given[0] = 1 - given[1] - given[2];
        if (nook_length(n) < 0.1f) continue;
        for (i = 0; i < 3; i++) p[i] = nook_scaled(p[i], scale);
        at = weighted(p, given);
        back = nook_scaled(n, scale * throw_part(&d)); /* seen along the normal, this is no other place */
        nook_barycentric(p, nook_make(at.x + back.x, at.y + back.y, at.z + back.z), w);
        for (i = 0; i < 3; i++) CHECK(is_near(w[i], given[i], 1e-4f));
        CHECK(is_near(w[0] + w[1] + w[2], 1, 1e-6f));
        back = nook_sub(weighted(p, w), at);
        CHECK(nook_length(back) < 1e-4f * scale);
        tried++;
    }
    CHECK(tried > round / 2);
}

static void barycentric_coordinates_of_no_area_are_a_third_each(void) {
    dice d = {20261202u};
    uint32_t round, i, kind;
    for (round = 0; round < (SMALL ? 100u : 2000u); round++) {
        float scale = nook_power_of_two(77 + throw_dice(&d, 80)), w[3];
        nook_point p[3], at;
        throw_triangle(&d, p);
        at = nook_scaled(p[0], scale);
        for (i = 0; i < 3; i++) p[i] = nook_scaled(throw_grid_point(&d, 4, false), scale);
        kind = throw_dice(&d, 4);
        if (kind == 0) p[2] = p[1];
        if (kind == 1) p[1] = p[0];
        if (kind == 2) p[2] = p[1] = p[0];
        if (kind == 3) p[2] = middle(p[0], p[1]);
        nook_barycentric(p, at, w);
        for (i = 0; i < 3; i++) CHECK(is_near(w[i], 1.0f / 3, 1e-7f));
    }
}

/* ---- a client of the callbacks ---------------------------------------------------------------------------------- */

/* What a program keeps beside the mesh: who each vertex is, which x says too, and each triangle, which its color says. */
typedef struct client {
    uint16_t vertex[ROOM_V];
    uint8_t triangle[ROOM_T];
    uint8_t before[ROOM_T]; /* the colors as of the kept mesh */
    uint32_t vertices;      /* names given out */
    uint8_t last;           /* and the last color */
    uint32_t copies;        /* that were told of */
} client;
static client known;

static void client_renamed(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    client *k = user;
    if (kind == NOOK_AT_VERTEX) k->vertex[to] = k->vertex[from];
    if (kind == NOOK_AT_TRIANGLE) k->triangle[to] = k->triangle[from];
}

static void client_copied(void *user, uint32_t from, uint32_t to) {
    client *k = user;
    k->vertex[to] = k->vertex[from];
    k->copies++;
}

static const nook_edit telling = {
    .color = color, .renamed = client_renamed, .copied = client_copied, .user = &known};

static uint16_t new_name(void) { return (uint16_t)++known.vertices; }

static void name_vertex(uint32_t v, uint16_t name) {
    known.vertex[v] = name;
    b.mesh.G[v] = nook_make((float)name, 0, 0);
}

static uint32_t find_color(const uint8_t *colors, uint32_t nt, uint32_t which) {
    uint32_t t = 0;
    while (t < nt && colors[t] != which) t++;
    return t;
}

static void name_triangle(uint32_t t) {
    do {
        if (++known.last == 0) known.last = 1;
    } while (find_color(color, b.mesh.nt, known.last) < b.mesh.nt);
    known.triangle[t] = color[t] = known.last;
}

static void begin_client(void (*build)(void)) {
    uint32_t i;
    build();
    link_shape();
    memset(color, 0, sizeof color);
    for (i = 0; i < b.mesh.nv; i++) name_vertex(i, new_name());
    for (i = 0; i < b.mesh.nt; i++) name_triangle(i);
}

/* The color of a new triangle, by number among the new: that of the one it is cut from, or joined to. */
static bool is_heir(const attempt *a, uint32_t t) {
    uint32_t i, from = a->c == NOOK_NONE || (a->what == SPLIT_VERTEX && t > kept_nt) ? a->d : a->c,
                joined = 0;
    if (a->what == SPLIT_EDGE && t > kept_nt) from = old_across(a->c);
    if (a->what != MAKE_TRIANGLE) return color[t] == known.before[from / 3];
    for (i = 3 * t; i < 3 * t + 3; i++) {
        if (b.mesh.O[i] == i) continue;
        joined++;
        if (color[b.mesh.O[i] / 3] == color[t]) return true;
    }
    return joined == 0 && color[t] == 1;
}

/* Whether an old triangle has a vertex that the edit is about; only such may be on other vertices afterwards. */
static bool is_concerned(const attempt *a, uint32_t t) {
    uint32_t i, end;
    for (end = 0; end < 2; end++) {
        uint32_t c = end == 0 ? a->c : a->d;
        if (c == NOOK_NONE) continue;
        for (i = 3 * t; i < 3 * t + 3; i++) {
            uint32_t v = kept.V[i];
            if (v == kept.V[c] || v == kept.V[nook_next(c)] || v == kept.V[nook_prev(c)]) return true;
        }
    }
    return false;
}

/* The names of a triangle's vertices are those that the triangle of this color had. */
static bool is_on_the_same_vertices(uint32_t t, uint32_t before) {
    uint32_t i, j, n = 0;
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) n += b.mesh.G[b.mesh.V[3 * t + i]].x == kept.G[kept.V[3 * before + j]].x;
    }
    return n == 3;
}

static void client_knows_all(const attempt *a) {
    uint32_t v, t, before;
    for (v = 0; v < b.mesh.nv; v++) CHECK(b.mesh.G[v].x == (float)known.vertex[v]);
    for (t = 0; t < b.mesh.nt; t++) {
        if (t >= kept_nt) continue;
        CHECK_EQUAL(color[t], known.triangle[t]);
        before = find_color(known.before, kept_nt, color[t]);
        CHECK(before < kept_nt);
        if (before < kept_nt && !is_on_the_same_vertices(t, before)) CHECK(is_concerned(a, before));
    }
}

/* What has come gets names, after a look at whom it comes from. */
static void welcome(const attempt *a) {
    uint32_t v, t;
    for (v = kept_nv; v < b.mesh.nv; v++) {
        if (a->what == CUT) CHECK(b.mesh.G[v].x == (float)known.vertex[v]);
        name_vertex(v, new_name());
    }
    for (t = kept_nt; t < b.mesh.nt; t++) CHECK(is_heir(a, t));
    for (t = kept_nt; t < b.mesh.nt; t++) name_triangle(t);
}

/* The vertex that a collapse moves has another name there; it is told nothing else. */
static bool edit_as_client(attempt *a) {
    uint32_t moved = a->what == COLLAPSE ? b.mesh.V[nook_prev(a->c)] : NOOK_NONE, copies = known.copies;
    uint16_t old_name = moved == NOOK_NONE ? 0 : known.vertex[moved], name = new_name();
    a->at = nook_make((float)name, 0, 0);
    keep();
    memcpy(known.before, color, sizeof known.before);
    if (moved != NOOK_NONE) known.vertex[moved] = name;
    if (carry_out(a, &telling) != NOOK_OK) {
        is_as_kept(!is_filling(a->what));
        if (moved != NOOK_NONE) known.vertex[moved] = old_name;
        return false;
    }
    CHECK_EQUAL(known.copies - copies, a->what == CUT ? b.mesh.nv - kept_nv : 0);
    welcome(a);
    client_knows_all(a);
    return true;
}

static void small_sheet(void) { grid(3, 3); }

/* Any; but less where the room is full, and what was cut is often sewn again. */
static attempt next_edit(dice *d, const attempt *last) {
    attempt a = *last;
    uint32_t full = throw_dice(d, 12);
    if (last->what == CUT && throw_dice(d, 2) == 0) {
        a.what = STITCH;
        return a;
    }
    a = throw_attempt(d, throw_dice(d, OPERATORS));
    if (b.mesh.max_nt - b.mesh.nt < full) a = throw_attempt(d, COLLAPSE);
    if (a.what == CUT) a.d = b.mesh.O[a.c];
    return a;
}

static void a_client_of_the_callbacks_knows_everyone_after_thousands_of_edits(void) {
    dice d = {20261203u};
    uint32_t edits = 0, tries, what, done[OPERATORS];
    attempt last = {.what = FLIP};
    memset(done, 0, sizeof done);
    memset(&known, 0, sizeof known);
    begin_client(small_sheet);
    for (tries = 0; tries < 20000 && edits < 2000 && !test_has_failed(); tries++) {
        last = next_edit(&d, &last);
        if (edit_as_client(&last)) {
            done[last.what]++;
            edits++;
        } else {
            last.what = FLIP;
        }
        if (b.mesh.nt < 4) begin_client(tries % 2 == 0 ? small_sheet : octahedron);
        if (tries % 64 == 63) {
            reverse_all(&telling);
            last.what = FLIP;
        }
    }
    CHECK_EQUAL(edits, 2000);
    for (what = 0; what < OPERATORS && !test_has_failed(); what++) CHECK(done[what] > 10);
}

/* Three fans on one vertex. */
static void a_client_is_told_whose_copy_the_vertex_of_a_split_fan_is(void) {
    static const uint8_t list[] = {0, 1, 2, 3, 0, 4, 5, 6, 0, 6, 5, 1};
    static const float xy[] = {0, 0, 1, 0, 1, 1, 0, 1, -1, 0, -1, -1, 0, -1};
    nook_split_fans split;
    uint32_t units = 100000, v, from_0 = 0;
    memset(&known, 0, sizeof known);
    draw(xy, 7, list, 4);
    for (v = 0; v < 7; v++) name_vertex(v, new_name());
    CHECK_EQUAL(nook_split_fans_begin(&split, &b.mesh, &b.marks, &telling), NOOK_OK);
    CHECK_EQUAL(nook_split_fans_step(&split, &units), NOOK_OK);
    CHECK_EQUAL(known.copies, b.mesh.nv - 7);
    for (v = 0; v < b.mesh.nv; v++) {
        CHECK(b.mesh.G[v].x == (float)known.vertex[v]);
        from_0 += known.vertex[v] == known.vertex[0];
    }
    CHECK_EQUAL(from_0, 3);
}

/* ---- with a tree -------------------------------------------------------------------------------------------- */

static nook_boxes tree_boxes[NOOK_BVH_GROUPS(ROOM_T)];
static nook_guard guard;
static const nook_edit watched = {.guard = &guard};

static void plant(void) {
    CHECK_EQUAL(nook_guard_begin(&guard, &b.mesh, tree_boxes), NOOK_OK);
    CHECK_EQUAL(nook_bvh_refit(&guard.bvh, tree_boxes, NULL), NOOK_OK);
}

static bool is_same_place(const nook_mesh *m, uint32_t t, const nook_point *G, const nook_index *V,
                          uint32_t u) {
    uint32_t i, turned_by;
    for (turned_by = 0; turned_by < 3; turned_by++) {
        for (i = 0; i < 3; i++) {
            nook_point p = m->G[m->V[3 * t + i]], q = G[V[3 * u + (i + turned_by) % 3]];
            if (p.x != q.x || p.y != q.y || p.z != q.z) break;
        }
        if (i == 3) return true;
    }
    return false;
}

/* Whether a triangle stands where none stood before. */
static bool is_new_place(uint32_t t) {
    uint32_t u;
    for (u = 0; u < kept_nt; u++) {
        if (is_same_place(&b.mesh, t, kept.G, kept.V, u)) return false;
    }
    return true;
}

/* Whether any triangle that is new, or elsewhere, intersects another: all pairs. */
static bool has_new_cut(void) {
    nook_view view = nook_view_of(&b.mesh);
    uint32_t t, u;
    for (t = 0; t < b.mesh.nt; t++) {
        if (!is_new_place(t)) continue;
        for (u = 0; u < b.mesh.nt; u++) {
            if (u != t && nook_triangles_intersect(&view, t, u)) return true;
        }
    }
    return false;
}

/* Vertices, and a place to be that is not the place of an end of the edge that collapses. */
static bool all_apart(const attempt *a) {
    uint32_t v, w;
    for (v = 0; v < b.mesh.nv; v++) {
        bool end = a->what == COLLAPSE && (v == b.mesh.V[nook_next(a->c)] || v == b.mesh.V[nook_prev(a->c)]);
        nook_point there = b.mesh.G[v];
        if (there.x == a->at.x && there.y == a->at.y && there.z == a->at.z && !end) return false;
        for (w = 0; w < v; w++) {
            nook_point p = b.mesh.G[v], q = b.mesh.G[w];
            if (p.x == q.x && p.y == q.y && p.z == q.z) return false;
        }
    }
    return true;
}

static bool boxes_meet(uint32_t t, nook_point low, nook_point high) {
    bool above = true, below = true;
    uint32_t axis, i;
    for (axis = 0; axis < 3; axis++) {
        float least = 0x1p40f, most = -0x1p40f;
        for (i = 0; i < 3; i++) {
            float x = nook_along(&b.mesh.G[b.mesh.V[3 * t + i]], axis);
            least = x < least ? x : least;
            most = x > most ? x : most;
        }
        above = above && most >= nook_along(&low, axis);
        below = below && least <= nook_along(&high, axis);
    }
    return above && below;
}

/* What the tree finds in a box is what looking at every triangle finds. */
static void overlap_finds_all(nook_point low, nook_point high) {
    uint8_t found[ROOM_T] = {0};
    nook_overlap q;
    nook_status status;
    uint32_t t;
    CHECK_EQUAL(nook_overlap_begin(&q, &guard.bvh, low, high), NOOK_OK);
    do {
        uint32_t units = 1;
        status = nook_overlap_step(&q, &units);
        if (status == NOOK_TRIANGLE) found[q.t]++;
    } while (status == NOOK_MORE || status == NOOK_TRIANGLE);
    CHECK_EQUAL(status, NOOK_OK);
    for (t = 0; t < b.mesh.nt; t++) CHECK_EQUAL(found[t], boxes_meet(t, low, high));
}

/* The same answers as of a tree that is built anew. */
static void tree_answers(dice *d) {
    nook_bvh anew;
    nook_ray ray, same;
    nook_closest near, as_near;
    nook_view view = nook_view_of(&b.mesh);
    nook_point from = finished(d, throw_grid_point(d, 16, false)), to = b.mesh.G[throw_dice(d, b.mesh.nv)];
    CHECK(guard.bvh.view.nt == b.mesh.nt && guard.bvh.view.nv == b.mesh.nv);
    CHECK_EQUAL(nook_bvh_build(&anew, &view, beside.fresh.boxes, beside.fresh.order, NULL), NOOK_OK);
    overlap_finds_all(nook_make(from.x - 2, from.y - 2, from.z - 3), nook_make(from.x, from.y, from.z));
    overlap_finds_all(to, to);
    if (nook_ray_cast(&ray, &guard.bvh, from, nook_sub(to, from), NOOK_MAX_T, NOOK_NEAREST) == NOOK_OK) {
        CHECK_EQUAL(nook_ray_cast(&same, &anew, from, nook_sub(to, from), NOOK_MAX_T, NOOK_NEAREST), NOOK_OK);
        CHECK(ray.triangle == same.triangle && ray.t == same.t);
    }
    CHECK_EQUAL(nook_closest_point(&near, &guard.bvh, from), NOOK_OK);
    CHECK_EQUAL(nook_closest_point(&as_near, &anew, from), NOOK_OK);
    CHECK(near.distance == as_near.distance);
}

static uint32_t clear, cutting;

/* Done without a tree and put back, then with it; and that stays. */
static void judge_by_tree(dice *d, const attempt *a) {
    uint32_t sum;
    nook_status status = carry_out(a, NULL), again;
    bool cut = status == NOOK_OK && a->what < CONDITIONED && has_new_cut();
    sum = hash_of_mesh();
    restore();
    again = carry_out(a, &watched);
    CHECK_EQUAL(again, cut ? NOOK_SELF_INTERSECTION : status);
    if (again == NOOK_OK) CHECK_EQUAL(hash_of_mesh(), sum);
    if (again != NOOK_OK) is_as_kept(!is_filling(a->what));
    if (cut) restore();
    cutting += cut;
    clear += again == NOOK_OK;
    if (b.mesh.nt != 0 && again == NOOK_OK) tree_answers(d);
}

static void a_tree_refuses_exactly_what_would_cut_the_mesh(void) {
    dice d = {20261128u};
    uint32_t round, turn, what, rounds;
    for (what = 0; what < OPERATORS && !test_has_failed(); what++) {
        clear = cutting = 0;
        rounds = SMALL ? 3 : what == STITCH ? 1000 : 120;
        for (round = 0; round < rounds && !test_has_failed(); round++) {
            bool flat = begin_scene(&d, what);
            plant();
            for (turn = 0; turn < 6 && b.mesh.nt > 1 && !test_has_failed(); turn++) {
                attempt a = throw_attempt(&d, throw_dice(&d, 4) == 0 ? throw_dice(&d, OPERATORS) : what);
                throw_at(&d, &a, flat);
                keep();
                if (all_apart(&a)) judge_by_tree(&d, &a);
            }
        }
        CHECK(SMALL || (clear > 15 && (cutting > 15 || what >= CONDITIONED)));
    }
}

/* From one triangle to none and back; a second one beside it, through it, and a fourth on the first two. */
static void a_tree_follows_from_nothing_and_back(void) {
    static const uint8_t one[] = {0, 1, 2};
    static const float xy[] = {0, 0, 4, 0, 0, 4, 4, 4, 1, 1, 2, 2};
    static const uint32_t same[3] = {0, 1, 2}, third[3] = {2, 1, 3}, through[3] = {3, 4, 5};
    nook_overlap q;
    nook_view none = {0};
    uint32_t units = 100;
    draw(xy, 6, one, 1);
    CHECK_EQUAL(nook_guard_begin(&guard, &b.mesh, tree_boxes), NOOK_OK);
    CHECK_EQUAL(nook_split_triangle(&b.mesh, 0, b.mesh.G[4], &watched), NOOK_EMPTY_MESH); /* not fitted */
    plant();
    CHECK_EQUAL(nook_remove_triangle(&b.mesh, 0, &watched), NOOK_OK);
    CHECK_EQUAL(nook_overlap_begin(&q, &guard.bvh, b.mesh.G[0], b.mesh.G[0]), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, same, &watched), NOOK_OK);
    place(3, 4, 4, 1);
    place(4, 1, 1, -1);
    place(5, 2, 1, 1);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, through, &watched), NOOK_SELF_INTERSECTION);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, through, NULL), NOOK_OK);
    CHECK_EQUAL(nook_remove_triangle(&b.mesh, 1, &watched), NOOK_OK);
    CHECK_EQUAL(nook_make_triangle(&b.mesh, third, &watched), NOOK_OK);
    CHECK_EQUAL(nook_overlap_begin(NULL, &guard.bvh, b.mesh.G[0], b.mesh.G[0]), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_overlap_begin(&q, NULL, b.mesh.G[0], b.mesh.G[0]), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_overlap_begin(&q, &guard.bvh, b.mesh.G[0], b.mesh.G[0]), NOOK_OK);
    b.mesh.V[0] = b.mesh.V[3] = NOOK_STORED_NONE;
    CHECK_EQUAL(nook_overlap_step(&q, &units), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_guard_begin(NULL, &b.mesh, tree_boxes), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_guard_begin(&guard, NULL, tree_boxes), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_guard_begin(&guard, &b.mesh, NULL), NOOK_NULL_ARGUMENT);
    guard.bvh.view = none;
    CHECK_EQUAL(nook_bvh_refit(&guard.bvh, tree_boxes, NULL), NOOK_EMPTY_MESH);
}

static const test tests[] = {
    TEST(a_flip_is_done_exactly_if_both_new_triangles_face_the_quadrilateral),
    TEST(a_split_is_done_exactly_if_every_part_faces_what_it_is_cut_from),
    TEST(a_vertex_is_split_exactly_if_what_moves_and_what_fills_the_gap_face_their_way),
    TEST(an_edge_collapses_exactly_if_every_triangle_at_its_ends_faces_its_way),
    TEST(a_vertex_is_removed_or_a_triangle_made_exactly_if_the_triangle_has_area),
    TEST(edges_are_stitched_exactly_if_every_triangle_that_moves_faces_its_way),
    TEST(a_hole_is_filled_exactly_if_every_triangle_faces_its_way),
    TEST(a_convex_quadrilateral_can_be_flipped_and_a_concave_one_not),
    TEST(a_flip_may_turn_a_turned_triangle_back),
    TEST(a_last_place_decides_whether_a_flip_turns_a_triangle),
    TEST(a_vertex_of_a_flat_grid_can_be_taken_anywhere_within_its_star),
    TEST(a_fold_over_a_reflex_border_is_refused),
    TEST(a_right_angle_is_one_turn_too_many),
    TEST(a_triangle_without_area_can_be_edited_away),
    TEST(a_triangle_without_area_that_an_edit_leaves_alone_is_not_in_its_way),
    TEST(every_hole_of_a_flat_mesh_is_filled_by_ears_that_face_up),
    TEST(a_hole_of_three_edges_is_filled_if_it_has_area),
    TEST(a_hole_is_seen_along_the_axis_that_it_mostly_faces),
    TEST(no_vertex_comes_to_have_more_triangles_than_the_limit),
    TEST(a_limit_holds_for_the_new_vertex_of_a_split_as_well),
    TEST(attributes_stay_a_function_of_the_place),
    TEST(a_collapse_at_the_border_brings_every_corner_along),
    TEST(a_new_place_on_an_edge_has_the_same_attributes_on_both_sides),
    TEST(attributes_of_a_place_off_the_edge_are_of_the_nearest_on_it),
    TEST(a_made_triangle_takes_the_attributes_of_the_corners_it_meets),
    TEST(the_new_vertex_of_a_vertex_split_has_the_attributes_of_its_place),
    TEST(a_vertex_split_on_a_crease_changes_one_side),
    TEST(barycentric_coordinates_give_the_point_back_at_any_scale),
    TEST(barycentric_coordinates_of_no_area_are_a_third_each),
    TEST(a_client_of_the_callbacks_knows_everyone_after_thousands_of_edits),
    TEST(a_client_is_told_whose_copy_the_vertex_of_a_split_fan_is),
    TEST(a_tree_refuses_exactly_what_would_cut_the_mesh),
    TEST(a_tree_follows_from_nothing_and_back),
};

void test_conditions(void) { run_tests(tests, sizeof tests / sizeof *tests); }
