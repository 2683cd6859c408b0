/* costs.c -- what the library costs on an emulated core that counts instructions, line by line for the table
 * that tests/tools/costs.py keeps: weld, link, survey and check a triangle and at most a unit, over a torus, sound and
 * with defects of every kind; each exact sign, by the stage that decides it; walks, normals, smoothing, and edits of a mesh of valence 6;
 * queries, hull and simplification on a link of 300 triangles.
 *
 * The emulator counts 64 ns for every instruction; TICK is a tick of the port in tenths of a nanosecond. */
#include "check.h"
#include "nook.h"
#include "nook_port.h"

#if NOOK_TEST_RAM < 2000000
enum { SIDE = 6, MORE = 20 };
#else
enum { SIDE = 24, MORE = 40 };
#endif
enum { T = 2 * SIDE * SIDE, MAX_T = T + MORE, MAX_V = 3 * MAX_T, MAX_SHELLS = 4 };
enum { SECTORS = 10, RINGS = 15, LINK_V = SECTORS * RINGS + 2, LINK_T = 2 * SECTORS * RINGS };
enum { SHELL_V = 4, SHELL_T = 4, TWO_V = LINK_V + SHELL_V, TWO_T = LINK_T + SHELL_T };
enum { MOST_V = (int)TWO_V > (int)MAX_V ? (int)TWO_V : (int)MAX_V };
enum { MOST_T = (int)TWO_T > (int)MAX_T ? (int)TWO_T : (int)MAX_T };
static union {
    NOOK_MESH_ARRAYS(MAX_V, MAX_T) torus;
    NOOK_MESH_ARRAYS(TWO_V, TWO_T) link;
} memory;
#define arrays memory.torus
static NOOK_BVH_ARRAYS(TWO_T) tree;
static nook_index map[MAX_V], component[MOST_T], stamp[MOST_V];
static nook_shell shell[MAX_SHELLS];
static uint8_t Mt[NOOK_MT_BYTES(MOST_T)], Mv[NOOK_MV_BYTES(MOST_V)];
static const nook_marks marks = {Mt, Mv, MOST_T, MOST_V};
enum { RECORDED = 50 };
static union {
    float number[9 * T];
    nook_vertex_split split[RECORDED];
} scratch;
#define numbers scratch.number
static nook_mesh mesh;

static void print_cost(const char *what, const char *of, uint32_t instructions) {
    print_text(what);
    print_text(of);
    print_text(" ");
    print_number(instructions);
    print_text("\n");
}

/* A torus of SIDE x SIDE cells of two triangles, shuffled: 577 and T have no common factor. With
 * defects: some triangles turned over, and a fan of MORE triangles about the vertex of cell 0. */
