/* queries.c -- rays and points: what they hit, and whether they are inside.
 *
 * Two oracles. What is hit, and what a point lies on, is decided in integers by weights.h for each
 * triangle. Where it is hit is asked of each triangle alone, as a mesh of one, and held against the exact
 * quotient: so a tree must give what its triangles give, to the bit, and each triangle what is true.
 * Inside is the winding number along lines that pass no edge and no vertex, in integers. */
#include "prove.h"
#include "solids.h"

#include "query/nook_inside.h"
#include "query/nook_ray.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static dice d = {99u};
static uint32_t targets = 120; /* of each kind, of each solid in each place */
static struct {
    uint32_t rays, hits, through_borders, points, inside, on;
    uint32_t worst_t, worst_range, worst_w, worst_w_sum,
        worst_winding; /* in 1e-9 of what they are measured by */
} count;
static const char *running_solid;
static uint32_t running_variant;

static void failed_at(const char *what) {
    (void)printf("%s: %s, variant %u\n", what, running_solid, (unsigned)running_variant);
}

static void note(uint32_t *worst, long double error, long double measure) {
    long double in_nano = measure > 0 ? error / measure * 1e9L : error > 0 ? 4e9L : 0;
    uint32_t n = in_nano > 4e9L ? 4000000000u : (uint32_t)in_nano;
    if (n > *worst) *worst = n;
}

/* ---- the ray being asked -------------------------------------------------------------------------- */

static struct {
    nook_point origin, direction;
    vector o, d; /* d on a lattice of its own */
    lattice of_d;
    bool meets[MOST_NT];
    float t[MOST_NT]; /* by the triangle alone */
    uint32_t met, nearest;
    float least;
} ray;

static long double power(int place) { return ldexpl(1.0L, place); }

/* Integer products in long double: 64 bits of a sum that is exact up to 2^63 and good to 2^-60 above it. */
static long double dot(const vector *a, const vector *b) {
    return (long double)a->at[0] * (long double)b->at[0] + (long double)a->at[1] * (long double)b->at[1] +
           (long double)a->at[2] * (long double)b->at[2];
}

typedef struct real {
    long double at[3];
} real;

static real cross(const vector *a, const vector *b) {
    real c;
    uint32_t i;
    for (i = 0; i < 3; i++) {
        uint32_t u = (i + 1) % 3, v = (i + 2) % 3;
        c.at[i] =
            (long double)a->at[u] * (long double)b->at[v] - (long double)a->at[v] * (long double)b->at[u];
    }
    return c;
}

static long double dot_real(const real *a, const vector *b) {
    return a->at[0] * (long double)b->at[0] + a->at[1] * (long double)b->at[1] +
           a->at[2] * (long double)b->at[2];
}

/* Where a triangle is hit is within the range of its corners, and where the planes say unless they are
 * nearly parallel. */
static void check_t(uint32_t t, float got) {
    vector p[3], a[3], u, v;
    real n;
    long double low = HUGE_VALL, high = -HUGE_VALL, unit = power(here.lattice.place - ray.of_d.place), size,
                slope;
    long double length = sqrtl(dot(&ray.d, &ray.d)), value = (long double)got / unit;
    uint32_t i;
    take_triangle(t, p);
    for (i = 0; i < 3; i++) {
        long double at;
        a[i] = minus(&p[i], &ray.o);
        at = dot(&a[i], &ray.d) / length / length;
        low = at < low ? at : low;
        high = at > high ? at : high;
    }
    u = minus(&p[1], &p[0]), v = minus(&p[2], &p[0]);
    n = cross(&u, &v);
    size = (sqrtl(dot(&u, &u)) + sqrtl(dot(&v, &v))) / length;
    note(&count.worst_range,
         value < low    ? low - value
         : value > high ? value - high
                        : 0,
         size + fabsl(value));
    slope = fabsl(dot_real(&n, &ray.d)) / length /
            sqrtl(n.at[0] * n.at[0] + n.at[1] * n.at[1] + n.at[2] * n.at[2]);
    if (!(slope > 1e-4L)) return;
    note(&count.worst_t, fabsl(value - dot_real(&n, &a[0]) / dot_real(&n, &ray.d)) * slope,
         size + fabsl(value));
}

