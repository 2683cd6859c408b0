/* test_query.c -- rays, distances, insides and pairs: what others are known to have got wrong, what is
 * refused, any budget.
 *
 * The known failures are those that users of other libraries have reported; the thread stands beside each
 * test. That answers are right in general is held by make prove (queries, nearest, trees, pairs); that all
 * machines and both widths give the same is shown here by one digest. */
#include "rooms.h"

#include "check.h"
#include "nook.h"

#include <string.h>

enum { MOST_NT = 312, MOST_NV = 168, GRID_PAIRS = NOOK_TEST_RAM < 2000000 ? 400 : 20000 };

static struct {
    nook_point G[MOST_NV];
    nook_index V[3 * MOST_NT], O[3 * MOST_NT], C[MOST_NV];
    nook_boxes boxes[NOOK_BVH_GROUPS(MOST_NT)];
    nook_index order[MOST_NT];
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

static uint32_t point(float x, float y, float z) {
    m.G[m.view.nv] = nook_make(x, y, z);
    return m.view.nv++;
}

static void triangle(uint32_t a, uint32_t b, uint32_t c) {
    nook_index *V = m.V + 3 * m.view.nt++;
    V[0] = nook_store(a);
    V[1] = nook_store(b);
    V[2] = nook_store(c);
}

/* Borders: no other corner faces the edge. */
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
    nook_where where = {NOOK_NOWHERE, 0};
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.boxes, m.order, &where), NOOK_OK);
}

/* Vertex i has bit 0 of i along x, bit 1 along y, bit 2 along z. */
static void add_box(nook_point low, nook_point high, bool cavity) {
    static const uint8_t list[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    uint32_t i, first = m.view.nv;
    for (i = 0; i < 8; i++) {
        (void)point(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    }
    for (i = 0; i < 12; i++) {
        triangle(first + list[i][0], first + list[i][cavity ? 2 : 1], first + list[i][cavity ? 1 : 2]);
    }
}

static void box(float x, float y, float z) {
    begin();
    add_box(nook_make(-x, -y, -z), nook_make(x, y, z), false);
    build();
}

static void octahedron(float size) {
    static const uint8_t list[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                       {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    uint32_t i;
    begin();
    for (i = 0; i < 6; i++) {
        float at = i % 2 ? -size : size;
        (void)point(i < 2 ? at : 0, i / 2 == 1 ? at : 0, i > 3 ? at : 0);
    }
    for (i = 0; i < 8; i++) triangle(list[i][0], list[i][1], list[i][2]);
    build();
}

/* 12 x 13 squares; circles by turning a point 12 and 13 times. */
static void torus(float scale) {
    float c = 1, s = 0;
    uint32_t i, j;
    begin();
    for (i = 0; i < 12; i++) {
        float u = 1, w = 0, keep;
        for (j = 0; j < 13; j++) {
            (void)point((3.5f + 1.5f * u) * c * scale, (3.5f + 1.5f * u) * s * scale, 1.5f * w * scale);
            keep = u * 0.8854560f - w * 0.4647232f;
            w = w * 0.8854560f + u * 0.4647232f;
            u = keep;
        }
        keep = c * 0.8660254f - s * 0.5f;
        s = s * 0.8660254f + c * 0.5f;
        c = keep;
    }
    for (i = 0; i < 12; i++) {
        for (j = 0; j < 13; j++) {
            uint32_t k = (i + 1) % 12, l = (j + 1) % 13;
            triangle(13 * i + j, 13 * k + j, 13 * k + l);
            triangle(13 * i + j, 13 * k + l, 13 * i + l);
        }
    }
    build();
}

static void one_triangle(nook_point a, nook_point b, nook_point c) {
    begin();
    (void)point(a.x, a.y, a.z);
    (void)point(b.x, b.y, b.z);
    (void)point(c.x, c.y, c.z);
    triangle(0, 1, 2);
    build();
}

/* ---- questions ------------------------------------------------------------------------------------ */

static nook_ray cast(nook_point origin, nook_point direction, nook_ray_kind kind) {
    nook_ray ray;
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, origin, direction, NOOK_MAX_T, kind), NOOK_OK);
    return ray;
}

static nook_point weights(const nook_ray *ray) {
    float w[3];
    nook_ray_weights(ray, w);
    return nook_make(w[0], w[1], w[2]);
}

static nook_closest distance(nook_point a, nook_point b) {
    nook_closest c;
    uint32_t units = UINT32_MAX;
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, a, b, NOOK_FAR, 0), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    return c;
}

static int side(nook_point p) {
    int side = 2;
    CHECK_EQUAL(nook_side_of(&m.bvh, p, &side), NOOK_OK);
    return side;
}

static nook_point middle(nook_point a, nook_point b) {
    return nook_make((a.x + b.x) * 0.5f, (a.y + b.y) * 0.5f, (a.z + b.z) * 0.5f);
}

static nook_point corner(uint32_t c) { return m.G[m.V[c]]; }

static nook_point unit_along(uint32_t axis, float length) {
    return nook_make(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
}

static bool near(float x, float y) { return x - y < 1e-5f && y - x < 1e-5f; }
static bool same_bits(float a, float b) { return nook_float_bits(a) == nook_float_bits(b); }

/* ---- what others have got wrong: rays ------------------------------------------------------------- */

static const float scales[] = {1e-3f, 1, 1e4f};

/* From inside through every vertex and the middle of every edge: something is hit, and an odd number
 * crossed. */
static void leave_through_everything(nook_point from) {
    uint32_t c;
    for (c = 0; c < 3 * m.view.nt; c++) {
        nook_point to_vertex = nook_sub(corner(c), from);
        nook_point to_edge = nook_sub(middle(corner(nook_next(c)), corner(nook_prev(c))), from);
        CHECK(cast(from, to_vertex, NOOK_NEAREST).triangle != NOOK_NONE);
        CHECK(cast(from, to_edge, NOOK_ANY).triangle != NOOK_NONE);
        CHECK_EQUAL(cast(from, to_vertex, NOOK_CROSSINGS).crossings & 1u, 1);
        CHECK_EQUAL(cast(from, to_edge, NOOK_CROSSINGS).winding, 1);
    }
}

/* RenderKit/embree 174 and 181: rays through vertices of watertight meshes miss. */
static void no_ray_slips_out_between_triangles(void) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        octahedron(scales[i]);
        leave_through_everything(nook_make(0, 0, 0));
        leave_through_everything(nook_make(0.25f * scales[i], 0.125f * scales[i], -0.3f * scales[i]));
        box(scales[i], 0.5f * scales[i], 3 * scales[i]);
        leave_through_everything(nook_make(0, 0, 0));
        torus(scales[i]);
        leave_through_everything(nook_make(3.5f * scales[i], 0.1f * scales[i], 0));
    }
}

/* RenderKit/embree 188: the edge between two triangles is hit twice. */
static void an_edge_and_a_vertex_are_crossed_once(void) {
    uint32_t axis;
    for (axis = 0; axis < 3; axis++) {
        nook_ray ray;
        box(1, 1, 1); /* each axis goes through the diagonal of a face */
        ray = cast(unit_along(axis, -5), unit_along(axis, 1), NOOK_CROSSINGS);
        CHECK_EQUAL(ray.crossings, 2);
        CHECK_EQUAL(ray.winding, 0);
        ray = cast(nook_make(-3, -3, -3), nook_make(1, 1, 1), NOOK_CROSSINGS);
        CHECK_EQUAL(ray.crossings, 2);
        octahedron(1); /* and through two vertices */
        ray = cast(unit_along(axis, 5), unit_along(axis, -1), NOOK_CROSSINGS);
        CHECK_EQUAL(ray.crossings, 2);
        ray = cast(nook_make(0, 0, 0), unit_along(axis, 1), NOOK_CROSSINGS);
        CHECK_EQUAL(ray.crossings, 1);
        CHECK_EQUAL(ray.winding, 1);
    }
}

