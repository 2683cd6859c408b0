/* decimal.c -- the fewest digits, found by trying; nine always suffice for float32. */
#include "decimal.h"

#include <stdio.h>

decimal decimal_of(float x) {
    decimal d, plain;
    float back = 0;
    int digits, length;
    if ((nook_float_bits(x) & 0x7F800000u) == 0x7F800000u) {
        (void)snprintf(d.text, sizeof d.text, "%s",
                       (nook_float_bits(x) & 0x7FFFFFu) != 0 ? "nan"
                       : x < 0                               ? "-inf"
                                                             : "inf");
        return d;
    }
    for (digits = 1; digits <= 9; digits++) {
        (void)snprintf(d.text, sizeof d.text, "%.*g", digits, (double)x);
        if (nook_parse_float(d.text, strlen(d.text), &back) == NOOK_OK &&
            nook_float_bits(back) == nook_float_bits(x))
            break;
    }
    if (strstr(d.text, "e+") == NULL) return d;
    length = snprintf(plain.text, sizeof plain.text, "%.0f", (double)x); /* 1000 is no longer than 1e+03 */
    return length <= (int)strlen(d.text) ? plain : d;
}
