/* spoiled.c -- the rooms walk and edit, and smoothing, on tables that hold any bits.
 *
 *   one triangle   all 125 O over the corners, the first number beyond them and all bits set, on 8 V, with every C,
 *                  every kind of edit and of points, and every room
 *   two            all 262,144 such O on 10 V; C, edit, points and room go round
 *   sound meshes   a tetrahedron, an octahedron, a disk, a torus of 7 vertices, two fans at one vertex: every entry of
 *                  V, O and C replaced by every other value up to the first beyond and by all bits; two and three
 *                  entries at random; and long series of random edits on what is left after one to three faults
 *
 * Each is given to every function of walk and to nook_smooth, in arrays that end where the tables end, and to every operator of edit
 * with every argument, in arrays with room for nothing, for one or two elements, and for more. Proven for each call:
 *   it returns; iterators give no more, and steps take no more, than their headers state
 *   nothing is written beyond an array (fences), and nothing read (AddressSanitizer)
 *   corners, half-edges and triangles that walk gives exist
 *   an edit that refuses has changed no byte of the mesh, of colors and attributes, and told nobody of a change;
 *   only the unused ends of the arrays may differ
 *   an edit is not carried out at a triangle whose own entries of V and O do not hold
 * C is right, or names nothing, corners that do not exist, or those of another vertex. Edits ask for nothing, or for
 * no turn, at most 5 triangles at a vertex, colors and attributes. Points are ordinary, or NaN, infinite and huge.
 *
 * usage: spoiled [small | large]. `small`, for sanitizers, takes one in 13 of the tables of two triangles and fewer
 * faults; `large` tries each O of two triangles with every C and every kind of edit, 32 times as many. */
#include <stdio.h>
#include <string.h>

#include "bounds.h"
#include "check.h"
#include "nook.h"
#include "nook_port.h"
#include "prove.h"

enum { MORE_NT = 8, MORE_NV = 2, MOST_NT = 14 + MORE_NT, MOST_NC = 3 * MOST_NT, MOST_NV = 16, WIDTH = 2 };

static dice d = {2463534242u};

/* ---- what is tried --------------------------------------------------------------------------------- */

/* The tables as they are before a call. */
static struct {
    uint32_t nv, nt;
    nook_point G[MOST_NV];
    nook_index V[MOST_NC], O[MOST_NC], C[MOST_NV];
    uint8_t color[MOST_NT];
    float attributes[MOST_NC * WIDTH];
} spoiled;

typedef enum kind_of_C { C_RIGHT, C_NONE, C_OUTSIDE, C_OF_ANOTHER, KINDS_OF_C } kind_of_C;
enum { NO_TURN = 1, LIMIT = 2, DATA = 4, KINDS_OF_EDIT = 8 };

static struct {
    kind_of_C C;
    uint32_t edit; /* of the above; 0: no edit is given */
    bool odd;      /* points */
    uint32_t room;
} with;

/* The call that is under way. */
static struct {
    const char *name;
    uint32_t argument[3];
} call;

static void begin_call(const char *name, uint32_t a, uint32_t b, uint32_t c) {
    call.name = name;
    call.argument[0] = a;
    call.argument[1] = b;
    call.argument[2] = c;
}

static uint32_t nc(void) { return 3 * spoiled.nt; }

static void say_list(const char *name, const nook_index *list, uint32_t n) {
    uint32_t i;
    print_text(name);
    for (i = 0; i < n; i++) (void)printf(" %u", (unsigned)list[i]);
}

static void say_case(void) {
    (void)printf("  %s(%u, %u, %u) on %u vertices, V", call.name, (unsigned)call.argument[0],
                 (unsigned)call.argument[1], (unsigned)call.argument[2], (unsigned)spoiled.nv);
    say_list("", spoiled.V, nc());
    say_list(", O", spoiled.O, nc());
    say_list(", C", spoiled.C, spoiled.nv);
    (void)printf(", edit %u, %s points, room %u\n", (unsigned)with.edit, with.odd ? "odd" : "plain",
                 (unsigned)with.room);
}

/* Says it of the first case of a test; the others are seldom news. */
static void expect(bool holds, const char *text, int line) {
    if (holds || test_has_failed()) return;
    (void)check_true(false, text, __FILE__, line);
    say_case();
}
#define EXPECT(condition) expect((condition), #condition, __LINE__)

/* ---- memory ---------------------------------------------------------------------------------------- */

/* Arrays for a mesh and what edits take along. Those of the first room end where the tables end. */
typedef struct room {
    nook_mesh mesh;
    uint8_t *color;
    float *attributes;
} room;

typedef struct room_more {
    uint8_t vertices, triangles;
} room_more;
enum { ROOMS = 4 };
static const room_more small_rooms[ROOMS] = {{0, 0}, {1, 1}, {1, 2}, {2, 3}},
                       large_rooms[ROOMS] = {{0, 0}, {2, 3}, {1, 6}, {MORE_NV, MORE_NT}};

static room rooms[ROOMS], *here;
static nook_view view;
static nook_marks marks;
static nook_index *of_triangles, *queue_of_triangles, *queue_of_vertices;
static float *of_corners, *of_vertices;

static void make_room(room *r, uint32_t max_nv, uint32_t max_nt) {
    nook_point *G = fenced(max_nv * sizeof *G);
    nook_index *V = fenced(3 * max_nt * sizeof *V), *O = fenced(3 * max_nt * sizeof *O),
               *C = fenced(max_nv * sizeof *C);
    CHECK_EQUAL(nook_mesh_init(&r->mesh, G, V, O, C, max_nv, max_nt), NOOK_OK);
    r->color = fenced(max_nt);
    r->attributes = fenced((size_t)3 * max_nt * WIDTH * sizeof *r->attributes);
}

static void begin_tables(uint32_t nv, uint32_t nt, const room_more *more) {
    uint32_t i;
    CHECK(nv + MORE_NV <= MOST_NV && nt + MORE_NT <= MOST_NT);
    spoiled.nv = nv;
    spoiled.nt = nt;
    for (i = 0; i < ROOMS; i++) make_room(&rooms[i], nv + more[i].vertices, nt + more[i].triangles);
    rooms[0].mesh.nv = nv;
    rooms[0].mesh.nt = nt;
    view = nook_view_of(&rooms[0].mesh);
    marks.Mt = fenced(NOOK_MT_BYTES(nt));
    marks.Mv = fenced(NOOK_MV_BYTES(nv));
    marks.max_nt = nt;
    marks.max_nv = nv;
    of_triangles = fenced(nt * sizeof *of_triangles);
    queue_of_triangles = fenced(nt * sizeof *queue_of_triangles);
    queue_of_vertices = fenced(nv * sizeof *queue_of_vertices);
    of_corners = fenced((size_t)9 * nt * sizeof *of_corners);
    of_vertices = fenced(nv * sizeof *of_vertices);
}