static void ask_alone(uint32_t t) {
    vector p[3];
    nook_ray r;
    take_triangle(t, p);
    ray.meets[t] = ray_meets(&ray.o, &ray.d, p);
    CHECK_EQUAL(nook_ray_cast(&r, &here.alone[t], ray.origin, ray.direction, NOOK_MAX_T, NOOK_NEAREST),
                NOOK_OK);
    if (!CHECK_EQUAL(r.triangle, ray.meets[t] ? 0 : NOOK_NONE)) failed_at("one triangle, ray");
    if (!ray.meets[t]) return;
    ray.met++;
    ray.t[t] = r.t;
    check_t(t, r.t);
    if (ray.nearest == NOOK_NONE || r.t < ray.least) {
        ray.nearest = t;
        ray.least = r.t;
    }
}

static bool same_bits(float a, float b) { return nook_float_bits(a) == nook_float_bits(b); }

/* Without area, or with so little that the places of its corners decide nothing. */
static bool is_a_sliver(uint32_t t) {
    vector p[3], u, v;
    real n;
    take_triangle(t, p);
    u = minus(&p[1], &p[0]), v = minus(&p[2], &p[0]);
    n = cross(&u, &v);
    return n.at[0] * n.at[0] + n.at[1] * n.at[1] + n.at[2] * n.at[2] <= 1e-10L * dot(&u, &u) * dot(&v, &v);
}

/* The weights name the point that is hit. */
static void check_weights(const nook_ray *r) {
    const nook_index *V = here.V + 3 * r->triangle;
    long double error = 0, size = 0, w_sum = 0;
    uint32_t i, axis;
    float w[3];
    nook_ray_weights(r, w);
    for (axis = 0; axis < 3; axis++) {
        const float *o = &ray.origin.x + axis, *to = &ray.direction.x + axis;
        long double at = (long double)r->t * (long double)*to;
        for (i = 0; i < 3; i++) {
            long double p = (long double)*(&here.G[V[i]].x + axis) - (long double)*o;
            at -= (long double)w[i] * p;
            size += fabsl(p);
        }
        error += fabsl(at);
    }
    for (i = 0; i < 3; i++) {
        w_sum += (long double)w[i];
        if (w[i] < 0) note(&count.worst_w_sum, -(long double)w[i], 1);
    }
    note(&count.worst_w_sum, fabsl(w_sum - 1), 1);
    if (!is_a_sliver(r->triangle)) note(&count.worst_w, error, size);
}

static void check_nearest(void) {
    nook_ray r;
    CHECK_EQUAL(nook_ray_cast(&r, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, NOOK_NEAREST), NOOK_OK);
    if (!CHECK_EQUAL(r.triangle, ray.nearest)) failed_at("nearest");
    if (ray.nearest == NOOK_NONE || r.triangle != ray.nearest) return;
    CHECK(same_bits(r.t, ray.least));
    CHECK(same_bits(r.t_min, r.t));
    check_weights(&r);
    CHECK_EQUAL(nook_ray_cast(&r, &here.bvh, ray.origin, ray.direction, r.t, NOOK_NEAREST), NOOK_OK);
    CHECK(r.triangle == ray.nearest && same_bits(r.t, ray.least));
    if (ray.least == 0) return;
    CHECK_EQUAL(nook_ray_cast(&r, &here.bvh, ray.origin, ray.direction,
                              nook_float_from(nook_float_bits(ray.least) - 1), NOOK_NEAREST),
                NOOK_OK);
    CHECK_EQUAL(r.triangle, NOOK_NONE);
}

static void check_any(void) {
    nook_ray r;
    CHECK_EQUAL(nook_ray_cast(&r, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, NOOK_ANY), NOOK_OK);
    CHECK_EQUAL(r.triangle != NOOK_NONE, ray.met != 0);
    if (r.triangle == NOOK_NONE) return;
    CHECK(r.triangle < here.view.nt && ray.meets[r.triangle] && same_bits(r.t, ray.t[r.triangle]));
}

