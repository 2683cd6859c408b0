/* orient.c -- every winding of small surfaces, any triangles at all, solids nested by the dice, and shells so close together
 * that they touch in every way there is.
 *
 * Triangles. The oracle spreads directions from triangle to triangle over a list of all pairs, until nothing changes, and takes
 * the majority. V must be what it says, to the bit; what is not orientable must be as it was.
 * Shells. Nested ones have their depth by construction. For tetrahedra of a small grid, which mostly meet, the oracle is of
 * integers and knows neither mesh nor tree: how much any two triangles have in common, from the line in which their planes meet
 * or, in one plane, from their corners and edges; and for every corner of a shell that is on no other, how often a segment
 * in a direction in general position crosses others. Proven as well: all those corners of a shell agree, which is what lets
 * nook_orient_shells ask one of them.
 * Spoiled. V, O, C, points, boxes, order, labels, volumes of any bits: an end, and no access outside (fences, AddressSanitizer).
 *
 * usage: orient [small] */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "nook.h"
#include "nook_port.h"
#include "prove.h"

enum { MOST_NT = 512, MOST_NV = 512, MOST_SHELLS = 64 };

static dice d = {1};
static uint32_t share = 1; /* of the work */

static nook_mesh mesh;
static nook_marks marks;
static nook_shells shells;
static nook_report report;
static nook_check_result result;
static nook_boxes *boxes;
static nook_index *order;

