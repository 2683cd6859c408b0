/* test_bvh.c -- trees of every small size over meshes of every kind, and the questions' extremes.
 *
 * What a tree must hold is worked out from the triangles alone, level by level. What a question must answer
 * is worked out from trees of one triangle each, or is known from a drawing. */
#include "rooms.h"

#include "check.h"
#include "nook.h"

#include <string.h>

enum { MOST_NT = 70, MOST_NV = 96, SMALL = NOOK_TEST_RAM < 2000000 };

static struct {
    nook_point G[MOST_NV];
    nook_index V[3 * MOST_NT];
    NOOK_BVH_ARRAYS(MOST_NT) tree, kept;
    nook_view view;
    nook_bvh bvh;
} m;

/* ---- meshes --------------------------------------------------------------------------------------- */

static void begin(void) {
    memset(&m.view, 0, sizeof m.view);
    m.view.G = m.G;
    m.view.V = m.V;
}

static void point(float x, float y, float z) { m.G[m.view.nv++] = nook_make(x, y, z); }

static void triangle(uint32_t a, uint32_t b, uint32_t c) {
    nook_index *V = m.V + 3 * m.view.nt++;
    V[0] = nook_store(a);
    V[1] = nook_store(b);
    V[2] = nook_store(c);
}

static void build(void) {
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, m.tree.order, NULL), NOOK_OK);
}

static nook_point turned(nook_point p, uint32_t axis) {
    return axis == 0 ? p : axis == 1 ? nook_make(p.y, p.z, p.x) : nook_make(p.z, p.x, p.y);
}

static float throw_float(dice *d, float most) { return ((float)throw_dice(d, 2001) - 1000) * 0.001f * most; }

static nook_point throw_point(dice *d, float most) {
    float x = throw_float(d, most), y = throw_float(d, most);
    return nook_make(x, y, throw_float(d, most));
}

/* How the points lie. */
enum { ANYHOW, ON_A_PLANE, ON_A_LINE, IN_ONE_PLACE, IN_TWO_PLACES, NEAR_AND_FAR, KINDS };

static void place(uint32_t v, uint32_t kind, dice *d) {
    nook_point p = throw_point(d, 10);
    if (kind == ON_A_PLANE) p.y = 3;
    if (kind == ON_A_LINE) p = nook_make(p.z, 2, 0.5f * p.z);
    if (kind == IN_ONE_PLACE) p = nook_make(1, 2, 3);
    if (kind == IN_TWO_PLACES) p = nook_make(p.x < 0 ? 1 : -1, 2, 3);
    if (kind == NEAR_AND_FAR) p = nook_scaled(p, p.x < 0 ? 0x1p26f : p.y < 0 ? 1e-30f : 1e-44f);
    m.G[v] = p;
}

static void soup(uint32_t nt, uint32_t kind, dice *d) {
    begin();
    for (; m.view.nv < 3 + nt / 3; m.view.nv++) place(m.view.nv, kind, d);
    while (m.view.nt < nt) {
        uint32_t a = throw_dice(d, m.view.nv), b = throw_dice(d, m.view.nv);
        triangle(a, b, throw_dice(d, m.view.nv));
    }
}

/* Closed, and each turned outward or inward by the dice. */
static void tetrahedra(uint32_t n, dice *d) {
    begin();
    while (n-- > 0) {
        uint32_t v = m.view.nv, i;
        for (i = 0; i < 4; i++) m.G[m.view.nv++] = throw_point(d, 10);
        triangle(v, v + 1, v + 2), triangle(v + 1, v, v + 3);
        triangle(v + 2, v + 1, v + 3), triangle(v, v + 2, v + 3);
    }
    build();
}

static void one_triangle(nook_point a, nook_point b, nook_point c) {
    begin();
    m.G[0] = a, m.G[1] = b, m.G[2] = c;
    m.view.nv = 3;
    triangle(0, 1, 2);
    build();
}

/* ---- the tree ------------------------------------------------------------------------------------- */

static uint32_t expected_low, expected_high;

static void take_cells(uint32_t low, uint32_t high) {
    if (low < expected_low) expected_low = low;
    if (high > expected_high) expected_high = high;
}

/* The cells along an axis of the triangles of a leaf, or of the children of a group. */
static void expect_leaf(uint32_t leaf, uint32_t axis) {
    uint32_t place, i;
    for (place = 4 * leaf; place < 4 * leaf + 4 && place < m.view.nt; place++) {
        uint32_t t = m.bvh.order == NULL ? place : m.bvh.order[place];
        for (i = 0; i < 3; i++) {
            uint32_t cell = nook_cell(&m.bvh, nook_along(&m.G[m.V[3 * t + i]], axis), axis);
            take_cells(cell, cell);
        }
    }
}

static void expect_group(const nook_boxes *group, uint32_t axis) {
    uint32_t i;
    for (i = 0; i < 4; i++) take_cells(group->low[axis][i], group->high[axis][i]);
}

static void every_box_is_that_of_what_is_below(void) {
    uint32_t groups = (m.view.nt + 15) / 16, base = 0, below = 0, children = (m.view.nt + 3) / 4, level, k,
             axis;
    for (level = 1;; level++) {
        for (k = 0; k < 4 * groups; k++) {
            const nook_boxes *group = &m.bvh.boxes[base + k / 4];
            for (axis = 0; axis < 3; axis++) {
                expected_low = NOOK_LAST_CELL, expected_high = 0; /* nothing */
                if (level == 1) expect_leaf(k, axis);
                if (level > 1 && k < children) expect_group(&m.bvh.boxes[below + k], axis);
                CHECK_EQUAL(group->low[axis][k % 4], expected_low);
                CHECK_EQUAL(group->high[axis][k % 4], expected_high);
            }
        }
        if (groups == 1) break;
        below = base;
        base += groups;
        children = groups;
        groups = (groups + 3) / 4;
    }
    CHECK_EQUAL(m.bvh.levels, level);
    CHECK_EQUAL(m.bvh.base[level], base);
    CHECK(base < NOOK_BVH_GROUPS(MOST_NT));
}