/* ---- points, C, edits ------------------------------------------------------------------------------ */

static nook_point point(uint32_t v) {
    static const uint32_t odd[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x7F7FFFFFu,
                                   1u,          0xFFFFFFFFu, 0x4E800000u};
    enum { ODD = sizeof odd / sizeof *odd };
    if (!with.odd) return nook_make((float)v, (float)(v * v % 7), (float)(v * v * v % 11));
    return nook_make(nook_float_from(odd[v % ODD]), nook_float_from(odd[v / 2 % ODD]), (float)v);
}

static void set_points(void) {
    uint32_t v;
    for (v = 0; v < spoiled.nv; v++) spoiled.G[v] = point(v);
}

static void set_C(void) {
    uint32_t c, v;
    for (v = 0; v < spoiled.nv; v++) {
        uint32_t outside = v % 2 == 0 ? nc() : NOOK_NONE - 1u;
        spoiled.C[v] = with.C == C_OUTSIDE ? nook_store(outside) : NOOK_STORED_NONE;
    }
    for (c = 0; c < nc() && (with.C == C_RIGHT || with.C == C_OF_ANOTHER); c++) {
        v = with.C == C_RIGHT || spoiled.nv == 1 ? spoiled.V[c] : (spoiled.V[c] + 1u) % spoiled.nv;
        if (spoiled.V[c] < spoiled.nv) spoiled.C[v] = nook_store(c);
    }
}

static uint32_t told; /* by an edit, of what it has changed */

static void hear_renamed(void *user, nook_kind kind, uint32_t from, uint32_t to) {
    const nook_mesh *m = user;
    uint32_t most = kind == NOOK_AT_VERTEX ? m->max_nv : m->max_nt;
    told++;
    EXPECT((kind == NOOK_AT_VERTEX || kind == NOOK_AT_TRIANGLE) && from < most && to < most);
}
static void hear_copied(void *user, uint32_t from, uint32_t to) {
    const nook_mesh *m = user;
    told++;
    EXPECT(from < m->max_nv && to < m->max_nv);
}

static nook_edit conditions;
static const nook_edit *edit;

static void set_edit(void) {
    here = &rooms[with.room];
    conditions.no_turn = (with.edit & NO_TURN) != 0;
    conditions.max_valence = (with.edit & LIMIT) != 0 ? 5 : 0;
    conditions.color = (with.edit & DATA) != 0 ? here->color : NULL;
    conditions.attributes = (with.edit & DATA) != 0 ? here->attributes : NULL;
    conditions.width = WIDTH;
    conditions.renamed = hear_renamed;
    conditions.copied = hear_copied;
    conditions.user = &here->mesh;
    edit = with.edit != 0 ? &conditions : NULL;
}

static void set_data(void) {
    uint32_t i;
    for (i = 0; i < MOST_NT; i++) spoiled.color[i] = (uint8_t)(i % 3);
    for (i = 0; i < MOST_NC * WIDTH; i++) spoiled.attributes[i] = (float)(i % 5);
}

/* ---- the mesh in its room -------------------------------------------------------------------------- */

/* The unused ends hold what would do as tables, too. */
static void fill_ends(nook_mesh *m) {
    uint32_t i;
    for (i = nc(); i < 3 * m->max_nt; i++) {
        m->V[i] = nook_store(i % m->max_nv);
        m->O[i] = nook_store(i - nc());
    }
    for (i = spoiled.nv; i < m->max_nv; i++) m->C[i] = 0;
}

static void load(room *r) {
    nook_mesh *m = &r->mesh;
    m->nv = spoiled.nv;
    m->nt = spoiled.nt;
    memcpy(m->G, spoiled.G, spoiled.nv * sizeof *m->G);
    memcpy(m->C, spoiled.C, spoiled.nv * sizeof *m->C);
    memcpy(m->V, spoiled.V, nc() * sizeof *m->V);
    memcpy(m->O, spoiled.O, nc() * sizeof *m->O);
    fill_ends(m);
    if ((with.edit & DATA) == 0) return;
    memcpy(r->color, spoiled.color, m->max_nt);
    memcpy(r->attributes, spoiled.attributes, (size_t)3 * m->max_nt * WIDTH * sizeof *r->attributes);
}

/* What an edit has made becomes what the next begins with. */
static void take_over(void) {
    const nook_mesh *m = &here->mesh;
    spoiled.nv = m->nv;
    spoiled.nt = m->nt;
    memcpy(spoiled.G, m->G, spoiled.nv * sizeof *m->G);
    memcpy(spoiled.C, m->C, spoiled.nv * sizeof *m->C);
    memcpy(spoiled.V, m->V, nc() * sizeof *m->V);
    memcpy(spoiled.O, m->O, nc() * sizeof *m->O);
    if ((with.edit & DATA) == 0) return;
    memcpy(spoiled.color, here->color, spoiled.nt);
    memcpy(spoiled.attributes, here->attributes, nc() * WIDTH * sizeof *here->attributes);
}

static bool data_is_as_before(void) {
    return (with.edit & DATA) == 0 ||
           (memcmp(here->color, spoiled.color, spoiled.nt) == 0 &&
            memcmp(here->attributes, spoiled.attributes, nc() * WIDTH * sizeof *here->attributes) == 0);
}

static bool is_as_before(const room *r) {
    const nook_mesh *m = &r->mesh;
    return m->nv == spoiled.nv && m->nt == spoiled.nt && memcmp(m->V, spoiled.V, nc() * sizeof *m->V) == 0 &&
           memcmp(m->O, spoiled.O, nc() * sizeof *m->O) == 0 &&
           memcmp(m->C, spoiled.C, spoiled.nv * sizeof *m->C) == 0 &&
           memcmp(m->G, spoiled.G, spoiled.nv * sizeof *m->G) == 0;
}

/* ---- walk: stars, borders, relations, half-edges --------------------------------------------------- */

static uint32_t end_of(nook_kind kind) {
    return kind == NOOK_AT_VERTEX ? spoiled.nv : kind == NOOK_AT_CORNER ? nc() : spoiled.nt;
}