/* A ray that only touches an edge or a vertex from outside crosses two triangles there, or none. */
static void what_is_only_touched_is_not_entered(void) {
    octahedron(1);
    CHECK_EQUAL(cast(nook_make(-1, 0, 1), nook_make(1, 0, 0), NOOK_CROSSINGS).winding, 0);
    CHECK_EQUAL(cast(nook_make(-1, 0, 1), nook_make(1, 0, 0), NOOK_CROSSINGS).crossings & 1u, 0);
    CHECK(cast(nook_make(-1, 0, 1), nook_make(1, 0, 0), NOOK_NEAREST).triangle != NOOK_NONE);
    box(1, 1, 1);
    CHECK_EQUAL(cast(nook_make(-3, 1, 1), nook_make(1, 0, 0), NOOK_CROSSINGS).winding, 0);
    CHECK_EQUAL(cast(nook_make(-3, 1, 0), nook_make(1, 0, 0), NOOK_CROSSINGS).crossings & 1u, 0);
    CHECK(cast(nook_make(-3, 1, 1), nook_make(1, 0, 0), NOOK_NEAREST).triangle != NOOK_NONE);
    CHECK(cast(nook_make(-3, 1.0000001f, 1), nook_make(1, 0, 0), NOOK_NEAREST).triangle == NOOK_NONE);
}

/* RenderKit/embree 387 and 423: hits far away from long thin triangles. */
static void a_thin_triangle_is_hit_only_where_it_is(void) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        float s = scales[i];
        uint32_t k;
        one_triangle(nook_make(0, 0, 0), nook_make(1000 * s, 700 * s, 0.01f * s),
                     nook_make(1000 * s, 700.001f * s, 0.01f * s));
        for (k = 1; k < 100; k++) {
            float x = 10 * s * (float)k;
            CHECK_EQUAL(cast(nook_make(x, x * 0.7f + 0.01f * s, s), nook_make(0, 0, -1), NOOK_ANY).triangle,
                        NOOK_NONE);
            CHECK_EQUAL(cast(nook_make(x, x * 0.7f - 0.01f * s, s), nook_make(0, 0, -1), NOOK_ANY).triangle,
                        NOOK_NONE);
            CHECK_EQUAL(cast(nook_make(1000.1f * s, x, 5 * s), nook_make(0, 0.3f, -1), NOOK_ANY).triangle,
                        NOOK_NONE);
        }
        CHECK_EQUAL(cast(nook_make(0, 0, s), nook_make(0, 0, -1), NOOK_ANY).triangle, 0);
        CHECK_EQUAL(cast(nook_make(1000 * s, 700 * s, s), nook_make(0, 0, -1), NOOK_ANY).triangle, 0);
    }
}

/* A ray along a face, an edge, or from a point of the surface: what it lies in is met at its beginning. */
static void a_ray_in_the_surface_is_met_where_it_begins(void) {
    nook_ray ray;
    box(1, 1, 1);
    ray = cast(nook_make(-3, 0.25f, 1), nook_make(2, 0, 0), NOOK_NEAREST);
    CHECK(ray.triangle != NOOK_NONE && ray.t == 1);
    ray = cast(nook_make(0, 0.25f, 1), nook_make(1, 0, 0), NOOK_NEAREST);
    CHECK(ray.triangle != NOOK_NONE && ray.t == 0);
    ray = cast(nook_make(-1, 1, 1), nook_make(1, 0, 0), NOOK_NEAREST);
    CHECK(ray.triangle != NOOK_NONE && ray.t == 0);
}

/* In the line of a segment, and through a triangle that is a point. */
static void what_has_no_area_is_met_where_it_is(void) {
    nook_ray ray;
    one_triangle(nook_make(0, 0, 0), nook_make(2, 0, 0), nook_make(1, 0, 0));
    ray = cast(nook_make(-1, 0, 0), nook_make(1, 0, 0), NOOK_NEAREST);
    CHECK(ray.triangle == 0 && ray.t == 1);
    ray = cast(nook_make(0.5f, -2, 0), nook_make(0, 1, 0), NOOK_NEAREST);
    CHECK(ray.triangle == 0 && ray.t == 2);
    CHECK_EQUAL(cast(nook_make(2.5f, -2, 0), nook_make(0, 1, 0), NOOK_NEAREST).triangle, NOOK_NONE);
    CHECK_EQUAL(cast(nook_make(0.5f, -2, 0), nook_make(0, 1, 0), NOOK_CROSSINGS).crossings, 0);
    one_triangle(nook_make(1, 1, 1), nook_make(1, 1, 1), nook_make(1, 1, 1));
    ray = cast(nook_make(0, 0, 0), nook_make(0.5f, 0.5f, 0.5f), NOOK_NEAREST);
    CHECK(ray.triangle == 0 && ray.t == 2 && near(weights(&ray).x + weights(&ray).y + weights(&ray).z, 1));
    CHECK_EQUAL(cast(nook_make(0, 0, 0), nook_make(-0.5f, -0.5f, -0.5f), NOOK_ANY).triangle, NOOK_NONE);
    CHECK_EQUAL(cast(nook_make(0, 0, 0), nook_make(0.5f, 0.5f, 0.50000006f), NOOK_ANY).triangle, NOOK_NONE);
}

/* Nearly in the plane of a triangle, where the quotient that gives t is one of two roundings: it must be
 * where the triangle is, which is from 1 behind the origin to 1 ahead, whatever the direction's length. */
static void a_ray_nearly_in_the_plane_of_a_triangle_hits_it_within_its_bounds(void) {
    static const float lengths[] = {1, 0x1p-110f, 0x1p110f};
    uint32_t i;
    for (i = 0; i < 3; i++) {
        nook_ray ray;
        const nook_point to = {0, -0x1.a28p-11f, 0x1.17p-10f};
        one_triangle(nook_make(0x1.9fc2p-8f, -0x1.c51f34p-9f, 0x1.c6dd9ap-9f),
                     nook_make(0x1.9fc2p-8f, -0x1.4b2f9ap-8f, 0x1.6eeeccp-8f),
                     nook_make(0x1.e2c4p-9f, -0x1.b3cf9ap-8f, 0x1.2076ccp-8f));
        ray = cast(nook_make(0x1.e2c4p-9f, -0x1.7f7f9ap-8f, 0x1.b56d98p-9f), nook_scaled(to, lengths[i]),
                   NOOK_NEAREST);
        CHECK_EQUAL(ray.triangle, 0);
        CHECK(ray.t >= 0 && ray.t * lengths[i] < 1.00001f);
    }
}

/* Directions may have any length, and components that are nearly nothing. */
static void a_direction_may_be_of_any_length(void) {
    static const float lengths[] = {1e-37f, 0x1p-101f, 1e-20f, 1, 1e20f, 0x1p102f, 1e37f};
    uint32_t i;
    for (i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        float s = lengths[i];
        nook_ray ray;
        box(1, 1, 1);
        ray = cast(nook_make(-3, 0.25f, 0.125f), nook_make(s, 0, 0), NOOK_NEAREST);
        CHECK(ray.triangle != NOOK_NONE && near(ray.t * s, 2));
        ray = cast(nook_make(-3, 0.25f, 0.125f), nook_make(s, s * 0x1p-24f, -s * 0x1p-25f), NOOK_NEAREST);
        CHECK(ray.triangle != NOOK_NONE && near(ray.t * s, 2));
        ray = cast(nook_make(-3, 1, 1), nook_make(s, s * 1e-30f, 0),
                   NOOK_NEAREST); /* hits at s = 1, rises at s > 1e-8 */
        CHECK_EQUAL(ray.triangle == NOOK_NONE, s * 1e-30f > 0);
        ray = cast(nook_make(-3, 1, 1), nook_make(s, s * -1e-30f, 0), NOOK_NEAREST);
        CHECK(ray.triangle != NOOK_NONE);
    }
}