/* From the lowest coordinates of all corners to the highest, and the cells are as narrow as that allows. */
static void the_grid_spans_the_mesh(void) {
    uint32_t axis, c;
    for (axis = 0; axis < 3; axis++) {
        float low = nook_along(&m.G[m.V[0]], axis), high = low;
        for (c = 0; c < 3 * m.view.nt; c++) {
            float x = nook_along(&m.G[m.V[c]], axis);
            if (x < low) low = x;
            if (x > high) high = x;
        }
        CHECK(nook_along(&m.bvh.origin, axis) == low);
        CHECK_EQUAL(nook_cell(&m.bvh, low, axis), 0);
        if ((high - low) * 1000 > nook_bvh_size(&m.bvh)) /* else they would be too narrow for floats */
            CHECK(nook_cell(&m.bvh, high, axis) + 1 >= NOOK_LAST_CELL);
    }
}

static void every_triangle_has_one_place(void) {
    uint32_t place, t;
    for (t = 0; t < m.view.nt; t++) {
        uint32_t places = 0;
        for (place = 0; place < m.view.nt; place++) places += m.tree.order[place] == t;
        CHECK_EQUAL(places, 1);
    }
}

static void a_tree_of_any_size_over_any_points_holds_what_it_should(void) {
    dice d = {3};
    uint32_t nt, kind;
    for (nt = 1; nt <= MOST_NT && !test_has_failed(); nt++) {
        for (kind = 0; kind < KINDS; kind++) {
            soup(nt, kind, &d);
            build();
            every_triangle_has_one_place();
            the_grid_spans_the_mesh();
            every_box_is_that_of_what_is_below();
            CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, NULL, NULL), NOOK_OK);
            CHECK(m.bvh.order == NULL);
            every_box_is_that_of_what_is_below();
        }
    }
}

/* Where sixteen clusters of four triangles are: in a square, in a row, in two rows far apart, in a block. */
static nook_point cluster(uint32_t i, uint32_t layout) {
    float x = (float)(i % 4), y = (float)(i / 4), row = (float)(i % 8);
    if (layout == 0) return nook_make(100 * x, 100 * y, 0);
    if (layout == 1) return nook_make(0, 100 * (float)i, 0);
    if (layout == 2) return nook_make(i < 8 ? 0 : 1e6f, 0, row);
    return nook_make(100 * x, i & 4 ? 70 : -70, i & 8 ? 50 : -50);
}

static void four_triangles_in_one_place_share_a_leaf(void) {
    dice d = {53};
    uint32_t layout, axis, i, k;
    for (layout = 0; layout < 4; layout++) {
        for (axis = 0; axis < 3; axis++) {
            uint8_t name[64] = {0};
            begin();
            for (i = 0; i < 64; i++) {
                uint32_t j = throw_dice(&d, i + 1);
                name[i] = name[j];
                name[j] = (uint8_t)i;
            }
            for (i = 0; i < 48; i++, m.view.nv++) {
                nook_point p = cluster(i / 3, layout);
                m.G[i] = turned(nook_make(p.x + (i % 3 == 0 ? 0.1f : 0), p.y + (i % 3 == 1 ? 0.1f : 0), p.z),
                                axis);
            }
            for (i = 0; i < 64; i++) {
                k = 3 * (name[i] / 4u);
                triangle(k, k + 1, k + 2);
            }
            build();
            for (i = 0; i < 64; i++)
                CHECK_EQUAL(name[m.tree.order[i]] / 4, name[m.tree.order[i / 4 * 4]] / 4);
        }
    }
}

static uint32_t build_in_slices(uint32_t slice) {
    nook_bvh_state state;
    nook_status status;
    uint32_t spent = 0;
    CHECK_EQUAL(nook_bvh_begin(&state, &m.bvh, &m.view, m.tree.boxes, m.tree.order, NULL), NOOK_OK);
    do {
        uint32_t units = slice;
        status = nook_bvh_step(&state, &units);
        spent += slice - units;
        if (status == NOOK_MORE) CHECK_EQUAL(units, 0);
    } while (status == NOOK_MORE);
    CHECK_EQUAL(status, NOOK_OK);
    return spent;
}

static void every_slicing_builds_the_same_tree(void) {
    dice d = {5};
    uint32_t nt, kind, slice;
    for (nt = 1; nt <= MOST_NT; nt += 1 + nt / 2) {
        for (kind = 0; kind < KINDS; kind++) {
            uint32_t spent;
            soup(nt, kind, &d);
            spent = build_in_slices(UINT32_MAX);
            memcpy(&m.kept, &m.tree, sizeof m.kept);
            for (slice = 1; slice < 20; slice += 3) {
                memset(&m.tree, 0x5A, sizeof m.tree);
                CHECK_EQUAL(build_in_slices(slice), spent);
                CHECK(memcmp(m.kept.order, m.tree.order, nt * sizeof *m.tree.order) == 0);
                CHECK(memcmp(m.kept.boxes, m.tree.boxes,
                             (m.bvh.base[m.bvh.levels] + 1u) * sizeof *m.tree.boxes) == 0);
            }
        }
    }
}

static nook_status refit(nook_where *where) {
    nook_bvh_state state;
    uint32_t units = UINT32_MAX;
    nook_status status = nook_bvh_refit_begin(&state, &m.bvh, m.tree.boxes, where);
    return status != NOOK_OK ? status : nook_bvh_step(&state, &units);
}

static void a_tree_whose_vertices_moved_is_fitted_anew_in_the_same_order(void) {
    dice d = {7};
    uint32_t nt, kind, v;
    for (nt = 1; nt <= MOST_NT; nt += 1 + nt / 4) {
        for (kind = 0; kind < KINDS; kind++) {
            soup(nt, ANYHOW, &d);
            build();
            memcpy(m.kept.order, m.tree.order, sizeof m.kept.order);
            for (v = 0; v < m.view.nv; v++) place(v, kind, &d);
            CHECK_EQUAL(refit(NULL), NOOK_OK);
            every_box_is_that_of_what_is_below();
            CHECK(memcmp(m.kept.order, m.tree.order, nt * sizeof *m.tree.order) == 0);
        }
    }
}

/* ---- what a tree refuses -------------------------------------------------------------------------- */

static nook_where where;

/* With where and without. */
static void is_refused(nook_status status, nook_kind kind, uint32_t index) {
    where = nook_at(NOOK_AT_LINE, 9);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, m.tree.order, &where), status);
    CHECK(where.kind == kind && where.index == index);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, m.tree.order, NULL), status);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, NULL, NULL), status);
}