/* Every element, the first that does not exist, none, and for triangles one whose corners wrap round. */
static uint32_t arguments(nook_kind kind) { return end_of(kind) + 3u; }
static uint32_t argument(nook_kind kind, uint32_t i) {
    uint32_t beyond = i - end_of(kind);
    return i <= end_of(kind) ? i : beyond == 1 ? NOOK_NONE : 0x55555556u;
}

static bool exists(uint32_t element, uint32_t end) { return element == NOOK_NONE || element < end; }

static uint32_t walk_star(uint32_t c, bool clockwise) {
    nook_star star;
    uint32_t n = 0, x;
    nook_status status = nook_star_begin(&star, &view, c, clockwise);
    if (c >= nc()) EXPECT(status == NOOK_INDEX_OUT_OF_RANGE);
    EXPECT(status == NOOK_OK || status == NOOK_BAD_OPPOSITE || c >= nc());
    for (x = nook_star_next(&star); x != NOOK_NONE && n <= spoiled.nt; x = nook_star_next(&star), n++) {
        EXPECT(status == NOOK_OK && x < nc() && view.V[x] == view.V[c]);
    }
    EXPECT(n <= spoiled.nt);
    return n;
}

static void try_stars(void) {
    uint32_t i, forward;
    for (i = 0; i < arguments(NOOK_AT_CORNER); i++) {
        uint32_t c = argument(NOOK_AT_CORNER, i);
        begin_call("nook_star", c, 0, 0);
        (void)walk_star(c, false);
        EXPECT(nook_valence(&view, c) == walk_star(c, true));
        begin_call("nook_border_next", c, 0, 0);
        for (forward = 0; forward < 2; forward++) {
            uint32_t x = nook_border_next(&view, c, forward != 0);
            EXPECT(x == NOOK_NONE || (x < nc() && view.O[x] == x));
        }
        EXPECT(nook_border_length(&view, c) <= nc());
    }
}

/* Lists about a vertex have no fixed length. */
typedef struct relation_kind {
    nook_kind of, gives;
    uint8_t length;
} relation_kind;
static const relation_kind relation_kinds[] = {
    {NOOK_AT_VERTEX, NOOK_AT_VERTEX, 0},    {NOOK_AT_VERTEX, NOOK_AT_CORNER, 0},
    {NOOK_AT_VERTEX, NOOK_AT_TRIANGLE, 0},  {NOOK_AT_CORNER, NOOK_AT_VERTEX, 2},
    {NOOK_AT_CORNER, NOOK_AT_CORNER, 4},    {NOOK_AT_CORNER, NOOK_AT_TRIANGLE, 2},
    {NOOK_AT_TRIANGLE, NOOK_AT_VERTEX, 3},  {NOOK_AT_TRIANGLE, NOOK_AT_CORNER, 3},
    {NOOK_AT_TRIANGLE, NOOK_AT_TRIANGLE, 3}};

static void walk_relation(uint32_t relation, uint32_t element) {
    const relation_kind *kind = &relation_kinds[relation];
    uint32_t n = 0, x,
             most = kind->length != 0 ? kind->length : spoiled.nt + (kind->gives != NOOK_AT_TRIANGLE);
    nook_related list;
    nook_status status = nook_related_begin(&list, &view, (nook_relation)relation, element);
    if (element >= end_of(kind->of)) EXPECT(status == NOOK_INDEX_OUT_OF_RANGE);
    if (status != NOOK_OK) return;
    for (; n <= most && nook_related_next(&list, &x); n++) {
        EXPECT(kind->gives == NOOK_AT_VERTEX || exists(x, end_of(kind->gives)));
    }
    EXPECT(kind->length != 0 ? n == most : n <= most);
}

static void try_relations(uint32_t first, uint32_t end) {
    uint32_t relation, i;
    for (relation = first; relation < end; relation++) {
        nook_kind of = relation_kinds[relation].of;
        for (i = 0; i < arguments(of); i++) {
            begin_call("nook_related", relation, argument(of, i), 0);
            walk_relation(relation, argument(of, i));
        }
    }
}

static void try_halfedges(void) {
    static uint32_t (*const turns[])(const nook_view *, uint32_t) = {
        nook_next_halfedge, nook_prev_halfedge, nook_onext, nook_oprev,
        nook_dnext,         nook_dprev,         nook_rnext, nook_rprev};
    uint32_t h, i, end = 2 * nc();
    for (h = 0; h < end; h++) {
        begin_call("half-edge", h, 0, 0);
        for (i = 0; i < sizeof turns / sizeof *turns; i++) EXPECT(exists(turns[i](&view, h), end));
        EXPECT(exists(nook_halfedge_corner(&view, h), nc()));
        EXPECT(exists(nook_left_face(&view, h), spoiled.nt) && exists(nook_right_face(&view, h), spoiled.nt));
        EXPECT(nook_origin(&view, h) == nook_target(&view, nook_pair(h)));
        EXPECT(nook_halfedge(&view, h / 2) < end);
    }
    EXPECT(!nook_is_halfedge(&view, end) && !nook_is_halfedge(&view, NOOK_NONE));
}

static void try_corners_of_vertices(void) {
    uint32_t v, c, n;
    for (v = 0; v < spoiled.nv; v++) {
        begin_call("nook_halfedge_of_vertex", v, 0, 0);
        EXPECT(exists(nook_halfedge_of_vertex(&view, v), 2 * nc()));
        begin_call("nook_corner_after", v, 0, 0);
        c = nook_corner_after(&view, v, NOOK_NONE);
        for (n = 0; c != NOOK_NONE && n < nc(); n++, c = nook_corner_after(&view, v, c))
            EXPECT(view.V[c] == v);
        EXPECT(c == NOOK_NONE);
    }
}

/* ---- steps ----------------------------------------------------------------------------------------- */

/* nook_flood.h: 3 nt hops, 1 a component, 1 for every triangle tried as a root, and the bytes of marks; */
static uint32_t flood_bound(void) { return 5 * spoiled.nt + (uint32_t)NOOK_MT_BYTES(spoiled.nt); }
/* nt for clearing and 1 a triangle; */
static uint32_t rings_bound(void) { return 2 * spoiled.nt; }
/* 9 nt where O holds other bits, and less than 6 nt log2 nt more, rounded up. */
static uint32_t components_bound(void) { return (9 + 6 * log2_rounded_up(spoiled.nt)) * spoiled.nt; }

