/* weights.c -- Caratheodory's theorem as an oracle. */
#include "weights.h"

#include <string.h>

/* ---- the theorem ---------------------------------------------------------------------------------- */

/* Whether the weights are all >= 0 or all <= 0, and not all 0. */
static bool agree(const int *weight, uint32_t n) {
    bool up = false, down = false;
    uint32_t i;
    for (i = 0; i < n; i++) {
        up = up || weight[i] > 0;
        down = down || weight[i] < 0;
    }
    return up != down;
}

static bool one(const signs *s, uint32_t i) {
    return s->at[i][0] == 0 && s->at[i][1] == 0 && s->at[i][2] == 0;
}

/* Parallel, and opposite along some axis. */
static bool two(const signs *s, uint32_t i, uint32_t j) {
    uint32_t axis;
    for (axis = 0; axis < 3; axis++) {
        if (s->cross[i][j][axis] != 0) return false;
    }
    for (axis = 0; axis < 3; axis++) {
        if (s->at[i][axis] * s->at[j][axis] < 0) return true;
    }
    return false;
}

static bool three(const signs *s, uint32_t i, uint32_t j, uint32_t k) {
    uint32_t axis;
    if (s->determinant[i][j][k] != 0) return false;
    for (axis = 0; axis < 3; axis++) {
        int weight[3];
        weight[0] = s->cross[j][k][axis];
        weight[1] = -s->cross[i][k][axis];
        weight[2] = s->cross[i][j][axis];
        if (agree(weight, 3)) return true;
    }
    return false;
}

static bool four(const signs *s, uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
    int weight[4];
    weight[0] = s->determinant[j][k][l];
    weight[1] = -s->determinant[i][k][l];
    weight[2] = s->determinant[i][j][l];
    weight[3] = -s->determinant[i][j][k];
    return agree(weight, 4);
}

bool zero_is_mean(const signs *s) {
    uint32_t i, j, k, l;
    for (i = 0; i < s->n; i++) {
        if (one(s, i)) return true;
        for (j = i + 1; j < s->n; j++) {
            if (two(s, i, j)) return true;
            for (k = j + 1; k < s->n; k++) {
                if (three(s, i, j, k)) return true;
                for (l = k + 1; l < s->n; l++) {
                    if (four(s, i, j, k, l)) return true;
                }
            }
        }
    }
    return false;
}

/* ---- integers ------------------------------------------------------------------------------------- */

__extension__ typedef __int128 wide;

static int8_t sign_of_wide(wide x) { return (int8_t)((x > 0) - (x < 0)); }

static wide component(const vector *a, const vector *b, uint32_t axis) {
    uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (wide)a->at[u] * b->at[v] - (wide)a->at[v] * b->at[u];
}

int sign_of(const vector *a, const vector *b, const vector *c) {
    return sign_of_wide(component(a, b, 0) * c->at[0] + component(a, b, 1) * c->at[1] +
                        component(a, b, 2) * c->at[2]);
}

vector minus(const vector *a, const vector *b) {
    vector d;
    uint32_t axis;
    for (axis = 0; axis < 3; axis++) d.at[axis] = a->at[axis] - b->at[axis];
    return d;
}

static void find_signs(signs *s, const vector *d, uint32_t n) {
    uint32_t i, j, k, axis;
    s->n = n;
    for (i = 0; i < n; i++) {
        for (axis = 0; axis < 3; axis++) s->at[i][axis] = sign_of_wide(d[i].at[axis]);
        for (j = i + 1; j < n; j++) {
            wide c[3];
            for (axis = 0; axis < 3; axis++) {
                c[axis] = component(&d[i], &d[j], axis);
                s->cross[i][j][axis] = sign_of_wide(c[axis]);
            }
            for (k = j + 1; k < n; k++) {
                const int64_t *p = d[k].at;
                s->determinant[i][j][k] = sign_of_wide(c[0] * p[0] + c[1] * p[1] + c[2] * p[2]);
            }
        }
    }
}

bool mean_of_vectors(const vector *d, uint32_t n) {
    static signs s;
    find_signs(&s, d, n);
    return zero_is_mean(&s);
}

bool hulls_meet(const vector *a, uint32_t m, const vector *b, uint32_t n) {
    vector d[MOST_VECTORS];
    uint32_t i;
    for (i = 0; i < m * n; i++) d[i] = minus(&a[i / n], &b[i % n]);
    return mean_of_vectors(d, m * n);
}

bool ray_meets(const vector *origin, const vector *direction, const vector triangle[3]) {
    static const vector zero = {{0, 0, 0}};
    vector d[4];
    uint32_t i;
    for (i = 0; i < 3; i++) d[i] = minus(&triangle[i], origin);
    d[3] = minus(&zero, direction);
    return mean_of_vectors(d, 4);
}