static void a_mesh_that_cannot_be_used_is_refused_with_the_place(void) {
    static const uint32_t bits[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x4E800001u, 0xCE800001u};
    dice d = {11};
    uint32_t i, c, axis;
    soup(20, ANYHOW, &d);
    for (c = 0; c < 60; c++) m.V[c] = nook_store(c % m.view.nv); /* all are used */
    for (c = 0; c < 60; c++) {
        nook_index keep = m.V[c];
        m.V[c] = nook_store(c % 2 ? m.view.nv : NOOK_NONE);
        is_refused(NOOK_INDEX_OUT_OF_RANGE, NOOK_AT_CORNER, c);
        m.V[c] = keep;
    }
    for (i = 0; i < 5; i++) {
        for (axis = 0; axis < 3; axis++) {
            uint32_t v = i + axis;
            nook_point keep = m.G[v];
            *nook_axis(&m.G[v], axis) = nook_float_from(bits[i]);
            is_refused(i < 3 ? NOOK_NOT_FINITE : NOOK_COORDINATE_TOO_LARGE, NOOK_AT_VERTEX, v);
            m.G[v] = keep;
        }
    }
    m.G[m.view.nv++] = nook_make(nook_float_from(bits[0]), 0, 0); /* in no triangle */
    build();
    m.view.nt = 0;
    is_refused(NOOK_EMPTY_MESH, NOOK_NOWHERE, 0);
}

static void a_tree_that_was_spoiled_is_not_fitted_anew(void) {
    dice d = {13};
    uint32_t place, bad;
    for (place = 0; place < 21; place += 4) {
        for (bad = 0; bad < 2; bad++) {
            soup(21, ANYHOW, &d);
            build();
            m.tree.order[place] = nook_store(bad ? 21 : NOOK_NONE);
            CHECK_EQUAL(refit(&where), NOOK_INDEX_OUT_OF_RANGE);
            CHECK(where.kind == NOOK_AT_TRIANGLE && where.index == place);
            CHECK_EQUAL(refit(NULL), NOOK_INDEX_OUT_OF_RANGE);
        }
    }
    m.bvh.view.nt = 0;
    CHECK_EQUAL(refit(&where), NOOK_EMPTY_MESH);
    CHECK_EQUAL(where.kind, NOOK_NOWHERE);
    CHECK_EQUAL(refit(NULL), NOOK_EMPTY_MESH);
}

static void a_build_without_what_it_needs_is_refused(void) {
    nook_bvh_state state;
    dice d = {17};
    soup(5, ANYHOW, &d);
    build();
    CHECK_EQUAL(nook_bvh_begin(NULL, &m.bvh, &m.view, m.tree.boxes, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, NULL, &m.view, m.tree.boxes, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, &m.bvh, NULL, m.tree.boxes, NULL, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, NULL, NULL, &where), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_refit_begin(NULL, &m.bvh, m.tree.boxes, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_refit_begin(&state, NULL, m.tree.boxes, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &m.bvh, NULL, NULL), NOOK_NULL_ARGUMENT);
}

/* ---- questions to trees of any size --------------------------------------------------------------- */

static uint32_t units;

/* 1.34 nt + 10 at most. */
static bool in_bounds(uint32_t left) { return (1000 - left) * 100 <= 134 * m.view.nt + 1000; }

static nook_ray ask_ray(const nook_bvh *bvh, nook_point from, nook_point toward, nook_ray_kind kind) {
    nook_ray ray;
    units = 1000;
    CHECK_EQUAL(nook_ray_begin(&ray, bvh, from, toward, NOOK_MAX_T, kind), NOOK_OK);
    CHECK_EQUAL(nook_ray_step(&ray, &units), NOOK_OK);
    CHECK(in_bounds(units));
    return ray;
}

static nook_closest ask_closest(const nook_bvh *bvh, nook_point a, nook_point b) {
    nook_closest c;
    units = 1000;
    CHECK_EQUAL(nook_closest_begin(&c, bvh, a, b, NOOK_FAR, 0), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    CHECK(in_bounds(units));
    return c;
}

/* A tree over one triangle of the mesh. */
static nook_bvh alone(uint32_t t) {
    static nook_boxes boxes[NOOK_BVH_GROUPS(1)];
    nook_view view = m.view;
    nook_bvh bvh;
    view.V += 3 * t;
    view.nt = 1;
    CHECK_EQUAL(nook_bvh_build(&bvh, &view, boxes, NULL, NULL), NOOK_OK);
    return bvh;
}

static void ask_each(nook_point from, nook_point toward, nook_point to) {
    nook_ray ray = ask_ray(&m.bvh, from, toward, NOOK_NEAREST), any = ask_ray(&m.bvh, from, toward, NOOK_ANY);
    nook_ray count = ask_ray(&m.bvh, from, toward, NOOK_CROSSINGS);
    nook_closest near = ask_closest(&m.bvh, from, to);
    uint32_t t, hit = NOOK_NONE, nearest = NOOK_NONE, crossings = 0;
    int32_t winding = 0;
    float at = NOOK_MAX_T, distance = NOOK_FAR;
    bool is_hit = any.triangle == NOOK_NONE;
    for (t = 0; t < m.view.nt; t++) {
        nook_bvh one = alone(t);
        nook_ray r = ask_ray(&one, from, toward, NOOK_NEAREST),
                 c = ask_ray(&one, from, toward, NOOK_CROSSINGS);
        nook_closest n = ask_closest(&one, from, to);
        if (r.triangle == 0 && r.t < at) at = r.t, hit = t;
        if (r.triangle == 0 && any.triangle == t) is_hit = true;
        if (n.distance < distance || (n.distance == distance && near.triangle == t))
            distance = n.distance, nearest = t;
        crossings += c.crossings;
        winding += c.winding;
    }
    CHECK_EQUAL(ray.triangle, hit);
    CHECK(ray.t == at && ray.t_min == at);
    CHECK_EQUAL(any.triangle == NOOK_NONE, hit == NOOK_NONE);
    CHECK(is_hit);
    CHECK_EQUAL(count.crossings, crossings);
    CHECK_EQUAL(count.winding, winding);
    CHECK_EQUAL(near.triangle, nearest);
    CHECK(near.distance == distance);
    CHECK(near.distance_min <= distance && near.distance_max >= distance);
}

static void of_all_triangles_the_nearest_is_found_whatever_the_tree(void) {
    dice d = {19};
    uint32_t nt, kind;
    for (nt = 1; nt <= MOST_NT && !test_has_failed(); nt += SMALL ? 11 : 1) {
        for (kind = 0; kind < (SMALL ? 2 : NEAR_AND_FAR); kind++) {
            nook_point from = throw_point(&d, 15), to;
            soup(nt, kind, &d);
            CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, nt % 3 ? m.tree.order : NULL, NULL),
                        NOOK_OK);
            to = nook_sub(m.G[throw_dice(&d, 3)], from);
            ask_each(from, to, throw_point(&d, 15));
            ask_each(from, throw_point(&d, 9), from);
        }
    }
}

