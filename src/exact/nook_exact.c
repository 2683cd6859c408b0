/* nook_exact.c -- the three stages of nook_exact.h, and the exact volume. Only the deepest counts for the stack. */
#include "exact/nook_exact.h"

static const uint32_t one = 0x3F800000u; /* the float 1 as bits */

static uint32_t second_after(uint32_t axis) { return axis == 0 ? 2u : axis - 1u; }

/* A point is three floats without gaps. */
static inline uint32_t bits_of(const nook_point *p, uint32_t axis) {
    return nook_float_bits(nook_along(p, axis));
}

/* A finite float without its sign is mantissa times 2^(exponent - 150), with 1 <= exponent. */
static inline uint32_t exponent_of(uint32_t bits) {
    uint32_t exponent = bits >> 23 & 0xFFu;
    return exponent != 0 ? exponent : 1u;
}

static inline uint32_t mantissa_of(uint32_t bits) {
    uint32_t mantissa = bits & 0x7FFFFFu;
    return (bits >> 23 & 0xFFu) != 0 ? mantissa | 0x800000u : mantissa;
}

/* a b + c in 64 bits. A Cortex-M0 multiplies to 32 bits only, and the compiler's helper for more takes three
 * times as long. */
static inline uint64_t multiply_add(uint32_t a, uint32_t b, uint32_t c) {
#ifdef __ARM_ARCH_6M__
    uint32_t low = (a & 0xFFFFu) * (b & 0xFFFFu), mid = (a >> 16) * (b & 0xFFFFu) + (low >> 16);
    uint32_t other = (a & 0xFFFFu) * (b >> 16) + (mid & 0xFFFFu);
    uint32_t high = (a >> 16) * (b >> 16) + (mid >> 16) + (other >> 16);
    return ((uint64_t)high << 32 | (other << 16 | (low & 0xFFFFu))) + c;
#else
    return (uint64_t)a * b + c;
#endif
}

static int64_t multiply_signed(int32_t a, int32_t b) {
#ifdef __ARM_ARCH_6M__
    uint64_t product = multiply_add((uint32_t)a, (uint32_t)b, 0);
    uint32_t over = (a < 0 ? (uint32_t)b : 0) + (b < 0 ? (uint32_t)a : 0);
    return (int64_t)(product - ((uint64_t)over << 32));
#else
    return (int64_t)a * b;
#endif
}

static int sign_of(int64_t n) { return (n > 0) - (n < 0); }

/* ---- float ------------------------------------------------------------------------------------- */

/* Also without an FPU: what is left costs thirty times as much. */
NOOK_APART static int normals_by_floats(const nook_point *const *p, const nook_point *const *q) {
    nook_point u = nook_sub(*p[2], *p[0]), v = nook_sub(*p[3], *p[1]);
    nook_point x = nook_sub(*q[2], *q[0]), y = nook_sub(*q[3], *q[1]);
    nook_point n = nook_cross(u, v), m = nook_cross(x, y), bound, other;
    bound = nook_make(nook_abs(u.y * v.z) + nook_abs(u.z * v.y), nook_abs(u.z * v.x) + nook_abs(u.x * v.z),
                      nook_abs(u.x * v.y) + nook_abs(u.y * v.x));
    other = nook_make(nook_abs(x.y * y.z) + nook_abs(x.z * y.y), nook_abs(x.z * y.x) + nook_abs(x.x * y.z),
                      nook_abs(x.x * y.y) + nook_abs(x.y * y.x));
    return nook_decided(nook_dot(n, m), 16 * 0x1p-24f, nook_dot(bound, other),
                        bound.x + bound.y + bound.z + other.x + other.y + other.z);
}

#if NOOK_HAS_FPU
static inline int cross_by_floats(nook_point b, nook_point c, uint32_t axis) {
    uint32_t u = nook_after(axis), v = second_after(axis);
    float left = nook_along(&b, u) * nook_along(&c, v), right = nook_along(&c, u) * nook_along(&b, v);
    return nook_decided(left - right, 4 * 0x1p-24f, nook_abs(left) + nook_abs(right), 0);
}

static inline int distances_by_floats(const nook_point *a, const nook_point *b, const nook_point *c,
                                      const nook_point *d) {
    nook_point ab = nook_sub(*b, *a), cd = nook_sub(*d, *c);
    float left = nook_dot(ab, ab), right = nook_dot(cd, cd);
    return nook_decided(left - right, 8 * 0x1p-24f, left + right, 0);
}
#else
#define cross_by_floats(b, c, axis) NOOK_UNDECIDED
#define distances_by_floats(a, b, c, d) NOOK_UNDECIDED
#endif