bool has_no_area(const vector p[3]) {
    vector u = minus(&p[1], &p[0]), v = minus(&p[2], &p[0]);
    return component(&u, &v, 0) == 0 && component(&u, &v, 1) == 0 && component(&u, &v, 2) == 0;
}

/* ---- floats on a lattice -------------------------------------------------------------------------- */

static float coordinate(nook_point p, uint32_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static int exponent_of(float x) {
    int biased = (int)(nook_float_bits(x) >> 23 & 255u);
    return biased == 0 ? -126 : biased - 127;
}

lattice lattice_of(const nook_point *p, uint32_t n) {
    lattice l = {-149};
    uint32_t i, axis;
    for (i = 0; i < n; i++) {
        for (axis = 0; axis < 3; axis++) {
            int place = exponent_of(coordinate(p[i], axis)) - 38;
            if (place > l.place) l.place = place;
        }
    }
    return l;
}

/* A float in units, what is below one cut off. */
static int64_t units_of(lattice l, float x) {
    uint32_t bits = nook_float_bits(x), m = (bits & 0x7FFFFFu) + ((bits >> 23 & 255u) != 0 ? 0x800000u : 0);
    int up = exponent_of(x) - 23 - l.place;
    int64_t units = up >= 0 ? (int64_t)m << up : up > -24 ? (int64_t)(m >> -up) : 0;
    return bits >> 31 != 0 ? -units : units;
}

static float cut(lattice l, float x) {
    int64_t units = units_of(l, x);
    int at = l.place, half = at / 2;
    uint32_t up = (uint32_t)(half + 127), rest = (uint32_t)(at - half + 127);
    return (float)units * nook_power_of_two(up) * nook_power_of_two(rest);
}

nook_point to_lattice(lattice l, nook_point p) { return nook_make(cut(l, p.x), cut(l, p.y), cut(l, p.z)); }

bool on_lattice(lattice l, nook_point p) {
    nook_point q = to_lattice(l, p);
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

vector take_point(lattice l, nook_point p) {
    vector v;
    v.at[0] = units_of(l, p.x);
    v.at[1] = units_of(l, p.y);
    v.at[2] = units_of(l, p.z);
    return v;
}

/* ---- any floats ----------------------------------------------------------------------------------- */

/* Difference i is that of points p[2 i] and p[2 i + 1]; its determinant with two others, or with another
 * and an axis. */
static int8_t big_sign(const nook_point *p, uint32_t i, uint32_t j, uint32_t k) {
    nook_point q[6];
    memcpy(q, p + 2 * i, 2 * sizeof *q);
    memcpy(q + 2, p + 2 * j, 2 * sizeof *q);
    memcpy(q + 4, p + 2 * k, 2 * sizeof *q);
    return (int8_t)big_determinant(q);
}

static void find_big_signs(signs *s, nook_point *p, uint32_t n) {
    uint32_t i, j, k, axis;
    s->n = n;
    for (axis = 0; axis < 3; axis++) {
        p[2 * (n + axis)] = nook_make(0, 0, 0);
        p[2 * (n + axis) + 1] = nook_make(axis == 0, axis == 1, axis == 2);
    }
    for (i = 0; i < n; i++) {
        for (axis = 0; axis < 3; axis++) {
            float a = coordinate(p[2 * i], axis), b = coordinate(p[2 * i + 1], axis);
            s->at[i][axis] = (int8_t)((b > a) - (b < a));
        }
        for (j = i + 1; j < n; j++) {
            for (axis = 0; axis < 3; axis++) s->cross[i][j][axis] = big_sign(p, i, j, n + axis);
            for (k = j + 1; k < n; k++) s->determinant[i][j][k] = big_sign(p, i, j, k);
        }
    }
}

bool big_triangles_meet(const nook_point a[3], const nook_point b[3]) {
    static signs s;
    nook_point p[2 * (MOST_VECTORS + 3)];
    uint32_t i;
    for (i = 0; i < 9; i++) {
        p[2 * i] = a[i / 3];
        p[2 * i + 1] = b[i % 3];
    }
    find_big_signs(&s, p, 9);
    return zero_is_mean(&s);
}

static void take_corners(nook_point *p, nook_point from, const nook_point triangle[3]) {
    uint32_t i;
    for (i = 0; i < 3; i++) {
        p[2 * i] = from;
        p[2 * i + 1] = triangle[i];
    }
}

bool big_ray_meets(nook_point origin, nook_point direction, const nook_point triangle[3]) {
    static signs s;
    nook_point p[2 * (4 + 3)];
    take_corners(p, origin, triangle);
    p[6] = direction;
    p[7] = nook_make(0, 0, 0);
    find_big_signs(&s, p, 4);
    return zero_is_mean(&s);
}

bool big_point_is_on(nook_point point, const nook_point triangle[3]) {
    static signs s;
    nook_point p[2 * (3 + 3)];
    take_corners(p, point, triangle);
    find_big_signs(&s, p, 3);
    return zero_is_mean(&s);
}