/* A ray, a line along an axis, and the sum of angles. */
static void three_ways_to_count_how_often_tetrahedra_wind_around_a_point_agree(void) {
    dice d = {23};
    uint32_t n, i, around = 0;
    for (n = 1; n <= 17 && !test_has_failed(); n++) {
        tetrahedra(n, &d);
        for (i = 0; i < 6; i++) {
            nook_point p = nook_make(throw_float(&d, 4) + 0.0003f, throw_float(&d, 4), throw_float(&d, 4));
            nook_ray ray = ask_ray(&m.bvh, p, throw_point(&d, 7), NOOK_CROSSINGS);
            nook_closest c;
            nook_inside in;
            nook_winding w;
            float off;
            units = 1000;
            CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_OK);
            CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
            CHECK(in_bounds(units) && in.on == NOOK_NONE);
            units = 1000;
            CHECK_EQUAL(nook_winding_begin(&w, &m.view, p), NOOK_OK);
            CHECK_EQUAL(nook_winding_step(&w, &units), NOOK_OK);
            CHECK_EQUAL(units, 1000 - 4 * n);
            CHECK_EQUAL(in.winding, ray.winding);
            CHECK_EQUAL(in.crossings & 1u, ray.crossings & 1u);
            off = w.number - (float)in.winding;
            CHECK(off < 1e-4f && off > -1e-4f);
            CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, p), NOOK_OK);
            CHECK(in.crossings % 2 == 0 ? c.distance > 0 : c.distance < 0);
            CHECK(c.distance_min > 0 && (c.distance < 0 ? -c.distance : c.distance) <= c.distance_max);
            around += in.winding != 0;
        }
    }
    CHECK(around > 5);
}

static void in_one_place_everything_is_found(void) {
    const nook_point here = {1, 2, 3};
    nook_closest c;
    nook_ray ray;
    nook_inside in;
    float w[3];
    int side;
    uint32_t nt;
    dice d = {29};
    for (nt = 1; nt <= MOST_NT; nt += 23) {
        soup(nt, IN_ONE_PLACE, &d);
        build();
        CHECK_EQUAL(nook_closest_point(&c, &m.bvh, nook_make(1, 6, 6)), NOOK_OK);
        CHECK(c.triangle == 0 && c.distance == 5 && c.point.x == 1 && c.point.y == 2 && c.point.z == 3);
        CHECK_EQUAL(
            nook_ray_cast(&ray, &m.bvh, nook_make(1, 2, 0), nook_make(0, 0, 2), NOOK_MAX_T, NOOK_NEAREST),
            NOOK_OK);
        nook_ray_weights(&ray, w);
        CHECK(ray.triangle == 0 && ray.t == 1.5f && w[0] + w[1] + w[2] == 1);
        CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, nook_make(1, 2, 0), nook_make(1e-30f, 0, 2), NOOK_MAX_T,
                                  NOOK_NEAREST),
                    NOOK_OK);
        CHECK_EQUAL(ray.triangle, NOOK_NONE);
        CHECK_EQUAL(nook_side_of(&m.bvh, here, &side), NOOK_OK);
        CHECK_EQUAL(side, 1); /* on no triangle that has an area */
        CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, here), NOOK_OK);
        units = 100;
        CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
        CHECK(in.on == NOOK_NONE && in.crossings == 0 && in.winding == 0);
        CHECK(in_bounds(units + 900));
    }
}

/* ---- spoiled after the build ---------------------------------------------------------------------- */

static void all_questions_end(nook_status expected) {
    const nook_point at = {1, 2, 3}, from = {1, 2, -5}, up = {0, 0, 1};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_status status;
    int side;
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, from, up, NOOK_MAX_T, NOOK_NEAREST), expected);
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, from, up, NOOK_MAX_T, NOOK_CROSSINGS), expected);
    CHECK_EQUAL(nook_closest_point(&c, &m.bvh, from), expected);
    CHECK_EQUAL(nook_side_of(&m.bvh, at, &side), expected);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, at), expected);
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, at), NOOK_OK);
    do {
        units = 1;
        status = nook_inside_step(&in, &units);
    } while (status == NOOK_MORE);
    CHECK_EQUAL(status, expected);
}

static void tables_spoiled_after_the_build_end_all_questions(void) {
    uint32_t c, t;
    nook_winding w;
    dice d = {31};
    soup(21, IN_ONE_PLACE, &d); /* so that every triangle is looked at */
    build();
    all_questions_end(NOOK_OK);
    for (c = 0; c < 63; c++) {
        nook_index keep = m.V[c];
        m.V[c] = nook_store(c % 2 ? m.view.nv : NOOK_NONE);
        all_questions_end(NOOK_INDEX_OUT_OF_RANGE);
        units = 1000;
        CHECK_EQUAL(nook_winding_begin(&w, &m.view, nook_make(1, 2, 4)), NOOK_OK);
        CHECK_EQUAL(nook_winding_step(&w, &units), NOOK_INDEX_OUT_OF_RANGE);
        CHECK_EQUAL(w.at, c / 3);
        m.V[c] = keep;
    }
    for (t = 0; t < 21; t++) {
        nook_index keep = m.tree.order[t];
        m.tree.order[t] = nook_store(t % 2 ? 21 : NOOK_NONE);
        all_questions_end(NOOK_INDEX_OUT_OF_RANGE);
        m.tree.order[t] = keep;
    }
}

