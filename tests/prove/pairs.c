/* pairs.c -- do two triangles meet? Every pair on a grid, the same moved and scaled, near misses, and any
 * floats.
 *
 * The oracle is weights.h, which knows no planes and no cases. On the grid of 3 x 3 x 3 points a triangle
 * is any three of them, equal ones too: segments and points are triangles here. The first is taken once
 * for all that the 48 symmetries of a cube make of it, the second is every one, so that all 27^6 pairs are
 * covered up to symmetry and the order of corners; that order is thrown. */
#include "prove.h"
#include "weights.h"

#include "query/nook_pair.h"

#include <stdio.h>
#include <string.h>

enum { SIDE = 3, POINTS = SIDE * SIDE * SIDE, MOST_TRIPLES = 3654, SYMMETRIES = 48 };

static dice d = {20240607u};
static struct { uint32_t pairs, meet, wrong; } count;

static void begin_count(void) { memset(&count, 0, sizeof count); }

/* Neither answer may be so rare that the test says nothing. */
static void end_count(const char *label, uint32_t since) {
    CHECK_EQUAL(count.wrong, 0);
    CHECK(count.meet > count.pairs / 50);
    CHECK(count.pairs - count.meet > count.pairs / 50);
    print_figure(label, count.pairs, "pairs", since);
    (void)printf("  %u meet\n", (unsigned)count.meet);
}

static void print_points(const nook_point *p) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        (void)printf(" (%a, %a, %a)", (double)p[i].x, (double)p[i].y, (double)p[i].z);
    }
}

static void judge(const nook_point *a, const nook_point *b, bool got, bool expected) {
    if (got == expected) return;
    if (count.wrong++ >= 5) return;
    (void)printf("wrong:");
    print_points(a);
    (void)printf(" and");
    print_points(b);
    (void)printf(" %s\n", expected ? "meet" : "do not meet");
}

static const uint8_t orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

static bool asked(const nook_point *a, uint32_t order_of_a, const nook_point *b, uint32_t order_of_b) {
    const nook_point *p[3], *q[3];
    uint32_t i;
    for (i = 0; i < 3; i++) {
        p[i] = &a[orders[order_of_a][i]];
        q[i] = &b[orders[order_of_b][i]];
    }
    return nook_triangles_meet(p, q);
}

/* As they stand, the other way round, and in orders that are thrown. */
static void ask(const nook_point *a, const nook_point *b, bool expected) {
    uint32_t order = throw_dice(&d, 36);
    count.pairs++;
    count.meet += expected;
    judge(a, b, asked(a, 0, b, 0), expected);
    judge(a, b, asked(b, 0, a, 0), expected);
    judge(a, b, asked(a, order / 6, b, order % 6), expected);
    order = throw_dice(&d, 36);
    judge(a, b, asked(b, order / 6, a, order % 6), expected);
}

/* ---- the grid ------------------------------------------------------------------------------------- */

typedef struct triple {
    uint8_t point[3];
} triple;

static triple all[MOST_TRIPLES];
static uint32_t listed;

static void list_triples(void) {
    uint32_t i, j, k;
    listed = 0;
    for (i = 0; i < POINTS; i++) {
        for (j = i; j < POINTS; j++) {
            for (k = j; k < POINTS; k++) {
                triple t = {{(uint8_t)i, (uint8_t)j, (uint8_t)k}};
                all[listed++] = t;
            }
        }
    }
}

static uint32_t digit(uint32_t point, uint32_t axis) {
    return axis == 0 ? point % SIDE : axis == 1 ? point / SIDE % SIDE : point / SIDE / SIDE;
}

/* Where symmetry s takes a point: axes in one of six orders, each turned round or not. */
static uint8_t taken_by(uint32_t s, uint32_t point) {
    uint32_t axis, place = 1, to = 0;
    for (axis = 0; axis < 3; axis++, place *= SIDE) {
        uint32_t x = digit(point, orders[s / 8][axis]);
        to += place * (s >> axis & 1 ? SIDE - 1 - x : x);
    }
    return (uint8_t)to;
}

static uint32_t code_of(const uint8_t *p) {
    uint32_t least = p[0], most = p[0], i, all_three = 0;
    for (i = 0; i < 3; i++) {
        if (p[i] < least) least = p[i];
        if (p[i] > most) most = p[i];
        all_three += p[i];
    }
    return (least * POINTS + (all_three - least - most)) * POINTS + most;
}

/* Whether no symmetry takes it to a lesser one. */
static bool stands_for_its_kind(const triple *t) {
    uint32_t s, i, code = code_of(t->point);
    for (s = 0; s < SYMMETRIES; s++) {
        uint8_t p[3];
        for (i = 0; i < 3; i++) p[i] = taken_by(s, t->point[i]);
        if (code_of(p) < code) return false;
    }
    return true;
}

