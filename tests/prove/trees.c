/* trees.c -- the tree of boxes itself, and what asks it for pairs: same answers from every tree, none from
 * spoiled bits.
 *
 * Trees over the same triangles, in their own order, in no order, in a thrown one and refitted after
 * vertices moved, must answer alike to the bit. Pairs are held against all pairs, T-junctions against all
 * vertices and edges. Boxes, order and tables are then filled with anything. */
#include "prove.h"
#include "solids.h"

#include "query/nook_closest.h"
#include "query/nook_inside.h"
#include "query/nook_intersections.h"
#include "query/nook_pair.h"
#include "query/nook_ray.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static dice d = {5u};
static uint32_t questions = 40;   /* of each tree */
static uint32_t spoilings = 1500; /* of each solid */
static uint32_t large = 1000;     /* triangles */
static const char *running_solid = "soup";
static uint32_t running_variant;

static bool same_bits(float a, float b) { return nook_float_bits(a) == nook_float_bits(b); }

static void failed_at(const char *what) {
    (void)printf("%s: %s of %u, variant %u\n", what, running_solid, (unsigned)here.view.nt,
                 (unsigned)running_variant);
}

static nook_point throw_place(float reach) {
    nook_point p, q = here.G[throw_dice(&d, here.view.nv)];
    p.x = q.x + throw_unit(&d) * reach;
    p.y = q.y + throw_unit(&d) * reach;
    p.z = q.z + throw_unit(&d) * reach;
    return p;
}

/* ---- sizes ---------------------------------------------------------------------------------------- */

/* Leaves of four triangles, groups of four leaves or groups, up to one; a group more is for the build. */
static uint32_t groups_counted(uint32_t nt) {
    uint32_t n = (nt + 3) / 4, all = 1;
    do {
        n = (n + 3) / 4;
        all += n;
    } while (n > 1);
    return all;
}

static void boxes_have_room_for_every_level(void) {
    static const uint32_t most = NOOK_MAX_TRIANGLES;
    uint32_t nt, k;
    for (nt = 1; nt <= 21845; nt++) CHECK_EQUAL(NOOK_BVH_GROUPS(nt), groups_counted(nt));
    for (k = 4; k < 15; k++) {
        for (nt = (1u << 2 * k) - 2; nt <= (1u << 2 * k) + 2 && nt <= most; nt++) {
            CHECK_EQUAL(NOOK_BVH_GROUPS(nt), groups_counted(nt));
        }
    }
    CHECK_EQUAL(NOOK_BVH_GROUPS(most), groups_counted(most));
}

/* ---- the same answers from every tree ------------------------------------------------------------- */

enum { TREES = 4 };
static struct {
    nook_bvh bvh;
    nook_boxes *boxes;
    nook_index *order;
} tree[TREES];

/* In its own order, in no order, in any order, and in its own again but built a unit at a time. */
static void build_as_it_is(uint32_t i, nook_index *order) {
    nook_where where;
    CHECK_EQUAL(nook_bvh_build(&tree[i].bvh, &here.view, tree[i].boxes, order, &where), NOOK_OK);
    CHECK(tree[i].bvh.order == order && tree[i].bvh.boxes == tree[i].boxes);
}

static void refit(uint32_t i) {
    nook_bvh_state state;
    nook_where where;
    nook_status status;
    uint32_t units;
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &tree[i].bvh, tree[i].boxes, &where), NOOK_OK);
    do {
        units = 1 + throw_dice(&d, 9);
        status = nook_bvh_step(&state, &units);
    } while (status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
}

static void build_in_any_order(uint32_t i) {
    nook_index *order = tree[i].order;
    uint32_t k;
    for (k = here.view.nt; k > 1; k--) {
        uint32_t j = throw_dice(&d, k);
        nook_index keep = order[j];
        order[j] = order[k - 1];
        order[k - 1] = keep;
    }
    refit(i);
}

static void build_slowly(uint32_t i) {
    nook_bvh_state state;
    nook_where where;
    nook_status status;
    uint32_t steps = 0, units;
    CHECK_EQUAL(nook_bvh_begin(&state, &tree[i].bvh, &here.view, tree[i].boxes, tree[i].order, &where),
                NOOK_OK);
    do {
        units = 1;
        status = nook_bvh_step(&state, &units);
    } while (status == NOOK_MORE && ++steps < 2000 * here.view.nt + 1000);
    CHECK_EQUAL(status, NOOK_OK);
}