static void boxes_of_any_bits_end_every_question_within_its_bound(void) {
    dice d = {37};
    uint32_t i, k;
    for (i = 0; i < 60; i++) {
        nook_inside in;
        soup(1 + throw_dice(&d, MOST_NT), ANYHOW, &d);
        build();
        for (k = 0; k < sizeof m.tree.boxes; k++) ((uint8_t *)m.tree.boxes)[k] = (uint8_t)throw_dice(&d, 256);
        if (i % 3 == 0) memset(m.tree.boxes, 0xFF, sizeof m.tree.boxes);
        if (i % 3 == 0) memset(m.tree.boxes, 0, sizeof m.tree.boxes[0].low);
        (void)ask_ray(&m.bvh, throw_point(&d, 12), throw_point(&d, 12), NOOK_NEAREST); /* which check units */
        (void)ask_closest(&m.bvh, throw_point(&d, 12), throw_point(&d, 12));
        CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, throw_point(&d, 12)), NOOK_OK);
        units = 1000;
        CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
        CHECK(in_bounds(units));
    }
}

/* ---- rays ----------------------------------------------------------------------------------------- */

/* The triangle (0, 0) (4, 0) (0, 4), in three planes and from each of its corners, and rays in its plane. */
static void a_ray_in_the_plane_of_a_triangle_meets_it_where_it_comes_upon_it(void) {
    static const struct {
        float x, y, dx, dy, t; /* or -1 */
    } list[] = {
        {-1, 1, 1, 0, 1},  {-1, 1, 0.5f, 0, 2}, {5, 1, -1, 0, 2},  {1, 1, 1, 0, 0},    {5, 1, 1, 0, -1},
        {-1, 5, 1, 0, -1}, {-1, 0, 1, 0, 1},    {-1, 4, 1, 0, 1},  {0, -3, 0, 1, 3},   {0, 9, 0, -1, 5},
        {5, -1, -1, 1, 1}, {0, 0, -1, 0, 0},    {4, 0, -1, 1, 0},  {2, 2, 1, 1, 0},    {2.5f, 2.5f, 1, 1, -1},
        {3, 3, -1, -1, 1}, {-2, -1, 2, 1, 1},   {6, -1, -2, 1, 1}, {1, 0, 1, 0, 0},    {4.5f, 0, 1, 0, -1},
        {-1, -1, 1, 2, 1}, {8, 2, -2, -1, 2},   {8, 2, -4, -2, 1}, {-1, -1, 1, 6, -1},
    };
    uint32_t i, axis, k;
    for (i = 0; i < sizeof list / sizeof *list; i++) {
        for (axis = 0; axis < 9; axis++) {
            nook_point p[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, from, to;
            nook_ray ray;
            for (k = 0; k < 3; k++) p[k] = turned(p[k], axis % 3);
            from = turned(nook_make(list[i].x, list[i].y, 0), axis % 3);
            to = turned(nook_make(list[i].dx, list[i].dy, 0), axis % 3);
            one_triangle(p[axis / 3], p[(axis / 3 + 1) % 3], p[(axis / 3 + 2) % 3]);
            ray = ask_ray(&m.bvh, from, to, NOOK_NEAREST);
            CHECK_EQUAL(ray.triangle, list[i].t < 0 ? NOOK_NONE : 0);
            if (list[i].t >= 0) CHECK(ray.t == list[i].t && ray.t_min == ray.t);
            ray = ask_ray(&m.bvh, from, to,
                          NOOK_CROSSINGS); /* it stands aside a trifle, and so beside the plane */
            CHECK_EQUAL(ray.crossings, 0);
        }
        if (test_has_failed()) print_text("ray "), print_number(i), print_text("\n");
    }
}

static void a_direction_may_hardly_rise_and_yet_be_followed_exactly(void) {
    static const struct {
        float y, rise;
        bool hit;
    } list[] = {
        {-0x1p-80f, 0x1p-70f, true}, {-0x1p-80f, 0x1p-90f, false}, {0x1p-80f, -0x1p-70f, false},
        {0x1p-60f, -0x1p-70f, true}, {-0x1p-70f, 0x1p-70f, true},  {-0x1p-70f, 0x1p-71f, false},
        {0, -0x1p-100f, false},      {0, 0x1p-100f, true},         {-0x1p-149f, 0x1p-120f, true},
    };
    static const float speed[] = {1, 0x1p-20f, 0x1p+20f, 0x1p+100f};
    uint32_t i, axis, k;
    for (axis = 0; axis < 3; axis++) {
        one_triangle(turned(nook_make(0, 0, -4), axis), turned(nook_make(0, 8, 0), axis),
                     turned(nook_make(0, 0, 4), axis));
        for (i = 0; i < sizeof list / sizeof *list; i++) {
            for (k = 0; k < 4; k++) {
                nook_point to = nook_scaled(nook_make(1, list[i].rise, 0), speed[k]);
                nook_ray ray = ask_ray(&m.bvh, turned(nook_make(-1, list[i].y, 0), axis), turned(to, axis),
                                       NOOK_NEAREST);
                CHECK_EQUAL(ray.triangle, list[i].hit ? 0 : NOOK_NONE);
                if (list[i].hit) CHECK(ray.t * speed[k] == 1);
            }
        }
    }
}

/* At a small angle t would be lost in rounding, and is exact; for the slowest and fastest directions too. */
static void t_of_a_grazing_ray_is_exact_at_any_speed(void) {
    int32_t k;
    for (k = -124; k <= 124; k += 4) {
        float speed = nook_power_of_two((uint32_t)(127 + k));
        nook_point to = nook_scaled(nook_make(1, 0, 1 + 0x1p-10f), speed);
        nook_ray ray;
        one_triangle(nook_make(-8, -8, -8), nook_make(8, -8, 8), nook_make(0, 8, 0)); /* in the plane z = x */
        ray = ask_ray(&m.bvh, nook_make(-1, 0, -1 - 0x1p-10f), to, NOOK_NEAREST);
        CHECK_EQUAL(ray.triangle, 0);
        CHECK(ray.t * speed == 1);
        ray = ask_ray(&m.bvh, nook_make(-3, 0, -3 - 3 * 0x1p-10f), to, NOOK_NEAREST);
        CHECK(ray.triangle == 0 && ray.t * speed == 3);
        ray = ask_ray(&m.bvh, nook_make(1, 0, 1 + 0x1p-10f), to, NOOK_NEAREST);
        CHECK_EQUAL(ray.triangle, NOOK_NONE);
    }
}

/* Its ends are on different sides of the ray, by less than rounding tells: for u = 2^-23, 1.5 (1 + u) and
 * 1.5 (1 + 3 u) become 1.5 + 2 u and 1.5 + 4 u, which are a half of 3 + 4 u and 3 + 8 u. */
static void an_edge_that_lies_on_a_ray_but_for_rounding_is_met_near_its_ends(void) {
    const float u = 0x1p-23f;
    nook_ray ray;
    one_triangle(nook_make(3 + 4 * u, 1 + u, 0), nook_make(3 + 8 * u, 1 + 3 * u, 0), nook_make(3, 5, 0));
    ray = ask_ray(&m.bvh, nook_make(0, 0, 0), nook_make(3, 1, 0), NOOK_NEAREST);
    CHECK_EQUAL(ray.triangle, 0);
    CHECK(ray.t >= 1 - 4 * u && ray.t <= 1 + 4 * u);
    ray = ask_ray(&m.bvh, nook_make(0, 0, 0), nook_make(3, 0.9999995f, 0), NOOK_NEAREST);
    CHECK_EQUAL(ray.triangle, NOOK_NONE); /* it goes by below both */
}

/* The triangle is so small beside the way to it that rounding is larger than it. */
static void weights_are_weights_where_rounding_leaves_nothing_to_tell_them_by(void) {
    uint32_t inexact = 0;
    float y;
    one_triangle(nook_make(-1e-40f, 0, -1e-40f), nook_make(1e-40f, 0, -1e-40f), nook_make(0, 0, 1e-40f));
    for (y = 0x1p28f; y < 0x1p29f; y += 0x1.4p24f + 32) {
        nook_ray ray = ask_ray(&m.bvh, nook_make(0, -y, 0), nook_make(0, 7, 0), NOOK_NEAREST);
        float w[3], sum, off = ray.t * 7 - y;
        nook_ray_weights(&ray, w);
        sum = w[0] + w[1] + w[2];
        CHECK_EQUAL(ray.triangle, 0);
        CHECK(off <= 32 && off >= -32);
        CHECK(w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && sum > 0.999999f && sum < 1.000001f);
        inexact += ray.t * 7 != y;
    }
    CHECK(inexact > 0);
}

static void a_hit_has_a_normal_as_long_as_its_triangle_is_there_and_has_an_area(void) {
    const nook_point from = {0.25f, 0.25f, 2}, down = {0, 0, -1};
    nook_ray ray;
    nook_point n;
    uint32_t c;
    for (c = 0; c < 3; c++) {
        one_triangle(nook_make(0, 0, 0), nook_make(0, 1, 0), nook_make(1, 0, 0));
        ray = ask_ray(&m.bvh, from, down, NOOK_NEAREST);
        n = nook_ray_normal(&ray);
        CHECK(ray.triangle == 0 && n.x == 0 && n.y == 0 && n.z == -1);
        m.V[c] = 3;
        n = nook_ray_normal(&ray);
        CHECK(n.x == 0 && n.y == 0 && n.z == 0);
    }
    one_triangle(nook_make(0, 0, 0), nook_make(0.25f, 0.25f, 0), nook_make(1, 1, 0));
    ray = ask_ray(&m.bvh, from, down, NOOK_NEAREST);
    n = nook_ray_normal(&ray);
    CHECK(ray.triangle == 0 && ray.t == 2 && n.x == 0 && n.y == 0 && n.z == 0);
    ray = ask_ray(&m.bvh, from, nook_make(0, 1, 0), NOOK_NEAREST);
    n = nook_ray_normal(&ray);
    CHECK(ray.triangle == NOOK_NONE && n.x == 0 && n.y == 0 && n.z == 0);
}

/* ---- distances ------------------------------------------------------------------------------------ */

static void a_search_ends_when_what_it_has_is_near_enough(void) {
    dice d = {41};
    uint32_t i, k;
    for (i = 0; i < 20; i++) {
        nook_point p = throw_point(&d, 30), q = i % 2 ? p : throw_point(&d, 30);
        nook_closest whole, c;
        uint32_t left;
        soup(MOST_NT, ANYHOW, &d);
        build();
        whole = ask_closest(&m.bvh, p, q);
        left = units;
        CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, q, NOOK_FAR, 1e9f), NOOK_OK);
        units = 0;
        CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK); /* any triangle will do */
        CHECK(c.triangle != NOOK_NONE && c.distance_max <= 1e9f && c.distance_min <= whole.distance_max);
        for (k = 0; k < 8; k++) {
            float enough = whole.distance_max * (0.75f + 0.25f * (float)k) + 1e-3f * (float)k;
            CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, q, NOOK_FAR, enough), NOOK_OK);
            units = 1000;
            CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
            CHECK(units >= left);
            CHECK(c.distance_min <= whole.distance_max && c.distance_max >= whole.distance_min);
            if (k > 0) CHECK(c.distance_max <= enough);
            if (k == 0 && enough < whole.distance_min) CHECK(c.distance == whole.distance && units == left);
        }
    }
}