static void place_triple(const triple *t, nook_point *p, vector *v) {
    uint32_t i, axis;
    for (i = 0; i < 3; i++) {
        for (axis = 0; axis < 3; axis++) v[i].at[axis] = digit(t->point[i], axis);
        p[i] = nook_make((float)v[i].at[0], (float)v[i].at[1], (float)v[i].at[2]);
    }
}

static void two_triangles_of_a_grid_meet_if_a_mean_of_their_differences_is_0(void) {
    uint32_t i, j, kinds = 0, since = milliseconds();
    nook_point p[3], q[3];
    vector a[3], b[3];
    begin_count();
    for (i = 0; i < listed; i++) {
        if (!stands_for_its_kind(&all[i])) continue;
        kinds++;
        place_triple(&all[i], p, a);
        for (j = 0; j < listed; j++) {
            place_triple(&all[j], q, b);
            ask(p, q, hulls_meet(a, 3, b, 3));
        }
    }
    end_count("triangles, segments and points on 3 x 3 x 3 points, one for each symmetry, with all", since);
    CHECK_EQUAL(kinds, 136); /* Burnside */
}

/* ---- in a mesh: vertices shared by number --------------------------------------------------------- */

/* Vertices 0 to 2 are those of the first triangle; those of the second are name[], of 0 to 2 or 3 to 5. */
static vector at[6];
static uint32_t name[3];

/* The turn of p q r as seen along an axis. */
static int turn(const vector *p, const vector *q, const vector *r, uint32_t axis) {
    static const vector unit[3] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    vector u = minus(q, p), v = minus(r, p);
    return sign_of(&u, &v, &unit[axis]);
}

/* c and e are on one side of the edge p q, and in one plane with it. */
static bool folded(const vector *p, const vector *q, const vector *c, const vector *e) {
    vector u = minus(q, p), v = minus(c, p), w = minus(e, p);
    uint32_t axis;
    if (sign_of(&u, &v, &w) != 0) return false;
    for (axis = 0; axis < 3; axis++) {
        if (turn(p, q, c, axis) * turn(p, q, e, axis) > 0) return true;
    }
    return false;
}

/* By the definition; c is the corner of the second triangle of which it is said that it is shared, or not. */
static bool intersect_by_definition(const vector *a, const vector *b, uint32_t shared, uint32_t c) {
    uint32_t i = name[c];
    if (has_no_area(a) || has_no_area(b)) return false;
    if (shared == 0) return hulls_meet(a, 3, b, 3);
    if (shared == 3) return true;
    if (shared == 1) {
        vector of_a[2], of_b[2];
        of_a[0] = a[(i + 1) % 3], of_a[1] = a[(i + 2) % 3];
        of_b[0] = b[(c + 1) % 3], of_b[1] = b[(c + 2) % 3];
        return hulls_meet(a, 3, of_b, 2) || hulls_meet(b, 3, of_a, 2);
    }
    i = 3 - name[(c + 1) % 3] - name[(c + 2) % 3];
    return folded(&b[(c + 1) % 3], &b[(c + 2) % 3], &a[i], &b[c]);
}

static bool should_intersect(uint32_t shared) {
    vector b[3];
    uint32_t i, c = 0;
    for (i = 0; i < 3; i++) {
        b[i] = at[name[i]];
        if ((name[i] < 3) == (shared == 1)) c = i;
    }
    return intersect_by_definition(at, b, shared, c);
}

static uint32_t seen[4][2]; /* by how many vertices they share, and by the answer */

static void ask_in_mesh(const nook_point *G, bool expected) {
    nook_index V[6];
    nook_view view = {G, V, NULL, NULL, 6, 2};
    uint32_t times, i;
    for (times = 0; times < 2; times++) {
        uint32_t order = times == 0 ? 0 : throw_dice(&d, 36);
        for (i = 0; i < 3; i++) {
            V[i] = orders[order / 6][i];
            V[3 + i] = nook_store(name[orders[order % 6][i]]);
        }
        judge(G, G + 3, nook_triangles_intersect(&view, 0, 1), expected);
        judge(G, G + 3, nook_triangles_intersect(&view, 1, 0), expected);
    }
}

static void ask_sharing(const nook_point *G) {
    uint32_t shared = (uint32_t)(name[0] < 3) + (uint32_t)(name[1] < 3) + (uint32_t)(name[2] < 3);
    bool expected = should_intersect(shared);
    seen[shared][expected]++;
    count.pairs++;
    count.meet += expected;
    ask_in_mesh(G, expected);
}

