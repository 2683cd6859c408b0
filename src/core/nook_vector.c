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