static void nothing_is_named_beyond_the_limit_and_everything_at_it(void) {
    const nook_point p = {1, 1, 3};
    static const float limit[] = {0, 1, 2.9999998f, 3, 3.5f, 1e30f};
    uint32_t i;
    for (i = 0; i < 6; i++) {
        nook_closest c;
        one_triangle(nook_make(0, 0, 0), nook_make(4, 0, 0), nook_make(0, 4, 0));
        CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, limit[i], 0), NOOK_OK);
        units = 100;
        CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
        CHECK_EQUAL(c.triangle, limit[i] < 3 ? NOOK_NONE : 0);
        CHECK(c.distance == (limit[i] < 3 ? limit[i] : 3));
        CHECK(c.distance_min <= 3 && c.distance_max >= 3);
    }
}

static void a_segment_along_any_axis_is_as_far_as_its_nearest_point(void) {
    static const struct {
        nook_point a, b;
        float square, at; /* or -1 */
    } list[] = {
        {{1, 1, 1}, {1, 1, 5}, 1, 0},      {{1, -5, 0}, {1, -2, 0}, 4, 1},
        {{6, 1, 0}, {5, 1, 0}, 2, 1},      {{1, 1, -3}, {1, 1, 1}, 0, -1},
        {{3, -1, 0}, {3, 9, 0}, 0, -1},    {{-1, 1, 0}, {0.5f, 1, 0}, 0, -1},
        {{5, 5, 2}, {5, 5, -2}, 18, 0.5f}, {{-9, -1, 2}, {1, -1, 2}, 5, -1},
        {{1, 1, 4}, {1, 1, 4}, 16, 0},
    };
    uint32_t i, axis;
    for (axis = 0; axis < 3; axis++) {
        one_triangle(turned(nook_make(0, 0, 0), axis), turned(nook_make(4, 0, 0), axis),
                     turned(nook_make(0, 4, 0), axis));
        for (i = 0; i < sizeof list / sizeof *list; i++) {
            nook_closest c = ask_closest(&m.bvh, turned(list[i].a, axis), turned(list[i].b, axis));
            float off = c.distance * c.distance - list[i].square;
            CHECK(off < 1e-4f && off > -1e-4f);
            if (list[i].at >= 0) CHECK(c.at < list[i].at + 1e-4f && c.at > list[i].at - 1e-4f);
            CHECK(c.distance_min * c.distance_min <= list[i].square);
            CHECK(c.distance_max * c.distance_max >= list[i].square);
            CHECK(c.distance_max - c.distance_min <= (list[i].square == 0 ? 0 : 2e-6f * 20));
        }
    }
}