/* ---- integers ---------------------------------------------------------------------------------- */

/* The largest exponent of one coordinate of n points. */
static uint32_t top_of(const nook_point *const *p, uint32_t n, uint32_t axis) {
    uint32_t most = 0;
    while (n-- > 0) {
        uint32_t doubled = bits_of(p[n], axis) << 1;
        if (doubled > most) most = doubled;
    }
    return exponent_of(most >> 1);
}

/* One coordinate of n points less that of point 0, as integers below 2^31 on the exponent top - 156; row number
 * direction, if there is one, as it is. False where bits do not fit. */
NOOK_APART static bool differences(const nook_point *const *p, uint32_t n, uint32_t direction, uint32_t axis,
                                   uint32_t top, int32_t *to) {
    uint32_t lost = 0, i;
    int32_t first = 0;
    for (i = 0; i < n; i++) {
        uint32_t bits = bits_of(p[i], axis), m = mantissa_of(bits) << 6, shift = top - exponent_of(bits),
                 kept;
        int32_t value;
        if (shift > 31u) shift = 31u;
        kept = m >> shift;
        lost |= m ^ kept << shift;
        value = bits >> 31 ? -(int32_t)kept : (int32_t)kept;
        if (i == 0) {
            first = value;
        } else {
            to[i - 1u] = i == direction ? value : value - first;
        }
    }
    return lost == 0;
}

/* Entries below 2^31: minors below 2^63, and the determinant below 4 * 2^93 (Hadamard), so its upper 64
 * of 96 bits come out right whatever their sum does on the way. */
static int sign_of_determinant(int32_t n[3][3]) {
    uint64_t high = 0, low = 0;
    uint32_t i;
    for (i = 0; i < 3u; i++) {
        uint32_t j = nook_after(i), k = second_after(i);
        int32_t x = n[0][i];
        int64_t minor = multiply_signed(n[1][j], n[2][k]) - multiply_signed(n[1][k], n[2][j]);
        uint64_t part = multiply_add((uint32_t)minor, (uint32_t)x, 0);
        high += (uint64_t)multiply_signed((int32_t)(minor >> 32), x) + (part >> 32);
        if (x < 0) high -= (uint32_t)minor;
        low += (uint32_t)part;
    }
    high += low >> 32;
    return high != 0 ? sign_of((int64_t)high) : (uint32_t)low != 0;
}

NOOK_APART static int orient3d_by_integers(const nook_point *const *p, uint32_t direction) {
    int32_t n[3][3];
    uint32_t axis;
    for (axis = 0; axis < 3u; axis++) {
        if (!differences(p, 4, direction, axis, top_of(p, 4, axis), n[axis])) return NOOK_UNDECIDED;
    }
    return sign_of_determinant(n);
}

NOOK_APART static int orient2d_by_integers(const nook_point *const *p, uint32_t direction, uint32_t axis) {
    uint32_t u = nook_after(axis), v = second_after(axis);
    int32_t x[2], y[2];
    if (!differences(p, 3, direction, u, top_of(p, 3, u), x)) return NOOK_UNDECIDED;
    if (!differences(p, 3, direction, v, top_of(p, 3, v), y)) return NOOK_UNDECIDED;
    return sign_of(multiply_signed(x[0], y[1]) - multiply_signed(x[1], y[0]));
}

NOOK_APART static int distances_by_integers(const nook_point *const *p) {
    uint64_t square[2] = {0, 0}; /* three squares below 2^62 */
    uint32_t i, top = 0;
    for (i = 0; i < 3u; i++) {
        uint32_t exponent = top_of(p, 4, i);
        if (exponent > top) top = exponent;
    }
    for (i = 0; i < 6u; i++) {
        int32_t n;
        if (!differences(p + 2u * (i & 1u), 2, NOOK_NONE, i >> 1, top, &n)) return NOOK_UNDECIDED;
        square[i & 1u] += (uint64_t)multiply_signed(n, n);
    }
    return (square[0] > square[1]) - (square[0] < square[1]);
}

/* ---- sum --------------------------------------------------------------------------------------- */

/* A number in two's complement from 2^-447 up, plus 5 in every digit: so neither does adding carry nor
 * does taking away borrow through all words when the sum goes back and forth about 0. */
enum { SUM_WORDS = 27 };
static const uint32_t zero = 0x55555555u;

static void clear(uint32_t *sum, uint32_t words) {
    while (words-- > 0) sum[words] = zero;
}

