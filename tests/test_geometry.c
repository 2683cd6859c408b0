/* test_geometry.c -- edges, convexity, volume, mass, against definitions computed the long way.
 *
 * Coordinates are small integers, so that every oracle here is plain integer arithmetic; that signs hold for
 * all other floats is test_exact.c's business. Convexity is judged by all pairs of vertices and triangles. */
#include "rooms.h"
#include "shapes.h"

#include <string.h>

static uint32_t told[NOOK_STATUS_COUNT];
static nook_where last[NOOK_STATUS_COUNT];
static void hear(void *user, nook_status defect, nook_where where) {
    (void)user;
    told[defect]++;
    last[defect] = where;
}
static const nook_finder finder = {hear, NULL};
static const nook_geometry *const g = &b.result.geometry;

static void examine(void) {
    memset(told, 0, sizeof told);
    CHECK_EQUAL(link_and_check(&finder), NOOK_OK);
}

/* ---- the oracle ---------------------------------------------------------------------------------------- */

typedef struct spot {
    int64_t x, y, z;
} spot;

static spot spot_of(uint32_t v) {
    spot s = {(int64_t)b.mesh.G[v].x, (int64_t)b.mesh.G[v].y, (int64_t)b.mesh.G[v].z};
    return s;
}

static spot normal_of(uint32_t t) {
    spot p = spot_of(b.mesh.V[3 * t]), q = spot_of(b.mesh.V[3 * t + 1]), r = spot_of(b.mesh.V[3 * t + 2]), n;
    n.x = (q.y - p.y) * (r.z - p.z) - (q.z - p.z) * (r.y - p.y);
    n.y = (q.z - p.z) * (r.x - p.x) - (q.x - p.x) * (r.z - p.z);
    n.z = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return n;
}

static int64_t dot(spot p, spot q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

static int64_t height(uint32_t t, uint32_t v) {
    spot p = spot_of(b.mesh.V[3 * t]), q = spot_of(v);
    spot up = {q.x - p.x, q.y - p.y, q.z - p.z};
    return dot(normal_of(t), up);
}

static bool has_area(uint32_t t) { return dot(normal_of(t), normal_of(t)) != 0; }

static int64_t six_volumes(void) {
    int64_t sum = 0;
    uint32_t t;
    for (t = 0; t < b.mesh.nt; t++) sum += dot(normal_of(t), spot_of(b.mesh.V[3 * t]));
    return sum;
}

static bool is_used(uint32_t v) {
    uint32_t c;
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        if (b.mesh.V[c] == v) return true;
    }
    return false;
}

/* Every vertex on or inside every plane. */
static bool is_convex(int64_t facing) {
    uint32_t t, v;
    for (t = 0; t < b.mesh.nt; t++) {
        for (v = 0; v < b.mesh.nv; v++) {
            if (has_area(t) && is_used(v) && facing * height(t, v) > 0) return false;
        }
    }
    return true;
}

/* Compare everything; b.result is of b.mesh, whose O is taken as it is. */
static void compare(void) {
    uint32_t c, t, concave = 0, convex = 0, flat = 0, folded = 0, thin = 0;
    bool closed = b.result.watertight == NOOK_YES && b.result.oriented == NOOK_YES;
    int64_t six = closed ? six_volumes() : 0, facing = six < 0 ? -1 : 1;
    for (t = 0; t < b.mesh.nt; t++) thin += !has_area(t);
    for (c = 0; c < 3 * b.mesh.nt; c++) {
        uint32_t o = b.mesh.O[c];
        int64_t up = facing * height(c / 3, b.mesh.V[o]);
        if (o <= c) continue;
        concave += up > 0;
        convex += up < 0;
        if (up != 0 || !has_area(c / 3) || !has_area(o / 3)) continue;
        flat += dot(normal_of(c / 3), normal_of(o / 3)) > 0;
        folded += dot(normal_of(c / 3), normal_of(o / 3)) < 0;
    }
    CHECK(g->known);
    CHECK_EQUAL(g->concave_edges, concave);
    CHECK_EQUAL(g->convex_edges, convex);
    CHECK_EQUAL(g->flat_edges, flat);
    CHECK_EQUAL(g->folded_edges, folded);
    CHECK_EQUAL(told[NOOK_FOLDED_EDGE], folded);
    CHECK_EQUAL(g->zero_area_triangles, thin);
    CHECK_EQUAL(told[NOOK_ZERO_AREA_TRIANGLE], thin);
    CHECK_EQUAL(g->volume_sign, (six > 0) - (six < 0));
    if (!closed) {
        CHECK_EQUAL(g->convex, NOOK_MAYBE);
        CHECK_EQUAL(g->witness_vertex, NOOK_NONE);
        CHECK(g->signed_volume == 0);
        return;
    }
    CHECK(g->signed_volume == (float)six / 6.0f);
    CHECK_EQUAL(g->convex,
                b.result.survey.components == 1 && six != 0 && is_convex(facing) ? NOOK_YES : NOOK_NO);
    if (g->witness_vertex == NOOK_NONE) {
        CHECK_EQUAL(g->witness_triangle, NOOK_NONE);
        CHECK(g->convex == NOOK_YES || six == 0 || is_convex(facing));
    } else {
        CHECK(facing * height(g->witness_triangle, g->witness_vertex) > 0);
    }
}

