/* test_meet.c -- which triangles meet, alone and in one mesh; all pairs of a mesh; vertices on edges.
 *
 * Single pairs are literals that a reader can draw, most of them about one triangle in the plane z = 0; each
 * is tried in all turns, in both orders, and along all axes. The pairs that a tree finds are those that
 * trying every pair finds. T-junctions are those of combs, whose number is known. */
#include "rooms.h"

#include "check.h"
#include "nook.h"

#include <string.h>

enum { MOST_NT = 41, MOST_NV = 3 * MOST_NT };

static struct {
    nook_point G[MOST_NV];
    nook_index V[3 * MOST_NT], O[3 * MOST_NT], C[MOST_NV];
    NOOK_BVH_ARRAYS(MOST_NT) tree;
    nook_view view;
    nook_bvh bvh;
} m;

/* ---- meshes --------------------------------------------------------------------------------------- */

static void begin(void) {
    memset(&m.view, 0, sizeof m.view);
    m.view.G = m.G;
    m.view.V = m.V;
    m.view.O = m.O;
    m.view.C = m.C;
}

static void point(float x, float y, float z) { m.G[m.view.nv++] = nook_make(x, y, z); }

static void triangle(uint32_t a, uint32_t b, uint32_t c) {
    nook_index *V = m.V + 3 * m.view.nt++;
    V[0] = nook_store(a);
    V[1] = nook_store(b);
    V[2] = nook_store(c);
}

/* Opposite corners face the same edge in opposite directions; others are their own. */
static void link(void) {
    uint32_t c, e;
    for (c = 0; c < 3 * m.view.nt; c++) {
        m.O[c] = nook_store(c);
        m.C[m.V[c]] = nook_store(c);
        for (e = 0; e < 3 * m.view.nt; e++) {
            if (m.V[nook_next(e)] == m.V[nook_prev(c)] && m.V[nook_prev(e)] == m.V[nook_next(c)])
                m.O[c] = nook_store(e);
        }
    }
}

static void build(void) {
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, m.tree.order, NULL), NOOK_OK);
}

/* Triangles of three vertices each, the same in every place. */
static void pile(uint32_t nt) {
    begin();
    while (m.view.nt < nt) {
        uint32_t v = m.view.nv;
        point(0, 0, 0), point(4, 0, 1), point(0, 4, 1);
        triangle(v, v + 1, v + 2);
    }
    link();
    build();
}

/* ---- two triangles -------------------------------------------------------------------------------- */

typedef struct pair {
    nook_point a[3], b[3];
    bool meet;
} pair;

static nook_point turned(nook_point p, uint32_t axis) {
    return axis == 0 ? p : axis == 1 ? nook_make(p.y, p.z, p.x) : nook_make(p.z, p.x, p.y);
}

/* In all turns of both, both ways round, in both orders, along all axes. */
static void meet_or_not(const pair *list, uint32_t n) {
    uint32_t k, i, axis;
    for (; n-- > 0 && !test_has_failed(); list++) {
        for (axis = 0; axis < 3; axis++) {
            nook_point a[3], b[3];
            for (i = 0; i < 3; i++) a[i] = turned(list->a[i], axis), b[i] = turned(list->b[i], axis);
            for (k = 0; k < 36; k++) {
                const nook_point *p[3], *q[3];
                for (i = 0; i < 3; i++) {
                    p[i] = &a[(i + k) % 3];
                    q[k < 18 ? i : 2 - i] = &b[(i + k / 3) % 3];
                }
                CHECK_EQUAL(nook_triangles_meet(p, q), list->meet);
                CHECK_EQUAL(nook_triangles_meet(q, p), list->meet);
            }
        }
        if (test_has_failed()) print_text("with pairs left: "), print_number(n), print_text("\n");
    }
}

#define MEET_OR_NOT(list) meet_or_not(list, sizeof(list) / sizeof *(list))
#define FLAT                                                                                                 \
    {                                                                                                        \
        {0, 0, 0}, {4, 0, 0}, { 0, 4, 0 }                                                                    \
    }
/* In the plane z = x. */
#define SLANTING                                                                                             \
    {                                                                                                        \
        {0, 0, 0}, {4, 0, 4}, { 0, 4, 0 }                                                                    \
    }

