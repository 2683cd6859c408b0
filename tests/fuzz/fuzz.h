/* fuzz.h -- what the fuzz targets share: a condition that must hold, and memory that ends where it should.
 *
 * libFuzzer calls LLVMFuzzerTestOneInput() with bytes of its own making; a target fails by ending the
 * program, and run.sh counts that. AddressSanitizer sees every access beyond an exact() block. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nook.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define EXPECT(condition) ((condition) ? (void)0 : expectation_failed(#condition, __FILE__, __LINE__))

static inline void expectation_failed(const char *text, const char *file, int line) {
    (void)fprintf(stderr, "%s:%d: not so: %s\n", file, line, text);
    abort();
}

/* A copy of bytes[size], or size zero bytes where bytes is null, in a heap block of exactly that size. */
static inline void *exact(const void *bytes, size_t size) {
    void *block = malloc(size != 0 ? size : 1);
    if (block == NULL) exit(2);
    if (size != 0 && bytes != NULL) memcpy(block, bytes, size);
    if (size != 0 && bytes == NULL) memset(block, 0, size);
    return block;
}

#endif