static bool is_named(uint32_t v, uint32_t before) {
    uint32_t i;
    for (i = 0; i < before; i++) {
        if (name[i] == v) return true;
    }
    return false;
}

/* Corner i has, of the first triangle, each vertex in turn that lies where it lies; or a vertex of its
 * own. */
static void share_and_ask(const nook_point *G, uint32_t i) {
    uint32_t v;
    if (i == 3) {
        ask_sharing(G);
        return;
    }
    name[i] = 3 + i;
    share_and_ask(G, i + 1);
    for (v = 0; v < 3; v++) {
        if (memcmp(&at[v], &at[3 + i], sizeof at[0]) != 0 || is_named(v, i)) continue;
        name[i] = v;
        share_and_ask(G, i + 1);
    }
}

static void two_triangles_of_a_mesh_intersect_as_defined_whatever_they_share(void) {
    uint32_t i, j, since = milliseconds();
    nook_point G[6];
    begin_count();
    for (i = 0; i < listed; i++) {
        if (!stands_for_its_kind(&all[i])) continue;
        place_triple(&all[i], G, at);
        for (j = 0; j < listed; j++) {
            place_triple(&all[j], G + 3, at + 3);
            share_and_ask(G, 0);
        }
    }
    end_count("the same in a mesh, with every choice of shared vertices", since);
    for (i = 0; i < 3; i++) CHECK(seen[i][0] > 0 && seen[i][1] > 0);
    CHECK(seen[3][1] > 0);
}

/* A vertex twice in a triangle, by number. */
static void a_triangle_with_a_vertex_twice_intersects_nothing(void) {
    static const nook_point G[6] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, -1}, {0, 1, 1}, {1, 1, 1}};
    uint32_t code, i;
    for (code = 0; code < 46656; code++) {
        nook_index V[6];
        nook_view view = {G, V, NULL, NULL, 6, 2};
        uint32_t rest = code;
        for (i = 0; i < 6; i++, rest /= 6) V[i] = nook_store(rest % 6);
        for (i = 0; i < 6; i += 3) {
            if (V[i] == V[i + 1] || V[i + 1] == V[i + 2] || V[i + 2] == V[i]) break;
        }
        if (i < 6) CHECK(!nook_triangles_intersect(&view, 0, 1) && !nook_triangles_intersect(&view, 1, 0));
    }
}

/* ---- the grid moved and scaled: nearly touching, by rounding -------------------------------------- */

static float unit(void) { return (float)throw_dice(&d, 0x1000000u) * 0x1p-23f - 1.0f; }

static void ask_on_lattice(nook_point *p) {
    lattice l = lattice_of(p, 6);
    vector v[6];
    uint32_t i;
    for (i = 0; i < 6; i++) {
        p[i] = to_lattice(l, p[i]);
        v[i] = take_point(l, p[i]);
    }
    ask(p, p + 3, hulls_meet(v, 3, v + 3, 3));
}

static void throw_grid(nook_point *p, float scale, nook_point offset) {
    uint32_t i;
    for (i = 0; i < 6; i++) {
        uint32_t point = throw_dice(&d, POINTS);
        p[i].x = offset.x + scale * (float)digit(point, 0);
        p[i].y = offset.y + scale * (float)digit(point, 1);
        p[i].z = offset.z + scale * (float)digit(point, 2);
    }
}

static void moved_and_scaled_grids_have_the_same_answers_as_integers(void) {
    static const float scales[] = {1e-3f, 1e-2f, 0.1f, 1, 3, 10, 100, 1e3f, 1e4f};
    uint32_t i, since = milliseconds();
    begin_count();
    for (i = 0; i < 1000000; i++) {
        nook_point p[6], offset;
        float reach = scales[throw_dice(&d, 9)];
        offset.x = unit() * reach;
        offset.y = unit() * reach;
        offset.z = unit() * reach;
        throw_grid(p, scales[i % 9], offset);
        ask_on_lattice(p);
    }
    end_count("triangles of grids, moved and scaled by 1e-3 to 1e4", since);
}

/* ---- near misses ---------------------------------------------------------------------------------- */

static nook_point throw_point(float scale) {
    nook_point p;
    p.x = unit() * scale;
    p.y = unit() * scale;
    p.z = unit() * scale;
    return p;
}