static void order_is_whole(const nook_index *order) {
    static uint8_t seen[MOST_NT];
    uint32_t i;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < here.view.nt; i++) {
        if (!CHECK(order[i] < here.view.nt && seen[order[i]] == 0)) return;
        seen[order[i]] = 1;
    }
}

static void build_all(void) {
    uint32_t nt = here.view.nt, i;
    for (i = 0; i < TREES; i++) {
        tree[i].boxes = fenced(NOOK_BVH_GROUPS(nt) * sizeof *tree[i].boxes);
        tree[i].order = fenced(nt * sizeof *tree[i].order);
    }
    build_as_it_is(0, tree[0].order);
    order_is_whole(tree[0].order);
    build_as_it_is(1, NULL);
    build_as_it_is(2, tree[2].order);
    CHECK(memcmp(tree[2].order, tree[0].order, nt * sizeof *tree[0].order) == 0);
    build_in_any_order(2);
    build_slowly(3);
    CHECK(memcmp(tree[3].order, tree[0].order, nt * sizeof *tree[0].order) == 0);
    CHECK(memcmp(tree[3].boxes, tree[0].boxes, (NOOK_BVH_GROUPS(nt) - 1) * sizeof *tree[0].boxes) == 0);
}

static nook_ray cast(uint32_t i, nook_point o, nook_point to, nook_ray_kind kind) {
    nook_ray r;
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_ray_begin(&r, &tree[i].bvh, o, to, NOOK_MAX_T, kind), NOOK_OK);
    CHECK_EQUAL(nook_ray_step(&r, &units), NOOK_OK);
    CHECK(UINT32_MAX - units <= here.view.nt * 134 / 100 + 10);
    return r;
}

static void compare_rays(nook_point o, nook_point to) {
    nook_ray first = cast(0, o, to, NOOK_NEAREST), crossed = cast(0, o, to, NOOK_CROSSINGS);
    uint32_t i;
    for (i = 0; i < TREES; i++) {
        nook_ray r = cast(i, o, to, NOOK_NEAREST);
        float w[3], first_w[3];
        nook_ray_weights(&r, w);
        nook_ray_weights(&first, first_w);
        if (!CHECK_EQUAL(r.triangle, first.triangle)) failed_at("ray");
        CHECK(same_bits(r.t, first.t) && same_bits(r.t_min, first.t_min) &&
              memcmp(w, first_w, sizeof w) == 0);
        r = cast(i, o, to, NOOK_ANY);
        CHECK_EQUAL(r.triangle == NOOK_NONE, first.triangle == NOOK_NONE);
        r = cast(i, o, to, NOOK_CROSSINGS);
        CHECK_EQUAL(r.crossings, crossed.crossings);
        CHECK_EQUAL(r.winding, crossed.winding);
    }
}

static nook_closest nearest(uint32_t i, nook_point a, nook_point b) {
    nook_closest c;
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_closest_begin(&c, &tree[i].bvh, a, b, NOOK_FAR, 0), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    CHECK(UINT32_MAX - units <= here.view.nt * 134 / 100 + 10);
    return c;
}

static void compare_nearest(nook_point a, nook_point b) {
    nook_closest first = nearest(0, a, b);
    uint32_t i;
    for (i = 1; i < TREES; i++) {
        nook_closest c = nearest(i, a, b);
        if (!CHECK_EQUAL(c.triangle, first.triangle)) failed_at("nearest");
        CHECK(same_bits(c.distance, first.distance) && same_bits(c.at, first.at));
        CHECK(same_bits(c.distance_min, first.distance_min) && same_bits(c.distance_max, first.distance_max));
        CHECK(memcmp(&c.point, &first.point, sizeof c.point) == 0);
    }
}