/* ---- inside, in integers -------------------------------------------------------------------------- */

/* +1, -1: the line from p along to leaves or enters the triangle in its inner part; 0: it passes it; 2: it
 * meets the line of an edge, or runs in the triangle's plane. p is not on the triangle. */
static int crossing(const vector *p, const vector *to, const vector triangle[3]) {
    vector a[3];
    int side[3], above;
    uint32_t i;
    for (i = 0; i < 3; i++) a[i] = minus(&triangle[i], p);
    above = sign_of(&a[0], &a[1], &a[2]);
    if (above == 0) {
        vector u = minus(&a[1], &a[0]), v = minus(&a[2], &a[0]);
        return sign_of(&u, &v, to) != 0 || has_no_area(a) ? 0 : 2;
    }
    for (i = 0; i < 3; i++) side[i] = sign_of(&a[i], &a[(i + 1) % 3], to);
    if (side[0] == 0 || side[1] == 0 || side[2] == 0) return 2;
    if (side[0] != side[1] || side[1] != side[2]) return 0;
    return above * side[0] > 0 ? side[0] : 0;
}

/* How often the surface winds around a point that is not on it. */
static int32_t winding_of(const vector *p) {
    dice own = {17u};
    for (;;) {
        vector to, q[3];
        int32_t winding = 0;
        int step = 0;
        uint32_t t, i;
        for (i = 0; i < 3; i++) to.at[i] = (int64_t)throw_dice(&own, 20001) - 10000;
        for (t = 0; t < here.view.nt && step != 2; t++) {
            take_triangle(t, q);
            step = crossing(p, &to, q);
            winding += step;
        }
        if (step != 2) return winding;
    }
}

static bool lies_on(const vector *p, uint32_t t) {
    vector q[3], a[3];
    uint32_t i;
    take_triangle(t, q);
    if (has_no_area(q)) return false;
    for (i = 0; i < 3; i++) a[i] = minus(&q[i], p);
    return mean_of_vectors(a, 3);
}

/* The first triangle that the point is on, if any. */
static uint32_t triangle_under(const vector *p) {
    uint32_t t;
    for (t = 0; t < here.view.nt; t++) {
        if (lies_on(p, t)) return t;
    }
    return NOOK_NONE;
}

/* ---- crossings ------------------------------------------------------------------------------------ */

/* Those of the mesh are those of its triangles; of a triangle that is met, none or one, and of others
 * none. */
static void check_crossings(void) {
    nook_ray r, one;
    uint32_t t, crossings = 0;
    int32_t winding = 0;
    for (t = 0; t < here.view.nt; t++) {
        CHECK_EQUAL(
            nook_ray_cast(&one, &here.alone[t], ray.origin, ray.direction, NOOK_MAX_T, NOOK_CROSSINGS),
            NOOK_OK);
        CHECK(one.crossings <= (ray.meets[t] ? 1u : 0u));
        CHECK(one.winding == (int32_t)one.crossings || one.winding == -(int32_t)one.crossings);
        crossings += one.crossings;
        winding += one.winding;
    }
    CHECK_EQUAL(nook_ray_cast(&r, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, NOOK_CROSSINGS), NOOK_OK);
    CHECK_EQUAL(r.crossings, crossings);
    CHECK_EQUAL(r.winding, winding);
    if (!here.closed || triangle_under(&ray.o) != NOOK_NONE) return;
    winding = winding_of(&ray.o);
    if (!CHECK_EQUAL(r.winding, winding)) failed_at("winding of a ray");
    CHECK_EQUAL(r.crossings & 1u, (uint32_t)winding & 1u);
    if (winding != 0) CHECK(ray.met > 0); /* nothing slips out */
}

/* ---- budgets -------------------------------------------------------------------------------------- */