static void make_room(uint32_t nv, uint32_t nt) {
    drop_fences();
    marks.Mt = fenced(NOOK_MT_BYTES(nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    marks.max_nt = nt;
    marks.max_nv = nv;
    shells.component = fenced(nt * sizeof(nook_index));
    shells.stamp = fenced(nv * sizeof(nook_index));
    shells.shell = fenced(MOST_SHELLS * sizeof(nook_shell));
    shells.max_shells = MOST_SHELLS;
    boxes = fenced(NOOK_BVH_GROUPS(nt) * sizeof *boxes);
    order = fenced(nt * sizeof *order);
    CHECK_EQUAL(nook_mesh_init(&mesh, fenced(nv * sizeof(nook_point)), fenced(3 * nt * sizeof(nook_index)),
                               fenced(3 * nt * sizeof(nook_index)), fenced(nv * sizeof(nook_index)), nv, nt),
                NOOK_OK);
}

static void turn_over(nook_index *T) {
    nook_index keep = T[1];
    T[1] = T[2];
    T[2] = keep;
}

static void turn_round(nook_index *T) {
    nook_index keep = T[0];
    T[0] = T[1];
    T[1] = T[2];
    T[2] = keep;
}

/* ---- triangles: the oracle --------------------------------------------------------------------------- */

enum { MOST = 16 };
static struct {
    nook_index V[3 * MOST];        /* as it must become */
    uint32_t part[MOST];           /* the first triangle of what hangs together */
    bool against[MOST], odd[MOST]; /* of a first triangle: its part cannot be oriented */
    bool any_odd;
} known;

/* Which way triangle t runs v w: 1 from v to w, -1 back, 0 if it does not have both. */
static int run_of(uint32_t t, uint32_t v, uint32_t w) {
    const nook_index *T = mesh.V + 3 * t;
    uint32_t i;
    for (i = 0; i < 3; i++) {
        if (T[i] == v && T[(i + 1) % 3] == w) return 1;
        if (T[i] == w && T[(i + 1) % 3] == v) return -1;
    }
    return 0;
}

static uint32_t triangles_on(uint32_t v, uint32_t w) {
    uint32_t t, n = 0;
    for (t = 0; t < mesh.nt; t++) n += run_of(t, v, w) != 0;
    return n;
}

/* Triangles t and u over the i-th edge of t: 0 if it is not theirs alone, else whether they agree. */
static int bond(uint32_t t, uint32_t u, uint32_t i) {
    const nook_index *T = mesh.V + 3 * t;
    uint32_t v = T[i], w = T[(i + 1) % 3];
    int run = run_of(u, v, w);
    if (t == u || run == 0 || triangles_on(v, w) != 2) return 0;
    return -run;
}

/* One round over all pairs; whether anything changed. */
static bool spread(void) {
    uint32_t t, u, i;
    bool changed = false;
    for (t = 0; t < mesh.nt; t++) {
        for (u = 0; u < mesh.nt; u++) {
            for (i = 0; i < 3; i++) {
                int agree = bond(t, u, i);
                bool against = known.against[t] != (agree < 0);
                if (agree == 0 || known.part[t] > known.part[u]) continue;
                if (known.part[t] == known.part[u]) {
                    if (known.against[u] != against) known.odd[known.part[t]] = true;
                    continue;
                }
                known.part[u] = known.part[t];
                known.against[u] = against;
                changed = true;
            }
        }
    }
    return changed;
}

static void ask_oracle(void) {
    uint32_t t, u;
    memset(&known, 0, sizeof known);
    for (t = 0; t < mesh.nt; t++) known.part[t] = t;
    while (spread()) memset(known.odd, 0, sizeof known.odd);
    memcpy(known.V, mesh.V, 3 * mesh.nt * sizeof *known.V);
    for (t = 0; t < mesh.nt; t++) {
        int balance = 0;
        if (known.odd[t]) known.any_odd = true;
        for (u = 0; u < mesh.nt; u++) {
            if (known.part[u] == known.part[t]) balance += known.against[u] ? -1 : 1;
        }
        if (!known.odd[known.part[t]] && known.against[t] == (balance >= 0)) turn_over(known.V + 3 * t);
    }
}

static uint32_t told, cases, odd_cases;
static void hear(void *user, nook_status status, nook_where where) {
    (void)user, (void)where;
    told += status == NOOK_NOT_ORIENTABLE;
}
static const nook_finder listening = {hear, NULL};

static void try_triangles(void) {
    nook_where where;
    nook_status status;
    uint32_t t, odd = 0;
    ask_oracle();
    told = 0;
    status = nook_orient(&mesh, &marks, NULL, &listening, &where);
    cases++;
    odd_cases += known.any_odd;
    if (status != (known.any_odd ? NOOK_NOT_ORIENTABLE : NOOK_OK)) CHECK(false);
    if (memcmp(known.V, mesh.V, 3 * mesh.nt * sizeof *known.V) != 0) CHECK(false);
    for (t = 0; t < mesh.nt; t++) odd += known.odd[t];
    if (told != odd) CHECK_EQUAL(told, odd);
    if (!known.any_odd) return;
    t = nook_triangle(where.index);
    if (where.kind != NOOK_AT_CORNER || t >= mesh.nt) {
        CHECK(false);
        return;
    }
    for (odd = 0; !known.odd[odd]; odd++) continue;
    if (known.part[t] != odd) CHECK(false);
    if (triangles_on(mesh.V[nook_next(where.index)], mesh.V[nook_prev(where.index)]) != 2) CHECK(false);
}

static void every_winding_of_small_surfaces_is_oriented(void) {
    static const uint8_t tetrahedron[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                         strip[] = {0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1},
                         plane[] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1,
                                    1, 3, 4, 2, 4, 5, 3, 5, 1, 4, 1, 2, 5, 2, 3},
                         octahedron[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                         2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5},
                         torus[] = {0, 1, 3, 1, 2, 4, 2, 3, 5, 3, 4, 6, 4, 5, 0, 5, 6, 1, 6, 0, 2,
                                    0, 3, 2, 1, 4, 3, 2, 5, 4, 3, 6, 5, 4, 0, 6, 5, 1, 0, 6, 2, 1};
    static const struct {
        const uint8_t *list;
        uint32_t nv, nt;
    } surfaces[] = {{tetrahedron, 4, 4}, {strip, 5, 5}, {plane, 6, 10}, {octahedron, 6, 8}, {torus, 7, 14}};
    uint32_t i, bits, t, start = milliseconds();
    cases = odd_cases = 0;
    for (i = 0; i < 5; i++) {
        make_room(surfaces[i].nv, surfaces[i].nt);
        mesh.nv = surfaces[i].nv;
        mesh.nt = surfaces[i].nt;
        for (bits = 0; bits < 1u << mesh.nt && !test_has_failed(); bits += share) {
            for (t = 0; t < 3 * mesh.nt; t++) mesh.V[t] = surfaces[i].list[t];
            for (t = 0; t < mesh.nt; t++) {
                if (bits >> t & 1u) turn_over(mesh.V + 3 * t);
            }
            try_triangles();
        }
        CHECK(fences_hold());
    }
    CHECK(odd_cases > 0 && odd_cases < cases);
    print_figure("small surfaces", cases, "windings", start);
}

/* Any, or grown from a border edge of those before, so that there are surfaces among them. */
static void throw_triangle(uint32_t nv) {
    nook_index *T = mesh.V + 3 * mesh.nt;
    uint32_t tries, k;
    for (tries = 0; tries < 20 && mesh.nt != 0; tries++) {
        memcpy(T, mesh.V + 3 * throw_dice(&d, mesh.nt), 3 * sizeof *T);
        for (k = throw_dice(&d, 3); k > 0; k--) turn_round(T);
        T[2] = nook_store(throw_dice(&d, nv));
        if (triangles_on(T[0], T[1]) == 1 && T[2] != T[0] && T[2] != T[1]) break;
    }
    for (k = 3; (tries == 20 || mesh.nt == 0) && k > 0;) T[--k] = nook_store(throw_dice(&d, nv));
    if (T[0] != T[1] && T[1] != T[2] && T[2] != T[0]) mesh.nt++;
}

static void any_triangles_are_oriented(void) {
    uint32_t i, start = milliseconds();
    cases = odd_cases = 0;
    for (i = 0; i < 100000 / share && !test_has_failed(); i++) {
        uint32_t nt = 1 + throw_dice(&d, MOST), t;
        if (i % 64 == 0) make_room(9, MOST);
        mesh.nv = 3 + throw_dice(&d, 7);
        for (mesh.nt = 0; mesh.nt < nt;) throw_triangle(mesh.nv);
        for (t = 0; t < nt; t++) {
            if (throw_dice(&d, 2) != 0) turn_over(mesh.V + 3 * t);
        }
        try_triangles();
        if (i % 64 == 63) CHECK(fences_hold());
    }
    CHECK(odd_cases > 100 / share && odd_cases < cases);
    (void)printf("%u of them with a part that cannot be oriented\n", (unsigned)odd_cases);
    print_figure("random sets of triangles", cases, "sets", start);
}

/* ---- shells ------------------------------------------------------------------------------------------- */

static struct {
    nook_point at[MOST_SHELLS]; /* a corner of no other shell */
    bool cavity[MOST_SHELLS];
    uint32_t count;
} placed;

static uint32_t add_point(float x, float y, float z) {
    mesh.G[mesh.nv] = nook_make(x, y, z);
    return mesh.nv++;
}

static void add(uint32_t a, uint32_t b, uint32_t c) {
    nook_index *T = mesh.V + 3 * mesh.nt++;
    T[0] = nook_store(a);
    T[1] = nook_store(b);
    T[2] = nook_store(c);
}

static void place_shell(uint32_t first, bool cavity) {
    placed.at[placed.count] = mesh.G[first];
    placed.cavity[placed.count++] = cavity;
}

typedef struct cell {
    float low[3], high[3];
    uint32_t depth;
} cell;

static void add_box(const cell *c) {
    static const uint8_t list[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    uint32_t i, v = mesh.nv;
    for (i = 0; i < 8; i++)
        (void)add_point(i & 1 ? c->high[0] : c->low[0], i & 2 ? c->high[1] : c->low[1],
                        i & 4 ? c->high[2] : c->low[2]);
    for (i = 0; i < 36; i += 3) add(v + list[i], v + list[i + 1], v + list[i + 2]);
    place_shell(v, c->depth % 2 != 0);
}

static float along(const cell *c, uint32_t axis, float part) {
    return c->low[axis] + part * (c->high[axis] - c->low[axis]);
}

/* A double pyramid, or a sphere, whose corners lie within the cell. */
static void add_ball(const cell *c, uint32_t sides) {
    static const float circle[6][2] = {{0.96f, 0.5f}, {0.72f, 0.88f}, {0.28f, 0.88f},
                                       {0.04f, 0.5f}, {0.28f, 0.12f}, {0.72f, 0.12f}};
    uint32_t i, v = mesh.nv, step = 6 / sides;
    for (i = 0; i < sides; i++)
        (void)add_point(along(c, 0, circle[i * step][0]), along(c, 1, circle[i * step][1]),
                        along(c, 2, 0.5f));
    (void)add_point(along(c, 0, 0.5f), along(c, 1, 0.5f), c->high[2]);
    (void)add_point(along(c, 0, 0.5f), along(c, 1, 0.5f), c->low[2]);
    for (i = 0; i < sides; i++) {
        uint32_t j = (i + 1) % sides;
        add(v + i, v + j, v + sides);
        add(v + j, v + i, v + sides + 1);
    }
    place_shell(v, c->depth % 2 != 0);
}

/* A square frame whose hole is free: cells within its bars, and one in the hole, which is outside it. */
static void add_frame(const cell *c) {
    static const float at[4] = {0, 0.3f, 0.7f, 1};
    uint32_t i, j, v = mesh.nv;
    for (i = 0; i < 4; i++) { /* round the frame; four corners across each bar */
        bool x = i == 1 || i == 2, y = i > 1;
        for (j = 0; j < 4; j++) {
            uint32_t ring = j == 0 || j == 3 ? 0 : 1;
            (void)add_point(along(c, 0, x ? at[3 - ring] : at[ring]),
                            along(c, 1, y ? at[3 - ring] : at[ring]), j < 2 ? c->high[2] : c->low[2]);
        }
    }
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            uint32_t k = (i + 1) % 4, l = (j + 1) % 4;
            add(v + 4 * i + j, v + 4 * k + j, v + 4 * k + l);
            add(v + 4 * i + j, v + 4 * k + l, v + 4 * i + l);
        }
    }
    place_shell(v, c->depth % 2 != 0);
}

/* What is free of cell c is the part from low to high along each axis. */
static cell part_of(const cell *c, const float low[3], const float high[3], uint32_t depth) {
    cell part;
    uint32_t i;
    for (i = 0; i < 3; i++) part.low[i] = along(c, i, low[i]), part.high[i] = along(c, i, high[i]);
    part.depth = depth;
    return part;
}

/* Cells are cut in two, or given a shell and its inside, by the dice. */
static void nest(uint32_t shells_wanted) {
    static const float box_low[3] = {0.1f, 0.1f, 0.1f}, box_high[3] = {0.9f, 0.9f, 0.9f};
    static const float ball_low[3] = {0.38f, 0.38f, 0.38f}, ball_high[3] = {0.62f, 0.62f, 0.62f};
    static const float bar_low[3] = {0.05f, 0.1f, 0.1f}, bar_high[3] = {0.25f, 0.9f, 0.9f};
    static const float hole_low[3] = {0.35f, 0.35f, 0}, hole_high[3] = {0.65f, 0.65f, 1};
    static cell cells[4 * MOST_SHELLS];
    uint32_t count = 1;
    cell all = {{-1000, -1000, -1000}, {1000, 1000, 1000}, 0};
    cells[0] = all;
    placed.count = mesh.nv = mesh.nt = 0;
    while (placed.count < shells_wanted) {
        cell *c = &cells[throw_dice(&d, count)], was = *c;
        uint32_t axis = throw_dice(&d, 3);
        switch (throw_dice(&d, 5)) {
        case 0: /* the parts do not touch */
            if (count == 4 * MOST_SHELLS) continue;
            c->high[axis] = along(&was, axis, 0.45f);
            cells[count] = was;
            cells[count++].low[axis] = along(&was, axis, 0.55f);
            continue;
        case 1: add_ball(&was, 3); break;
        case 2: add_ball(&was, 6); break;
        case 3:
            if (count == 4 * MOST_SHELLS) continue;
            add_frame(&was);
            *c = part_of(&was, bar_low, bar_high, was.depth + 1);
            cells[count++] = part_of(&was, hole_low, hole_high, was.depth);
            continue;
        default:
            add_box(&was);
            *c = part_of(&was, box_low, box_high, was.depth + 1);
            continue;
        }
        *c = part_of(&was, ball_low, ball_high, was.depth + 1);
    }
}

/* Triangles in any order, turned, and each running either way. */
static void shuffle(void) {
    uint32_t t, u, k;
    for (t = mesh.nt; t > 0; t--) {
        nook_index *to = mesh.V + 3 * (t - 1), *from, keep[3];
        u = throw_dice(&d, t);
        from = mesh.V + 3 * u;
        memcpy(keep, to, sizeof keep);
        memmove(to, from, sizeof keep);
        memcpy(from, keep, sizeof keep);
    }
    for (t = 0; t < mesh.nt; t++) {
        nook_index *T = mesh.V + 3 * t;
        for (k = throw_dice(&d, 3); k > 0; k--) turn_round(T);
        if (throw_dice(&d, 2) != 0) turn_over(T);
    }
}

static void link_and_check(void) {
    nook_view view = nook_view_of(&mesh);
    CHECK_EQUAL(nook_link(&mesh, &marks, &shells, NULL, &report, NULL), NOOK_OK);
    CHECK_EQUAL(nook_check(&view, &marks, &report, &shells, NULL, &result), NOOK_OK);
}

static nook_status orient_all(nook_where *where) {
    nook_orient_shells_state state;
    nook_bvh bvh;
    nook_view view = nook_view_of(&mesh);
    nook_status status = nook_orient(&mesh, &marks, NULL, NULL, NULL);
    if (status != NOOK_OK) CHECK_EQUAL(status, NOOK_OK);
    link_and_check();
    if (nook_bvh_build(&bvh, &view, boxes, order, NULL) != NOOK_OK) CHECK(false);
    status = nook_orient_shells(&state, &mesh, &bvh, &shells, NULL, NULL);
    *where = state.where;
    return status;
}

static const nook_shell *shell_with(nook_point p) {
    uint32_t v;
    for (v = 0; mesh.G[v].x != p.x || mesh.G[v].y != p.y || mesh.G[v].z != p.z; v++) continue;
    return &shells.shell[shells.component[nook_triangle(mesh.C[v])]];
}

static void all_face_outward(void) {
    uint32_t k;
    link_and_check();
    if (shells.count != placed.count) CHECK_EQUAL(shells.count, placed.count);
    for (k = 0; k < placed.count; k++) {
        if (nook_volume_sign(&shell_with(placed.at[k])->volume) != (placed.cavity[k] ? -1 : 1)) CHECK(false);
    }
}

static void solids_nested_by_the_dice_face_outward(void) {
    uint32_t i, start = milliseconds(), total = 0, cavities = 0, k;
    nook_where where;
    for (i = 0; i < 10000 / share && !test_has_failed(); i++) {
        if (i % 64 == 0) make_room(MOST_NV, MOST_NT);
        nest(1 + throw_dice(&d, 16));
        shuffle();
        if (orient_all(&where) != NOOK_OK) CHECK(false);
        for (k = 0; k < placed.count; k++) cavities += placed.cavity[k];
        all_face_outward();
        total += placed.count;
        if (i % 64 == 63) CHECK(fences_hold());
    }
    (void)printf("%u shells, %u of them cavities\n", (unsigned)total, (unsigned)cavities);
    print_figure("nested solids", i, "solids", start);
}

/* ---- tetrahedra of a small grid ----------------------------------------------------------------------- */

__extension__ typedef __int128 wide;
typedef struct vector {
    int64_t x, y, z;
} vector;

static vector less(vector a, vector b) {
    vector c = {a.x - b.x, a.y - b.y, a.z - b.z};
    return c;
}

static vector across(vector a, vector b) {
    vector n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return n;
}

static int64_t dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vector normal_of(const vector t[3]) { return across(less(t[1], t[0]), less(t[2], t[0])); }
static bool same(vector a, vector b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

enum { MOST_T = 4 };
static struct {
    vector corner[MOST_T][4];
    uint32_t count;
} tetrahedra;

static void face_of(uint32_t k, uint32_t f, vector t[3]) {
    uint32_t i;
    for (i = 0; i < 3; i++) t[i] = tetrahedra.corner[k][(f + 1 + i) % 4];
}

static bool is_in(const vector t[3], vector p) {
    vector n = normal_of(t);
    uint32_t i;
    if (dot(n, less(p, t[0])) != 0) return false;
    for (i = 0; i < 3; i++) {
        if (dot(across(n, less(t[(i + 1) % 3], t[i])), less(p, t[i])) < 0) return false;
    }
    return true;
}

/* In one plane: edges that cross within both. */
static bool edges_cross(const vector t[3], const vector u[3], vector n) {
    uint32_t i, j;
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) {
            vector a = t[i], e = less(t[(i + 1) % 3], a), b = u[j], f = less(u[(j + 1) % 3], b);
            int64_t s0 = dot(n, across(e, less(b, a))), s1 = s0 + dot(n, across(e, f));
            int64_t r0 = dot(n, across(f, less(a, b))), r1 = r0 + dot(n, across(f, e));
            if (((s0 < 0 && s1 > 0) || (s0 > 0 && s1 < 0)) && ((r0 < 0 && r1 > 0) || (r0 > 0 && r1 < 0)))
                return true;
        }
    }
    return false;
}