static void triangles_in_two_planes_meet_where_an_edge_of_one_goes_through_the_other(void) {
    static const pair list[] = {
        {FLAT, {{1, 1, -1}, {1, 1, 1}, {3, 3, 1}}, true},   /* an edge through the inner part */
        {FLAT, {{3, 3, -1}, {3, 3, 1}, {1, 1, 3}}, false},  /* beside the longest edge */
        {FLAT, {{-1, 2, -1}, {9, 2, -1}, {2, 2, 9}}, true}, /* its inner part crossed by an edge of flat */
        {FLAT, {{1, 1, -1}, {9, 1, -1}, {1, 1, 3}}, true},  /* one edge of each through the other */
        {FLAT, {{2, 2, -1}, {2, 2, 1}, {5, 5, 0}}, true},   /* edge through edge */
        {FLAT, {{4, 0, -1}, {4, 0, 1}, {5, 1, 0}}, true},   /* edge through a corner */
        {FLAT, {{1, 1, 3}, {3.5f, 1, -0.5f}, {4.5f, 1, -0.5f}}, false}, /* one beyond the other's line */
        {FLAT, {{-2, 1, -1}, {2, 1, 3}, {2, 2, 3}}, false},             /* flat lies on one side of it */
        {SLANTING, {{1, 1, 1.5f}, {2, 1, 2.5f}, {1, 2, 1.5f}}, false},  /* in parallel planes */
        {SLANTING, {{1, 1, 0.5f}, {2, 1, 1.5f}, {1, 2, 0.5f}}, false},
        {FLAT, {{1, 1, 9}, {2, 1, 8}, {1, 2, 7}}, false},
    };
    MEET_OR_NOT(list);
}

static void triangles_that_touch_at_a_point_meet_and_those_a_last_place_apart_do_not(void) {
    static const pair list[] = {
        {FLAT, {{1, 1, 0}, {1, 1, 3}, {2, 2, 3}}, true}, /* a corner in the inner part */
        {FLAT, {{2, 2, 0}, {3, 3, 1}, {2, 2, 5}}, true}, /* on the longest edge */
        {FLAT, {{2, 2.0000002f, 0}, {3, 3, 1}, {2, 2, 5}}, false},
        {FLAT, {{4, 0, 0}, {5, 0, 1}, {5, 1, 3}}, true}, /* on a corner */
        {FLAT, {{4.0000005f, 0, 0}, {5, 0, 1}, {5, 1, 3}}, false},
        {FLAT, {{1, 1, 1e-45f}, {1, 1, 3}, {2, 2, 3}}, false},
        {FLAT, {{1, 1, 0}, {1, 1, 1e-45f}, {1, 2, 1e-45f}}, true},
        {FLAT, {{-1, 0, 0}, {5, 0, 0}, {2, -1, 1}}, true}, /* edge along edge */
        {SLANTING, {{1, 1, 1.0000001f}, {2, 1, 2.0000002f}, {1, 2, 1.0000001f}}, false},
        {SLANTING, {{1, 1, 1}, {2, 1, 2.0000002f}, {1, 2, 1.0000001f}}, true},
        {SLANTING, {{1, 1, 1}, {2, 1, 2}, {1, 2, 1}}, true},
        /* Above flat's inner part, and the plane of the second goes by flat's corner a last place away. */
        {FLAT, {{-2, 1, -1.9999999f}, {2, 1, 2.0000002f}, {2, 2, 2.0000002f}}, false},
    };
    MEET_OR_NOT(list);
}

