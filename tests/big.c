/* big.c -- integers of any size that floats need, and the hard cases of big.h. */
#include "big.h"

#include <string.h>

/* ---- integers in sign and magnitude -------------------------------------------------------------- */

enum { LIMBS = 48 };
typedef struct big {
    bool negative;
    uint32_t n; /* limbs in use; the last is not 0 */
    uint32_t limb[LIMBS];
} big;

static void trim(big *a) {
    while (a->n > 0 && a->limb[a->n - 1u] == 0) a->n--;
}

static int compare_magnitudes(const big *a, const big *b) {
    uint32_t i;
    if (a->n != b->n) return a->n > b->n ? 1 : -1;
    for (i = a->n; i-- > 0;) {
        if (a->limb[i] != b->limb[i]) return a->limb[i] > b->limb[i] ? 1 : -1;
    }
    return 0;
}

/* to += or -= what; |to| < |what| needs the other order, so a copy. */
static void add_magnitudes(big *to, const big *what) {
    uint64_t t = 0;
    uint32_t i, n = to->n > what->n ? to->n : what->n;
    for (i = 0; i < n; i++) {
        t += (uint64_t)(i < to->n ? to->limb[i] : 0) + (i < what->n ? what->limb[i] : 0);
        to->limb[i] = (uint32_t)t;
        t >>= 32;
    }
    to->n = n;
    if (t != 0) to->limb[to->n++] = (uint32_t)t;
}

static void take_magnitude(big *from, const big *what) {
    uint32_t i, borrow = 0;
    for (i = 0; i < from->n; i++) {
        uint64_t t = (uint64_t)from->limb[i] - (i < what->n ? what->limb[i] : 0) - borrow;
        from->limb[i] = (uint32_t)t;
        borrow = (uint32_t)(t >> 63);
    }
    trim(from);
}

static void add(big *to, const big *what, bool minus) {
    bool negative = what->negative != minus;
    if (to->negative == negative) {
        add_magnitudes(to, what);
    } else if (compare_magnitudes(to, what) >= 0) {
        take_magnitude(to, what);
    } else {
        static big keep;
        keep = *what;
        take_magnitude(&keep, to);
        *to = keep;
        to->negative = negative;
    }
}

static void multiply(big *to, const big *a, const big *b) {
    uint32_t i, j;
    to->negative = a->negative != b->negative;
    to->n = a->n + b->n;
    memset(to->limb, 0, to->n * sizeof to->limb[0]);
    for (i = 0; i < a->n; i++) {
        uint64_t t = 0;
        for (j = 0; j < b->n; j++) {
            t += (uint64_t)a->limb[i] * b->limb[j] + to->limb[i + j];
            to->limb[i + j] = (uint32_t)t;
            t >>= 32;
        }
        to->limb[i + j] = (uint32_t)t;
    }
    trim(to);
}

static int sign_of_big(const big *a) { return a->n == 0 ? 0 : a->negative ? -1 : 1; }

/* ---- floats as integers ---------------------------------------------------------------------------- */

static uint32_t place_of(float x) {
    uint32_t exponent = nook_float_bits(x) >> 23 & 255u;
    return exponent == 0 ? 0 : exponent - 1u;
}

static void take_float(big *to, float x, uint32_t lowest) {
    uint32_t bits = nook_float_bits(x), m = (bits & 0x7FFFFFu) + ((bits >> 23 & 255u) != 0 ? 0x800000u : 0);
    uint32_t up = place_of(x) - lowest, i;
    uint64_t shifted = (uint64_t)m << up % 32u;
    if (m == 0) up = 0;
    to->negative = bits >> 31 != 0;
    for (i = 0; i < up / 32u; i++) to->limb[i] = 0;
    to->limb[i] = (uint32_t)shifted;
    to->limb[i + 1u] = (uint32_t)(shifted >> 32);
    to->n = i + 2u;
    trim(to);
}

static float coordinate(const nook_point *p, uint32_t axis) {
    return axis == 0 ? p->x : axis == 1u ? p->y : p->z;
}

/* The unit of one coordinate of n points: the place of the last bit of the smallest. */
static uint32_t lowest_of(const nook_point *p, uint32_t n, uint32_t axis) {
    uint32_t lowest = 255u, i;
    for (i = 0; i < n; i++) {
        uint32_t place = place_of(coordinate(&p[i], axis));
        if (coordinate(&p[i], axis) != 0 && place < lowest) lowest = place;
    }
    return lowest == 255u ? 0 : lowest;
}

static void take_difference(big *to, float a, float b, uint32_t lowest) {
    static big other;
    take_float(to, a, lowest);
    take_float(&other, b, lowest);
    add(to, &other, true);
}

static void take_minor(big *to, const big *a, const big *d, const big *b, const big *c) {
    static big other;
    multiply(to, a, d);
    multiply(&other, b, c);
    add(to, &other, true);
}