/* Points x / w. */
typedef struct ratio {
    vector x;
    int64_t w;
} ratio;

/* Where the border of u is in a plane: none, one or two points. */
static uint32_t cut(const vector u[3], const int64_t h[3], ratio at[3]) {
    uint32_t i, n = 0;
    for (i = 0; i < 3; i++) {
        uint32_t j = (i + 1) % 3;
        if (h[i] == 0) {
            ratio p = {u[i], 1};
            at[n++] = p;
        }
        if ((h[i] < 0 && h[j] > 0) || (h[i] > 0 && h[j] < 0)) {
            int64_t w = h[i] > h[j] ? h[i] - h[j] : h[j] - h[i], p = h[i] < 0 ? -h[i] : h[i], q = w - p;
            ratio r = {{u[i].x * q + u[j].x * p, u[i].y * q + u[j].y * p, u[i].z * q + u[j].z * p}, w};
            at[n++] = r;
        }
    }
    return n;
}

/* How much of the segment from a to b, in the plane of t, is in t: nothing, a point, or more. */
static uint32_t clip(const vector t[3], ratio a, ratio b) {
    vector n = normal_of(t);
    wide low = 0, low_of = 1, high = 1, high_of = 1; /* parts of the way */
    uint32_t i;
    for (i = 0; i < 3; i++) {
        vector m = across(n, less(t[(i + 1) % 3], t[i]));
        wide f = (wide)(dot(m, a.x) - a.w * dot(m, t[i])) * b.w,
             g = (wide)(dot(m, b.x) - b.w * dot(m, t[i])) * a.w;
        if (f < 0 && g < 0) return 0;
        if (f < 0 && -f * low_of > low * (g - f)) low = -f, low_of = g - f;
        if (g < 0 && f * high_of < high * (f - g)) high = f, high_of = f - g;
    }
    if (low * high_of > high * low_of) return 0;
    return low * high_of == high * low_of ? 1 : 2;
}

