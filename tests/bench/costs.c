/* costs.c -- what the library costs on an emulated core that counts instructions, line by line for the table
 * that tests/tools/costs.py keeps: weld, link, survey and check a triangle and at most a unit, over a torus, sound and
 * with defects of every kind; each exact sign, by the stage that decides it; walks, normals, smoothing, and edits of a mesh of valence 6;
 * queries on a link of 300 triangles.
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
static union {
    NOOK_MESH_ARRAYS(MAX_V, MAX_T) torus;
    NOOK_MESH_ARRAYS(LINK_V, LINK_T) link;
} memory;
#define arrays memory.torus
static NOOK_BVH_ARRAYS(LINK_T) tree;
static nook_index map[MAX_V], component[MAX_T], stamp[MAX_V];
static nook_shell shell[MAX_SHELLS];
static uint8_t Mt[NOOK_MT_BYTES(MAX_T)], Mv[NOOK_MV_BYTES(MAX_V)];
static float numbers[9 * T];
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
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
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
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
    soup(false);
    nook_weld(&mesh, map, arrays.O, NULL);
    nook_link(&mesh, &marks, NULL, NULL, &report, NULL);
}

static void walks(void) {
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
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

/* Unit by unit, a round of Taubin; with or without points for reference. */
static void smooth(const char *name, const nook_point *reference) {
    const nook_smoothing how = {1, NOOK_TAUBIN_LAMBDA, NOOK_TAUBIN_MU, false, reference};
    nook_smooth_state state;
    nook_smoothed result;
    cost c = {0, 0};
    uint32_t units;
    nook_status status;
    nook_smooth_begin(&state, &mesh, &how, numbers, &result);
    do {
        units = 1, start(), status = nook_smooth_step(&state, &units), note(&c, 0);
    } while (status == NOOK_MORE);
    print_cost(name, "_a_triangle", c.sum / mesh.nt);
    print_cost(name, "_most_a_unit", c.most);
}

static void trees_and_normals(void) {
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
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
    nook_marks marks = {Mt, Mv, MAX_T, MAX_V};
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
    nook_mesh_init(&mesh, memory.link.G, memory.link.V, memory.link.O, memory.link.C, LINK_V, LINK_T);
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

int main(void) {
    start();
    overhead = (nook_port_ticks() - before) & 0xFFFFFFu;
    survey_only();
#ifndef ONLY_SURVEY
    measure("sound_", false);
    measure("defective_", true);
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
#endif
    return 0;
}