/* The determinant of three rows, added to or taken from a sum. */
static void add_determinant(big *sum, big m[3][3]) {
    static big minor, product;
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        take_minor(&minor, &m[(i + 1u) % 3u][1], &m[(i + 2u) % 3u][2], &m[(i + 1u) % 3u][2],
                   &m[(i + 2u) % 3u][1]);
        multiply(&product, &minor, &m[i][0]);
        add(sum, &product, false);
    }
}

static big m[3][3], sum;

int big_orient3d(const nook_point p[4]) {
    uint32_t axis, i;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t lowest = lowest_of(p, 4, axis);
        for (i = 0; i < 3u; i++) {
            take_difference(&m[i][axis], coordinate(&p[i + 1u], axis), coordinate(&p[0], axis), lowest);
        }
    }
    sum.n = 0;
    sum.negative = false;
    add_determinant(&sum, m);
    return sign_of_big(&sum);
}

int big_determinant(const nook_point p[6]) {
    uint32_t axis, i;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t lowest = lowest_of(p, 6, axis);
        for (i = 0; i < 3u; i++) {
            take_difference(&m[i][axis], coordinate(&p[2u * i + 1u], axis), coordinate(&p[2u * i], axis),
                            lowest);
        }
    }
    sum.n = 0;
    sum.negative = false;
    add_determinant(&sum, m);
    return sign_of_big(&sum);
}

int big_orient2d(const nook_point p[3], uint32_t axis) {
    uint32_t u = (axis + 1u) % 3u, v = (axis + 2u) % 3u, i;
    for (i = 0; i < 2u; i++) {
        take_difference(&m[i][0], coordinate(&p[i + 1u], u), coordinate(&p[0], u), lowest_of(p, 3, u));
        take_difference(&m[i][1], coordinate(&p[i + 1u], v), coordinate(&p[0], v), lowest_of(p, 3, v));
    }
    take_minor(&sum, &m[0][0], &m[1][1], &m[0][1], &m[1][0]);
    return sign_of_big(&sum);
}

int big_compare_distances(const nook_point p[4]) {
    uint32_t axis, lowest = 255u;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t l = lowest_of(p, 4, axis);
        if (l < lowest) lowest = l;
    }
    sum.n = 0;
    sum.negative = false;
    for (axis = 0; axis < 3u; axis++) {
        take_difference(&m[0][0], coordinate(&p[0], axis), coordinate(&p[1], axis), lowest);
        take_difference(&m[0][1], coordinate(&p[2], axis), coordinate(&p[3], axis), lowest);
        multiply(&m[1][0], &m[0][0], &m[0][0]);
        multiply(&m[1][1], &m[0][1], &m[0][1]);
        add(&sum, &m[1][0], false);
        add(&sum, &m[1][1], true);
    }
    return sign_of_big(&sum);
}

/* The normal of each piece as three minors of differences, all axes on one unit. */
int big_compare_normals(const nook_point p[8]) {
    static big normal[2][3], product;
    uint32_t axis, piece, lowest = 255u;
    for (axis = 0; axis < 3u; axis++) {
        uint32_t l = lowest_of(p, 8, axis);
        if (l < lowest) lowest = l;
    }
    for (piece = 0; piece < 2u; piece++) {
        const nook_point *q = p + 4u * piece;
        for (axis = 0; axis < 3u; axis++) {
            take_difference(&m[0][axis], coordinate(&q[2], axis), coordinate(&q[0], axis), lowest);
            take_difference(&m[1][axis], coordinate(&q[3], axis), coordinate(&q[1], axis), lowest);
        }
        for (axis = 0; axis < 3u; axis++) {
            uint32_t u = (axis + 1u) % 3u, v = (axis + 2u) % 3u;
            take_minor(&normal[piece][axis], &m[0][u], &m[1][v], &m[0][v], &m[1][u]);
        }
    }
    sum.n = 0;
    sum.negative = false;
    for (axis = 0; axis < 3u; axis++) {
        multiply(&product, &normal[0][axis], &normal[1][axis]);
        add(&sum, &product, false);
    }
    return sign_of_big(&sum);
}

int compare_pieces(const nook_point p[4], uint32_t order, int *expected) {
    static const uint8_t choice[4][8] = {{0, 1, 2, 2, 1, 3, 2, 2},
                                         {0, 1, 3, 3, 0, 1, 2, 2},
                                         {0, 1, 2, 2, 0, 3, 2, 2},
                                         {0, 1, 2, 3, 2, 0, 3, 1}};
    nook_point q[8];
    const nook_point *one[4], *other[4];
    uint32_t i;
    for (i = 0; i < 8; i++) q[i] = p[choice[order % 4][i]];
    for (i = 0; i < 4; i++) one[i] = &q[i], other[i] = &q[4 + i];
    *expected = big_compare_normals(q);
    return nook_compare_normals(one, other);
}

