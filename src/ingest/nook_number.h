/* nook_number.h -- decimal text to the nearest float, without a locale, a libm or a double.
 *
 * A number may arrive in pieces, one byte at a time, and may be of any length: digits go into a
 * fixed 384-bit integer (115 significant digits decide every rounding to float32; of any further
 * digit only whether it is zero matters). */
#ifndef NOOK_NUMBER_H
#define NOOK_NUMBER_H

#include "core/nook_status.h"

#define NOOK_NUMBER_WORDS 12

/* A number being read. Declare it anywhere and begin it; 60 bytes. */
typedef struct nook_number {
    uint32_t digits[NOOK_NUMBER_WORDS]; /* significant digits so far, as one integer */
    int32_t scale;                      /* its power of ten, from the point and from dropped digits */
    int32_t exponent;                   /* the one written after e */
    uint8_t words;                      /* of digits[] in use */
    uint8_t kept;                       /* significant digits in digits[] */
    uint8_t place;                      /* what may come next; private */
    uint8_t flags;                      /* private */
} nook_number;

void nook_number_begin(nook_number *number);

/* Take one byte: an optional sign, digits with an optional point (at least one digit before or
 * after it), optionally e or E with an optional sign and at least one digit.
 * NOOK_OK, or NOOK_BAD_NUMBER if no number can go on like this. Steps: 12 words. */
nook_status nook_number_push(nook_number *number, char byte);

/* The number read so far as the nearest float, ties to even; -0 and denormals included.
 *   NOOK_OK          *value is set; what is too small becomes a zero of its sign
 *   NOOK_BAD_NUMBER  the text is not complete ("-", "1e")
 *   NOOK_NOT_FINITE  it rounds to more than the largest float
 * Steps: at most 20,000 instructions on M4F; 100 where the digits make less than 2^24 and the power of ten is
 * within 10. */
nook_status nook_number_value(const nook_number *number, float *value);

/* The whole of text[length] as one number; the three calls above in a loop. */
nook_status nook_parse_float(const char *text, size_t length, float *value);

#endif