/* nook_neighborhood.h: the bytes of marks, 3 nt + nv. */
static uint32_t neighborhood_bound(void) {
    return (uint32_t)(NOOK_MT_BYTES(spoiled.nt) + NOOK_MV_BYTES(spoiled.nv)) + nc() + spoiled.nv;
}

/* nook_trees.h: 7 nt, and nv or the bytes of marks; of a loop 2 nv, and one to find that it is none. */
static uint32_t trees_bound(void) {
    uint32_t mt = (uint32_t)NOOK_MT_BYTES(spoiled.nt);
    return 7 * spoiled.nt + (mt > spoiled.nv ? mt : spoiled.nv);
}
static uint32_t loop_bound(void) { return 2 * spoiled.nv + 1; }

/* nook_normals.h: 6 nt. */
static uint32_t creases_bound(void) { return 6 * spoiled.nt; }

/* nook_smooth.h: nv + 2 nt + 3; a pass 6 nv + 6, and for each axis at most nv + 1 sweeps of nt + 1. */
static uint32_t smooth_bound(uint32_t passes) {
    uint32_t nv = spoiled.nv, nt = spoiled.nt;
    return nv + 2 * nt + 3 + passes * (6 * nv + 6 + 3 * (nv + 1) * (nt + 1));
}

/* nook_whole.h: less than 13 nt + nv / 4 + 8. */
static uint32_t split_fans_bound(void) { return 13 * spoiled.nt + spoiled.nv / 4 + 7; }

/* nook_fill.h: for L edges less than 10 L; with ears L (L - 1) and half of L^3 more; with a limit (3 L)^2 more. */
static uint32_t fill_bound(uint32_t L, nook_fill_way way) {
    return 10 * L - 1 + (way == NOOK_FILL_EARS ? L * (L - 1) + L * L * L / 2 : 0) +
           ((with.edit & LIMIT) != 0 ? 9 * L * L : 0);
}

static uint32_t bound, units; /* the most steps, and what is left of one more */
static void begin_steps(uint32_t most) {
    bound = most;
    units = most + 1;
}
static uint32_t steps_taken(void) { return bound + 1 - units; }

/* ---- walk: searches -------------------------------------------------------------------------------- */

