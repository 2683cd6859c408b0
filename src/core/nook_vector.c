/* nook_vector.c -- what of nook_vector.h is longer than a line. */
#include "core/nook_vector.h"

/* Digit by digit, two bits of the radicand for one of the root, as on paper. The radicand is
 * brought to 2^24 <= m < 2^26 with an even exponent; 25 steps give 24 bits of root and one more to
 * round by. The root of a 24-bit number is never half way between two floats, so that bit decides. */
float nook_sqrt_by_integers(float x) {
    uint32_t bits = nook_float_bits(x), m = bits & 0x7FFFFFu, root = 0, sum = 0, bit;
    int32_t exponent = (int32_t)(bits >> 23);
    if (bits == 0 || bits == 0x80000000u || bits == 0x7F800000u) return x;
    if (bits > 0x7F800000u) return nook_float_from(0x7FC00000u);
    if (exponent == 0) {
        for (exponent = 1; m < 0x800000u; exponent--) m <<= 1;
    }
    m |= 0x800000u;
    exponent -= 127;
    m <<= (exponent & 1) ? 2 : 1;
    exponent -= exponent & 1;
    for (bit = 0x1000000u; bit != 0; bit >>= 1) {
        if (m >= sum + bit) {
            m -= sum + bit;
            sum += 2u * bit;
            root += bit;
        }
        m <<= 1;
    }
    root += root & 1u;
    return nook_float_from(((uint32_t)(exponent / 2 + 126) << 23) + (root >> 1));
}

float nook_length(nook_point a) {
    float x = a.x < 0 ? -a.x : a.x, y = a.y < 0 ? -a.y : a.y, z = a.z < 0 ? -a.z : a.z;
    float most = x > y ? x : y;
    uint32_t exponent = nook_exponent(most > z ? most : z);
    /* Scaling by a power of two near the largest component rounds nothing that matters. */
    a = nook_scaled(a, nook_power_of_two(254u - exponent));
    return nook_sqrt(nook_dot(a, a)) * nook_power_of_two(exponent);
}

/* Two edges of a triangle and how far it is scaled: to a length near 1, by a power of two. */
typedef struct edges {
    nook_point a, b;
    float scale;
} edges;

static edges edges_of(const nook_point triangle[3]) {
    edges e = {nook_sub(triangle[1], triangle[0]), nook_sub(triangle[2], triangle[0]), 1};
    uint32_t exponent = nook_exponent(nook_length(e.a)), other = nook_exponent(nook_length(e.b));
    e.scale = nook_power_of_two(254u - (exponent > other ? exponent : other));
    e.a = nook_scaled(e.a, e.scale);
    e.b = nook_scaled(e.b, e.scale);
    return e;
}

void nook_barycentric(const nook_point triangle[3], nook_point p, float w[3]) {
    edges e = edges_of(triangle);
    nook_point n = nook_cross(e.a, e.b), x = nook_scaled(nook_sub(p, triangle[0]), e.scale);
    float square = nook_dot(n, n);
    w[1] = nook_dot(nook_cross(x, e.b), n) / square;
    w[2] = nook_dot(nook_cross(e.a, x), n) / square;
    if (!(square > 0)) w[1] = w[2] = 1.0f / 3.0f;
    w[0] = 1.0f - w[1] - w[2];
}

nook_point nook_normal(const nook_point triangle[3]) {
    edges e = edges_of(triangle);
    nook_point n = nook_cross(e.a, e.b);
    float length = nook_length(n);
    return length > 0x1p-100f ? nook_scaled(n, 1.0f / length) : nook_make(0, 0, 0);
}

/* The arctangent of r, 0 <= r <= 1: beyond tan(pi/8) less pi/4 by the sum formula, then a polynomial through four
 * Chebyshev nodes. */
static float arctangent(float r) {
    bool far = r > 0.41421356f;
    float x = far ? (r - 1.0f) / (r + 1.0f) : r, z = x * x;
    float sum = ((0.08520492f * z - 0.14024143f) * z + 0.19991238f) * z - 0.33333287f;
    return (far ? 0.78539816f : 0) + (x * z * sum + x);
}

float nook_angle(float y, float x) {
    float a = x < 0 ? -x : x, b = y < 0 ? -y : y, most = a > b ? a : b, angle;
    if (!(most > 0)) return 0;
    angle = arctangent((a < b ? a : b) / most);
    if (a < b) angle = 1.57079633f - angle;
    if (x < 0) angle = 3.14159265f - angle;
    return y < 0 ? -angle : angle;
}
