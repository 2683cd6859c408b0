/* nearest.c -- how far a point, or a segment, is from the mesh.
 *
 * The truth of one triangle is found in long double as the least of all that it can be: between corners
 * and edges, edges and edges, corners and planes; and 0 if weights.h says that the two meet. The tree is
 * held against each triangle asked alone, to the bit, and what is known against the truth after every
 * number of units. */
#include "prove.h"
#include "solids.h"

#include "query/nook_closest.h"
#include "query/nook_inside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static dice d = {7u};
static uint32_t asked_of_each = 40; /* solid in each place, and kind */
static struct {
    uint32_t points, segments, meet, cuts, limits;
    uint32_t worst;  /* of distance, in 1e-9 of it, the triangle's size and the segment's length */
    uint32_t widest; /* of distance_max - distance_min, in 1e-9 of reach_of() */
} count;
static const char *running_solid;
static uint32_t running_variant;

static void note(uint32_t *worst, long double error, long double measure) {
    long double in_nano = measure > 0 ? error / measure * 1e9L : error > 0 ? 4e9L : 0;
    uint32_t n = in_nano > 4e9L ? 4000000000u : (uint32_t)in_nano;
    if (n > *worst) *worst = n;
}

/* ---- the truth ------------------------------------------------------------------------------------ */

typedef struct real {
    long double x, y, z;
} real;

static real real_of(nook_point p) {
    real r = {(long double)p.x, (long double)p.y, (long double)p.z};
    return r;
}

