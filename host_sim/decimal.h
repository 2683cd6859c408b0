/* decimal.h -- a float as the shortest decimals that read back to the same float, so that two runs,
 * and a PC and a board, can be compared as text. At most nine digits are tried. */
#ifndef DECIMAL_H
#define DECIMAL_H

#include "nook.h"

typedef struct decimal {
    char text[24];
} decimal;

/* "nan" and "inf" for what is not finite. */
decimal decimal_of(float x);

#endif