static void turn_all_over(void) {
    uint32_t t;
    for (t = 0; t < b.mesh.nt; t++) turn_over(t);
}

/* As it stands, turned over, and both again shuffled. */
static void compare_all_ways(void) {
    uint32_t i;
    dice d = {17u};
    for (i = 0; i < 4 && !test_has_failed(); i++) {
        if (i == 2) shuffle(&d);
        examine();
        compare();
        turn_all_over();
    }
}

/* ---- shapes --------------------------------------------------------------------------------------------- */

static void edges_and_convexity_of_all_shapes_are_those_of_the_definition(void) {
    uint32_t i;
    for (i = 0; i < shape_count && !test_has_failed(); i++) {
        uint32_t v;
        shapes[i].build();
        for (v = 0; v < b.mesh.nv; v++) { /* to integers */
            nook_point p = nook_scaled(b.mesh.G[v], 50);
            place(v, (float)(int32_t)p.x, (float)(int32_t)p.y, (float)(int32_t)p.z);
        }
        if (b.mesh.nt <= 128) compare_all_ways();
    }
}

static void a_cube_has_12_convex_and_6_flat_edges_and_is_convex(void) {
    cube();
    examine();
    CHECK_EQUAL(g->convex_edges, 12);
    CHECK_EQUAL(g->flat_edges, 6);
    CHECK_EQUAL(g->concave_edges + g->folded_edges + g->zero_area_triangles, 0);
    CHECK_EQUAL(g->convex, NOOK_YES);
    CHECK_EQUAL(g->witness_vertex, NOOK_NONE);
    compare();
}