static void of_equal_hits_the_lowest_triangle_is_named(void) {
    uint32_t k;
    nook_ray ray;
    begin();
    for (k = 0; k < 40; k++) {
        uint32_t a = point(0, 0, 0), b = point(1, 0, 0), c = point(0, 1, 0);
        triangle(k % 2 ? b : a, k % 2 ? a : b, c);
    }
    build();
    ray = cast(nook_make(0.25f, 0.25f, -2), nook_make(0, 0, 0.5f), NOOK_NEAREST);
    CHECK_EQUAL(ray.triangle, 0);
    CHECK(ray.t == 4 && ray.t_min == 4);
    CHECK(weights(&ray).x == 0.5f && weights(&ray).y == 0.25f && weights(&ray).z == 0.25f);
    CHECK_EQUAL(cast(nook_make(0.25f, 0.25f, -2), nook_make(0, 0, 0.5f), NOOK_CROSSINGS).crossings, 40);
    CHECK_EQUAL(cast(nook_make(0.25f, 0.25f, -2), nook_make(0, 0, 0.5f), NOOK_CROSSINGS).winding, 0);
    CHECK_EQUAL(distance(nook_make(0.25f, 0.25f, -2), nook_make(0.25f, 0.25f, -2)).triangle, 0);
    CHECK_EQUAL(distance(nook_make(0.25f, 0.25f, 0), nook_make(0.25f, 0.25f, 0)).triangle, 0);
}

static void a_hit_beyond_t_max_is_none_and_one_at_it_is(void) {
    nook_ray ray;
    one_triangle(nook_make(0, 0, 0), nook_make(1, 0, 0), nook_make(0, 1, 0));
    CHECK_EQUAL(
        nook_ray_cast(&ray, &m.bvh, nook_make(0.25f, 0.25f, 3), nook_make(0, 0, -2), 1.5f, NOOK_NEAREST),
        NOOK_OK);
    CHECK(ray.triangle == 0 && ray.t == 1.5f);
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, nook_make(0.25f, 0.25f, 3), nook_make(0, 0, -2), 1.4999999f,
                              NOOK_NEAREST),
                NOOK_OK);
    CHECK_EQUAL(ray.triangle, NOOK_NONE);
    CHECK(ray.t == 1.4999999f && ray.t_min == ray.t);
    CHECK_EQUAL(
        nook_ray_cast(&ray, &m.bvh, nook_make(0.25f, 0.25f, 3), nook_make(0, 0, 2), NOOK_MAX_T, NOOK_ANY),
        NOOK_OK);
    CHECK_EQUAL(ray.triangle, NOOK_NONE); /* it lies behind */
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, nook_make(0.25f, 0.25f, 0), nook_make(0, 0, 2), 0, NOOK_NEAREST),
                NOOK_OK);
    CHECK(ray.triangle == 0 && ray.t == 0);
}

static void the_normal_of_a_hit_has_length_1(void) {
    nook_ray ray;
    nook_point n;
    one_triangle(nook_make(0, 0, 0), nook_make(1e-3f, 0, 0), nook_make(0, 1e-3f, 0));
    ray = cast(nook_make(2e-4f, 2e-4f, 3), nook_make(0, 0, -2), NOOK_NEAREST);
    n = nook_ray_normal(&ray);
    CHECK(n.x == 0 && n.y == 0 && n.z == 1);
    ray = cast(nook_make(2e-4f, 2e-4f, 3), nook_make(0, 0, 2), NOOK_NEAREST);
    n = nook_ray_normal(&ray);
    CHECK(n.x == 0 && n.y == 0 && n.z == 0);
    one_triangle(nook_make(0, 0, 0), nook_make(2, 0, 0), nook_make(1, 0, 0)); /* no area */
    ray = cast(nook_make(0.5f, 0, 3), nook_make(0, 0, -2), NOOK_NEAREST);
    n = nook_ray_normal(&ray);
    CHECK(n.x == 0 && n.y == 0 && n.z == 0);
}

/* ---- what others have got wrong: inside ----------------------------------------------------------- */

/* mikedh/trimesh 73, 85 and 545: inside and outside wrong where the ray that is counted meets an edge or a
 * vertex. */
static void a_point_in_line_with_edges_and_vertices_is_where_it_is(void) {
    uint32_t axis, i;
    for (i = 0; i < 3; i++) {
        float s = scales[i];
        for (axis = 0; axis < 3; axis++) {
            octahedron(s);
            CHECK_EQUAL(side(nook_make(0, 0, 0)), -1);
            CHECK_EQUAL(side(unit_along(axis, 0.5f * s)), -1);
            CHECK_EQUAL(side(unit_along(axis, -0.5f * s)), -1);
            CHECK_EQUAL(side(unit_along(axis, s)), 0);
            CHECK_EQUAL(side(unit_along(axis, 1.0000001f * s)), 1);
            CHECK_EQUAL(side(unit_along(axis, -2 * s)), 1);
            box(s, s, s);
            CHECK_EQUAL(side(unit_along(axis, 0.5f * s)), -1);
            CHECK_EQUAL(side(unit_along(axis, -s)), 0);
            CHECK_EQUAL(side(unit_along(axis, 2 * s)), 1);
        }
        CHECK_EQUAL(side(nook_make(s, s, s)), 0);
        CHECK_EQUAL(side(nook_make(-2 * s, s, s)), 1);
        CHECK_EQUAL(side(nook_make(s, s, -1.0000001f * s)), 1);
        CHECK_EQUAL(side(nook_make(-2 * s, s, 0.25f * s)), 1); /* in the plane of a face */
    }
}

/* isl-org/Open3D 5105: the sign of the distance is wrong where the nearest triangle lies in one plane with
 * the point. */
static void the_sign_of_a_distance_does_not_come_from_the_nearest_triangle(void) {
    nook_closest c;
    box(1, 1, 1);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(3, 1, 0.25f)), NOOK_OK);
    CHECK(c.distance == 2);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(3, 1, 1)), NOOK_OK);
    CHECK(c.distance == 2);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(4, 5, 1)), NOOK_OK);
    CHECK(c.distance == 5);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(0.5f, 0.5f, 0.5f)), NOOK_OK);
    CHECK(c.distance == -0.5f);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(0, 0, 0)), NOOK_OK);
    CHECK(c.distance == -1);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, nook_make(1, 0.5f, 1)), NOOK_OK);
    CHECK(c.distance == 0);
}

/* Boxes in boxes: solid, cavity, solid, cavity. */
static void what_is_nested_is_inside_and_outside_in_turn(void) {
    uint32_t depth;
    begin();
    for (depth = 0; depth < 4; depth++) {
        float r = 8.0f - 2.0f * (float)depth;
        add_box(nook_make(-r, -r, -r), nook_make(r, r, r), depth % 2 == 1);
    }
    build();
    CHECK_EQUAL(side(nook_make(9, 0, 0)), 1);
    CHECK_EQUAL(side(nook_make(7, 0, 0)), -1);
    CHECK_EQUAL(side(nook_make(0, 5, 0)), 1);
    CHECK_EQUAL(side(nook_make(0, 0, -3)), -1);
    CHECK_EQUAL(side(nook_make(0, 0, 0)), 1);
    CHECK_EQUAL(side(nook_make(2, 2, 2)), 0);
}

static int32_t winding(nook_point p) {
    nook_inside in;
    uint32_t units = 10000;
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
    return in.winding;
}

static void where_shells_overlap_the_surface_winds_twice(void) {
    begin();
    add_box(nook_make(0, 0, 0), nook_make(2, 2, 2), false);
    add_box(nook_make(1, 1, 1), nook_make(3, 3, 3), false);
    add_box(nook_make(-4, -4, -4), nook_make(-3, -3, -3), true);
    build();
    CHECK_EQUAL(winding(nook_make(1.5f, 1.5f, 1.5f)), 2);
    CHECK_EQUAL(winding(nook_make(0.5f, 1.5f, 1.5f)), 1);
    CHECK_EQUAL(winding(nook_make(2.5f, 2.5f, 2.5f)), 1);
    CHECK_EQUAL(winding(nook_make(-3.5f, -3.5f, -3.5f)), -1);
    CHECK_EQUAL(winding(nook_make(0.5f, 2.5f, 2.5f)), 0);
}

static float winding_number(nook_point p) {
    nook_winding w;
    uint32_t units = 10000;
    CHECK_EQUAL(nook_winding_begin(&w, &m.view, p), NOOK_OK);
    CHECK_EQUAL(nook_winding_step(&w, &units), NOOK_OK);
    return w.number;
}