static int sign_of_sum(const uint32_t *sum, uint32_t words) {
    while (words-- > 0) {
        if (sum[words] != zero) return sum[words] > zero ? 1 : -1;
    }
    return 0;
}

static inline uint32_t add_word(uint32_t *word, uint32_t digit, uint32_t carry) {
    uint64_t t = (uint64_t)*word + digit + carry;
    *word = (uint32_t)t;
    return (uint32_t)(t >> 32);
}

/* The product of two floats: 48 bits, their place, and the sign in the highest bit. */
typedef struct product {
    uint32_t low, high, place, sign;
} product;

static product product_of(uint32_t x, uint32_t y) {
    uint64_t xy = multiply_add(mantissa_of(x), mantissa_of(y), 0);
    product p = {(uint32_t)xy, (uint32_t)(xy >> 32), exponent_of(x) + exponent_of(y) - 3u, x ^ y};
    return p;
}

/* Add xy times z to a sum, or take it away: 72 bits at their place, and as far as they carry. */
NOOK_APART static void add_product(uint32_t *sum, uint32_t words, const product *xy, uint32_t z) {
    uint32_t flip = 0u - ((xy->sign ^ z) >> 31), carry = flip & 1u, before, now;
    uint32_t left = xy->place + exponent_of(z), right, above = words - (left >> 5);
    uint64_t part;
    if ((left >> 5) + 4u > words) return; /* a coordinate beyond 2^30 in a volume */
    sum += left >> 5;
    left &= 31u, right = 31u - left;
    z = mantissa_of(z);
    part = multiply_add(xy->low, z, 0);
    before = (uint32_t)part;
    carry = add_word(sum++, before << left ^ flip, carry);
    part = multiply_add(xy->high, z, (uint32_t)(part >> 32));
    now = (uint32_t)part;
    carry = add_word(sum++, (now << left | before >> 1 >> right) ^ flip, carry);
    before = now, now = (uint32_t)(part >> 32);
    carry = add_word(sum++, (now << left | before >> 1 >> right) ^ flip, carry);
    carry = add_word(sum++, now >> 1 >> right ^ flip, carry);
    for (above -= 4u; above != 0 && carry != (flip & 1u); above--) carry = add_word(sum++, flip, carry);
}

/* The product of two coordinates, with the sign of the permutation that takes rows i and j and leaves the
 * others in order. */
static product product_of_rows(const nook_point *const *p, uint32_t i, uint32_t j, uint32_t u, uint32_t v) {
    product xy = product_of(bits_of(p[i], u), bits_of(p[j], v));
    xy.sign ^= (i + j + (uint32_t)(i > j) + 1u) << 31;
    return xy;
}

/* The determinant of four rows x y z 1: a product for each way to choose rows i, j, k that differ, with the
 * sign of the permutation i, j, k, rest. It is that of orient3d turned over. A direction ends in 0 and is never the rest. */
static void add_determinant(uint32_t *sum, const nook_point *const *p, uint32_t direction) {
    uint32_t i, j, k;
    clear(sum, SUM_WORDS);
    for (i = 0; i < 4u; i++) {
        for (j = 0; j < 4u; j++) {
            product xy;
            if (i == j) continue;
            xy = product_of_rows(p, i, j, 0, 1);
            for (k = 0; k < 4u; k++) {
                if (k == i || k == j) continue;
                if (6u - i - j - k != direction) add_product(sum, SUM_WORDS, &xy, bits_of(p[k], 2));
                xy.sign ^= 0x80000000u;
            }
        }
    }
}

NOOK_APART static int orient3d_by_sum(const nook_point *const *p, uint32_t direction) {
    uint32_t sum[SUM_WORDS];
    add_determinant(sum, p, direction);
    return -sign_of_sum(sum, SUM_WORDS);
}

/* The determinant of three rows of two coordinates and 1, or 0 for a direction. */
NOOK_APART static int orient2d_by_sum(const nook_point *const *p, uint32_t direction, uint32_t axis) {
    uint32_t sum[SUM_WORDS], i, j;
    clear(sum, SUM_WORDS);
    for (i = 0; i < 3u; i++) {
        for (j = 0; j < 3u; j++) {
            product xy;
            if (i == j || 3u - i - j == direction) continue;
            xy = product_of_rows(p, i, j, nook_after(axis), second_after(axis));
            add_product(sum, SUM_WORDS, &xy, one);
        }
    }
    return sign_of_sum(sum, SUM_WORDS);
}