static uint32_t common_corners(const vector t[3], const vector u[3]) {
    vector seen[6];
    uint32_t i, k, n = 0;
    for (i = 0; i < 6; i++) {
        vector p = i < 3 ? t[i] : u[i - 3];
        if (!is_in(i < 3 ? u : t, p)) continue;
        for (k = 0; k < n && !same(seen[k], p); k++) continue;
        if (k == n) seen[n++] = p;
    }
    return n;
}

/* What two triangles have in common: 0 nothing, 1 one point, a corner of one, 2 more or another point. */
static uint32_t common(const vector t[3], const vector u[3]) {
    vector n = normal_of(t);
    uint32_t i, ends, corners = common_corners(t, u), much;
    int64_t h[3];
    ratio at[3];
    for (i = 0; i < 3; i++) h[i] = dot(n, less(u[i], t[0]));
    if (h[0] == 0 && h[1] == 0 && h[2] == 0) return edges_cross(t, u, n) || corners > 1 ? 2 : corners;
    ends = cut(u, h, at);
    if (ends == 0) return 0;
    if (ends == 1) return is_in(t, at[0].x) ? 1 : 0;
    much = clip(t, at[0], at[1]);
    return much == 1 && corners == 0 ? 2 : much;
}

static uint32_t meeting_of(uint32_t k, uint32_t l) {
    vector t[3], u[3];
    uint32_t f, g, most = 0;
    for (f = 0; f < 4; f++) {
        for (g = 0; g < 4; g++) {
            uint32_t much;
            face_of(k, f, t);
            face_of(l, g, u);
            much = common(t, u);
            if (much > most) most = much;
        }
    }
    return most;
}