static void a_cube_without_a_face_winds_five_sixths_around_its_middle(void) {
    box(1, 1, 1);
    CHECK(near(winding_number(nook_make(0, 0, 0)), 1));
    CHECK(near(winding_number(nook_make(0.9f, -0.9f, 0.9f)), 1));
    CHECK(near(winding_number(nook_make(1.1f, -0.9f, 0.9f)), 0));
    CHECK(winding_number(nook_make(1, 1, 1)) <= 1); /* a number, even at a vertex */
    m.view.nt = 10;
    CHECK(near(winding_number(nook_make(0, 0, 0)), 5.0f / 6.0f));
}

/* ---- what others have got wrong: pairs ------------------------------------------------------------ */

static bool meet(const nook_point *a, const nook_point *b) {
    const nook_point *p[3], *q[3];
    bool expected = false;
    uint32_t i, k;
    for (k = 0; k < 18; k++) { /* all turns of both, in both orders */
        bool found;
        for (i = 0; i < 3; i++) {
            p[i] = &a[(i + k) % 3];
            q[i] = &b[(i + k / 3) % 3];
        }
        found = k < 9 ? nook_triangles_meet(p, q) : nook_triangles_meet(q, p);
        if (k == 0) expected = found;
        CHECK_EQUAL(found, expected);
    }
    return expected;
}

/* gkjohnson/three-mesh-bvh 655: a meets b, but b does not meet a. */
static void two_triangles_meet_in_either_order(void) {
    static const nook_point flat[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    static const nook_point corner_on_it[3] = {{1, 1, 0}, {1, 1, 3}, {2, 2, 3}},
                            corner_above[3] = {{1, 1, 1e-30f}, {1, 1, 3}, {2, 2, 3}};
    static const nook_point edge_on_edge[3] = {{1, 0, 0}, {3, 0, 0}, {2, -1, 1}},
                            in_it[3] = {{0.5f, 0.5f, 0}, {1, 0.5f, 0}, {0.5f, 1, 0}};
    static const nook_point beside[3] = {{2.5f, 2.5f, 0}, {4, 4, 0}, {3, 4, 0}},
                            corner_on_corner[3] = {{4, 0, 0}, {5, 0, 0}, {5, 1, 0}};
    static const nook_point through[3] = {{1, 1, -1}, {1, 1, 1}, {9, 9, 1}};
    CHECK(meet(flat, corner_on_it) && meet(flat, edge_on_edge) && meet(flat, in_it) &&
          meet(flat, corner_on_corner));
    CHECK(meet(flat, through) && meet(flat, flat));
    CHECK(!meet(flat, corner_above) && !meet(flat, beside));
}

/* isl-org/Open3D 5117 and 7539: triangles that do not touch are said to, by an absolute tolerance, and
 * otherwise when turned. */
static void a_gap_of_one_last_place_is_a_gap_at_any_scale_and_turn(void) {
    static const nook_point a[3] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                            on[3] = {{0.25f, 0.25f, 1}, {0.25f, 0.5f, 2}, {0.5f, 0.25f, 2}};
    uint32_t k, i, turn;
    for (k = 0; k < 3; k++) {
        for (turn = 0; turn < 3; turn++) {
            nook_point p[3], q[3], r[3];
            float s = nook_power_of_two(97 + 30 * k), gap = nook_float_from(nook_float_bits(s) + 1);
            for (i = 0; i < 3; i++) {
                nook_point above = nook_scaled(on[i], s);
                p[i] = nook_scaled(a[i], s);
                q[i] = above;
                if (i == 0) above.z = gap;
                r[i] = above;
                if (turn == 1)
                    p[i] = nook_make(p[i].z, p[i].x, p[i].y), q[i] = nook_make(q[i].z, q[i].x, q[i].y);
                if (turn == 1) r[i] = nook_make(r[i].z, r[i].x, r[i].y);
                if (turn == 2)
                    p[i] = nook_make(p[i].y, p[i].z, -p[i].x), q[i] = nook_make(q[i].y, q[i].z, -q[i].x);
                if (turn == 2) r[i] = nook_make(r[i].y, r[i].z, -r[i].x);
            }
            CHECK(meet(p, q));
            CHECK(!meet(p, r));
        }
    }
}

static uint32_t count_pairs(uint32_t *t, uint32_t *u) {
    nook_intersections f;
    nook_status status;
    uint32_t units = 100000;
    CHECK_EQUAL(nook_intersections_begin(&f, &m.bvh), NOOK_OK);
    while ((status = nook_intersections_step(&f, &units)) == NOOK_TRIANGLE) *t = f.t, *u = f.u;
    CHECK_EQUAL(status, NOOK_OK);
    return f.count;
}

static void a_mesh_that_cuts_itself_says_which_triangles(void) {
    uint32_t t = 0, u = 0;
    torus(1);
    CHECK_EQUAL(count_pairs(&t, &u), 0);
    box(1, 1, 1);
    CHECK_EQUAL(count_pairs(&t, &u), 0);
    begin();
    (void)point(0, 0, 0), (void)point(4, 0, 0), (void)point(0, 4, 0);
    (void)point(1, 1, 0), (void)point(1, 1, 3), (void)point(2, 2, 3);
    triangle(0, 1, 2), triangle(3, 4, 5);
    build();
    CHECK_EQUAL(count_pairs(&t, &u), 1);
    CHECK(t == 0 && u == 1);
    m.G[3].z = 1e-38f;
    build();
    CHECK_EQUAL(count_pairs(&t, &u), 0);
    m.V[3] = 0; /* one vertex shared, and nothing else met */
    build();
    CHECK_EQUAL(count_pairs(&t, &u), 0);
    m.G[4].z = 0;
    m.G[5] = nook_make(2, 1, 0); /* folded into its plane */
    build();
    CHECK_EQUAL(count_pairs(&t, &u), 1);
}

static uint32_t junctions(float tolerance) {
    nook_t_junctions f;
    nook_status status;
    uint32_t units = 10000;
    CHECK_EQUAL(nook_t_junctions_begin(&f, &m.bvh, tolerance), NOOK_OK);
    while ((status = nook_t_junctions_step(&f, &units)) == NOOK_TRIANGLE) continue;
    CHECK_EQUAL(status, NOOK_OK);
    return f.count;
}

static void a_vertex_within_a_border_edge_is_a_t_junction(void) {
    nook_t_junctions f;
    uint32_t units = 1000;
    begin();
    (void)point(0, 0, 0), (void)point(2, 0, 0), (void)point(1, 2, 0);
    (void)point(1, 0, 0), (void)point(0, -2, 0), (void)point(2, -2, 0);
    triangle(0, 1, 2), triangle(3, 4, 5);
    link();
    build();
    CHECK_EQUAL(nook_t_junctions_begin(&f, &m.bvh, 1e-6f), NOOK_OK);
    CHECK_EQUAL(nook_t_junctions_step(&f, &units), NOOK_TRIANGLE);
    CHECK(f.vertex == 3 && f.corner == 2);
    CHECK_EQUAL(nook_t_junctions_step(&f, &units), NOOK_OK);
    CHECK_EQUAL(f.count, 1);
    units = 0;
    CHECK_EQUAL(nook_t_junctions_begin(&f, &m.bvh, 1e-6f), NOOK_OK);
    CHECK_EQUAL(nook_t_junctions_step(&f, &units), NOOK_MORE);
    m.bvh.view.O = NULL;
    CHECK_EQUAL(nook_t_junctions_begin(&f, &m.bvh, 1e-6f), NOOK_NULL_ARGUMENT);
    m.bvh.view.O = m.O;
    m.bvh.view.C = NULL;
    CHECK_EQUAL(nook_t_junctions_begin(&f, &m.bvh, 1e-6f), NOOK_NULL_ARGUMENT);
    m.G[3].y = -1e-3f;
    build();
    CHECK_EQUAL(junctions(1e-6f), 0);
    m.G[3] = nook_make(1e-3f, 0, 0); /* too near an end, from either side */
    build();
    CHECK_EQUAL(junctions(2e-3f), 0);
    CHECK_EQUAL(junctions(1e-4f), 1);
    m.G[3] = nook_make(2 - 1e-3f, 0, 0);
    build();
    CHECK_EQUAL(junctions(2e-3f), 0);
    CHECK_EQUAL(junctions(1e-4f), 1);
    box(1, 1, 1); /* no border */
    link();
    CHECK_EQUAL(junctions(5), 0);
    m.view.nt = 10;
    link();
    build();
    CHECK_EQUAL(junctions(0.01f), 0);
    CHECK_EQUAL(junctions(5), 0);
}

/* ---- what others have got wrong: distances -------------------------------------------------------- */

/* bulletphysics/bullet3 2579: a sphere of 0.01 misses a box of 0.005 that one ten times as large touches. */
static void a_small_body_touches_as_a_large_one_does(void) {
    uint32_t k;
    for (k = 0; k < 41; k++) {
        float s = nook_power_of_two(107 + k);
        nook_point p = nook_make(0.0149f * s, 0.001f * s, -0.002f * s);
        nook_closest c;
        box(0.005f * s, 0.005f * s, 0.005f * s);
        c = distance(p, p);
        CHECK(c.distance_max <= 0.01f * s);
        CHECK(c.distance_min > 0.0098f * s);
        p.x = 0.0151f * s;
        CHECK(distance(p, p).distance_min > 0.01f * s);
    }
}

/* google-deepmind/mujoco 3383: distance 0 for bodies that are clearly apart. And none that touch are
 * apart. */
static void what_is_apart_has_a_distance_and_what_touches_has_none(void) {
    dice d = {31415u};
    uint32_t i;
    torus(1);
    for (i = 0; i < (NOOK_TEST_RAM < 2000000 ? 60 : 600); i++) {
        nook_point a, b;
        nook_closest c;
        uint32_t t = throw_dice(&d, m.view.nt), k = throw_dice(&d, 3);
        float up = 1.6f + 0.001f * (float)throw_dice(&d, 1000);
        a.x = (float)throw_dice(&d, 1000) * 0.01f - 5.0f;
        a.y = (float)throw_dice(&d, 1000) * 0.01f - 5.0f;
        a.z = up;
        b = nook_make(a.y, -a.x, up);
        c = distance(a, b);
        CHECK(c.distance_min > 0.09f && c.distance > 0.09f && c.distance_min <= c.distance &&
              c.distance <= c.distance_max);
        c = distance(corner(3 * t + k), a);
        CHECK(c.distance == 0 && c.distance_min == 0 && c.distance_max < 1e-4f);
    }
}

/* flexible-collision-library/fcl 390, 493, 495: kissing bodies and gaps below the epsilon make it throw. */
static void kissing_and_nearly_kissing_bodies_have_a_distance(void) {
    nook_closest c;
    float gap;
    box(1, 1, 1);
    c = distance(nook_make(-4, 0.25f, 1), nook_make(4, 0.25f, 1)); /* in the plane of a face */
    CHECK(c.distance == 0 && c.distance_min == 0);
    c = distance(nook_make(1, 1, 1), nook_make(2, 2, 2));
    CHECK(c.distance == 0 && c.at == 0);
    for (gap = 0x1p-23f; gap < 1; gap *= 2) {
        c = distance(nook_make(-4, 0.25f, 1 + gap), nook_make(4, 0.25f, 1 + gap));
        CHECK(c.distance_min <= gap && c.distance_max >= gap);
        CHECK(c.distance == gap);
        c = distance(nook_make(0.5f, 0.25f, 1 + gap), nook_make(0.5f, 0.25f, 1 + gap));
        CHECK(c.distance == gap && c.point.x == 0.5f && c.point.y == 0.25f && c.point.z == 1);
    }
}

/* openGJK returns 1.5e-3 for a gap of 5e-4 between a plate 10,000 times as wide as thick and a bar. */
static void a_thin_plate_is_as_far_from_a_bar_as_it_is(void) {
    nook_closest c;
    box(5, 5, 5e-4f);
    c = distance(nook_make(-4, -3, 1e-3f), nook_make(4, 4.5f, 1e-3f));
    CHECK(c.distance > 4.999e-4f && c.distance < 5.001e-4f);
    CHECK(c.distance_min <= 5.001e-4f && c.distance_max >= 4.999e-4f);
    c = distance(nook_make(-4, -3, -6e-4f), nook_make(4, 4.5f, -1e-3f));
    CHECK(c.distance > 0.999e-4f && c.distance < 1.001e-4f);
    CHECK(c.at == 0);
}

/* coal-library/coal 823: the witness points are not where the distance is. */
static void the_two_points_are_as_far_apart_as_is_said(void) {
    dice d = {271828u};
    uint32_t i;
    torus(1);
    for (i = 0; i < (NOOK_TEST_RAM < 2000000 ? 60 : 600); i++) {
        nook_point a, b, q;
        nook_closest c;
        float length;
        a.x = (float)throw_dice(&d, 1000) * 0.02f - 10.0f;
        a.y = (float)throw_dice(&d, 1000) * 0.02f - 10.0f;
        a.z = (float)throw_dice(&d, 1000) * 0.02f - 10.0f;
        b = nook_make(a.z * 0.2f, a.x * 0.5f, a.y);
        c = distance(a, b);
        q = nook_make(a.x + (b.x - a.x) * c.at, a.y + (b.y - a.y) * c.at, a.z + (b.z - a.z) * c.at);
        length = nook_length(nook_sub(q, c.point));
        CHECK(length - c.distance < 2e-5f && c.distance - length < 2e-5f);
        CHECK(distance(c.point, c.point).distance < 1e-5f);
    }
}

static void what_lies_beyond_the_limit_is_not_named(void) {
    nook_closest c;
    nook_point p = {4, 0.25f, 0.5f};
    uint32_t units = 1000;
    box(1, 1, 1);
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, 2.5f, 0), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    CHECK_EQUAL(c.triangle, NOOK_NONE);
    CHECK(c.distance_min > 2.4999f && c.distance_min <= 3 && c.distance_max >= 3);
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, 3.5f, 0), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    CHECK(c.triangle != NOOK_NONE && c.distance == 3);
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, NOOK_FAR, 100), NOOK_OK);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_OK);
    CHECK(c.triangle != NOOK_NONE && c.distance <= 100 && c.distance_min <= 3 && c.distance_max >= 3);
}