/* A cube from 0 to 8, each face cut into four triangles about its middle; the middles are vertices 8 to 13. */
static void cut_face(const uint8_t corner[4], uint32_t *next) {
    nook_point *G = b.mesh.G;
    uint32_t m = (*next)++, i;
    nook_point p = G[corner[0]], q = G[corner[2]];
    place(m, (p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2);
    b.mesh.nv = *next;
    for (i = 0; i < 4; i++) add(m, corner[i], corner[(i + 1) % 4]);
}

static void cut_cube(void) {
    static const uint8_t face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    uint32_t i, next = 8;
    begin_shape(8);
    for (i = 0; i < 8; i++) place(i, i & 1 ? 8.0f : 0, i & 2 ? 8.0f : 0, i & 4 ? 8.0f : 0);
    for (i = 0; i < 6; i++) cut_face(face[i], &next);
}

/* The face x = 1 of the cube gets a point of its own: in the plane, pushed out, pushed in. */
static void a_dent_is_concave_and_names_a_vertex_outside_a_triangle(void) {
    uint32_t push;
    for (push = 0; push < 3; push++) {
        cut_cube();
        place(13, push == 0 ? 8 : push == 1 ? 9 : 7, 4, 4);
        examine();
        compare();
        CHECK_EQUAL(g->concave_edges, push == 2 ? 4 : 0);
        CHECK_EQUAL(g->convex, push == 2 ? NOOK_NO : NOOK_YES);
        CHECK_EQUAL(g->witness_vertex != NOOK_NONE, push == 2);
    }
}

/* Random closed surfaces: two triangulated cones over one polygon, all coordinates a small grid, so that
 * coplanar, folded, thin and coincident parts are common. */
static void random_double_cones_on_a_grid(void) {
    dice d = {1234567u};
    uint32_t round, i, convex = 0, thin = 0, folded = 0, rounds = NOOK_TEST_RAM < 2000000 ? 1500 : 20000;
    for (round = 0; round < rounds && !test_has_failed(); round++) {
        uint32_t n = 3 + throw_dice(&d, 4), size = 2 + throw_dice(&d, 3);
        begin_shape(n + 2);
        for (i = 0; i < n + 2; i++) {
            uint32_t x = throw_dice(&d, size), y = throw_dice(&d, size);
            place(i, (float)x, (float)y, (float)throw_dice(&d, size) - 1);
        }
        for (i = 0; i < n; i++) {
            add(n, i, (i + 1) % n);
            add(n + 1, (i + 1) % n, i);
        }
        examine();
        compare();
        convex += g->convex == NOOK_YES;
        thin += g->convex == NOOK_YES && g->zero_area_triangles != 0;
        folded += g->folded_edges != 0;
    }
    CHECK(convex > rounds / 100);
    CHECK(thin > 0);
    CHECK(folded > rounds / 100);
}

/* Put a vertex on the middle of the edge that corner c faces, and triangles without area between: each side
 * keeps its triangle, and a sliver closes the gap. */
static void add_sliver(uint32_t c) {
    uint32_t from = b.mesh.V[nook_next(c)], to = b.mesh.V[nook_prev(c)], m = b.mesh.nv++, t = c / 3;
    nook_point p = b.mesh.G[from], q = b.mesh.G[to];
    uint32_t tip = b.mesh.V[c];
    place(m, (p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2);
    b.mesh.V[3 * t] = nook_store(tip);
    b.mesh.V[3 * t + 1] = nook_store(from);
    b.mesh.V[3 * t + 2] = nook_store(m);
    add(tip, m, to);
    add(m, from, to);
}

/* In the place of the last triangle, a sliver, three about a vertex of their own on its line, perhaps beyond. */
static void spread_sliver(float along) {
    uint32_t t = b.mesh.nt - 1, w = b.mesh.nv++;
    uint32_t m = b.mesh.V[3 * t], from = b.mesh.V[3 * t + 1], to = b.mesh.V[3 * t + 2];
    nook_point p = b.mesh.G[from], q = nook_sub(b.mesh.G[to], p);
    place(w, p.x + q.x * along, p.y + q.y * along, p.z + q.z * along);
    b.mesh.V[3 * t + 2] = nook_store(w);
    add(from, to, w);
    add(to, m, w);
}

static void slivers_do_not_hide_what_is_not_convex(void) {
    dice d = {99u};
    uint32_t round, i, convex = 0, rounds = NOOK_TEST_RAM < 2000000 ? 100 : 1500;
    for (round = 0; round < rounds && !test_has_failed(); round++) {
        uint32_t slivers = 1 + throw_dice(&d, 6);
        cut_cube();
        if (round % 3 == 1) place(8, 4, 4, -1 + (float)throw_dice(&d, 3));
        if (round % 3 == 2) place(throw_dice(&d, 8), 4, 3, 4);
        for (i = 0; i < b.mesh.nv; i++) b.mesh.G[i] = nook_scaled(b.mesh.G[i], 64);
        for (i = 0; i < slivers; i++) add_sliver(throw_dice(&d, 3 * b.mesh.nt));
        if (round % 4 == 0) spread_sliver(throw_dice(&d, 3) == 0 ? 2 : 0.25f);
        if (round & 1) turn_all_over();
        examine();
        compare();
        convex += g->convex == NOOK_YES;
    }
    CHECK(convex > rounds / 4);
    CHECK(convex < rounds * 3 / 4);
}

/* A vertex of triangles without area only, on the line of an edge: between its ends, and beyond. */
static void a_vertex_of_slivers_only_may_be_outside(void) {
    uint32_t i, outside = 0;
    for (i = 0; i < 20; i++) {
        dice d = {1 + i};
        cut_cube();
        add_sliver(i);
        spread_sliver(i < 10 ? 0.25f : 2);
        if (i % 2) shuffle(&d);
        examine();
        compare();
        if (i < 10) CHECK_EQUAL(g->convex, NOOK_YES);
        outside += g->convex == NOOK_NO;
    }
    CHECK(outside >= 5); /* on half of the edges "beyond" is still on the face */
}

/* Vertices of no triangle, before and after all others and far outside, have no say. */
static void isolated_vertices_do_not_spoil_convexity(void) {
    uint32_t v, c, sliver;
    for (sliver = 0; sliver < 2; sliver++) {
        cut_cube();
        if (sliver == 1) add_sliver(0);
        for (v = b.mesh.nv++; v > 0; v--) b.mesh.G[v] = b.mesh.G[v - 1];
        for (c = 0; c < 3 * b.mesh.nt; c++) b.mesh.V[c]++;
        place(0, 99, 99, 99);
        place(b.mesh.nv++, -99, 5, 5);
        examine();
        CHECK_EQUAL(g->zero_area_triangles, sliver);
        CHECK_EQUAL(g->convex, NOOK_YES);
        CHECK(g->box_max.x == 8 && g->box_min.x == 0);
        compare();
    }
}

/* {5/2}: the pentagram as a double cone. Every edge is convex, but it goes round twice. */
static void a_surface_that_goes_round_twice_is_judged_by_its_vertices(void) {
    static const int8_t at[5][2] = {{30, 0}, {9, 29}, {-24, 18}, {-24, -18}, {9, -29}};
    uint32_t i, step;
    for (step = 1; step <= 2; step++) {
        begin_shape(7);
        for (i = 0; i < 5; i++) place(i, at[i * step % 5][0], at[i * step % 5][1], 0);
        place(5, 0, 0, 20);
        place(6, 0, 0, -20);
        for (i = 0; i < 5; i++) {
            add(5, i, (i + 1) % 5);
            add(6, (i + 1) % 5, i);
        }
        examine();
        CHECK_EQUAL(g->convex_edges, 15);
        CHECK_EQUAL(g->convex, step == 1 ? NOOK_YES : NOOK_NO);
        compare_all_ways();
    }
    /* A triangle twice round, with equal points: no vertex is outside. */
    begin_shape(8);
    for (i = 0; i < 6; i++) place(i, i % 3 == 0 ? 9 : -5, i % 3 == 1 ? 9 : i % 3 == 2 ? -9 : 0, 0);
    place(6, 0, 0, 20);
    place(7, 0, 0, -20);
    for (i = 0; i < 6; i++) {
        add(6, i, (i + 1) % 6);
        add(7, (i + 1) % 6, i);
    }
    examine();
    CHECK_EQUAL(g->convex_edges, 18);
    compare();
    CHECK_EQUAL(g->convex, NOOK_YES);
}

static nook_status run(bool closed, nook_shells *shells, uint32_t cut, uint32_t *spent,
                       nook_geometry *result) {
    nook_geometry_state state;
    nook_view view = nook_view_of(&b.mesh);
    nook_status status = nook_geometry_begin(&state, &view, closed, shells, NULL, result);
    uint32_t calls = 0;
    *spent = 0;
    if (status != NOOK_OK) return status;
    do {
        uint32_t units = cut;
        status = nook_geometry_step(&state, &units);
        *spent += cut - units;
    } while (status == NOOK_MORE && ++calls < 1000000);
    return status;
}

static void two_shells_are_never_convex(void) {
    uint32_t v, spent;
    nook_geometry result;
    shapes[14].build();
    examine();
    CHECK_EQUAL(g->convex, NOOK_NO);
    compare();
    for (v = 0; v < 4; v++) b.mesh.G[v] = b.mesh.G[v + 4]; /* coincident */
    examine();
    CHECK_EQUAL(g->convex, NOOK_NO);
    CHECK_EQUAL(run(true, &b.shells, 100, &spent, &result), NOOK_OK);
    CHECK_EQUAL(result.convex, NOOK_NO);
    CHECK(spent < 140 * b.mesh.nt + 13 * b.mesh.nv + 30); /* two shells are enough to know */
    CHECK_EQUAL(run(true, NULL, 100, &spent, &result), NOOK_OK);
    CHECK_EQUAL(result.convex, NOOK_YES); /* no vertex outside, for who does not know the shells */
    for (v = 0; v < 4; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v + 4], 2);
    examine();
    CHECK_EQUAL(g->convex, NOOK_NO);
}

/* Closed meshes of no extent: every answer is there, and no is the answer. */
static void points_that_are_all_equal_or_on_a_line_or_in_a_plane_have_no_solid(void) {
    static const float at[] = {0, -0.0f, 1e-45f, 1073741824.0f, -0.1f};
    uint32_t i, dimension, v;
    for (i = 0; i < 5; i++) {
        for (dimension = 0; dimension < 3; dimension++) {
            cube();
            for (v = 0; v < 8; v++) {
                nook_point p = b.mesh.G[v];
                place(v, at[i], dimension > 0 ? p.y + p.z : at[i], dimension > 1 ? p.z : at[i]);
            }
            examine();
            CHECK(g->known && !g->mass_known);
            CHECK_EQUAL(g->zero_area_triangles == 12, dimension < 2);
            CHECK_EQUAL(g->concave_edges + g->convex_edges, 0);
            CHECK_EQUAL(g->flat_edges + g->folded_edges != 0, dimension == 2);
            CHECK(g->signed_volume == 0 && (g->area == 0) == (dimension < 2));
            CHECK_EQUAL(g->convex, NOOK_NO);
            CHECK_EQUAL(g->witness_vertex, NOOK_NONE);
            CHECK_EQUAL(told[NOOK_FLAT_SHELL], 1);
            CHECK(g->box_min.x == at[i] && g->box_max.x == at[i]);
            CHECK(!nook_is_sound(&b.result));
        }
    }
}

/* A cube whose corners are a last place off: convex or not as the exact signs say, and never both. */
static void a_cube_a_last_place_off_is_convex_or_names_its_witness(void) {
    dice d = {8u};
    uint32_t round, v, convex = 0;
    for (round = 0; round < 200 && !test_has_failed(); round++) {
        cut_cube();
        for (v = 0; v < 14; v++) {
            nook_point p = b.mesh.G[v];
            uint32_t bits = nook_float_bits(p.x + 1) + throw_dice(&d, 5) / 4;
            place(v, nook_float_from(bits), p.y + 0.1f, p.z * 1073741824.0f / 8);
        }
        examine();
        convex += g->convex == NOOK_YES;
        CHECK((g->convex == NOOK_NO) == (g->witness_vertex != NOOK_NONE));
        CHECK(g->convex == NOOK_NO || g->concave_edges == 0);
        if (g->convex == NOOK_NO) {
            const nook_point *G = b.mesh.G;
            const nook_index *V = b.mesh.V + 3 * g->witness_triangle;
            CHECK_EQUAL(nook_orient3d(&G[V[0]], &G[V[1]], &G[V[2]], &G[g->witness_vertex]), 1);
        }
    }
    CHECK(convex > 0 && convex < 200);
}

/* ---- volume and mass ------------------------------------------------------------------------------------- */

/* A brick so thin and so far away that a float sum gets its sign by chance. */
static void a_thin_far_shell_knows_its_inside(void) {
    uint32_t i, v;
    for (i = 0; i < 40 && !test_has_failed(); i++) {
        cube();
        for (v = 0; v < 8; v++) {
            nook_point p = b.mesh.G[v];
            uint32_t bits = nook_float_bits(1000003.0f) + (p.z != 0) + i;
            place(v, p.x * 3000 + 777777, p.y * 3000 - 999999, nook_float_from(bits));
        }
        if (i % 2) turn_all_over();
        examine();
        CHECK_EQUAL(g->volume_sign, i % 2 ? -1 : 1);
        CHECK_EQUAL(told[NOOK_INSIDE_OUT], i % 2);
        CHECK(g->signed_volume == (i % 2 ? -562500.0f : 562500.0f));
        CHECK(b.shell[0].signed_volume == g->signed_volume);
        CHECK_EQUAL(g->convex, NOOK_YES);
    }
}

static bool near(float got, float expected, float error) {
    float off = got - expected;
    return off <= error && -off <= error;
}

static void a_brick_has_the_centroid_and_inertia_of_the_formula(void) {
    static const float place_at[][3] = {{0, 0, 0}, {100, -50, 7}, {-3000, 2000, 1000}};
    uint32_t i, v, over;
    for (i = 0; i < 3; i++) {
        for (over = 0; over < 2; over++) {
            const float *o = place_at[i], m = 2 * 4 * 6;
            cube();
            for (v = 0; v < 8; v++) {
                place(v, o[0] + 2 * b.mesh.G[v].x, o[1] + 4 * b.mesh.G[v].y, o[2] + 6 * b.mesh.G[v].z);
            }
            if (over) turn_all_over();
            examine();
            CHECK(g->signed_volume == (over ? -m : m));
            CHECK(near(g->centroid.x, o[0] + 1, 1e-3f) && near(g->centroid.y, o[1] + 2, 1e-3f));
            CHECK(near(g->centroid.z, o[2] + 3, 1e-3f));
            CHECK(near(g->inertia[0], m / 12 * (16 + 36), 1e-3f * m) && near(g->inertia[1], 0, 1e-3f * m));
            CHECK(near(g->inertia[3], m / 12 * (4 + 36), 1e-3f * m) && near(g->inertia[2], 0, 1e-3f * m));
            CHECK(near(g->inertia[5], m / 12 * (4 + 16), 1e-3f * m) && near(g->inertia[4], 0, 1e-3f * m));
        }
    }
}

/* With corners at the origin and on the axes at a, b, c: centroid (a b c) / 4, products -V a b / 20 about the
 * origin, and V a b / 80 more about the centroid. */
static void a_corner_tetrahedron_has_its_products_of_inertia(void) {
    float v = 2.0f * 3 * 5 / 6;
    tetrahedron();
    place(0, 0, 0, 0);
    place(1, 2, 0, 0);
    place(2, 0, 3, 0);
    place(3, 0, 0, 5);
    examine();
    if (g->volume_sign < 0) {
        turn_all_over();
        examine();
    }
    CHECK(near(g->signed_volume, v, 1e-5f));
    CHECK(near(g->centroid.x, 0.5f, 1e-6f) && near(g->centroid.y, 0.75f, 1e-6f));
    CHECK(near(g->centroid.z, 1.25f, 1e-6f));
    CHECK(near(g->inertia[1], v * 6 / 80, 1e-5f) && near(g->inertia[2], v * 10 / 80, 1e-5f));
    CHECK(near(g->inertia[4], v * 15 / 80, 1e-5f));
    CHECK(near(g->inertia[0], v * 3 / 80 * (9 + 25), 2e-5f) &&
          near(g->inertia[3], v * 3 / 80 * (4 + 25), 2e-5f));
    CHECK(near(g->inertia[5], v * 3 / 80 * (4 + 9), 2e-5f));
}

/* Four million sizes from the origin the inertia is still that about the centroid. */
static void far_from_the_origin_the_mass_is_the_same(void) {
    uint32_t v;
    float o = 4194304;
    tetrahedron();
    for (v = 0; v < 4; v++) place(v, o + (v == 1), o + (v == 2), o + (v == 3));
    examine();
    CHECK(g->mass_known);
    CHECK(near(g->inertia[0], 0.0125f, 1e-7f) && near(g->inertia[3], 0.0125f, 1e-7f));
    CHECK(near(g->inertia[1], 1.0f / 480, 1e-8f) && near(g->inertia[5], 0.0125f, 1e-7f));
    CHECK(near(g->centroid.x, o, 0.5f));
}

/* So thin that float sums are noise: then nothing is said. */
static void the_mass_of_a_paper_thin_body_is_unknown(void) {
    tetrahedron();
    place(0, 100.80000305175781f, -0.10227286070585251f, -0.6000000238418579f);
    place(1, 99.49482727050781f, -0.16715233027935028f, 0.3788813352584839f);
    place(2, 100.64140319824219f, -0.125f, -0.48105019330978394f);
    place(3, 99.5f, -0.5f, 0.37500080466270447f);
    examine();
    CHECK(g->volume_sign != 0);
    CHECK(!g->mass_known);
    CHECK(g->centroid.x == 0 && g->inertia[0] == 0);
    CHECK_EQUAL(g->convex, NOOK_YES);
}

/* Scaled by a power of two, everything scales exactly, down to where floats end. */
static void mass_scales_with_the_mesh(void) {
    static const int32_t exponent[] = {-20, -10, 10, 20};
    uint32_t i, k, v;
    nook_geometry whole;
    shapes[5].build();
    examine();
    whole = *g;
    for (i = 0; i < 4; i++) {
        float s = nook_power_of_two((uint32_t)(127 + exponent[i]));
        shapes[5].build();
        for (v = 0; v < b.mesh.nv; v++) b.mesh.G[v] = nook_scaled(b.mesh.G[v], s);
        examine();
        CHECK(g->area == whole.area * s * s);
        CHECK(g->signed_volume == whole.signed_volume * s * s * s);
        CHECK(g->centroid.x == whole.centroid.x * s && g->centroid.y == whole.centroid.y * s);
        for (k = 0; k < 6; k++) CHECK(g->inertia[k] == whole.inertia[k] * s * s * s * s * s);
        CHECK_EQUAL(g->concave_edges, whole.concave_edges);
        CHECK_EQUAL(g->flat_edges, whole.flat_edges);
    }
}

/* 2^130 times as long as wide: the size is that of the longest axis, whichever that is. */
static void a_needle_along_any_axis_keeps_its_area(void) {
    uint32_t axis, v;
    for (axis = 0; axis < 3; axis++) {
        const float x = axis == 0 ? 0x1p+30f : 0x1p-100f, y = axis == 1 ? 0x1p+30f : 0x1p-100f;
        const float z = axis == 2 ? 0x1p+30f : 0x1p-100f;
        cube();
        for (v = 0; v < 8; v++) place(v, b.mesh.G[v].x * x, b.mesh.G[v].y * y, b.mesh.G[v].z * z);
        examine();
        CHECK(g->area == 0x1p-68f);
        CHECK(g->box_max.x == x && g->box_max.y == y && g->box_max.z == z);
    }
}

/* Here float sums give a volume that is one part in a hundred off: too far to say anything of the mass. */
static void a_mass_one_hundredth_off_is_unknown(void) {
    tetrahedron();
    place(0, 56, 21, 0x1.3403cp+5f);
    place(1, 35, 24, 0x1.d801ap+4f);
    place(2, 61, 52, 0x1.c4029p+5f);
    place(3, 33, 26, 0x1.d8016p+4f);
    examine();
    CHECK(g->volume_sign != 0);
    CHECK(!g->mass_known);
}

/* Without shells to look at, the survey still counts them. */
static void two_shells_are_never_convex_for_a_check_without_shells(void) {
    uint32_t v;
    nook_view view;
    shapes[14].build();
    for (v = 0; v < 4; v++) b.mesh.G[v] = b.mesh.G[v + 4];
    CHECK_EQUAL(nook_link(&b.mesh, &b.marks, NULL, NULL, &b.report, NULL), NOOK_OK);
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_check(&view, &b.marks, &b.report, NULL, NULL, &b.result), NOOK_OK);
    CHECK_EQUAL(b.result.survey.components, 2);
    CHECK_EQUAL(g->convex, NOOK_NO);
}