static nook_inside is_inside(uint32_t i, nook_point p) {
    nook_inside in;
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_inside_begin(&in, &tree[i].bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
    return in;
}

static void compare_inside(nook_point p) {
    nook_inside first = is_inside(0, p);
    uint32_t i;
    for (i = 1; i < TREES; i++) {
        nook_inside in = is_inside(i, p);
        CHECK_EQUAL(in.on, first.on);
        CHECK_EQUAL(in.crossings, first.crossings);
        CHECK_EQUAL(in.winding, first.winding);
    }
}

/* Components of any ratio, and some of 0. */
static nook_point throw_direction(void) {
    nook_point to = {0, 0, 0};
    uint32_t axis;
    for (axis = 0; axis < 3; axis++) {
        float x = throw_unit(&d);
        *(&to.x + axis) = throw_dice(&d, 4) == 0 ? 0 : x * nook_power_of_two(77 + throw_dice(&d, 60));
    }
    if (to.x == 0 && to.y == 0) to.z = 1;
    return to;
}

static float far_reach(void) {
    float reach = here.size * 1000;
    return reach < NOOK_MAX_COORDINATE * 0.25f ? reach : here.size * 10;
}

static void compare_trees(void) {
    uint32_t k;
    for (k = 0; k < questions; k++) {
        nook_point f = throw_place(far_reach()), to = throw_direction();
        compare_rays(here.G[throw_dice(&d, here.view.nv)], to);
        compare_rays(f, nook_sub(here.G[throw_dice(&d, here.view.nv)], f));
        compare_rays(nook_sub(here.G[throw_dice(&d, here.view.nv)], nook_scaled(to, here.size * 0x1p-9f)),
                     to);
        compare_nearest(f, f);
        compare_nearest(f, throw_place(here.size));
    }
    for (k = 0; k < questions; k++) {
        nook_point p = throw_place(k % 4 == 0 ? 0 : here.size), q = throw_place(here.size * 0.1f);
        compare_nearest(p, p);
        compare_nearest(p, q);
        compare_inside(p);
        if (memcmp(&p, &q, sizeof p) != 0) compare_rays(p, nook_sub(q, p));
        compare_rays(p, nook_make(k % 3 == 0, k % 3 == 1, k % 3 == 2));
    }
}

static void all_trees_over_a_few_triangles_answer_alike(void) {
    uint32_t nt, trees = 0, since = milliseconds();
    for (nt = 1; nt <= 71 && !test_has_failed(); nt++) {
        make_soup(nt == 71 ? large : nt, &variants[nt % variant_count]);
        running_variant = nt % variant_count;
        build_all();
        compare_trees();
        trees += TREES;
        drop_world();
    }
    print_figure("trees of 1 to 70 and 1000 triangles", trees, "trees", since);
}

static void all_trees_over_a_solid_answer_alike(void) {
    uint32_t s, trees = 0, since = milliseconds();
    for (s = 0; s < solid_count && !test_has_failed(); s++) {
        running_solid = solids[s].name;
        for (running_variant = 0; running_variant < variant_count; running_variant++) {
            make_solid(&solids[s], &variants[running_variant]);
            build_all();
            compare_trees();
            trees += TREES;
            drop_world();
        }
    }
    print_figure("trees of solids", trees, "trees", since);
}

/* Vertices move: the trees of before are refitted, the first is built anew. */
static void a_refitted_tree_answers_as_a_new_one(void) {
    uint32_t s, i, times, trees = 0, since = milliseconds();
    for (s = 0; s < solid_count && !test_has_failed(); s++) {
        running_solid = solids[s].name;
        running_variant = s % variant_count;
        make_solid(&solids[s], &variants[running_variant]);
        build_all();
        for (times = 0; times < 4; times++) {
            for (i = 0; i < here.view.nv; i++)
                here.G[i] = throw_place(here.size * (times % 2 ? 3.0f : 0.01f));
            build_as_it_is(0, tree[0].order);
            for (i = 1; i < TREES; i++) refit(i);
            compare_trees();
            trees += TREES;
        }
        drop_world();
    }
    print_figure("trees refitted", trees, "trees", since);
}

/* ---- self-intersections --------------------------------------------------------------------------- */

static uint8_t pairs_found[MOST_NT][MOST_NT];

static void find_pairs(const nook_bvh *bvh, uint32_t units_each) {
    nook_intersections f;
    nook_status status;
    uint32_t count = 0;
    uint64_t used = 0;
    memset(pairs_found, 0, sizeof pairs_found);
    CHECK_EQUAL(nook_intersections_begin(&f, bvh), NOOK_OK);
    do {
        uint32_t units = units_each;
        status = nook_intersections_step(&f, &units);
        used += units_each - units;
        if (status != NOOK_TRIANGLE) continue;
        count++;
        if (!CHECK(f.t < f.u && f.u < here.view.nt)) return;
        CHECK_EQUAL(++pairs_found[f.t][f.u], 1);
    } while (status == NOOK_TRIANGLE ||
             (status == NOOK_MORE && used < UINT64_C(4) * here.view.nt * here.view.nt + 1000));
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(f.count, count);
    CHECK(used * 100 <= UINT64_C(134) * here.view.nt * here.view.nt + UINT64_C(1000) * here.view.nt);
}

static uint32_t compare_pairs(void) {
    uint32_t t, u, count = 0;
    for (t = 0; t < here.view.nt; t++) {
        for (u = t + 1; u < here.view.nt; u++) {
            bool expected = nook_triangles_intersect(&here.view, t, u);
            count += expected;
            if (!CHECK_EQUAL(pairs_found[t][u], expected)) failed_at("pair");
        }
    }
    return count;
}

static uint32_t check_pairs(void) {
    uint32_t count;
    build_all();
    find_pairs(&tree[0].bvh, UINT32_MAX);
    count = compare_pairs();
    find_pairs(&tree[1].bvh, 1);
    CHECK_EQUAL(compare_pairs(), count);
    find_pairs(&tree[2].bvh, 1 + throw_dice(&d, 100));
    CHECK_EQUAL(compare_pairs(), count);
    return count;
}

static void pairs_are_all_pairs_each_once(void) {
    uint32_t s, nt, count, all = 0, since = milliseconds();
    for (s = 0; s < solid_count; s++) {
        running_solid = solids[s].name;
        for (running_variant = 0; running_variant < variant_count && !test_has_failed(); running_variant++) {
            make_solid(&solids[s], &variants[running_variant]);
            count = check_pairs();
            if (solids[s].closed && !variants[running_variant].skew)
                CHECK_EQUAL(count > 0, strcmp(running_solid, "two spheres") == 0);
            all += count;
            drop_world();
        }
    }
    for (nt = 1; nt <= 71 && !test_has_failed(); nt++) {
        make_soup(nt == 71 ? large : nt, &variants[1]);
        all += check_pairs();
        drop_world();
    }
    CHECK(all > 300);
    print_figure("pairs of triangles that intersect", all, "pairs", since);
}

/* ---- T-junctions ---------------------------------------------------------------------------------- */

static uint8_t junction_found[3 * MOST_NT][MOST_NV];
static uint32_t junctions, doubtful;

static long double apart(const long double *a, const long double *b) {
    return sqrtl((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                 (a[2] - b[2]) * (a[2] - b[2]));
}

/* 1: v lies within the edge that c faces; 0: it does not; 2: too near to say. */
static int within_edge(uint32_t c, uint32_t v, long double tolerance) {
    uint32_t end[2], i, k;
    long double p[3], e[2][3], foot[3], along = 0, square = 0, nearest_end, off;
    end[0] = here.V[c % 3 == 2 ? c - 2 : c + 1], end[1] = here.V[c % 3 == 0 ? c + 2 : c - 1];
    if (v == end[0] || v == end[1]) return 0;
    for (k = 0; k < 3; k++) {
        p[k] = (long double)*(&here.G[v].x + k);
        for (i = 0; i < 2; i++) e[i][k] = (long double)*(&here.G[end[i]].x + k);
        along += (p[k] - e[0][k]) * (e[1][k] - e[0][k]);
        square += (e[1][k] - e[0][k]) * (e[1][k] - e[0][k]);
    }
    along = square > 0 ? along / square : 0;
    along = along < 0 ? 0 : along > 1 ? 1 : along;
    for (k = 0; k < 3; k++) foot[k] = e[0][k] + along * (e[1][k] - e[0][k]);
    off = apart(p, foot);
    nearest_end = fminl(apart(p, e[0]), apart(p, e[1]));
    if (off > tolerance * 1.00001L || nearest_end < tolerance * 0.99999L) return 0;
    return off < tolerance * 0.99999L && nearest_end > tolerance * 1.00001L ? 1 : 2;
}

static void find_junctions(const nook_bvh *bvh, float tolerance, uint32_t units_each) {
    nook_t_junctions f;
    nook_status status;
    uint32_t count = 0;
    memset(junction_found, 0, sizeof junction_found);
    CHECK_EQUAL(nook_t_junctions_begin(&f, bvh, tolerance), NOOK_OK);
    do {
        uint32_t units = units_each;
        status = nook_t_junctions_step(&f, &units);
        if (status != NOOK_TRIANGLE) continue;
        count++;
        if (!CHECK(f.corner < 3 * here.view.nt && f.vertex < here.view.nv)) return;
        CHECK_EQUAL(++junction_found[f.corner][f.vertex], 1);
    } while (status == NOOK_TRIANGLE || (status == NOOK_MORE && units_each != UINT32_MAX));
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(f.count, count);
}

static void compare_junctions(float tolerance) {
    uint32_t c, v;
    for (c = 0; c < 3 * here.view.nt; c++) {
        for (v = 0; v < here.view.nv; v++) {
            int expected = here.O[c] != c || here.C[v] == NOOK_STORED_NONE
                               ? 0
                               : within_edge(c, v, (long double)tolerance);
            junctions += expected == 1;
            doubtful += expected == 2;
            if (expected != 2 && !CHECK_EQUAL(junction_found[c][v], expected)) failed_at("T-junction");
        }
    }
}

static void t_junctions_are_all_vertices_within_border_edges(void) {
    static const float tolerances[] = {3e-7f, 1e-4f, 1.1e-3f, 0.1f};
    uint32_t s, i, since = milliseconds();
    for (s = 0; s < solid_count; s++) {
        running_solid = solids[s].name;
        for (running_variant = 0; running_variant < variant_count && !test_has_failed(); running_variant++) {
            make_solid(&solids[s], &variants[running_variant]);
            build_all();
            for (i = 0; i < 4; i++) {
                float tolerance = tolerances[i] * here.size;
                find_junctions(&tree[0].bvh, tolerance, UINT32_MAX);
                compare_junctions(tolerance);
                find_junctions(&tree[1].bvh, tolerance, 1);
                compare_junctions(tolerance);
                find_junctions(&tree[2].bvh, tolerance, 7);
                compare_junctions(tolerance);
            }
            drop_world();
        }
    }
    CHECK(junctions > 1000 && doubtful < junctions / 10);
    print_figure("vertices within border edges", junctions, "T-junctions", since);
}

/* ---- any bits ------------------------------------------------------------------------------------- */

static uint32_t spoiled, refused;

static void is_expected(nook_status status) {
    CHECK(status == NOOK_OK || status == NOOK_INDEX_OUT_OF_RANGE);
    refused += status != NOOK_OK;
}

static void strike(void *array, size_t bytes, uint32_t faults) {
    uint8_t *byte = array;
    uint32_t i;
    if (faults == 0) { /* all of it */
        for (i = 0; i < bytes; i++) byte[i] = (uint8_t)throw_dice(&d, 256);
    }
    while (faults-- > 0) {
        i = throw_dice(&d, (uint32_t)bytes);
        byte[i] = (uint8_t)throw_dice(&d, 256);
    }
}

/* One entry is the first that does not exist. */
static void strike_one(nook_index *array, uint32_t entries, uint32_t end) {
    uint32_t i = throw_dice(&d, entries);
    array[i] = nook_store(end);
}

static void spoil(void) {
    uint32_t what = 1 + throw_dice(&d, 31), faults = throw_dice(&d, 4), nt = here.view.nt;
    if (what & 1) strike(tree[0].boxes, NOOK_BVH_GROUPS(nt) * sizeof(nook_boxes), faults);
    if (what & 2) strike(tree[0].order, nt * sizeof(nook_index), faults);
    if (what & 4) strike(here.V, 3 * nt * sizeof(nook_index), faults);
    if (what & 8) strike(here.O, 3 * nt * sizeof(nook_index), faults);
    if (faults == 1 && (what & 2)) strike_one(tree[0].order, nt, nt);
    if (faults == 1 && (what & 4)) strike_one(here.V, 3 * nt, here.view.nv);
    if (what & 16) strike(here.C, here.view.nv * sizeof(nook_index), faults);
}

static void ask_spoiled_rays(const nook_bvh *bvh, nook_point p, nook_point q) {
    nook_ray r;
    uint32_t kind, units;
    for (kind = 0; kind < 3; kind++) {
        nook_status status = nook_ray_begin(&r, bvh, p, q, NOOK_MAX_T, (nook_ray_kind)kind);
        if (status != NOOK_OK) {
            CHECK_EQUAL(status, NOOK_NOT_FINITE); /* no direction */
            return;
        }
        units = UINT32_MAX;
        is_expected(nook_ray_step(&r, &units));
        CHECK(UINT32_MAX - units <= here.view.nt * 134 / 100 + 10);
        CHECK(r.triangle == NOOK_NONE || r.triangle < here.view.nt);
        (void)nook_ray_normal(&r);
    }
}

static void ask_spoiled(const nook_bvh *bvh) {
    nook_point p = throw_place(here.size), q = throw_place(here.size * 0.1f);
    nook_closest c;
    nook_inside in;
    uint32_t units = UINT32_MAX, bound = here.view.nt * 134 / 100 + 10;
    ask_spoiled_rays(bvh, p, nook_sub(q, p));
    CHECK_EQUAL(nook_closest_begin(&c, bvh, p, q, NOOK_FAR, 0), NOOK_OK);
    is_expected(nook_closest_step(&c, &units));
    CHECK(UINT32_MAX - units <= bound);
    CHECK(c.triangle == NOOK_NONE || c.triangle < here.view.nt);
    units = UINT32_MAX;
    CHECK_EQUAL(nook_inside_begin(&in, bvh, p), NOOK_OK);
    is_expected(nook_inside_step(&in, &units));
    CHECK(UINT32_MAX - units <= bound);
    CHECK(in.on == NOOK_NONE || in.on < here.view.nt);
}

/* Until the end, which must come. */
static void walk_spoiled_pairs(const nook_bvh *bvh) {
    nook_intersections f;
    nook_t_junctions j;
    nook_status status;
    uint32_t nt = here.view.nt, most = 2 * nt * nt + 100 * nt + 100, units = most;
    CHECK_EQUAL(nook_intersections_begin(&f, bvh), NOOK_OK);
    do {
        status = nook_intersections_step(&f, &units);
        if (status == NOOK_TRIANGLE) CHECK(f.t < nt && f.u < nt);
    } while (status == NOOK_TRIANGLE && f.count <= nt * nt);
    is_expected(status);
    units = 8 * most;
    CHECK_EQUAL(nook_t_junctions_begin(&j, bvh, here.size * 0.01f), NOOK_OK);
    do {
        status = nook_t_junctions_step(&j, &units);
        if (status == NOOK_TRIANGLE) CHECK(j.corner < 3 * nt && j.vertex < here.view.nv);
    } while (status == NOOK_TRIANGLE && j.count <= 9 * nt * nt);
    is_expected(status);
}

static void keep_or_restore(bool restore) {
    static nook_boxes boxes[NOOK_BVH_GROUPS(MOST_NT)];
    static nook_index order[MOST_NT], V[3 * MOST_NT], O[3 * MOST_NT], C[MOST_NV];
    size_t nt = here.view.nt, nv = here.view.nv;
    struct {
        void *kept, *used;
        size_t bytes;
    } all[5] = {{boxes, tree[0].boxes, NOOK_BVH_GROUPS(here.view.nt) * sizeof *boxes},
                {order, tree[0].order, nt * sizeof *order},
                {V, here.V, 3 * nt * sizeof *V},
                {O, here.O, 3 * nt * sizeof *O},
                {C, here.C, nv * sizeof *C}};
    uint32_t i;
    for (i = 0; i < 5; i++)
        memcpy(restore ? all[i].used : all[i].kept, restore ? all[i].kept : all[i].used, all[i].bytes);
}

static void spoil_and_ask(void) {
    uint32_t i;
    nook_bvh none = tree[0].bvh;
    none.order = NULL;
    keep_or_restore(false);
    for (i = 0; i < spoilings && !test_has_failed(); i++) {
        spoil();
        ask_spoiled(&tree[0].bvh);
        ask_spoiled(&none);
        if (i % 10 == 0) walk_spoiled_pairs(&tree[0].bvh);
        spoiled++;
        keep_or_restore(true);
    }
}

static void no_bits_in_boxes_order_and_tables_hurt(void) {
    uint32_t s, nt, since = milliseconds();
    for (s = 0; s < solid_count && !test_has_failed(); s++) {
        running_solid = solids[s].name;
        make_solid(&solids[s], &variants[s % variant_count]);
        build_all();
        spoil_and_ask();
        drop_world();
    }
    for (nt = 1; nt <= 70; nt += nt < 20 ? 1 : 7) {
        make_soup(nt, &variants[1]);
        build_all();
        spoil_and_ask();
        drop_world();
    }
    CHECK(refused > spoiled / 10);
    print_figure("spoiled trees", spoiled, "trees", since);
    (void)printf("  %u answers refused\n", (unsigned)refused);
}

/* What the build must say of the first element that is wrong, and of no other that it may name instead. */
static void is_a_fault(nook_status status, nook_where where) {
    if (status == NOOK_INDEX_OUT_OF_RANGE) {
        CHECK_EQUAL(where.kind, NOOK_AT_CORNER);
        CHECK(where.index < 3 * here.view.nt && here.V[where.index] >= here.view.nv);
        return;
    }
    CHECK(status == NOOK_NOT_FINITE || status == NOOK_COORDINATE_TOO_LARGE);
    CHECK_EQUAL(where.kind, NOOK_AT_VERTEX);
    if (CHECK(where.index < here.view.nv)) CHECK_EQUAL(nook_point_status(here.G[where.index]), status);
}

static bool is_sound(void) {
    uint32_t c;
    for (c = 0; c < 3 * here.view.nt; c++) {
        if (here.V[c] >= here.view.nv || nook_point_status(here.G[here.V[c]]) != NOOK_OK) return false;
    }
    return true;
}

static void any_bits_in_points_and_tables_are_reported_by_the_build(void) {
    uint32_t i, sound = 0, since = milliseconds();
    nook_where where = {NOOK_NOWHERE, 0};
    for (i = 0; i < 20 * spoilings && !test_has_failed(); i++) {
        nook_status status;
        uint32_t faults = throw_dice(&d, 3);
        make_soup(1 + throw_dice(&d, 40), &variants[1]);
        if (i % 2) strike(here.V, 3 * here.view.nt * sizeof(nook_index), faults);
        if (i % 3) strike(here.G, here.view.nv * sizeof(nook_point), 1 + throw_dice(&d, 4));
        status = nook_bvh_build(&here.bvh, &here.view, here.boxes, i % 5 ? here.order : NULL, &where);
        CHECK_EQUAL(status == NOOK_OK, is_sound());
        sound += status == NOOK_OK;
        if (status != NOOK_OK) is_a_fault(status, where);
        if (status == NOOK_OK) ask_spoiled(&here.bvh);
        drop_world();
    }
    CHECK(sound > i / 10 && sound < i - i / 10);
    print_figure("builds over any bits", i, "builds", since);
}

int main(int argc, char **argv) {
    static const test tests[] = {
        TEST(boxes_have_room_for_every_level),
        TEST(all_trees_over_a_few_triangles_answer_alike),
        TEST(all_trees_over_a_solid_answer_alike),
        TEST(a_refitted_tree_answers_as_a_new_one),
        TEST(pairs_are_all_pairs_each_once),
        TEST(t_junctions_are_all_vertices_within_border_edges),
        TEST(no_bits_in_boxes_order_and_tables_hurt),
        TEST(any_bits_in_points_and_tables_are_reported_by_the_build),
    };
    if (argc > 1 && strcmp(argv[1], "small") == 0) questions = 8, spoilings = 200, large = 300;
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
