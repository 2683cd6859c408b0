/* prove.h -- what the programs of `make prove` share: exact-size memory with fences, and CPU time.
 *
 * Tests are those of check.h. A table made by fenced() ends where its heap block ends, so that
 * AddressSanitizer sees the first access beyond it; without that sanitizer it lies between words of a
 * pattern, which fences_hold() compares, so that at least every write beyond it is seen. */
#ifndef PROVE_H
#define PROVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Zeros with a fence on either side; the program ends if there is no memory. At most 32 blocks at a time. */
void *fenced(size_t bytes);
/* Whether nothing has been written beyond any of them. */
bool fences_hold(void);
/* Give all of them back. */
void drop_fences(void);

/* CPU time of this program in thousandths of a second. */
uint32_t milliseconds(void);
/* "label: 1234 things, 5.678 s" */
void print_figure(const char *label, uint32_t count, const char *things, uint32_t since);

#endif