static void a_folded_edge_is_named_by_a_corner_that_faces_it(void) {
    uint32_t turn;
    static const uint8_t list[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    for (turn = 0; turn < 3; turn++) {
        begin_shape(4);
        place(0, 0, 0, 0);
        place(1, 4, 0, 0);
        place(2, 0, 4, 0);
        place(3, 1, 1, 0);
        add_list(list[turn], 1);
        add(2, 1, 3);
        examine();
        CHECK_EQUAL(g->folded_edges, 1);
        CHECK_EQUAL(last[NOOK_FOLDED_EDGE].kind, NOOK_AT_CORNER);
        CHECK(last[NOOK_FOLDED_EDGE].index == (3 - turn) % 3 || last[NOOK_FOLDED_EDGE].index == 5);
    }
}

/* Two cones over a bent square whose tips lean out over the edge 0-1: the only concave edge, seen from the tips,
 * 4 and 5, alone. */
static void leaning_cones(void) {
    static const int8_t at[6][3] = {{0, 0, 0}, {8, 0, 0}, {8, 8, 2}, {0, 8, -2}, {4, -4, 8}, {4, -4, -8}};
    uint32_t i;
    begin_shape(6);
    for (i = 0; i < 6; i++) place(i, at[i][0] * 4096.0f, at[i][1] * 4096.0f, at[i][2] * 4096.0f);
    for (i = 0; i < 4; i++) {
        add(4, i, (i + 1) % 4);
        add(5, (i + 1) % 4, i);
    }
}

/* A sliver hides the concave edge, across the first, second, third corner of its triangles. */
static void a_concave_edge_is_found_behind_a_sliver_across_any_corner(void) {
    uint32_t turn, i, c;
    leaning_cones();
    examine();
    CHECK_EQUAL(g->concave_edges, 1);
    for (turn = 0; turn < 3; turn++) {
        leaning_cones();
        add_sliver(0);
        for (c = 0; c < 3 * b.mesh.nt; c += 3) {
            nook_index keep[3];
            for (i = 0; i < 3; i++) keep[i] = b.mesh.V[c + i];
            for (i = 0; i < 3; i++) b.mesh.V[c + i] = keep[(i + turn) % 3];
        }
        examine();
        CHECK_EQUAL(g->concave_edges, 0);
        CHECK_EQUAL(g->convex, NOOK_NO);
        compare();
    }
}

/* Three triangles that are in order, each held just before one of the concave edge that has two corners in its
 * plane and faces the same way along x. Slivers lie on the edges 0-1, 1-2 and 3-0. */
static void a_triangle_held_stands_only_for_those_in_its_plane(void) {
    static const int8_t at[9][3] = {{0, 0, 0},   {0, 0, 8}, {8, 2, 10}, {8, -2, -2}, {-4, 8, 4},
                                    {-4, -8, 4}, {0, 0, 4}, {4, 1, 9},  {4, -1, -1}};
    static const uint8_t list[] = {4, 8, 0, 4, 0, 6, 4, 1, 7, 1, 4, 6, 5, 2, 1, 5, 1, 0, 6, 0, 1,
                                   7, 1, 2, 8, 3, 0, 4, 7, 2, 4, 2, 3, 4, 3, 8, 5, 3, 2, 5, 0, 3};
    uint32_t i;
    begin_shape(9);
    for (i = 0; i < 9; i++) place(i, at[i][0], at[i][1], at[i][2]);
    add_list(list, 14);
    examine();
    CHECK_EQUAL(g->concave_edges, 0);
    CHECK_EQUAL(g->convex, NOOK_NO);
    compare();
}

/* One vertex of the first shell stands out of the second: whichever it is, it is the witness or another one is. */
static void one_vertex_outside_another_shell_is_a_witness(void) {
    static const uint8_t list[] = {4, 6, 5, 4, 5, 7, 5, 6, 7, 6, 4, 7};
    uint32_t out;
    for (out = 0; out < 4; out++) {
        uint32_t v;
        tetrahedron();
        b.mesh.nv = 8;
        for (v = 0; v < 4; v++)
            b.mesh.G[v] = nook_make(10 + 4 * b.mesh.G[v].x, 10 + 4 * b.mesh.G[v].y, 10 + 4 * b.mesh.G[v].z);
        if (out == 0) place(0, 8, 8, -5);
        if (out == 1) place(1, 90, 10, 10);
        if (out == 2) place(2, 10, 90, 10);
        if (out == 3) place(3, 10, 10, 90);
        place(4, 0, 0, 0);
        place(5, 60, 0, 0);
        place(6, 0, 60, 0);
        place(7, 0, 0, 60);
        add_list(list, 4);
        examine();
        CHECK_EQUAL(g->convex, NOOK_NO);
        CHECK(g->witness_vertex != NOOK_NONE);
        compare();
    }
}

/* ---- the call ---------------------------------------------------------------------------------------------- */

static void what_it_cannot_do_without_is_asked_for(void) {
    nook_geometry_state state;
    nook_geometry result;
    nook_view view;
    nook_shells broken = b.shells;
    cube();
    examine();
    view = nook_view_of(&b.mesh);
    CHECK_EQUAL(nook_geometry_begin(NULL, &view, true, NULL, NULL, &result), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_geometry_begin(&state, NULL, true, NULL, NULL, &result), NOOK_NULL_ARGUMENT);
    CHECK_EQUAL(nook_geometry_begin(&state, &view, true, NULL, NULL, NULL), NOOK_NULL_ARGUMENT);
    broken.component = NULL;
    CHECK_EQUAL(nook_geometry_begin(&state, &view, true, &broken, NULL, &result), NOOK_NULL_ARGUMENT);
    CHECK(sizeof state <= 256 && sizeof(nook_check_state) <= 256);
}

static void units_are_the_same_however_they_are_cut_and_within_the_bound(void) {
    static const uint32_t cuts[] = {1, 7, 1000, UINT32_MAX};
    uint32_t i, k;
    for (i = 0; i < shape_count; i++) {
        uint32_t first = 0;
        nook_geometry whole;
        shapes[i].build();
        if (b.mesh.nt > 128) continue;
        examine();
        for (k = 0; k < 4; k++) {
            uint32_t spent;
            nook_geometry result;
            CHECK_EQUAL(run(b.result.watertight == NOOK_YES, NULL, cuts[k], &spent, &result), NOOK_OK);
            CHECK(spent < 140 * b.mesh.nt + 13 * b.mesh.nv + 30);
            if (k == 0) first = spent, whole = result;
            CHECK_EQUAL(spent, first);
            CHECK(memcmp(&result.volume, &whole.volume, sizeof result.volume) == 0);
            CHECK(result.area == whole.area && result.convex == whole.convex);
        }
    }
}

/* Exact signs are paid at their worst, so that a slice of a tick can be counted on: 9 units a side of a plane, 4 a
 * turn. The cube's 12 convex edges, 6 flat ones, and 4 sides of 12 triangles alone come to 690. */
static void the_units_of_a_cube_are_those_of_its_passes(void) {
    uint32_t spent;
    nook_geometry result;
    cube();
    examine();
    CHECK_EQUAL(run(true, NULL, 5, &spent, &result), NOOK_OK);
    CHECK(spent > 12 * 9 + 6 * (9 + 16) + 4 * 12 * 9 + 12 * (3 + 2 + 3 + 12));
    CHECK_EQUAL(spent, 1099);
    CHECK_EQUAL(run(false, NULL, 5, &spent, &result), NOOK_OK);
    CHECK_EQUAL(spent, 478);
}

/* A convex mesh is known in one pass, be it right or inside out. */
static void a_mesh_inside_out_takes_as_many_units(void) {
    uint32_t over, spent[2];
    nook_geometry result;
    for (over = 0; over < 2; over++) {
        icosphere(2);
        if (over) turn_all_over();
        examine();
        CHECK_EQUAL(run(true, NULL, 1000, &spent[over], &result), NOOK_OK);
        CHECK_EQUAL(result.convex, NOOK_YES);
        CHECK(spent[over] < 140 * b.mesh.nt + 13 * b.mesh.nv + 30);
    }
}

/* A pyramid on a polygon whose flat ground is cut by slivers: one triangle stands for all of that plane. */
static void slivers_in_one_plane_are_held_once(void) {
    enum { N = 30 };
    uint32_t i, spent;
    nook_geometry result;
    begin_shape(N + 2);
    for (i = 0; i < N; i++) place(i, (float)i, (float)(i * i), 0);
    place(N, N / 2, 10 * N, 0);
    place(N + 1, N / 2, 10 * N, 50);
    for (i = 0; i < N; i++) add(N, (i + 1) % N, i);
    for (i = 0; i < N; i++) add(N + 1, i, (i + 1) % N);
    for (i = 0; i < N; i++) add_sliver(3 * i + 1);
    examine();
    CHECK_EQUAL(g->convex, NOOK_YES);
    CHECK_EQUAL(run(true, NULL, 1000, &spent, &result), NOOK_OK);
    CHECK(spent < 230 * b.mesh.nt + 103 * b.mesh.nv + 30 + 10 * (b.mesh.nt + b.mesh.nv));
}

/* Any bits in O: other answers, but within the bound and inside the arrays. */
static void any_opposites_end_in_time(void) {
    dice d = {5150u};
    uint32_t round, c;
    for (round = 0; round < 300; round++) {
        uint32_t spent;
        nook_geometry result;
        cube();
        if (round % 2) place(0, 0.5f, 0, 0);
        CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
        for (c = 0; c < 36; c++) {
            if (throw_dice(&d, 4) == 0)
                b.mesh.O[c] = (nook_index)throw_dice(&d, throw_dice(&d, 2) ? 50u : UINT32_MAX);
        }
        CHECK_EQUAL(run(true, NULL, 100, &spent, &result), NOOK_OK);
        CHECK(spent <= NOOK_CHECK_UNITS(12, 8, 12));
    }
}

static void a_single_opposite_out_of_range_takes_one_edge_away(void) {
    uint32_t c, nc;
    cut_cube();
    add_sliver(0);
    CHECK_EQUAL(link_and_check(NULL), NOOK_OK);
    nc = 3 * b.mesh.nt;
    for (c = 0; c < nc; c++) {
        uint32_t spent, all = g->convex_edges + g->flat_edges, edges;
        nook_index keep = b.mesh.O[c];
        nook_geometry result;
        b.mesh.O[c] = NOOK_STORED_NONE;
        CHECK_EQUAL(run(true, NULL, 1000, &spent, &result), NOOK_OK);
        edges = result.convex_edges + result.flat_edges;
        CHECK(edges == all || (edges == all - 1 && c < keep));
        CHECK_EQUAL(result.convex, NOOK_YES);
        b.mesh.O[c] = keep;
    }
}

static const test tests[] = {
    TEST(edges_and_convexity_of_all_shapes_are_those_of_the_definition),
    TEST(a_cube_has_12_convex_and_6_flat_edges_and_is_convex),
    TEST(a_dent_is_concave_and_names_a_vertex_outside_a_triangle),
    TEST(random_double_cones_on_a_grid),
    TEST(slivers_do_not_hide_what_is_not_convex),
    TEST(a_vertex_of_slivers_only_may_be_outside),
    TEST(isolated_vertices_do_not_spoil_convexity),
    TEST(a_surface_that_goes_round_twice_is_judged_by_its_vertices),
    TEST(two_shells_are_never_convex),
    TEST(points_that_are_all_equal_or_on_a_line_or_in_a_plane_have_no_solid),
    TEST(a_cube_a_last_place_off_is_convex_or_names_its_witness),
    TEST(a_thin_far_shell_knows_its_inside),
    TEST(a_brick_has_the_centroid_and_inertia_of_the_formula),
    TEST(a_corner_tetrahedron_has_its_products_of_inertia),
    TEST(far_from_the_origin_the_mass_is_the_same),
    TEST(the_mass_of_a_paper_thin_body_is_unknown),
    TEST(mass_scales_with_the_mesh),
    TEST(what_it_cannot_do_without_is_asked_for),
    TEST(units_are_the_same_however_they_are_cut_and_within_the_bound),
    TEST(the_units_of_a_cube_are_those_of_its_passes),
    TEST(a_needle_along_any_axis_keeps_its_area),
    TEST(a_folded_edge_is_named_by_a_corner_that_faces_it),
    TEST(a_concave_edge_is_found_behind_a_sliver_across_any_corner),
    TEST(a_triangle_held_stands_only_for_those_in_its_plane),
    TEST(one_vertex_outside_another_shell_is_a_witness),
    TEST(a_mesh_inside_out_takes_as_many_units),
    TEST(slivers_in_one_plane_are_held_once),
    TEST(a_mass_one_hundredth_off_is_unknown),
    TEST(two_shells_are_never_convex_for_a_check_without_shells),
    TEST(any_opposites_end_in_time),
    TEST(a_single_opposite_out_of_range_takes_one_edge_away),
};

void test_geometry(void) { run_tests(tests, sizeof tests / sizeof *tests); }