/* A point of the plane of a triangle, or of the line of one of its edges, or a corner; rounded. */
static nook_point near_triangle(const nook_point *a) {
    uint32_t kind = throw_dice(&d, 4), i = throw_dice(&d, 3);
    float s = unit() * 0.7f + 0.5f, t = unit() * 0.7f + 0.5f;
    nook_point u = nook_sub(a[(i + 1) % 3], a[i]), v = nook_sub(a[(i + 2) % 3], a[i]);
    if (kind == 0) return a[i];
    u = nook_scaled(u, s);
    v = nook_scaled(v, kind == 1 ? 0 : t);
    return nook_make(a[i].x + u.x + v.x, a[i].y + u.y + v.y, a[i].z + u.z + v.z);
}

static float shaken(float x) {
    uint32_t bits = nook_float_bits(x), to = throw_dice(&d, 5);
    return to > 2 || (bits & 0x7FFFFFFFu) < 2 ? x : nook_float_from(bits + to - 1);
}

/* Thin ones too: all points near one line. */
static void throw_near_miss(nook_point *p, float scale) {
    uint32_t i;
    float flat = throw_dice(&d, 4) == 0 ? 1e-4f : 1.0f;
    for (i = 0; i < 3; i++) {
        p[i] = throw_point(scale);
        p[i].y = p[i].x * 0.3f + p[i].y * flat;
    }
    for (i = 3; i < 6; i++) p[i] = throw_dice(&d, 4) == 0 ? throw_point(scale) : near_triangle(p);
    for (i = 0; i < 6; i++) {
        p[i].x = shaken(p[i].x);
        p[i].y = shaken(p[i].y);
        p[i].z = shaken(p[i].z);
    }
}

static void near_misses_have_the_answers_of_integers(void) {
    static const float scales[] = {1e-3f, 1, 1e4f};
    uint32_t i, since = milliseconds();
    begin_count();
    for (i = 0; i < 1000000; i++) {
        nook_point p[6];
        throw_near_miss(p, scales[i % 3]);
        ask_on_lattice(p);
    }
    end_count("triangles upon or a last place beside one another", since);
}

/* ---- any floats ----------------------------------------------------------------------------------- */

static void any_finite_floats_have_the_answers_of_big_integers(void) {
    uint32_t i, j, k, since = milliseconds();
    begin_count();
    for (i = 0; i < 15000; i++) {
        nook_point p[8];
        throw_case(&d, p);
        throw_case(&d, p + 4);
        if (i % 3 != 0) { /* both of one kind, with what they have in common */
            for (j = 4; j < 6; j++) {
                k = throw_dice(&d, 4);
                p[j] = p[k];
                if (i % 3 == 2) p[j].x = shaken(p[j].x);
            }
        }
        ask(p, p + 3, big_triangles_meet(p, p + 3));
    }
    end_count("triangles of any finite floats", since);
}

/* What a line passes, and how it turns, with a direction that no float reaches as a point. */
static void a_direction_has_the_signs_of_big_integers(void) {
    static const nook_point zero = {0, 0, 0};
    uint32_t i, none = 0, since = milliseconds();
    begin_count();
    for (i = 0; i < 300000; i++) {
        nook_point p[8], q[6];
        uint32_t axis = i % 3;
        throw_case(&d, p);
        throw_case(&d, p + 4);
        if (i % 4 == 1) p[3] = nook_sub(p[0], p[1]);
        if (i % 4 == 2) p[3] = nook_sub(p[2], p[0]);
        if (i % 4 == 3) p[3] = p[5];
        if (nook_point_status(p[3]) == NOOK_NOT_FINITE) p[3] = p[0];
        q[0] = q[2] = p[0], q[1] = p[1], q[3] = p[2], q[4] = zero, q[5] = p[3];
        count.wrong += nook_passing(&p[0], &p[3], &p[1], &p[2]) != big_determinant(q);
        q[2] = zero, q[3] = p[3];
        q[5] = nook_make(axis == 0, axis == 1, axis == 2);
        count.wrong += nook_turning(&p[0], &p[1], &p[3], axis) != big_determinant(q);
        none += big_determinant(q) == 0;
    }
    CHECK_EQUAL(count.wrong, 0);
    CHECK(none > 10000);
    print_figure("signs of directions", i, "cases", since);
}

int main(void) {
    static const test tests[] = {
        TEST(two_triangles_of_a_grid_meet_if_a_mean_of_their_differences_is_0),
        TEST(two_triangles_of_a_mesh_intersect_as_defined_whatever_they_share),
        TEST(a_triangle_with_a_vertex_twice_intersects_nothing),
        TEST(moved_and_scaled_grids_have_the_same_answers_as_integers),
        TEST(near_misses_have_the_answers_of_integers),
        TEST(any_finite_floats_have_the_answers_of_big_integers),
        TEST(a_direction_has_the_signs_of_big_integers),
    };
    list_triples();
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