static int sign(int64_t x) { return (x > 0) - (x < 0); }
static int side(vector a, vector b, vector c, vector p) {
    return sign(dot(across(less(b, a), less(c, a)), less(p, a)));
}

/* How often the segment from p along a direction crosses triangle t; 2 if that is not in general position. */
static uint32_t crossings(const vector t[3], vector p, vector q) {
    int from = side(t[0], t[1], t[2], p), to = side(t[0], t[1], t[2], q);
    int a = side(p, q, t[0], t[1]), b = side(p, q, t[1], t[2]), c = side(p, q, t[2], t[0]);
    if (to == 0) return 2;
    if (from == 0 || from == to) return 0; /* p is not on it */
    return a == 0 || b == 0 || c == 0 ? 2 : a == b && b == c;
}

/* Whether p, on no other tetrahedron than its own k, lies in an odd number of others. */
static bool lies_within(uint32_t k, vector p) {
    static const vector directions[] = {
        {1009, 613, 389}, {-877, 1013, 571}, {419, -997, 761}, {-653, -439, 1021}, {983, 331, -701}};
    uint32_t way, l, f, n;
    for (way = 0; way < 5; way++) {
        vector q = {p.x + directions[way].x, p.y + directions[way].y, p.z + directions[way].z}, t[3];
        uint32_t odd = 0;
        bool general = true;
        for (l = 0; l < tetrahedra.count; l++) {
            for (f = 0; f < 4 && l != k; f++) {
                face_of(l, f, t);
                n = crossings(t, p, q);
                general = general && n != 2;
                odd ^= n & 1u;
            }
        }
        if (general) return odd != 0;
    }
    CHECK(false);
    return false;
}