static void a_vertex_is_on_the_lowest_of_its_triangles(void) {
    dice d = {43};
    uint32_t n, v;
    for (n = 1; n <= 17; n += 4) {
        tetrahedra(n, &d);
        for (v = 0; v < m.view.nv; v++) {
            uint32_t lowest = v / 4 * 4 + (v % 4 == 3); /* the first of four has all but the last */
            nook_closest c = ask_closest(&m.bvh, m.G[v], m.G[v]);
            nook_inside in;
            int side = 2;
            CHECK(c.triangle == lowest && c.distance == 0 && c.distance_min == 0);
            CHECK(c.point.x == m.G[v].x && c.point.y == m.G[v].y && c.point.z == m.G[v].z);
            units = 1000;
            CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, m.G[v]), NOOK_OK);
            CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
            CHECK_EQUAL(in.on, lowest);
            CHECK_EQUAL(nook_side_of(&m.bvh, m.G[v], &side), NOOK_OK);
            CHECK_EQUAL(side, 0);
            CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, m.G[v]), NOOK_OK);
            CHECK(c.distance == 0);
        }
    }
}

/* ---- angles --------------------------------------------------------------------------------------- */

static bool near(float x, float y, float tolerance) { return x - y <= tolerance && y - x <= tolerance; }

/* From a corner whose edges are at right angles the face beyond it is an eighth of all that is seen; the
 * three that meet at the corner are seen edgewise. */
static void a_corner_of_a_cube_sees_an_eighth(void) {
    nook_winding w;
    uint32_t calls = 0;
    begin();
    point(0, 0, 0), point(2, 0, 0), point(0, 2, 0), point(0, 0, 2);
    triangle(0, 2, 1), triangle(0, 1, 3), triangle(0, 3, 2), triangle(1, 2, 3);
    CHECK_EQUAL(nook_winding_begin(&w, &m.view, m.G[0]), NOOK_OK);
    do {
        units = 1;
        calls++;
    } while (nook_winding_step(&w, &units) == NOOK_MORE);
    CHECK_EQUAL(calls, 4);
    CHECK(near(w.number, 0.125f, 1e-6f));
    m.view.nt = 0;
    CHECK_EQUAL(nook_winding_begin(&w, &m.view, m.G[0]), NOOK_OK);
    CHECK_EQUAL(nook_winding_step(&w, &units), NOOK_OK);
    CHECK(w.number == 0);
}

static void an_angle_is_that_of_the_circle(void) {
    static const float sine[] = {0,           0.25881905f, 0.5f, 0.70710678f,
                                 0.86602540f, 0.96592583f, 1}; /* of 15 degrees each */
    int32_t i;
    uint32_t k;
    for (i = -12; i <= 12; i++) {
        int32_t a = i < 0 ? -i : i, b = a > 6 ? 12 - a : a;
        float y = i < 0 ? -sine[b] : sine[b], x = a > 6 ? -sine[6 - b] : sine[6 - b];
        float angle = (float)i * 0.26179939f;
        if (i == -12) continue; /* that is +12 */
        for (k = 0; k < 3; k++) {
            float scale = k == 0 ? 1 : k == 1 ? 1e-30f : 1e30f;
            CHECK(near(nook_angle(y * scale, x * scale), angle, 4e-7f * (float)(a < 2 ? 1 : a) * 0.26f));
        }
    }
    CHECK(nook_angle(0, 0) == 0 && nook_angle(0, 5) == 0 && nook_angle(-0.0f, 0) == 0);
    CHECK(nook_angle(1e-45f, 0) > 1.57f && nook_angle(-1e-45f, 0) < -1.57f);
}

static void a_triangle_without_area_has_no_normal_and_equal_weights(void) {
    static const nook_point list[][3] = {
        {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}, {4, 2, 3}},
        {{1, 2, 3}, {4, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {4, 2, 3}, {4, 2, 3}},
        {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 0, 0}, {0x1p-140f, 0, 0}, {-0x1p-139f, 0, 0}},
    };
    uint32_t i;
    for (i = 0; i < sizeof list / sizeof *list; i++) {
        nook_point n = nook_normal(list[i]);
        float w[3];
        CHECK(n.x == 0 && n.y == 0 && n.z == 0);
        nook_barycentric(list[i], nook_make(5, -7, 1), w);
        CHECK(near(w[0], 1.0f / 3.0f, 1e-7f) && w[1] == 1.0f / 3.0f && w[2] == 1.0f / 3.0f);
    }
}