static void same_ray(const nook_ray *a, const nook_ray *b) {
    float v[3], w[3];
    nook_ray_weights(a, v);
    nook_ray_weights(b, w);
    CHECK_EQUAL(a->triangle, b->triangle);
    CHECK(same_bits(a->t, b->t) && same_bits(a->t_min, b->t_min));
    CHECK_EQUAL(a->crossings, b->crossings);
    CHECK_EQUAL(a->winding, b->winding);
    CHECK(memcmp(v, w, sizeof v) == 0);
}

/* What is known after any number of units does not contradict the answer. */
static void check_cut(const nook_ray *r, const nook_ray *whole) {
    CHECK(r->t_min >= 0 && r->t_min <= whole->t);
    CHECK(r->t >= whole->t);
    if (r->triangle == NOOK_NONE) return;
    CHECK(r->triangle < here.view.nt && ray.meets[r->triangle]);
    CHECK(same_bits(r->t, ray.t[r->triangle]));
}

static void check_budgets(nook_ray_kind kind) {
    nook_ray whole, sliced, cut;
    uint32_t units = UINT32_MAX, used, k;
    nook_status status = NOOK_MORE;
    (void)nook_ray_begin(&whole, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, kind);
    CHECK_EQUAL(nook_ray_step(&whole, &units), NOOK_OK);
    used = UINT32_MAX - units;
    CHECK(used <= here.view.nt * 134 / 100 + 10);
    (void)nook_ray_begin(&sliced, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, kind);
    for (k = 0; status == NOOK_MORE && k <= used + 1; k++) {
        units = 1;
        status = nook_ray_step(&sliced, &units);
        if (kind == NOOK_NEAREST) check_cut(&sliced, &whole);
    }
    CHECK_EQUAL(status, NOOK_OK);
    same_ray(&sliced, &whole);
    for (k = 0; k <= used; k += 1 + k / 8) {
        (void)nook_ray_begin(&cut, &here.bvh, ray.origin, ray.direction, NOOK_MAX_T, kind);
        if (kind == NOOK_NEAREST) check_cut(&cut, &whole);
        units = k;
        status = nook_ray_step(&cut, &units);
        CHECK(status == NOOK_MORE || status == NOOK_OK);
        CHECK(units <= k && (status == NOOK_OK || units == 0));
        if (k == 0) CHECK_EQUAL(status, NOOK_MORE);
        if (kind == NOOK_NEAREST) check_cut(&cut, &whole);
        if (status == NOOK_OK) same_ray(&cut, &whole);
    }
}

/* ---- rays ----------------------------------------------------------------------------------------- */

static bool is_zero(nook_point p) { return p.x == 0 && p.y == 0 && p.z == 0; }

static void ask_ray(nook_point origin, nook_point direction) {
    uint32_t t;
    if (is_zero(direction)) return;
    ray.of_d = lattice_of(&direction, 1);
    ray.origin = to_lattice(here.lattice, origin);
    ray.direction = to_lattice(ray.of_d, direction);
    ray.o = take_point(here.lattice, ray.origin);
    ray.d = take_point(ray.of_d, ray.direction);
    ray.met = 0;
    ray.nearest = NOOK_NONE;
    for (t = 0; t < here.view.nt; t++) ask_alone(t);
    count.rays++;
    count.hits += ray.met > 0;
    count.through_borders += ray.met > 1;
    check_nearest();
    check_any();
    check_crossings();
    if (count.rays % 8 == 0) check_budgets(NOOK_NEAREST);
    if (count.rays % 32 == 1) check_budgets(NOOK_CROSSINGS);
    if (count.rays % 32 == 2) check_budgets(NOOK_ANY);
}

static nook_point throw_place(float reach) {
    nook_point p, q = here.G[throw_dice(&d, here.view.nv)];
    p.x = q.x + throw_unit(&d) * reach;
    p.y = q.y + throw_unit(&d) * reach;
    p.z = q.z + throw_unit(&d) * reach;
    return p;
}