/* Stopped as soon as something is near enough, between units as well. */
static void near_enough_is_enough(void) {
    const nook_point p = {9, 1, 1};
    nook_closest whole, c;
    float enough;
    torus(1);
    whole = distance(p, p);
    for (enough = 1; enough < 10; enough += 0.5f) {
        uint32_t units, calls = 0;
        nook_status status = NOOK_MORE;
        CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, NOOK_FAR, enough), NOOK_OK);
        while (status == NOOK_MORE && calls++ < 1000) {
            units = 1;
            status = nook_closest_step(&c, &units);
        }
        CHECK_EQUAL(status, NOOK_OK);
        CHECK(c.distance <= enough || same_bits(c.distance, whole.distance));
        CHECK(c.distance_min <= whole.distance_max && c.distance_max >= whole.distance_min);
    }
}

/* Corner, edge and inner part; a point, and segments along each axis; a leaf that is not full. */
static void one_triangle_is_as_far_as_its_nearest_part(void) {
    static const struct {
        nook_point a, b;
        float distance;
    } list[] = {{{-3, -4, 0}, {-3, -4, 0}, 5},
                {{1, -2, 0}, {1, -2, 0}, 2},
                {{1, 1, 7}, {1, 1, 7}, 7},
                {{6, 1, 0}, {6, -1, 0}, 2},
                {{1, 1, 3}, {1, 1, 9}, 3},
                {{1, 1, -3}, {1, 1, 9}, 0},
                {{-1, -1, 2}, {-1, 9, 2}, 2.236068f},
                {{-5, 1, 2}, {9, 1, 2}, 2},
                {{5, 5, -1}, {5, 5, 1}, 4.2426407f},
                {{0, 0, 0}, {0, 0, 0}, 0},
                {{-9, -1, 0}, {9, -1, 0}, 1},
                {{1, 1, 0}, {2, 1, 0}, 0},
                {{-1, 2, 0}, {5, 2, 0}, 0},
                {{4, 4, 1}, {4, 4, 1}, 3}};
    uint32_t i, turn;
    for (turn = 0; turn < 3; turn++) {
        static const nook_point G[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
        for (i = 0; i < sizeof list / sizeof *list; i++) {
            nook_closest c;
            one_triangle(G[turn], G[(turn + 1) % 3], G[(turn + 2) % 3]);
            c = distance(list[i].a, list[i].b);
            CHECK(near(c.distance, list[i].distance));
            CHECK(c.distance_min <= list[i].distance + 1e-7f && c.distance_max >= list[i].distance - 1e-7f);
            c = distance(list[i].b, list[i].a);
            CHECK(near(c.distance, list[i].distance));
        }
        CHECK_EQUAL(side(nook_make(1, 1, 0)), 0);
        CHECK_EQUAL(side(nook_make(1, 1, 1e-30f)) & 1, 1);
    }
}

/* ---- what is refused ------------------------------------------------------------------------------ */

static nook_status build_at(nook_where *where) {
    *where = nook_at(NOOK_NOWHERE, 0);
    return nook_bvh_build(&m.bvh, &m.view, m.boxes, m.order, where);
}

static void a_tree_says_what_is_wrong_with_its_mesh(void) {
    nook_where where;
    box(1, 1, 1);
    m.V[17] = 8;
    CHECK_EQUAL(build_at(&where), NOOK_INDEX_OUT_OF_RANGE);
    CHECK(where.kind == NOOK_AT_CORNER && where.index == 17);
    m.V[17] = NOOK_STORED_NONE;
    CHECK_EQUAL(build_at(&where), NOOK_INDEX_OUT_OF_RANGE);
    box(1, 1, 1);
    m.G[5].y = nook_float_from(0x7FC00000u);
    CHECK_EQUAL(build_at(&where), NOOK_NOT_FINITE);
    CHECK(where.kind == NOOK_AT_VERTEX && where.index == 5);
    m.G[5].y = nook_float_from(0xFF800000u);
    CHECK_EQUAL(build_at(&where), NOOK_NOT_FINITE);
    m.G[5].y = -1.5e9f;
    CHECK_EQUAL(build_at(&where), NOOK_COORDINATE_TOO_LARGE);
    CHECK(where.kind == NOOK_AT_VERTEX && where.index == 5);
    m.G[5].y = 1;
    m.G[4].x = nook_float_from(0x7F800000u);
    CHECK_EQUAL(build_at(&where), NOOK_NOT_FINITE);
    CHECK(where.kind == NOOK_AT_VERTEX && where.index == 4);
    m.G[4].x = 1;
    m.G[3].z = 2e9f;
    CHECK_EQUAL(build_at(&where), NOOK_COORDINATE_TOO_LARGE);
    CHECK(where.kind == NOOK_AT_VERTEX && where.index == 3);
    m.G[3].z = -1;
    m.G[5].y = NOOK_MAX_COORDINATE;
    CHECK_EQUAL(build_at(&where), NOOK_OK);
    m.G[5].y = 1;
    (void)point(nook_float_from(0x7FC00000u), 0, 0); /* a vertex of no triangle may be anything */
    CHECK_EQUAL(build_at(&where), NOOK_OK);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.boxes, m.order, NULL), NOOK_OK);
    m.V[2] = NOOK_STORED_NONE;
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.boxes, m.order, NULL), NOOK_INDEX_OUT_OF_RANGE);
    m.view.nt = 0;
    CHECK_EQUAL(build_at(&where), NOOK_EMPTY_MESH);
}