/* a a + b b - 2 a b in every coordinate, less the same of c and d. */
NOOK_APART static int distances_by_sum(const nook_point *const *p) {
    uint32_t sum[SUM_WORDS], axis, i;
    clear(sum, SUM_WORDS);
    for (axis = 0; axis < 3u; axis++) {
        for (i = 0; i < 4u; i++) {
            product xy = product_of(bits_of(p[i], axis), bits_of(p[i], axis));
            xy.sign = i << 30;
            add_product(sum, SUM_WORDS, &xy, one);
            if ((i & 1u) == 0) continue;
            xy = product_of(bits_of(p[i], axis), bits_of(p[i - 1u], axis));
            xy.sign ^= ~i << 30;
            xy.place++;
            add_product(sum, SUM_WORDS, &xy, one);
        }
    }
    return sign_of_sum(sum, SUM_WORDS);
}

/* One of the eight products of two coordinates u and v in (p2 - p0) x (p3 - p1): bit 0 of which takes p0 for p2,
 * bit 1 p1 for p3, bit 2 the second half of the minor. False if it is 0, or of p2 and p3 that are the same. */
static bool product_of_normal(const nook_point *const *p, uint32_t which, uint32_t axis, product *xy) {
    const nook_point *first = p[2u - 2u * (which & 1u)], *second = p[3u - (which & 2u)];
    uint32_t u = nook_after(axis), v = second_after(axis);
    if (first == second) return false;
    *xy = product_of(bits_of(first, which < 4u ? u : v), bits_of(second, which < 4u ? v : u));
    xy->sign ^= (which ^ which >> 1 ^ which >> 2) << 31;
    return (xy->low | xy->high) != 0;
}

/* All products of four coordinates, from 2^-596 up; the last two are multiplied first and come in two parts of 24
 * bits, which as the bits of a float are just that many times the smallest. */
enum { QUARTIC_WORDS = 36 };
NOOK_APART static int normals_by_sum(const nook_point *const *p, const nook_point *const *q) {
    uint32_t sum[QUARTIC_WORDS], i, j;
    clear(sum, QUARTIC_WORDS);
    for (i = 0; i < 24u; i++) {
        product xy, zw, all;
        if (!product_of_normal(p, i & 7u, i >> 3, &xy)) continue;
        all = xy;
        for (j = 0; j < 8u; j++) {
            if (!product_of_normal(q, j, i >> 3, &zw)) continue;
            all.place = xy.place + zw.place + 1u;
            all.sign = xy.sign ^ zw.sign;
            add_product(sum, QUARTIC_WORDS, &all, zw.low & 0xFFFFFFu);
            all.place += 24u;
            add_product(sum, QUARTIC_WORDS, &all, zw.low >> 24 | zw.high << 8);
        }
    }
    return sign_of_sum(sum, QUARTIC_WORDS);
}

/* ---- predicates -------------------------------------------------------------------------------- */

NOOK_APART static int orient3d_without_floats(const nook_point *a, const nook_point *b, const nook_point *c,
                                              const nook_point *d, uint32_t direction) {
    const nook_point *const p[4] = {a, b, c, d};
    int sign = orient3d_by_integers(p, direction);
    return sign != NOOK_UNDECIDED ? sign : orient3d_by_sum(p, direction);
}

int nook_orient3d(const nook_point *a, const nook_point *b, const nook_point *c, const nook_point *d) {
    int sign = nook_orient3d_fast(a, b, c, d);
    return sign != NOOK_UNDECIDED ? sign : orient3d_without_floats(a, b, c, d, NOOK_NONE);
}

int nook_passing(const nook_point *o, const nook_point *d, const nook_point *a, const nook_point *b) {
    int sign = nook_triple_sign(nook_sub(*a, *o), nook_sub(*b, *o), *d);
    return sign != NOOK_UNDECIDED ? sign : orient3d_without_floats(o, a, b, d, 3);
}

NOOK_APART static int orient2d_without_floats(const nook_point *a, const nook_point *b, const nook_point *c,
                                              uint32_t direction, uint32_t axis) {
    const nook_point *const p[3] = {a, b, c};
    int sign = orient2d_by_integers(p, direction, axis);
    return sign != NOOK_UNDECIDED ? sign : orient2d_by_sum(p, direction, axis);
}

int nook_orient2d(const nook_point *a, const nook_point *b, const nook_point *c, uint32_t axis) {
    int sign = cross_by_floats(nook_sub(*b, *a), nook_sub(*c, *a), axis);
    return sign != NOOK_UNDECIDED ? sign : orient2d_without_floats(a, b, c, NOOK_NONE, axis);
}