static void triangles_in_one_plane_meet_unless_a_line_parts_them(void) {
    static const pair list[] = {
        {FLAT, FLAT, true},
        {FLAT, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, true},        /* inside */
        {FLAT, {{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}, true},  /* around */
        {FLAT, {{-1, 1, 0}, {5, 1, 0}, {5, 2, 0}}, true},       /* across, no corner in the other */
        {FLAT, {{3, 3, 0}, {-1, 3, 0}, {3, -1, 0}}, true},      /* a star of six points */
        {FLAT, {{4, 0, 0}, {0, 4, 0}, {4, 4, 0}}, true},        /* along an edge */
        {FLAT, {{2, 2, 0}, {4, 4, 0}, {3, 4, 0}}, true},        /* a corner on an edge */
        {FLAT, {{4, 0, 0}, {5, 0, 0}, {4, -1, 0}}, true},       /* corner on corner */
        {FLAT, {{2.5f, 2.5f, 0}, {4, 4, 0}, {3, 4, 0}}, false}, /* boxes overlap, one edge parts */
        {FLAT, {{2, 2.0000002f, 0}, {4, 4, 0}, {3, 4, 0}}, false},
        {FLAT, {{5, 0, 0}, {9, 0, 0}, {5, 4, 0}}, false}, /* boxes do not */
        {SLANTING, {{1, -1, 1}, {1, 5, 1}, {3, 5, 3}}, true},
        {SLANTING, {{3, 2, 3}, {4, 4, 4}, {3, 4, 3}}, false},
    };
    MEET_OR_NOT(list);
}

static void a_segment_or_a_point_meets_what_it_touches(void) {
    static const pair list[] = {
        {FLAT, {{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}, true}, /* through */
        {FLAT, {{1, 1, -1}, {1, 1, 1}, {1, 1, 0.5f}}, true},
        {FLAT, {{1, 1, 0}, {1, 1, 1}, {1, 1, 1}}, true}, /* ends on it */
        {FLAT, {{3, 3, -1}, {3, 3, 1}, {3, 3, 1}}, false},
        {FLAT, {{1, 1, 1}, {2, 1, 2}, {2, 1, 2}}, false},
        {FLAT, {{1, 3, -1}, {5, 1, 1}, {5, 1, 1}}, false}, /* through the plane at (3, 2) */
        {FLAT, {{-1, 1, 0}, {5, 1, 0}, {2, 1, 0}}, true},  /* in the plane, across */
        {FLAT, {{1, 1, 0}, {2, 1, 0}, {1, 1, 0}}, true},   /* inside */
        {FLAT, {{3, 3, 0}, {4, 2, 0}, {4, 2, 0}}, false},  /* beside, boxes overlap */
        {FLAT, {{0, 4, 0}, {5, 4, 0}, {2, 4, 0}}, true},
        {FLAT, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, true}, /* a point */
        {FLAT, {{4, 0, 0}, {4, 0, 0}, {4, 0, 0}}, true},
        {FLAT, {{3, 3, 0}, {3, 3, 0}, {3, 3, 0}}, false},
        {SLANTING, {{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}, false},
        {SLANTING, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, true},
    };
    MEET_OR_NOT(list);
}

static void segments_meet_if_they_cross_or_overlap(void) {
    static const pair list[] = {
        {{{0, 0, 0}, {2, 2, 2}, {2, 2, 2}}, {{0, 2, 1}, {2, 0, 1}, {0, 2, 1}}, true},
        {{{0, 0, 0}, {2, 2, 2}, {2, 2, 2}}, {{0, 2, 1.25f}, {2, 0, 1.25f}, {0, 2, 1.25f}}, false}, /* skew */
        {{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, {{2, 0, 0.5f}, {0, 2, 0.75f}, {0, 2, 0.75f}}, false},
        {{{0, 0, 0}, {0, 2, 2}, {0, 1, 1}}, {{0, 0, 1}, {0, 1, 2}, {0, 0, 1}}, false}, /* parallel */
        {{{0, 0, 0}, {0, 4, 4}, {0, 4, 4}},
         {{0, 0, 4}, {0, 1, 2}, {0, 1, 2}},
         false}, /* too short to cross */
        {{{0, 0, 0}, {0, 4, 4}, {0, 4, 4}}, {{0, 0, 4}, {0, 3, 1}, {0, 3, 1}}, true},
        {{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, {{1, 1, 1}, {3, 3, 3}, {2, 2, 2}}, true}, /* on one line */
        {{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, {{3, 3, 3}, {4, 4, 4}, {3, 3, 3}}, false},
        {{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}},
         {{1.5f, 1.5f, 1.5f}, {1.5f, 1.5f, 1.5f}, {1.5f, 1.5f, 1.5f}},
         true},
        {{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, {{1, 1, 1.5f}, {1, 1, 1.5f}, {1, 1, 1.5f}}, false},
        {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, true},
        {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{1, 2, 4}, {1, 2, 4}, {1, 2, 4}}, false},
    };
    MEET_OR_NOT(list);
}

/* ---- two triangles of one mesh -------------------------------------------------------------------- */

/* Vertices 0 1 2 are the flat triangle, unless told otherwise; then come others. */
typedef struct joint {
    uint8_t a[3], b[3];
    nook_point G[4]; /* from vertex 2 on */
    bool intersect;
} joint;

static void intersect_or_not(const joint *list, uint32_t n) {
    uint32_t k, i, axis;
    for (; n-- > 0 && !test_has_failed(); list++) {
        for (axis = 0; axis < 3; axis++) {
            begin();
            m.G[0] = nook_make(0, 0, 0);
            m.G[1] = turned(nook_make(4, 0, 0), axis);
            for (i = 0; i < 4; i++) m.G[2 + i] = turned(list->G[i], axis);
            m.view.nv = 6;
            for (k = 0; k < 36; k++) {
                for (i = 0; i < 3; i++) {
                    m.V[i] = list->a[(i + k) % 3];
                    m.V[3 + (k < 18 ? i : 2 - i)] = list->b[(i + k / 3) % 3];
                }
                m.view.nt = 2;
                CHECK_EQUAL(nook_triangles_intersect(&m.view, 0, 1), list->intersect);
                CHECK_EQUAL(nook_triangles_intersect(&m.view, 1, 0), list->intersect);
            }
        }
        if (test_has_failed()) print_text("with joints left: "), print_number(n), print_text("\n");
    }
}

#define INTERSECT_OR_NOT(list) intersect_or_not(list, sizeof(list) / sizeof *(list))
#define AT_CORNER                                                                                            \
    {0, 1, 2}, { 0, 3, 4 }
#define AT_EDGE                                                                                              \
    {0, 1, 2}, { 1, 0, 3 }

static void at_a_common_corner_triangles_intersect_if_one_reaches_the_edge_that_faces_it(void) {
    static const joint list[] = {
        {AT_CORNER, {{0, 4, 0}, {-1, -1, 1}, {-2, -1, 1}}, false},
        {AT_CORNER, {{0, 4, 0}, {1, 1, 1}, {2, 1, 1}}, false}, /* above */
        {AT_CORNER, {{0, 4, 0}, {1, 1, -1}, {1, 1, 1}}, true}, /* the edge goes through flat */
        {AT_CORNER, {{0, 4, 0}, {3, 3, -1}, {3, 3, 1}}, true}, /* flat's edge through it */
        {AT_CORNER,
         {{0, 4, 0}, {-3, -3, -1}, {-3, -3, 1}},
         false},                                                  /* it is on the other side of the corner */
        {AT_CORNER, {{0, 4, 0}, {1, 1, 1}, {-3, -2, -1}}, false}, /* it goes by beside the corner */
        {AT_CORNER, {{0, 4, 0}, {1, 1, 0}, {1, 1, 1}}, true},     /* a corner on flat */
        {AT_CORNER, {{0, 4, 0}, {2, 2, 0}, {5, 5, 1}}, true},     /* on the edge that faces */
        {AT_CORNER, {{0, 4, 0}, {1, 1, 1e-45f}, {1, 1, 1}}, false},
    };
    INTERSECT_OR_NOT(list);
}

static void in_one_plane_at_a_common_corner_triangles_intersect_unless_a_line_parts_them(void) {
    static const joint list[] = {
        {AT_CORNER, {{0, 4, 0}, {5, 1, 0}, {5, 2, 0}}, true},        /* sticks out beyond flat */
        {AT_CORNER, {{0, 4, 0}, {3, 2, 0}, {2, 3, 0}}, true},        /* hardly */
        {AT_CORNER, {{0, 4, 0}, {1, 0.5f, 0}, {0.5f, 1, 0}}, true},  /* lies in flat */
        {AT_CORNER, {{0, 4, 0}, {4.8f, -1.2f, 0}, {2, 4, 0}}, true}, /* goes around a corner of flat */
        {AT_CORNER, {{0, 4, 0}, {-1, -1, 0}, {-2, -1, 0}}, false},
        {AT_CORNER, {{0, 4, 0}, {-1, 0, 0}, {0, -1, 0}}, false}, /* goes on both of flat's edges backward */
        {AT_CORNER, {{0, 4, 0}, {-1, 3, 0}, {-3, 1, 0}}, false}, /* boxes overlap */
        {AT_CORNER, {{0, 4, 0}, {8, 0, 0}, {4, -4, 0}}, true},   /* along an edge */
        {AT_CORNER, {{0, 4, 0}, {2, 0, 0}, {4, -4, 0}}, true},
    };
    INTERSECT_OR_NOT(list);
}

static void at_a_common_edge_triangles_intersect_only_if_folded_upon_one_another(void) {
    static const joint list[] = {
        {AT_EDGE, {{0, 4, 0}, {0, -4, 0}}, false},      {AT_EDGE, {{0, 4, 0}, {1, 1, 0}}, true},
        {AT_EDGE, {{0, 4, 0}, {-9, 1, 0}}, true},       {AT_EDGE, {{0, 4, 0}, {1, 1, 1e-45f}}, false},
        {AT_EDGE, {{0, 4, 0}, {1, 1, -1e-45f}}, false}, {AT_EDGE, {{0, 4, 0}, {0, 0, 4}}, false},
        {AT_EDGE, {{0, 4, 0}, {0, 4, 0}}, true}, /* the same but for a number */
    };
    INTERSECT_OR_NOT(list);
}

static void triangles_of_the_same_three_vertices_intersect(void) {
    static const joint list[] = {
        {{0, 1, 2}, {0, 1, 2}, {{0, 4, 0}}, true},
        {{0, 1, 2}, {2, 1, 0}, {{0, 4, 0}}, true},
    };
    INTERSECT_OR_NOT(list);
}

static void triangles_without_area_intersect_nothing(void) {
    static const joint list[] = {
        {{0, 1, 2},
         {3, 4, 5},
         {{0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 0}},
         false}, /* though it goes through */
        {{0, 1, 2}, {3, 4, 5}, {{0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 2, 0}}, true},
        {AT_CORNER, {{0, 4, 0}, {1, 1, 0}, {2, 2, 0}}, false},
        {AT_EDGE, {{2, 0, 0}, {1, 1, 0}}, false},
        {AT_EDGE, {{2, 0, 0}, {3, 0, 0}}, false},
        {{0, 1, 2}, {0, 1, 2}, {{2, 0, 0}}, false},
    };
    INTERSECT_OR_NOT(list);
}

static void vertices_are_told_apart_by_number_not_by_place(void) {
    static const joint list[] = {
        /* The edge of flat again, under other numbers. */
        {{0, 1, 2}, {3, 4, 5}, {{0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {0, -4, 0}}, true},
        {{0, 1, 2}, {3, 0, 5}, {{0, 4, 0}, {4, 0, 0}, {0, 0, 0}, {0, -4, 0}}, true},
    };
    INTERSECT_OR_NOT(list);
}

/* ---- all pairs of a mesh -------------------------------------------------------------------------- */

static void soup(uint32_t nt, uint32_t nv, uint32_t sides, dice *d) {
    begin();
    while (m.view.nv < nv) {
        float x = (float)throw_dice(d, sides), y = (float)throw_dice(d, sides);
        point(x, y, (float)throw_dice(d, sides));
    }
    while (m.view.nt < nt) {
        uint32_t a = throw_dice(d, nv), b = throw_dice(d, nv);
        triangle(a, b, throw_dice(d, nv));
    }
}

/* Each pair once and no other, in slices of so many units; how many units that took. */
static uint32_t finds_what_trying_all_pairs_finds(uint32_t slice) {
    static uint8_t seen[MOST_NT][MOST_NT];
    nook_intersections q;
    nook_status status;
    uint32_t t, u, units, spent = 0, count = 0;
    memset(seen, 0, sizeof seen);
    CHECK_EQUAL(nook_intersections_begin(&q, &m.bvh), NOOK_OK);
    do {
        units = slice;
        status = nook_intersections_step(&q, &units);
        spent += slice - units;
        if (status == NOOK_MORE) CHECK_EQUAL(units, 0);
        if (status != NOOK_TRIANGLE) continue;
        CHECK(q.t < q.u && q.u < m.view.nt);
        CHECK_EQUAL(seen[q.t][q.u]++, 0);
        CHECK_EQUAL(q.count, ++count);
    } while ((status == NOOK_MORE || status == NOOK_TRIANGLE) && !test_has_failed());
    CHECK_EQUAL(status, NOOK_OK);
    for (t = 0; t < m.view.nt; t++) {
        for (u = t + 1; u < m.view.nt; u++) CHECK_EQUAL(seen[t][u], nook_triangles_intersect(&m.view, t, u));
    }
    CHECK_EQUAL(nook_intersections_step(&q, &units), NOOK_OK); /* and so it stays */
    return spent;
}

static void a_tree_finds_the_pairs_that_trying_all_of_them_finds(void) {
    dice d = {47};
    uint32_t nt;
    for (nt = 1; nt <= MOST_NT && !test_has_failed(); nt++) {
        uint32_t spent;
        soup(nt, 3 + nt, nt % 3 == 0 ? 3 : 20, &d);
        CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, nt % 2 ? m.tree.order : NULL, NULL),
                    NOOK_OK);
        spent = finds_what_trying_all_pairs_finds(UINT32_MAX);
        CHECK(spent * 100 <= 134 * nt * nt + 1000 * nt);
        CHECK_EQUAL(finds_what_trying_all_pairs_finds(1), spent);
        CHECK_EQUAL(finds_what_trying_all_pairs_finds(7), spent);
    }
}

static void of_a_pile_all_pairs_intersect(void) {
    uint32_t nt, units, count;
    for (nt = 1; nt <= MOST_NT; nt += 5) {
        nook_intersections q;
        pile(nt);
        CHECK_EQUAL(nook_intersections_begin(&q, &m.bvh), NOOK_OK);
        units = UINT32_MAX, count = 0;
        while (nook_intersections_step(&q, &units) == NOOK_TRIANGLE && count < 1000) count++;
        CHECK_EQUAL(count, nt * (nt - 1) / 2);
        CHECK_EQUAL(q.count, count);
    }
}

/* Those of a row are apart, and so are their leaves: each begins, and goes by the root and one group to
 * itself. Of a pile each leaf meets all; but what comes before is passed by, a group of four at once. */
static void a_search_goes_only_where_boxes_overlap_and_not_where_it_has_been(void) {
    uint32_t axis, i;
    for (axis = 0; axis < 3; axis++) {
        begin();
        while (m.view.nt < 41) {
            for (i = 0; i < 3; i++) {
                float along = (float)(6 * m.view.nt + i);
                m.G[m.view.nv++] = turned(nook_make(along, i == 1, i == 2), axis);
            }
            triangle(m.view.nv - 3, m.view.nv - 2, m.view.nv - 1);
        }
        CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.tree.boxes, NULL, NULL), NOOK_OK);
        CHECK(finds_what_trying_all_pairs_finds(5) <= 11 * 4);
    }
    pile(41);
    CHECK(finds_what_trying_all_pairs_finds(5) <= 4 * (2 + 3 + 11) + 4 * (2 + 3 + 7) + 3 * (2 + 3 + 3));
}

static void the_search_for_pairs_ends_at_what_is_spoiled(void) {
    nook_intersections q;
    nook_status status;
    uint32_t units = 100;
    CHECK_EQUAL(nook_intersections_begin(&q, &m.bvh), NOOK_OK);
    do status = nook_intersections_step(&q, &units);
    while (status == NOOK_TRIANGLE);
    CHECK_EQUAL(status, NOOK_INDEX_OUT_OF_RANGE);
    CHECK(q.count <= 6); /* at most those of the first leaf with itself */
}

static void spoiled_tables_end_the_search_for_pairs(void) {
    uint32_t c, t;
    for (c = 0; c < 24; c++) { /* in the first leaf, or in the second only */
        pile(8);
        m.V[c] = nook_store(c % 2 ? m.view.nv : NOOK_NONE);
        the_search_for_pairs_ends_at_what_is_spoiled();
    }
    for (t = 0; t < 8; t++) {
        pile(8);
        m.tree.order[t] = nook_store(t % 2 ? 8 : NOOK_NONE);
        the_search_for_pairs_ends_at_what_is_spoiled();
    }
}

/* A flipped bit may come between two steps, when pairs of a leaf are still to be tried. */
static void a_table_spoiled_between_two_pairs_is_not_followed(void) {
    uint32_t c;
    for (c = 0; c < 12; c++) {
        nook_intersections q;
        nook_status status;
        uint32_t units = 100;
        pile(4);
        CHECK_EQUAL(nook_intersections_begin(&q, &m.bvh), NOOK_OK);
        CHECK_EQUAL(nook_intersections_step(&q, &units), NOOK_TRIANGLE);
        m.V[c] = nook_store(c % 2 ? m.view.nv : NOOK_NONE);
        do status = nook_intersections_step(&q, &units);
        while (status == NOOK_TRIANGLE);
        CHECK_EQUAL(status, NOOK_INDEX_OUT_OF_RANGE);
    }
}

static void a_search_without_a_tree_is_refused(void) {
    nook_intersections q;
    nook_t_junctions j;
    nook_bvh empty;
    pile(2);
    empty = m.bvh;
    empty.view.nt = 0;
    CHECK_EQUAL(nook_intersections_begin(NULL, &m.bvh), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_intersections_begin(&q, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_intersections_begin(&q, &empty), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_t_junctions_begin(NULL, &m.bvh, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_t_junctions_begin(&j, NULL, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_t_junctions_begin(&j, &empty, 0), NOOK_EMPTY_MESH);
    m.bvh.view.O = NULL;
    CHECK_EQUAL(nook_t_junctions_begin(&j, &m.bvh, 0), NOOK_NULL_ARGUMENT);
    m.bvh.view.O = m.O, m.bvh.view.C = NULL;
    CHECK_EQUAL(nook_t_junctions_begin(&j, &m.bvh, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_intersections_begin(&q, &m.bvh), NOOK_OK); /* which needs neither */
}

/* ---- T-junctions ---------------------------------------------------------------------------------- */

/* On the left of the line x = 0 a square of two triangles, whose right edge is as long as all teeth together.
 *
 *     2 ---- 1 \
 *     |    / | / 5    vertices 0 to 3 are the square's, then come those of the teeth: their tips, and
 *     |  /   4 \      between two of them one on the line, below it the tooth that is named for it
 *     3 ---- 0 /                                                                                       */
static void comb(uint32_t teeth, uint32_t axis) {
    uint32_t i, v, below = 0;
    begin();
    point(0, 0, 0), point(0, (float)teeth, 0), point(-1, (float)teeth, 0), point(-1, 0, 0);
    triangle(0, 1, 3), triangle(1, 2, 3);
    for (i = 0; i < teeth; i++) {
        uint32_t above = 1;
        point(1, (float)i + 0.5f, 0);
        if (i + 1 < teeth) above = m.view.nv, point(0, (float)i + 1, 0);
        triangle(below, 4 + 2 * i, above);
        below = above;
    }
    for (v = 0; v < m.view.nv; v++) m.G[v] = turned(m.G[v], axis);
    link();
    build();
}

/* All junctions are within the edge that corner faces, each vertex once. */
static uint32_t junctions(float tolerance, uint32_t corner, uint32_t slice) {
    static bool seen[MOST_NV];
    nook_t_junctions q;
    nook_status status;
    uint32_t count = 0;
    memset(seen, 0, sizeof seen);
    CHECK_EQUAL(nook_t_junctions_begin(&q, &m.bvh, tolerance), NOOK_OK);
    do {
        uint32_t units = slice;
        status = nook_t_junctions_step(&q, &units);
        if (status == NOOK_MORE) CHECK_EQUAL(units, 0);
        if (status != NOOK_TRIANGLE) continue;
        CHECK_EQUAL(q.corner, corner);
        CHECK(!seen[q.vertex] && q.vertex > 4 && q.vertex % 2 == 1);
        seen[q.vertex] = true;
        CHECK_EQUAL(q.count, ++count);
    } while (status == NOOK_MORE || status == NOOK_TRIANGLE);
    CHECK_EQUAL(status, NOOK_OK);
    return count;
}

static void every_vertex_between_two_teeth_of_a_comb_is_a_t_junction(void) {
    uint32_t teeth, axis;
    for (teeth = 1; teeth <= MOST_NT - 2; teeth += teeth < 6 ? 1 : 11) {
        for (axis = 0; axis < 3; axis++) {
            comb(teeth, axis);
            CHECK_EQUAL(junctions((float)teeth * 0x1p-22f, 2, UINT32_MAX), teeth - 1);
            CHECK_EQUAL(junctions(1e-3f, 2, UINT32_MAX), teeth - 1);
            CHECK_EQUAL(junctions(1e-3f, 2, 1), teeth - 1);
            CHECK_EQUAL(junctions(1e-3f, 2, 3), teeth - 1);
        }
    }
}

static void a_vertex_farther_from_the_edge_than_the_tolerance_is_no_junction(void) {
    comb(4, 0);
    m.G[5].x = 0.125f; /* not too far, as it is moved away from the edges of its teeth too */
    build();
    CHECK_EQUAL(junctions(0.0625f, 2, 100), 2);
    CHECK_EQUAL(junctions(0.125f, 2, 100), 3);
    m.G[5].x = 0, m.G[5].z = -0.125f;
    build();
    CHECK_EQUAL(junctions(0.0625f, 2, 100), 2);
    CHECK_EQUAL(junctions(0.125f, 2, 100), 3);
}

static void a_vertex_as_near_to_an_end_as_the_tolerance_is_no_junction(void) {
    comb(2, 0);
    m.G[5].y = 0.125f;
    build();
    CHECK_EQUAL(junctions(0.0625f, 2, 100), 1);
    CHECK_EQUAL(junctions(0.125f, 2, 100), 0);
    m.G[5].y = 2 - 0.125f;
    build();
    CHECK_EQUAL(junctions(0.0625f, 2, 100), 1);
    CHECK_EQUAL(junctions(0.125f, 2, 100), 0);
}

static void a_vertex_in_line_with_an_edge_but_beyond_its_ends_is_no_junction(void) {
    float y;
    for (y = -0.5f; y < 2; y += 2) { /* the edge is from 0 to 1 */
        begin();
        point(0, 0, 0), point(0, 1, 0), point(-1, 1, 0);
        point(2, y, -1), point(2, y, 1), point(0, y, 0);
        triangle(0, 1, 2), triangle(3, 4, 5);
        link();
        build();
        CHECK_EQUAL(junctions(0.25f, 2, 100), 0);
        m.G[5].y = 0.5f;
        build();
        CHECK_EQUAL(junctions(0.25f, 2, 100), 1);
    }
}

static void an_edge_with_two_triangles_has_no_junctions(void) {
    comb(2, 0);
    m.G[5] = nook_make(-0.5f, 1, 0); /* in the middle of the square, on its diagonal */
    build();
    CHECK_EQUAL(junctions(1e-3f, 2, 100), 0);
}

static void spoiled_tables_end_the_search_for_junctions(void) {
    uint32_t c, units;
    for (c = 0; c < 24; c++) {
        nook_t_junctions q;
        nook_status status;
        pile(8);
        m.V[c] = nook_store(c % 2 ? m.view.nv : NOOK_NONE);
        CHECK_EQUAL(nook_t_junctions_begin(&q, &m.bvh, 0.5f), NOOK_OK);
        units = 100;
        status = nook_t_junctions_step(&q, &units);
        CHECK_EQUAL(status, NOOK_INDEX_OUT_OF_RANGE);
        CHECK(units > 0);
    }
    for (c = 0; c < 8; c++) {
        nook_t_junctions q;
        pile(8);
        m.tree.order[c] = nook_store(c % 2 ? 8 : NOOK_NONE);
        CHECK_EQUAL(nook_t_junctions_begin(&q, &m.bvh, 0.5f), NOOK_OK);
        units = 100;
        CHECK_EQUAL(nook_t_junctions_step(&q, &units), NOOK_INDEX_OUT_OF_RANGE);
    }
}

static const test tests[] = {
    TEST(triangles_in_two_planes_meet_where_an_edge_of_one_goes_through_the_other),
    TEST(triangles_that_touch_at_a_point_meet_and_those_a_last_place_apart_do_not),
    TEST(triangles_in_one_plane_meet_unless_a_line_parts_them),
    TEST(a_segment_or_a_point_meets_what_it_touches),
    TEST(segments_meet_if_they_cross_or_overlap),
    TEST(at_a_common_corner_triangles_intersect_if_one_reaches_the_edge_that_faces_it),
    TEST(in_one_plane_at_a_common_corner_triangles_intersect_unless_a_line_parts_them),
    TEST(at_a_common_edge_triangles_intersect_only_if_folded_upon_one_another),
    TEST(triangles_of_the_same_three_vertices_intersect),
    TEST(triangles_without_area_intersect_nothing),
    TEST(vertices_are_told_apart_by_number_not_by_place),
    TEST(a_tree_finds_the_pairs_that_trying_all_of_them_finds),
    TEST(of_a_pile_all_pairs_intersect),
    TEST(a_search_goes_only_where_boxes_overlap_and_not_where_it_has_been),
    TEST(spoiled_tables_end_the_search_for_pairs),
    TEST(a_table_spoiled_between_two_pairs_is_not_followed),
    TEST(a_search_without_a_tree_is_refused),
    TEST(every_vertex_between_two_teeth_of_a_comb_is_a_t_junction),
    TEST(a_vertex_farther_from_the_edge_than_the_tolerance_is_no_junction),
    TEST(a_vertex_as_near_to_an_end_as_the_tolerance_is_no_junction),
    TEST(a_vertex_in_line_with_an_edge_but_beyond_its_ends_is_no_junction),
    TEST(an_edge_with_two_triangles_has_no_junctions),
    TEST(spoiled_tables_end_the_search_for_junctions),
};

void test_meet(void) { run_tests(tests, sizeof tests / sizeof *tests); }