static void a_tree_needs_all_but_order_and_where(void) {
    nook_bvh_state state;
    nook_view view;
    box(1, 1, 1);
    view = m.view;
    CHECK_EQUAL(nook_bvh_begin(NULL, &m.bvh, &view, m.boxes, m.order, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, NULL, &view, m.boxes, m.order, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, &m.bvh, NULL, m.boxes, m.order, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, &m.bvh, &view, NULL, m.order, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_begin(&state, &m.bvh, &view, m.boxes, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, NULL, m.boxes, m.order, NULL), NOOK_NULL_ARGUMENT);
    build();
    CHECK_EQUAL(nook_bvh_refit_begin(NULL, &m.bvh, m.boxes, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_refit_begin(&state, NULL, m.boxes, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &m.bvh, NULL, NULL), NOOK_NULL_ARGUMENT);
}

/* Points and directions that are no numbers, or too large. */
static const struct {
    uint32_t bits;
    nook_status status;
} bad[] = {{0x7FC00000u, NOOK_NOT_FINITE},
           {0x7F800000u, NOOK_NOT_FINITE},
           {0xFF800000u, NOOK_NOT_FINITE},
           {0x4E800001u, NOOK_COORDINATE_TOO_LARGE},
           {0xFF7FFFFFu, NOOK_COORDINATE_TOO_LARGE}};

static void a_question_about_no_place_is_refused(void) {
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_winding w;
    uint32_t i, axis;
    int sign;
    box(1, 1, 1);
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        for (axis = 0; axis < 3; axis++) {
            const nook_point p = unit_along(axis, nook_float_from(bad[i].bits)), q = {1, 2, 3};
            CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, q, NOOK_MAX_T, NOOK_NEAREST), bad[i].status);
            CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, q, NOOK_FAR, 0), bad[i].status);
            CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, q, p, NOOK_FAR, 0), bad[i].status);
            CHECK_EQUAL(nook_closest_point(&c, &m.bvh, p), bad[i].status);
            CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, p), bad[i].status);
            CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), bad[i].status);
            CHECK_EQUAL(nook_side_of(&m.bvh, p, &sign), bad[i].status);
            CHECK_EQUAL(nook_winding_begin(&w, &m.view, p), bad[i].status);
            if (bad[i].status != NOOK_NOT_FINITE) continue;
            CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, q, p, NOOK_MAX_T, NOOK_NEAREST), NOOK_NOT_FINITE);
        }
    }
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, m.G[0], unit_along(0, -0.0f), NOOK_MAX_T, NOOK_ANY),
                NOOK_NOT_FINITE);
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, m.G[0], unit_along(0, 0), NOOK_MAX_T, NOOK_ANY), NOOK_NOT_FINITE);
}