static void run_flood(uint32_t seed) {
    nook_flood flood;
    nook_status status = nook_flood_begin(&flood, &view, &marks, seed);
    uint32_t entered = 0, shown = 0, v[3];
    EXPECT(status == (exists(seed, spoiled.nt) ? NOOK_OK : NOOK_INDEX_OUT_OF_RANGE));
    if (status != NOOK_OK) return;
    memset(marks.Mv, 0, NOOK_MV_BYTES(spoiled.nv));
    begin_steps(flood_bound());
    while ((status = nook_flood_step(&flood, &units)) == NOOK_TRIANGLE) {
        entered++;
        EXPECT(flood.corner < nc() && flood.component < spoiled.nt);
        shown += nook_flood_new_vertices(&flood, marks.Mv, v);
    }
    EXPECT(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    EXPECT(steps_taken() <= bound && entered <= spoiled.nt && shown <= spoiled.nv);
}

static void run_rings(uint32_t seed) {
    nook_rings rings;
    nook_status status = nook_rings_begin(&rings, &view, seed, of_triangles, queue_of_triangles);
    uint32_t i;
    EXPECT(status == (seed < spoiled.nt ? NOOK_OK : NOOK_INDEX_OUT_OF_RANGE));
    if (status != NOOK_OK) return;
    begin_steps(rings_bound());
    EXPECT(nook_rings_step(&rings, &units) == NOOK_OK);
    EXPECT(steps_taken() <= bound && rings.tail >= 1 && rings.tail <= spoiled.nt);
    for (i = 1; i < rings.tail; i++) {
        EXPECT(of_triangles[queue_of_triangles[i - 1]] <= of_triangles[queue_of_triangles[i]]);
    }
}

static void run_components(void) {
    nook_components sets;
    uint32_t t;
    EXPECT(nook_components_begin(&sets, &view, of_triangles) == NOOK_OK);
    begin_steps(components_bound());
    EXPECT(nook_components_step(&sets, &units) == NOOK_OK);
    EXPECT(steps_taken() <= bound && sets.count >= 1 && sets.count <= spoiled.nt);
    for (t = 0; t < spoiled.nt; t++) EXPECT(of_triangles[t] < sets.count);
}

static void try_searches(void) {
    uint32_t i;
    for (i = 0; i < arguments(NOOK_AT_TRIANGLE); i++) {
        uint32_t t = argument(NOOK_AT_TRIANGLE, i);
        begin_call("nook_flood", t, 0, 0);
        run_flood(t);
        begin_call("nook_rings", t, 0, 0);
        run_rings(t);
    }
    begin_call("nook_components", 0, 0, 0);
    run_components();
}

static void run_neighborhood(nook_where seed) {
    nook_neighborhood n;
    nook_status status = nook_neighborhood_begin(&n, &view, &marks, queue_of_vertices, seed);
    uint32_t given = 0, ring = 1;
    EXPECT(status == (seed.index < end_of(seed.kind) ? NOOK_OK : NOOK_INDEX_OUT_OF_RANGE));
    if (status != NOOK_OK) return;
    begin_steps(neighborhood_bound());
    for (; (status = nook_neighborhood_step(&n, &units)) == NOOK_TRIANGLE; given++, ring = n.ring) {
        EXPECT(n.corner < nc() && n.ring >= ring && n.ring <= spoiled.nv);
    }
    EXPECT(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    EXPECT(steps_taken() <= bound && given <= spoiled.nt);
}

static void try_neighborhoods(void) {
    static const nook_kind kinds[] = {NOOK_AT_VERTEX, NOOK_AT_CORNER, NOOK_AT_TRIANGLE};
    uint32_t k, i;
    for (k = 0; k < 3; k++) {
        for (i = 0; i < arguments(kinds[k]); i++) {
            begin_call("nook_neighborhood", kinds[k], argument(kinds[k], i), 0);
            run_neighborhood(nook_at(kinds[k], argument(kinds[k], i)));
        }
    }
}

static void run_loop(const nook_trees *trees, uint32_t c) {
    nook_loop loop;
    nook_status status = nook_loop_begin(&loop, trees, c);
    EXPECT(status == (c < nc() ? NOOK_OK : NOOK_INDEX_OUT_OF_RANGE));
    if (status != NOOK_OK) return;
    begin_steps(loop_bound());
    while ((status = nook_loop_step(&loop, &units)) == NOOK_TRIANGLE) {
        EXPECT(loop.corner < nc() && (loop.vertex < spoiled.nv || loop.corner == c));
    }
    EXPECT(status == NOOK_OK || status == NOOK_NONMANIFOLD_VERTEX);
    EXPECT(steps_taken() <= bound);
}

static void try_trees(void) {
    nook_trees trees;
    nook_status status;
    uint32_t c, i;
    begin_call("nook_trees", 0, 0, 0);
    EXPECT(nook_trees_begin(&trees, &view, &marks, queue_of_vertices) == NOOK_OK);
    begin_steps(trees_bound());
    status = nook_trees_step(&trees, &units);
    EXPECT(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    EXPECT(steps_taken() <= bound);
    for (c = 0; c < nc(); c++) {
        EXPECT(!(nook_is_generator(&trees, c) && nook_in_triangle_tree(&trees, c)));
        EXPECT(!(nook_is_generator(&trees, c) && nook_in_vertex_tree(&trees, c)));
    }
    for (i = 0; i < arguments(NOOK_AT_CORNER); i++) {
        begin_call("nook_loop", argument(NOOK_AT_CORNER, i), 0, 0);
        run_loop(&trees, argument(NOOK_AT_CORNER, i));
    }
}

static bool is_a_normal(nook_point n) {
    float square = nook_dot(n, n);
    return square == 0 || (square > 0.99999f && square < 1.00001f);
}

static void try_normals(void) {
    nook_creases creases;
    nook_status status;
    uint32_t i, c;
    for (i = 0; i < arguments(NOOK_AT_CORNER); i++) {
        nook_point n;
        c = argument(NOOK_AT_CORNER, i);
        begin_call("nook_vertex_normal", c, 0, 0);
        status = nook_vertex_normal(&view, c, i % 2 == 0 ? NOOK_BY_AREA : NOOK_BY_ANGLE, &n);
        EXPECT((status == NOOK_INDEX_OUT_OF_RANGE) == (c >= nc()));
        EXPECT(status == NOOK_OK || nook_dot(n, n) == 0);
        EXPECT(is_a_normal(n));
    }
    begin_call("nook_creases", 0, 0, 0);
    EXPECT(nook_creases_begin(&creases, &view, NOOK_BY_ANGLE, 0.5f, of_corners, 3) == NOOK_OK);
    begin_steps(creases_bound());
    status = nook_creases_step(&creases, &units);
    EXPECT(status == NOOK_OK || status == NOOK_BAD_OPPOSITE);
    EXPECT(steps_taken() <= bound);
    for (c = 0; c < nc() && status == NOOK_OK; c++) {
        EXPECT(is_a_normal(nook_make(of_corners[3 * c], of_corners[3 * c + 1], of_corners[3 * c + 2])));
    }
}

/* Afterwards points are not what they were, unless it was refused. */
static void try_smoothing(void) {
    nook_mesh *m = &rooms[0].mesh;
    const nook_smoothing how = {1, 0.9f, -0.95f, spoiled.nt % 2 == 0, m->G};
    nook_smooth_state state;
    nook_smoothed result;
    nook_status status;
    begin_call("nook_smooth", 0, 0, 0);
    EXPECT(nook_smooth_begin(&state, m, &how, of_vertices, &result) == NOOK_OK);
    begin_steps(smooth_bound(2));
    status = nook_smooth_step(&state, &units);
    EXPECT(status != NOOK_MORE);
    if (status != NOOK_OK) EXPECT(result.where.kind != NOOK_NOWHERE && is_as_before(&rooms[0]));
    EXPECT(steps_taken() <= bound);
}

/* ---- edit: one call -------------------------------------------------------------------------------- */

static struct { uint32_t tables, calls, done; } count;
static bool goes_on; /* edits build on each other */

/* Whether V and O of the triangle of corner c lead to vertices and corners that exist, and back. */
static bool holds(uint32_t c) {
    uint32_t i;
    if (c >= nc()) return false;
    for (i = c - c % 3; i < c - c % 3 + 3; i++) {
        if (spoiled.V[i] >= spoiled.nv || spoiled.O[i] >= nc() || spoiled.O[spoiled.O[i]] != i) return false;
    }
    return true;
}

/* The next corner counter-clockwise about the same vertex, if there is one. */
static uint32_t turned(uint32_t c) {
    uint32_t o = c >= nc() ? NOOK_NONE : spoiled.O[c - c % 3 + (c + 1) % 3];
    return o >= nc() ? NOOK_NONE : o - o % 3 + (o + 1) % 3;
}

/* The mesh as it was if the edit refuses. */
static void settle(nook_status status) {
    const nook_mesh *m = &here->mesh;
    count.calls++;
    if (status != NOOK_OK) {
        EXPECT(told == 0 && is_as_before(here) && data_is_as_before());
        return;
    }
    count.done++;
    EXPECT(m->nv <= m->max_nv && m->nt <= m->max_nt);
    told = 0;
    if (goes_on) {
        take_over();
    } else {
        load(here);
    }
}

/* The same of an edit at the triangle of corner c. */
static void settle_at(nook_status status, uint32_t c) {
    EXPECT(status != NOOK_OK || holds(c));
    settle(status);
}

typedef void operator_of_two(uint32_t x, uint32_t y);

static void flip(uint32_t c, uint32_t unused) {
    (void)unused;
    begin_call("nook_flip", c, 0, 0);
    settle_at(nook_flip(&here->mesh, c, edit), c);
}
static void split_triangle(uint32_t t, uint32_t unused) {
    (void)unused;
    begin_call("nook_split_triangle", t, 0, 0);
    settle_at(nook_split_triangle(&here->mesh, t, point(t + 2), edit), 3 * t);
}
static void split_edge(uint32_t c, uint32_t unused) {
    (void)unused;
    begin_call("nook_split_edge", c, 0, 0);
    settle_at(nook_split_edge(&here->mesh, c, point(c + 1), edit), c);
}
static void split_vertex(uint32_t c, uint32_t e) {
    begin_call("nook_split_vertex", c, e, 0);
    settle_at(nook_split_vertex(&here->mesh, c, e, point(c + e), edit), c != NOOK_NONE ? c : e);
}
static void collapse(uint32_t c, uint32_t unused) {
    (void)unused;
    begin_call("nook_collapse", c, 0, 0);
    settle_at(nook_collapse(&here->mesh, c, point(c), edit), c);
}
static void merge_edges(uint32_t c, uint32_t unused) {
    (void)unused;
    begin_call("nook_merge_edges", c, 0, 0);
    settle_at(nook_merge_edges(&here->mesh, c, edit), c);
}
static void remove_vertex(uint32_t v, uint32_t unused) {
    nook_status status;
    (void)unused;
    begin_call("nook_remove_vertex", v, 0, 0);
    status = nook_remove_vertex(&here->mesh, v, edit);
    if (status == NOOK_OK && v < spoiled.nv && spoiled.C[v] != NOOK_STORED_NONE) {
        uint32_t c = spoiled.C[v], q = turned(c);
        EXPECT(holds(c) && holds(q) && holds(turned(q)));
    }
    settle(status);
}
static void make_vertex(uint32_t v, uint32_t unused) {
    (void)unused;
    begin_call("nook_make_vertex", v, 0, 0);
    settle(nook_make_vertex(&here->mesh, point(v)));
}
/* With every third vertex, unless the two will not do anyway. */
static void make_triangles(uint32_t v, uint32_t w) {
    uint32_t i, end = v == w || v >= spoiled.nv || w >= spoiled.nv ? 1 : spoiled.nv + 1;
    for (i = 0; i < end; i++) {
        uint32_t on[3];
        on[0] = v, on[1] = w, on[2] = i;
        begin_call("nook_make_triangle", v, w, i);
        settle(nook_make_triangle(&here->mesh, on, edit));
    }
}
static void remove_triangle(uint32_t t, uint32_t unused) {
    (void)unused;
    begin_call("nook_remove_triangle", t, 0, 0);
    settle_at(nook_remove_triangle(&here->mesh, t, edit), 3 * t);
}
static void stitch(uint32_t c, uint32_t e) {
    begin_call("nook_stitch", c, e, 0);
    settle_at(nook_stitch(&here->mesh, c, e, edit), e);
}
static void cut(uint32_t c, uint32_t unused) {
    (void)unused;
    begin_call("nook_cut", c, 0, 0);
    settle_at(nook_cut(&here->mesh, c, edit), c);
}

/* ---- edit: in steps -------------------------------------------------------------------------------- */

/* A loop that turns out to be none has been followed for one edge more than it is long. */
static void run_fill(uint32_t c, nook_fill_way way) {
    nook_fill fill;
    nook_status status = nook_fill_begin(&fill, &here->mesh, c, way, edit);
    if (status == NOOK_OK) {
        begin_steps(fill_bound(nc() + 1, way));
        status = nook_fill_step(&fill, &units);
        EXPECT(status != NOOK_MORE && steps_taken() <= fill_bound(fill.length + 1, way));
    }
    settle_at(status, c);
    if (status != NOOK_OK) load(here);
}

static void fill_hole(uint32_t c, uint32_t way) {
    begin_call("nook_fill", c, way, 0);
    run_fill(c, (nook_fill_way)way);
}

static void reverse(uint32_t which, uint32_t with_component) {
    nook_reverse r;
    nook_status status;
    begin_call("nook_reverse", which, with_component, 0);
    status = nook_reverse_begin(&r, &here->mesh, with_component != 0 ? of_triangles : NULL, which, edit);
    begin_steps(2 * spoiled.nt);
    if (status == NOOK_OK) status = nook_reverse_step(&r, &units);
    EXPECT(status != NOOK_MORE);
    settle(status);
}

static void split_fans(uint32_t unused, uint32_t unused_too) {
    nook_split_fans s;
    nook_status status;
    (void)unused, (void)unused_too;
    begin_call("nook_split_fans", 0, 0, 0);
    status = nook_split_fans_begin(&s, &here->mesh, &marks, edit);
    begin_steps(split_fans_bound());
    if (status == NOOK_OK) status = nook_split_fans_step(&s, &units);
    EXPECT(status != NOOK_MORE && steps_taken() <= bound);
    settle(status);
}

/* ---- edit: every argument -------------------------------------------------------------------------- */

static void try_each(operator_of_two *apply, nook_kind kind) {
    uint32_t i;
    for (i = 0; i < arguments(kind); i++) apply(argument(kind, i), 0);
}

static void try_corners(void) {
    static operator_of_two *const of_one[] = {flip, split_edge, collapse, merge_edges, cut},
                                  *const of_two[] = {split_vertex, stitch};
    uint32_t k, i, j, end = arguments(NOOK_AT_CORNER) - 1u;
    for (k = 0; k < 5; k++) try_each(of_one[k], NOOK_AT_CORNER);
    for (k = 0; k < 2; k++) {
        for (i = 0; i < end; i++) {
            for (j = 0; j < end; j++) of_two[k](argument(NOOK_AT_CORNER, i), argument(NOOK_AT_CORNER, j));
        }
    }
}

static void try_whole(void) {
    uint32_t t;
    try_each(split_triangle, NOOK_AT_TRIANGLE);
    try_each(remove_triangle, NOOK_AT_TRIANGLE);
    reverse(0, 0);
    for (t = 0; t < spoiled.nt; t++) of_triangles[t] = nook_store(t % 2);
    reverse(1, 1);
    (void)run_components(); /* into of_triangles */
    reverse(0, 1);
    split_fans(0, 0);
}

/* What looks at C. */
static void try_vertices(void) {
    uint32_t v, w, c, way;
    make_vertex(0, 0);
    try_each(remove_vertex, NOOK_AT_VERTEX);
    for (v = 0; v <= spoiled.nv; v++) {
        for (w = 0; w <= spoiled.nv; w++) make_triangles(v, w);
    }
    make_triangles(NOOK_NONE, 0);
    for (way = NOOK_FILL_FAN; way <= NOOK_FILL_EARS; way++) {
        for (c = 0; c < arguments(NOOK_AT_CORNER); c++) fill_hole(argument(NOOK_AT_CORNER, c), way);
    }
}

/* ---- one table ------------------------------------------------------------------------------------- */

static void try_walk(void) {
    uint32_t edit_kind = with.edit;
    with.edit = 0;
    load(&rooms[0]);
    try_stars();
    try_relations(NOOK_EV, NOOK_FF + 1);
    try_halfedges();
    try_searches();
    try_relations(NOOK_VV, NOOK_VF + 1);
    try_corners_of_vertices();
    try_neighborhoods();
    try_trees();
    try_normals();
    EXPECT(is_as_before(&rooms[0]));
    try_smoothing();
    with.edit = edit_kind;
}

static void try_edits(void) {
    set_edit();
    load(here);
    try_corners();
    try_whole();
    try_vertices();
}

static void try_table(void) {
    count.tables++;
    try_walk();
    try_edits();
}

/* C, edit, points and room from a number whose bits are mixed; odd points in one of 16. */
static void choose(uint32_t number) {
    uint32_t bits = (number + 1u) * 2654435769u;
    bits = (bits ^ bits >> 15) * 2246822519u >> 8;
    with.C = (kind_of_C)(bits % KINDS_OF_C);
    with.edit = bits / 4 % KINDS_OF_EDIT;
    with.room = bits / 32 % ROOMS;
    with.odd = bits / 128 % 16 == 0;
}

static void begin_count(void) { memset(&count, 0, sizeof count); }

static void end_count(const char *label, uint32_t since) {
    CHECK(fences_hold());
    print_figure(label, count.tables, "tables", since);
    (void)printf("  %u edits, of which %u were carried out\n", (unsigned)count.calls, (unsigned)count.done);
}

/* ---- one and two triangles -------------------------------------------------------------------------- */

static uint32_t stride = 1; /* which tables are taken */
static bool everything;

typedef struct pattern {
    uint8_t nv, V[6]; /* 255: all bits set */
} pattern;

static void set_V(const pattern *p) {
    uint32_t c;
    for (c = 0; c < nc(); c++) spoiled.V[c] = p->V[c] == 255 ? NOOK_STORED_NONE : nook_store(p->V[c]);
}

/* The table of this number: its digits to the base 3 nt + 2. */
static void set_O(uint32_t number) {
    uint32_t c, base = nc() + 2;
    for (c = 0; c < nc(); c++, number /= base) {
        uint32_t digit = number % base;
        spoiled.O[c] = digit <= nc() ? nook_store(digit) : NOOK_STORED_NONE;
    }
}

static uint32_t tables_of_O(void) { return spoiled.nt == 1 ? 125 : 262144; }

static void try_all_kinds(void) {
    uint32_t k;
    for (k = 0; k < KINDS_OF_C * KINDS_OF_EDIT * 2; k++) {
        with.C = (kind_of_C)(k % KINDS_OF_C);
        with.edit = k / KINDS_OF_C % KINDS_OF_EDIT;
        with.odd = k / KINDS_OF_C / KINDS_OF_EDIT != 0;
        set_points();
        set_C();
        for (with.room = 0; with.room < ROOMS; with.room++) try_table();
    }
}

static void try_chosen(uint32_t number) {
    uint32_t k;
    choose(number);
    set_points();
    for (k = 0; k < (everything ? (uint32_t)(KINDS_OF_C * KINDS_OF_EDIT) : 1u); k++) {
        set_C();
        try_table();
        with.C = (kind_of_C)((with.C + 1u) % KINDS_OF_C);
        if (with.C == C_RIGHT) with.edit = (with.edit + 1u) % KINDS_OF_EDIT;
    }
}

static void try_every_O(const pattern *p, uint32_t nt, uint32_t every, uint32_t first) {
    uint32_t k;
    begin_tables(p->nv, nt, small_rooms);
    set_V(p);
    for (k = first % every; k < tables_of_O() && !test_has_failed(); k += every) {
        set_O(k);
        if (nt == 1) {
            try_all_kinds();
        } else {
            try_chosen(k + first);
        }
    }
    CHECK(fences_hold());
    drop_fences();
}

static void no_O_of_one_triangle_hurts(void) {
    static const pattern patterns[] = {{3, {0, 1, 2}}, {2, {0, 1, 0}},   {1, {0, 0, 0}},   {4, {3, 1, 0}},
                                       {3, {0, 1, 3}}, {3, {255, 1, 2}}, {3, {1, 255, 3}}, {2, {0, 0, 1}}};
    uint32_t i, since = milliseconds();
    begin_count();
    for (i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        try_every_O(&patterns[i], 1, 1, i);
    }
    end_count("one triangle, 125 O for 8 V", since);
}

static void no_O_of_two_triangles_hurts(void) {
    static const pattern patterns[] = {
        {4, {0, 1, 2, 2, 1, 3}},   /* a coherent pair */
        {4, {0, 1, 2, 1, 2, 3}},   /* one that runs the edge the same way */
        {6, {0, 1, 2, 3, 4, 5}},   /* disjoint */
        {5, {0, 1, 2, 0, 3, 4}},   /* a vertex in common */
        {3, {0, 1, 2, 2, 1, 0}},   /* a pillow */
        {3, {0, 0, 1, 1, 2, 0}},   /* vertices repeated */
        {2, {0, 1, 0, 1, 0, 1}},   /* two vertices only, */
        {1, {0, 0, 0, 0, 0, 0}},   /* and one */
        {4, {0, 1, 2, 2, 1, 4}},   /* out of range, */
        {4, {0, 1, 2, 2, 1, 255}}, /* and none at all */
    };
    uint32_t i, since = milliseconds();
    begin_count();
    for (i = 0; i < sizeof patterns / sizeof *patterns; i++) try_every_O(&patterns[i], 2, stride, i);
    end_count("two triangles, 262144 O for 10 V", since);
}

/* ---- sound meshes ---------------------------------------------------------------------------------- */

typedef struct solid {
    const char *name;
    uint8_t nv, nt, V[42];
} solid;
static const solid solids[] = {
    {"tetrahedron", 4, 4, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}},
    {"two fans at a vertex", 7, 4, {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 6}},
    {"octahedron", 6, 8, {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}},
    {"disk of 3 x 3 vertices", 9, 8, {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4,
                                      3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7}},
    {"torus of 7 vertices", 7, 14, {0, 1, 3, 1, 2, 4, 2, 3, 5, 3, 4, 6, 4, 5, 0, 5, 6, 1, 6, 0, 2,
                                    0, 3, 2, 1, 4, 3, 2, 5, 4, 3, 6, 5, 4, 0, 6, 5, 1, 0, 6, 2, 1}}};
enum { SOLIDS = sizeof solids / sizeof *solids };

static nook_index sound_V[MOST_NC], sound_O[MOST_NC], sound_C[MOST_NV];

static void begin_solid(const solid *s) {
    nook_mesh *m;
    nook_report report;
    uint32_t c;
    begin_tables(s->nv, s->nt, large_rooms);
    m = &rooms[0].mesh;
    for (c = 0; c < nc(); c++) m->V[c] = s->V[c];
    CHECK_EQUAL(nook_link(m, &marks, NULL, NULL, &report, NULL), NOOK_OK);
    memcpy(sound_V, m->V, nc() * sizeof *sound_V);
    memcpy(sound_O, m->O, nc() * sizeof *sound_O);
    memcpy(sound_C, m->C, s->nv * sizeof *sound_C);
}

static void make_sound(const solid *s) {
    spoiled.nv = s->nv;
    spoiled.nt = s->nt;
    memcpy(spoiled.V, sound_V, nc() * sizeof *sound_V);
    memcpy(spoiled.O, sound_O, nc() * sizeof *sound_O);
    memcpy(spoiled.C, sound_C, s->nv * sizeof *sound_C);
    set_points();
}

/* Entry i of V, O and C, one after the other; and the first value that it must not have. */
static uint32_t entries(void) { return 2 * nc() + spoiled.nv; }
static nook_index *entry(uint32_t i) {
    if (i < nc()) return &spoiled.V[i];
    return i < 2 * nc() ? &spoiled.O[i - nc()] : &spoiled.C[i - 2 * nc()];
}
static uint32_t end_of_values(uint32_t i) { return i < nc() ? spoiled.nv : nc(); }

static nook_index value(uint32_t i, uint32_t number) {
    return number <= end_of_values(i) ? nook_store(number) : NOOK_STORED_NONE;
}

/* Every value but the right one. */
static void try_values(const solid *s, uint32_t i, uint32_t kinds) {
    uint32_t number, k;
    for (number = 0; number <= end_of_values(i) + 1u; number++) {
        for (k = 0; k < kinds; k++) {
            choose(count.tables);
            make_sound(s);
            if (*entry(i) == value(i, number)) continue;
            *entry(i) = value(i, number);
            try_table();
        }
    }
}

static void one_wrong_entry_of_a_sound_mesh_does_not_hurt(void) {
    uint32_t k, i, since = milliseconds();
    begin_count();
    for (k = 0; k < SOLIDS; k++) {
        begin_solid(&solids[k]);
        make_sound(&solids[k]);
        try_table();
        for (i = 0; i < entries() && !test_has_failed(); i++) {
            try_values(&solids[k], i, stride > 1 ? 1 : 2);
        }
        CHECK(fences_hold());
        drop_fences();
    }
    end_count("five sound meshes, one entry wrong", since);
}

static void strike(uint32_t faults) {
    while (faults-- > 0) {
        uint32_t i = throw_dice(&d, entries());
        *entry(i) = value(i, throw_dice(&d, end_of_values(i) + 2u));
    }
}

static uint32_t wanted = 2000; /* of each mesh */

static void two_and_three_wrong_entries_do_not_hurt(void) {
    uint32_t k, i, since = milliseconds();
    begin_count();
    for (k = 0; k < SOLIDS; k++) {
        begin_solid(&solids[k]);
        for (i = 0; i < wanted && !test_has_failed(); i++) {
            choose(throw_dice(&d, UINT32_MAX));
            make_sound(&solids[k]);
            strike(2u + i % 2u);
            try_table();
        }
        CHECK(fences_hold());
        drop_fences();
    }
    end_count("five sound meshes, two or three entries wrong", since);
}

/* ---- series of edits -------------------------------------------------------------------------------- */

/* Any operator with any arguments. */
static void edit_at_random(void) {
    static const struct {
        operator_of_two *apply;
        nook_kind first, second;
    } all[] = {{flip, NOOK_AT_CORNER, NOOK_NOWHERE},
               {split_triangle, NOOK_AT_TRIANGLE, NOOK_NOWHERE},
               {split_edge, NOOK_AT_CORNER, NOOK_NOWHERE},
               {split_vertex, NOOK_AT_CORNER, NOOK_AT_CORNER},
               {collapse, NOOK_AT_CORNER, NOOK_NOWHERE},
               {merge_edges, NOOK_AT_CORNER, NOOK_NOWHERE},
               {remove_vertex, NOOK_AT_VERTEX, NOOK_NOWHERE},
               {make_vertex, NOOK_AT_VERTEX, NOOK_NOWHERE},
               {make_triangles, NOOK_AT_VERTEX, NOOK_AT_VERTEX},
               {remove_triangle, NOOK_AT_TRIANGLE, NOOK_NOWHERE},
               {stitch, NOOK_AT_CORNER, NOOK_AT_CORNER},
               {cut, NOOK_AT_CORNER, NOOK_NOWHERE},
               {fill_hole, NOOK_AT_CORNER, NOOK_AT_LINE}};
    uint32_t k = throw_dice(&d, sizeof all / sizeof *all), x, y = 0;
    x = argument(all[k].first, throw_dice(&d, arguments(all[k].first)));
    if (all[k].second == NOOK_AT_LINE) y = throw_dice(&d, 3);
    if (all[k].second == NOOK_AT_CORNER || all[k].second == NOOK_AT_VERTEX) {
        y = argument(all[k].second, throw_dice(&d, arguments(all[k].second)));
    }
    all[k].apply(x, y);
}

static void run_series(const solid *s, uint32_t edits) {
    choose(throw_dice(&d, UINT32_MAX));
    make_sound(s);
    set_data();
    strike(1u + throw_dice(&d, 3));
    set_edit();
    load(here);
    goes_on = true;
    while (edits-- > 0) edit_at_random();
    goes_on = false;
    count.tables++;
}

static void series_of_edits_on_wrong_tables_stay_in_their_arrays(void) {
    uint32_t k, i, since = milliseconds();
    begin_count();
    for (k = 0; k < SOLIDS; k++) {
        begin_solid(&solids[k]);
        for (i = 0; i < 10 * wanted && !test_has_failed(); i++) run_series(&solids[k], 100);
        CHECK(fences_hold());
        drop_fences();
    }
    set_data();
    end_count("five sound meshes, 100 edits after one to three faults", since);
}

static const test tests[] = {
    TEST(no_O_of_one_triangle_hurts),
    TEST(no_O_of_two_triangles_hurts),
    TEST(one_wrong_entry_of_a_sound_mesh_does_not_hurt),
    TEST(two_and_three_wrong_entries_do_not_hurt),
    TEST(series_of_edits_on_wrong_tables_stay_in_their_arrays),
};

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "small") == 0) stride = 13, wanted = 500;
    everything = argc > 1 && strcmp(argv[1], "large") == 0;
    set_data();
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