static real plus(real a, real b, long double s) {
    real r = {a.x + b.x * s, a.y + b.y * s, a.z + b.z * s};
    return r;
}
static real less(real a, real b) { return plus(a, b, -1); }
static long double dot(real a, real b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static long double length(real a) { return sqrtl(dot(a, a)); }
static real cross(real a, real b) {
    real r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}
static long double lesser(long double a, long double b) { return a < b ? a : b; }

static long double point_to_segment(real p, real a, real b) {
    real u = less(b, a), v = less(p, a);
    long double s = dot(u, u) > 0 ? dot(u, v) / dot(u, u) : 0;
    return length(less(v, plus(less(a, a), u, s < 0 ? 0 : s > 1 ? 1 : s)));
}

static long double segment_to_segment(real a, real b, real p, real q) {
    real u = less(b, a), v = less(q, p), w = less(p, a), n = cross(u, v);
    long double least = lesser(point_to_segment(a, p, q), point_to_segment(b, p, q)), s, t, nn = dot(n, n);
    least = lesser(least, lesser(point_to_segment(p, a, b), point_to_segment(q, a, b)));
    if (!(nn > 0)) return least;
    s = dot(cross(w, v), n) / nn;
    t = dot(cross(w, u), n) / nn;
    return s < 0 || s > 1 || t < 0 || t > 1 ? least : lesser(least, fabsl(dot(w, n)) / sqrtl(nn));
}

/* The plane counts where the foot is on the inner side of all edges. */
static long double point_to_triangle(real p, const real *c) {
    real n = cross(less(c[1], c[0]), less(c[2], c[0]));
    long double least = HUGE_VALL;
    bool within = dot(n, n) > 0;
    uint32_t i;
    for (i = 0; i < 3; i++) {
        real a = c[i], b = c[(i + 1) % 3];
        least = lesser(least, point_to_segment(p, a, b));
        within = within && dot(cross(less(b, a), less(p, a)), n) >= 0;
    }
    return within ? lesser(least, fabsl(dot(less(p, c[0]), n)) / length(n)) : least;
}

/* What bounds are measured by: the mesh, the way to it, and the segment. */
static long double reach_of(const nook_bvh *bvh, long double truth, real a, real b) {
    real low = {HUGE_VALL, HUGE_VALL, HUGE_VALL}, high = {-HUGE_VALL, -HUGE_VALL, -HUGE_VALL};
    uint32_t c;
    for (c = 0; c < 3 * bvh->view.nt; c++) {
        real p = real_of(bvh->view.G[bvh->view.V[c]]);
        low.x = lesser(low.x, p.x), low.y = lesser(low.y, p.y), low.z = lesser(low.z, p.z);
        high.x = -lesser(-high.x, -p.x), high.y = -lesser(-high.y, -p.y), high.z = -lesser(-high.z, -p.z);
    }
    return length(less(high, low)) + truth + length(less(b, a)) + 1e-24L; /* a point upon a point */
}

typedef struct question {
    nook_point a, b;
    real ra, rb;
    vector at[2];
} question;
static question asked;

static bool is_point(void) { return memcmp(&asked.at[0], &asked.at[1], sizeof asked.at[0]) == 0; }

static long double true_distance(uint32_t t) {
    real c[3];
    vector p[3];
    long double least;
    uint32_t i;
    for (i = 0; i < 3; i++) c[i] = real_of(here.G[here.V[3 * t + i]]);
    least = lesser(point_to_triangle(asked.ra, c), point_to_triangle(asked.rb, c));
    if (is_point()) return least;
    for (i = 0; i < 3; i++)
        least = lesser(least, segment_to_segment(asked.ra, asked.rb, c[i], c[(i + 1) % 3]));
    take_triangle(t, p);
    return hulls_meet(p, 3, asked.at, 2) ? 0 : least;
}

static long double size_of(uint32_t t) {
    real c[3];
    uint32_t i;
    for (i = 0; i < 3; i++) c[i] = real_of(here.G[here.V[3 * t + i]]);
    return length(less(c[1], c[0])) + length(less(c[2], c[1]));
}

/* ---- the answer ----------------------------------------------------------------------------------- */

static struct {
    long double truth[MOST_NT], least;
    nook_closest alone[MOST_NT]; /* of each triangle */
    uint32_t nearest; /* the first of those that say they are; of equal distances the squares may differ */
    nook_closest whole;
    uint32_t used;
} found;

static bool same_bits(float a, float b) { return nook_float_bits(a) == nook_float_bits(b); }

static void failed_at(const char *what) {
    (void)printf("%s: %s, variant %u: {%a, %a, %a} {%a, %a, %a}\n", what, running_solid,
                 (unsigned)running_variant, (double)asked.a.x, (double)asked.a.y, (double)asked.a.z,
                 (double)asked.b.x, (double)asked.b.y, (double)asked.b.z);
}

static nook_status answer(nook_closest *c, const nook_bvh *bvh, float limit, float enough, uint32_t *units) {
    CHECK_EQUAL(nook_closest_begin(c, bvh, asked.a, asked.b, limit, enough), NOOK_OK);
    return nook_closest_step(c, units);
}

/* What is known holds the truth, of the whole mesh or of one triangle; long double itself may be off by a
 * little. */
static void holds(const nook_closest *c, long double truth) {
    long double little = truth * 1e-15L;
    if (!CHECK((long double)c->distance_min <= truth + little)) failed_at("distance_min");
    if (!CHECK((long double)c->distance_max >= truth - little)) failed_at("distance_max");
    CHECK(c->distance_min >= 0 && c->distance_min <= c->distance_max);
    CHECK(c->triangle == NOOK_NONE || c->triangle < here.view.nt);
}

static void note_width(const nook_closest *c, const nook_bvh *bvh, long double truth) {
    note(&count.widest, (long double)c->distance_max - (long double)c->distance_min,
         reach_of(bvh, truth, asked.ra, asked.rb));
}

static void ask_alone(uint32_t t) {
    nook_closest c;
    uint32_t units = 1000;
    long double size = size_of(t), truth = true_distance(t);
    found.truth[t] = truth;
    found.least = t == 0 ? truth : lesser(truth, found.least);
    CHECK_EQUAL(answer(&c, &here.alone[t], NOOK_FAR, 0, &units), NOOK_OK);
    CHECK_EQUAL(c.triangle, 0);
    holds(&c, truth);
    note(&count.worst, fabsl((long double)c.distance - truth),
         truth + size + length(less(asked.rb, asked.ra)));
    note_width(&c, &here.alone[t], truth);
    found.alone[t] = c;
    if (t != 0 && !(c.distance < found.alone[found.nearest].distance)) return;
    found.nearest = t;
}

/* The two nearest points are where they should be: on the segment, on the triangle, as far apart as is
 * said. */
static void check_witness(const nook_closest *c) {
    question keep = asked;
    nook_point on = c->point;
    real r = real_of(on), q = plus(asked.ra, less(asked.rb, asked.ra), (long double)c->at);
    long double size = size_of(c->triangle), span = length(asked.ra) + length(asked.rb) + length(r);
    long double few = c->distance == 0
                          ? 5e-5L
                          : 4e-6L; /* thin triangles are passed through at a place that is not well known */
    CHECK(c->at >= 0 && c->at <= 1);
    if (!CHECK(fabsl(length(less(r, q)) - (long double)c->distance) <=
               few * (size + (long double)c->distance) + 2e-7L * span)) {
        failed_at("witness");
    }
    asked.a = asked.b = on;
    asked.ra = asked.rb = r;
    asked.at[1] = asked.at[0];
    if (!CHECK(true_distance(c->triangle) <= 1e-5L * (size + (long double)c->distance) + 2e-7L * span))
        failed_at("point");
    asked = keep;
}

static void same_witness(const nook_closest *a, const nook_closest *b) {
    CHECK(same_bits(a->distance, b->distance));
    CHECK(memcmp(&a->point, &b->point, sizeof a->point) == 0 && same_bits(a->at, b->at));
}

static void same_answer(const nook_closest *a, const nook_closest *b) {
    CHECK_EQUAL(a->triangle, b->triangle);
    CHECK(same_bits(a->distance_min, b->distance_min) && same_bits(a->distance_max, b->distance_max));
    same_witness(a, b);
}

static void check_whole(void) {
    uint32_t units = UINT32_MAX;
    const nook_closest *c = &found.whole;
    CHECK_EQUAL(answer(&found.whole, &here.bvh, NOOK_FAR, 0, &units), NOOK_OK);
    found.used = UINT32_MAX - units;
    CHECK(found.used <= here.view.nt * 134 / 100 + 10);
    holds(c, found.least);
    if (!CHECK(c->triangle < here.view.nt)) return;
    if (!CHECK(same_bits(c->distance, found.alone[found.nearest].distance))) failed_at("distance");
    if (!CHECK(c->triangle >= found.nearest)) failed_at("nearest");
    same_witness(c, &found.alone[c->triangle]);
    if (c->distance == 0 && !CHECK_EQUAL(c->triangle, found.nearest))
        failed_at("nearest of those that touch");
    check_witness(c);
    note_width(c, &here.bvh, found.least);
}

/* ---- budgets -------------------------------------------------------------------------------------- */

/* The triangle that is named is no farther than the upper bound. */
static void check_cut(const nook_closest *c) {
    count.cuts++;
    holds(c, found.least);
    if (c->triangle == NOOK_NONE || c->triangle >= here.view.nt) return;
    CHECK(found.truth[c->triangle] <= (long double)c->distance_max * (1 + 1e-15L));
    CHECK(c->distance_max >= found.whole.distance_min);
}

static void check_budgets(void) {
    nook_closest c;
    nook_status status = NOOK_MORE;
    uint32_t units, k;
    (void)nook_closest_begin(&c, &here.bvh, asked.a, asked.b, NOOK_FAR, 0);
    check_cut(&c);
    for (k = 0; status == NOOK_MORE && k <= found.used + 1; k++) {
        units = 1;
        status = nook_closest_step(&c, &units);
        check_cut(&c);
    }
    CHECK_EQUAL(status, NOOK_OK);
    same_answer(&c, &found.whole);
    for (k = 0; k <= found.used; k += 1 + k / 8) {
        units = k;
        status = answer(&c, &here.bvh, NOOK_FAR, 0, &units);
        CHECK(status == NOOK_MORE || status == NOOK_OK);
        CHECK(units <= k && (status == NOOK_OK || units == 0));
        check_cut(&c);
        if (status == NOOK_OK) same_answer(&c, &found.whole);
    }
}

/* ---- limit and enough ----------------------------------------------------------------------------- */

static void check_limit(float limit) {
    nook_closest c;
    uint32_t units = UINT32_MAX;
    long double l = (long double)limit, slack = 3e-6L * reach_of(&here.bvh, found.least, asked.ra, asked.rb);
    CHECK_EQUAL(answer(&c, &here.bvh, limit, 0, &units), NOOK_OK);
    count.limits++;
    if (c.triangle != NOOK_NONE) {
        same_answer(&c, &found.whole);
        CHECK(found.least <= l + slack);
        return;
    }
    if (!CHECK(found.least >= l - slack)) failed_at("limit");
    CHECK((long double)c.distance_min <= found.least &&
          (long double)c.distance_min >= l * (1 - 1e-5L) - slack);
    CHECK((long double)c.distance_max >= found.least);
}

static void check_enough(float enough) {
    nook_closest c;
    uint32_t units = UINT32_MAX;
    long double e = (long double)enough;
    CHECK_EQUAL(answer(&c, &here.bvh, NOOK_FAR, enough, &units), NOOK_OK);
    CHECK(UINT32_MAX - units <= found.used);
    count.limits++;
    holds(&c, found.least);
    if (!CHECK(c.triangle < here.view.nt)) return;
    CHECK(found.truth[c.triangle] <= (long double)c.distance_max * (1 + 1e-15L));
    if (c.distance > enough) same_answer(&c, &found.whole);
    if (found.least < e - 3e-6L * reach_of(&here.bvh, found.least, asked.ra, asked.rb))
        CHECK(c.distance <= enough);
}

static void check_limits(void) {
    static const float by[] = {0.25f, 0.9f, 0.99999f, 1, 1.00001f, 1.1f, 5};
    uint32_t i;
    float distance = found.whole.distance;
    for (i = 0; i < sizeof by / sizeof *by; i++) {
        check_limit(distance * by[i]);
        check_enough(distance * by[i]);
    }
    check_limit(distance + here.size);
    check_enough(distance + here.size);
    check_limit(found.whole.distance_max);
}

/* ---- questions ------------------------------------------------------------------------------------ */

/* The same with a sign, from where the point is. */
static void check_signed(void) {
    nook_closest c;
    int side;
    CHECK_EQUAL(nook_signed_distance(&c, &here.bvh, asked.a), NOOK_OK);
    CHECK_EQUAL(nook_side_of(&here.bvh, asked.a, &side), NOOK_OK);
    CHECK_EQUAL(c.triangle, found.whole.triangle);
    if (side == 0) {
        CHECK(c.distance == 0 || !here.closed);
        return;
    }
    if (!CHECK(c.distance == (side < 0 ? -found.whole.distance : found.whole.distance))) failed_at("signed");
}

static void ask(nook_point a, nook_point b) {
    uint32_t t;
    asked.a = to_lattice(here.lattice, a);
    asked.b = to_lattice(here.lattice, b);
    asked.ra = real_of(asked.a);
    asked.rb = real_of(asked.b);
    asked.at[0] = take_point(here.lattice, asked.a);
    asked.at[1] = take_point(here.lattice, asked.b);
    for (t = 0; t < here.view.nt; t++) ask_alone(t);
    check_whole();
    if (is_point()) {
        nook_closest c;
        CHECK_EQUAL(nook_closest_point(&c, &here.bvh, asked.a), NOOK_OK);
        same_answer(&c, &found.whole);
        check_signed();
        count.points++;
    } else {
        count.segments++;
        count.meet += found.least == 0;
    }
    if ((count.points + count.segments) % 4 == 0) check_budgets();
    if ((count.points + count.segments) % 4 == 1) check_limits();
}

static nook_point throw_place(float reach) {
    nook_point p, q = here.G[throw_dice(&d, here.view.nv)];
    p.x = q.x + throw_unit(&d) * reach;
    p.y = q.y + throw_unit(&d) * reach;
    p.z = q.z + throw_unit(&d) * reach;
    return p;
}

static nook_point throw_target(void) {
    uint32_t kind = throw_dice(&d, 4), t = throw_dice(&d, here.view.nt), k = throw_dice(&d, 3);
    nook_point a = here.G[here.V[3 * t + k]], b = here.G[here.V[3 * t + (k + 1) % 3]];
    if (kind == 0) return a;
    if (kind == 1) return between(a, b, 0.5f);
    return kind == 2 ? centre_of(t) : between(a, centre_of(t), 3.0f);
}

/* On the surface, close to it, away from it, far away, and where many triangles are equally near. */
static void ask_points(void) {
    static const float reach[] = {0, 1e-5f, 1e-3f, 0.1f, 1, 30};
    uint32_t i;
    for (i = 0; i < asked_of_each; i++) {
        nook_point p = throw_target(), q = throw_place(reach[i % 6] * here.size);
        ask(p, p);
        ask(q, q);
    }
}

/* Of all lengths, through the surface, along edges and axes, and of no length but far apart in name. */
static void ask_segments(void) {
    static const float reach[] = {1e-3f, 0.1f, 1};
    uint32_t i;
    for (i = 0; i < asked_of_each; i++) {
        nook_point p = throw_place(reach[i % 3] * here.size), q = throw_place(reach[i / 3 % 3] * here.size),
                   r = throw_target();
        nook_point s = throw_target();
        ask(p, q);
        ask(p, r);
        ask(r, s);
        ask(p, nook_make(p.x, p.y, q.z));
        ask(between(r, s, -1), between(r, s, -3));
        ask(p, nook_make(p.x + 1e-3f * (q.x - p.x), p.y, p.z));
    }
}

static void of_each(void (*ask_all)(void)) {
    uint32_t s;
    for (s = 0; s < solid_count; s++) {
        running_solid = solids[s].name;
        for (running_variant = 0; running_variant < variant_count && !test_has_failed(); running_variant++) {
            make_solid(&solids[s], &variants[running_variant]);
            build_trees();
            ask_all();
            drop_world();
        }
    }
}

static void print_worst(void) {
    (void)printf("  off by at most %u nano of it, the triangle and the segment; bounds apart by %u of the "
                 "mesh, the way and the segment\n",
                 (unsigned)count.worst, (unsigned)count.widest);
    CHECK(count.worst < 2000);
    CHECK(count.widest < 2500);
}

static void the_nearest_to_a_point_is_what_each_triangle_says_and_true(void) {
    uint32_t since = milliseconds();
    of_each(ask_points);
    print_figure("points on, near and far from surfaces", count.points, "points", since);
    print_worst();
}

static void the_nearest_to_a_segment_is_what_each_triangle_says_and_true(void) {
    uint32_t since = milliseconds();
    of_each(ask_segments);
    print_figure("segments", count.segments, "segments", since);
    (void)printf("  %u meet the surface; %u cuts, %u limits\n", (unsigned)count.meet, (unsigned)count.cuts,
                 (unsigned)count.limits);
    CHECK(count.meet > count.segments / 10 && count.meet < count.segments / 10 * 9);
    print_worst();
}

int main(int argc, char **argv) {
    static const test tests[] = {
        TEST(the_nearest_to_a_point_is_what_each_triangle_says_and_true),
        TEST(the_nearest_to_a_segment_is_what_each_triangle_says_and_true),
    };
    if (argc > 1 && strcmp(argv[1], "small") == 0) asked_of_each = 12;
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