static void normals_and_weights_do_not_depend_on_size(void) {
    static const float size[] = {1e-37f, 1e-20f, 1, 1e5f, 0x1p29f};
    uint32_t i, axis;
    for (i = 0; i < 5; i++) {
        for (axis = 0; axis < 3; axis++) {
            float s = size[i], w[3];
            nook_point p[3], n, unit = turned(nook_make(0, 0, 1), axis);
            p[0] = turned(nook_make(-s, -s, s), axis);
            p[1] = turned(nook_make(s, -s, s), axis);
            p[2] = turned(nook_make(-s, s, s), axis);
            n = nook_normal(p);
            CHECK(near(n.x, unit.x, 1e-6f) && near(n.y, unit.y, 1e-6f) && near(n.z, unit.z, 1e-6f));
            nook_barycentric(p, turned(nook_make(0, -0.5f * s, 0), axis), w); /* seen along the normal */
            CHECK(near(w[0], 0.25f, 1e-6f) && near(w[1], 0.5f, 1e-6f) && near(w[2], 0.25f, 1e-6f));
            nook_barycentric(p, p[2], w);
            CHECK(near(w[0], 0, 1e-6f) && near(w[1], 0, 1e-6f) && near(w[2], 1, 1e-6f));
            nook_barycentric(p, turned(nook_make(s, s, -s), axis),
                             w); /* beyond the edge that the first faces */
            CHECK(near(w[0], -1, 1e-6f) && near(w[1], 1, 1e-6f) && near(w[2], 1, 1e-6f));
        }
    }
}

/* ---- what questions refuse ------------------------------------------------------------------------ */

static void a_question_without_a_tree_or_a_place_for_the_answer_is_refused(void) {
    const nook_point p = {1, 2, 3};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_winding w;
    nook_bvh empty;
    int side;
    one_triangle(nook_make(0, 0, 0), nook_make(4, 0, 0), nook_make(0, 4, 0));
    empty = m.bvh;
    empty.view.nt = 0;
    CHECK_EQUAL(nook_ray_begin(NULL, &m.bvh, p, p, 1, NOOK_ANY), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_ray_cast(&ray, NULL, p, p, 1, NOOK_ANY), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_ray_cast(&ray, &empty, p, p, 1, NOOK_ANY), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_closest_begin(NULL, &m.bvh, p, p, 1, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_closest_point(&c, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_closest_point(&c, &empty, p), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_inside_begin(NULL, &m.bvh, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_inside_begin(&in, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_inside_begin(&in, &empty, p), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_side_of(&m.bvh, p, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_side_of(NULL, p, &side), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_side_of(&empty, p, &side), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_signed_distance(NULL, &m.bvh, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_signed_distance(&c, &empty, p), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_winding_begin(NULL, &m.view, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_winding_begin(&w, NULL, p), NOOK_NULL_ARGUMENT);
}

static void a_place_that_is_none_is_refused(void) {
    static const uint32_t bits[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x4E800001u, 0xCE800001u};
    const nook_point p = {1, 2, 3};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_winding w;
    uint32_t i, axis;
    one_triangle(nook_make(0, 0, 0), nook_make(4, 0, 0), nook_make(0, 4, 0));
    for (i = 0; i < 5; i++) {
        nook_status status = i < 3 ? NOOK_NOT_FINITE : NOOK_COORDINATE_TOO_LARGE;
        for (axis = 0; axis < 3; axis++) {
            nook_point bad = p;
            *nook_axis(&bad, axis) = nook_float_from(bits[i]);
            CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, bad, p, 1, NOOK_ANY), status);
            CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, bad, 1, NOOK_ANY), i < 3 ? NOOK_NOT_FINITE : NOOK_OK);
            CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, bad, p, 1, 0), status);
            CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, bad, 1, 0), status);
            CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, bad), status);
            CHECK_EQUAL(nook_winding_begin(&w, &m.view, bad), status);
        }
    }
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, nook_make(0, -0.0f, 0), 1, NOOK_ANY), NOOK_NOT_FINITE);
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, nook_make(0, 0, 1e-45f), 1, NOOK_ANY), NOOK_OK);
}

static const test tests[] = {
    TEST(a_tree_of_any_size_over_any_points_holds_what_it_should),
    TEST(four_triangles_in_one_place_share_a_leaf),
    TEST(every_slicing_builds_the_same_tree),
    TEST(a_tree_whose_vertices_moved_is_fitted_anew_in_the_same_order),
    TEST(a_mesh_that_cannot_be_used_is_refused_with_the_place),
    TEST(a_tree_that_was_spoiled_is_not_fitted_anew),
    TEST(a_build_without_what_it_needs_is_refused),
    TEST(of_all_triangles_the_nearest_is_found_whatever_the_tree),
    TEST(three_ways_to_count_how_often_tetrahedra_wind_around_a_point_agree),
    TEST(in_one_place_everything_is_found),
    TEST(tables_spoiled_after_the_build_end_all_questions),
    TEST(boxes_of_any_bits_end_every_question_within_its_bound),
    TEST(a_ray_in_the_plane_of_a_triangle_meets_it_where_it_comes_upon_it),
    TEST(a_direction_may_hardly_rise_and_yet_be_followed_exactly),
    TEST(t_of_a_grazing_ray_is_exact_at_any_speed),
    TEST(an_edge_that_lies_on_a_ray_but_for_rounding_is_met_near_its_ends),
    TEST(weights_are_weights_where_rounding_leaves_nothing_to_tell_them_by),
    TEST(a_hit_has_a_normal_as_long_as_its_triangle_is_there_and_has_an_area),
    TEST(a_search_ends_when_what_it_has_is_near_enough),
    TEST(nothing_is_named_beyond_the_limit_and_everything_at_it),
    TEST(a_segment_along_any_axis_is_as_far_as_its_nearest_point),
    TEST(a_vertex_is_on_the_lowest_of_its_triangles),
    TEST(a_corner_of_a_cube_sees_an_eighth),
    TEST(an_angle_is_that_of_the_circle),
    TEST(a_triangle_without_area_has_no_normal_and_equal_weights),
    TEST(normals_and_weights_do_not_depend_on_size),
    TEST(a_question_without_a_tree_or_a_place_for_the_answer_is_refused),
    TEST(a_place_that_is_none_is_refused),
};

void test_bvh(void) { run_tests(tests, sizeof tests / sizeof *tests); }