/* A vertex, a midpoint of an edge, a centre, a point of a triangle's plane beyond it. */
static nook_point throw_target(void) {
    uint32_t kind = throw_dice(&d, 8), t = throw_dice(&d, here.view.nt), k = throw_dice(&d, 3);
    nook_point a = here.G[here.V[3 * t + k]], b = here.G[here.V[3 * t + (k + 1) % 3]];
    if (kind < 3) return a;
    if (kind < 6) return between(a, b, 0.5f);
    return kind == 6 ? centre_of(t) : between(a, centre_of(t), 3.0f);
}

/* From a place through what is on the surface. */
static void through_targets(void) {
    uint32_t i;
    for (i = 0; i < targets; i++) {
        nook_point target = throw_target(), from = throw_place(here.size * (i % 3 == 0 ? 0.1f : 1.0f));
        if (i % 4 == 1) from = throw_target();
        from = to_lattice(here.lattice, from);
        ask_ray(from, nook_sub(target, from));
        if (i % 4 == 0) ask_ray(target, nook_sub(from, target));
    }
}

/* Along the axes, exactly through what is on the surface, from outside, from it and through all of it. */
static void along_axes(void) {
    uint32_t i;
    for (i = 0; i < targets; i++) {
        uint32_t axis = throw_dice(&d, 3);
        nook_point target = throw_target(), way = {0, 0, 0};
        float back = i % 3 == 0 ? 0 : i % 3 == 1 ? 2.0f : 0.125f;
        *(&way.x + axis) = throw_dice(&d, 2) ? 1.0f : -1.0f;
        ask_ray(nook_sub(target, nook_scaled(way, back * here.size)), way);
    }
}

/* Along edges, from before one, from its ends, from within it. */
static void along_edges(void) {
    static const float from[] = {0, 2, -1, 0.5f, 1, 3};
    uint32_t i;
    for (i = 0; i < targets; i++) {
        uint32_t t = throw_dice(&d, here.view.nt), k = throw_dice(&d, 3);
        nook_point a = here.G[here.V[3 * t + k]], b = here.G[here.V[3 * t + (k + 1) % 3]];
        ask_ray(between(a, b, from[i % 6]), nook_sub(b, a));
    }
}

/* In the plane of a triangle, from outside it and from within. */
static void along_faces(void) {
    uint32_t i;
    for (i = 0; i < targets; i++) {
        uint32_t t = throw_dice(&d, here.view.nt), k = throw_dice(&d, 3);
        nook_point a = here.G[here.V[3 * t + k]], b = here.G[here.V[3 * t + (k + 1) % 3]];
        nook_point c = here.G[here.V[3 * t + (k + 2) % 3]], m = between(b, c, 0.5f);
        if (i % 3 == 0) ask_ray(between(a, m, 2), nook_sub(m, a));
        if (i % 3 == 1) ask_ray(centre_of(t), nook_sub(m, c));
        if (i % 3 == 2) ask_ray(between(a, b, 3), nook_sub(m, between(a, b, 3)));
    }
}

/* From as far as a thousand times the size. */
static void from_afar(void) {
    uint32_t i;
    for (i = 0; i < targets / 2; i++) {
        nook_point target = throw_target(), from;
        float reach = i % 3 == 0 ? 1000.0f : i % 3 == 1 ? 100.0f : 30.0f;
        if (here.size * reach > NOOK_MAX_COORDINATE * 0.5f) continue;
        from = to_lattice(here.lattice, throw_place(here.size * reach));
        ask_ray(from, nook_sub(target, from));
    }
}

/* Directions of any length. */
static void of_any_length(void) {
    uint32_t i;
    for (i = 0; i < targets / 4; i++) {
        nook_point target = throw_target(), from = to_lattice(here.lattice, throw_place(here.size));
        float s = nook_power_of_two(i % 2 ? 127 + 60 - throw_dice(&d, 8) : 127 - 60 + throw_dice(&d, 8));
        ask_ray(from, nook_scaled(nook_sub(target, from), s));
    }
}

/* ---- points --------------------------------------------------------------------------------------- */