static bool is_on_another(uint32_t k, vector p) {
    uint32_t l, f;
    vector t[3];
    for (l = 0; l < tetrahedra.count; l++) {
        for (f = 0; f < 4 && l != k; f++) {
            face_of(l, f, t);
            if (is_in(t, p)) return true;
        }
    }
    return false;
}

/* Whether some corner of tetrahedron k tells where it is; all that do must agree. */
static bool is_known(uint32_t k) {
    uint32_t i;
    bool some = false;
    for (i = 0; i < 4; i++) {
        vector p = tetrahedra.corner[k][i];
        bool within;
        if (is_on_another(k, p)) continue;
        within = lies_within(k, p);
        if (some && within != placed.cavity[k]) CHECK(false);
        placed.at[k] = nook_make((float)p.x, (float)p.y, (float)p.z);
        placed.cavity[k] = within;
        some = true;
    }
    return some;
}

static void throw_tetrahedra(uint32_t sides) {
    uint32_t k, i;
    tetrahedra.count = 2 + throw_dice(&d, MOST_T - 1);
    for (k = 0; k < tetrahedra.count; k++) {
        vector *p = tetrahedra.corner[k];
        do {
            for (i = 0; i < 4; i++) {
                p[i].x = throw_dice(&d, sides), p[i].y = throw_dice(&d, sides),
                p[i].z = throw_dice(&d, sides);
            }
        } while (side(p[0], p[1], p[2], p[3]) == 0);
    }
}