int big_volume_sign(const nook_point *p, uint32_t n) {
    uint32_t lowest[3], axis, i, t;
    for (axis = 0; axis < 3u; axis++) lowest[axis] = lowest_of(p, 3u * n, axis);
    sum.n = 0;
    sum.negative = false;
    for (t = 0; t < n; t++) {
        for (i = 0; i < 9u; i++) {
            take_float(&m[i / 3u][i % 3u], coordinate(&p[3u * t + i / 3u], i % 3u), lowest[i % 3u]);
        }
        add_determinant(&sum, m);
    }
    return sign_of_big(&sum);
}

/* No two throws in one expression: compilers order them as they like, and boards must see the same cases. */

/* ---- cases ------------------------------------------------------------------------------------------- */

static float unit(dice *d) { return (float)throw_dice(d, 0x1000000u) * 0x1p-23f - 1.0f; }

static float finite(uint32_t bits) {
    return nook_float_from((bits & 0x7F800000u) == 0x7F800000u ? bits ^ 0x40000000u : bits);
}

/* The float a last place more or less, or the same. */
static float near(dice *d, float x) {
    uint32_t bits = nook_float_bits(x), throw = throw_dice(d, 3);
    return (bits & 0x7FFFFFFFu) < 2u ? x : finite(bits + throw -1u);
}

static float with_sign(dice *d, uint32_t bits) { return nook_float_from(bits | throw_dice(d, 2) << 31); }

static float edge_case(dice *d) {
    static const uint32_t bits[] = {
        0,  0x80000000u, 0x3F800000u, 0xBF800000u, 0x3F800001u, 0x3F7FFFFFu, 0x4E800000u, 0xCE800000u,
        1u, 0x80000001u, 0x007FFFFFu, 0x00800000u, 0x7F7FFFFFu, 0xFF7FFFFFu, 0x24E69595u, 0x08E7E34Bu};
    return nook_float_from(bits[throw_dice(d, 16)]);
}

static float cad(dice *d) {
    static const float value[] = {0, 1, -1, 0.5f, 0.1f, 0.3f, 1e-17f, -1e-17f, 1e-33f, 12.7f, 25.4f, 0.025f};
    return value[throw_dice(d, 12)];
}

static float one_coordinate(dice *d, uint32_t kind) {
    switch (kind) {
    case CASE_GRID: return (float)throw_dice(d, 7) - 3.0f;
    case CASE_CAD: return cad(d);
    case CASE_BITS: return finite(throw_dice(d, UINT32_MAX));
    case CASE_SUBNORMAL: return with_sign(d, throw_dice(d, 0x1000000u));
    case CASE_EXPONENTS: return with_sign(d, throw_dice(d, 254 * 8) << 20);
    case CASE_EDGES: return edge_case(d);
    default: return unit(d);
    }
}

static nook_point blend(nook_point a, nook_point b, nook_point c, float s, float t) {
    nook_point ab = nook_scaled(nook_sub(b, a), s), ac = nook_scaled(nook_sub(c, a), t);
    return nook_make(a.x + ab.x + ac.x, a.y + ab.y + ac.y, a.z + ab.z + ac.z);
}

uint32_t throw_case(dice *d, nook_point p[4]) {
    uint32_t kind = throw_dice(d, CASE_KINDS), i;
    float scale = nook_power_of_two(107u + throw_dice(d, 41)), s = unit(d), t = unit(d);
    for (i = 0; i < 4u; i++) {
        float x = one_coordinate(d, kind), y = one_coordinate(d, kind);
        p[i] = nook_make(x, y, one_coordinate(d, kind));
    }
    switch (kind) {
    case CASE_COPLANAR:
    case CASE_ON_TRIANGLE:
    case CASE_COLLINEAR:
        for (i = 0; i < 3u; i++) p[i] = nook_scaled(p[i], scale);
        if (kind == CASE_COLLINEAR) p[2] = blend(p[0], p[1], p[1], s, 0);
        p[3] = blend(p[0], p[1], p[2], s * 0.5f + 0.5f, t * 0.5f);
        for (i = 0; i < 4u && kind != CASE_ON_TRIANGLE; i++) {
            p[i].x = near(d, p[i].x);
            p[i].y = near(d, p[i].y);
            p[i].z = near(d, p[i].z);
        }
        break;
    case CASE_SAME_PLANE:
        for (i = 0; i < 4u; i++) p[i].z = s;
        break;
    case CASE_FAR:
        for (i = 0; i < 4u; i++)
            p[i] = nook_make(s * 64.0f + p[i].x * 1e-4f, t * 64.0f + p[i].y * 1e-4f, p[i].z * 1e-4f);
        break;
    default: break;
    }
    /* Any two points may fall together, and any axis come first. */
    i = throw_dice(d, 64);
    if (i < 4) p[i] = p[throw_dice(d, 4)];
    if (throw_dice(d, 3) == 0) {
        for (i = 0; i < 4u; i++) p[i] = nook_make(p[i].z, p[i].x, p[i].y);
    }
    return kind;
}