int nook_turning(const nook_point *a, const nook_point *b, const nook_point *d, uint32_t axis) {
    int sign = cross_by_floats(nook_sub(*b, *a), *d, axis);
    return sign != NOOK_UNDECIDED ? sign : orient2d_without_floats(a, b, d, 2, axis);
}

int nook_facing(const nook_point *a, const nook_point *b, const nook_point *c, uint32_t *axis) {
    for (*axis = 0;; ++*axis) {
        int sign = nook_orient2d(a, b, c, *axis);
        if (sign != 0 || *axis == 2u) return sign;
    }
}

NOOK_APART static int distances_without_floats(const nook_point *a, const nook_point *b, const nook_point *c,
                                               const nook_point *d) {
    const nook_point *const p[4] = {a, b, c, d};
    int sign = distances_by_integers(p);
    return sign != NOOK_UNDECIDED ? sign : distances_by_sum(p);
}

int nook_compare_distances(const nook_point *a, const nook_point *b, const nook_point *c,
                           const nook_point *d) {
    int sign = distances_by_floats(a, b, c, d);
    return sign != NOOK_UNDECIDED ? sign : distances_without_floats(a, b, c, d);
}

int nook_compare_normals(const nook_point *const p[4], const nook_point *const q[4]) {
    int sign = normals_by_floats(p, q);
    return sign != NOOK_UNDECIDED ? sign : normals_by_sum(p, q);
}

/* ---- volume ------------------------------------------------------------------------------------ */

void nook_volume_clear(nook_volume *volume) { clear(volume->word, NOOK_VOLUME_WORDS); }

void nook_volume_add(nook_volume *volume, const nook_point *a, const nook_point *b, const nook_point *c) {
    const nook_point *const p[3] = {a, b, c};
    uint32_t i, j;
    for (i = 0; i < 3u; i++) {
        for (j = 0; j < 3u; j++) {
            product xy;
            if (i == j) continue;
            xy = product_of_rows(p, i, j, 0, 1);
            add_product(volume->word, NOOK_VOLUME_WORDS, &xy, bits_of(p[3u - i - j], 2));
        }
    }
}

void nook_volume_merge(nook_volume *volume, const nook_volume *other) {
    uint64_t t = 0;
    uint32_t i;
    for (i = 0; i < NOOK_VOLUME_WORDS; i++) {
        t += (uint64_t)volume->word[i] + other->word[i] + ~zero;
        t += i == 0;
        volume->word[i] = (uint32_t)t;
        t >>= 32;
    }
}

int nook_volume_sign(const nook_volume *volume) { return sign_of_sum(volume->word, NOOK_VOLUME_WORDS); }

/* The highest 32 bits of a sum and where they stand, the last bit set if anything stands below them; 0 if it is 0. */
static uint32_t top_of_sum(const uint32_t *sum, uint32_t words, int sign, int32_t *exponent) {
    uint32_t high = 0, mid = 0, rest = 0, last = 0, below = 0, borrow = 0, i;
    for (i = 0; i < words; i++) {
        int64_t digit = (sign > 0 ? (int64_t)sum[i] - zero : (int64_t)zero - sum[i]) - borrow;
        borrow = digit < 0;
        if ((uint32_t)digit != 0) {
            high = (uint32_t)digit, mid = last, rest = below;
            *exponent = 32 * (int32_t)i - 447;
        }
        below |= last;
        last = (uint32_t)digit;
    }
    if (high == 0) return 0;
    for (; high < 0x80000000u; --*exponent) {
        high = high << 1 | mid >> 31;
        mid <<= 1;
    }
    return high | ((mid | rest) != 0);
}

float nook_volume_value(const nook_volume *volume) {
    int sign = nook_volume_sign(volume);
    int32_t exponent = 0;
    uint32_t high = top_of_sum(volume->word, NOOK_VOLUME_WORDS, sign, &exponent);
    float sixth;
    if (high == 0 || exponent < -200) return 0;
    sixth = (float)(high / 6u | (high % 6u != 0));
    sixth *= nook_power_of_two((uint32_t)(127 + exponent / 2));
    sixth *= nook_power_of_two((uint32_t)(127 + exponent - exponent / 2));
    return sign > 0 ? sixth : -sixth;
}

float nook_determinant(const nook_point *const p[4], bool direction, int32_t *exponent) {
    uint32_t sum[SUM_WORDS];
    float value;
    int sign;
    add_determinant(sum, p, direction ? 3u : NOOK_NONE);
    sign = -sign_of_sum(sum, SUM_WORDS);
    *exponent = 0;
    value = (float)top_of_sum(sum, SUM_WORDS, -sign, exponent);
    return sign > 0 ? value : -value;
}
