/* nook_number.c -- decimal text to the nearest float, exactly.
 *
 * The value is D * 10^e with D an integer of at most 115 digits. Few digits and a small exponent
 * (D < 2^24, |e| <= 10: both are then floats) need one correctly rounded multiplication or division.
 * All else is done in integers: D * 10^e or D / 10^-e is brought, by shifting, to a quotient of 25
 * bits or more, computed bit by bit, and rounded once.
 *
 * 115 digits are enough: where two floats meet half way stands a number of at most 113 significant
 * digits, so of a longer text only whether anything follows decides, and a final digit 1 says so. */
#include "ingest/nook_number.h"

#include <string.h>

#include "core/nook_vector.h"

enum { KEEP = 115, WORDS = 20 };
enum place { AT_SIGN, AT_FIRST, IN_INTEGER, AFTER_POINT, AT_EXPONENT, AT_EXPONENT_DIGIT, IN_EXPONENT };
enum flags { NEGATIVE = 1, INEXACT = 2, EXPONENT_NEGATIVE = 4, NO_DIGIT_YET = 8 };

/* ---- integers of many words, the least first ------------------------------------------------- */

/* words = words * factor + add; returns the new count. The caller leaves room. */
static uint32_t multiply_add(uint32_t *word, uint32_t count, uint32_t factor, uint32_t add) {
    uint64_t carry = add;
    uint32_t i;
    for (i = 0; i < count; i++) {
        carry += (uint64_t)word[i] * factor;
        word[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry != 0) word[count++] = (uint32_t)carry;
    return count;
}

static uint32_t times_power_of_ten(uint32_t *word, uint32_t count, uint32_t power) {
    for (; power >= 9u; power -= 9u) count = multiply_add(word, count, 1000000000u, 0);
    for (; power > 0; power--) count = multiply_add(word, count, 10u, 0);
    return count;
}

static uint32_t bit_length(const uint32_t *word, uint32_t count) {
    uint32_t top = word[count - 1u], bits = 32u * (count - 1u);
    for (; top != 0; top >>= 1) bits++;
    return bits;
}

/* All WORDS words, zeros above included. */
static void shift_left(uint32_t *word, uint32_t bits) {
    uint32_t whole = bits / 32u, part = bits % 32u, i;
    for (i = WORDS; i-- > 0;) {
        uint32_t high = i >= whole ? word[i - whole] : 0;
        uint32_t low = i > whole ? word[i - whole - 1u] : 0;
        word[i] = part == 0 ? high : high << part | low >> (32u - part);
    }
}

/* a = a - b if that is not negative; whether it was done. */
static bool take_away(uint32_t *a, const uint32_t *b) {
    uint32_t i = WORDS, borrow = 0;
    while (i > 0 && a[i - 1u] == b[i - 1u]) i--;
    if (i > 0 && a[i - 1u] < b[i - 1u]) return false;
    for (i = 0; i < WORDS; i++) {
        uint64_t difference = (uint64_t)a[i] - b[i] - borrow;
        a[i] = (uint32_t)difference;
        borrow = (uint32_t)(difference >> 63);
    }
    return true;
}

/* ---- reading --------------------------------------------------------------------------------- */

void nook_number_begin(nook_number *number) {
    memset(number, 0, sizeof *number);
    number->flags = NO_DIGIT_YET;
}

static void take_digit(nook_number *n, uint32_t digit, bool fraction) {
    n->flags = (uint8_t)(n->flags & ~NO_DIGIT_YET);
    if (n->kept == KEEP) {
        if (digit != 0) n->flags |= INEXACT;
        /* A text of more than 2^30 digits is no number that ends in the range of floats. */
        if (!fraction && n->scale < 0x3FFFFFFF) n->scale++;
        return;
    }
    if (fraction && n->scale > -0x3FFFFFFF) n->scale--;
    if (digit == 0 && n->words == 0) return;
    n->words = (uint8_t)multiply_add(n->digits, n->words, 10u, digit);
    n->kept++;
}

nook_status nook_number_push(nook_number *n, char byte) {
    uint32_t digit = (uint32_t)(uint8_t)byte - (uint32_t)'0';
    bool in_exponent = n->place >= AT_EXPONENT, sign = byte == '-' || byte == '+';
    if (digit <= 9u && in_exponent) {
        n->place = IN_EXPONENT;
        if (n->exponent < 100000000) n->exponent = n->exponent * 10 + (int32_t)digit;
    } else if (digit <= 9u) {
        n->place = n->place >= AFTER_POINT ? AFTER_POINT : IN_INTEGER;
        take_digit(n, digit, n->place == AFTER_POINT);
    } else if (sign && (n->place == AT_SIGN || n->place == AT_EXPONENT)) {
        if (byte == '-') n->flags |= in_exponent ? EXPONENT_NEGATIVE : NEGATIVE;
        n->place++;
    } else if (byte == '.' && n->place <= IN_INTEGER) {
        n->place = AFTER_POINT;
    } else if (!in_exponent && (n->flags & NO_DIGIT_YET) == 0 && (byte == 'e' || byte == 'E')) {
        n->place = AT_EXPONENT;
    } else {
        return NOOK_BAD_NUMBER;
    }
    return NOOK_OK;
}

/* ---- rounding -------------------------------------------------------------------------------- */

static float power_of_ten(uint32_t power) {
    float ten = 1.0f;
    for (; power > 0; power--) ten *= 10.0f; /* exact up to 10^10 */
    return ten;
}

/* quotient * 2^exponent, where quotient has 26 bits or more of the value and its last bit says
 * whether anything follows: rounded to float bits, infinity included. */
static uint32_t round_to_float(uint32_t quotient, int32_t exponent) {
    uint32_t drop = 1, half, bits; /* at least 2 of the 26 bits go */
    int32_t top = exponent;
    for (bits = quotient; bits > 1u; bits >>= 1) top++;
    if (top > 127) return 0x7F800000u;
    /* What a float keeps: 24 bits, or down to 2^-149. */
    while ((quotient >> drop) > 0xFFFFFFu || exponent + (int32_t)drop < -149) {
        if (++drop == 32u) return 0;
    }
    half = quotient & ((1u << drop) - 1u);
    bits = quotient >> drop;
    if (half > 1u << (drop - 1u) || (half == 1u << (drop - 1u) && (bits & 1u))) bits++;
    /* A carry into the next exponent is what adding does to the bits of a float. */
    if (bits < 0x800000u) return bits;
    return bits + (uint32_t)(exponent + (int32_t)drop + 149) * 0x800000u;
}

/* D * 10^scale by integers. */
static uint32_t exact_bits(const nook_number *n, int32_t scale) {
    uint32_t top[WORDS] = {0}, under[WORDS] = {0}, count = n->words, under_count = 1, quotient = 0, i;
    int32_t shift;
    memcpy(top, n->digits, count * sizeof *top);
    under[0] = 1;
    if (n->flags & INEXACT) {
        count = multiply_add(top, count, 10u, 1u);
        scale--;
    }
    if (scale >= 0) {
        count = times_power_of_ten(top, count, (uint32_t)scale);
    } else {
        under_count = times_power_of_ten(under, under_count, (uint32_t)-scale);
    }
    /* Shift the shorter so that the quotient has 27 or 28 bits. */
    shift = 27 + (int32_t)bit_length(under, under_count) - (int32_t)bit_length(top, count);
    if (shift >= 0) {
        shift_left(top, (uint32_t)shift);
    } else {
        shift_left(under, (uint32_t)-shift);
    }
    shift_left(under, 28u);
    for (i = 0; i <= 28u; i++) {
        quotient = quotient << 1 | take_away(top, under);
        shift_left(top, 1u);
    }
    quotient <<= 1;
    for (i = 0; i < WORDS; i++) quotient |= top[i] != 0; /* something follows */
    return round_to_float(quotient, -shift - 1);
}

nook_status nook_number_value(const nook_number *n, float *value) {
    int32_t scale = n->scale + (n->flags & EXPONENT_NEGATIVE ? -n->exponent : n->exponent);
    uint32_t sign = n->flags & NEGATIVE ? 0x80000000u : 0, bits;
    if ((n->flags & NO_DIGIT_YET) || n->place == AT_EXPONENT || n->place == AT_EXPONENT_DIGIT)
        return NOOK_BAD_NUMBER;
    if (n->words == 0 || n->kept + scale < -46) {
        bits = 0;
    } else if (n->kept + scale > 39) {
        return NOOK_NOT_FINITE;
    } else if (n->words == 1 && n->digits[0] < 0x1000000u && scale >= -10 && scale <= 10) {
        float d = (float)n->digits[0]; /* all of D: digits are dropped only after the 115th */
        bits = nook_float_bits(scale < 0 ? d / power_of_ten((uint32_t)-scale)
                                         : d * power_of_ten((uint32_t)scale));
    } else {
        bits = exact_bits(n, scale);
    }
    if (bits >= 0x7F800000u) return NOOK_NOT_FINITE;
    *value = nook_float_from(bits | sign);
    return NOOK_OK;
}

nook_status nook_parse_float(const char *text, size_t length, float *value) {
    nook_number number;
    size_t i;
    nook_number_begin(&number);
    for (i = 0; i < length; i++) {
        nook_status status = nook_number_push(&number, text[i]);
        if (status != NOOK_OK) return status;
    }
    return nook_number_value(&number, value);
}