static void a_question_to_nobody_is_refused(void) {
    const nook_point p = {1, 2, 3};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_winding w;
    nook_intersections f;
    nook_t_junctions j;
    int sign;
    box(1, 1, 1);
    CHECK_EQUAL(nook_ray_begin(NULL, &m.bvh, p, p, 1, NOOK_ANY), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_ray_begin(&ray, NULL, p, p, 1, NOOK_ANY), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_ray_cast(&ray, NULL, p, p, 1, NOOK_ANY), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_closest_begin(NULL, &m.bvh, p, p, 1, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_closest_begin(&c, NULL, p, p, 1, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_closest_point(&c, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_inside_begin(NULL, &m.bvh, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_inside_begin(&in, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_side_of(NULL, p, &sign), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_side_of(&m.bvh, p, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_signed_distance(NULL, &m.bvh, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_signed_distance(&c, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_winding_begin(NULL, &m.view, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_winding_begin(&w, NULL, p), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_intersections_begin(NULL, &m.bvh), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_intersections_begin(&f, NULL), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_t_junctions_begin(NULL, &m.bvh, 0), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_t_junctions_begin(&j, NULL, 0), NOOK_NULL_ARGUMENT);
}

/* The tree of a torus, with one entry of its mesh spoiled; what each question says. */
static void all_notice(void) {
    const nook_point p = {3.5f, 0.1f, 0}, to = {0, 0.1f, 1};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_intersections f;
    uint32_t units = 100000;
    int sign;
    CHECK_EQUAL(nook_ray_cast(&ray, &m.bvh, p, to, NOOK_MAX_T, NOOK_CROSSINGS), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_closest_point(&c, &m.bvh, p), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_side_of(&m.bvh, p, &sign), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_signed_distance(&c, &m.bvh, p), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(nook_intersections_begin(&f, &m.bvh), NOOK_OK);
    CHECK_EQUAL(nook_intersections_step(&f, &units), NOOK_INDEX_OUT_OF_RANGE);
}

static void tables_spoiled_after_the_build_are_noticed(void) {
    nook_winding w;
    nook_t_junctions j;
    nook_intersections f;
    nook_bvh_state state;
    nook_where where = {NOOK_NOWHERE, 0};
    uint32_t i, c, units;
    for (i = 0; i < 3; i++) {
        torus(1);
        link();
        for (c = i; c < 3 * m.view.nt; c += 3) m.V[c] = nook_store(m.view.nv);
        all_notice();
        units = 1000;
        CHECK_EQUAL(nook_winding_begin(&w, &m.view, nook_make(0, 0, 0)), NOOK_OK);
        CHECK_EQUAL(nook_winding_step(&w, &units), NOOK_INDEX_OUT_OF_RANGE);
        for (c = 0; c < 3 * m.view.nt; c++) m.O[c] = nook_store(c);
        CHECK_EQUAL(nook_t_junctions_begin(&j, &m.bvh, 0.01f), NOOK_OK);
        units = 100000;
        CHECK_EQUAL(nook_t_junctions_step(&j, &units), NOOK_INDEX_OUT_OF_RANGE);
    }
    torus(1);
    m.V[3 * m.order[m.view.nt - 1]] = nook_store(m.view.nv); /* when others have been looked at */
    units = 100000;
    CHECK_EQUAL(nook_intersections_begin(&f, &m.bvh), NOOK_OK);
    CHECK_EQUAL(nook_intersections_step(&f, &units), NOOK_INDEX_OUT_OF_RANGE);
    torus(1);
    for (c = 0; c < m.view.nt; c++) m.order[c] = nook_store(m.view.nt);
    all_notice();
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &m.bvh, m.boxes, &where), NOOK_OK);
    units = 100000;
    CHECK_EQUAL(nook_bvh_step(&state, &units), NOOK_INDEX_OUT_OF_RANGE);
    CHECK_EQUAL(where.kind, NOOK_AT_TRIANGLE);
}

static void a_hit_whose_triangle_is_spoiled_has_no_normal(void) {
    nook_ray ray;
    one_triangle(nook_make(0, 0, 0), nook_make(1, 0, 0), nook_make(0, 1, 0));
    ray = cast(nook_make(0.25f, 0.25f, -1), nook_make(0, 0, 1), NOOK_NEAREST);
    CHECK(nook_ray_normal(&ray).z == 1);
    m.V[2] = 3;
    CHECK(nook_ray_normal(&ray).z == 0 && weights(&ray).x == 0);
}

static void a_tree_over_nothing_is_refused(void) {
    const nook_point p = {1, 2, 3};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    int sign;
    box(1, 1, 1);
    m.bvh.view.nt = 0;
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, p, 1, NOOK_ANY), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, 1, 0), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_EMPTY_MESH);
    CHECK_EQUAL(nook_side_of(&m.bvh, p, &sign), NOOK_EMPTY_MESH);
}

/* ---- budgets -------------------------------------------------------------------------------------- */

static void nothing_is_known_for_nothing_but_what_is_true(void) {
    const nook_point p = {7, 1, 2}, inside = {3.5f, 0.1f, 0};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_intersections f;
    uint32_t units = 0;
    torus(1);
    CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, p, NOOK_FAR, 0), NOOK_OK);
    CHECK(c.distance_min >= 0 && c.distance_min < 3 && c.distance_max > 2.5f);
    CHECK_EQUAL(nook_closest_step(&c, &units), NOOK_MORE);
    CHECK(units == 0 && c.distance_min < 3 && c.distance_max > 2.5f);
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, p, NOOK_MAX_T, NOOK_NEAREST), NOOK_OK);
    CHECK(ray.triangle == NOOK_NONE && ray.t_min >= 0);
    CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, inside, p, 5, NOOK_NEAREST), NOOK_OK);
    CHECK_EQUAL(nook_ray_step(&ray, &units), NOOK_MORE);
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, inside), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_MORE);
    CHECK_EQUAL(nook_intersections_begin(&f, &m.bvh), NOOK_OK);
    CHECK_EQUAL(nook_intersections_step(&f, &units), NOOK_MORE);
}

static void use_slices(nook_status (*step)(void *, uint32_t *), void *state, uint32_t slice) {
    uint32_t calls = 0, units;
    nook_status status;
    do {
        units = slice;
        status = step(state, &units);
        CHECK(status == NOOK_OK || units == 0);
    } while (status == NOOK_MORE && ++calls < 1000);
    CHECK_EQUAL(status, NOOK_OK);
}

static nook_status step_ray(void *state, uint32_t *units) { return nook_ray_step(state, units); }
static nook_status step_closest(void *state, uint32_t *units) { return nook_closest_step(state, units); }
static nook_status step_inside(void *state, uint32_t *units) { return nook_inside_step(state, units); }
static nook_status step_winding(void *state, uint32_t *units) { return nook_winding_step(state, units); }
static nook_status step_bvh(void *state, uint32_t *units) { return nook_bvh_step(state, units); }

static void slices_of_any_size_give_the_same_bits(void) {
    const nook_point p = {0.3f, 3.1f, 0.2f}, q = {-4, 1, 0.5f};
    nook_ray ray;
    nook_closest c;
    nook_inside in;
    nook_winding w;
    uint32_t slice;
    for (slice = 1; slice < 40; slice += 1 + slice / 4) {
        nook_closest whole;
        nook_ray whole_ray;
        torus(1);
        whole = distance(p, q);
        whole_ray = cast(p, q, NOOK_NEAREST);
        CHECK_EQUAL(nook_closest_begin(&c, &m.bvh, p, q, NOOK_FAR, 0), NOOK_OK);
        use_slices(step_closest, &c, slice);
        CHECK(c.triangle == whole.triangle && same_bits(c.distance, whole.distance) &&
              same_bits(c.at, whole.at));
        CHECK(same_bits(c.distance_min, whole.distance_min) && same_bits(c.distance_max, whole.distance_max));
        CHECK_EQUAL(nook_ray_begin(&ray, &m.bvh, p, q, NOOK_MAX_T, NOOK_NEAREST), NOOK_OK);
        use_slices(step_ray, &ray, slice);
        CHECK(ray.triangle == whole_ray.triangle && same_bits(ray.t, whole_ray.t) &&
              same_bits(weights(&ray).y, weights(&whole_ray).y));
        CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_OK);
        use_slices(step_inside, &in, slice);
        CHECK_EQUAL(nook_inside_side(&in), side(p));
        CHECK_EQUAL(nook_winding_begin(&w, &m.view, p), NOOK_OK);
        use_slices(step_winding, &w, slice);
        CHECK(same_bits(w.number, winding_number(p)));
    }
}

static void a_tree_built_in_slices_and_one_refitted_are_the_same(void) {
    static nook_boxes boxes[NOOK_BVH_GROUPS(MOST_NT)];
    nook_bvh_state state;
    nook_where where;
    uint32_t i;
    torus(1);
    memcpy(boxes, m.boxes, sizeof boxes);
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &m.bvh, m.boxes, &where), NOOK_OK);
    memset(m.boxes, 0x5A, sizeof m.boxes);
    use_slices(step_bvh, &state, 50);
    CHECK(memcmp(boxes, m.boxes, (NOOK_BVH_GROUPS(MOST_NT) - 1) * sizeof *boxes) == 0);
    for (i = 0; i < m.view.nv; i++) m.G[i].x += 20;
    CHECK_EQUAL(nook_bvh_refit_begin(&state, &m.bvh, m.boxes, &where), NOOK_OK);
    use_slices(step_bvh, &state, 50);
    CHECK_EQUAL(side(nook_make(3.5f, 0.1f, 0)), 1);
    CHECK_EQUAL(side(nook_make(23.5f, 0.1f, 0)), -1);
}

/* ---- the same on all machines --------------------------------------------------------------------- */

static uint32_t crc;

static void put(uint32_t word) {
    uint32_t bit;
    crc ^= word;
    for (bit = 0; bit < 32; bit++) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
}

static void put_float(float x) { put(x == 0 ? 0 : nook_float_bits(x)); }

static void put_point(nook_point p) {
    put_float(p.x);
    put_float(p.y);
    put_float(p.z);
}