static void take_tetrahedra(void) {
    uint32_t k, i, v;
    mesh.nv = mesh.nt = 0;
    for (k = 0; k < tetrahedra.count; k++) {
        const vector *p = tetrahedra.corner[k];
        for (i = 0; i < 4; i++) (void)add_point((float)p[i].x, (float)p[i].y, (float)p[i].z);
        v = 4 * k;
        add(v, v + 2, v + 1);
        add(v, v + 1, v + 3);
        add(v + 1, v + 2, v + 3);
        add(v + 2, v, v + 3);
    }
}

static uint32_t shared_corners(uint32_t k, uint32_t l) {
    uint32_t i, j, n = 0;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) n += same(tetrahedra.corner[k][i], tetrahedra.corner[l][j]);
    }
    return n;
}

enum { APART, TOUCH, CROSS, SHARE_AN_EDGE, ALL_ON_OTHERS, KINDS };

static uint32_t kind_of(bool welded) {
    uint32_t k, l, kind = APART;
    for (k = 0; k < tetrahedra.count; k++) {
        for (l = 0; l < k; l++) {
            uint32_t much = meeting_of(k, l);
            if (welded && shared_corners(k, l) > 1) return SHARE_AN_EDGE;
            if (much == 2) kind = CROSS;
            if (much == 1 && kind == APART) kind = TOUCH;
        }
    }
    return kind;
}

static void try_tetrahedra(bool welded, uint32_t counts[KINDS]) {
    static nook_index map[4 * MOST_T], scratch[NOOK_WELD_SCRATCH(4 * MOST_T)];
    nook_status expected = NOOK_OK, status;
    nook_where where;
    uint32_t kind, k;
    take_tetrahedra();
    shuffle();
    if (welded && nook_weld(&mesh, map, scratch, NULL) != NOOK_OK) CHECK(false);
    kind = kind_of(welded);
    placed.count = tetrahedra.count;
    for (k = 0; k < placed.count && kind < CROSS; k++) {
        if (!is_known(k)) kind = ALL_ON_OTHERS;
    }
    counts[kind]++;
    if (kind == SHARE_AN_EDGE) expected = NOOK_NONMANIFOLD_EDGE;
    if (kind == CROSS || kind == ALL_ON_OTHERS) expected = NOOK_SELF_INTERSECTION;
    status = orient_all(&where);
    if (status != expected) CHECK_EQUAL(status, expected);
    if (status == NOOK_OK && expected == NOOK_OK) all_face_outward();
    if (status != NOOK_OK && (where.kind != NOOK_AT_TRIANGLE || where.index >= mesh.nt)) CHECK(false);
}

static void tetrahedra_that_may_touch_face_outward_or_are_refused(void) {
    static const char *const names[KINDS] = {"apart", "touching", "crossing", "with a common edge",
                                             "with all corners on others"};
    uint32_t i, k, start = milliseconds(), counts[KINDS] = {0};
    for (i = 0; i < 200000 / share && !test_has_failed(); i++) {
        if (i % 64 == 0) make_room(4 * MOST_T, 4 * MOST_T);
        throw_tetrahedra(3 + throw_dice(&d, 8));
        try_tetrahedra(i % 2 != 0, counts);
        if (i % 64 == 63) CHECK(fences_hold());
    }
    for (k = 0; k < KINDS; k++) (void)printf("%u %s\n", (unsigned)counts[k], names[k]);
    CHECK(counts[APART] > 4000 / share && counts[TOUCH] > 4000 / share && counts[CROSS] > 4000 / share);
    print_figure("sets of 2 to 4 tetrahedra of a small grid", i, "sets", start);
}