static void check_sliced_inside(const nook_inside *whole, nook_point p) {
    nook_inside sliced;
    nook_status status = NOOK_MORE;
    uint32_t k, units;
    CHECK_EQUAL(nook_inside_begin(&sliced, &here.bvh, p), NOOK_OK);
    for (k = 0; status == NOOK_MORE && k < 2 * here.view.nt + 20; k++) {
        units = 1;
        status = nook_inside_step(&sliced, &units);
    }
    CHECK_EQUAL(status, NOOK_OK);
    CHECK_EQUAL(sliced.on, whole->on);
    CHECK_EQUAL(sliced.crossings, whole->crossings);
    CHECK_EQUAL(sliced.winding, whole->winding);
}

static void check_side(nook_point p, const nook_inside *inside) {
    int side;
    CHECK_EQUAL(nook_side_of(&here.bvh, p, &side), NOOK_OK);
    CHECK_EQUAL(side, nook_inside_side(inside));
}

static void ask_point(nook_point point) {
    nook_point p = to_lattice(here.lattice, point);
    vector v = take_point(here.lattice, p);
    uint32_t under = triangle_under(&v), units = UINT32_MAX;
    nook_inside inside;
    CHECK_EQUAL(nook_inside_begin(&inside, &here.bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&inside, &units), NOOK_OK);
    CHECK(UINT32_MAX - units <= here.view.nt * 134 / 100 + 10);
    if (!CHECK_EQUAL(inside.on, under)) failed_at("on");
    if (here.closed && under == NOOK_NONE) {
        int32_t winding = winding_of(&v);
        if (!CHECK_EQUAL(inside.winding, winding)) failed_at("winding of a point");
        CHECK_EQUAL(inside.crossings & 1u, (uint32_t)winding & 1u);
        count.inside += winding != 0;
    }
    count.points++;
    count.on += under != NOOK_NONE;
    check_side(p, &inside);
    if (count.points % 8 == 0) check_sliced_inside(&inside, p);
}

static float beside(float x) {
    uint32_t bits = nook_float_bits(x), by = throw_dice(&d, 3);
    return (bits & 0x7FFFFFFFu) < 2 ? x : nook_float_from(bits + by - 1);
}

/* On the surface, a last place beside it, in line with it along axes, and anywhere. */
static void points_of_all_kinds(void) {
    uint32_t i, axis;
    for (i = 0; i < 3 * targets; i++) {
        nook_point p = throw_target(), q = throw_target();
        ask_point(p);
        ask_point(nook_make(p.x, p.y, q.z));
        ask_point(nook_make(q.x, p.y, p.z));
        ask_point(throw_place(here.size * (i % 2 ? 0.01f : 1.0f)));
        for (axis = 0; axis < 3; axis++) *(&p.x + axis) = beside(*(&p.x + axis));
        ask_point(p);
    }
}

/* ---- the generalised winding number --------------------------------------------------------------- */

/* Van Oosterom and Strackee. */
static long double solid_angle(const vector *p, uint32_t t) {
    vector q[3], a[3];
    long double l[3], above, below;
    real n;
    uint32_t i;
    take_triangle(t, q);
    for (i = 0; i < 3; i++) {
        a[i] = minus(&q[i], p);
        l[i] = sqrtl(dot(&a[i], &a[i]));
    }
    n = cross(&a[0], &a[1]);
    above = dot_real(&n, &a[2]);
    below =
        l[0] * l[1] * l[2] + dot(&a[0], &a[1]) * l[2] + dot(&a[1], &a[2]) * l[0] + dot(&a[2], &a[0]) * l[1];
    return 2 * atan2l(above, below);
}

static void ask_winding(nook_point point) {
    nook_point p = to_lattice(here.lattice, point);
    vector v = take_point(here.lattice, p);
    long double sum = 0;
    nook_winding w;
    nook_status status = NOOK_MORE;
    uint32_t t, units;
    if (triangle_under(&v) != NOOK_NONE) return;
    for (t = 0; t < here.view.nt; t++) sum += solid_angle(&v, t);
    CHECK_EQUAL(nook_winding_begin(&w, &here.view, p), NOOK_OK);
    for (t = 0; status == NOOK_MORE && t < 2 * here.view.nt; t++) {
        units = 1 + throw_dice(&d, 3);
        status = nook_winding_step(&w, &units);
    }
    CHECK_EQUAL(status, NOOK_OK);
    note(&count.worst_winding, fabsl(sum / 12.566370614359172954L - (long double)w.number), 1);
}