static void put_closest(nook_point a, nook_point b) {
    nook_closest c = distance(a, b);
    put(c.triangle);
    put_point(c.point);
    put_float(c.at);
    put_float(c.distance);
    put_float(c.distance_min);
    put_float(c.distance_max);
}

static void put_rays(nook_point a, nook_point b) {
    nook_ray ray = cast(a, b, NOOK_NEAREST);
    put(ray.triangle);
    put_float(ray.t);
    put_point(weights(&ray));
    put_point(nook_ray_normal(&ray));
    ray = cast(a, b, NOOK_CROSSINGS);
    put(ray.crossings);
    put((uint32_t)ray.winding);
}

static void put_inside(nook_point p) {
    nook_inside in;
    uint32_t units = 10000;
    CHECK_EQUAL(nook_inside_begin(&in, &m.bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
    put(in.on);
    put(in.crossings);
    put((uint32_t)in.winding);
}

/* Anywhere, at a vertex, and where only one coordinate is not a vertex's. */
static nook_point throw_point(dice *d) {
    nook_point p, q = m.G[throw_dice(d, m.view.nv)];
    uint32_t kind = throw_dice(d, 4);
    p.x = (float)throw_dice(d, 12000) * 0.001f - 6.0f;
    p.y = (float)throw_dice(d, 12000) * 0.001f - 6.0f;
    p.z = (float)throw_dice(d, 4000) * 0.001f - 2.0f;
    if (kind == 0) return q;
    if (kind == 1) q.z = p.z;
    return kind == 1 ? q : p;
}

static uint32_t digest_of_answers(void) {
    dice d = {20241128u};
    uint32_t i;
    crc = UINT32_MAX;
    for (i = 0; i < 150; i++) {
        nook_point a = throw_point(&d), b = throw_point(&d);
        put_closest(a, a);
        put_closest(a, b);
        put_rays(a, nook_sub(b, a).x != 0 ? nook_sub(b, a) : nook_make(0, 0, 1));
        put_inside(a);
        if (i % 10 == 0) put_float(winding_number(nook_make(a.x, a.y, a.z + 0.001f)));
    }
    return ~crc;
}

static void answers_have_one_digest_on_all_machines_and_widths(void) {
    torus(1);
    CHECK_EQUAL(digest_of_answers(), 0x300029F6u);
}

static void without_an_order_the_answers_are_the_same(void) {
    torus(1);
    CHECK_EQUAL(nook_bvh_build(&m.bvh, &m.view, m.boxes, NULL, NULL), NOOK_OK);
    CHECK_EQUAL(digest_of_answers(), 0x300029F6u);
}

/* On 3 x 3 x 3 points, some in common; make prove has every pair and the oracle. */
static void pairs_on_a_grid_have_one_digest_on_all_machines(void) {
    dice d = {3u};
    uint32_t i, k;
    crc = UINT32_MAX;
    begin();
    m.view.nt = 2;
    for (i = 0; i < (uint32_t)GRID_PAIRS; i++) {
        const nook_point *p[6];
        uint32_t found;
        for (k = 0; k < 6; k++) {
            uint32_t at = throw_dice(&d, 27), named = throw_dice(&d, 6);
            m.G[k] = nook_make((float)(at % 3), (float)(at / 3 % 3), (float)(at / 9));
            m.V[k] = nook_store(k < 3 || named > 2 ? k : named);
            p[k] = &m.G[k];
        }
        if (m.V[3] == m.V[4] || m.V[4] == m.V[5] || m.V[5] == m.V[3]) m.V[3] = 3, m.V[4] = 4;
        found = nook_triangles_meet(p, p + 3);
        CHECK_EQUAL(nook_triangles_meet(p + 3, p), found);
        m.view.nv = 6;
        found += 2u * nook_triangles_intersect(&m.view, 0, 1);
        CHECK_EQUAL(nook_triangles_intersect(&m.view, 1, 0), found >> 1);
        if (i < 400) put(found);
    }
    CHECK_EQUAL(~crc, 0x17360747u);
}

/* What a tree is for: of 312 triangles and 108 groups few are looked at. */
static void a_question_takes_few_units(void) {
    dice d = {271u};
    uint32_t i, ray_units = 0, closest_units = 0, inside_units = 0;
    torus(1);
    for (i = 0; i < 64; i++) {
        nook_point a = throw_point(&d), b = throw_point(&d);
        nook_ray ray;
        nook_closest c;
        nook_inside in;
        uint32_t units = 1000;
        (void)nook_closest_begin(&c, &m.bvh, a, a, NOOK_FAR, 0);
        (void)nook_closest_step(&c, &units);
        closest_units += 1000 - units;
        units = 1000;
        (void)nook_ray_begin(&ray, &m.bvh, a, nook_sub(b, a), NOOK_MAX_T, NOOK_NEAREST);
        (void)nook_ray_step(&ray, &units);
        ray_units += 1000 - units;
        units = 1000;
        (void)nook_inside_begin(&in, &m.bvh, a);
        (void)nook_inside_step(&in, &units);
        inside_units += 1000 - units;
    }
    CHECK(closest_units < 64 * 15);
    CHECK(ray_units < 64 * 13);
    CHECK(inside_units < 64 * 9);
}

/* --------------------------------------------------------------------------------------------------- */

void test_query(void) {
    static const test tests[] = {
        TEST(no_ray_slips_out_between_triangles),
        TEST(an_edge_and_a_vertex_are_crossed_once),
        TEST(what_is_only_touched_is_not_entered),
        TEST(a_thin_triangle_is_hit_only_where_it_is),
        TEST(a_ray_in_the_surface_is_met_where_it_begins),
        TEST(what_has_no_area_is_met_where_it_is),
        TEST(a_ray_nearly_in_the_plane_of_a_triangle_hits_it_within_its_bounds),
        TEST(a_direction_may_be_of_any_length),
        TEST(of_equal_hits_the_lowest_triangle_is_named),
        TEST(a_hit_beyond_t_max_is_none_and_one_at_it_is),
        TEST(the_normal_of_a_hit_has_length_1),
        TEST(a_point_in_line_with_edges_and_vertices_is_where_it_is),
        TEST(the_sign_of_a_distance_does_not_come_from_the_nearest_triangle),
        TEST(what_is_nested_is_inside_and_outside_in_turn),
        TEST(where_shells_overlap_the_surface_winds_twice),
        TEST(a_cube_without_a_face_winds_five_sixths_around_its_middle),
        TEST(two_triangles_meet_in_either_order),
        TEST(a_gap_of_one_last_place_is_a_gap_at_any_scale_and_turn),
        TEST(a_mesh_that_cuts_itself_says_which_triangles),
        TEST(a_vertex_within_a_border_edge_is_a_t_junction),
        TEST(a_small_body_touches_as_a_large_one_does),
        TEST(what_is_apart_has_a_distance_and_what_touches_has_none),
        TEST(kissing_and_nearly_kissing_bodies_have_a_distance),
        TEST(a_thin_plate_is_as_far_from_a_bar_as_it_is),
        TEST(the_two_points_are_as_far_apart_as_is_said),
        TEST(what_lies_beyond_the_limit_is_not_named),
        TEST(near_enough_is_enough),
        TEST(one_triangle_is_as_far_as_its_nearest_part),
        TEST(a_tree_says_what_is_wrong_with_its_mesh),
        TEST(a_tree_needs_all_but_order_and_where),
        TEST(a_question_about_no_place_is_refused),
        TEST(a_question_to_nobody_is_refused),
        TEST(tables_spoiled_after_the_build_are_noticed),
        TEST(a_hit_whose_triangle_is_spoiled_has_no_normal),
        TEST(a_tree_over_nothing_is_refused),
        TEST(nothing_is_known_for_nothing_but_what_is_true),
        TEST(slices_of_any_size_give_the_same_bits),
        TEST(a_tree_built_in_slices_and_one_refitted_are_the_same),
        TEST(answers_have_one_digest_on_all_machines_and_widths),
        TEST(without_an_order_the_answers_are_the_same),
        TEST(pairs_on_a_grid_have_one_digest_on_all_machines),
        TEST(a_question_takes_few_units),
    };
    run_tests(tests, sizeof tests / sizeof *tests);
}