static void soup(bool defects) {
    static const uint8_t step[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
    uint32_t k, i;
    nook_mesh_init(&mesh, arrays.G, arrays.V, arrays.O, arrays.C, MAX_V, MAX_T);
    for (k = 0; k < (uint32_t)MORE && defects; k++) {
        const nook_point fan[3] = {{0, 0, 0}, {(float)k, -1, 3}, {(float)k + 1, -1, 3}};
        nook_mesh_append(&mesh, fan);
    }
    for (k = 0; k < (uint32_t)T; k++) {
        nook_point p[3], keep;
        uint32_t t = k * 577u % T;
        for (i = 0; i < 3u; i++) {
            uint32_t x = (t / 2u + step[t & 1u][i][0]) % SIDE,
                     y = (t / 2u / SIDE + step[t & 1u][i][1]) % SIDE;
            p[i] = nook_make((float)x * 1.37f, (float)y * 0.61f, (float)((x * 7u + y * 5u) % 11u));
        }
        keep = p[0];
        if (defects && k % 50u == 7u) p[0] = p[1], p[1] = keep;
        nook_mesh_append(&mesh, p);
    }
}

/* ---- counting ---------------------------------------------------------------------------------------- */

static uint32_t before, overhead;

static void start(void) { before = nook_port_ticks(); }
static uint32_t spent(void) { return (((nook_port_ticks() - before) & 0xFFFFFFu) - overhead) * TICK / 640u; }

typedef struct cost {
    uint32_t sum, most;
} cost;

/* A call that was given one unit, did work, and has debt of that work left. */
static void note(cost *c, uint32_t debt) {
    uint32_t n = spent();
    c->sum += n;
    n = (n + debt) / (1u + debt);
    if (n > c->most) c->most = n;
}

static void print_costs(const char *mesh_name, const char *of, const cost *c) {
    print_text(of);
    print_cost(mesh_name, "a_triangle", c->sum / mesh.nt);
    print_text(of);
    print_cost(mesh_name, "most_a_unit", c->most);
}

/* ---- passes ------------------------------------------------------------------------------------------ */

/* The debt that a check has after a call, and had before if it was only paying. */
static uint32_t debt_of(const nook_check_state *s) { return s->phase == 6u ? s->in.geometry.debt : 0; }

static void measure(const char *name, bool defects) {
    nook_shells shells = {shell, component, stamp, MAX_SHELLS, 0};
    nook_weld_state weld;
    nook_link_state link;
    nook_survey_state survey;
    nook_check_state check;
    nook_report report;
    nook_survey surveyed;
    nook_check_result result;
    nook_view view;
    nook_status status;
    cost costs[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    uint32_t units, debt = 0;
    soup(defects);
    nook_weld_begin(&weld, &mesh, map, arrays.O);
    do {
        units = 1, start(), status = nook_weld_step(&weld, &units), note(&costs[0], 0);
    } while (status == NOOK_MORE);
    nook_link_begin(&link, &mesh, &marks, &shells, NULL, &report);
    do {
        units = 1, start(), status = nook_link_step(&link, &units), note(&costs[1], 0);
    } while (status == NOOK_MORE);
    view = nook_view_of(&mesh);
    nook_survey_begin(&survey, &view, NULL, &marks, NULL, NULL, &surveyed);
    do {
        units = 1, start(), status = nook_survey_step(&survey, &units), note(&costs[2], 0);
    } while (status == NOOK_MORE);
    nook_check_begin(&check, &view, &marks, &report, &shells, NULL, &result);
    do {
        units = 1, start(), status = nook_check_step(&check, &units);
        if (debt == 0) note(&costs[3], debt_of(&check));
        debt = debt_of(&check);
    } while (status == NOOK_MORE);
    print_costs(name, "weld_", &costs[0]);
    print_costs(name, "link_", &costs[1]);
    print_costs(name, "survey_", &costs[2]);
    print_costs(name, "check_", &costs[3]);
}

/* Welded, not linked. */
static void orient(const char *name, bool defects) {
    nook_orient_state state;
    cost c = {0, 0};
    uint32_t units;
    nook_status status;
    soup(defects);
    nook_weld(&mesh, map, arrays.O, NULL);
    nook_orient_begin(&state, &mesh, &marks, NULL, NULL);
    do {
        units = 1, start(), status = nook_orient_step(&state, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    print_costs(name, "orient_", &c);
}

/* ---- exact signs ------------------------------------------------------------------------------------- */

/* Decided by floats, if there is an FPU; by integers, 0; by the sum, 0. */
static void signs(void) {
    static const char *const stage[3] = {"_by_floats", "_by_integers", "_by_sum"};
    static const nook_point at[3][3] = {
        {{0.1f, 0.2f, 0.3f}, {1.1f, 0.3f, 0.4f}, {0.3f, 1.7f, 0.2f}},
        {{0.1f, 0.2f, 0.3f}, {1.1f, 0.3f, 0.3f}, {0.3f, 1.7f, 0.3f}},
        {{1.1f, 1e-30f, 1e30f}, {1e-33f, 1.3f, 1e-9f}, {1.1e-17f, 1.7e-17f, 1.3f}}};
    uint32_t i;
    volatile int sink;
    nook_volume volume;
    for (i = 0; i < 3u; i++) {
        const nook_point *p = at[i];
        nook_point apart = {0.4f, 0.5f, 1.9f}, last = i == 0 ? apart : p[0];
        start(), sink = nook_orient3d(&p[0], &p[1], &p[2], &last);
        print_cost("orient3d", stage[i], spent());
        start(), sink = nook_orient2d(&p[0], &p[1], &last, 2);
        print_cost("orient2d", stage[i], spent());
        start(), sink = nook_compare_distances(&p[0], &p[1], &p[1], &last);
        print_cost("compare_distances", stage[i], spent());
    }
    (void)sink;
    nook_volume_clear(&volume);
    start(), nook_volume_add(&volume, &at[0][0], &at[0][1], &at[0][2]);
    print_cost("volume_add", "", spent());
}

/* ---- walks and edits ---------------------------------------------------------------------------------- */

/* Valence 6 everywhere. */
static void whole_torus(void) {
    nook_report report;
    soup(false);
    nook_weld(&mesh, map, arrays.O, NULL);
    nook_link(&mesh, &marks, NULL, NULL, &report, NULL);
}

static void walks(void) {
    nook_view view;
    nook_star star;
    nook_flood flood;
    nook_rings rings;
    nook_components sets;
    nook_related all;
    uint32_t units = UINT32_MAX, sum = 0, item;
    volatile uint32_t sink;
    whole_torus();
    view = nook_view_of(&mesh);
    start();
    nook_star_begin(&star, &view, 7, true);
    while (nook_star_next(&star) != NOOK_NONE) sum++;
    print_cost("star", "_of_6", spent());
    start();
    nook_related_begin(&all, &view, NOOK_VV, 7);
    while (nook_related_next(&all, &item)) sum += item;
    print_cost("relation", "_VV_of_6", spent());
    start(), sink = nook_onext(&view, nook_halfedge(&view, 7));
    print_cost("halfedge", "_onext", spent());
    nook_flood_begin(&flood, &view, &marks, NOOK_NONE);
    start();
    while (nook_flood_step(&flood, &units) == NOOK_TRIANGLE) sum++;
    print_cost("flood", "_a_triangle", spent() / mesh.nt);
    nook_rings_begin(&rings, &view, 0, component, stamp);
    units = UINT32_MAX;
    start(), nook_rings_step(&rings, &units);
    print_cost("rings", "_a_triangle", spent() / mesh.nt);
    nook_components_begin(&sets, &view, component);
    units = UINT32_MAX;
    start(), nook_components_step(&sets, &units);
    print_cost("components", "_a_triangle", spent() / mesh.nt);
    sink = sum;
    (void)sink;
}

/* Unit by unit, so many rounds of Taubin, two passes each; with or without points for reference. */
static cost smooth_rounds(uint32_t rounds, const nook_point *reference) {
    const nook_smoothing how = {rounds, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, reference};
    nook_smooth_state state;
    nook_smoothed result;
    cost c = {0, 0};
    uint32_t units;
    nook_status status;
    nook_smooth_begin(&state, &mesh, &how, numbers, &result);
    do {
        units = 1, start(), status = nook_smooth_step(&state, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    return c;
}

static void smooth(const char *name, const nook_point *reference) {
    cost none = smooth_rounds(0, reference), once = smooth_rounds(1, reference);
    print_cost(name, "_a_triangle", once.sum / mesh.nt);
    print_cost(name, "_a_vertex_and_pass", (once.sum - none.sum) / (2u * mesh.nv));
    print_cost(name, "_most_a_unit", once.most);
}

static void trees_and_normals(void) {
    nook_view view;
    nook_trees trees;
    nook_loop loop;
    nook_creases creases;
    nook_point normal;
    cost c = {0, 0}, of_loops = {0, 0}, of_creases = {0, 0};
    uint32_t units, i;
    nook_status status;
    whole_torus();
    view = nook_view_of(&mesh);
    nook_trees_begin(&trees, &view, &marks, stamp);
    do {
        units = 1, start(), status = nook_trees_step(&trees, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    print_cost("trees", "_a_triangle", c.sum / mesh.nt);
    print_cost("trees", "_most_a_unit", c.most);
    for (i = 0; i < 3u * mesh.nt; i++) {
        if (!nook_is_generator(&trees, i)) continue;
        nook_loop_begin(&loop, &trees, i);
        do {
            units = 1, start(), status = nook_loop_step(&loop, &units), note(&of_loops, 0);
        } while (status == NOOK_MORE || status == NOOK_TRIANGLE);
    }
    print_cost("loop", "_most_a_unit", of_loops.most);
    start(), nook_vertex_normal(&view, 7, NOOK_BY_AREA, &normal);
    print_cost("vertex_normal", "_by_area_of_6", spent());
    start(), nook_vertex_normal(&view, 7, NOOK_BY_ANGLE, &normal);
    print_cost("vertex_normal", "_by_angle_of_6", spent());
    nook_creases_begin(&creases, &view, NOOK_BY_ANGLE, 0.5f, numbers, 3);
    do {
        units = 1, start(), status = nook_creases_step(&creases, &units), note(&of_creases, 0);
    } while (status == NOOK_MORE);
    print_cost("creases", "_a_triangle", of_creases.sum / mesh.nt);
    print_cost("creases", "_most_a_unit", of_creases.most);
    smooth("smooth", NULL);
    smooth("smooth_without_turning", mesh.G);
}

/* Each edit and what takes it back; with and without the condition that nothing turns over. The new points are inside,
 * so that nothing is refused. */
static void edits(const char *name, const nook_edit *edit) {
    nook_point at, p, q, r;
    nook_status status;
    uint32_t c = 30, d, nt;
    whole_torus();
    p = mesh.G[mesh.V[c]], q = mesh.G[mesh.V[c + 1]], r = mesh.G[mesh.V[c + 2]];
    at = nook_make((q.x + r.x) / 2, (q.y + r.y) / 2, (q.z + r.z) / 2);
    start(), status = nook_split_edge(&mesh, c, at, edit);
    print_cost("split_edge", name, spent() + (uint32_t)status * 100000u);
    start(), status = nook_merge_edges(&mesh, 3 * (mesh.nt - 2) + 1, edit);
    print_cost("merge_edges", name, spent() + (uint32_t)status * 100000u);
    at = nook_make((p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3);
    start(), status = nook_split_triangle(&mesh, c / 3, at, edit);
    print_cost("split_triangle", name, spent() + (uint32_t)status * 100000u);
    start(), status = nook_remove_vertex(&mesh, mesh.nv - 1, edit);
    print_cost("remove_vertex", name, spent());
    start(), status = nook_flip(&mesh, c, edit);
    print_cost("flip", name, spent());
    whole_torus();
    nt = mesh.nt;
    d = nook_next(nook_prev(mesh.O[c + 2]));
    start(), status = nook_split_vertex(&mesh, c, nook_prev(d), nook_make(q.x + 0.01f, q.y, q.z), NULL);
    if (edit == NULL) print_cost("split_vertex", name, spent() + (uint32_t)status * 100000u);
    start(), status = nook_collapse(&mesh, 3 * nt, q, edit);
    print_cost("collapse", name, spent() + (uint32_t)status * 100000u);
}

static void sewing(void) {
    uint32_t v[3], c;
    whole_torus();
    v[0] = mesh.V[30], v[1] = mesh.V[31], v[2] = mesh.V[32];
    start(), nook_remove_triangle(&mesh, 10, NULL);
    print_cost("remove_triangle", "", spent());
    start(), nook_make_triangle(&mesh, v, NULL);
    print_cost("make_triangle", "", spent());
    nook_remove_triangle(&mesh, 10, NULL);
    for (c = 0; mesh.O[c] != c; c++) {
    }
    start(), nook_fill_hole(&mesh, c, NOOK_FILL_CENTROID, NULL);
    print_cost("fill_centroid", "_of_3", spent());
}

/* In one call, for comparison with the same without guards. */
static void survey_only(void) {
    nook_survey_state survey;
    nook_survey surveyed;
    nook_report report;
    nook_view view;
    uint32_t units = UINT32_MAX;
    soup(false);
    nook_weld(&mesh, map, arrays.O, NULL);
    nook_link(&mesh, &marks, NULL, NULL, &report, NULL);
    view = nook_view_of(&mesh);
    nook_survey_begin(&survey, &view, NULL, &marks, NULL, NULL, &surveyed);
    start(), nook_survey_step(&survey, &units);
    print_cost("survey", "", spent() / mesh.nt);
}

/* ---- queries ----------------------------------------------------------------------------------------- */

static void add(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t i = 3u * mesh.nt++;
    mesh.V[i] = (nook_index)a, mesh.V[i + 1u] = (nook_index)b, mesh.V[i + 2u] = (nook_index)c;
}

/* The size of a robot's link, 300 triangles, in metres: a lathe with steps and a groove. */
static void robot_link(void) {
    static const float turn[SECTORS][2] = {
        {1, 0},  {0.809f, 0.588f},   {0.309f, 0.951f},   {-0.309f, 0.951f}, {-0.809f, 0.588f},
        {-1, 0}, {-0.809f, -0.588f}, {-0.309f, -0.951f}, {0.309f, -0.951f}, {0.809f, -0.588f}};
    static const uint8_t radius[RINGS] = {40, 60, 61, 62, 62, 50, 49, 49, 50, 58, 59, 59, 47, 45, 30};
    uint32_t ring, k, last = LINK_V - 1;
    nook_mesh_init(&mesh, memory.link.G, memory.link.V, memory.link.O, memory.link.C, TWO_V, TWO_T);
    mesh.nv = LINK_V;
    mesh.G[0] = nook_make(0, 0, 0);
    mesh.G[last] = nook_make(0, 0, 0.3f);
    for (ring = 0; ring < RINGS; ring++) {
        for (k = 0; k < SECTORS; k++) {
            uint32_t a = 1 + ring * SECTORS + k, b = 1 + ring * SECTORS + (k + 1) % SECTORS;
            float r = (float)radius[ring] * 0.001f;
            mesh.G[a] = nook_make(r * turn[k][0], r * turn[k][1], (float)ring * 0.0207f + 0.004f);
            if (ring == 0) add(0, b, a);
            if (ring == RINGS - 1) {
                add(a, b, last);
            } else {
                add(a, b, b + SECTORS);
                add(a, b + SECTORS, a + SECTORS);
            }
        }
    }
}

static uint32_t seed = 2463534242u;
static float between(float low, float high) {
    seed ^= seed << 13, seed ^= seed >> 17, seed ^= seed << 5;
    return low + (high - low) * (float)(seed >> 8) * 0x1p-24f;
}

/* Around the link and in it. */
static nook_point somewhere(void) {
    float x = between(-0.1f, 0.1f), y = between(-0.1f, 0.1f);
    return nook_make(x, y, between(-0.04f, 0.34f));
}

enum { ASKED = 32 };
/* One of five kinds of question, to its end a unit at a time. */
static void ask(const nook_bvh *bvh, uint32_t kind, const char *of) {
    union {
        nook_ray ray;
        nook_closest closest;
        nook_inside inside;
    } q;
    cost c = {0, 0};
    uint32_t i, most = 0;
    for (i = 0; i < ASKED; i++) {
        nook_point a = somewhere(), b = somewhere();
        uint32_t units = 0, from = c.sum;
        nook_status status = NOOK_MORE;
        start();
        if (kind < 2u)
            nook_ray_begin(&q.ray, bvh, a, nook_sub(b, a), NOOK_MAX_T,
                           kind == 0 ? NOOK_NEAREST : NOOK_CROSSINGS);
        if (kind == 2u) nook_closest_begin(&q.closest, bvh, a, a, NOOK_FAR, 0);
        if (kind == 3u) nook_closest_begin(&q.closest, bvh, a, b, NOOK_FAR, 0);
        if (kind == 4u) nook_inside_begin(&q.inside, bvh, a);
        c.sum += spent();
        while (status == NOOK_MORE) {
            units = 1;
            start();
            status = kind < 2u    ? nook_ray_step(&q.ray, &units)
                     : kind == 4u ? nook_inside_step(&q.inside, &units)
                                  : nook_closest_step(&q.closest, &units);
            note(&c, 0);
        }
        if (c.sum - from > most) most = c.sum - from;
    }
    print_cost(of, "_mean", c.sum / ASKED);
    print_cost(of, "_most", most);
    print_cost(of, "_most_a_unit", c.most);
}

static void queries(void) {
    static const char *const names[5] = {"ray_nearest", "ray_crossings", "closest_point", "closest_segment",
                                         "inside"};
    nook_intersections found;
    nook_bvh_state build;
    nook_bvh bvh;
    nook_view view;
    cost c = {0, 0}, self = {0, 0}, all = {0, 0};
    nook_overlap about;
    uint32_t units, i;
    nook_status status;
    robot_link();
    view = nook_view_of(&mesh);
    nook_bvh_begin(&build, &bvh, &view, tree.boxes, tree.order, NULL);
    do {
        units = 1, start(), status = nook_bvh_step(&build, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    print_cost("bvh_build", "_most_a_unit", c.most);
    start(), nook_bvh_build(&bvh, &view, tree.boxes, tree.order, NULL);
    print_cost("bvh_build", "_a_triangle", spent() / mesh.nt);
    nook_bvh_refit_begin(&build, &bvh, tree.boxes, NULL);
    units = UINT32_MAX, start(), nook_bvh_step(&build, &units);
    print_cost("bvh_refit", "_a_triangle", spent() / mesh.nt);
    for (i = 0; i < 5u; i++) ask(&bvh, i, names[i]);
    nook_intersections_begin(&found, &bvh);
    do {
        units = 1, start(), status = nook_intersections_step(&found, &units), note(&self, 0);
    } while (status == NOOK_MORE);
    for (i = 0; i < (uint32_t)ASKED; i++) {
        nook_point low = somewhere();
        nook_overlap_begin(&about, &bvh, low, nook_make(low.x + 0.03f, low.y + 0.03f, low.z + 0.03f));
        for (status = NOOK_MORE; status != NOOK_OK;) {
            units = 1, start(), status = nook_overlap_step(&about, &units), note(&all, 0);
        }
    }
    print_cost("overlap", "_most_a_unit", all.most);
    print_cost("self_intersections", "_a_triangle", self.sum / mesh.nt);
    print_cost("self_intersections", "_most_a_unit", self.most);
}

/* An edge of the link collapses to its middle, at valence 6, if no triangle turns over and none cuts another. */
static void edit_with_tree(void) {
    nook_guard guard;
    nook_edit edit = {0};
    nook_view view;
    nook_report report;
    nook_point p, q;
    uint32_t c = 3u * (LINK_T / 2u);
    robot_link();
    nook_link(&mesh, NULL, NULL, NULL, &report, NULL);
    view = nook_view_of(&mesh);
    nook_guard_begin(&guard, &mesh, tree.boxes);
    nook_bvh_refit(&guard.bvh, tree.boxes, NULL);
    edit.no_turn = true;
    edit.guard = &guard;
    p = nook_point_at(&view, nook_next(c)), q = nook_point_at(&view, nook_prev(c));
    start(), c = nook_collapse(&mesh, c, nook_make((p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2), &edit);
    print_cost("collapse", "_without_cutting", spent() + c * 100000000u);
}

/* ---- shapes ------------------------------------------------------------------------------------------ */

/* A tetrahedron on vertices from v on, whose fourth stands above the other three. */
static void add_tetrahedron(uint32_t v) {
    add(v, v + 2, v + 1);
    add(v, v + 1, v + 3);
    add(v + 1, v + 2, v + 3);
    add(v + 2, v, v + 3);
    mesh.nv = v + 4;
}

static uint32_t touched;
static void count_touched(void *user, nook_status defect, nook_where where) {
    (void)user, (void)where;
    touched += defect == NOOK_SELF_INTERSECTION;
}

/* The shells of the mesh; those units apart in which two of them touch. */
static void orient_shells(cost *c, cost *of_touching) {
    static const nook_finder finder = {count_touched, NULL};
    nook_shells shells = {shell, component, stamp, MAX_SHELLS, 0};
    nook_orient_shells_state state;
    nook_check_result result;
    nook_report report;
    nook_bvh bvh;
    nook_view view;
    uint32_t units, before_it;
    nook_status status;
    nook_link(&mesh, &marks, NULL, NULL, &report, NULL);
    view = nook_view_of(&mesh);
    nook_check(&view, &marks, &report, &shells, NULL, &result);
    nook_bvh_build(&bvh, &view, tree.boxes, tree.order, NULL);
    nook_orient_shells_begin(&state, &mesh, &bvh, &shells, NULL, &finder);
    do {
        before_it = touched;
        units = 1, start(), status = nook_orient_shells_step(&state, &units);
        note(touched == before_it ? c : of_touching, 0);
    } while (status == NOOK_MORE);
    c->sum += (uint32_t)status * 100000000u;
}

/* Two solids, of which the second stands on tiptoe, so far up, or with a whole side on the table of the first. In the
 * latter case two triangles in one plane touch in a corner. */
static void touching(const char *name, float up) {
    const nook_point p[8] = {{0, 0.2f, 0},  {0.1f, 0.1f, 0}, {0.2f, 0.1f, 0}, {0.1f, 0.13f, 0.1f},
                             {0.2f, 0, up}, {0.1f, 0.1f, 0}, {0, 0.1f, up},   {0.1f, 0.07f, 0.1f}};
    cost c = {0, 0}, of_touching = {0, 0};
    touched = mesh.nt = 0;
    memcpy(mesh.G, p, sizeof p);
    add_tetrahedron(0);
    add_tetrahedron(4);
    orient_shells(&c, &of_touching);
    print_cost("orient_shells_most_a_unit_that_touches", name,
               of_touching.most + (touched == 0 || c.sum >= 100000000u) * 100000000u);
}

/* A solid beside the link; and two that touch. */
static void shells(void) {
    static const nook_point beside[4] = {
        {0.1f, 0.1f, 0.1f}, {0.15f, 0.1f, 0.1f}, {0.1f, 0.15f, 0.1f}, {0.12f, 0.12f, 0.15f}};
    cost c = {0, 0}, none = {0, 0};
    robot_link();
    memcpy(mesh.G + LINK_V, beside, sizeof beside);
    add_tetrahedron(LINK_V);
    orient_shells(&c, &none);
    print_cost("orient_shells", "_a_triangle", c.sum / mesh.nt);
    print_cost("orient_shells", "_most_a_unit", c.most);
    touching("", 0.03f);
    touching("_in_a_plane", 0);
}

static void hull(void) {
    nook_hull_state state;
    cost c = {0, 0};
    uint32_t units;
    nook_status status;
    robot_link();
    nook_hull_begin(&state, &mesh, &marks, NULL);
    do {
        units = 1, start(), status = nook_hull_step(&state, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    print_cost("hull", "_a_point", c.sum / LINK_V + (uint32_t)status * 100000000u);
    print_cost("hull", "_most_a_unit", c.most);
}

/* The mesh, linked and simplified; how many units it took in *calls. */
static cost simplify(const nook_simplify_goal *goal, uint32_t *calls) {
    nook_simplify_state state;
    nook_report report;
    cost c = {0, 0};
    uint32_t units;
    nook_status status;
    nook_link(&mesh, &marks, NULL, NULL, &report, NULL);
    nook_simplify_begin(&state, &mesh, goal, NULL);
    *calls = 0;
    do {
        units = 1, start(), status = nook_simplify_step(&state, &units), note(&c, 0);
        ++*calls;
    } while (status == NOOK_MORE);
    c.sum += (uint32_t)status * 100000000u;
    return c;
}

/* The link, to a third of its triangles. */
static void simplify_link(const char *name, nook_simplify_goal goal) {
    uint32_t calls;
    cost c;
    robot_link();
    memset(numbers, 0, sizeof numbers);
    goal.triangles = LINK_T / 3;
    goal.error = 1;
    c = simplify(&goal, &calls);
    print_cost(name, "_a_unit", c.sum / calls);
    print_cost(name, "_a_collapse", c.sum / (LINK_V - mesh.nv));
    print_cost(name, "_most_a_unit", c.most);
}

/* Two hubs over or below a rim, to be one: as many corners around an edge as there may be. */
static void simplify_hubs(const char *name, nook_simplify_goal goal, uint32_t corners, float height) {
    uint32_t half = corners / 2u - 2u, k, calls;
    cost c;
    nook_mesh_init(&mesh, arrays.G, arrays.V, arrays.O, arrays.C, MAX_V, MAX_T);
    mesh.nv = 2u * half + 2u;
    mesh.G[0] = nook_make(-0.01f, 0, height);
    mesh.G[1] = nook_make(0.01f, 0, height);
    for (k = 0; k < 2u * half; k++) {
        float t = 1.0f - 2.0f * (float)(k % half) / (float)half, x = (1 - t * t) / (1 + t * t),
              y = 2 * t / (1 + t * t), z = 0.05f * (float)(k & 1u);
        mesh.G[k + 2u] = k < half ? nook_make(x, -y, z) : nook_make(-x, y, z);
        add(k + 2u, k + 1u < 2u * half ? k + 3u : 2u, k < half);
    }
    add(1, half + 2u, 0);
    add(0, 2, 1);
    memset(numbers, 0, sizeof numbers);
    goal.triangles = mesh.nt - 2u;
    goal.error = 1;
    c = simplify(&goal, &calls);
    print_cost("simplify", name, c.most + (mesh.nt > goal.triangles) * 100000000u);
}

static void simplifications(void) {
    static const nook_simplify_goal plain = {0, 0, NULL, false, NULL}, near = {0, 0, numbers, false, NULL},
                                    outside = {0, 0, NULL, true, NULL};
    simplify_link("simplify", plain);
    simplify_link("simplify_with_deviation", near);
    simplify_link("simplify_outside", outside);
    simplify_hubs("_most_a_unit_at_44_corners", plain, 44, 0.1f);
    simplify_hubs("_with_deviation_most_a_unit_at_44_corners", near, 44, 0.1f);
    simplify_hubs("_outside_most_a_unit_at_24_corners", outside, 24, -0.3f);
}

/* A collapse at valence 6, back and forth; and those of the link, by one call each. */
static void levels(void) {
    nook_levels record = nook_levels_in(scratch.split, RECORDED);
    nook_simplify_goal goal = {LINK_T - 2 * RECORDED, 0, NULL, false, NULL};
    cost down = {0, 0}, up = {0, 0};
    nook_status status;
    uint32_t units;
    whole_torus();
    start(), status = nook_levels_collapse(&record, &mesh, 30, mesh.G[mesh.V[31]], NULL);
    print_cost("levels", "_collapse", spent() + (uint32_t)status * 100000u);
    start(), status = nook_levels_refine(&record, &mesh, NULL);
    print_cost("levels", "_refine", spent() + (uint32_t)status * 100000u);
    start(), status = nook_levels_coarsen(&record, &mesh, NULL);
    print_cost("levels", "_coarsen", spent() + (uint32_t)status * 100000u);
    record = nook_levels_in(scratch.split, RECORDED);
    robot_link();
    goal.levels = &record;
    (void)simplify(&goal, &units);
    do {
        units = 1, start(), status = nook_levels_step(&record, &mesh, LINK_T, NULL, &units), note(&up, 0);
    } while (status == NOOK_MORE);
    do {
        units = 1, start(), status = nook_levels_step(&record, &mesh, 0, NULL, &units), note(&down, 0);
    } while (status == NOOK_MORE);
    print_cost("levels", "_finer_mean", up.sum / RECORDED);
    print_cost("levels", "_finer_most", up.most);
    print_cost("levels", "_coarser_mean", down.sum / RECORDED);
    print_cost("levels", "_coarser_most", down.most);
}

int main(void) {
    start();
    overhead = (nook_port_ticks() - before) & 0xFFFFFFu;
    survey_only();
#ifndef ONLY_SURVEY
    measure("sound_", false);
    measure("defective_", true);
    orient("sound_", false);
    orient("defective_", true);
    signs();
    walks();
    trees_and_normals();
    edits("", NULL);
    {
        static const nook_edit careful = {.no_turn = true};
        edits("_without_turning", &careful);
    }
    sewing();
    queries();
    edit_with_tree();
    shells();
    hull();
    simplifications();
    levels();
#endif
    return 0;
}