static void winding_of_points(void) {
    uint32_t i;
    for (i = 0; i < targets / 2; i++) ask_winding(throw_place(here.size * (i % 2 ? 0.1f : 1.0f)));
}

/* ---- any floats ----------------------------------------------------------------------------------- */

static struct {
    nook_point G[3];
    nook_index V[3];
    nook_boxes boxes[NOOK_BVH_GROUPS(1)];
    nook_bvh bvh;
} single;

static bool is_usable(nook_point p) { return nook_point_status(p) == NOOK_OK; }

static float largest_of(nook_point p) {
    float x = fabsf(p.x), y = fabsf(p.y), z = fabsf(p.z);
    return x > y ? (x > z ? x : z) : y > z ? y : z;
}

/* Two cases make a triangle, an origin that may have to do with it, and a direction that may. */
static bool throw_single(nook_point *origin, nook_point *direction) {
    nook_point p[8];
    uint32_t kind = throw_dice(&d, 6);
    nook_view view = {single.G, single.V, NULL, NULL, 3, 1};
    throw_case(&d, p);
    throw_case(&d, p + 4);
    memcpy(single.G, p, sizeof single.G);
    single.V[1] = 1, single.V[2] = 2;
    *origin = kind < 3 ? p[3] : p[4];
    *direction = kind % 3 == 0 ? p[5] : nook_sub(p[kind % 3], *origin);
    if (!is_usable(p[0]) || !is_usable(p[1]) || !is_usable(p[2]) || !is_usable(*origin)) return false;
    CHECK_EQUAL(nook_bvh_build(&single.bvh, &view, single.boxes, NULL, NULL), NOOK_OK);
    return nook_point_status(*direction) != NOOK_NOT_FINITE && !is_zero(*direction);
}

static void check_single_ray(nook_point origin, nook_point direction) {
    nook_ray r, crossed;
    bool meets = big_ray_meets(origin, direction, single.G);
    CHECK_EQUAL(nook_ray_cast(&r, &single.bvh, origin, direction, NOOK_MAX_T, NOOK_NEAREST), NOOK_OK);
    CHECK_EQUAL(nook_ray_cast(&crossed, &single.bvh, origin, direction, NOOK_MAX_T, NOOK_CROSSINGS), NOOK_OK);
    count.rays++;
    count.hits += meets;
    CHECK(r.triangle == NOOK_NONE || (r.t >= 0 && r.t <= NOOK_MAX_T));
    CHECK(crossed.crossings <= (meets ? 1u : 0u));
    if (largest_of(direction) < 1e-20f && meets) return; /* t may be beyond all floats */
    if (CHECK_EQUAL(r.triangle, meets ? 0 : NOOK_NONE)) return;
    (void)printf("o {%a,%a,%a} d {%a,%a,%a}", (double)origin.x, (double)origin.y, (double)origin.z,
                 (double)direction.x, (double)direction.y, (double)direction.z);
    (void)printf(" {%a,%a,%a} {%a,%a,%a} {%a,%a,%a}\n", (double)single.G[0].x, (double)single.G[0].y,
                 (double)single.G[0].z, (double)single.G[1].x, (double)single.G[1].y, (double)single.G[1].z,
                 (double)single.G[2].x, (double)single.G[2].y, (double)single.G[2].z);
}

static void check_single_point(nook_point p) {
    bool has_area =
        big_orient2d(single.G, 0) != 0 || big_orient2d(single.G, 1) != 0 || big_orient2d(single.G, 2) != 0;
    nook_inside in;
    uint32_t units = 100;
    CHECK_EQUAL(nook_inside_begin(&in, &single.bvh, p), NOOK_OK);
    CHECK_EQUAL(nook_inside_step(&in, &units), NOOK_OK);
    CHECK_EQUAL(in.on, has_area && big_point_is_on(p, single.G) ? 0 : NOOK_NONE);
    count.on += in.on == 0;
}