/* ---- spoiled ------------------------------------------------------------------------------------------- */

static void spoil(void *bytes, size_t size) {
    uint8_t *at = bytes;
    uint32_t n;
    for (n = throw_dice(&d, 3); n > 0; n--) at[throw_dice(&d, (uint32_t)size)] = (uint8_t)throw_dice(&d, 256);
}

static void spoil_index(nook_index *of, uint32_t n, uint32_t limit) {
    uint32_t k;
    for (k = throw_dice(&d, 3); k > 0; k--) of[throw_dice(&d, n)] = nook_store(throw_dice(&d, limit + 2));
}

/* In arrays that end where the tables end. */
static void nest_exactly(uint32_t shells_wanted) {
    static nook_point G[MOST_NV];
    static nook_index V[3 * MOST_NT];
    uint32_t nv, nt;
    make_room(MOST_NV, MOST_NT);
    nest(shells_wanted);
    nv = mesh.nv;
    nt = mesh.nt;
    memcpy(G, mesh.G, nv * sizeof *G);
    memcpy(V, mesh.V, 3 * nt * sizeof *V);
    make_room(nv, nt);
    memcpy(mesh.G, G, nv * sizeof *G);
    memcpy(mesh.V, V, 3 * nt * sizeof *V);
    mesh.nv = nv;
    mesh.nt = nt;
}

static void spoiled_tables_end(void) {
    uint32_t i, k, start = milliseconds(), heard[NOOK_STATUS_COUNT] = {0};
    for (i = 0; i < 60000 / share && !test_has_failed(); i++) {
        nook_orient_shells_state state;
        nook_bvh bvh;
        nook_view view;
        nook_status status;
        uint32_t used = 0;
        nest_exactly(1 + throw_dice(&d, 4));
        link_and_check();
        view = nook_view_of(&mesh);
        if (nook_bvh_build(&bvh, &view, boxes, order, NULL) != NOOK_OK) CHECK(false);
        if (i % 2) spoil(boxes, (size_t)NOOK_BVH_GROUPS(mesh.nt) * sizeof *boxes);
        if (i % 3) spoil_index(order, mesh.nt, mesh.nt);
        if (i % 5 == 0) spoil_index(mesh.V, 3 * mesh.nt, mesh.nv);
        if (i % 7 == 0) spoil_index(mesh.O, 3 * mesh.nt, 3 * mesh.nt);
        if (i % 11 == 0) spoil_index(mesh.C, mesh.nv, 3 * mesh.nt);
        if (i % 4 == 0) spoil_index(shells.component, mesh.nt, shells.count);
        if (i % 13 == 0) spoil(mesh.G, mesh.nv * sizeof *mesh.G);
        if (i % 17 == 0) spoil(&shells.shell->volume, sizeof shells.shell->volume);
        if (i % 19 == 0) spoil(&shells.shell->first_triangle, sizeof shells.shell->first_triangle);
        CHECK_EQUAL(nook_orient_shells_begin(&state, i % 9 ? &mesh : NULL, &bvh, &shells, NULL, NULL),
                    NOOK_OK);
        do {
            uint32_t units = 1 + throw_dice(&d, 100);
            used += units;
            status = nook_orient_shells_step(&state, &units);
        } while (status == NOOK_MORE && used < mesh.nt * mesh.nt * 2 + 1000);
        if (status == NOOK_MORE) CHECK(false);
        heard[status]++;
        CHECK(fences_hold());
    }
    for (k = 0; k < NOOK_STATUS_COUNT; k++) {
        if (heard[k] != 0) (void)printf("%u %s\n", (unsigned)heard[k], nook_status_name((nook_status)k));
    }
    drop_fences();
    print_figure("spoiled tables", i, "tables", start);
}

int main(int argc, char **argv) {
    static const test tests[] = {
        TEST(every_winding_of_small_surfaces_is_oriented),
        TEST(any_triangles_are_oriented),
        TEST(solids_nested_by_the_dice_face_outward),
        TEST(tetrahedra_that_may_touch_face_outward_or_are_refused),
        TEST(spoiled_tables_end),
    };
    if (argc > 1 && strcmp(argv[1], "small") == 0) share = 11;
    make_room(MOST_NV, MOST_NT);
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