static void one_triangle_of_any_floats_is_met_as_in_big_integers(void) {
    uint32_t i, since = milliseconds();
    nook_point origin, direction;
    memset(&count, 0, sizeof count);
    for (i = 0; i < 400 * targets && !test_has_failed(); i++) {
        if (!throw_single(&origin, &direction)) continue;
        check_single_ray(origin, direction);
        check_single_point(origin);
    }
    CHECK(count.rays > i / 3 && count.hits > count.rays / 8 && count.on > count.rays / 200);
    print_figure("a triangle of any floats", count.rays, "rays", since);
    (void)printf("  %u hit; %u origins lie on it\n", (unsigned)count.hits, (unsigned)count.on);
}

/* ---- all solids ----------------------------------------------------------------------------------- */

static void of_each(void (*ask)(void)) {
    uint32_t s;
    for (s = 0; s < solid_count; s++) {
        running_solid = solids[s].name;
        for (running_variant = 0; running_variant < variant_count && !test_has_failed(); running_variant++) {
            make_solid(&solids[s], &variants[running_variant]);
            build_trees();
            ask();
            drop_world();
        }
    }
}

static void closed_solids_are_closed_and_outward(void) {
    uint32_t s, c;
    for (s = 0; s < solid_count; s++) {
        make_solid(&solids[s], &variants[1]);
        for (c = 0; c < 3 * here.view.nt && solids[s].closed; c++) CHECK(here.O[c] != c);
        drop_world();
    }
}

static void rays_hit_what_they_hit_in_integers_and_where_each_triangle_says(void) {
    uint32_t since = milliseconds();
    of_each(through_targets);
    of_each(along_axes);
    of_each(along_edges);
    of_each(along_faces);
    of_each(of_any_length);
    of_each(from_afar);
    CHECK(count.hits > count.rays / 2 && count.hits < count.rays);
    CHECK(count.through_borders > count.rays / 4);
    print_figure("rays through vertices, edges and faces, and along them", count.rays, "rays", since);
    (void)printf("  %u hit, %u of them more than one triangle\n", (unsigned)count.hits,
                 (unsigned)count.through_borders);
    (void)printf("  worst: t off by %u and out of the triangle's range by %u nano of it and the size\n",
                 (unsigned)count.worst_t, (unsigned)count.worst_range);
    (void)printf(
        "  weights: their point off by %u nano of t and the size, they or their sum out of 0 to 1 by %u\n",
        (unsigned)count.worst_w, (unsigned)count.worst_w_sum);
    CHECK(count.worst_t < 1000);
    CHECK(count.worst_range < 4000);
    CHECK(count.worst_w < 200000); /* on thin triangles */
    CHECK(count.worst_w_sum < 1000);
}

static void points_are_inside_outside_or_on_as_in_integers(void) {
    uint32_t since = milliseconds();
    of_each(points_of_all_kinds);
    CHECK(count.on > count.points / 8 && count.inside > count.points / 20);
    print_figure("points on surfaces, beside them, in line with them and anywhere", count.points, "points",
                 since);
    (void)printf("  %u on a surface, %u inside\n", (unsigned)count.on, (unsigned)count.inside);
}

static void winding_numbers_are_the_sums_of_solid_angles(void) {
    of_each(winding_of_points);
    (void)printf("winding numbers are off by at most %u nano\n", (unsigned)count.worst_winding);
    CHECK(count.worst_winding < 20000);
}

int main(int argc, char **argv) {
    static const test tests[] = {
        TEST(closed_solids_are_closed_and_outward),
        TEST(rays_hit_what_they_hit_in_integers_and_where_each_triangle_says),
        TEST(points_are_inside_outside_or_on_as_in_integers),
        TEST(winding_numbers_are_the_sums_of_solid_angles),
        TEST(one_triangle_of_any_floats_is_met_as_in_big_integers),
    };
    if (argc > 1 && strcmp(argv[1], "small") == 0) targets = 12;
    run_tests(tests, sizeof tests / sizeof *tests);
    return finish_tests();
}
